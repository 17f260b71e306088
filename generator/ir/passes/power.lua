-- power.lua: pass that unrolls integer powers into multiplications.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line.  The law is a definition: the value of powi x, n IS that of the chain
--     x^(2k)   ==>  x^k * x^k
--     x^(2k+1) ==>  x^(2k) * x          n >= 2
-- so unrolling changes no bit.  The chain of x^n depends on x and n alone, hence the powers of one x
-- share their steps: x^2, x^3, x^4, x^6 cost one multiplication each.  (It is the shortest chain up
-- to n = 14; x^15 takes 6 where 5 suffice.)
-- Negative and fractional powers do not reach this level: lower writes them as quotients and roots.

local instr = require "generator.ir.core.instr"

local power = {}

function power.run(ir)
  local known = {} -- value number of x -> n -> value number of x^n
  return instr.rebuilt(ir, function(i, emit, new)
    if i.op ~= "powi" then return emit(i) end
    if i.n < 2 then error("power: exponent " .. tostring(i.n) .. " is below 2") end
    local x = i.src1
    local steps = known[x] or { x }
    known[x] = steps

    -- the value number of x^n, made if it is not there
    local function raised(n, dst, name)
      if steps[n] then return steps[n] end
      local a, b
      if n % 2 == 0 then
        a = raised(n // 2)
        b = a
      else
        a, b = raised(n - 1), x
      end
      steps[n] = dst or instr.fresh(new)
      emit { op = "mul", dst = steps[n], src1 = a, src2 = b, name = name }
      return steps[n]
    end

    -- A power seen before, as a step of a higher one: its value number has uses, so it is kept as a
    -- copy for cse to merge.
    steps[i.n] = nil
    raised(i.n, i.dst, i.name)
  end)
end

return power
