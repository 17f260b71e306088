-- cost.lua -- how many operations an expression takes to evaluate, shared subexpressions once.
--
-- ABOVE the line, so an estimate: one for each +, *, root and call, two for a division.  It chooses between two forms
-- of the same thing; what the emitted code costs is counted on its instructions (ir/core/count.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local function power(n) -- multiplications of x^n by squaring
  local count = 0
  while n > 1 do
    count = count + 1 + n % 2
    n = n // 2
  end
  return count
end

-- Operations of the expressions in the list; `known` (set of nodes, optional) cost nothing, and what is counted is
-- added to it.
return function(list, known)
  known = known or {}
  local total = 0
  local function walk(e)
    if known[e] then return end
    known[e] = true
    for _, c in ipairs(expr.children(e)) do walk(c) end
    if e.kind == "add" or e.kind == "mul" then
      total = total + #e - 1
    elseif e.kind == "pow" then
      local n = R.abs(e.exp)
      total = total + power(R.toint(R.num(n))) + (R.isint(n) and 0 or 1) + (R.sign(e.exp) < 0 and 2 or 0)
    elseif e.kind == "call" then
      total = total + 1
    end
  end
  for _, e in ipairs(list) do walk(e) end
  return total
end
