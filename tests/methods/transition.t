#!/usr/bin/env lua5.4
-- transition.t - NAME_step_transition of every stepper that has one, against differences of the step it belongs to.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Two programs from the same emitted files: one in double or float prints the transition matrix of one step and the
-- product of those of STEPS steps; one with the real type made long double knows the step only, and forms central
-- differences of one step and of all, by d, d/2, d/4 of each state, extrapolated twice (error d^6 times the seventh
-- derivative over 7! 64, 2^-54 at d = 2^-9, and 2^-53 of rounding; the constants are the emitted doubles in both).
-- Tolerance: no entry is more than 256 operations deep (seven stages of some 32), half a unit each, of the largest
-- number in its row or 1; the product of n such matrices n times that, of the product's largest.
-- Consistency: what a method keeps exactly, L in space, its transition matrix keeps: grad L(x1) F v = grad L(x0) v for
-- v along |q| = 1.  L is a polynomial, of degree 2 in each state, so that central differences by 1 are its derivatives.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local program = require "tests.cli.program"

local STEPS, DEPTH = 12, 128
local dir = program.directory()

local BRICK = "tensor { mass = 1, xx = 2, yy = 3, zz = 4 }"
local ROUND = "tensor { mass = 1, xx = 3, yy = 3, zz = 2, com = {0, 0, 0.5} }"
local LONG = "tensor { mass = 1, xx = 3, yy = 4, zz = 2, com = {0, 0, 0.5} }"
local FULL = "tensor { mass = 1, xx = 3, yy = 3.5, zz = 4, xy = 0.3, xz = -0.5, yz = 0.25, com = {0.1, 0, 0.5} }"
local GRAVITY = "effect.gravity { g = 8 }"

-- {what, body, effects, keeps: what of L in space every step keeps}
local rows = {
  { "a free brick", BRICK, "", keeps = 3 },
  { "a free ball", "solid.sphere { r = 0.5, mass = 3 }", "", keeps = 3 },
  { "a rod", "rod.between { from = {0, 0, 0}, to = {0, 0, 1}, mass = 1 }", GRAVITY },
  { "a heavy symmetric top", ROUND, GRAVITY, keeps = 1 },
  { "a heavy top", LONG, GRAVITY, keeps = 1, float = true },
  { "a full tensor, damped", FULL, GRAVITY .. ", effect.damping { c = {0.1, 0.2, 0.3} }" },
  { "a damped and driven brick with a rotor", BRICK, "effect.damping { c = {0.1, 0.2, 0.3} }, effect.control {}, " ..
    "effect.torque { body = {0.5, -0.25, 0.125} }, effect.rotor { axis = {3, 0, 4}, momentum = 5 }" },
  { "torque over time", BRICK, "effect.torque { body = { cos(2*t), t*quantity(1, \"N m/s\"), 0 } }, " ..
    GRAVITY },
  { "a table", ROUND, "effect.torque { body = { { {0, 0}, {0.03125, 8}, {0.046875, -8}, {0.5, 0} }, 0, 0 } }, " ..
    GRAVITY },
  { "two wheels", BRICK, "effect.wheel { axis = {1, 0, 0}, inertia = 0.5, speed = 2, torque = 0.5, included = true }" ..
    ", effect.wheel { axis = {0, 3, 4}, inertia = 0.25, speed = 3, included = true }", except = { midpoint = true } },
  { "thrown, with drag", BRICK, "effect.translation { gravity = {0, 0, -4}, drag = 0.5 }",
    except = { midpoint = true } },
  { "in a turning frame", BRICK, "effect.rotating_frame { rate = {0.25, 0, 0.5} }, effect.translation {}",
    except = { midpoint = true } },
}
local methods = { "rk4", "adaptive", "taylor", "semi", "midpoint" }
local conserving = { midpoint = true, semi = true }
local places = { qw = 0.5, qx = -0.5, qy = 0.5, qz = 0.5, wx = 0.75, wy = -0.625, wz = 1.125, rx = 0.5, ry = -1,
  rz = 0.25, vx = 0.25, vy = 0.75, vz = -0.5, wheel = 2, wheel_2 = 3, turn = 0.5 }

local head = [[
#include "NAME.h"
#include <stdio.h>
#define N UPPER_NX
#define H ((NAME_real)0.0625)
static const NAME_real u[] = {(NAME_real)0.25, (NAME_real)0.5, (NAME_real)0.75}, start[N] = {STATE};
]]

