#!/usr/bin/env lua5.4
-- values.t - the values of the motion in explain against the motion that `polhode run` computes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- run is the general library: Taylor series or its own closed form, which share no formula with report/values.lua.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function output(arguments)
  local status = program.shell(string.format("timeout 120 %s %s >%s/stdout 2>%s/stderr", binary, arguments, dir, dir))
  return status == 0 and program.read(dir .. "/stdout") or nil
end

local function values(scene) return json.read(output("explain " .. scene .. " --format json")).values end

-- Rows of run at the times, each a table by column.
local function rows(scene, times, columns)
  local list, names = {}, {}
  for i, t in ipairs(times) do times[i] = string.format("%.17g", t) end
  local text = output("run " .. scene .. " --at " .. table.concat(times, ",") .. " --columns " .. columns)
  for name in text:match "^[^\n]*":gmatch "[^,]+" do names[#names + 1] = name end
  for line in text:match "\n(.*)":gmatch "[^\n]+" do
    local row, i = {}, 0
    for cell in line:gmatch "[^,]+" do
      i = i + 1
      row[names[i]] = tonumber(cell)
    end
    list[#list + 1] = row
  end
  return list
end

local why = "values to rounding, times the growth of a phase's rounding in the motion"

-- ---- the free asymmetric top ----

for _, case in ipairs { { "bodies/tennis_racket.lua", "wx" }, { "bodies/flipping_box.lua", "wy" },
  { "bodies/brick_centroid.lua", "wy" } } do
  local scene, middle = case[1], case[2]
  local v = values(scene)
  local T = v.polhode_period.value
  local r = rows(scene, { 0, T, T / 2 }, "w,L,momentum,energy")
  for _, name in ipairs { "wx", "wy", "wz" } do
    tap.near(r[2][name], r[1][name], 0, 1e-8, scene .. ": after the polhode's period " .. name .. " is back",
      why .. "; near the separatrix, where periods of 1e-16 of each other differ by 1e-10 of a rate")
  end
  tap.near(v.T.value, r[1].energy, 1e-13, 0, scene .. ": T", "a few products")
  tap.near(v.momentum.value, r[1].momentum, 1e-13, 0, scene .. ": |L|", "a few products")
  for i = 1, 3 do
    local t = v["flip_" .. i].value
    local f = rows(scene, { t - 1e-6, t + 1e-6 }, middle)
    tap.ok(f[1][middle] * f[2][middle] < 0, scene .. ": flip " .. i .. " is where " .. middle .. " changes its sign")
  end
  tap.near(v.flip_3.value - v.flip_1.value, T, 1e-12, 0, scene .. ": two flips in a period", "differences")
  -- the mean precession: of the axis that L goes round, by the sum over a period, which converges exponentially
  local times, n, sum = {}, 2000, 0.0
  for i = 1, n do times[i] = T * (i / n) end
  local about = json.read(output("explain " .. scene .. " --format json")).principal
  local level = v.momentum.value ^ 2 / (2 * v.T.value)
  local k = level > about.moments[2] and 3 or 1
  local a = about.axes[k]
  local I = about.moments[k]
  for _, row in ipairs(rows(scene, times, "w")) do
    local along = I * (a[1] * row.wx + a[2] * row.wy + a[3] * row.wz)
    sum = sum + v.momentum.value * (2 * v.T.value - along ^ 2 / I) / (v.momentum.value ^ 2 - along ^ 2) / n
  end
  tap.near(v.precession_rate.value, sum, 1e-9, 0, scene .. ": the mean precession is that of its rate over a period",
    "2000 points of a period whose sharpest peak is a twentieth of it")
end

-- ---- the free symmetric top ----

for _, scene in ipairs { "bodies/symmetric_top.lua", "bodies/coin.lua" } do
  local v = values(scene)
  local r = rows(scene, { 0, v.precession_period.value, v.wobble_period.value },
    "axis,w,L,omega_inertial,speed,momentum")
  for _, name in ipairs { "axis_x", "axis_y", "axis_z" } do
    tap.near(r[2][name], r[1][name], 0, 1e-13, scene .. ": after the precession's period " .. name .. " is back", why)
  end
  tap.near(r[3].wx, r[1].wx, 0, 1e-12 * r[1].speed, scene .. ": after the wobble's period wx is back", why)
  local function angle(x1, y1, z1, x2, y2, z2)
    local c = (x1 * x2 + y1 * y2 + z1 * z2) / math.sqrt((x1 ^ 2 + y1 ^ 2 + z1 ^ 2) * (x2 ^ 2 + y2 ^ 2 + z2 ^ 2))
    return math.deg(math.acos(c))
  end
  local s = r[1]
  local acos = "arccosines of cosines near 1"
  tap.near(v.axis_to_L.value, angle(s.axis_x, s.axis_y, s.axis_z, s.Lx, s.Ly, s.Lz), 1e-10, 0,
    scene .. ": the axis and L", acos)
  tap.near(v.body_cone.value, angle(s.axis_x, s.axis_y, s.axis_z, s.omega_inertial_x, s.omega_inertial_y,
    s.omega_inertial_z), 1e-10, 0, scene .. ": the cone in the body", acos)
  tap.near(v.space_cone.value, angle(s.Lx, s.Ly, s.Lz, s.omega_inertial_x, s.omega_inertial_y, s.omega_inertial_z),
    1e-10, 0, scene .. ": the cone in space", acos)
end

-- ---- the heavy top ----

for _, case in ipairs { { "bodies/nodding_top.lua", 1 }, { "bodies/heavy_top.lua", -1 } } do
  local scene, side = case[1], case[2] -- heavy_top's centre of mass is on its -z
  local v = values(scene)
  local T, times, n = v.nutation_period.value, {}, 2000
  for i = 0, n do times[i + 1] = T * i / n end
  local least, most, turn, before = math.huge, 0.0, 0.0, nil
  local list = rows(scene, times, "tilt,axis")
  for _, r in ipairs(list) do
    local tilt = side > 0 and r.tilt or math.pi - r.tilt
    least, most = math.min(least, tilt), math.max(most, tilt)
    local phi = math.atan(r.axis_y, r.axis_x)
    if before then turn = turn + (phi - before + math.pi) % (2 * math.pi) - math.pi end
    before = phi
  end
  tap.near(list[n + 1].tilt, list[1].tilt, 0, 1e-10, scene .. ": after a nutation the tilt is back", why)
  tap.near(math.rad(v.tilt_least.value), least, 0, 1e-6, scene .. ": the least tilt",
    "2000 samples of a smooth minimum")
  tap.near(math.rad(v.tilt_greatest.value), most, 0, 1e-6, scene .. ": the greatest tilt",
    "2000 samples of a smooth maximum")
  tap.near(v.precession_rate.value, turn / T, 1e-9, 0, scene .. ": the mean precession", "the angle in one nutation")
  tap.near(v.precession_period.value, 2 * math.pi / math.abs(turn / T), 1e-9, 0, scene .. ": and its period",
    "the angle in one nutation")
end

-- ---- steady rolling of a sphere about its centre of mass ----

-- Its lever about the contact is 0 at every tilt, so the other root of the equation is no precession: it is no row, and
-- not what rounding leaves of 0.  (I1 c - m h y) p = (I3 - m h x/s) w3, h = R, x = -R s, y = -R c.
do
  program.write(dir .. "/rolls.lua", [[return scene { name = "rolls",
    body = tensor { mass = 1, xx = 0.004, yy = 0.004, zz = 0.003 }, initial = { omega = {0, 0, 7},
    attitude = { axis = "x", angle = 2.1 } }, effects = { effect.plane { surface = contact.sphere { r = 0.1 },
    law = "rolling", gravity = 9.81 } } }]])
  local v = values(dir .. "/rolls.lua")
  tap.near(v.steady_precession_1.value, (0.003 + 0.01) * 7 / ((0.004 + 0.01) * math.cos(2.1)), 1e-8, 0,
    "a sphere about its centre: the steady precession", "nine digits are written")
  tap.is(v.steady_precession_2, nil, "and no other")
end

-- ---- other formats, other scenes ----

do
  local text = output "explain bodies/symmetric_top.lua"
  tap.like(text, "body cone: alpha = atan(A/w3) = 3.1996013 deg", "as text, with formula and unit")
  tap.like(output "explain bodies/symmetric_top.lua --format markdown",
    "half angle of the cone of the angular velocity in the body", "as Markdown")
  tap.like(output "explain bodies/symmetric_top.lua --format latex",
    "\\alpha & = \\arctan\\left( \\frac{A}{\\omega_{3}} \\right) \\approx 3.1996",
    "as LaTeX")
  tap.ok(not output "explain bodies/foucault.lua":find("Values of the motion", 1, true), "a point has none")
  local v = values "bodies/dumbbell.lua"
  tap.ok(v.precession_rate and not v.body_cone, "a rod has no cones")
end

program.finish()
tap.done()
