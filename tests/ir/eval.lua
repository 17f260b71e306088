-- eval.lua: runs an ir in double or float arithmetic; the oracle of the passes and of the C text.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line.  Each operation is done in double and rounded to `real`.  For float that is what
-- float arithmetic gives: 53 >= 2*24 + 2 bits, so rounding twice changes no sum, product, quotient or
-- square root.  Results equal those of C compiled without contraction (-ffp-contract=off) to the bit,
-- except for libm calls: here they are Lua's (that is the host's libm, in double) or correctly rounded.
-- Not here: the value of an expression (algebra/evaluate.lua).

local R = require "generator.algebra.rational"
local instr = require "generator.ir.core.instr"

local eval = {}

-- x rounded to binary32.
function eval.float(x)
  if x ~= x then return x end
  return (string.unpack("<f", string.pack("<f", x)))
end

local reals = {
  double = { constant = R.todouble, rounded = function(x) return x end },
  float = { constant = R.tofloat, rounded = eval.float },
}

-- env: value of each input by its symbol, and of each lvalue that is updated (+=) by its C text.
-- Returns lvalue -> number, and the named intermediates likewise.
function eval.run(ir, env, real)
  local arithmetic = reals[real or "double"] or error("eval: no real '" .. tostring(real) .. "'", 2)
  local rounded = arithmetic.rounded
  local value, results, names = {}, {}, {}

  local special = {
    const = function(i) return arithmetic.constant(i.value) end,
    input = function(i)
      return rounded((env[i.sym] or error("eval: no value for input '" .. i.sym .. "'")) * 1.0) -- keeps -0.0
    end,
    store = function(i)
      local x = value[i.src1]
      if i.assign == "+=" then
        local before = results[i.c] or rounded(env[i.c] or error("eval: no value for '" .. i.c .. "'"))
        x = rounded(before + x)
      end
      results[i.c] = x
    end,
  }

  instr.each(ir, function(i)
    local entry = instr.of(i.op)
    local x
    if entry.apply then
      x = rounded(entry.apply(value[i.src1], value[i.src2], i, rounded, value[i.src3]))
    else
      x = special[i.op](i)
    end
    if i.dst then value[i.dst] = x end
    if i.name then names[i.name] = x end
  end)
  return results, names
end

return eval
