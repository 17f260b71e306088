-- count.lua: operation counts of an ir, by cost class.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line; reads only.  A subtraction counts as add; neg, fabs, loads and stores are free
-- (a sign bit or a move); an integer power counts as the multiplications of its own chain, so the
-- count before the power pass is an upper bound.  This is the cost that the banner and the planner
-- quote.

local instr = require "generator.ir.core.instr"

local count = {}

-- Multiplications in the chain of x^n: one a squaring, one a further 1 bit.
local function chain(n)
  local muls = 0
  while n > 1 do
    muls = muls + 1 + n % 2
    n = n // 2
  end
  return muls
end

-- { add =, mul =, div =, sqrt =, call = }
function count.run(ir)
  local total = { add = 0, mul = 0, div = 0, sqrt = 0, call = 0 }
  instr.each(ir, function(i)
    local class = instr.of(i.op).cost
    if class ~= "free" then
      total[class] = total[class] + (i.op == "powi" and chain(i.n) or 1)
    end
  end)
  return total
end

return count
