#!/usr/bin/env lua5.4
-- known.t - the bodies do what is known of them: NASA's brick, the Earth, the coin, the flips, the water molecule.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Numbers from outside the project: tests/reference/nesc_case2.h (NASA/TM-2015-218675, check case 2), Euler's period,
-- Feynman's plate, the published moments of water.  The motions come from the program, by the general library and by
-- the emitted code.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local compiled = require "tests.ir.compiled"

local EPSILON = 2.0 ^ -52

local binary = program.quick()

-- Rows of polhode run, as numbers: t, q (4), w (3), energy, L (3).
local function run(body, options)
  local rows = {}
  local pipe = assert(io.popen(string.format("%s run bodies/%s.lua %s 2>/dev/null", binary, body, options)))
  local head = pipe:read "l"
  for line in pipe:lines() do
    local row = {}
    for word in line:gmatch "[^,]+" do row[#row + 1] = tonumber(word) end
    rows[#rows + 1] = row
  end
  pipe:close()
  return rows, head
end

-- ---- every body ----

do
  local pipe = assert(io.popen "ls bodies/*.lua")
  for path in pipe:lines() do
    local name = path:match "([%w_]+)%.lua"
    local text = scene.slurp(path)
    tap.ok(text:find "^%-%- %u[^\n]+%.\n", name .. ": opens with one sentence of what it shows")
    tap.ok(text:find('name%s+= "' .. name .. '"'), name .. ": the scene has the file's name")
    local rows, head = run(name, "--until 1e-12 --every 5e-13")
    local turning, flying = "t,qw,qx,qy,qz,wx,wy,wz,energy,Lx,Ly,Lz", "t,energy,rx,ry,rz,vx,vy,vz"
    tap.ok(head:sub(1, #turning) == turning or head == flying, name .. ": run prints the columns", head)
    local columns = select(2, head:gsub(",", ",")) + 1
    local finite = #rows == 3
    for _, row in ipairs(rows) do
      finite = finite and #row == columns
      for _, x in ipairs(row) do finite = finite and x == x and math.abs(x) < math.huge end
    end
    tap.ok(finite, name .. ": and three rows of as many finite numbers")
  end
  pipe:close()
end

-- ---- NASA's brick ----

local nasa = {}
local nasa_row = "{([%d.]+), {([-%d.e]+), ([-%d.e]+), ([-%d.e]+)}"
for t, p, q, r in scene.slurp("tests/reference/nesc_case2.h"):gmatch(nasa_row) do
  nasa[#nasa + 1] = { tonumber(t), tonumber(p), tonumber(q), tonumber(r) }
end

-- 1e-8 deg/s: simulator 04 is within 4e-10 of the exact solution, its numbers are printed to 12 digits (5e-11 of 34
-- deg/s); RK4 with h = 1 ms leaves (h w)^4 = 1e-13 a radian.
local NASA_TOLERANCE = 1e-8

for _, engine in ipairs { "--engine general", "--engine generated", "--engine generated --method rk4 --step 0.002" } do
  local rows = run("nasa_brick", engine .. " --until 30 --every 0.5")
  local worst, at, drift = 0.0, 0, 0.0
  local matched = #rows == #nasa and #nasa == 61
  for i, row in ipairs(rows) do
    matched = matched and nasa[i] and math.abs(row[1] - nasa[i][1]) < 1e-12
    if not matched then break end
    for k = 1, 3 do
      local d = math.abs(math.deg(row[5 + k]) - nasa[i][1 + k])
      if d > worst or d ~= d then worst, at = d, row[1] end
    end
    drift = math.max(drift, math.abs(row[9] / rows[1][9] - 1))
    for k = 10, 12 do drift = math.max(drift, math.abs(row[k] - rows[1][k]) / math.abs(rows[1][12])) end
  end
  tap.ok(matched, "NASA brick, " .. engine .. ": a row for each of the 61 times")
  tap.ok(matched and worst <= NASA_TOLERANCE,
    "NASA brick, " .. engine .. ": rates as NASA's simulator 04 to 1e-8 deg/s",
    string.format("%.3g deg/s at %g s", worst, at))
  -- 30000 steps with a method error of (h w)^4 each radian of 20: below 1e-11
  tap.near(drift, 0.0, 0.0, 1e-11, "NASA brick, " .. engine .. ": energy and inertial L are constant",
    "the method's error over 20 rad, (0.002 0.65)^4, and rounding")
end

-- ---- the Earth ----

-- C text of a scene's header and source as one unit, and what a body of main prints.
local function emitted(path, text)
  local job = scene.plan(scene.file("bodies/" .. path .. ".lua"))
  local files = scene.files(job)
  local unit = files[path .. ".c"]:gsub('#include "[^\n]*\n', function() return files[path .. ".h"] end)
  return compiled.numbers("#include <stdio.h>\n" .. unit .. "int main(void)\n{\n" .. text .. "  return 0;\n}\n")
end

do
  local w3, A, C = 7.292115e-5, 8.0365e37 * 3043 / 3053, 8.0365e37
  local rate = emitted("earth", [[
  earth_model m;
  earth_orbit o;
  double x[EARTH_NX];
  earth_init(&m, 0);
  earth_initial(&m, x);
  if (earth_solve(&o, &m, x) != 0) return 1;
  printf("%.17e\n", 6.283185307179586/earth_polhode_period(&o));
]])[1]
  -- the pole goes round the figure's axis at (C - A)/A w3 = 10/3043 w3
  tap.near(rate, 10 / 3043 * w3, 2 * 305 * EPSILON, 0.0, "Earth: Euler's rate is (C - A)/A w3",
    "A and C are rounded to double, and C - A loses a factor C/(C - A) of that")
  local period = 2 * math.pi / rate
  local sidereal = 2 * math.pi / w3
  tap.near(period / sidereal, A / (C - A), 4 * 305 * EPSILON, 0.0, "Earth: the period is A/(C - A) turns",
    "the same loss on both sides")
  tap.near(period / sidereal, 305, 0.0, 1, "Earth: Euler's 305 days, to a day",
    "A/(C - A) = 304.3, C/(C - A) = 305.3")
  -- the wobble's phase seen in the rates: back after one period, a quarter turn after a quarter
  for _, engine in ipairs { "--engine generated", "--engine general" } do
    local rows = run("earth", string.format("%s --at %.17g,%.17g", engine, period / 4, period))
    local w1 = 1e-10
    -- the spin's angle is 1900 rad; the wobble's own, 2 pi, is known to some roundings of it
    local who, why = "Earth, " .. engine, "1e-11 rad of phase"
    tap.near(rows[1][7], w1, 0.0, 1e-11 * w1, who .. ": after a quarter of the period the pole is at +90 degrees", why)
    tap.near(rows[1][6], 0.0, 0.0, 1e-11 * w1, who .. ": and no more at 0", why)
    tap.near(rows[2][6], w1, 0.0, 1e-11 * w1, who .. ": after the period it is back", why)
  end
end

-- ---- the coin ----

do
  local r, d = 0.0116, 0.00233
  local I1, I3 = r * r / 4 + d * d / 12, r * r / 2
  local precession = emitted("coin", [[
  coin_model m;
  coin_orbit o;
  double x[COIN_NX];
  coin_init(&m, 0);
  coin_initial(&m, x);
  if (coin_solve(&o, &m, x) != 0) return 1;
  printf("%.17e\n", coin_precession_rate(&o));
]])[1]
  tap.near(precession, math.sqrt(1.5 ^ 2 + (I3 / I1 * 30) ^ 2), 8 * EPSILON, 0.0,
    "coin: the axis goes round L at |L|/I1", "a handful of roundings")
  -- Feynman's plate: 2 to 1 for a thin disc and a small wobble; the thickness takes (d/r)^2/3 = 1.3 percent of it
  tap.near(precession / 30, 2.0, 0.02, 0.0, "coin: it wobbles twice while it spins once", "thickness, 1.3 percent")
end

-- ---- flips about the middle axis ----

for _, case in ipairs { { "tennis_racket", 1 }, { "book", 2 }, { "brick_centroid", 2 } } do
  local body, axis = case[1], case[2]
  local counts = {}
  for i, engine in ipairs { "general", "generated" } do
    local rows = run(body, "--engine " .. engine .. " --every 0.01")
    local count, smallest = 0, math.huge
    for n = 2, #rows do
      if rows[n][5 + axis] * rows[n - 1][5 + axis] < 0 then count = count + 1 end
    end
    -- at a flip the whole spin has turned over: |w| about the axis comes back to its size with the other sign
    for _, row in ipairs(rows) do smallest = math.min(smallest, row[5 + axis]) end
    counts[i] = count
    tap.ok(count >= 1, body .. ", " .. engine .. ": the spin about the middle axis flips", "no change of sign")
    tap.ok(smallest < -0.99 * rows[1][5 + axis], body .. ", " .. engine .. ": completely, to the opposite spin",
      string.format("%g, from %g", smallest, rows[1][5 + axis]))
    local L = 0.0
    for n = 2, #rows do
      for k = 10, 12 do L = math.max(L, math.abs(rows[n][k] - rows[1][k])) end
    end
    local length = math.sqrt(rows[1][10] ^ 2 + rows[1][11] ^ 2 + rows[1][12] ^ 2)
    -- RK4 of 1 ms at 9 rad/s: (h w)^4 = 7e-9 a radian, cancelled for the most part; measured below 1e-9
    tap.near(L / length, 0.0, 0.0, 1e-8, body .. ", " .. engine .. ": while L does not move", "the method's error")
  end
  tap.is(counts[1], counts[2], body .. ": both engines see the same number of flips")
end

-- ---- water ----

do
  local moments = require("generator.report.facts").of(scene.file "bodies/water.lua").moments
  -- Eisenberg and Kauzmann, The Structure and Properties of Water (1969), table 1.2: 1.0220, 1.9187, 2.9376e-40 g cm^2
  for k, want in ipairs { 1.0220e-47, 1.9187e-47, 2.9376e-47 } do
    tap.near(moments[k], want, 0.005, 0.0, "water: moment " .. k .. " as published",
      "the geometry has four digits and is not quite theirs")
  end
  tap.near(moments[1] + moments[2], moments[3], 4 * EPSILON, 0.0, "water: three particles lie in a plane, I1 + I2 = I3",
    "4 roundings")
end

tap.done(program.finish())