local exact = head .. [[
static void go(const NAME_model *m, int k, NAME_real d, int steps, NAME_real x[N]) {
  int i;
  for (i = 0; i < N; i++) x[i] = start[i];
  x[k] += d;
  for (i = 0; i < steps; i++) NAME_step(m, i*H, x, u, H);
}
int main(void) {
  NAME_model m;
  int steps, i, k, s, r;
  if (NAME_init(&m, 0)) return 1;
  for (steps = 1; steps <= STEPS; steps += STEPS - 1)
    for (k = 0; k < N; k++) {
      NAME_real D[3][N], hi[N], lo[N], d = start[k]/512;
      for (s = 0; s < 3; s++, d /= 2) {
        go(&m, k, d, steps, hi);
        go(&m, k, -d, steps, lo);
        for (i = 0; i < N; i++) D[s][i] = (hi[i] - lo[i])/(2*d);
      }
      for (r = 1, d = 4; r < 3; r++, d *= 4)
        for (s = 0; s + r < 3; s++)
          for (i = 0; i < N; i++) D[s][i] = (d*D[s + 1][i] - D[s][i])/(d - 1);
      for (i = 0; i < N; i++) printf("%.20Lg\n", D[0][i]);
    }
  return 0;
}
]]

local own = head .. [[
int main(void) {
  NAME_model m;
  NAME_real x[N], y[N], F[N*N], P[N*N], Q[N*N];
  int steps, i, k, j;
  if (NAME_init(&m, 0)) return 1;
  for (i = 0; i < N; i++) x[i] = y[i] = start[i];
  for (i = 0; i < N*N; i++) P[i] = i % (N + 1) == 0;
  for (steps = 0; steps < STEPS; steps++) {
    NAME_step_transition(&m, (NAME_real)steps*H, x, u, H, F);
    NAME_step(&m, (NAME_real)steps*H, y, u, H);
    for (i = 0; i < N; i++)
      for (k = 0; k < N; k++)
        for (j = 0, Q[i*N + k] = 0; j < N; j++) Q[i*N + k] += F[i*N + j]*P[j*N + k];
    for (i = 0; i < N*N; i++) P[i] = Q[i];
    if (steps == 0 || steps == STEPS - 1)
      for (k = 0; k < N; k++)
        for (i = 0; i < N; i++) printf("%.17g\n", (double)P[i*N + k]);
  }
  for (i = 0; i < N; i++) printf("%.17g\n", (double)(x[i] - y[i]));
KEEPS  return 0;
}
]]

local keeps = [[
  for (k = 1; k < N; k++) { /* v: along e[k] without what is along q; L at the end and at the start */
    NAME_real v[N] = {0}, g[2][3] = {{0}}, size = 1;
    const NAME_real *at[2];
    at[0] = start;
    at[1] = x;
    v[k] = 1;
    if (k < 4) for (i = 0; i < 4; i++) v[i] -= start[k]*start[i];
    for (j = 0; j < 2; j++) {
      for (i = 0; i < N; i++) {
        NAME_real z[N], hi[3], lo[3], by = v[i];
        int n;
        if (j == 1) for (n = 0, by = 0; n < N; n++) by += P[i*N + n]*v[n];
        for (n = 0; n < N; n++) z[n] = at[j][n];
        z[i] += 1;
        NAME_momentum(&m, z, hi);
        z[i] -= 2;
        NAME_momentum(&m, z, lo);
        for (n = 0; n < 3; n++) {
          g[j][n] += (hi[n] - lo[n])/2*by;
          if (g[j][n] > size) size = g[j][n];
          if (-g[j][n] > size) size = -g[j][n];
        }
      }
    }
    for (i = 3 - KEPT; i < 3; i++) printf("%.17g\n", (double)((g[1][i] - g[0][i])/size));
  }
]]

local long_functions = "#include <math.h>\n"
for _, fn in ipairs { "sqrt", "fabs", "sin", "cos", "exp", "log", "fma", "frexp", "ldexp" } do
  long_functions = long_functions .. "#define " .. fn .. " " .. fn .. "l\n"
end

