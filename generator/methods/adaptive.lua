-- adaptive.lua -- the embedded Runge-Kutta pair of orders 5 and 4 by Dormand and Prince, unrolled.
--
-- The seventh stage is the first of the next step; the difference of the two results is the error of the lower one, and
-- the higher one is kept.  Source: Dormand, Prince 1980, J. Comput. Appl. Math. 6, 19; Hairer, Norsett, Wanner, Solving
-- ODEs I (2nd ed.), table II.5.2 and section II.4 (choice of the step).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local breaks = require "generator.dynamics.breaks"
local constancy = require "generator.dynamics.constancy"
local state = require "generator.dynamics.state"
local switching = require "generator.dynamics.switching"
local floors = require "generator.methods.floors"
local stages = require "generator.methods.stages"

local adaptive = { name = "adaptive", order = 5, adaptive = true,
  about = "embedded pair of Dormand and Prince, orders 5 and 4, step from a tolerance, unrolled" }

-- A row of the tableau as rationals.
local function q(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = R.lift(x) end
  return out
end

-- c: the nodes; a[n]: the weights of stage n, a[7] also those of the result of order 5 (its last stage is the next
-- step's first); low: those of order 4.
local tableau = {
  c = q { 0, "1/5", "3/10", "4/5", "8/9", 1, 1 },
  a = { {}, q { "1/5" }, q { "3/40", "9/40" }, q { "44/45", "-56/15", "32/9" },
    q { "19372/6561", "-25360/2187", "64448/6561", "-212/729" },
    q { "9017/3168", "-355/33", "46732/5247", "49/176", "-5103/18656" },
    q { "35/384", 0, "500/1113", "125/192", "-2187/6784", "11/84" } },
  low = q { "5179/57600", 0, "7571/16695", "393/640", "-92097/339200", "187/2100", "1/40" },
}
adaptive.tableau = tableau

local h = state.h

-- The equations with the states in `map` replaced: definitions named with `suffix`, and the rates by state name; first:
-- with those that never change.
local function instance(eq, map, suffix, first)
  local defs, out, renamed = {}, {}, {}
  for k, v in pairs(map) do renamed[k] = v end -- into a table: order is lost anyway
  for _, g in ipairs(eq.groups) do
    for _, d in ipairs(g.defs) do
      local e = calculus.substitute(d.expr, renamed)
      if e ~= d.expr then
        renamed[expr.sym(d.name, 7)] = expr.sym(d.name .. suffix, 7)
        defs[#defs + 1] = { name = d.name .. suffix, expr = e }
      elseif first then
        defs[#defs + 1] = d
      end
    end
    for _, o in ipairs(g.outs) do out[o.state] = calculus.substitute(o.expr, renamed) end
  end
  return defs, out
end

-- sum of coefficients times k, over the stages so far
local function combined(coefficients, k, name)
  local terms = {}
  for j, a in ipairs(coefficients) do terms[j] = a * k[j][name] end
  return expr.add(terms)
end

-- The trial step: from x at t and k1 = f(t, x) the state `out`, what is `turn`ed to get its q, its rates k7 and the
-- error of the lower order, as the groups of a function; knots: where the run must stop (dynamics/breaks.lua).  Or nil
-- and why there is none.
-- groups[n - 1] is stage n, whose first definitions are its values of the moving states in their order (`plain` takes
-- them from there); the last group is the error.
local function trial(eq)
  local moving, k, groups = constancy.moving(eq), { {} }, {}
  if #moving == 0 then return nil, stages.AT_REST end
  for _, s in ipairs(moving) do k[1][s.name] = expr.sym("k1" .. s.name, 8) end
  for n = 2, 7 do
    local suffix = "_" .. n
    for _, s in ipairs(eq.model.states) do -- the second wheel's speed is wheel_2
      while eq.model.states.by_name[s.name .. suffix] do suffix = "_" .. suffix end
    end
    local g = { why = n == 7 and "stage 7: at the end, of order 5; the next step's first" or "stage " .. n, defs = {},
      outs = {} }
    local map = {}
    for i, s in ipairs(moving) do
      local name = s.name .. suffix
      local added = h * combined(tableau.a[n], k, s.name)
      g.defs[i] = { name = name, expr = s.sym + added }
      map[s.sym] = expr.sym(name, 8)
      if n == 7 then
        g.outs[#g.outs + 1] = { array = "out", index = s.name, expr = map[s.sym] }
        if s.kind == "attitude" then g.outs[#g.outs + 1] = { array = "turn", index = s.name, expr = added } end
      end
    end
    if R.sign(tableau.c[n]) ~= 0 then map[state.t] = state.t + tableau.c[n] * h end
    local defs, out = instance(eq, map, suffix, n == 2)
    for _, d in ipairs(defs) do g.defs[#g.defs + 1] = d end
    k[n] = {}
    for _, s in ipairs(moving) do
      local name = "k" .. n .. s.name
      g.defs[#g.defs + 1] = { name = name, expr = out[s.name] }
      k[n][s.name] = expr.sym(name, 8)
      if n == 7 then g.outs[#g.outs + 1] = { array = "k7", index = s.name, expr = k[n][s.name] } end
    end
    groups[#groups + 1] = g
  end
  local last = { why = "the error: order 5 less order 4", defs = {}, outs = {} }
  for i, s in ipairs(moving) do
    local difference = {}
    for j = 1, 7 do difference[j] = (tableau.a[7][j] or R.zero) - tableau.low[j] end
    last.outs[i] = { array = "error", index = s.name, expr = h * combined(difference, k, s.name) }
  end
  groups[#groups + 1] = last
  return { states = moving, groups = groups, knots = breaks.knots(eq) }
end

-- The same between the corners, which `switches` tells (dynamics/switching.lua), or nil.
function adaptive.program(eq)
  local switches = switching.of(eq)
  local program, why = trial(switches and switches.equations or eq)
  if program then program.switches, program.floors = switches, floors.of(eq) end
  return program, why
end

-- The step of a fixed size as equation groups with outs {state, expr}: what is derived from it goes by these
-- (dynamics/sensitivity.lua).
function adaptive.plain(eq)
  local program = trial(eq)
  local moving, count = {}, #program.states
  for _, s in ipairs(program.states) do moving[s.name] = true end
  local first, rates, known = { why = "stage 1: at the start", defs = {}, outs = {} }, {}, {}
  for _, g in ipairs(eq.groups) do
    for _, d in ipairs(g.defs) do
      first.defs[#first.defs + 1] = d
      known[d.name] = true -- what never changes is here already
    end
    for _, o in ipairs(g.outs) do
      if moving[o.state] then rates[#rates + 1] = { name = "k1" .. o.state, expr = o.expr } end
    end
  end
  table.move(rates, 1, #rates, #first.defs + 1, first.defs)
  local groups = { first }
  for n = 2, 6 do
    local stage = program.groups[n - 1]
    local g = { why = stage.why, defs = {}, outs = {} }
    for _, d in ipairs(stage.defs) do
      if not known[d.name] then g.defs[#g.defs + 1] = d end
    end
    groups[n] = g
  end
  local last = { why = "the new state, of order 5; one Newton step for 1/|q|", defs = {}, outs = {} }
  -- n = (3 - |q|^2)/2 is 1/|q| up to 3/8 (|q|^2 - 1)^2
  local square, n = expr.zero, expr.one
  for i, s in ipairs(program.states) do
    last.defs[i] = program.groups[6].defs[i]
    if s.kind == "attitude" then square = square + expr.sym(last.defs[i].name, 8) ^ 2 end
  end
  if square ~= expr.zero then
    last.defs[count + 1] = { name = "n_7", expr = (3 - square) / 2 }
    n = expr.sym("n_7", 8)
  end
  for i, s in ipairs(program.states) do
    local e = expr.sym(last.defs[i].name, 8)
    last.outs[i] = { state = s.name, expr = s.kind == "attitude" and n * e or e }
  end
  groups[#groups + 1] = last
  return groups
end

-- What the step of a fixed size adds to the states, in the place of the new states (methods/compensated.lua): h k1 + h
-- times what the others differ from k1 by, for the weights are rounded, and always in the same way.
-- Law: the weights of a[7] sum to 1, so sum a_j k_j = k1 + sum a_j (k_j - k1).
function adaptive.increments(eq)
  local groups = adaptive.plain(eq)
  local new = groups[#groups]
  local last = { why = "what is added, of order 5; n - 1 of one Newton step for n = 1/|q|", defs = {}, outs = {} }
  local short
  for _, o in ipairs(new.outs) do
    local s, k, rest = eq.model.states.by_name[o.state], {}, { expr.zero }
    for j = 1, 6 do k[j] = expr.sym("k" .. j .. s.name, 8) end
    for j = 2, 6 do rest[j] = expr.lift(tableau.a[7][j]) * (k[j] - k[1]) end
    local first = { name = "f" .. s.name, expr = h * k[1] }
    local d = { name = "d" .. s.name, expr = expr.sym(first.name, 8) + h * expr.add(rest) }
    last.defs[#last.defs + 1] = first
    last.defs[#last.defs + 1] = d
    o.sum, o.added = s.sym + expr.sym(d.name, 8), expr.sym(d.name, 8)
    if s.kind == "attitude" then short = (short or expr.one) - o.sum ^ 2 end
  end
  if short then last.defs[#last.defs + 1] = { name = "m1", expr = short / 2 } end
  for i, o in ipairs(new.outs) do
    local turned = eq.model.states.by_name[o.state].kind == "attitude"
    last.outs[i] = { state = o.state, expr = turned and o.added + expr.sym("m1", 8) * o.sum or o.added }
  end
  groups[#groups] = last
  return groups
end

return adaptive
