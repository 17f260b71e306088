-- states.lua -- which states a scene has, and why: what the scene needs and no more.
--
--     attitude   unless the body does not turn, or `outputs` asks for nothing made of it and no effect depends on it
--     rates      unless the body moves through space, its turning is not spoken of (neither initial rates nor attitude
--                are given) and nothing turns it: then it is a point
--     position and velocity   when an effect moves the body
--     further states          those that effects declare
-- What an effect depends on is read from its expressions.  An effect that does nothing (zero strength, gravity about
-- the centroid) is taken out here, so that leaving it out gives the same code; a warning says so.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local contact = require "generator.dynamics.contact"
local landing = require "generator.dynamics.landing"
local context = require "generator.dynamics.context"
local idle = require "generator.dynamics.idle"
local state = require "generator.dynamics.state"

local states = {}

local function set(names)
  local s = {}
  for _, n in ipairs(names) do s[n] = true end
  return s
end

local of_attitude, of_rates = set(state.names.attitude), set(state.names.rates)
local of_place = set(state.names.position)
for _, n in ipairs(state.names.velocity) do of_place[n] = true end

local function zero(e) return e == expr.zero or ratio.iszero(e) end

-- What the effect does, as lists of expressions: {torque =, force =, rates = (of its own states)}; and whether it acts.
local function deeds(m, e)
  local c = context.with(context.dry(m), e)
  local list, acts = { torque = {}, force = {}, rates = {} }, e.spec.input or e.spec.touches or false
  for _, name in ipairs { "torque", "force" } do
    list[name] = e.spec[name] and e.spec[name](e.a, c) or {}
    for _, x in ipairs(list[name]) do acts = acts or not zero(x) end
  end
  for _, s in ipairs(e.states) do
    acts = true
    if not e.spec.touches then list.rates[#list.rates + 1] = e.spec.derivative(e.a, c)[s.key] end
  end
  for _, x in ipairs(e.spec.momentum and e.spec.momentum(e.a, c) or {}) do acts = acts or not zero(x) end
  local frame = e.spec.frame and e.spec.frame(e.a, c)
  for i = 1, frame and 3 or 0 do
    list.frame = list.frame or not zero(frame.rate[i]) or not zero(frame.rate_dot[i])
  end
  acts = acts or list.frame
  return list, acts or e.spec.moves and e.spec.moves(m.given) or false
end

-- Does one of the expressions depend on one of the names?
local function depends(list, names)
  for _, e in ipairs(list) do
    if not expr.constant(e, names) then return true end
  end
  return false
end

-- What turns the body by its place must find one: effect e asks for a position or velocity and nothing moves the body.
local function placeless(d, m, e, list)
  local V = e.spec.potential and not e.spec.touches and e.spec.potential(e.a, context.with(context.dry(m), e))
  for _, exprs in ipairs { list.torque, list.rates, { V or expr.zero } } do
    for _, x in ipairs(exprs) do
      for _, s in ipairs(expr.symbols(x)) do
        if of_place[s.name] then
          local plane = contact.of(m)
          d:error(e.line, e.kind, "depends on " .. s.name .. ", which " .. (plane and "a body on a plane (line " ..
            plane.line .. ") does not have as a state" or "needs an effect that moves the body: effect.translation " ..
            "or effect.rotating_frame"))
          return
        end
      end
    end
  end
end

-- Does the effect exert a torque?
local function torques(list)
  for _, x in ipairs(list.torque) do
    if not zero(x) then return true end
  end
  return false
end

-- The effects' own states, with names that are free: {key, name, sym, about, unit, initial}.
local function own_states(e, taken, given)
  e.own, e.states = {}, {}
  for i, s in ipairs(e.spec.states and e.spec.states(e.a, given) or {}) do
    local name, n = s.name, 1
    while taken[name] do
      n = n + 1
      name = s.name .. "_" .. n -- speed2 would be the speed at stage 2
    end
    taken[name] = true
    e.own[s.name] = state.sym(name)
    e.states[i] = { key = s.name, name = name, sym = e.own[s.name], about = s.about, unit = s.unit,
      kind = name, place = i, initial = s.initial, effect = e }
  end
end

local short = function(e) return (string.gsub(e.kind, "^effect%.", "")) end

-- Is the centre of mass the origin of rotation?
local function central(m)
  for i = 1, 3 do
    if not zero(m.com[i]) then return false end
  end
  return true
end

-- A second effect that takes the input.
local function one_input(d, m)
  local first
  for _, e in ipairs(m.record.effects) do
    if e.spec.input and first then
      d:warn(e.line, e.kind, "takes the same input u as the one of line " .. first.line .. ": u acts once for each")
    end
    first = first or e.spec.input and e
  end
end

-- With --bake a parameter that is 0 may be all that an effect waits for: as the scene has it, it acts.
local function only_baked(m, i, e)
  local symbolic = m.symbolic.effects[i]
  if not m.baked or symbolic == e then return false end
  symbolic = setmetatable({ own = e.own, states = e.states }, { __index = symbolic })
  return (select(2, deeds(m, symbolic)))
end

-- What cannot be together: a second base or translation, a fixed point and a body that moves.
local function contradictions(d, m, moving)
  local seen, plane = {}, contact.of(m)
  for _, e in ipairs(m.record.effects) do
    if e.spec.single and seen[e.kind] then
      d:error(e.line, e.kind, "is given twice (first on line " .. seen[e.kind] .. ")")
    end
    seen[e.kind] = seen[e.kind] or e.line
    if e.spec.central and not central(m) then
      d:error(m.record.origin and m.record.origin.line or m.line, "origin", "must be the centroid, about which " ..
        e.kind .. " (line " .. e.line .. ") acts")
    end
    if (moving or plane) and e.spec.fixed then
      moving = moving or plane
      d:error(e.line, e.kind, "acts about a fixed point, and " .. moving.kind .. " (line " .. moving.line ..
        ") moves the body: " .. e.spec.fixed)
    end
  end
  if not moving and not plane and (m.given.position or m.given.velocity) then
    d:error(m.given.line, "initial", "position and velocity need an effect that moves the body: " ..
      "effect.translation, effect.rotating_frame or effect.plane")
  end
end

-- The names that `outputs` gives, checked; nil without it.
local function outputs(d, m, taken)
  local given = m.record.outputs
  if not given then return nil end
  local wanted, known = {}, { "attitude", "rates", "position", "velocity", "energy", "momentum", "momentum_body" }
  local is = set(known)
  for _, name in ipairs(given.list) do
    wanted[name] = true
    if not is[name] and not taken[name] then
      d:error(given.line, "outputs", "must be names of states or of " .. table.concat(known, ", "),
        string.format("%q", name))
    end
  end
  return wanted
end

-- The effects that do something, in m.record; what moves the body, which states are asked for and by whom:
-- {moving, turned, by_attitude, by_rates}, an effect each.  An effect that does nothing is told and left out; with
-- --bake one that only a value of a parameter stops stays in, for as the scene has it, it acts.
local function acting_effects(d, m, moving)
  local acting, cause = {}, { moving = moving }
  m.frame = nil
  for i, e in ipairs(m.record.effects) do
    local deed, acts = deeds(m, e)
    if not acts and not only_baked(m, i, e) then d:warn(e.line, e.kind, idle.why(e)) end
    if acts then
      acting[#acting + 1] = e
      if not moving then placeless(d, m, e, deed) end
      if deed.frame then m.frame = e end
      if e.spec.touches then cause.by_attitude = cause.by_attitude or e end
      if torques(deed) or e.spec.input or e.spec.touches then cause.turned = cause.turned or e end
      for _, name in ipairs { "torque", "force", "rates" } do
        if depends(deed[name], of_attitude) then cause.by_attitude = cause.by_attitude or e end
        if name ~= "torque" and depends(deed[name], of_rates) then cause.by_rates = cause.by_rates or e end
      end
    end
  end
  local landing_on = m.record.landing -- which way up it lands, and what an impact does to its rates
  cause.by_attitude, cause.turned = cause.by_attitude or landing_on, cause.turned or landing_on
  local acted = {}
  for k, v in pairs(m.record) do acted[k] = v end -- into a table: order is lost anyway
  acted.effects = acting
  m.record = acted
  return cause
end

-- Sets m.has and returns why, a sentence each.  Rates are states unless the body moves and nothing gives, makes or
-- needs a rotation: then it is a point.  The attitude is one where there are rates and it is wanted or needed.
local function decided(m, cause, wanted)
  local has, why, moving = m.has, {}, cause.moving
  local by_attitude, needs = cause.by_attitude, cause.by_attitude or cause.by_rates
  local spoken = m.given.omega and "initial gives omega" or m.given.attitude and "initial gives the attitude"
  local plane = contact.of(m)
  local rates = plane and "the body touches a plane" or not moving and "the body turns about a fixed point" or spoken or
    cause.turned and short(cause.turned) .. " turns the body" or
    needs and short(needs) .. " depends on how the body turns"
  by_attitude = by_attitude or m.frame -- its energy does
  has.rates = rates and true or false
  has.attitude = has.rates and (not wanted or wanted.attitude or wanted.momentum or by_attitude) and true or false
  if has.attitude then
    why[1] = "attitude: " .. (by_attitude and short(by_attitude) .. " depends on it" or wanted and "outputs names " ..
      (wanted.attitude and "it" or "the momentum in inertial axes") or "it is part of the motion")
  else
    why[1] = "no attitude: " .. (has.rates and "outputs does not ask for it and nothing depends on it" or
      "the body is a point")
  end
  why[2] = has.rates and "rates: " .. rates or "no rates: the body moves, initial gives neither omega nor attitude, " ..
    "and nothing turns the body: a point"
  why[3] = moving and "position and velocity: " .. short(moving) .. " moves the body" or plane and
    "no position: the height above the plane follows from the attitude" .. (#plane.states == 0 and
    ", and nothing depends on the place along the plane" or "") or "no position: nothing moves the body"
  return why
end

-- m.states: those of the motion in the order of state.kinds, then the effects' own, which `why` tells of.
local function listed(m, why)
  local first = { attitude = m.attitude, rates = m.omega, position = m.given.position, velocity = m.given.velocity }
  local none = { expr.zero, expr.zero, expr.zero }
  local place = m.frame and "frame" or "inertial"
  m.states = { by_name = {} }
  for _, kind in ipairs(state.kinds) do
    for i, name in ipairs(m.has[kind] and state.names[kind] or {}) do
      local s = state.known.by_name[name]
      local about = s.about
      if i == 1 and (kind == "position" or kind == "velocity") then about = about .. ", " .. place .. " axes" end
      if name == "qw" and m.frame then about = "attitude, body to frame" end
      m.states[#m.states + 1] = { name = name, sym = s.sym, about = about, unit = s.unit,
        kind = kind, place = i, initial = (first[kind] or none)[i] }
    end
  end
  for _, e in ipairs(m.record.effects) do
    for _, s in ipairs(e.states) do
      m.states[#m.states + 1] = s
      why[#why + 1] = s.name .. ": " .. short(e) .. " has it"
    end
  end
end

-- States and inputs by name; parameters and inputs must have other names.
local function named(d, m)
  for _, s in ipairs(m.inputs) do m.by_name[s.name] = m.by_name[s.name] or s end
  for _, s in ipairs(m.states) do
    m.states.by_name[s.name] = s
    m.by_name[s.name] = m.by_name[s.name] or s -- no constant may be called so
    for _, p in ipairs(m.params) do
      if string.upper(p.name) == string.upper(s.name) then
        d:error(p.line, "param", "name is taken by a state of the scene", string.format("%q", p.name))
      end
    end
    for _, u in ipairs(m.inputs) do
      if u.index == string.upper(s.name) then
        d:error(u.line, "input", "name is taken by a state of the scene", string.format("%q", u.label))
      end
    end
  end
end

-- Decides m.has, m.states (a list of {name, sym, about, unit, kind, place in its kind, initial}, and by_name),
-- of m.record.  Reports what cannot be.
function states.decide(d, m)
  local taken, moving = {}, nil
  for _, s in ipairs(state.known) do taken[s.name] = true end
  for _, e in ipairs(m.record.effects) do
    own_states(e, taken, m.given)
    if e.spec.moves and e.spec.moves(m.given) and not moving then moving = e end
  end
  contradictions(d, m, moving)
  one_input(d, m)
  if not contact.check(d, m) or not landing.place(d, m) then return false end
  m.has = { attitude = true, rates = true, position = moving ~= nil } -- until we know better
  local cause = acting_effects(d, m, moving)
  local why = decided(m, cause, outputs(d, m, taken))
  m.has.velocity = m.has.position
  listed(m, why)
  if moving and m.has.rates and not central(m) then
    d:error(m.record.origin and m.record.origin.line or m.line, "origin", "must be the centroid, as " .. moving.kind ..
      " (line " .. moving.line .. ") moves the body")
  end
  named(d, m)
  m.moving, m.reasons = moving, why
  return not d:failed()
end

return states