local function numbers(path)
  local list = {}
  for word in string.gmatch(program.read(path) or "", "%S+") do list[#list + 1] = tonumber(word) end
  return list
end

local jobs, script = {}, {}
for i, row in ipairs(tier.every(8, rows, 2)) do
  for _, method in ipairs(methods) do
    for _, real in ipairs { "double", "float" } do
      if not (row.except and row.except[method]) and (real == "double" or row.float) then
        local name = string.format("s%d%s%s", i, method, string.sub(real, 1, 1))
        local job = assert(scene.read("return scene { name = \"" .. name .. "\", body = " .. row[2] ..
          ", effects = {" .. row[3] .. "}, origin = {0, 0, 0}, initial = { omega = {1, 2, 3} } }\n"))
        job = assert(scene.plan(job, { real = real, jacobians = true, methods = { method } }), method)
        local files = scene.files(job)
        local state = {}
        for k, s in ipairs(job.states) do state[k] = string.format("(NAME_real)%.17g", places[s.name]) end
        local kept = conserving[method] and row.keeps
        local function write(file, text)
          text = string.gsub(text, "KEEPS", function() return kept and keeps or "" end)
          text = string.gsub(text, "STATE", table.concat(state, ", "))
          text = string.gsub(string.gsub(text, "KEPT", tostring(kept or 0)), "STEPS", tostring(STEPS))
          text = string.gsub(text, "UPPER", string.upper(name))
          program.write(dir .. "/" .. file, (string.gsub(text, "NAME", name)))
        end
        write(name .. ".h", files[name .. ".h"])
        write(name .. ".c", files[name .. ".c"])
        write(name .. "_own.c", own)
        local line = "gcc -std=c99 -O0 -Wall -Wextra -Werror -ffp-contract=off -o own NAME.c NAME_own.c -lm && " ..
          "./own > NAME.own"
        if real == "double" then
          program.shell("mkdir -p " .. dir .. "/long")
          write("long/" .. name .. ".h", (string.gsub(files[name .. ".h"], "typedef double", "typedef long double")))
          write("long/" .. name .. ".c", (string.gsub(files[name .. ".c"], "#include <math.h>\n", long_functions)))
          write("long/" .. name .. "_exact.c", exact)
          line = line .. " && gcc -std=c99 -O0 -o exact -Ilong long/NAME.c long/NAME_exact.c -lm && " ..
            "./exact > NAME.exact"
        end
        script[#script + 1] = (string.gsub(line, "NAME", name))
        jobs[#jobs + 1] = { what = row[1] .. ", " .. method .. ", " .. real, name = name, n = #job.states,
          real = real, kept = kept }
      end
    end
  end
end
program.write(dir .. "/build.sh", "set -e\ncd " .. dir .. "\n" .. table.concat(script, "\n") .. "\n")
tap.is(program.shell("sh " .. dir .. "/build.sh 2>" .. dir .. "/log"), 0, "the emitted code compiles and runs",
  program.read(dir .. "/log"))

for _, j in ipairs(jobs) do
  local epsilon = j.real == "float" and 2.0 ^ -23 or 2.0 ^ -52
  local got = numbers(dir .. "/" .. j.name .. ".own")
  local want = numbers(dir .. "/" .. string.gsub(j.name, "f$", "d") .. ".exact")
  local n = j.n
  tap.is(#want, 2 * n * n, j.what .. ": differences of the step")
  for part, what in ipairs { "one step", STEPS .. " steps" } do
    local base, worst = (part - 1) * n * n, 0.0
    local all = 1.0
    for i = 1, n * n do all = math.max(all, math.abs(want[base + i] or 0)) end
    for i = 1, n do
      local most = 1.0 -- of the row
      for k = 1, n do most = math.max(most, math.abs(want[base + (k - 1) * n + i] or 0)) end
      if part == 2 then most = all * STEPS end
      for k = 1, n do
        local at = base + (k - 1) * n + i
        local d = math.abs((got[at] or math.huge) - (want[at] or 0)) / most
        worst = d <= worst and worst or d
      end
    end
    tap.ok(worst <= DEPTH * epsilon, string.format("%s: the transition of %s (%.2g of what rounding may do)", j.what,
      what, worst / (DEPTH * epsilon)))
  end
  local worst = 0.0
  for i = 1, n do worst = math.max(worst, math.abs(got[2 * n * n + i] or math.huge)) end
  tap.ok(worst <= STEPS * DEPTH * epsilon, j.what .. ": with its transition it is the same step",
    string.format("%.3g", worst))
  if j.kept then
    worst = 0.0
    for i = 2 * n * n + n + 1, #got do worst = math.max(worst, math.abs(got[i])) end
    tap.ok(#got == 2 * n * n + n + (n - 1) * j.kept and worst <= STEPS * DEPTH * epsilon,
      string.format("%s: what keeps L in space has a tangent that does (%.2g)", j.what, worst / epsilon))
  end
end

-- what has none is refused
do
  local text = "return scene { name = \"b\", body = " .. ROUND .. ",\n effects = { " .. GRAVITY .. " } }\n"
  for _, method in ipairs { "split2", "split4", "split6" } do
    local job = assert(scene.read(text))
    local planned, d = scene.plan(job, { jacobians = true, methods = { "rk4", method } })
    tap.ok(not planned and string.find(d:report(), "method " .. method .. ": its step has no transition matrix here", 1,
      true), method .. " is refused", d:report())
  end
end

program.finish()
tap.done()
