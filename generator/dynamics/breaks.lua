-- breaks.lua -- where the equations of motion are not smooth: at |e| with e = 0.
--
-- A table over time is a sum of |t - t_i|: the times are known.  What else stands between bars may vanish anywhere, as
-- may what an effect names itself (`corners`).  Checks of a stepper's order stay between the breaks.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local context = require "generator.dynamics.context"
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

-- The time at which e vanishes for the parameters' defaults (a rational) if it depends on time alone, and is known.
local function known(m, e)
  local t = motion.sym "t"
  local slope, rest = calculus.diff(e, t), calculus.substitute(e, { [t] = expr.zero })
  if motion.free(slope) and motion.free(rest) then return m:number(-rest / slope) end
  return nil
end

-- The first time after 0 at which the equations are not smooth, for the parameters' defaults, or nil; second result:
-- what else stands between bars and vanishes at times that nobody knows, a list of expressions.
function breaks.first(eq)
  local m, first, unknown = eq.model, nil, {}
  for _, e in ipairs(bars(eq)) do
    local time = known(m, e)
    if time then
      if time > m:number(expr.zero) and (not first or time < first) then first = time end
    elseif not expr.constant(e, moving(m)) then -- inputs are held
      unknown[#unknown + 1] = e
    end
  end
  return first, #unknown > 0 and unknown or nil
end

-- All that vanishes where the equations are not smooth, at times that nobody knows: expressions of parameters, states
-- and time.
function breaks.corners(eq)
  local _, unknown = breaks.first(eq)
  local m, list = eq.model, unknown or {}
  for _, e in ipairs(m.record.effects) do
    for _, corner in ipairs(e.spec.corners and e.spec.corners(e.a, context.with(context.dry(m), e)) or {}) do
      list[#list + 1] = corner
    end
  end
  return list
end

return breaks
