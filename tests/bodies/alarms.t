#!/usr/bin/env lua5.4
-- alarms.t - polhode check has no false alarm, and no silence: scenes whose terms lie far apart, bend, or have corners.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each scene is right, by the other checks; what is asked here is that a bound of check knows what the scene has.
-- Random scenes of such kinds are product.t's.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local polhode = program.quick()

local function check(text, options)
  program.write(dir .. "/s.lua", text)
  local status, out, err = program.output(string.format("timeout 100 %s check %s %s/s.lua", polhode, options, dir))
  local bad, good = {}, 0
  for line in out:gmatch "[^\n]+" do
    if line:find "^not ok" then bad[#bad + 1] = line end
    if line:find "^ok" and not line:find "# SKIP" then good = good + 1 end
  end
  return status, good, table.concat(bad, "\n") .. err, out
end

local function scene(body, effects, more)
  return "local gain = input(\"gain\", \"N m\")\nreturn scene { name = \"s\", body = " .. body .. ", effects = { " ..
    effects .. " }, initial = { omega = {1, 2, 3}" .. (more or "") .. " } }"
end

local BODY = "tensor { mass = 1, xx = 3, yy = 4, zz = 5 }"
for _, c in ipairs {
  -- Jacobi's integral has Omega . L, and here nearly all of L is the rotor's
  { "a strong rotor in a turning frame", scene(BODY, "effect.rotating_frame { rate = {.1, .2, .3} }, " ..
    "effect.rotor { axis = {1, 2, 2}, momentum = 3000 }") },
  { "a fast wheel in a turning frame", scene(BODY, "effect.rotating_frame { rate = {.1, .2, .3} }, " ..
    "effect.wheel { axis = {1, 2, 2}, inertia = 0.1, speed = 30000, included = false }") },
  { "a thrust that bends with the rates", scene(BODY, "effect.translation { gravity = 0, " ..
    "thrust = { quantity(1, \"N\")*tanh(quantity(1, \"s\")*wz), 0, 0 } }") },
  { "damping that bends with the rates", scene(BODY, "effect.damping { c = quantity(1, \"N m s\")*" ..
    "(2 + tanh(quantity(8, \"s\")*wz)) }") },
  { "a corner that an input moves", scene(BODY, "effect.torque { body = {0, 0, " ..
    "-abs(quantity(1, \"N m s\")*wz - gain)} }") },
  { "drag of a point", scene(BODY, "effect.translation { gravity = 9, drag = 2 }", ", velocity = {1, 0, 0.01}") },
} do
  local status, good, bad = check(c[2], "--real double --states 200")
  tap.ok(status == 0 and good >= 9, c[1] .. ": " .. good .. " checks, no alarm", status .. " " .. bad)
end

-- moments of 1e-46 kg m^2 are below the least number of float
local tiny = scene("solid.box { x = 1e-15, y = 2e-15, z = 3e-15, mass = 1e-16 }", "effect.damping { c = 1e-47 }")
local status, _, bad, out = check(tiny, "--real float --states 20")
tap.ok(status == 1 and out:find "not ok 1" and bad:find "must be within its range",
  "what float cannot hold is no success where float is asked for", status .. " " .. out .. bad)
status, _, bad, out = check(tiny, "--states 20")
tap.ok(status == 0 and out:find "# SKIP its constants are outside the range of float",
  "and is passed over, with a word, beside double", status .. " " .. out .. bad)

tap.done(program.finish())
