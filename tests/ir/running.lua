-- running.lua: evaluates an ir in double together with a bound of its rounding error.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Running error analysis (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 3.3): with every
-- value v goes e >= |v - exact|.  An operation adds half an ulp of its result, |v| 2^-53, to what it makes
-- of the errors of its operands; a libm call is granted 2 ulp.  The bound needs no tolerance chosen by hand
-- and is a theorem for each point, up to the roundings of e itself, for which a part in 1000 is added.

local instr = require "generator.ir.core.instr"
local R = require "polhode_rational"

local running = {}

local U = 2.0 ^ -53
local TINY = 2.0 ^ -1074 -- underflow

-- Derivative bounds: |f(x + d) - f(x)| <= rule(x, e, v) for |d| <= e.
local slope = {
  sin = function(_, e) return e end,
  cos = function(_, e) return e end,
  atan = function(_, e) return e end,
  exp = function(_, e, v) return v * (math.exp(e) - 1) * 1.001 end,
  log = function(x, e) return e / (x - e) end,
  asin = function(x, e) -- slope 1/sqrt(1 - x^2)
    local far = math.abs(x) + e
    return far < 1 and e / math.sqrt((1 - far) * (1 + far)) or math.huge
  end,
  sqrt = function(x, e, v) return x > e and e / (v + math.sqrt(x - e)) or math.sqrt(e + x) end,
  fabs = function(_, e) return e end,
}

local combine = {
  neg = function(_, _, e1) return e1 end,
  add = function(_, _, e1, e2) return e1 + e2 end,
  sub = function(_, _, e1, e2) return e1 + e2 end,
  mul = function(x, y, e1, e2) return math.abs(x) * e2 + math.abs(y) * e1 + e1 * e2 end,
  div = function(x, y, e1, e2)
    local far = math.abs(y) - e2
    return far > 0 and (e1 + math.abs(x / y) * e2) / far or math.huge
  end,
  atan2 = function(y, x, e1, e2) -- the angle moves at most by the shift over the distance
    local r = math.sqrt(x * x + y * y) - e1 - e2
    return r > 0 and 2 * (e1 + e2) / r or math.huge
  end,
}

-- Returns lvalue -> value and lvalue -> bound; the ir must be free of powi (after the power pass).
function running.run(ir, env)
  local value, bound, results, bounds = {}, {}, {}, {}
  instr.each(ir, function(i)
    local v, e
    if i.op == "const" then
      v = R.todouble(i.value)
      e = U * math.abs(v)
    elseif i.op == "input" then
      v, e = env[i.sym], 0.0
    elseif i.op == "store" then
      results[i.c], bounds[i.c] = value[i.src1], bound[i.src1]
      return
    else
      local x, y, e1, e2 = value[i.src1], value[i.src2], bound[i.src1], bound[i.src2]
      local entry = instr.of(i.op)
      v = entry.apply(x, y, i)
      if combine[i.op] then
        e = combine[i.op](x, y, e1, e2)
      else
        e = (slope[i.op] or error("running: no rule for " .. i.op))(x, e1, v)
      end
      if entry.cost ~= "free" then e = e + (entry.cost == "call" and 4 or 1) * U * math.abs(v) + TINY end
      e = e * 1.001
    end
    value[i.dst], bound[i.dst] = v, e
  end)
  return results, bounds
end

return running
