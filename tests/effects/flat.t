#!/usr/bin/env lua5.4
-- flat.t - a disc that lies flat: when a run says so, what the emitted code does there, and what is not flat.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Falls from rest go about one line: their time is an integral of the energy's law.  Discs with losses: every engine
-- and method ends at the same time, where the law of docs/plane.md, written down here once more, holds, and with a
-- shorter time.step the library's motion goes on from there, never above what the law says.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = "timeout 100 " .. (os.getenv "POLHODE" or "build/polhode")

local r, half, mass, g = 0.0375, 0.0064, 0.4387, 9.80665
local R = r - half
local I = mass * (3 * r * r + 4 * half * half) / 12 -- of the cylinder across its axis, h = 2 half

local function disc(rest, omega, attitude, more)
  return string.format([[
return scene { name = "disc", body = solid.cylinder { r = 0.0375, h = 0.0128, mass = 0.4387 },
  effects = { effect.plane { surface = contact.disc { r = 0.0375 - 0.0064, edge = 0.0064 }%s }%s },
  initial = { omega = { %s }, attitude = { %s } }, time = { horizon = 3, step = 0.001 } }
]], rest, more or "", omega, attitude)
end

local COLUMNS = "t,qw,qx,qy,qz,wx,wy,wz,N"
-- The event that ends a run as {name, t, ..}, the number of rows, status and what was said.
local function run(text, options, columns)
  program.write(dir .. "/disc.lua", text)
  os.remove(dir .. "/events.csv")
  local status = program.shell(string.format("%s run %s/disc.lua --columns %s %s --events %s/events.csv >%s/out " ..
    "2>%s/err", binary, dir, columns or COLUMNS, options, dir, dir, dir))
  local out, said = program.read(dir .. "/out"), program.read(dir .. "/err")
  local event, rows = {}, select(2, out:gsub("\n", "")) - 1
  for line in ((program.read(dir .. "/events.csv") or ""):match "^[^\n]*\n(.*)$" or ""):gmatch "[^\n]+" do
    event = {}
    for cell in line:gmatch "[^,]+" do event[#event + 1] = tonumber(cell) or cell end
  end
  return event, rows, status, said
end

-- ---- falls ----

-- The time of a fall from the tilt a at rest, and its last rate: height and slope of the centre of mass and moment over
-- mass, functions of the tilt.  Simpson's rule in u, tilt = a - u^2: its error is far below 1e-12 for 2000 parts.
local function falling(a, height, slope, moment)
  local function rate(x) return math.sqrt(2 * g * (height(a) - height(x)) / moment(x)) end
  local parts, sum, top = 2000, 0.0, math.sqrt(a)
  for i = 0, parts do
    local u = top * i / parts
    local f = i == 0 and 2 / math.sqrt(2 * g * slope(a) / moment(a)) or 2 * u / rate(a - u * u)
    sum = sum + (i == 0 and 1 or i == parts and 1 or i % 2 == 1 and 4 or 2) * f
  end
  return sum * top / parts / 3, rate(0)
end

-- rolling: about the contact point, whose arm squared is R^2 + rim^2 + 2 R rim sin; smooth: the centre of mass, at
-- R sin + rim, goes straight down.
local function fall(a, law)
  return falling(a, function(x) return R * math.sin(x) + half end, function(x) return R * math.cos(x) end, function(x)
    return I / mass + (law == "rolling" and R * R + half * half + 2 * R * half * math.sin(x) or (R * math.cos(x)) ^ 2)
  end)
end

local engines = { "", "--method taylor", "--method rkf45", "--method rk8pd", "--method rk4",
  "--engine generated --method rk4", "--engine generated --method adaptive", "--engine generated --method taylor",
  "--engine generated --method rosenbrock", "--engine generated --method rosenbrock --real float",
  "--engine generated --method rk4 --real float", "--engine generated --method adaptive --real float",
  "--engine generated --method taylor --real float" }

-- How long before it is flat a run stops.  generator/commands/run/flat.lua halves the time that is left until the sine
-- of the tilt is at most two roots of a rounding: 2 sqrt(epsilon)/speed, as the sine goes to 0 at that speed.
-- The series in float may end before: what is left, T, is its radius of convergence.  So its coefficient of order 10
-- is about speed/T^10 (the rates are the largest states), which is beyond the range of float, 2^128, for T below
-- (speed 2^-128)^(1/10) = 1.8e-4 s.  From a state nearer than that no step leads on: it is the last.
local function nearest(options, speed)
  if not options:find "float" then return 2 * 2.0 ^ -26 / speed end
  local near = 2 * 2.0 ^ -11.5 / speed
  return options:find "taylor" and math.max(near, (speed * 2.0 ^ -128) ^ (1 / 10)) or near
end

-- rk4: what its steps of 1 ms are off by, 1e-6 of the time.
local function falls(text, a, law, options, what)
  local want, speed = fall(a, law)
  local event, _, status, said = run(text, options)
  local near = nearest(options, speed)
  local off = options:find "float" and 1e-5 * want or options:find "rk4" and 1e-6 * want or 1e-9 * want
  tap.ok(status == 0 and event[1] == "lies_flat" and event[2] <= want + off and event[2] >= want - near - off,
    what .. ", " .. options .. ": it lies flat when its energy says", table.concat(event, " ") .. " " .. want .. said)
  tap.ok(said:find("the disc has fallen flat, and touches the plane in a line at t = 0.0", 1, true),
    what .. ", " .. options .. ": and the run says so", said)
  tap.ok(event[10] and event[10] > 0 and event[10] < 2 * mass * g, what .. ", " .. options .. ": N is finite there")
end

for _, options in ipairs(engines) do
  falls(disc("", "0, 0, 0", 'axis = "x", angle = 0.3'), 0.3, "rolling", options, "rolling")
end
-- At rest so near to flat that it falls within a few time.steps, of which none may be left out; and within less than
-- one, 1 ms: then the disc has settled before anything moves.
for _, a in ipairs { "1e-3", "1e-2" } do
  falls(disc("", "0, 0, 0", 'axis = "x", angle = ' .. a), tonumber(a), "rolling", "", "from " .. a)
end
for _, a in ipairs { "1e-4", "1e-9" } do
  local event, _, status, said = run(disc("", "0, 0, 0", 'axis = "x", angle = ' .. a), "")
  tap.ok(fall(tonumber(a), "rolling") < 0.001 and status == 0 and event[1] == "lies_flat" and event[2] == 0 and
    said:find("the disc has settled flat", 1, true), "from " .. a .. ": it has settled at the start", said)
end
for _, options in ipairs { "", "--engine generated --method adaptive" } do
  falls(disc(', law = "smooth"', "0, 0, 0", 'axis = "y", angle = 0.3'), 0.3, "smooth", options, "smooth")
end

-- However long the grid's steps are.  A smooth disc far below its centre of mass is much faster than one that rolls.
for _, step in ipairs { "0.0001", "0.005", "0.01" } do
  local event, _, status, said = run(disc("", "0, 0, 0", 'axis = "x", angle = 1e-5'), "--step " .. step)
  tap.ok(status == 0 and event[1] == "lies_flat" and event[2] == 0, "settled at the start, --step " .. step, said)
end
for _, options in ipairs { "", "--engine generated --method taylor", "--engine generated --method rk4" } do
  local event, _, status, said = run([[
return scene { name = "disc", body = solid.sphere { r = 0.01, mass = 1 },
  effects = { effect.plane { surface = contact.disc { r = 0.05, at = { 0, 0, -0.5 } }, law = "smooth" } },
  initial = { omega = { 0, 0, 0 }, attitude = { axis = "x", angle = 0.01 } }, time = { horizon = 1, step = 0.001 } }]],
    options)
  local function slope(x) return 0.05 * math.cos(x) - 0.5 * math.sin(x) end
  local want, speed = falling(0.01, function(x) return 0.5 * math.cos(x) + 0.05 * math.sin(x) end, slope, function(x)
    return 0.4 * 0.01 ^ 2 + slope(x) ^ 2
  end)
  local off = options:find "rk4" and 1e-6 or 1e-9
  tap.ok(status == 0 and event[1] == "lies_flat" and event[2] <= want * (1 + off) and
    event[2] >= want * (1 - off) - nearest(options, speed), "top-heavy and smooth, " .. options,
    string.format("%s %.17g %s", event[2], want, said))
end
do
  program.write(dir .. "/disc.lua", disc("", "0, 0, 0", 'axis = "x", angle = 1e-5'))
  for _, command in ipairs { "plot %s/disc.lua -o %s/at_once.svg",
    "view %s/disc.lua --format glb -o %s/at_once.glb" } do
    local status = program.shell(string.format("%s " .. command .. " 2>%s/err", binary, dir, dir, dir))
    tap.ok(status == 3 and program.read(dir .. "/err"):find("the disc has settled flat.*there is no motion to show") and
      not program.read(dir .. "/at_once.svg"), command:match "%a+" .. " says that there is nothing to show",
      program.read(dir .. "/err"))
  end
end

-- A tilted plane across the gravity, and a turned body: nothing is 0 by symmetry.  z of the body in space, by
-- Rodrigues' formula, and the normal (0, -3, 4)/5.
do
  local axis, angle = { 1, 0.5, 0.2 }, 0.3
  local length = math.sqrt(1 + 0.25 + 0.04)
  local x, y, z = axis[1] / length, axis[2] / length, axis[3] / length
  local c, s = math.cos(angle), math.sin(angle)
  local up = { y * s + x * z * (1 - c), -x * s + y * z * (1 - c), c + z * z * (1 - c) }
  local tilt = math.acos((-3 * up[2] + 4 * up[3]) / 5)
  local text = disc(string.format(", normal = { 0, -3, 4 }, gravity = { 0, 0.6*%.17g, -0.8*%.17g }", g, g), "0, 0, 0",
    "axis = { 1, 0.5, 0.2 }, angle = 0.3")
  for _, options in ipairs(engines) do falls(text, tilt, "rolling", options, "skew") end
end

-- ---- losses ----

local LOSSES = disc(", rolling_resistance = { coulomb = 4e-4, smoothing = 0.1 }", "0.2, 0, 20",
  'axis = "x", angle = 0.3')

-- The law: the time of the fall from the highest tilt that is left, s.
local function left(event)
  local qw, qx, qy, qz, wx, wy, wz = table.unpack(event, 3, 9)
  local g1, g2 = 2 * (qx * qz - qw * qy), 2 * (qy * qz + qw * qx)
  local n = g1 * wx + g2 * wy + (1 - 2 * (qx * qx + qy * qy)) * wz
  local k = mass * (g - n * n * half) * R / (I + mass * (R * R + half * half))
  return math.sqrt(2 * (math.sqrt(g1 * g1 + g2 * g2) + (wx * wx + wy * wy) / (2 * k)) / k)
end

local first
for _, options in ipairs(engines) do
  local event, rows, status, said = run(LOSSES, options .. " --every 1")
  tap.ok(status == 0 and event[1] == "lies_flat" and rows == 4 and
    said:find "the disc has settled flat at t = [%d.]+ s: it would not rise again by what it falls in one time%.step",
    "losses, " .. options .. ": the run ends where the disc has settled, and says so", said)
  -- a state of 16 digits, and the search for the time ends within 2^-28 of a step; the clock of float counts steps of
  -- 2.4e-7 s, in which a wobble of 1000 rad/s changes w by 2e-4; rk4 comes there by other last steps, and is as wrong
  tap.ok(event[2] and math.abs(left(event) / 0.001 - 1) < (options:find "float" and 1e-3 or options:find "rk4" and
    1e-3 or 1e-7),
    "losses, " .. options .. ": the law holds there", event[2] and left(event) / 0.001 - 1)
  first = first or event[2]
  -- the library is right to rounding, of a motion that magnifies errors by 1e3 in 2 s; the others by their tolerance,
  -- 1e-12 (1e-6 in float); rk4 in steps of 1 ms is off by some ms in the phase of the wobble
  local most = options:find "rk4" and 0.01 or options:find "float" and 1e-3 or options:find "rkf45" and 1e-6 or 1e-8
  tap.ok(event[2] and math.abs(event[2] - first) < most, "losses, " .. options .. ": at the same time",
    string.format("%s %s", event[2], first))
end
do
  local finer = run((LOSSES:gsub("0.001 }", "0.0005 }")), "--every 1")
  tap.ok(finer[1] == "lies_flat" and finer[2] > first, "a shorter time.step sees it later")
  -- a fall that takes 1 ms begins at the sine k (1 ms)^2/2, k = m G R/J
  local top, k, count = 0.0, mass * g * R / (I + mass * (R * R + half * half)), 0
  local times = {}
  for i = 1, 200 do times[i] = string.format("%.9f", first + (finer[2] - first) * i / 201) end
  run((LOSSES:gsub("0.001 }", "0.0005 }")), "--at " .. table.concat(times, ","), "tilt")
  for line in program.read(dir .. "/out"):gmatch "\n([^\n]+)" do
    top, count = math.max(top, math.sin(tonumber(line))), count + 1
  end
  tap.ok(count == 200 and top <= k * 0.001 ^ 2 / 2, "and does not rise above the fall of one time.step",
    string.format("%d rows, %g of %g", count, top, k * 0.001 ^ 2 / 2))
  program.write(dir .. "/disc.lua", LOSSES)
  for _, command in ipairs { "plot %s/disc.lua -o %s/disc.svg", "view %s/disc.lua --format glb -o %s/disc.glb" } do
    local status = program.shell(string.format("%s " .. command .. " 2>%s/err", binary, dir, dir, dir))
    tap.ok(status == 0 and program.read(dir .. "/err"):find("the disc has settled flat", 1, true),
      command:match "%a+" .. " ends there, too, and says so", program.read(dir .. "/err"))
  end
end

-- ---- what is not flat ----

do -- it comes to 6e-5 rad and rises again: tests/reference/plane.h, disc_fall_and_flip
  local text = [[
return scene { name = "disc", body = tensor { mass = 1, xx = 0.01, yy = 0.01, zz = 0.02 },
  effects = { effect.plane { surface = contact.disc { r = 0.2 }, gravity = 9.81 } },
  initial = { omega = { 0, 0.002, 0.001 }, attitude = { axis = "x", angle = 0.5 } },
  time = { horizon = 0.5, step = 0.001 } }]]
  for _, options in ipairs { "", "--engine generated --method taylor" } do
    local event, rows = run(text, options .. " --every 0.25", "t")
    tap.ok(event[1] == nil and rows == 3, options .. ": a disc that only comes near to flat goes on",
      table.concat(event, " "))
  end
end

do -- in the air and back: it lands on its edge, and falls
  local text = string.gsub(disc(', law = "rolling", impact = { restitution = 0 }', "0, 0, 0",
    'axis = "x", angle = 0.3', ", effect.translation { gravity = 9.80665 }"), "initial = {",
    "initial = { position = { 0, 0, 0.05 },")
  for _, options in ipairs { "", "--engine generated --method taylor" } do
    local event, _, status = run(text, options .. " --every 1", "t,N")
    tap.ok(status == 0 and event[1] == "lies_flat" and event[2] > 0.08, options .. ": a disc that flies and lands",
      table.concat(event, " "))
  end
end

-- ---- the emitted code in the flat state ----

local MAIN = [[
#include "disc.h"
#include <stdio.h>
#include <string.h>
int main(void) {
  static const disc_real flat[DISC_NX] = { 1, 0, 0, 0, 1, 2, 3 };
  disc_model m;
  disc_real x[DISC_NX], com[3], v[3];
  const disc_real u[1] = { 0 };
  if (disc_init(&m, NULL)) return 1;
  printf("%d", !(disc_contact(&m, 0, flat, u, com, v) > 0));
  memcpy(x, flat, sizeof x);
  printf(" %d", disc_adaptive_run(&m, 0, x, u, (disc_real)0.1, (disc_real)1e-5, 1000));
  printf(" %d", memcmp(x, flat, sizeof x) == 0);
  printf(" %d", disc_taylor_run(&m, 0, x, u, (disc_real)0.1, (disc_real)1e-5, 1000));
  printf(" %d", memcmp(x, flat, sizeof x) == 0);
  printf(" %d", disc_rosenbrock_run(&m, 0, x, u, (disc_real)0.1, (disc_real)1e-5, 1000));
  printf(" %d\n", memcmp(x, flat, sizeof x) == 0);
  return 0;
}
]]
program.write(dir .. "/disc.lua", disc("", "0, 0, 0", 'axis = "x", angle = 0.3'))
program.write(dir .. "/main.c", MAIN)
for _, real in ipairs { "double", "float" } do
  local status = program.shell(string.format("%s gen %s/disc.lua --real %s " ..
    "--method rk4,adaptive,taylor,rosenbrock -o %s/%s 2>%s/err && cd %s && " ..
    "%s -std=c99 -I%s -o main main.c %s/disc.c -lm && ./main >out", binary, dir, real, dir,
    real, dir, dir, os.getenv "CC" or "cc", real, real))
  tap.ok(status == 0 and program.read(dir .. "/out") == "1 -1 1 -1 1 -1 1\n",
    real .. ": of a flat disc !(N > 0) holds, and runs return -1 and leave x", program.read(dir .. "/out"))
  tap.ok(program.read(dir .. "/" .. real .. "/disc.h"):gsub("\n %*", ""):find("So ask for !(N > 0) before a step", 1,
    true), real .. ": the header says so")
end

program.finish()
tap.done()
