#!/usr/bin/env lua5.4
-- plane_long.t - what bodies on a plane conserve over long times, and what that costs: the numbers of docs/plane.md.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Energy of rolling over 1e4 s by the Taylor series at 1e-14: steps are cut so that what they leave is below the
-- rounding; some 1e6 of them round the state by half a unit each, walking, 1e3 u = 1e-13 of the energy that moves;
-- asked for 1e-12.  Jellett's integral over inversions of the tippe top with both laws of friction: some 1e4 steps,
-- 1e2 u.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

-- The first and the last value of a column; a run that takes more than 100 processor seconds is ended.  Measured: 5 to
-- 60 s.
local function ends(path, options, column)
  local status = program.shell(string.format("ulimit -t 100; %s run %s --engine generated " ..
    "--method taylor %s --columns 't,X = %s' >%s/out 2>%s/err", binary, path, options, column, dir, dir))
  local first, last
  for t, x in (program.read(dir .. "/out") or ""):gmatch "\n([%d.e+-]+),([%d.e+-]+)" do
    first, last = first or tonumber(x), t and tonumber(x)
  end
  return status == 0 and first, last
end

for _, run in ipairs { { "chaplygin_ball", 10000 }, { "rolling_coin", 10000 }, { "rattleback", 2500 } } do
  local body, span = run[1], run[2]
  local first, last = ends("bodies/" .. body .. ".lua", "--tolerance 1e-14 --until " .. span .. " --every " .. span,
    "energy")
  tap.ok(first and last and math.abs(last / first - 1) < 1e-12, body .. ": energy over " .. span .. " s",
    first and string.format("%.3g", last / first - 1) or program.read(dir .. "/err"))
end

for _, c in ipairs { { "viscous = 1", 180 }, { "viscous = 0.5", 220 }, { "coulomb = 0.3, smoothing = 0.01", 200 },
  { "coulomb = 0.1, smoothing = 0.002", -180 } } do
  program.write(dir .. "/s.lua", string.format([[
return scene { name = "top", body = tensor { mass = 0.006, xx = 8e-7, yy = 8e-7, zz = 7e-7 },
  effects = { effect.plane { surface = contact.sphere { r = 0.015, at = {0, 0, 0.003} }, law = "sliding",
    friction = { %s } } },
  initial = { omega = {0, 0, %d}, attitude = { axis = "x", angle = 0.1 } }, time = { step = 0.0005 } }]], c[1], c[2]))
  local options = "--tolerance 1e-15 --until 8 --every 8"
  local first, last = ends(dir .. "/s.lua", options, "0.015*Lz - 0.003*L_body_z")
  tap.ok(first and math.abs(last / first - 1) < 1e-14, "Jellett's integral over an inversion, " .. c[1],
    first and string.format("%.3g", last / first - 1) or program.read(dir .. "/err"))
  local _, tilt = ends(dir .. "/s.lua", options, "qw^2 - qx^2 - qy^2 + qz^2")
  tap.ok(tilt and tilt < 0, "it has turned over", tilt)
end

program.finish()
tap.done()
