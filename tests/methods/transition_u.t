#!/usr/bin/env lua5.4
-- transition_u.t - NAME_step_transition_u of every stepper that has one, against differences of the step it belongs to.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- As in transition.t: one program in double or float prints G = dx(t + h)/du; one with the real type made long double
-- knows the step only and forms central differences by d, d/2, d/4 of each input, extrapolated twice.  The values of
-- the inputs are at least 8 d away from a limit, or beyond it by as much, so that no difference meets the corner.
-- Tolerance: 256 operations deep, half a unit each, of the largest number in the row or 1, as there.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"

local DEPTH = 128
local dir = program.directory()

-- Named inputs: `a` within its limits, `b` beyond them (its column is zero), `c` without any.
local INPUTS = [[local a, b = input("a", "N m", { min = -1, max = 2 }), input("b", "N m", { min = -1, max = 0.5 })
local c = input("c", "N m")
]]
local THRUST = [[local a, b = input("a", "N", { min = -1, max = 2 }), input("b", "N m", { min = -1, max = 0.5 })
local c = input("c", "N")
]]
local BRICK = "tensor { mass = 1, xx = 2, yy = 3, zz = 4 }"
local ROUND = "tensor { mass = 1, xx = 3, yy = 3, zz = 2, com = {0, 0, 0.5} }"
local FULL = "tensor { mass = 1, xx = 3, yy = 3.5, zz = 4, xy = 0.3, xz = -0.5, yz = 0.25, com = {0.1, 0, 0.5} }"

local rows = {
  { "a brick, controlled and braked", INPUTS, BRICK, "effect.control { max = 2 }, " ..
    "effect.torque { body = {a, 0, b} }, effect.friction { torque = c, smoothing = 0.5 }", beyond = 5, float = true },
  { "a heavy symmetric top, driven about its axis", INPUTS, ROUND,
    "effect.gravity { g = 8 }, effect.torque { body = {b, 0, a + 2*c} }", beyond = 2 },
  { "a full tensor, a table and a push in inertial axes", INPUTS, FULL,
    "effect.gravity { g = 8 }, effect.torque { inertial = {a, sin(t)*c, b} }, " ..
    "effect.torque { body = { { {0, 0}, {0.03125, 8}, {0.5, 0} }, 0, 0 } }", beyond = 2 },
  { "wheels", INPUTS, BRICK, "effect.wheel { axis = {1, 0, 0}, inertia = 0.5, speed = 2, torque = a, " ..
    "included = true }, effect.wheel { axis = {0, 3, 4}, inertia = 0.25, speed = 3, torque = b + c, " ..
    "included = false }", beyond = 2, except = { midpoint = true } },
  { "a rocket", THRUST, BRICK, "effect.translation { drag = 0.5, thrust = {c, 0, a} }, " ..
    "effect.torque { body = {0, b, 0} }", beyond = 2, except = { midpoint = true } },
}
local methods = { "rk4", "adaptive", "taylor", "semi", "midpoint" }
local places = { qw = 0.5, qx = -0.5, qy = 0.5, qz = 0.5, wx = 0.75, wy = -0.625, wz = 1.125, rx = 0.5, ry = -1,
  rz = 0.25, vx = 0.25, vy = 0.75, vz = -0.5, wheel = 2, wheel_2 = 3 }
local values = { ux = 0.5, uy = -0.75, uz = 1, u_a = 0.75, u_b = 0.875, u_c = 1.25 }

local head = [[
#include "NAME.h"
#include <stdio.h>
#define N UPPER_NX
#define M UPPER_NU
#define H ((NAME_real)0.0625)
static const NAME_real u[M] = {INPUT}, start[N] = {STATE};
]]

local exact = head .. [[
int main(void) {
  NAME_model m;
  int i, k, s, r;
  if (NAME_init(&m, 0)) return 1;
  for (k = 0; k < M; k++) {
    NAME_real D[3][N], x[2][N], v[2][M], d = (NAME_real)1/64;
    for (s = 0; s < 3; s++, d /= 2) {
      for (r = 0; r < 2; r++) {
        for (i = 0; i < N; i++) x[r][i] = start[i];
        for (i = 0; i < M; i++) v[r][i] = u[i];
        v[r][k] += r ? -d : d;
        NAME_step(&m, 0, x[r], v[r], H);
      }
      for (i = 0; i < N; i++) D[s][i] = (x[0][i] - x[1][i])/(2*d);
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
  NAME_real G[N*M];
  int i, k;
  if (NAME_init(&m, 0)) return 1;
  NAME_step_transition_u(&m, 0, start, u, H, G);
  for (k = 0; k < M; k++)
    for (i = 0; i < N; i++) printf("%.17g\n", (double)G[i*M + k]);
  return 0;
}
]]

local long_functions = "#include <math.h>\n"
for _, fn in ipairs { "sqrt", "fabs", "sin", "cos", "exp", "log", "fma", "frexp", "ldexp", "copysign" } do
  long_functions = long_functions .. "#define " .. fn .. " " .. fn .. "l\n"
end

local function numbers(path)
  local list = {}
  for word in string.gmatch(program.read(path) or "", "%S+") do list[#list + 1] = tonumber(word) end
  return list
end

local jobs, script = {}, {}
for i, row in ipairs(rows) do
  for _, method in ipairs(methods) do
    for _, real in ipairs { "double", "float" } do
      if not (row.except and row.except[method]) and (real == "double" or row.float) then
        local name = string.format("s%d%s%s", i, method, string.sub(real, 1, 1))
        local job = assert(scene.read(row[2] .. "return scene { name = \"" .. name .. "\", body = " .. row[3] ..
          ", effects = {" .. row[4] .. "}, origin = {0, 0, 0}, initial = { omega = {1, 2, 3} } }\n"))
        job = assert(scene.plan(job, { real = real, jacobians = true, methods = { method } }), method)
        local files, state, held = scene.files(job), {}, {}
        for k, s in ipairs(job.states) do state[k] = string.format("(NAME_real)%.17g", places[s.name]) end
        for k, s in ipairs(job.model.inputs) do held[k] = string.format("(NAME_real)%.17g", values[s.name]) end
        local function write(file, text)
          text = string.gsub(string.gsub(text, "STATE", table.concat(state, ", ")), "INPUT", table.concat(held, ", "))
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
          inputs = #job.model.inputs, real = real, beyond = row.beyond }
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
  local n, worst, moved = j.n, 0.0, 0.0
  tap.is(#got, n * j.inputs, j.what .. ": a matrix of NX by NU")
  for i = 1, n do
    local most = 1.0
    for k = 1, j.inputs do most = math.max(most, math.abs(want[(k - 1) * n + i] or 0)) end
    for k = 1, j.inputs do
      local at = (k - 1) * n + i
      local d = math.abs((got[at] or math.huge) - (want[at] or 0)) / most
      worst = d <= worst and worst or d
      if k ~= j.beyond then moved = math.max(moved, math.abs(got[at] or 0)) end
    end
  end
  tap.ok(worst <= DEPTH * epsilon, string.format("%s: the derivative (%.2g of what rounding may do)", j.what,
    worst / (DEPTH * epsilon)))
  tap.ok(moved > 0.001, j.what .. ": the inputs within their limits move the state", moved)
  local still = true
  for i = 1, n do still = still and got[(j.beyond - 1) * n + i] == 0 end
  tap.ok(still, j.what .. ": one beyond its limits does not")
end

program.finish()
tap.done()
