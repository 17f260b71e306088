-- breaks.lua -- where the equations of motion are not smooth: at |e| with e = 0.
--
-- A table over time is a sum of |t - t_i|: the times are known.  What else stands between bars may vanish anywhere.
-- Checks of a stepper's order stay between the breaks.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local equations = require "generator.dynamics.equations"

local breaks = {}

-- All |e| in the equations, with parameters put in: a list of e.
local function bars(eq)
  local list, seen, map = {}, {}, {}
  for _, member in ipairs(eq.model.members) do map[member.sym] = member.e end
  local function walk(e)
    if seen[e] then return end
    seen[e] = true
    if e.kind == "call" and e.fn == "abs" and not motion.free(e) then list[#list + 1] = e[1] end
    for _, c in ipairs(expr.children(e)) do walk(c) end
  end
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do walk(calculus.substitute(equations.inline(eq.groups, o.expr), map)) end
  end
  return list
end

-- The names of states and time.
local function moving(m)
  local set = { t = true }
  for _, s in ipairs(m.states) do set[s.name] = true end
  return set
end

-- The first time after 0 at which the equations are not smooth, for the parameters' defaults (a rational), or nil;
-- second result: true where there are others, at times that nobody knows.
function breaks.first(eq)
  local m, first, unknown = eq.model, nil, false
  local t = motion.sym "t"
  for _, e in ipairs(bars(eq)) do
    local slope = calculus.diff(e, t)
    local rest = calculus.substitute(e, { [t] = expr.zero })
    if motion.free(slope) and motion.free(rest) then
      local time = m:number(-rest / slope)
      if time > m:number(expr.zero) and (not first or time < first) then first = time end
    else
      unknown = unknown or not expr.constant(e, moving(m)) -- inputs are held
    end
  end
  return first, unknown
end

return breaks
