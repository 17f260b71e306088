-- rk4.lua -- the classical Runge-Kutta method of order 4, unrolled for the states of the scene.
--
--     k1 = f(x), k2 = f(x + h k1/2), k3 = f(x + h k2/2), k4 = f(x + h k3),  x += h (k1 + 2 k2 + 2 k3 + k4)/6
-- (Kutta 1901; Hairer, Norsett, Wanner, Solving ODEs I, 2nd ed., table II.1.2.)  Structure is used, the method is not
-- changed in exact arithmetic:
--   * the attitude's equation is linear in q: methods/attitude.lua;
--   * without torque the rates are quadratic in w, k(s w) = s^2 k(w).  The stages then run on the angles v = w h/4 that
--     the attitude needs anyway: v + 2 k(v), v + 2 k(v2), v + 4 k(v3), and h drops out of them;
--   * a factor of a rate that is constant during the step (a quotient of moments) is taken out of the stages.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local moving = require "generator.dynamics.moving"
local state = require "generator.dynamics.state"
local attitude = require "generator.methods.attitude"
local stages = require "generator.methods.stages"

local rk4 = { name = "rk4", order = 4, title = "classical Runge-Kutta method of order 4",
  about = "classical Runge-Kutta, fixed step, unrolled" }
-- h |w| above which |q| leaves 1: with y = h |w|/2 a step multiplies q by R, |R|^2 = 1 - y^6/72 + y^8/576, and by
-- (3 - q^2)/2, so that q^2 comes to 3 - 2/|R|, which is 0.92 there.  At 4.3 nothing is left of q.
rk4.longest = "2.8"

rk4.needs = { { path = "angles for rates", needs = "no effect at all: the rates are then quadratic in w" } }

local h, q, w = state.h, state.q, state.w
local comp, named = attitude.comp, attitude.named

-- Definitions of what is called prefix..letter at stage n, "" for the first: see stages.name.
local function at_stage(group, prefix, n, v, letters)
  local bases = vec.map(letters, function(letter) return stages.name(prefix .. letter, n) end)
  return named(group, "", "", v, bases)
end

local function group(why, rank) return { why = why, defs = {}, outs = {}, rank = rank } end

-- What is integrated beside the attitude: {sym = symbols, names = states, id = names in locals: a letter for rates}.
local function integrated(eq)
  local list = { sym = {}, id = {}, names = {} }
  for _, s in ipairs(eq.model.states) do
    if not attitude.is[s.name] then
      local n = #list.names + 1
      list.names[n], list.sym[n] = s.name, s.sym
      list.id[n] = string.match(s.name, "^w([xyz])$") or s.name
    end
  end
  return list
end

-- The rates out[name] in the order of the list.
local function in_order(list, out)
  return vec.map(list.names, function(name) return out[name] end)
end

