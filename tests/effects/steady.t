#!/usr/bin/env lua5.4
-- steady.t - steady rolling of bodies of revolution: NAME_steady_spin and NAME_steady_nod against the library's motion.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The library knows Newton's and Euler's laws with the contact force as an unknown, and neither function.  From the
-- spin that the first one gives the tilt must stay, and N be the weight.  With a rate of 1e-5 of nodding the tilt must
-- go as sin(r t)/r with r^2 of the second one, or sinh: at the end of half a nod, and where it has grown e times.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function shell(format, ...) return program.shell(string.format(format, ...)) end

local function scene_of(case, omega, tilt)
  return string.format([[
local low = param("low", %.17g, "m")
return scene { name = "roller", body = tensor { mass = 0.02, xx = %s, yy = %s, zz = %s },
  effects = { effect.plane { surface = %s, gravity = 9.81 } },
  initial = { omega = { %.17g, %.17g, %.17g }, attitude = { axis = "x", angle = %.17g } } }]], case.low or 0.003,
    case.across, case.across, case.along, case.surface, omega[1], omega[2], omega[3], tilt)
end

-- at: tilt and precession; the signs of r^2 are those of the motions.
local cases = {
  { what = "top on a sphere", across = "3e-6", along = "2.5e-6",
    surface = "contact.sphere { r = 0.015, at = { 0, 0, low } }",
    at = { { 0.4, 60.0 }, { 1.2, -90.0 }, { 2.5, 25.0 } } },
  { what = "egg", across = "5e-6", along = "3e-6", low = 0.001,
    surface = "contact.ellipsoid { a = 0.02, b = 0.02, c = 0.03, at = { 0, 0, low } }",
    at = { { 0.3, 80.0 }, { 1.5, 30.0 }, { 1.1, -45.0 } } },
  { what = "thin disc", across = "2e-6", along = "4e-6", surface = "contact.disc { r = 0.02 }",
    at = { { 0.3, 60.0 }, { 1.4, 2.0 }, { 1.4, 10.0 } } },
  { what = "coin with a rounded edge", across = "2e-6", along = "3.9e-6",
    surface = "contact.disc { r = 0.02, edge = low }", at = { { 0.3, 60.0 }, { 1.4, 2.0 } } },
  { what = "paraboloid", across = "5e-6", along = "3e-6", low = -0.01,
    surface = "contact.paraboloid { a = 0.012, b = 0.012, at = { 0, 0, low } }",
    at = { { 0.5, 70.0 }, { 0.2, 20.0 } } },
}

