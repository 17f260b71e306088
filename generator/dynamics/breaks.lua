-- breaks.lua -- the times at which the equations of motion are not smooth: |e| and sign(e) with e = 0.
--
-- A table over time has sign(t - t_i): the times are known, steppers with a tolerance stop there (knots).  The corners
-- at times that nobody knows are those of switching.lua.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local ratio = require "generator.algebra.ratio"
local equations = require "generator.dynamics.equations"

local breaks = {}

-- The derived constants by parameters.
function breaks.constants(m)
  local map = {}
  for _, member in ipairs(m.members) do map[member.sym] = member.e end
  return map
end

-- |p| of parameters alone has its value once and for all.
local function cornered(e) return e.kind == "call" and (e.fn == "abs" or e.fn == "side") and not motion.free(e) end

-- All |e| and sign(e) in the equations, with parameters put in: a list of e.
local function bars(eq)
  local list, seen = {}, {}
  local inlined, opened = equations.inlined(eq.groups), calculus.substitution(breaks.constants(eq.model))
  local function walk(e)
    if seen[e] then return end
    seen[e] = true
    if cornered(e) then list[#list + 1] = e[1] end
    for _, c in ipairs(expr.children(e)) do walk(c) end
  end
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do walk(opened(inlined(o.expr))) end
  end
  return list
end

local t = motion.sym "t"

-- |e| with e linear in time and constant beside: its slope and its zero as expressions of constants, or nil.
local function ramp(e)
  local slope, rest = calculus.diff(e, t), calculus.substitute(e, { [t] = expr.zero })
  if motion.free(slope) and motion.free(rest) then return slope, ratio.tidy(-rest / slope) end
end

-- The corners at times that are known, in their order for the parameters' defaults: a list of {time, bars = {|e| ->
-- the positive factor of |t - time| in it}, signs = {sign(e) -> its sign after time}}; the times are numbers or derived
-- constants.
function breaks.knots(eq)
  local m, list, at, seen = eq.model, {}, {}, {}
  local function walk(e)
    if seen[e] then return end
    seen[e] = true
    local slope, time
    if cornered(e) then slope, time = ramp(e[1]) end
    if time then
      if time.kind ~= "num" and time.kind ~= "sym" then time = m:derived(time, "corner of ") end
      if not at[time] then
        local value = m:number(calculus.substitute(time, breaks.constants(m)))
        at[time] = { time = time, bars = {}, signs = {}, value = value }
        list[#list + 1] = at[time]
      end
      if e.fn == "abs" then at[time].bars[e] = expr.call("abs", slope) end
      if e.fn == "side" then at[time].signs[e] = expr.call("side", slope) end
    end
    for _, c in ipairs(expr.children(e)) do walk(c) end
  end
  for _, g in ipairs(eq.groups) do
    for _, d in ipairs(g.defs) do walk(d.expr) end
    for _, o in ipairs(g.outs) do walk(o.expr) end
  end
  for i, k in ipairs(list) do k.place = i end
  table.sort(list, function(a, b)
    local d = R.sign(a.value - b.value)
    return d < 0 or d == 0 and a.place < b.place
  end)
  return list
end

-- The first time after 0 at which the equations are not smooth, for the parameters' defaults (a rational), or nil.
function breaks.first(eq)
  local m, first = eq.model, nil
  for _, e in ipairs(bars(eq)) do
    local _, at = ramp(e)
    local time = at and m:number(at)
    if time and time > m:number(expr.zero) and (not first or time < first) then first = time end
  end
  return first
end

return breaks
