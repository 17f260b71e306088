#!/usr/bin/env lua5.4
-- knots.t - steppers go from corner to corner of tables over time, and keep their order; a speed that passes zero.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A ball under a torque about z that a table gives: the rate is the area under a polygon, the angle the area under the
-- parabolas between, both found here by Simpson's rule on each segment, exact for them.  A brick has no such solution:
-- the order shows by halving steps that straddle the corners, and the library (Runge and Kutta extrapolated, in long
-- double, by another road) is the reference of the run.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"

local binary = program.quick()
local dir = program.directory()
local WARN = "-std=c99 -O1 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local function build(name, text, options, main, flags)
  program.write(dir .. "/" .. name .. ".lua", text)
  local status = program.shell(string.format("POLHODE_SOURCE=. %s gen %s -o %s/%s %s/%s.lua 2>%s/log", binary, options,
    dir, name, dir, name, dir))
  if not tap.is(status, 0, name .. ": gen " .. options, program.read(dir .. "/log")) then return {} end
  program.write(dir .. "/" .. name .. "/main.c", main)
  status = program.shell(string.format("cd %s/%s && gcc %s -o main main.c %s.c -lm 2>log && ./main > out && " ..
    "gcc %s -o self %s.c %s_test.c -lm 2>>log && ./self > self.out", dir, name, flags or WARN, name, flags or WARN,
    name, name))
  tap.is(status, 0, name .. ": compiles without a warning, runs, and its self-test passes",
    (program.read(dir .. "/" .. name .. "/log") or "") .. (program.read(dir .. "/" .. name .. "/self.out") or ""))
  local v = {}
  for word in string.gmatch(program.read(dir .. "/" .. name .. "/out") or "", "%S+") do v[#v + 1] = tonumber(word) end
  return v
end

-- the ball: I = 2, rows {t, N}, rate 1/4 at the start, to t = 1; in any segment the angle is so small that a series of
-- order 20 has all digits
local rows = { { 0.125, 0 }, { 0.25, 3 }, { 0.375, -2 }, { 0.75, 1 }, { 0.875, 0 } }
local function torque(t)
  if t <= rows[1][1] then return rows[1][2] end
  for i = 2, #rows do
    local a, b = rows[i - 1], rows[i]
    if t <= b[1] then return a[2] + (b[2] - a[2]) * (t - a[1]) / (b[1] - a[1]) end
  end
  return rows[#rows][2]
end
local function after(stop)
  local rate, angle, t = 0.25, 0.0, 0.0
  local ends = {}
  for _, r in ipairs(rows) do ends[#ends + 1] = r[1] end
  ends[#ends + 1] = 1
  for _, e in ipairs(ends) do
    e = math.min(e, stop)
    local h = e - t
    if h > 0 then
      local function area(u) return u / 6 * (torque(t) + 4 * torque(t + u / 2) + torque(t + u)) / 2 end
      angle = angle + h * rate + h / 6 * (4 * area(h / 2) + area(h))
      rate, t = rate + area(h), e
    end
  end
  return angle, rate
end

local ball = [[
return scene { name = "NAME", body = tensor { mass = 1, xx = 2, yy = 2, zz = 2 },
  effects = { effect.torque { body = { 0, 0, ROWS } } }, initial = { omega = { 0, 0, 0.25 } } }]]
local main = [[
#include "NAME.h"
#include <stdio.h>
static void show(const NAME_real x[]) {
  printf("%.17g %.17g %.17g\n", (double)x[UPPER_QW], (double)x[UPPER_QZ], (double)x[UPPER_WZ]);
}
int main(void) {
  const NAME_real e = (NAME_real)EPS;
  NAME_real x[UPPER_NX], t;
  NAME_model m;
  int i;
  NAME_init(&m, 0);
  NAME_initial(&m, x); NAME_taylor_step(&m, 0, x, 0, 1); show(x); /* over all corners at once */
  NAME_taylor_step(&m, 1, x, 0, -1); show(x);
  NAME_initial(&m, x);
  for (i = 0; i < 8; i++) NAME_taylor_step(&m, (NAME_real)i/8, x, 0, (NAME_real)0.125); /* corners at ends of steps */
  show(x);
  NAME_initial(&m, x); NAME_taylor_step(&m, 0, x, 0, 0.25f); NAME_taylor_step(&m, 0.25f, x, 0, -0.25f); show(x);
  NAME_initial(&m, x); i = NAME_taylor_run(&m, 0, x, 0, 1, e, 1000); show(x); printf("%d\n", i);
  i = NAME_taylor_run(&m, 1, x, 0, 0, e, 1000); show(x); printf("%d\n", i);
  NAME_initial(&m, x);
  for (t = 0, i = 0; t < 1 && i < 1000; i++) t += NAME_taylor_adapt(&m, t, x, 0, 1 - t, e);
  show(x); printf("%d\n", i);
  NAME_initial(&m, x); i = NAME_adaptive_run(&m, 0, x, 0, 1, 64*e, 100000); show(x); printf("%d\n", i);
  i = NAME_adaptive_run(&m, 1, x, 0, 0, 64*e, 100000); show(x); printf("%d\n", i);
  return 0;
}
]]
local plain, named = {}, {}
for i, r in ipairs(rows) do
  plain[i] = string.format("{%g, %g}", r[1], r[2])
  named[i] = string.format("{param(\"s%d\", %g, \"s\"), %g}", i, r[1], r[2])
end
for _, c in ipairs { { "table", "{" .. table.concat(plain, ", ") .. "}", "double" },
  { "named", "{" .. table.concat(named, ", ") .. "}", "double" },
  { "single", "{" .. table.concat(plain, ", ") .. "}", "float" } } do
  local name, eps = c[1], c[3] == "float" and 2.0 ^ -23 or 2.0 ^ -52
  local function fill(text)
    text = string.gsub(string.gsub(text, "NAME", name), "UPPER", string.upper(name))
    return (string.gsub(string.gsub(text, "ROWS", c[2]), "EPS", string.format("%g", eps)))
  end
  local v = build(name, fill(ball), "--method taylor,adaptive --real " .. c[3], fill(main))
  local at = 1
  local function row(stop, what, counted, bound)
    local angle, rate = after(stop)
    local d = math.max(math.abs((v[at] or math.huge) - math.cos(angle / 2)),
      math.abs((v[at + 1] or math.huge) - math.sin(angle / 2)), math.abs((v[at + 2] or math.huge) - rate))
    at = at + 3
    local steps = counted and v[at]
    if counted then at = at + 1 end
    tap.ok(d <= bound * eps and (not counted or steps > 0 and steps <= counted), name .. ": " .. what ..
      (steps and string.format(", %d steps", steps) or ""), string.format("%.3g eps", d / eps))
  end
  -- at most 8 segments or 20 steps, 16 roundings of numbers below 2 in each
  row(1, "one step over all corners", nil, 256)
  row(0, "and back", nil, 512)
  row(1, "steps that end at corners", nil, 256)
  row(0, "to a corner and back", nil, 256)
  row(1, "taylor_run", 20, 320)
  row(0, "taylor_run back", 20, 640)
  row(1, "taylor_adapt", 20, 320)
  -- the pair: an error of 64 eps and 16 roundings in each of its steps, here and on the way back
  row(1, "adaptive_run", 1000, 80 * 1000)
  row(0, "adaptive_run back", 1000, 160 * 1000)
end

-- a brick: fixed steps that straddle the corners keep their order, 8
local brick = [[
return scene { name = "brick", body = tensor { mass = 1, xx = 2, yy = 3, zz = 4 },
  effects = { effect.torque { body = { { {0.3, 0}, {0.7, 1}, {1.1, -1}, {1.2, 0} }, abs(t - 1)*quantity(1, "N m/s"),
    0 } }, effect.torque { inertial = { { {0.65, 1}, {0.7, -1} }, 0, 0 } } }, initial = { omega = { 1, 2, 0.5 } },
  time = { horizon = 2, step = 0.01 } }]]
local v = build("brick", brick, "--method taylor,adaptive --order 8", [[
#include "brick.h"
#include <math.h>
#include <stdio.h>
int main(void) {
  brick_model m;
  double x[3][BRICK_NX], d;
  int i, n, s;
  brick_init(&m, 0);
  for (n = 3; n <= 12; n *= 2) { /* 2 s in n, 2 n and 256 steps */
    for (s = 0; s < 3; s++) {
      const int steps = s == 0 ? n : s == 1 ? 2*n : 512;
      brick_initial(&m, x[s]);
      for (i = 0; i < steps; i++) brick_taylor_step(&m, i*(2.0/steps), x[s], 0, 2.0/steps);
    }
    for (s = 0; s < 2; s++) {
      for (i = 0, d = 0; i < BRICK_NX; i++) d = fmax(d, fabs(x[s][i] - x[2][i]));
      printf("%.17g\n", d);
    }
  }
  return 0;
}
]])
for i = 1, #v, 2 do
  tap.ok(v[i + 1] <= v[i] / 2 ^ 8 * 4 + 1e-13, "halving a step over corners divides its error by some 2^8",
    string.format("%.3g %.3g", v[i], v[i + 1]))
end
tap.ok(#v == 6 and v[1] > 1e-9, "and the error is there to be seen", tostring(v[1]))

-- The library knows the corners of tables, not those of expressions: there the same torque is a table.
program.write(dir .. "/brick.lua", (string.gsub(brick, "abs%b()%*quantity%b()", "{ {0, 1}, {1, 0}, {2, 1} }")))
local function run(more)
  program.shell(string.format("POLHODE_SOURCE=. %s run %s/brick.lua --at 0.7,2 %s > %s/csv 2>&1", binary, dir, more,
    dir))
  local list, text = {}, program.read(dir .. "/csv") or ""
  for line in string.gmatch(text, "[^\n]+") do
    for word in string.gmatch(line, "[^,]+") do list[#list + 1] = tonumber(word) end
  end
  return list, text
end
local want = run ""
for _, how in ipairs { "taylor --order 20 --tolerance 1e-14", "adaptive --tolerance 1e-14" } do
  local got, text = run("--engine generated --method " .. how)
  local d = 0.0
  for i = 1, #want do d = math.max(d, math.abs((got[i] or math.huge) - want[i])) end
  tap.ok(#want >= 16 and d <= 1e-12, "run --method " .. how .. " agrees with the library to 1e-12",
    string.format("%.3g", d) .. text)
end

-- a stone thrown straight up against drag: its speed is the root of a square that vanishes, and the run stops there.
-- v' = -g - c v|v|/m: up to the time atan(v0/vt) vt/g, then v = -vt tanh(g (t - that)/vt), vt = sqrt(m g/c).
program.write(dir .. "/brick.lua", [[
return scene { name = "brick", body = solid.sphere { r = 0.1, mass = 2 }, effects = { effect.translation {
  gravity = {0, 0, -9.5}, drag = 0.25 } }, initial = { velocity = {0, 0, 20} }, time = { horizon = 4, step = 0.01 } }]])
do
  local vt = math.sqrt(2 * 9.5 / 0.25)
  local apex = math.atan(20 / vt) * vt / 9.5
  for _, tolerance in ipairs { "1e-13", "1e-9", "1e-6" } do
    local _, text = run("--engine generated --method taylor --tolerance " .. tolerance)
    local _, last = string.match(text, "([^\n]*)\n([^\n]*)\n?$")
    local got = {}
    for word in string.gmatch(last or "", "[^,]+") do got[#got + 1] = tonumber(word) end
    local e = math.exp(-2 * 9.5 * (2 - apex) / vt)
    local d = math.abs((got[8] or math.huge) + vt * (1 - e) / (1 + e))
    tap.ok(apex < 2 and d <= 20 * (tonumber(tolerance) + 64 * 2.0 ^ -52), "thrown straight up, " .. tolerance ..
      ": the run goes over the corner", string.format("%.3g", d) .. text)
  end
end

-- beyond corners at times that nobody knows (switching.t) there is no transition matrix by one series
local job = assert(scene.read [[return scene { name = "b", body = tensor { mass = 1, xx = 2, yy = 3, zz = 4 },
  effects = { effect.torque { body = { abs(sin(t)), 0, 0 } } } }]])
local planned, d = scene.plan(job, { methods = { "taylor" }, jacobians = true })
tap.ok(not planned and string.find(d:report(), "at times that are not known before", 1, true),
  "jacobians of |sin t| are refused", d:report())

program.finish()
tap.done()
