#!/usr/bin/env lua5.4
-- rest.t - emitted steppers where a body comes to rest in space, and where a motion grows out of nearly nothing.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Expected: closed forms.  rate: the size of the fastest mode, decay: that of the slowest, e: the tolerance.
-- Steps: while the motion lasts (1/e)^(1/5) of order 5 in 1/rate at most; as an error is measured by terms that stay
-- while the motion falls as exp(-decay t), the steps become longer as exp(decay t/5).  At rest an explicit pair is
-- stable up to |h rate| = 3 and more: with what is tried in vain, one step in 1/rate.  L-stable steps have no such
-- limit.  A call begins with a step of its whole time, which falls by 8 at a time: 20 steps are more than that.
-- Errors: a step of a third of 1/decay, as at rest, is wrong by e times what the terms make in it.  Some three of them
-- are still felt.
-- Without a floor for what is left of cancelling forces no number of steps is enough.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary, dir = os.getenv "POLHODE" or "build/polhode", program.directory()
local STRICT = "-pedantic -Wall -Wextra -Wshadow -Werror"
local C99 = " -std=c99 -Wconversion -Wdouble-promotion " .. STRICT

-- One call from time to time, as the times come; a line has the steps that it took, and the state.
local MAIN = [[
#include <stdio.h>
#include "rest.h"
int main(void)
{
  static const double times[] = {0, %s};
  const int most = 200000;
  rest_model m;
  rest_real x[REST_NX];

  if (rest_init(&m, 0)) return 1;
  rest_initial(&m, x);
  for (int i = 1; i < (int)(sizeof times/sizeof *times); i++) {
    const int steps = rest_%s_run(&m, (rest_real)times[i - 1], x, 0, (rest_real)times[i], (rest_real)%s, most);

    printf("%%d", steps);
    for (int k = 0; k < REST_NX; k++) printf(" %%.17g", (double)x[k]);
    puts("");
    if (steps < 0) return 0;
  }
  return 0;
}
]]

local made = {}

-- The code of a scene, made once: its folder; nil and what was said.
local function code(name, scene, real)
  local out = string.format("%s/%s_%s", dir, name, real)
  if made[out] then return out end
  program.write(dir .. "/" .. name .. ".lua", scene)
  if program.shell(string.format("POLHODE_SOURCE=. %s gen %s/%s.lua --method adaptive,rosenbrock --real %s -o %s " ..
    ">%s/said 2>&1", binary, dir, name, real, out, dir)) ~= 0 then return nil, program.read(dir .. "/said") end
  made[out] = true
  return out
end

