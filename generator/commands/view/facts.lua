-- facts.lua -- what a page is told of its scene: names, units, limits of sliders, and the formulas.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local touch = require "generator.commands.run.touch"

local facts = {}

local function double(q) return R.todouble(q) + 0.0 end

-- Parameters as the page's sliders have them: SI values, the unit in which they are written, and the limits that the
-- scene's `ranges` give.
local function parameters(scene)
  local model, list = scene.model, {}
  for i, p in ipairs(model.params) do
    list[i] = { name = p.name, value = double(p.default), unit = p.own or "", factor = p.own and
      model:double(p.factor) or 1.0 }
    for _, r in ipairs(scene.ranges and scene.ranges.params or {}) do
      if r.name == p.name then list[i].low, list[i].high = double(r.lo), double(r.hi) end
    end
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

-- What every page knows, also one that computes nothing.
function facts.of(scene)
  local m, acts, closed = scene.model, {}, scene.closed
  for i, e in ipairs(m.record.effects) do acts[i] = e.kind end
  return { name = m.name, version = "polhode " .. scene.build, real = "double", params = parameters(scene),
    states = states_of(scene), inputs = {}, methods = {}, exact = true, kind = m.structure.kind,
    closed = closed.full and closed.kind or
      closed.kind and "the one that there is " .. closed.part or closed.refused or "",
    horizon = m:double(m.horizon), step = m:double(m.step), effects = acts, checks = {}, plane = touch.plane(scene),
    compass = compass_of(m) }
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
  air.closed, air.exact = plane.closed, false
  for i, s in ipairs(scene.states) do
    if s.effect and s.key then air.ground.states[i].own = s.key end
  end
  for _, kind in ipairs(plane.effects) do table.insert(air.effects, kind) end
  table.insert(air.effects, "effect.translation")
  for _, text in ipairs(plane.checks) do table.insert(air.checks, text) end
  return air
end

return facts
