#!/usr/bin/env lua5.4
-- absent.t - an effect that is not there leaves no byte: left out, or of a strength that is the constant 0.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The scenes of a pair have the same number of lines, since what is emitted cites them.  Text is compared, so there is
-- nothing to tolerate.  The reverse is tested too: with a strength the bytes differ and the effect's name appears.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"

local function files(effects)
  local text = table.concat({ "local k = param(\"k\", 2, \"N m\")", "return scene { name = \"s\",",
    "  body = solid.box { x = 1, y = 2, z = 3, mass = 4 }, origin = { 1/8, 0, 0 },",
    "  effects = { " .. effects .. " },", "  initial = { omega = { 1, 2, 3 } } }", "" }, "\n")
  local job = assert(scene.read(text))
  scene.plan(job)
  return scene.files(job)
end

local function same(a, b)
  for _, name in ipairs(a) do
    if a[name] ~= b[name] then return false, name end
  end
  return #a == #b
end

local light = "effect.solar_pressure { %ssun = {1, 0, 0}, " ..
  "plates = { { area = %d, normal = {1, 0, 0}, centre = {0, 1, 0}, reflectivity = 1/2 } } }"

-- what it is called; of strength 0; with a strength
local cases = {
  { "drag", "effect.drag { c = 0 }", "effect.drag { c = 0.5 }" },
  { "friction", "effect.friction { torque = 0, smoothing = 0.1 }", "effect.friction { torque = 1, smoothing = 0.1 }" },
  { "spring", "effect.spring { stiffness = 0, axis = {0, 0, 1}, rest = 1 }",
    "effect.spring { stiffness = k, axis = {0, 0, 1}, rest = 1 }" },
  { "spring", "effect.spring { stiffness = {0, 0, 0} }", "effect.spring { stiffness = {0, k, 0} }" },
  { "magnetic", "effect.magnetic { moment = {0, 0, 0}, field = {0, 0, 1} }",
    "effect.magnetic { moment = {0, 1, 0}, field = {0, 0, 1} }" },
  { "magnetic", "effect.magnetic { moment = {0, 1, 0}, rotating = {0, 0, 0}, rate = 3 }",
    "effect.magnetic { moment = {0, 1, 0}, rotating = {0, 0, 1}, rate = 3 }" },
  { "torque", "effect.torque { body = {0, 0*t, {{0, 0}, {1, 0}}} }",
    "effect.torque { body = {0, 0, {{0, 0}, {1, 1}}} }" },
  { "solar_pressure", string.format(light, "flux = 0, ", 1), string.format(light, "", 1) },
  { "solar_pressure", string.format(light, "", 0), string.format(light, "", 1) },
  { "pivot", "effect.pivot { amplitude = 0, rate = 5 }", "effect.pivot { amplitude = 0.1, rate = 5 }" },
  { "pivot", "effect.pivot { acceleration = { 0*t, 0, 0 } }", "effect.pivot { acceleration = { t, 0, 0 } }" },
  { "inertia_rate", "effect.inertia_rate { xx = 0, yz = 0*t }", "effect.inertia_rate { xx = t, yz = 0*t }" },
  { "inertia_rate", "effect.inertia_rate {}", "effect.inertia_rate { yz = sin(t) }" },
  { "dissipation", "effect.dissipation { k = 0 }", "effect.dissipation { k = 0.1 }" },
  { "custom", "effect.custom { params = {stiff = 0}, potential = function(s) return s.stiff*s.q[2]^2 end }",
    "effect.custom { params = {stiff = k}, potential = function(s) return s.stiff*s.q[2]^2 end }" },
  { "custom", "effect.custom { torque = function(s) return { 0*s.w[1], 0, s.t - s.t } end }",
    "effect.custom { torque = function(s) return { s.w[1], 0, 0 } end }" },
}

for _, with in ipairs { "", "effect.gravity {}, effect.damping { c = 0.1 }, " } do
  local without = files(with)
  for _, c in ipairs(cases) do
    local label = c[1] .. (with == "" and "" or " beside others")
    local ok, where = same(files(with .. c[2]), without)
    tap.ok(ok, label .. ": of strength 0 the same bytes as without it", tostring(where))
    local strong = files(with .. c[3])
    tap.ok(not same(strong, without), label .. ": with a strength it is there")
    tap.ok(strong["s.h"]:find("Effect " .. c[1], 1, true) ~= nil, label .. ": and named in the header")
    tap.ok(without["s.h"]:find("Effect " .. c[1], 1, true) == nil, label .. ": without it the header does not")
  end
end

-- Gravity gradient is about the centroid only.
for _, orbit in ipairs { "{ radius = 2 }", "{ a = 2, e = 0.5 }" } do
  local text = 'return scene { name = "s", body = solid.box { x = 1, y = 2, z = 3, mass = 4 },\n' ..
    "  effects = { %s },\n  initial = { omega = { 1, 2, 3 } } }\n"
  local made = {}
  for i, effect in ipairs { "", "effect.gravity_gradient { mu = 0, orbit = " .. orbit .. " }",
    "effect.gravity_gradient { mu = 1, orbit = " .. orbit .. " }" } do
    local job = assert(scene.read(string.format(text, effect)))
    scene.plan(job)
    made[i] = scene.files(job)
  end
  tap.ok(same(made[1], made[2]), "gravity_gradient " .. orbit .. ": of strength 0 the same bytes as without it")
  tap.ok(not same(made[1], made[3]), "gravity_gradient " .. orbit .. ": with a strength it is there")
  tap.is(made[3]["s.h"]:find("S_ANOMALY", 1, true) ~= nil, orbit ~= "{ radius = 2 }",
    "gravity_gradient " .. orbit .. ": a state where the orbit is not a circle, and only there")
end

-- A wheel is never nothing; without it there is no state of it.
local wheel = "effect.wheel { axis = {0, 0, 1}, inertia = 0.1, included = false }"
tap.ok(files("")["s.h"]:find("WHEEL", 1, true) == nil, "no wheel, no state of a wheel")
tap.ok(files(wheel)["s.h"]:find("S_WHEEL,", 1, true) ~= nil, "a wheel has a state")
tap.ok(files(wheel .. ", " .. wheel)["s.h"]:find("S_WHEEL_2,", 1, true) ~= nil, "two wheels have two")

tap.done()
