-- constancy.lua -- what keeps its value along every motion, by the structure of the equations, and what changes.
--
-- A state is conserved where its rate is the number 0.  The attitude never counts as conserved: steppers hold q in a
-- form of their own.  What has a value that only happens to stay, by the numbers of a motion, is not known here.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

local constancy = {}

local attitude = { qw = true, qx = true, qy = true, qz = true }

-- The states whose rate is structurally zero: a set of names.
function constancy.conserved(eq)
  local zero = {}
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do
      if not attitude[o.state] and o.expr == expr.zero then zero[o.state] = true end
    end
  end
  return zero
end

-- The states that are not conserved, in their order, and those that are: a set of names.
function constancy.moving(eq)
  local zero, list = constancy.conserved(eq), {}
  for _, s in ipairs(eq.model.states) do
    if not zero[s.name] then list[#list + 1] = s end
  end
  return list, zero
end

-- A set of the names of what changes: states that are not conserved, time, and every definition that depends on one of
-- them.  One pass: a definition uses only those before it.
function constancy.varying(eq)
  local set = { t = true }
  for _, s in ipairs(constancy.moving(eq)) do set[s.name] = true end
  for _, g in ipairs(eq.groups) do
    for _, d in ipairs(g.defs) do
      if not expr.constant(d.expr, set) then set[d.name] = true end
    end
  end
  return set
end

return constancy
