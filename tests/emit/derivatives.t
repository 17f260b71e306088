#!/usr/bin/env lua5.4
-- derivatives.t - the emitted self-test of `gen --with jacobians`: it passes, for every stepper that has a transition
-- matrix, and it finds a derivative that is wrong.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The numbers that it compares with are the generator's; that these are right is tests/dynamics/sensitivity.t and
-- tests/methods/transition.t.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()
local WARN = "-std=c99 -O0 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local function run(command) return program.shell(command .. " >" .. dir .. "/log 2>&1") end
local function log() return program.read(dir .. "/log") end

-- inputs, more parameters than states; a point in a turning frame
program.write(dir .. "/many.lua", [[
return scene { name = "many", origin = "corner",
  body = solid.box { x = param("a", 1, "m"), y = param("b", 2, "m"), z = param("c", 3, "m"),
    mass = param("M", 4, "kg") },
  effects = { effect.control { max = param("limit", 2, "N m") }, effect.damping { rate = param("k", 0.1, "1/s") },
    effect.gravity { g = param("g", 9.8, "m/s^2") }, effect.torque { inertial = { param("n", 1, "N m"), 0, 2 } } },
  initial = { omega = { param("p", 1, "rad/s"), 2, 3 } } }]])
program.write(dir .. "/point.lua", [[
return scene { name = "point", body = solid.sphere { r = param("r", 1, "m"), mass = param("M", 4, "kg") },
  effects = { effect.rotating_frame { rate = { 0, 0, param("W", 0.5, "rad/s") } },
    effect.translation { gravity = { 0, 0, param("g", -9.8, "m/s^2") } } }, initial = { position = { 1, 0, 0 } } }]])


for _, name in ipairs { "many", "point", "bodies/heavy_top", "bodies/thruster", "bodies/wheels" } do
  local path = string.find(name, "/", 1, true) and name or dir .. "/" .. name
  local short = string.match(name, "[%w_]+$")
  for _, method in ipairs { "rk4", "adaptive", "taylor", "semi", "midpoint" } do
    local real = method == "semi" and "float" or "double"
    local out = dir .. "/" .. short .. method
    local status = run(string.format("POLHODE_SOURCE=. %s gen %s.lua --layout single --with jacobians --method %s " ..
      "--real %s -o %s",
      binary, path, method, real, out))
    if method == "midpoint" and (short == "point" or short == "wheels") then
      tap.is(status, 1, short .. ", midpoint: refused")
    else
      tap.is(status, 0, short .. ", " .. method .. ": gen --with jacobians", log())
      status = run(string.format("cd %s && gcc %s -o test %s.c %s_test.c -lm && ./test", out, WARN, short, short))
      tap.is(status, 0, short .. ", " .. method .. ": the self-test compiles and passes", log())
      for _, what in ipairs { "transition matrix agrees", "its transition is the step" } do
        tap.ok(string.find(log(), what, 1, true), short .. ", " .. method .. ": the " .. what)
      end
    end
  end
end

-- wrong by a sign or a factor: found
for _, c in ipairs { { "manyrk4", "many", "many_jacobian_u" }, { "manyrk4", "many", "many_jacobian_p" },
  { "manyrk4", "many", "many_initial_p" }, { "manyrk4", "many", "many_step_transition" },
  { "manymidpoint", "many", "midpoint_tangent" }, { "heavy_toptaylor", "heavy_top", "taylor_along" } } do
  local source = program.read(dir .. "/" .. c[1] .. "/" .. c[2] .. ".c")
  local at = string.find(source, c[3] .. "%([^;]-%)\n{")
  local stop = string.find(source, "\n}\n", at, true)
  local body, count = string.sub(source, at, stop), 0
  body = string.gsub(body, "\n(  [FJSv]%[[%w_]+%] = )([^;]*);", function(head, value)
    count = count + 1
    return count == 3 and string.format("\n%s%s + (%s_real)0.015625;", head, value, c[2]) or nil
  end)
  program.write(dir .. "/wrong.c", string.sub(source, 1, at - 1) .. body .. string.sub(source, stop + 1))
  local status = run(string.format("gcc -std=c99 -I%s/%s -o %s/wrong %s/wrong.c %s/%s/%s_test.c -lm", dir, c[1], dir,
    dir, dir, c[1], c[2]))
  tap.ok(count >= 3 and status == 0, c[3] .. ": spoilt", log())
  tap.is(run(dir .. "/wrong"), 1, c[3] .. ": the self-test finds it", log())
end

-- ---- small and large bodies: the derivatives of I^-1 have no determinant squared, which is I^6 ----

do
  local text = [[
local function I(name, value) return param(name, value, "kg m^2") end
return scene { name = "scaled", body = tensor { mass = 4, xx = I("Ixx", 0.036), yy = I("Iyy", 0.037),
  zz = I("Izz", 0.0067), xy = I("Ixy", 1e-4), xz = I("Ixz", -2e-4), yz = I("Iyz", 5e-5) },
  initial = { omega = { 0.05, -0.03, 0.02 } } }]]
  local main = [[
#include "scaled.h"
#include <math.h>
#include <stdio.h>

/* Moments times s: the rates of change are the same, so their derivatives by the moments go with 1/s. */
int main(void)
{
  scaled_real x[SCALED_NX], first[SCALED_NX*SCALED_NP], J[SCALED_NX*SCALED_NP], p[SCALED_NP];
  scaled_model m;

  scaled_defaults(p);
  if (scaled_init(&m, p) != 0) return 1;
  scaled_initial(&m, x);
  x[SCALED_WX] = 1;
  scaled_jacobian_p(&m, 0, x, 0, first);
  for (int e = -11; e <= 12; e++) {
    const scaled_real s = (scaled_real)pow(10, e);
    int far = 0;

    scaled_defaults(p);
    for (int i = 0; i < SCALED_NP; i++) p[i] *= s;
    if (scaled_init(&m, p) != 0) return 2;
    scaled_jacobian_p(&m, 0, x, 0, J);
    for (int i = 0; i < SCALED_NX*SCALED_NP; i++) far += !(fabs(s*J[i] - first[i]) <= 1e-4*fabs(first[i]) + 1e-5);
    if (far > 0) printf("%d: %d\n", e, far);
  }
  return 0;
}
]]
  local plan = scene.plan(assert(scene.read(text)), { jacobians = true, real = "float", methods = { "rk4" } })
  local files, where = scene.files(plan), program.directory()
  program.write(where .. "/scaled.h", files["scaled.h"])
  program.write(where .. "/scaled.c", files["scaled.c"])
  program.write(where .. "/main.c", main)
  local code = program.shell("cd " .. where .. " && gcc -std=c99 -O1 -ffp-contract=off " ..
    "main.c scaled.c -lm -o scaled >log 2>&1 && ./scaled >out")
  tap.ok(code == 0 and program.read(where .. "/out") == "", "moments of 1e-13 to 1e10 kg m^2: init takes them, in " ..
    "float, and the derivatives scale as they should", code .. " " .. (program.read(where .. "/log") or "") ..
    (program.read(where .. "/out") or ""))
end

program.finish()
tap.done()
