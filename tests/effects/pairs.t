#!/usr/bin/env lua5.4
-- pairs.t - every two effects together: the emitted code and the library agree, by polhode check.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What is compared and how much may differ is said in generator/commands/check.lua: rates to 8 ulp of the largest term
-- at random times and states, the Jacobian, the stepper's order, the laws that the pair keeps.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local effects = {
  { "gravity", "effect.gravity {}" },
  { "damping", "effect.damping { c = {0.1, 0.2, 0.3} }" },
  { "torque", "effect.torque { inertial = { k*sin(2*t), {{4, 0}, {5, k}, {7, -k}}, -0.1*wz } }" },
  { "drag", "effect.drag { c = 0.2 }" },
  { "friction", "effect.friction { torque = k, smoothing = 0.1 }" },
  { "spring", "effect.spring { stiffness = {k, 0.1, 0.2}, rest = {1, 1, 0, 0.5} }" },
  { "magnetic", "effect.magnetic { moment = {0.3, 0, 1}, rotating = {0.1, 0, 0.2}, rate = 2 }" },
  { "wheel", "effect.wheel { axis = {1, 0.5, 1}, inertia = 0.15, speed = 6, torque = k*sin(t), included = true }" },
  { "custom", "effect.custom { params = {stiff = k}, " ..
    "potential = function(s) return s.stiff*(s.q[2]^2 + s.phi^2) end, " ..
    "states = {phi = {initial = 1, unit = \"rad\", rate = function(s) return s.w[1] - s.phi end}} }" },
}

local paths = {}
for i, a in ipairs(effects) do
  for j = i, #effects do
    local b = effects[j]
    local path = string.format("%s/%s_%s.lua", dir, a[1], b[1])
    program.write(path, string.format("local k = param(\"k\", 0.3, \"N m\")\nreturn scene { name = \"%s_%s\",\n" ..
      "  body = solid.box { x = 1, y = 2, z = 3, mass = 3 }, origin = { 0, 0.1, 0.2 },\n  effects = { %s%s },\n" ..
      "  initial = { omega = { 0.7, -0.3, 0.9 }, attitude = { 0.5, 0.5, 0.5, 0.5 } } }\n", a[1], b[1], a[2],
      i == j and "" or ", " .. b[2]))
    paths[#paths + 1] = path
  end
end

local command = string.format("timeout 900 %s check --real double --states 200 %s >%s/stdout 2>%s/stderr", binary,
  table.concat(paths, " "), dir, dir)
tap.is(program.shell(command), 0, #paths .. " scenes of one and two effects pass")
for line in program.read(dir .. "/stdout"):gmatch "[^\n]+" do
  local verdict, what = line:match "^(n?o?t? ?ok) %d+ %- (.*)$"
  if verdict then tap.ok(verdict == "ok", what) end
end
tap.is(program.read(dir .. "/stderr"), "", "and nothing is complained of")

program.finish()
tap.done()