-- The final sum: x + weight (k1 + 2 k2 + 2 k3 + k4); with `whole` = 6 weight, a rate that is the same at all stages is
-- added as it is.
local function finish(list, prepared, rate, weight, why, whole)
  local g = group(why)
  for i, name in ipairs(list.names) do
    local same = rate[1][i] == rate[2][i] and rate[2][i] == rate[3][i] and rate[3][i] == rate[4][i]
    if whole and same and not prepared.zero[name] then
      g.outs[#g.outs + 1] = { state = name, expr = list.sym[i] + whole[i] * rate[1][i] }
    elseif not prepared.zero[name] then
      local middle = named(g, "s", "", { rate[2][i] + rate[3][i] }, { list.id[i] })[1]
      g.outs[#g.outs + 1] = { state = name, expr = list.sym[i] + weight[i] * (rate[1][i] + 2 * middle + rate[4][i]) }
    end
  end
  return g
end

-- What the final sum adds, h k1 + (h/6) ((k4 - k1) + 2 (k2 - k1) + 2 (k3 - k1)): h is exact and h/6 is not, and what is
-- wrong with it at every step would be a clock that goes wrong by as much; of the differences it is h |w| times less.
local function added(list, prepared, rate)
  local g = group "w += h k1 + (h/6) ((k4 - k1) + 2 (k2 - k1 + k3 - k1))"
  for i, name in ipairs(list.names) do
    if not prepared.zero[name] then
      local k = { rate[1][i], rate[2][i], rate[3][i], rate[4][i] }
      local first = named(g, "f", "1", { h * k[1] }, { list.id[i] })[1]
      local rest = (k[4] - k[1]) + 2 * (k[2] + k[3] - 2 * k[1])
      g.outs[#g.outs + 1] = { state = name, expr = first + expr.sym("h6", 6) * rest }
    end
  end
  return g
end

---- with torque ------------------------------------------------------------------------------------

-- h, h/2 and h/6 times the constant factor of each rate: lists whole, half, sixth.  A factor 1 costs nothing.
local function fractions(list, pre, prepared, hh)
  local part = { whole = {}, half = {}, sixth = {} }
  for i, name in ipairs(list.names) do
    local c = prepared.factor[name]
    if prepared.zero[name] then
      part.whole[i], part.half[i], part.sixth[i] = expr.zero, expr.zero, expr.zero
    elseif c == expr.one then
      part.whole[i], part.half[i] = h, hh
      part.sixth[i] = named(pre, "h6", "", { h / 6 }, { "" })[1]
    else
      part.whole[i] = named(pre, "h", "", { h * c }, { list.id[i] })[1]
      part.half[i] = named(pre, "h", "2", { part.whole[i] / 2 }, { list.id[i] })[1]
      part.sixth[i] = named(pre, "h", "6", { part.whole[i] / 6 }, { list.id[i] })[1]
    end
  end
  return part
end

local why = { "stage 1: at the start", "stage 2: at h/2 along stage 1", "stage 3: at h/2 along stage 2",
  "stage 4: at h along stage 3" }

-- Angles v = w h/4 of the stage, and V = Omega h/4 of a frame that turns; their names keep clear of the velocity's.
local function angles(eq, g, s, h4, at, renamed)
  local m = eq.model
  if eq.turn then -- the axes do not turn at w
    at = vec.map(eq.turn, function(e) return calculus.substitute(e, renamed) end)
  end
  local v = named(g, m.has.position and "a" or "v", tostring(s), vec.scale(h4, at), comp)
  if not m.frame then return v end
  local turn = vec.map(moving.rate(m), function(e) return calculus.substitute(e, renamed) end)
  return v, named(g, "b", tostring(s), vec.scale(h4, turn), comp)
end

-- Definitions of a stage come in the order in which they need each other. Where the axes do not turn at w alone (moving
-- frame, slip) the increment of the attitude needs the rate at which they do, and so the stage's definitions, and these
-- the attitude of the stage; else the increment comes first.
local function forced(eq, prepared)
  local has, list = eq.model.has, integrated(eq)
  local pre = group("fractions of the step, times the constant factors of the rates", 6)
  local hh = named(pre, "hh", "", { h / 2 }, { "" })[1]
  local h4 = has.attitude and named(pre, "h4", "", { h / 4 }, { "" })[1]
  local part = fractions(list, pre, prepared, hh)
  local groups, rate, increment = { pre }, {}, {}
  for s = 1, 4 do
    local g = group(why[s] .. (s == 1 and has.attitude and (has.position and "; a = w h/4" or "; v = w h/4") or ""))
    local suffix = s == 1 and "" or tostring(s)
    local at, map, qs = list.sym, {}, q
    if s > 1 then
      at = vec.map(list.sym, function(x, i)
        return at_stage(g, list.names[i], suffix, { x + (s == 4 and part.whole or part.half)[i] * rate[s - 1][i] },
          { "" })[1]
      end)
      for i, x in ipairs(list.sym) do map[x] = at[i] end
      map[state.t] = state.t + (s == 4 and h or hh)
    end
    local defs, out, renamed
    local function instance()
      for i = 1, s > 1 and has.attitude and 4 or 0 do map[q[i]] = qs[i] end
      local _
      defs, out, _, renamed = stages.instance(prepared, map, suffix)
      for _, def in ipairs(defs) do g.defs[#g.defs + 1] = def end
    end
    if has.attitude then
      local turned = eq.model.frame ~= nil or eq.turn -- then the increment needs Omega or W of this stage
      local ws = {}
      for i = 1, 3 do ws[i] = at[i] end
      if turned then
        qs = attitude.at(g, s, increment[s - 1], eq.coupled)
        instance()
      end
      local v, V = angles(eq, g, s, h4, ws, renamed)
      if not turned then qs = attitude.at(g, s, increment[s - 1], eq.coupled) end
      increment[s] = attitude.increment(g, s, v, qs, increment[s - 1], eq.coupled, V)
      if not turned then instance() end
    else
      instance()
    end
    rate[s] = at_stage(g, "k", tostring(s), in_order(list, out), list.id)
    groups[#groups + 1] = g
  end
  groups[#groups + 1] = prepared.increments and added(list, prepared, rate)
    or finish(list, prepared, rate, part.sixth, "w += h (k1 + 2 k2 + 2 k3 + k4)/6", part.whole)
  if has.attitude then groups[#groups + 1] = attitude.finish(increment, eq.coupled, prepared.increments) end
  return groups
end

---- without torque -----------------------------------------------------------------------------------

local free_why = { "stage 1: k1 = k(v1)", "stage 2: v2 = v1 + 2 k1", "stage 3: v3 = v1 + 2 k2",
  "stage 4: v4 = v1 + 4 k3" }

-- Twice and four times the constant factor of each rate; kept in the model where they depend on parameters alone.
-- Rates that do not change have 0.
local function factors(g, prepared, out_factor, constant)
  local two, four = {}, {}
  for i, name in ipairs(state.names.rates) do
    local c = out_factor[name]
    if prepared.zero[name] then
      two[i], four[i] = expr.zero, expr.zero
    else
      two[i] = constant(2 * c, "twice ") or named(g, "c", "2", { 2 * c }, { comp[i] })[1]
      four[i] = constant(4 * c, "four times ") or named(g, "c", "4", { 4 * c }, { comp[i] })[1]
    end
  end
  return two, four
end

-- With v = w h/4 and k(v) = (h/4)^2 k(w): w + (h/2) k(w) becomes v + (h^2/8) k(w) = v + 2 k(v), and w + h k(w) becomes
-- v + 4 k(v).
local function free(eq, prepared, constant)
  local list = integrated(eq)
  local pre = group("angles v = w h/4: k(v) = (h/4)^2 k(w) is quadratic, so the stages need no h", 6)
  local h4 = named(pre, "h4", "", { h / 4 }, { "" })[1]
  local v1 = named(pre, "v", "1", vec.scale(h4, w), comp)
  local groups, rate, increment = { pre }, {}, {}
  local two, four
  for s = 1, 4 do
    local g = group(free_why[s])
    local v = v1
    if s > 1 then
      v = named(g, "v", tostring(s), vec.map(v1, function(x, i)
        return x + (s == 4 and four or two)[i] * rate[s - 1][i]
      end), comp)
    end
    local map = {}
    for i = 1, 3 do map[w[i]] = v[i] end
    local defs, out, factor = stages.instance(prepared, map, tostring(s))
    for _, def in ipairs(defs) do g.defs[#g.defs + 1] = def end
    if s == 1 then two, four = factors(g, prepared, factor, constant) end
    if eq.model.has.attitude then increment[s] = attitude.increment(g, s, v, q, increment[s - 1], false) end
    rate[s] = named(g, "k", tostring(s), in_order(list, out), comp)
    groups[#groups + 1] = g
  end
  -- h/6 k(w) = 16/(6 h) k(v)
  local changes = not (prepared.zero.wx and prepared.zero.wy and prepared.zero.wz)
  if changes then
    local scale = expr.lift "4/3" / h
    pre.defs[#pre.defs + 1] = { name = "g", expr = scale }
    local weight = vec.map(two, function(x) return x * expr.sym("g", 6) end)
    groups[#groups + 1] = finish(list, prepared, rate, weight,
      "w += (4/h) (2 k1 + 4 k2 + 4 k3 + 2 k4)/6, back from angles")
  end
  if eq.model.has.attitude then groups[#groups + 1] = attitude.finish(increment, false) end
  return groups, changes
end

-- The step as equation groups with outs {state, expr}; its inputs are the state, h, t, u and derived constants.
-- constant(e, words): e as a constant kept in the model, or nil if it depends on the state.
-- Second result: the step divides by h.
function rk4.groups(eq, constant)
  local prepared = stages.prepare(eq)
  if eq.free then return free(eq, prepared, constant) end
  return forced(eq, prepared), false
end

-- What the step adds to the states, in the place of the new states: methods/compensated.lua.
function rk4.increments(eq)
  local prepared = stages.prepare(eq, true)
  prepared.increments = true
  return forced(eq, prepared), false
end

-- The same step without the division by h, for what is derived from it (dynamics/sensitivity.lua).
function rk4.plain(eq) return forced(eq, stages.prepare(eq, true)) end

return rk4
