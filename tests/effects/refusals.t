#!/usr/bin/env lua5.4
-- refusals.t - what is wrong with an effect, and the line it stands on.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Every case is one line of a scene; the message must name that line, the construct and the rule.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"

local cases = { -- the line, what its message must say after file and line
  { "effect.torque { body = { k*t, 0, 0 } }", "effect.torque: body[1] must be in kg m^2/s^2, got k*t kg m^2/s" },
  { "effect.torque { body = { k*sin(t*q), 0, 0 } }", "sin: the argument must be a pure number or an angle" },
  { "effect.torque { body = { 1, 2, { {0, 0}, {1, 2}, {1, 3} } } }",
    "effect.torque: times of body[3] must ascend, got 1 after 1" },
  { "effect.torque { body = { 1, 2, { {0, 0}, {2, 2}, {1, 3} } } }",
    "effect.torque: times of body[3] must ascend, got 1 after 2" },
  { "effect.torque { inertial = { {{0, k}, {2, q}}, 0, 0 } }",
    "effect.torque: inertial[1][2], its value, must be in kg m^2/s^2, got q = 2 m" },
  { "effect.torque { inertial = { {{k, 0}, {2, 0}}, 0, 0 } }",
    "effect.torque: inertial[1][1], its time, must be in s, got k = 2 kg m^2/s^2" },
  { "effect.torque { inertial = { {{0, t}, {2, 0}}, 0, 0 } }",
    "effect.torque: inertial[1][1], its value, must not depend on time, states or inputs, got t" },
  { "effect.torque { inertial = { {{0, k}}, 0, 0 } }", "must be a number, an expression, or a table of 2 to 100 rows" },
  { "effect.torque { inertial = { {{0, 1, 2}, {1, 2}}, 0, 0 } }", "inertial[1][1] must be a row {t, value}" },
  { "effect.torque { body = {1, 2} }", "effect.torque: body must be a list of 3 numbers, expressions or tables" },
  { "effect.torque { body = {0, 0, 0}, inertial = {0, 0, 0} }", "effect.torque: give body or inertial, one of them" },
  { "effect.drag { c = -1 }", "effect.drag: c must not be negative, got -1" },
  { "effect.drag { c = k }", "effect.drag: c must be in kg m^2, got k = 2 kg m^2/s^2" },
  { "effect.gravity { g = t }", "effect.gravity: g must not depend on time, states or inputs, got t" },
  { "effect.torque { body = { quantity(1, \"N\")*rx, 0, 0 } }",
    "effect.torque: depends on rx, which needs an effect that moves the body" },
  { "effect.drag { }", "effect.drag: c is missing" },
  { "effect.friction { torque = 1 }", "effect.friction: smoothing is missing" },
  { "effect.friction { torque = 1, smoothing = 0 }", "effect.friction: smoothing must be positive, got 0" },
  { "effect.friction { torque = q, smoothing = 1 }", "effect.friction: torque must be in kg m^2/s^2, got q = 2 m" },
  { "effect.spring { stiffness = 1, axis = { 0, 0, 0 } }", "effect.spring: axis must not be zero, got axis {0, 0, 0}" },
  { "effect.spring { stiffness = -1, axis = { 0, 0, 1 } }", "effect.spring: stiffness must not be negative, got -1" },
  { "effect.spring { axis = { 0, 0, 1 } }", "effect.spring: stiffness is missing" },
  { "effect.spring { stiffness = 1, rest = { 0, 0, 0, 0 } }", "effect.spring: rest must not be zero" },
  { "effect.spring { stiffness = 1, rest = 0.5 }", "effect.spring: rest must be a list of 4 numbers, got 0.5" },
  { "effect.spring { stiffness = 1, damping = 0.5 }", "effect.spring: unknown argument \"damping\"" },
  { "effect.magnetic { moment = { 0, 0, 1 } }", "effect.magnetic: give field or rotating, one of them" },
  { "effect.magnetic { moment = { 0, 0, 1 }, rotating = { 0, 0, 1 } }",
    "effect.magnetic: rotating needs rate, and rate needs rotating" },
  { "effect.magnetic { moment = { 0, 0, 1 }, field = { 0, 0, k } }", "effect.magnetic: field[3] must be in kg/s^2/A" },
  { "effect.wheel { axis = { 0, 0, 1 }, inertia = 1 }", "effect.wheel: included is missing" },
  { "effect.wheel { axis = { 0, 0, 0 }, inertia = 1, included = true }", "effect.wheel: axis must not be zero" },
  { "effect.wheel { axis = { 0, 0, 1 }, inertia = 0, included = true }",
    "effect.wheel: inertia must be positive, got 0" },
  { "effect.wheel { axis = { 0, 0, 1 }, inertia = 100, included = true }",
    "wheel: the tensor must stay positive without the wheels that it includes" },
  { "effect.wheel { axis = { 0, 0, 1 }, inertia = 1, included = true, torque = q*t }",
    "effect.wheel: torque must be in kg m^2/s^2, got q*t m s" },
  { "effect.gravity_gradient { mu = 1 }",
    "effect.gravity_gradient: orbit must be a table {radius =} or {a =, e =, anomaly =}" },
  { "effect.gravity_gradient { mu = q, orbit = { radius = 1 } }", "effect.gravity_gradient: mu must be in m^3/s^2" },
  { "effect.gravity_gradient { mu = 1, orbit = { radius = 0 } }",
    "effect.gravity_gradient, orbit: radius must be positive, got 0" },
  { "effect.gravity_gradient { mu = 1, orbit = { a = 1, e = 1 } }",
    "effect.gravity_gradient, orbit: e must be less than 1, got 1" },
  { "effect.gravity_gradient { mu = 1, orbit = { a = 1, e = 0, radius = 1 } }", "unknown argument \"a\"" },
  { "effect.solar_pressure { sun = {1, 0, 0} }", "effect.solar_pressure: plates must be a list of 1 to 64 plates" },
  { "effect.solar_pressure { sun = {0, 0, 0}, plates = {{area = 1, normal = {1, 0, 0}, centre = {0, 0, 0}}} }",
    "effect.solar_pressure: sun must not be zero" },
  { "effect.solar_pressure { sun = {1, 0, 0}, plates = {{area = 1, normal = {0, 0, 0}, centre = {0, 0, 0}}} }",
    "effect.solar_pressure, plates[1]: normal must not be zero" },
  { "effect.solar_pressure { sun = {1, 0, 0}, plates = {{area = q, normal = {1, 0, 0}, centre = {0, 0, 0}}} }",
    "effect.solar_pressure, plates[1]: area must be in m^2, got q = 2 m" },
  { "effect.solar_pressure { sun = {1, 0, 0}, plates = {{area = 1, normal = {1, 0, 0}, centre = {0, 0, 0}, " ..
    "reflectivity = 2}} }", "effect.solar_pressure, plates[1]: reflectivity must not be above 1, got 2" },
  { "effect.pivot { amplitude = 1 }", "effect.pivot: rate is missing" },
  { "effect.pivot { }", "effect.pivot: give acceleration, or amplitude and rate, one of them" },
  { "effect.pivot { amplitude = k, rate = 1 }", "effect.pivot: amplitude must be in m, got k" },
  { "effect.pivot { acceleration = { 2*wx, 0, 0 } }",
    "effect.pivot: acceleration[1] must depend on time and inputs only, got wx" },
  { "effect.pivot { acceleration = { q, 0, 0 } }", "effect.pivot: acceleration[1] must be in m/s^2, got q = 2 m" },
  { "effect.inertia_rate { xx = k*t }", "effect.inertia_rate: xx must be in kg m^2, got k*t" },
  { "effect.inertia_rate { zz = 2*wz }", "effect.inertia_rate: zz must depend on time only, got wz" },
  { "effect.inertia_rate { zx = 1 }", "effect.inertia_rate: unknown argument \"zx\"" },
  { "effect.dissipation { k = -1 }", "effect.dissipation: k must not be negative, got -1" },
  { "effect.dissipation { k = q }", "effect.dissipation: k must be in s/kg/m^2, got q = 2 m" },
  { "effect.custom { }", "effect.custom: must have a torque, a force, a potential or states" },
  { "effect.custom { torque = 3 }", "effect.custom: torque must be a function of the motion" },
  { "effect.custom { torque = function(s) return 1 end }", "effect.custom: torque must be a list of 3 numbers, got 1" },
  { "effect.custom { torque = function(s) return { k*s.w[1], 0, 0 } end }",
    "effect.custom: torque[1] must be in kg m^2/s^2, got k*wx kg m^2/s^3" },
  { "effect.custom { params = { s_gain = 1 }, torque = function(s) return { s.L[2]*s.w[3], 0, 0 } end }",
    "effect.custom: name must not begin with s_, as the emitted code's own names do, got \"s_gain\"" },
  { "effect.custom { torque = function(s) return { s.foo, 0, 0 } end }",
    "effect.custom: has no \"foo\" (it has L, q, r, t, v, w)" },
  -- a number may be meant in any unit, words of the motion alone are what they are
  { "effect.custom { torque = function(s) return { 2*s.w[1] + 3*s.q[1], 0, 0 } end }", false },
  { "effect.custom { torque = function(s) return { -s.w[1]/8 + s.q[1]^2/4, sin(t), 0.1*s.L[1] } end }", false },
  { "effect.custom { torque = function(s) return { s.w[1] + s.q[1], 0, 0 } end }",
    "sum: both sides must have one dimension, got 1/s and a pure number" },
  { "effect.custom { torque = function(s) return { 2*(s.w[1] - s.r[1]), 0, 0 } end }",
    "difference: both sides must have one dimension, got 1/s and m" },
  { "effect.custom { torque = function(s) return s.w end }",
    "effect.custom: torque[1] must be in kg m^2/s^2, got wx 1/s" },
  { "effect.custom { torque = function(s) return { 0, -s.L[2]*s.w[3], s.L[3]*s.w[2] } end }", false },
  { "effect.custom { torque = function(s) return { 0, s.L[2]*s.w[3]^2, 0 } end }",
    "effect.custom: torque[2] must be in kg m^2/s^2, got Ly*wz^2 kg m^2/s^3" },
  { "effect.custom { torque = function(s) return { k*s.q[1] + q*s.q[2], 0, 0 } end }",
    "sum: both sides must have one dimension, got kg m^2/s^2 and m" },
  { "effect.custom { torque = function(s) return { k*cos(q*s.t), 0, 0 } end }",
    "cos: the argument must be a pure number or an angle" },
  { "effect.custom { states = { phi = { unit = \"rad\", rate = function(s) return s.phi end } } }",
    "effect.custom, state phi: rate must be in 1/s, got phi (a pure number)" },
  { "effect.custom { force = function(s) return { s.v[1], 0, 0 } end }",
    "effect.custom: force[1] must be in kg m/s^2, got vx m/s" },
  { "effect.custom { potential = function(s) return s.q[2]^2/2 end }", false },
  { "effect.custom { potential = function(s) return s.r[1]^2/2 end }",
    "effect.custom: depends on rx, which needs an effect that moves the body" },
  { "effect.torque { body = { t, cos(t), t^2 } }", false }, -- t: the number of seconds
  { "effect.torque { inertial = { 0, 0, wx*wy } }",
    "effect.torque: inertial[3] must be in kg m^2/s^2, got wx*wy 1/s^2" },
  { "effect.torque { body = { k*wx, 0, 0 } }", "effect.torque: body[1] must be in kg m^2/s^2, got k*wx" },
  { "effect.torque { body = { k*wx*t, 0.1*t, 0.01*wx } }", false },
  { "effect.custom { potential = function(s) return k*s.w[1]^2 end }",
    "effect.custom: potential must be in kg m^2/s^2, got k*wx^2 kg m^2/s^4" },
  { "effect.custom { potential = function(s) return 2*s.w[1]^2 end }",
    "effect.custom: potential must depend on attitude, position and own states only, got wx" },
  { "effect.custom { params = { wx = 1 }, torque = function(s) return s.w end }",
    "effect.custom: name of a parameter must be three or more small letters or _, got \"wx\"" },
  { "effect.custom { params = { for_ = 1 }, torque = function(s) return s.w end }", "name of a parameter is taken" },
  { "effect.custom { states = { double = {} } }", "name of a state must not be a word of C or C++, got \"double\"" },
  { "effect.custom { states = { phi = 3 } }", "name of a state must have a table {initial =, unit =, rate =}, got 3" },
  { "effect.custom { states = { phi = { unit = \"rad\" } } }",
    "effect.custom, state phi: rate must be a function of the motion" },
  { "effect.custom { states = { phi = { unit = \"m\", rate = function(s) return k end } } }",
    "effect.custom, state phi: rate must be in m/s, got k = 2 kg m^2/s^2" },
  { "effect.custom { states = { phi = { unit = \"deg\", rate = function(s) return 1 end } } }",
    "unit: must be an SI unit without a factor, got \"deg\"" },
}