-- {{steps, state by name} ..} at the times; nil and what was said.
local function run(name, scene, o, times)
  local out, said = code(name, scene, o.real)
  if not out then return nil, said end
  program.write(out .. "/main.c", string.format(MAIN, table.concat(times, ", "), o.method, o.tolerance))
  if program.shell(string.format("cd %s && gcc -O1%s -o main main.c rest.c -lm > said 2>&1 && timeout 60 ./main > rows",
    out, C99)) ~= 0 then return nil, program.read(out .. "/said") end
  local names, rows = {}, {}
  for list in string.gmatch(string.match(program.read(out .. "/rest.h"), "%*/\n  REST_QW.-REST_NX\n"), "REST_(%w+),") do
    names[#names + 1] = string.lower(list)
  end
  for line in string.gmatch(program.read(out .. "/rows"), "[^\n]+") do
    local row, k = {}, 0
    for word in string.gmatch(line, "%S+") do
      row[names[k] or "steps"] = tonumber(word)
      k = k + 1
    end
    rows[#rows + 1] = row
  end
  return rows
end

local function has_floor(name, real)
  return string.find(program.read(string.format("%s/%s_%s/rest.c", dir, name, real)), "static void floors%(") ~= nil
end

local ways = {}
for _, real in ipairs { "double", "float" } do
  for _, method in ipairs { "adaptive", "rosenbrock" } do
    ways[#ways + 1] = { real = real, method = method, tolerance = real == "float" and 1e-5 or 1e-9,
      about = method .. ", " .. real }
  end
end

local function scene(effects, initial, body)
  return string.format("return scene { name = \"rest\", body = %s, effects = { %s }, initial = { %s }, " ..
    "time = { horizon = 1 } }\n", body or "solid.sphere { r = 0.1, mass = 2 }", effects, initial)
end

-- x'' + 2 c x' + k x = g from x0, v0, underdamped: x and x' at t.
local function oscillator(k, c, g, x0, v0)
  local w, rest = math.sqrt(k - c * c), g / k
  local a = x0 - rest
  local b = (v0 + c * a) / w
  return function(t)
    local e, cos, sin = math.exp(-c * t), math.cos(w * t), math.sin(w * t)
    return rest + e * (a * cos + b * sin), e * ((b * w - c * a) * cos - (a * w + c * b) * sin)
  end
end

-- Steps from t0 to t1, at most: the law above.
local function most(o, rate, decay, t0, t1)
  local moving = 5 * rate / decay * (math.exp(-decay * t0 / 5) - math.exp(-decay * t1 / 5))
  return moving * (1 / o.tolerance) ^ (1 / 5) + (o.method == "adaptive" and rate * (t1 - t0) or 0) + 20
end

-- The largest difference from what `expected` has at the times, in parts of `sizes`; are the steps as few as they must
-- be; and their numbers, in words.
local function compare(rows, o, rate, decay, times, expected, sizes)
  local worst, few, steps = 0.0, true, {}
  for i, t in ipairs(times) do
    local row = rows and rows[i] or { steps = -1 }
    steps[i] = string.format("%d", row.steps)
    few = few and row.steps >= 0 and row.steps <= most(o, rate, decay, times[i - 1] or 0, t)
    for key, x in pairs(expected(t)) do
      local d = row[key] and math.abs(row[key] - x) / sizes[string.sub(key, 1, 1)] or math.huge
      worst = d <= worst and worst or d
    end
  end
  return worst, few, table.concat(steps, " ")
end

-- ---- rest ----

-- The terms are some 40 N/kg, |h| is 0.2 s to 0.6 s: errors of v in parts of 10 m/s, and of r in those of 2 m.
local times, g, sizes = { 0.3, 1, 5, 40, 400 }, 9.80665, { r = 2, v = 10 }
local start = "omega = { 0, 0, %s }, position = { 0.3, 0, 0.1 }, velocity = { 0, 1, 0 }"

local function rests(name, about, text, rate, decay, expected)
  for _, o in ipairs(ways) do
    local rows, said = run(name, text, o, times)
    local d, few, steps = compare(rows, o, rate, decay, times, expected, sizes)
    tap.ok(d <= 30 * o.tolerance, about .. ", " .. o.about, said or string.format("%.2g", d))
    tap.ok(few, "in steps as its rates say", steps)
  end
  tap.ok(has_floor(name, "double") and has_floor(name, "float"), "its forces balance at rest")
end

-- r'' = a - 25 r - 2 r': rates -1 +- i sqrt 24.
local function damped(a)
  local x, y, z = oscillator(25, 1, 0, 0.3, 0), oscillator(25, 1, 0, 0, 1), oscillator(25, 1, a, 0.1, 0)
  return function(t)
    local e = {}
    e.rx, e.vx = x(t)
    e.ry, e.vy = y(t)
    e.rz, e.vz = z(t)
    return e
  end
end
rests("weight", "a weight on a damped spring",
  scene("effect.translation { stiffness = 50, linear = 4 }", start:format "0"), 5, 1, damped(-g))
-- The thrust is the weight: the rest is at r = 0, where r has no size either.
rests("held", "a weight that its thrust holds at the spring's centre",
  scene("effect.translation { stiffness = 50, linear = 4, thrust = { 0, 0, 19.6133 } }", start:format "0"), 5, 1,
  damped(0))

-- In a frame that turns at Omega = 2 about z, with the force 3 along x and z = x + i y (generator/dynamics/moving.lua):
--     z'' + (2 + 2 i Omega) z' + (25 - Omega^2) z = 3,   z = 3/21 + sum of A exp(s t) over s = -(1 + 2 i) +- d,
--     d^2 = (1 + 2 i)^2 - 21 = -24 + 4 i,   |s| to 7.1, -Re s from 0.59.
local function times_c(a, b) return { a[1] * b[1] - a[2] * b[2], a[1] * b[2] + a[2] * b[1] } end
local function turning(t)
  local size = math.sqrt(24 ^ 2 + 4 ^ 2)
  local d = { math.sqrt((size - 24) / 2), math.sqrt((size + 24) / 2) }
  local s = { { d[1] - 1, d[2] - 2 }, { -d[1] - 1, -d[2] - 2 } }
  local z0, v0, e = { 0.3 - 3 / 21, 0 }, { 0, 1 }, { rx = 3 / 21, ry = 0, vx = 0, vy = 0 }
  for k = 1, 2 do -- A = (v0 - s2 z0)/(s1 - s2), and the other way round
    local w, apart = times_c(s[3 - k], z0), { s[k][1] - s[3 - k][1], s[k][2] - s[3 - k][2] }
    local n = apart[1] ^ 2 + apart[2] ^ 2
    local A = times_c({ v0[1] - w[1], v0[2] - w[2] }, { apart[1] / n, -apart[2] / n })
    local grown = math.exp(s[k][1] * t)
    local z = times_c(A, { grown * math.cos(s[k][2] * t), grown * math.sin(s[k][2] * t) })
    local v = times_c(s[k], z)
    e.rx, e.ry, e.vx, e.vy = e.rx + z[1], e.ry + z[2], e.vx + v[1], e.vy + v[2]
  end
  return e
end
rests("frame", "at rest in a turning frame",
  scene("effect.rotating_frame { rate = { 0, 0, 2 } }, effect.translation { stiffness = 50, linear = 4, " ..
    "gravity = { 3, 0, 0 } }", start:format "2"), 7.1, 0.59, turning)

-- A force with a sum inside a function, as f = -25 sin(x - 1.1), is known to the terms of the sum.
local function ends(e)
  return function(t) return t < 40 and {} or e end
end
rests("sine", "at rest in a wave's trough",
  scene('effect.translation { linear = 4, gravity = 0 }, effect.custom { force = function(s) return { ' ..
    'quantity(-50, "N")*sin(s.r[1]/quantity(1, "m") - 1.1), 0, 0 } end }', start:format "0"), 5, 1,
  ends { rx = 1.1, vx = 0, vy = 0, rz = 0.1 })
-- The same behind a corner: z'' = -g - 30 z - 2 z' where z < 0, -g - 20 z - 2 z' above.
rests("bent", "a weight on a spring with a kink",
  scene('effect.translation { stiffness = 50, linear = 4 }, effect.custom { force = function(s) return { 0, 0, ' ..
    'quantity(10, "N/m")*abs(s.r[3]) } end }', start:format "0"), math.sqrt(30), 1,
  ends { rx = 0, ry = 0, rz = -g / 30, vx = 0, vy = 0, vz = 0 })

-- The library measures by the same law (src/runtime/integrate/scale.c).
for _, name in ipairs { "weight", "held" } do
  local status = program.shell(string.format("POLHODE_SOURCE=. timeout 60 %s run %s/%s.lua --at 400 --columns " ..
    "rx,ry,rz,vx,vy,vz > %s/csv 2>&1", binary, dir, name, dir))
  local worst, row = 0.0, string.match(program.read(dir .. "/csv"), "\n(.*)") or ""
  local e = damped(name == "weight" and -g or 0)(400)
  local want, k = { e.rx, e.ry, e.rz, e.vx, e.vy, e.vz }, 0
  for word in string.gmatch(row, "[^,%s]+") do
    k = k + 1
    worst = math.max(worst, math.abs((tonumber(word) or math.huge) - (want[k] or math.huge)))
  end
  tap.ok(status == 0 and k == 6 and worst <= 1e-15, name .. ": the library, long after", string.format("%.2g", worst))
end

local function cosh(x) return (math.exp(x) + math.exp(-x)) / 2 end
local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end

-- ---- growth out of nearly nothing ----

-- The largest error in parts of the motion's size, which grows as exp(rate t).  Each step may be wrong by the tolerance
-- of the state, and the errors grow as the motion does, so their number times it is the limit.
local function grows(name, about, text_of, rate, expected, floor)
  for _, o in ipairs(ways) do
    local single = o.real == "float"
    local first, T = single and 1e-30 or 1e-100, (single and 60 or 200) / rate
    local own = name .. "_" .. o.real
    local rows, said = run(own, text_of(string.format("%g", first)), o, { T })
    local row, worst = rows and rows[1] or { steps = -1 }, 0.0
    local want, size = expected(T, first)
    for key, x in pairs(want) do
      local d = row[key] and math.abs(row[key] - x) / size or math.huge
      worst = d <= worst and worst or d
    end
    tap.ok(row.steps > 0 and worst <= row.steps * o.tolerance, about .. ", " .. o.about, said or
      string.format("%.2g in %d steps", worst, row.steps))
    tap.ok(has_floor(own, o.real) == floor, floor and "its terms vanish with the state" or "no forces balance at rest")
  end
end

-- r'' = 25 r: r = r0 cosh 5 t.
grows("hill", "off the top of a hill", function(first)
  return scene("effect.translation { stiffness = -50, gravity = 0 }",
    "omega = { 0, 0, 0 }, position = { " .. first .. ", 0, 0 }")
end, 5, function(t, first)
  local x = first * cosh(5 * t)
  return { rx = x, vx = 5 * first * sinh(5 * t) }, x
end, false)
-- x'' = 20 x + 5 y, y'' = 5 x + 20 y: from x = y the same, by two forces.
grows("saddle", "off a saddle", function(first)
  return scene('effect.translation { stiffness = -40, gravity = 0 }, effect.custom { force = function(s) return { ' ..
    'quantity(10, "N/m")*s.r[2], quantity(10, "N/m")*s.r[1], 0 } end }',
    "omega = { 0, 0, 0 }, position = { " .. first .. ", " .. first .. ", 0 }")
end, 5, function(t, first)
  local x = first * cosh(5 * t)
  return { rx = x, ry = x }, x
end, true)
-- Moments 6.5, 5, 2.5 kg m^2 and w2 = 2: w1' = 2.5/6.5 w2 w3, w3' = 1.5/2.5 w1 w2 while both are small.
local unstable = 2 * math.sqrt(2.5 / 6.5 * 1.5 / 2.5)
grows("flip", "out of a spin about the middle axis", function(first)
  return scene("", "omega = { " .. first .. ", 2, 0 }", "solid.box { x = 1, y = 2, z = 3, mass = 6 }")
end, unstable, function(t, first)
  local x = first * cosh(unstable * t)
  return { wx = x, wz = 1.2 / unstable * first * sinh(unstable * t) }, x
end, false)

-- What sizes are measured by is the same whichever method comes first, or alone.
local function floor_of(out) return string.match(program.read(out .. "/rest.c"), "static void floors%(.-\n}\n") end
for _, name in ipairs { "weight", "bent" } do
  local both, alone = string.format("%s/%s_double", dir, name), string.format("%s/%s_alone", dir, name)
  local status = program.shell(string.format("POLHODE_SOURCE=. %s gen %s/%s.lua --method rosenbrock -o %s >" ..
    "%s/said 2>&1", binary, dir, name, alone, dir))
  tap.ok(status == 0 and floor_of(both) and floor_of(both) == floor_of(alone), name ..
    ": rosenbrock alone has the same", program.read(dir .. "/said"))
end

-- ---- what compilers say ----

for _, name in ipairs { "weight", "frame", "sine", "bent" } do
  for _, real in ipairs { "double", "float" } do
    for _, cc in ipairs { "clang" .. C99, "g++ -std=c++11 -x c++ " .. STRICT } do
      local status = program.shell(string.format("%s -fsyntax-only %s/%s_%s/rest.c > %s/said 2>&1", cc, dir, name, real,
        dir))
      tap.is(status, 0, name .. ", " .. real .. ": " .. cc:match "%S+" .. " has nothing to say",
        program.read(dir .. "/said"))
    end
  end
end

tap.done(program.finish())
