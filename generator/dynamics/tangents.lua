-- tangents.lua -- a step with the derivatives of the discrete map itself along some directions, for `polhode fit`.
--
--     tangents.of(plan, ask) -> what emit/fit.lua prints; ask: {free = parameters, outputs = of dsl/measure.lua,
--     initial = function(states) how many further directions, or nil}
-- A direction moves parameters and states at once: s0_NAME is the derivative of a state along it, k0_NAME that of a
-- derived constant.  Every named quantity of the step is followed by its derivative, so the result is exact for the
-- step as it is computed, whatever its length.  All directions share the step's own numbers.
-- An input u is u0 + u1 (t - tu) during a step: its value at the time tu, and its slope, which the caller knows.
-- Only the states that the outputs depend on, now or later, are followed.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local sensitivity = require "generator.dynamics.sensitivity"
local stages = require "generator.stages"

local tangents = {}

local RANK = 8 -- of the symbols of a direction: they differ as states do

-- The equations with each input on its line.
local function on_lines(eq)
  local own, map, t, since = stages.copy(eq), {}, motion.sym "t", motion.sym "tu"
  for _, s in ipairs(eq.model.inputs) do
    map[s.sym] = motion.sym("u0_" .. s.label) + motion.sym("u1_" .. s.label) * (t - since)
  end
  own.groups = {}
  for i, g in ipairs(eq.groups) do
    local copy = { why = g.why, where = g.where, defs = {}, outs = {} }
    for k, d in ipairs(g.defs) do copy.defs[k] = { name = d.name, expr = calculus.substitute(d.expr, map) } end
    for k, o in ipairs(g.outs) do copy.outs[k] = { state = o.state, expr = calculus.substitute(o.expr, map) } end
    own.groups[i] = copy
  end
  return stages.close(own)
end

-- Names that an expression mentions.
local function mentioned(e, put)
  for _, s in ipairs(expr.symbols(e)) do put(s.name) end
end

-- What each named quantity and each new state is made of, in terms of names.
local function uses_of(groups)
  local defs, outs = {}, {}
  for _, g in ipairs(groups) do
    for _, d in ipairs(g.defs) do defs[d.name] = d.expr end
    for _, o in ipairs(g.outs) do outs[o.state] = o.expr end
  end
  return defs, outs
end

-- The states that the outputs need, in the model's order, and the definitions that these need: sets by name.
-- Through the equations: a state whose rate needs another one needs that, too.  An output without expressions is an
-- attitude.
local function needed(m, groups, outputs)
  local defs, outs = uses_of(groups)
  local states, named = {}, {}
  local function need(name)
    if m.states.by_name[name] then
      if states[name] then return end
      states[name] = true
      if outs[name] then mentioned(outs[name], need) end
    elseif defs[name] and not named[name] then
      named[name] = true
      mentioned(defs[name], need)
    end
  end
  for _, o in ipairs(outputs) do
    for _, e in ipairs(o.e or {}) do mentioned(e, need) end
    for _, name in ipairs(o.e and {} or { "qw", "qx", "qy", "qz" }) do need(name) end
  end
  return states, named
end

