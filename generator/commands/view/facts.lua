-- facts.lua -- what a page is told of its scene: names, units, limits of sliders, and the formulas.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local touch = require "generator.commands.run.touch"
local sleeping = require "generator.dynamics.sleeping"
local critical = require "generator.mass.critical"
local extent = require "generator.mass.extent"

local facts = {}

local function double(q) return R.todouble(q) + 0.0 end

local angles = { deg = true, rad = true, rev = true }
local inside = 0.01 -- of the way to the value: where a slider ends before the body does

-- The ends of a slider without `ranges`: around the value, positive where the parameter must be, a quarter turn to each
-- side of an angle, and no further than there is a body.
local function limits(model, p, positive, unit)
  local v, size = double(p.default), math.abs(double(p.default))
  local low, high = v - 2 * size, v + 2 * size
  if positive then
    low, high = 0.2 * v, 3 * v
  elseif angles[p.own] then
    low, high = v - math.pi / 2, v + math.pi / 2
  elseif size == 0 then
    low, high = -unit, unit
  end
  local least, most = extent.of(model, p.name, low, high)
  if least > low then low = least + inside * (v - least) end
  if most < high then high = most - inside * (most - v) end
  return low, high
end

-- Parameters as the page's sliders have them: SI values, the unit in which they are written, and the ends, those of the
-- scene's `ranges` where it gives some.
local function parameters(scene)
  local model, list = scene.model, {}
  local signs = critical.of(model.conditions)
  for i, p in ipairs(model.params) do
    local unit = p.own and model:double(p.factor) or 1.0
    local low, high = limits(model, p, signs.map[p.sym] ~= nil, unit)
    for _, r in ipairs(scene.ranges and scene.ranges.params or {}) do
      if r.name == p.name then low, high = double(r.lo), double(r.hi) end
    end
    list[i] = { name = p.name, value = double(p.default), unit = p.own or "", factor = unit, low = low, high = high }
  end
  return list
end

local function states_of(scene)
  local list = {}
  for i, s in ipairs(scene.states) do
    list[i] = { name = s.name, kind = s.kind or "", unit = s.unit or "" }
  end
  return list
end

-- Inputs with their limits for the scene's own parameters.
local function inputs_of(model)
  local list = {}
  for i, u in ipairs(model.inputs) do
    list[i] = { name = u.label, unit = u.own or u.unit or "", factor = u.own and u.factor and model:double(u.factor)
      or 1.0, low = u.low and model:double(u.low), high = u.high and model:double(u.high) }
  end
  return list
end

-- A magnet that is fixed in the body, and the field at t = 0; nil where there is none, or one of them is zero.
local function compass_of(model)
  for _, e in ipairs(model.record.effects) do
    local field = e.kind == "effect.magnetic" and (e.a.field or e.a.rotating)
    if field and not motion.any(e.a.moment) then
      local function numbers(v) return vec.map(v, function(x) return model:double(x) + 0.0 end) end
      local m, B = numbers(e.a.moment), numbers(field)
      return vec.dot(m, m) > 0 and vec.dot(B, B) > 0 and { moment = m, field = B } or nil
    end
  end
  return nil
end

-- Which motions are worth offering as presets, by what turns the body: "free", where its own momentum I w stays in
-- space; "weight", where gravity alone turns it about a point that is not its centre of mass; nil where neither is so.
local function turning_of(scene)
  local m, effects = scene.model, scene.model.record.effects
  local own = m.carried == m.inertia and m.locked == m.inertia
  if own and scene.conserved.is.L and not m.frame then return "free" end
  local arm = vec.map(m.com, function(e) return m:double(e) end)
  if #effects == 1 and effects[1].kind == "effect.gravity" and vec.dot(arm, arm) > 0 and m:double(effects[1].a.g) > 0
  then
    return "weight"
  end
  return nil
end

-- Of a body that its weight turns: the upward direction, and of a symmetric top the least spin that keeps it upright,
-- both at the scene's own parameters.
local function weight_of(scene)
  local m = scene.model
  if turning_of(scene) ~= "weight" then return nil end
  local top = sleeping.of(m, scene.closed)
  return { up = vec.map(m.record.effects[1].a.direction, function(e) return -m:double(e) end), rate = top and top.rate }
end

-- What every page knows, also one that computes nothing.
function facts.of(scene)
  local m, acts, closed = scene.model, {}, scene.closed
  for i, e in ipairs(m.record.effects) do acts[i] = e.kind end
  return { name = m.name, version = "polhode " .. scene.build, real = "double", params = parameters(scene),
    states = states_of(scene), inputs = {}, methods = {}, exact = true, kind = m.structure.kind,
    closed = closed.full and closed.theorem or
      closed.kind and "the one that there is " .. closed.part or closed.refused or "",
    horizon = m:double(m.horizon), step = m:double(m.step), effects = acts, checks = {}, plane = touch.plane(scene),
    compass = compass_of(m), turning = turning_of(scene), weight = weight_of(scene) }
end

-- The same of a plan whose emitted code the page runs.
function facts.compiled(scene, plan, unit)
  local f = facts.of(scene)
  for i, s in ipairs(plan.steppers) do f.methods[i] = { name = s.method.name, order = s.method.order or 0 } end
  f.real, f.exact = plan.real, plan.closed.full or false
  f.inputs, f.checks = inputs_of(plan.model), unit.checks
  return f
end

-- Of a body that flies and lands: what is known of it in the air, with what is known of it on the plane.
function facts.phases(air, plane, scene)
  air.ground, air.effects = { states = plane.states, checks = #plane.checks }, {}
  air.closed, air.exact, air.turning = plane.closed, false, nil -- impacts turn it, too
  for i, s in ipairs(scene.states) do
    if s.effect and s.key then air.ground.states[i].own = s.key end
  end
  for _, kind in ipairs(plane.effects) do table.insert(air.effects, kind) end
  table.insert(air.effects, "effect.translation")
  for _, text in ipairs(plane.checks) do table.insert(air.checks, text) end
  return air
end

return facts
