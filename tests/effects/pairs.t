#!/usr/bin/env lua5.4
-- pairs.t - every two effects together: the emitted code and the library agree, by polhode check.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What is compared and how much may differ is said in generator/commands/check.lua: rates to 8 ulp of the largest term
-- at random times and states, the Jacobian, the stepper's order, the laws that the pair keeps.
-- The quick tier takes every sixth scene.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local quick = program.quick_compiler() -- these scenes are all equations: little to run, much to compile

local effects = {
  { "gravity", "effect.gravity {}" },
  { "damping", "effect.damping { c = {0.1, 0.2, 0.3} }" },
  { "torque", "effect.torque { inertial = { k*sin(2*t), {{4, 0}, {5, k}, {7, -k}}, -0.1*wz } }" },
  { "drag", "effect.drag { c = 0.2 }" },
  { "friction", "effect.friction { torque = k, smoothing = 0.1 }" },
  { "spring", "effect.spring { stiffness = {k, 0.1, 0.2}, rest = {1, 1, 0, 0.5} }" },
  { "magnetic", "effect.magnetic { moment = {0.3, 0, 1}, rotating = {0.1, 0, 0.2}, rate = 2 }" },
  { "wheel", "effect.wheel { axis = {1, 0.5, 1}, inertia = 0.15, speed = 6, torque = k*sin(t), included = true }" },
  { "solar", "effect.solar_pressure { flux = 2e8, sun = {1, 2, 0}, plates = { { area = 1, normal = {1, 0.5, 0}, " ..
    "centre = {0, 1, 0.5}, reflectivity = 0.4 }, { area = 2, normal = {0, 1, -1}, centre = {0.3, 0, 0} } } }" },
  { "pivot", "effect.pivot { acceleration = { 2*sin(3*t), t/8, -0.5 } }" },
  { "parts", "effect.inertia_rate { xx = 0.5*sin(t)^2, zz = k*t*quantity(0.01, \"s\"), xy = 0.1*cos(2*t) }" },
  { "sink", "effect.dissipation { k = 0.02 }" },
  { "custom", "effect.custom { params = {stiff = k}, " ..
    "potential = function(s) return s.stiff*(s.q[2]^2 + s.phi^2) end, " ..
    "states = {phi = {initial = 1, unit = \"rad\", " ..
    "rate = function(s) return s.w[1] - quantity(1, \"1/s\")*s.phi end}} }" },
}

local paths = {}
local function put(name, origin, list)
  local path = dir .. "/" .. name .. ".lua"
  -- an unused parameter would be warned of
  local k = list:gsub("%f[%w]k =", ""):find "%f[%w]k%f[%W]" and "local k = param(\"k\", 0.3, \"N m\")\n" or ""
  program.write(path, k .. string.format("return scene { name = \"%s\",\n" ..
    "  body = solid.box { x = 1, y = 2, z = 3, mass = 3 }, origin = %s,\n  effects = { %s },\n" ..
    "  initial = { omega = { 0.7, -0.3, 0.9 }, attitude = { 0.5, 0.5, 0.5, 0.5 } },\n" ..
    "  time = { horizon = 1 } }\n", name, origin, list))
  paths[#paths + 1] = path
end
for i, a in ipairs(effects) do
  for j = i, #effects do
    local b = effects[j]
    -- each alone, and every third pair
    local both = i == j and a[2] or a[2] .. ", " .. b[2]
    if i == j or (i + j) % 3 == 1 then put(a[1] .. "_" .. b[1], "{ 0, 0.1, 0.2 }", both) end
  end
end

-- What acts about the centre of mass, and what can move it, alone and with some of the others.
local circular = "effect.gravity_gradient { mu = 0.3, orbit = { radius = 0.9 } }"
local elliptic = "effect.gravity_gradient { mu = 0.3, orbit = { a = 0.9, e = 0.3, anomaly = 0.5 } }"
local flying = "effect.translation { gravity = {0, 0, -1} }"
put("circular", "\"centroid\"", circular)
put("elliptic", "\"centroid\"", elliptic)
for i = 2, #effects do
  local name, text = effects[i][1], effects[i][2]
  if name ~= "pivot" then put("circular_" .. name, "\"centroid\"", circular .. ", " .. text) end
  if name == "parts" or name == "sink" or name == "wheel" then
    put("elliptic_" .. name, "\"centroid\"", elliptic .. ", " .. text)
  end
  if name == "solar" or name == "parts" or name == "sink" then
    put("flying_" .. name, "\"centroid\"", flying .. ", " .. text)
  end
end

local rotor = "effect.rotor { axis = {1, 0, 2}, momentum = 0.4 }"
put("rotor_parts", "\"centroid\"", rotor .. ", effect.inertia_rate { yy = 0.3*sin(t), yz = 0.1*t }")
put("rotor_sink", "\"centroid\"", rotor .. ", effect.dissipation { k = 0.02 }")

paths = tier.every(6, paths, 2)
for first = 1, #paths, 30 do -- a run of the program has room for some dozens
  local some = { table.unpack(paths, first, math.min(first + 29, #paths)) }
  local command = string.format("%s timeout 900 %s check --real double --states 200 %s >%s/stdout 2>%s/stderr", quick,
    binary, table.concat(some, " "), dir, dir)
  tap.is(program.shell(command), 0, #some .. " scenes of one and two effects pass")
  for line in program.read(dir .. "/stdout"):gmatch "[^\n]+" do
    local verdict, what = line:match "^(n?o?t? ?ok) %d+ %- (.*)$"
    if verdict then tap.ok(verdict == "ok", what) end
  end
  tap.is(program.read(dir .. "/stderr"), "", "and nothing is complained of")
end

program.finish()
tap.done()
