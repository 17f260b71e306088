#!/usr/bin/env lua5.4
-- switching.t - emitted steppers with a tolerance end their steps where the equations have corners.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Expected: closed forms of equations of one state each; drag straight up by tan and tanh; the rest by the library's
-- rk8pd at 1e-15, another road, which crosses corners by very short steps.  At the tolerance 1e-13 a method that
-- misses a corner of a smooth course by one step is off by h^2, 1e-3 and more; what is asked for is 1e-10.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary, dir = program.quick(), program.directory()
local methods = { "adaptive", "taylor", "rosenbrock" }

-- The row at t: numbers by the columns' names; nil and what the program said.
local function at(scene, t, options)
  program.write(dir .. "/s.lua", scene)
  local status, out, err = program.output(string.format("POLHODE_SOURCE=. timeout 60 %s run %s/s.lua --at %s %s",
    binary, dir, t, options))
  local names, values = string.match(out, "^([^\n]*)\n([^\n]*)")
  if status ~= 0 or not values then return nil, err end
  local row, each = {}, string.gmatch(values, "[^,]+")
  for name in string.gmatch(names, "[^,]+") do row[name] = tonumber(each()) end
  return row
end

-- ---- each kind of corner, one state each ----

local ln2 = math.log(2)
local a = math.acos(0.99)
local cases = { -- name, start, rate, value at t = 5.5
  -- y' = y - 2 to y = 0 at ln 2, then y' = -y - 2
  { "bars", 1, "abs(s.bars) - 2", -2 + 2 * math.exp(ln2 - 5.5) },
  -- y' = -3/2 to y = 0 at 2/3, then -1/2
  { "signs", 1, "-1 - sign(s.signs)/2", -(5.5 - 2 / 3) / 2 },
  -- 2 exp(-t) to y = 1 at ln 2, then -y > -1 and y' = -1
  { "least", 2, "min(-s.least, -1)", 1 - (5.5 - ln2) },
  { "most", 2, "-max(s.most, 1)", 1 - (5.5 - ln2) },
  { "limits", 1, "-max(-0.5, min(0.5, s.limits))", 0.5 * math.exp(-4.5) }, -- y' = -1/2 to t = 1, then y' = -y
  { "each", 0, "sign(sin(pi*s.t))", 0.5 }, -- up for a second, down for one
  { "fast", 0, "sign(sin(20*pi*s.t))", 0 }, -- 110 seconds of a twentieth, 55 up and 55 down
  { "twice", 0, "max(0, cos(s.t) - 0.99)", math.sin(a) - 0.99 * a }, -- two zeros 0.28 s apart at 2 pi > 5.5; half at 0
  { "touch", 0, "abs(sin(pi*s.t))", 2 / math.pi * 5 + 1 / math.pi }, -- corners where `each` has its jumps
  { "ramp", 0, "abs(s.t - 1)", 0.5 + 4.5 ^ 2 / 2 }, -- at a time that is known: a knot
  { "nested", 3, "-min(abs(s.nested), max(1, s.t - 1))", nil },
}
-- y' = -1 to t = 2, y = 1; then |y| <= 1 <= t - 1: y' = -y
cases[#cases][4] = math.exp(-3.5)

-- A scene with the states of a list of cases.
local function states_of(list)
  local text = {}
  for i, c in ipairs(list) do
    text[i] = string.format('%s = { initial = %g, unit = "1", rate = function(s) return quantity(1, "1/s")*(%s) end }',
      c[1], c[2], (c[3]:gsub("s%.t", "one(s.t)")))
  end
  return [[local function one(t) return t/quantity(1, "s") end
return scene { name = "corners", body = solid.box { x = .3, y = .2, z = .1, mass = 2 }, time = { horizon = 6 },
  effects = { effect.custom { states = { ]] .. table.concat(text, ",\n") .. " } } } }"
end

for _, method in ipairs(methods) do
  local options = "--engine generated --method " .. method .. " --tolerance 1e-13"
  for _, c in ipairs(cases) do
    local row, why = at(states_of { c }, 5.5, options)
    tap.near(row and row[c[1]] or math.huge, c[4], 1e-10, 1e-10, method .. ": " .. c[1] .. "' = " .. c[3],
      "some hundred steps, see the head; " .. (why or ""))
  end
  -- All of them in one scene: at ln 2 three zeros are within roundings of each other, at 1 five are, at 2 and 3 others.
  local row, why = at(states_of(cases), 5.5, options)
  for _, c in ipairs(cases) do
    tap.near(row and row[c[1]] or math.huge, c[4], 1e-10, 1e-10, method .. ", beside the others: " .. c[1],
      "as alone, and errors of roundings where zeros coincide; " .. (why or ""))
  end
end

-- ---- where both sides of a sign push back to 0 there is no motion on either: refused, not wrong ----

-- Or a step landed on 0 itself: sign(0) = 0, and there it stays.
local function held(row, name, why)
  if row then return row[name] == 0 end
  return string.find(why, "no steps lead on", 1, true)
end

for _, method in ipairs(methods) do
  local row, why = at([[return scene { name = "stuck", body = tensor { mass = 1, xx = 1, yy = 1, zz = 1 },
    effects = { effect.torque { body = { 0, 0, -1*sign(wz) } } }, initial = { omega = {0, 0, 1} } }]], 2,
    "--engine generated --method " .. method .. " --tolerance 1e-9")
  tap.ok(held(row, "wz", why), method .. ": a sign that holds the motion at 0 ends the run", why)
  local more = { { "stuck", 1, "-sign(s.stuck)" }, table.unpack(cases) } -- at rest at t = 1, where others have corners
  row, why = at(states_of(more), 5.5, "--engine generated --method " .. method .. " --tolerance 1e-9")
  tap.ok(held(row, "stuck", why), method .. ": so does one beside other corners", why)
end

-- ---- there and back: what passed the corners comes back to where it began ----

for _, method in ipairs(methods) do
  program.write(dir .. "/corners.lua", states_of(cases))
  program.write(dir .. "/back.c", (([[
#include "corners.h"
#include <math.h>
#include <stdio.h>
int main(void)
{
  double x[CORNERS_NX], x0[CORNERS_NX], worst = 0;
  int i;
  corners_model m;
  if (corners_init(&m, 0)) return 1;
  corners_initial(&m, x);
  corners_initial(&m, x0);
  if (corners_METHOD_run(&m, 0, x, 0, 2.63, 1e-13, 100000) < 0) return 1;
  if (corners_METHOD_run(&m, 2.63, x, 0, 0, 1e-13, 100000) < 0) return 1;
  for (i = 0; i < CORNERS_NX; i++) worst = fmax(worst, fabs(x[i] - x0[i]));
  printf("%.3g\n", worst);
  return 0;
}
]]):gsub("METHOD", method)))
  local here = os.getenv "PWD"
  local status = program.shell(string.format("cd %s && rm -rf out && " ..
    "POLHODE_SOURCE=%s %s gen corners.lua -o out --method %s >err 2>&1 && " ..
    "cc -O1 -Iout back.c out/corners.c -o back -lm && timeout 60 ./back > csv", dir, here,
    string.gsub(binary, "build/polhode", here .. "/build/polhode"), method))
  local worst = tonumber(program.read(dir .. "/csv") or "")
  -- some thousand steps of 1e-13, grown by e^2.6 at most
  tap.ok(status == 0 and worst and worst <= 1e-10, "there and back by " .. method, tostring(worst))
end

-- ---- plates, drag, friction ----

local scenes = {
  { "solar_two_plates", 5, [[effect.solar_pressure { flux = 3e8, sun = {1,0,0}, plates = {
    { area = 1, normal = {1,0,0}, centre = {0,0.5,0} },
    { area = 1, normal = {1,0.0003,0}, centre = {0,-0.3,0.2} } } }]],
    "omega = {0, 0, 1}" },
  { "drag_turned_round", 5, "effect.drag { c = 0.3 }, effect.torque { body = {0,0,-1} }", "omega = {0, 0, 0.4334}" },
  { "abs_of_rates", 5, "effect.torque { body = { -1*abs(wy), 0, 1*abs(wx) } }", "omega = {-2.194, 2.085, 1.583}" },
  { "abs_and_drag", 5, "effect.drag { c = 0.3 }, effect.torque { body = { -1*abs(wy), 0, 1*min(wx, 0.1*wz) } }",
    "omega = {-2.194, 2.085, 1.583}" },
}
local function scene(name, effects, initial)
  return string.format("return scene { name = %q, body = tensor { mass = 1, xx = 1, yy = 1.2, zz = 1.5 },\n" ..
    "effects = { %s }, initial = { %s } }", name, effects, initial)
end

local function apart(text, t, method, tolerance)
  local true_row, why = at(text, t, "--method rk8pd --tolerance 1e-15")
  local row, also = at(text, t, string.format("--engine generated --method %s --tolerance %s", method, tolerance))
  if not (row and true_row) then return math.huge, (why or "") .. (also or "") end
  local d = 0.0
  for name, x in pairs(true_row) do d = math.max(d, math.abs(x - row[name]) / (1 + math.abs(x))) end -- any order
  return d
end
for _, s in ipairs(scenes) do
  for _, method in ipairs(methods) do
    local d, why = apart(scene(s[1], s[3], s[4]), s[2], method, "1e-13")
    tap.ok(d <= 1e-10, s[1] .. " by " .. method, string.format("%.3g", d) .. (why or ""))
  end
end
-- w' = -1.5 (here I = 1) while w > 0, then -1/2 but for smoothing's 1e-9: w(3) = -(3 - w0/1.5)/2
for _, method in ipairs(methods) do
  local row = at([[return scene { name = "friction_sharp", body = tensor { mass = 1, xx = 1, yy = 1.2, zz = 1 },
    effects = {
    effect.friction { torque = 0.5, smoothing = 1e-9 }, effect.torque { body = {0,0,-1} } },
    initial = { omega = {0,0,1.5084} } }]], 3, "--engine generated --method " .. method .. " --tolerance 1e-12")
  tap.near(row and row.wz or math.huge, -(3 - 1.5084 / 1.5) / 2, 0, 1e-8,
    "friction that turns round, by " .. method, "the layer of 1e-9 in which friction is not 1/2 takes 1e-9 s or so")
end

-- ---- 200 stones straight up ----

-- v' = -g - k |v| v; up: v = c tan(atan(v0/c) - g t/c), c = sqrt(g/k); down: -c tanh(..)

for _, method in ipairs(methods) do
  program.write(dir .. "/stone.lua", [[return scene { name = "stone",
    body = tensor { mass = 1, xx = 1, yy = 1.2, zz = 1.5 },
    effects = { effect.translation { gravity = 9, drag = 0.3 } }, initial = { omega = {1,2,3}, velocity = {0,0,1} } }]])
  program.write(dir .. "/stones.c", (([[
#include "stone.h"
#include <math.h>
#include <stdio.h>
int main(void)
{
  const double g = 9, k = 0.3, c = sqrt(g/k), T = 2;
  double worst = 0;
  unsigned r = 12345;
  int i, failed = 0;
  stone_model m;
  if (stone_init(&m, 0)) return 1;
  for (i = 0; i < 200; i++) {
    double x[STONE_NX], v0, up, v, z, e;
    stone_initial(&m, x);
    r = r*1664525u + 1013904223u;
    v0 = 10*(double)(r >> 8)/16777216;
    x[STONE_VZ] = v0;
    failed += stone_METHOD_run(&m, 0, x, 0, T, 1e-13, 1000000) < 0;
    up = c/g*atan(v0/c);
    v = T < up ? c*tan(atan(v0/c) - g*T/c) : -c*tanh(g*(T - up)/c);
    z = T < up ? c*c/g*log(cos(atan(v0/c) - g*T/c)/cos(atan(v0/c)))
      : c*c/g*(-log(cos(atan(v0/c))) - log(cosh(g*(T - up)/c)));
    e = fmax(fabs(x[STONE_VZ] - v), fabs(x[STONE_RZ] - z));
    worst = fmax(worst, e);
  }
  printf("%d %.3g\n", failed, worst);
  return 0;
}
]]):gsub("METHOD", method)))
  local status = program.shell(string.format("cd %s && rm -rf out && " ..
    "POLHODE_SOURCE=%s %s gen stone.lua -o out --method %s >err 2>&1 && " ..
    "cc -O1 -Iout stones.c out/stone.c -o stones -lm && timeout 60 ./stones > csv", dir, os.getenv "PWD",
    string.gsub(binary, "build/polhode", os.getenv "PWD" .. "/build/polhode"), method))
  local failed, worst = string.match(program.read(dir .. "/csv") or "", "^(%d+) (%S+)")
  -- heights of some 5 m, some hundred steps of 1e-13: 1e-10
  tap.ok(status == 0 and failed == "0" and tonumber(worst) <= 1e-10, "200 stones straight up by " .. method,
    tostring(worst) .. " " .. tostring(program.read(dir .. "/err")))
end

tap.done(program.finish())