-- Without what no followed state needs.
local function pruned(groups, states, named)
  local list = {}
  for _, g in ipairs(groups) do
    local own = { why = g.why, where = g.where, defs = {}, outs = {} }
    for _, d in ipairs(g.defs) do own.defs[#own.defs + 1] = named[d.name] and d or nil end
    for _, o in ipairs(g.outs) do own.outs[#own.outs + 1] = states[o.state] and o or nil end
    list[#list + 1] = own
  end
  return list
end

-- known[symbol] for calculus.diff along a direction; rows: the derived constants that move, filled as they are asked
-- for: {name, by = {expression for each free parameter}}.
local function along(m, free, states, rows)
  local by = {}
  for k, p in ipairs(free) do by[k] = sensitivity.by_parameter(m, p) end
  return setmetatable({}, { __index = function(known, sym)
    local state, member = m.states.by_name[sym.name], m.by_name[sym.name]
    local d = expr.zero
    if state and state.sym == sym then
      d = states[sym.name] and expr.sym("s0_" .. sym.name, RANK) or expr.zero
    elseif member and member.sym == sym then
      local list, moves = {}, false
      for k, p in ipairs(free) do
        list[k] = sym == p.sym and expr.one or by[k][sym]
        moves = moves or list[k] ~= expr.zero
      end
      if moves then
        d = expr.sym("k0_" .. sym.name, RANK)
        rows[#rows + 1] = { name = sym.name, by = list }
      end
    end
    known[sym] = d
    return d
  end })
end

-- The step and its derivative along a direction: outs {row = place of the state, expr, lane = is it a derivative?}.
-- The direction has no symbol in the step: `dummy` is none of its symbols, and all derivatives are those known.
local function step_of(m, groups, known, list)
  local taken, dummy = {}, { name = "d0", sym = expr.sym("d0", 9) }
  for _, member in ipairs(m.members) do taken[member.name] = true end
  for _, s in ipairs(m.states) do taken["s0_" .. s.name] = true end
  local out, final = {}, {}
  for _, g in ipairs(groups) do
    for _, d in ipairs(g.defs) do taken[d.name] = true end
    for _, o in ipairs(g.outs) do final[o.state] = o.expr end
  end
  for i, g in ipairs(groups) do
    out[i] = { why = g.why, where = g.where, outs = {}, defs = sensitivity.follow(g.defs, { dummy }, { known }, taken) }
  end
  local last = { why = "the new state and its derivative along the direction", defs = {}, outs = {} }
  for i, s in ipairs(list) do
    local e = final[s.name] or s.sym
    table.insert(last.outs, { row = i - 1, expr = e, lane = false })
    table.insert(last.outs, { row = i - 1, expr = calculus.diff(e, dummy.sym, known), lane = true })
  end
  out[#out + 1] = last
  return out
end

-- Outputs that are expressions: values y, and their derivatives by the followed states and by the free parameters, G,
-- as far as they are not 0.  Third result: of each value {state = {{place, index of G}}, param = likewise}.
local function outputs_of(list, free, outputs)
  local g, slopes = { why = "what is measured", defs = {}, outs = {} }, {}
  local y, n = 0, 0
  local function put(places, place, e)
    if e == expr.zero then return end
    table.insert(g.outs, { array = "G", index = n, expr = e })
    places[#places + 1], n = { place - 1, n }, n + 1
  end
  for _, o in ipairs(outputs) do
    for _, e in ipairs(o.e or {}) do
      table.insert(g.outs, { array = "y", index = y, expr = e })
      local own = { state = {}, param = {} }
      for i, s in ipairs(list) do put(own.state, i, calculus.diff(e, s.sym)) end
      for k, p in ipairs(free) do put(own.param, k, calculus.diff(e, p.sym)) end
      y, slopes[y + 1] = y + 1, own
    end
  end
  return { g }, y, slopes, n
end

-- {states = the followed ones, step = groups, constants = {{name, by}}, start = {{expressions by parameter} by state},
-- measure = groups, values = how many numbers these measure, slopes, slope_count = of their derivatives,
-- free, inputs = the model's}
function tangents.of(plan, ask)
  local m, eq, s = plan.model, on_lines(plan.equations), plan.steppers[1]
  local all = (s.method.plain or s.method.groups)(eq, function(e, words) return m:derived(e, words) end)
  local states, named = needed(m, all, ask.outputs)
  local groups, list, rows = pruned(all, states, named), {}, {}
  for _, state in ipairs(m.states) do list[#list + 1] = states[state.name] and state or nil end
  local known = along(m, ask.free, states, rows)
  local made = { states = list, constants = rows, start = {}, free = ask.free, outputs = ask.outputs,
    inputs = m.inputs, initial = ask.initial and ask.initial(list) or 0 }
  made.step = step_of(m, groups, known, list)
  for i, state in ipairs(list) do
    made.start[i] = {}
    for k, p in ipairs(ask.free) do
      made.start[i][k] = m:constant("d" .. state.name .. "0_d" .. p.name, calculus.diff(state.initial, p.sym),
        "d " .. state.name .. "(0)/d " .. p.name)
    end
  end
  made.measure, made.values, made.slopes, made.slope_count = outputs_of(list, ask.free, ask.outputs)
  return made
end

return tangents