local function text(line)
  return table.concat({ 'local k = param("k", 2, "N m")', 'local q = param("q", 2, "m")', "local e =",
    "  " .. line, "return scene { name = \"s\", body = solid.box { x = 1, y = 2, z = 3, mass = 4 },",
    "  effects = { e }, initial = { omega = { 1, 0, 1 } } }", "" }, "\n")
end

for _, c in ipairs(cases) do
  local job, why = scene.read(text(c[1]))
  if c[2] then
    tap.ok(job == nil, c[1] .. ": is refused")
    tap.like(why or "", "test.lua:4: ", c[1] .. ": on its line")
    tap.like(why or "", c[2], c[1] .. ": with the rule")
  else
    tap.ok(job ~= nil, c[1] .. ": is accepted", why)
  end
end

-- Elsewhere time and states have no place.
local job, why = scene.read(
  "return scene { name = \"s\",\n body = solid.box { x = 1 + t, y = 2, z = 3, mass = 4 } }\n")
tap.ok(job == nil, "a size that depends on time is refused")
tap.like(why, "test.lua:2: box: x must not depend on time, states or inputs", "with the rule")

-- A parameter of the scene may not have the name of a state that an effect brings.
job, why = scene.read("local p = param(\"phi\", 1, \"rad\")\nreturn scene { name = \"s\",\n" ..
  " body = solid.box { x = 1, y = 2, z = 3, mass = 4 }, effects = {\n" ..
  "  effect.custom { states = { phi = { rate = function(s) return p*s.w[1] end } } } } }\n")
tap.ok(job == nil, "a parameter called as a state is refused")
tap.like(why, "test.lua:1: param: name is taken by a state of the scene", "on the parameter's line")

tap.done()