-- {spin, nod} at each tilt and precession, by the emitted code.
local function emitted(case, real)
  local calls = {}
  for i, at in ipairs(case.at) do
    calls[i] = string.format("show(&m, (roller_real)%.17g, (roller_real)%.17g);", at[1], at[2])
  end
  program.write(dir .. "/roller.lua", scene_of(case, { 0, 0, 10 }, 1.0))
  program.write(dir .. "/main.c", '#include "roller_analysis.h"\n#include <stdio.h>\n' ..
    "static void show(const roller_model *m, roller_real tilt, roller_real n) {\n" ..
    '  printf("%.17g %.17g\\n", (double)roller_steady_spin(m, tilt, n), (double)roller_steady_nod(m, tilt, n));\n}\n' ..
    "int main(void) {\n  roller_model m;\n  if (roller_init(&m, 0) != 0) return 1;\n  " ..
    table.concat(calls, "\n  ") .. "\n  return 0;\n}\n")
  local code = shell("(%s gen %s/roller.lua --with analysis --method rk4 --real %s -o %s/made && cc -std=c99 -O1 " ..
    "-I%s/made -o %s/run %s/main.c %s/made/roller_analysis.c %s/made/roller.c -lm && %s/run >%s/out) >%s/log 2>&1",
    binary, dir, real, dir, dir, dir, dir, dir, dir, dir, dir, dir)
  if not tap.is(code, 0, case.what .. ", " .. real .. ": emitted and compiled") then
    tap.diag(program.read(dir .. "/log"))
    return nil
  end
  local rows = {}
  for spin, nod in program.read(dir .. "/out"):gmatch "(%S+) (%S+)" do
    rows[#rows + 1] = { tonumber(spin), tonumber(nod) }
  end
  return rows
end

-- What explain says of the start: {precession, square of the nutation's rate}, twice.
local function explained(case, tilt, omega)
  program.write(dir .. "/start.lua", scene_of(case, omega, tilt))
  shell("%s explain %s/start.lua --format json >%s/said", binary, dir, dir)
  local values, list = json.read(program.read(dir .. "/said")).values, {}
  for i = 1, 2 do
    local n, stable, grows = values["steady_precession_" .. i], values["steady_nutation_" .. i],
      values["steady_growth_" .. i]
    list[i] = n and { n.value, stable and stable.value ^ 2 or -grows.value ^ 2 }
  end
  return list
end

-- tilt and N at the times
local function run(case, tilt, omega, times)
  local words = {}
  for i, t in ipairs(times) do words[i] = string.format("%.17g", t) end
  program.write(dir .. "/start.lua", scene_of(case, omega, tilt))
  local code = shell("%s run %s/start.lua --columns tilt,N --at %s -o %s/out.csv 2>%s/log", binary, dir,
    table.concat(words, ","), dir, dir)
  local rows = {}
  for a, b in (code == 0 and program.read(dir .. "/out.csv") or ""):gmatch "\n([%d.e+-]+),([%d.e+-]+)" do
    rows[#rows + 1] = { tonumber(a), tonumber(b) }
  end
  return #rows == #times and rows or nil, program.read(dir .. "/log")
end

local PUSH = 1e-5 -- rad, the swing of a nod: terms of its square are 1e-5 of it and some factor

local signs = {}
for _, case in ipairs(cases) do
  local rows, float = emitted(case, "double"), emitted(case, "float")
  for i, at in ipairs(rows and float and case.at or {}) do
    local tilt, n, spin, nod = at[1], at[2], rows[i][1], rows[i][2]
    local name = string.format("%s, tilt %g, precession %g", case.what, tilt, n)
    local omega = { 0, n * math.sin(tilt), spin }
    local size = math.max(math.abs(n), math.abs(spin))
    local rate = math.sqrt(math.abs(nod))
    signs[nod > 0] = true
    -- an unstable one leaves by what the rounding of its start grows
    local course, why = run(case, tilt, omega, { 0.5 / rate, 2 / rate })
    local off = 0.0
    for _, row in ipairs(course or {}) do
      off = math.max(off, math.abs(row[1] - tilt), math.abs(row[2] / (0.02 * 9.81) - 1) * rate ^ 2 / size ^ 2)
    end
    tap.ok(course and off < 1e-12, name .. ": the tilt stays and N is the weight", course and off or why)
    local first = nod > 0 and math.pi / rate or 1 / rate
    course = run(case, tilt, { PUSH * rate, omega[2], omega[3] }, { 0.5 * first, first })
    local want = nod > 0 and { 1, 0 } or { (math.exp(0.5) - math.exp(-0.5)) / 2, (math.exp(1) - math.exp(-1)) / 2 }
    for k = 1, 2 do
      local what = string.format("%s: %s %d of 2", name, nod > 0 and "nods" or "falls", k)
      tap.near(course and (course[k][1] - tilt) / PUSH or 0 / 0, want[k], 0, 2e-3, what,
        "terms of second order: 1e-5 times the ratio of curvatures, at most some 100")
    end
    -- the root of a quadratic, and the formula of discs, which is another one
    local near = math.huge
    for _, said in ipairs(explained(case, tilt, omega)) do
      near = math.min(near, math.max(math.abs(said[1] - n), math.abs(said[2] - nod) / size))
    end
    tap.ok(near <= 1e-11 * size, name .. ": explain has this one among the steady motions", near)
    -- float: a few roundings of terms that are larger by what cancels, the squares of both rates
    tap.near(float[i][1], spin, 0, 1e-5 * size, name .. ": float, the spin", "80 roundings")
    tap.near(float[i][2], nod, 0, 1e-4 * size ^ 2, name .. ": float, the nod", "800 roundings of the rates' squares")
  end
end
-- ---- limits ----

-- A thin disc in float, nearly flat: (I3 + m R^2) w n s = I1 n^2 s c - m G R c (tests/reference/README.md, plane.h).
do
  local tilt, n = 2.0 ^ -80, 5.0
  local rows = emitted({ what = "thin disc nearly flat", across = "2e-6", along = "4e-6",
    surface = "contact.disc { r = 0.02 }", at = { { tilt, n } } }, "float")
  local want = (2e-6 * n * n - 0.02 * 9.81 * 0.02 / tilt) / (n * (4e-6 + 0.02 * 0.02 ^ 2))
  tap.near(rows and rows[1][1] or 0 / 0, want, 16 * 2.0 ^ -24, 0, "a tilt of 2^-80 in float", "some ten roundings")
end

-- The values that explain has of a scene; N of the library at the start, and its least one within 0.01 s.
local function both(text)
  program.write(dir .. "/limit.lua", text)
  shell("%s explain %s/limit.lua --format json >%s/said 2>%s/log; %s run %s/limit.lua --columns N --until 0.01 " ..
    "--every 1e-4 -o %s/out.csv 2>%s/log", binary, dir, dir, dir, binary, dir, dir, dir)
  local first, least = 0 / 0, math.huge
  for N in program.read(dir .. "/out.csv"):gmatch "\n([%d.e+-]+)" do
    first = first == first and first or tonumber(N)
    least = math.min(least, tonumber(N))
  end
  return json.read(program.read(dir .. "/said")).values, first, least
end

-- Gravity away from the plane, on which the disc's turning keeps it: what is said of the least tilt, where it starts,
-- is the library's.
do
  local values, N = both [[
return scene { name = "limit", body = solid.cylinder { r = 0.05, h = 0.01, mass = 0.5 },
  effects = { effect.plane { surface = contact.disc { r = 0.045, edge = 0.005 }, gravity = { 0, 0, 9.81 } } },
  initial = { omega = { 0, -40, 130 }, attitude = { axis = "x", angle = 1.2 } } }]]
  tap.near(values.reaction_tilt_least.value, N, 1e-12, 0, "gravity away from the plane: N", "the swing's bar")
  -- contact R + rho s across and rho c along the axis, height R s + rho: I1, I3 about the centre, both times over m
  local s, c, R, rho, w, G = math.sin(1.2), math.cos(1.2), 0.045, 0.005, 130, -9.81
  local I1, I3, h = (3 * 0.05 ^ 2 + 0.01 ^ 2) / 12, 0.05 ^ 2 / 2, R * s + rho
  local a, b, d = s * c * (I1 + h * rho), -(I3 * s + h * (R + rho * s)) * w, -G * R * c
  for i, sign in ipairs { 1, -1 } do
    local p = (-b + sign * math.sqrt(b * b - 4 * a * d)) / (2 * a)
    tap.near(values["steady_precession_" .. i].value, p, 1e-12, 0, "gravity away from the plane: precession " .. i,
      "a sum of two roots, half of which cancels")
  end
end

-- A fall from all but rest: W is constant to rounding where the rate is tiny.  It turns about the contact line, so near
-- to flat, with lengths in R, p = edge/R and J0 = I1/(m R^2) + 1 + p^2: theta'^2 = 2 (g/R) sin(a)/J0, and the centre of
-- mass falls with g - N/m = R ((g/R)/J0 + p theta'^2/J0).
for _, rate in ipairs { "1e-20", "1e-25", "1e-100" } do
  local values, N, least = both(string.format([[
return scene { name = "limit", body = solid.cylinder { r = 0.05, h = 0.01, mass = 0.5 },
  effects = { effect.plane { surface = contact.disc { r = 0.045, edge = 0.005 } } },
  initial = { omega = { 0, %s, 0 }, attitude = { axis = "x", angle = 1e-3 } } }]], rate))
  local what = "a fall with the rate " .. rate
  tap.near(values.reaction_tilt_greatest.value, N, 1e-12, 0, what .. ": N where it starts", "the swing's bar")
  local m, R, p = 0.5, 0.045, 0.005 / 0.045
  local gamma, J0 = 9.80665 / R, (3 * 0.05 ^ 2 + 0.01 ^ 2) / 12 / R ^ 2 + 1 + p ^ 2
  local flat = m * (9.80665 - R * (gamma + p * 2 * gamma * math.sin(1e-3) / J0) / J0)
  -- what turns about the normal, of the size C = 1e-3 rate, adds C^2/s^3 to N, which has a term in s: the least is at
  -- s = sqrt(C) and by as much above
  tap.near(values.reaction_least.value, flat, 1e-12 + 2 * math.sqrt(1e-3 * tonumber(rate)), 0,
    what .. ": the least N, by its energy", "the swing's bar, and what the turning adds")
  tap.ok(least >= flat * (1 - 1e-12), what .. ": and no N of the motion is less")
end

-- At 90 degrees no precession has a term that is not 0.
do
  local values = both(scene_of({ low = 0, across = "5e-6", along = "3e-6", surface =
    "contact.ellipsoid { a = 0.02, b = 0.02, c = 0.03 }" }, { 0, 0, 30 }, math.pi / 2):gsub("angle = [%d.]+",
    "angle = pi/2"))
  tap.ok(not values.steady_precession_1, "an egg on its side has no steady precession of a rounding's size")
end

tap.ok(signs[true] and signs[false], "stable and unstable ones are among them")

tap.done(program.finish())
