#!/usr/bin/env lua5.4
-- compensated.t - gen --with compensated: what the steps lose, what they refuse, and that they are the steps they
-- stand for.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- N steps of H by the emitted float or double code, and by the same text with the real type made long double (constants
-- stay what the type made of them).  A compensated step's error is that of its increments: rates of change are a sum
-- of at most DEPTH operations deep, half a unit u each, u = 2^-53 or 2^-24, so the whole run is off by at most
-- N H DEPTH u S, S the largest of all states and their rates (at the start; in so short a time they stay within a
-- tenth). The attitude is compared at |q| = 1, for what brings |q| back rounds it, and says so.  H is chosen such
-- that the bound is below a quarter of u S.  The plain step's error is that of N sums: if no component of it were 4
-- times the bound, the test could not tell the two apart, and fails.  Last, compensated and plain steps in long
-- double are the same method: they differ by N H times the roundings of constants, 4 to a rate, and by N sums in long
-- double, 2^-64 S each.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local driver = require "generator.driver"

local N, H, DEPTH = 4096, 2 ^ -21, 128
local dir = program.directory()

local BRICK = "tensor { mass = 1, xx = 2, yy = 3, zz = 4 }"
local LONG = "tensor { mass = 1, xx = 3, yy = 4, zz = 2, com = {0, 0, 0.5} }"
local FULL = "tensor { mass = 1, xx = 3, yy = 3.5, zz = 4, xy = 0.3, xz = -0.5, yz = 0.25, com = {0.1, 0, 0.5} }"
local GRAVITY = "effect.gravity { g = 8 }"
local rows = {
  { "a free brick", BRICK, "", float = true },
  { "a heavy top", LONG, GRAVITY, float = true },
  { "a full tensor, damped", FULL, GRAVITY .. ", effect.damping { c = {0.1, 0.2, 0.3} }", "adaptive" },
  { "a table, a wheel", BRICK, "effect.torque { body = { { {0, 0}, {0.03125, 8}, {0.5, 0} }, 0, 0 } }, " ..
    "effect.control {}, effect.wheel { axis = {0, 3, 4}, inertia = 0.25, speed = 3, torque = 0.5, included = true }",
      "taylor" },
  { "thrown, with drag, in a turning frame", BRICK,
    "effect.rotating_frame { rate = {0.25, 0, 0.5} }, effect.translation { gravity = {0, 0, -4}, drag = 0.5 }",
      "semi" },
}
local methods = { "rk4", "adaptive", "taylor", "semi" }

local text = [[
#include "NAME.h"
#include <stdio.h>
static const NAME_real u[] = {(NAME_real)0.25, (NAME_real)0.5, (NAME_real)0.75};
static const NAME_real start[] = {(NAME_real)0.53125, (NAME_real)-0.46875, (NAME_real)0.4375, (NAME_real)0.5546875,
  (NAME_real)0.75, (NAME_real)-0.625, (NAME_real)1.125, (NAME_real)0.25, (NAME_real)0.75, (NAME_real)-0.5,
  (NAME_real)0.5, (NAME_real)-1, (NAME_real)0.375, (NAME_real)0.75};
int main(void) {
  NAME_model m;
  NAME_real x[UPPER_NX], y[UPPER_NX], low[UPPER_NX], dx[UPPER_NX], h = (NAME_real)STEP;
  int i;
  if (NAME_init(&m, 0)) return 1;
  for (i = 0; i < UPPER_NX; i++) x[i] = y[i] = start[i];
  for (i = 0; i < UPPER_NX; i++) low[i] = 0;
  NAME_rhs(&m, 0, x, u, dx);
  for (i = 0; i < COUNT; i++) NAME_step(&m, (NAME_real)i*h, y, u, h);
  for (i = 0; i < COUNT; i++) NAME_step_compensated(&m, (NAME_real)i*h, x, u, h, low);
  for (i = 0; i < UPPER_NX; i++)
    printf("%.21Lg %.21Lg %.21Lg %.21Lg\n", (long double)y[i], (long double)x[i], (long double)low[i],
      (long double)dx[i]);
  return 0;
}
]]

local long_functions = "#include <math.h>\n"
for _, fn in ipairs { "sqrt", "fabs", "sin", "cos", "exp", "log", "floor", "frexp", "ldexp" } do
  long_functions = long_functions .. string.format("#define %s %sl\n#define %sf %sl\n", fn, fn, fn, fn)
end

-- What is compared is formed in C, by long double: |q| = 1, differences; here only their sizes.
local judge = [[
#include <math.h>
#include <stdio.h>
static int read(const char *name, int n, long double v[4][32]) {
  FILE *f = fopen(name, "r");
  int i, ok = f != 0;
  for (i = 0; ok && i < n; i++) ok = fscanf(f, "%Lf %Lf %Lf %Lf", &v[0][i], &v[1][i], &v[2][i], &v[3][i]) == 4;
  if (f) fclose(f);
  return ok;
}
static void unit(long double q[]) {
  long double s = sqrtl(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
  int i;
  for (i = 0; i < 4; i++) q[i] /= s;
}
int main(int argc, char **argv) {
  long double a[4][32], b[4][32], plain = 0, sum = 0, same = 0, size = 0;
  int i, n = 0;
  if (argc != 4 || sscanf(argv[3], "%d", &n) != 1 || !read(argv[1], n, a) || !read(argv[2], n, b)) return 1;
  for (i = 0; i < n; i++) {
    a[1][i] += a[2][i];
    b[1][i] += b[2][i];
    size = fmaxl(size, fmaxl(fabsl(b[0][i]), fabsl(b[3][i])));
  }
  unit(a[0]); unit(a[1]); unit(b[0]); unit(b[1]);
  for (i = 0; i < n; i++) {
    plain = fmaxl(plain, fabsl(a[0][i] - b[0][i]));
    sum = fmaxl(sum, fabsl(a[1][i] - b[1][i]));
    same = fmaxl(same, fabsl(b[0][i] - b[1][i]));
  }
  printf("%.6Lg %.6Lg %.6Lg %.6Lg\n", plain, sum, same, size);
  return 0;
}
]]

program.shell("mkdir -p " .. dir .. "/long")
program.write(dir .. "/judge.c", judge)
local script, jobs = { "gcc -O1 -o judge judge.c -lm" }, {}
for i, row in ipairs(tier.every(5, rows)) do
  for _, method in ipairs(methods) do
    for _, real in ipairs { "double", "float" } do
      if real == "double" and (not row[4] or method == row[4] or method == "rk4") or row.float then
        local name = string.format("s%d%s%s", i, method, string.sub(real, 1, 1))
        local job = assert(scene.read('return scene { name = "' .. name .. '", body = ' .. row[2] .. ", effects = {" ..
          row[3] .. "}, origin = {0, 0, 0}, initial = { omega = {1, 2, 3} } }\n"))
        job = assert(driver.plan(job, { real = real, compensated = true, methods = { method }, order = 8,
          libm = "system", command = "" }))
        local files = scene.files(job)
        local function write(file, s)
          s = string.gsub(string.gsub(s, "COUNT", tostring(N)), "STEP", string.format("%.17g", H))
          program.write(dir .. "/" .. file, (string.gsub(string.gsub(s, "UPPER", string.upper(name)), "NAME", name)))
        end
        for _, ending in ipairs { ".h", ".c" } do
          program.write(dir .. "/" .. name .. ending, files[name .. ending])
          local long = string.gsub(files[name .. ending], "typedef " .. real, "typedef long double")
          program.write(dir .. "/long/" .. name .. ending, (string.gsub(long, "#include <math.h>\n", long_functions)))
        end
        write(name .. "_own.c", text)
        write("long/" .. name .. "_own.c", text)
        -- what the emitted code promises of warnings, and of C++, in one scene each
        local strict = i == 2 and (method == "rk4" or method == "taylor") and
          "for cc in 'gcc -std=c99' 'clang -std=c99' 'g++ -x c++'; do $cc -pedantic -Wall -Wextra " ..
          "-Wconversion -Wdouble-promotion -Wshadow -Werror -c -o any.o NAME.c || exit 1; done; " or ""
        script[#script + 1] = (string.gsub(strict .. "gcc -std=c99 -O0 -Wall -Wextra -Werror -ffp-contract=off " ..
          "-o own NAME.c NAME_own.c -lm && ./own > NAME.own && gcc -std=c99 -O0 -o exact -Ilong long/NAME.c " ..
          "long/NAME_own.c -lm && " ..
          "./exact > NAME.exact && ./judge NAME.own NAME.exact " .. #job.states .. " > NAME.result", "NAME", name))
        jobs[#jobs + 1] = { what = row[1] .. ", " .. method .. ", " .. real, name = name, u = 2 ^ (real == "float" and
          -24 or -53) }
      end
    end
  end
end
for _, line in ipairs(script) do
  program.write(dir .. "/line", "cd " .. dir .. "\n" .. line .. "\n")
  local code = program.shell(string.format("sh -e %s/line > %s/log 2>&1", dir, dir))
  if code ~= 0 then tap.ok(false, "compiles and runs", line .. "\n" .. (program.read(dir .. "/log") or "")) end
end
for _, j in ipairs(jobs) do
  local v = {}
  for word in string.gmatch(program.read(dir .. "/" .. j.name .. ".result") or "", "%S+") do v[#v + 1] =
    tonumber(word) end
  local plain, sum, same, size = v[1] or 1, v[2] or 1, v[3] or 1, v[4] or 0
  local bound = N * H * DEPTH * j.u * size
  tap.ok(sum <= bound, j.what .. ": the increments' roundings and no others",
    string.format("%.2g, bound %.2g", sum, bound))
  tap.ok(plain >= 4 * bound, j.what .. ": the plain step loses more", string.format("%.2g, bound %.2g", plain, bound))
  tap.ok(same <= N * (H * 4 * j.u + 2 ^ -64) * size, j.what .. ": the same method", string.format("%.2g", same))
end

-- ---- what is refused ----

local path = dir .. "/brick.lua"
local function brick(more)
  program.write(path, 'return scene { name = "brick", body = ' .. BRICK .. more ..
    ", initial = { omega = {1, 2, 3} } }\n")
end
brick ""
local binary = os.getenv "POLHODE" or "build/polhode"
local function gen(options)
  program.shell(string.format("rm -rf %s/out", dir))
  return program.shell(string.format("POLHODE_SOURCE=. timeout 90 " ..
    "%s gen %s --with compensated %s -o %s/out >%s/log 2>&1",
    binary, path, options, dir, dir)), program.read(dir .. "/log")
end
for _, method in ipairs { "split4", "midpoint" } do
  local code, err = gen("--method rk4," .. method)
  tap.ok(code == 1 and string.find(err, "method " .. method .. ": ", 1, true) and
    string.find(err, "rk4, adaptive, taylor and semi", 1, true), method ..
    " has no increments, and the message says what has", err)
  tap.is(program.read(dir .. "/out/brick.c"), nil, "nothing is written then")
end

-- ---- the whole chain: the emitted self-test, and what fast arithmetic does ----

for _, options in ipairs(tier.every(3, { "--method rk4,semi", "--real float --method semi,rk4",
  "--method taylor --order 4 --bake" })) do
  local code, err = gen(options)
  tap.ok(code == 0, "gen --with compensated " .. options, err)
  code = program.shell(string.format("make -s -C %s/out CFLAGS='-O0 -ffp-contract=off' check > %s/log 2>&1", dir, dir))
  local log = program.read(dir .. "/log") or ""
  tap.ok(code == 0 and string.find(log, "\nok %d+ %- brick: compensated sums of steps too short"),
    "the emitted self-test passes, its lines on compensated sums among them", log)
end
local readme = program.read(dir .. "/out/README.md") or ""
tap.ok(string.find(readme, "| step_compensated |", 1, true) ~= nil, "the cost sheet has the step")
for _, flag in ipairs { "-ffast-math", "-fassociative-math -fno-signed-zeros -fno-trapping-math" } do
  local code = program.shell(string.format("gcc -O2 %s -c -o %s/any.o %s/out/brick.c > %s/log 2>&1", flag, dir, dir,
    dir))
  tap.ok(code ~= 0 and string.find(program.read(dir .. "/log"), "compensated sums vanish", 1, true),
    "gcc " .. flag .. " is refused", program.read(dir .. "/log"))
end

-- moving parts are asked where a step ends: steps too short to be seen must add up in the clock as well
program.write(path, [[
return scene { name = "brick", body = tensor { mass = 3, xx = 1.9, yy = 1.7, zz = 1.2, xy = -0.1, xz = 0.2, yz = 0.05 },
  effects = { effect.inertia_rate { zz = 0.3*cos(t), xx = 0.3*sin(t)^2 } }, initial = { omega = {1, 2, 3} } }]])
for _, real in ipairs { "float", "double" } do
  local code, err = gen("--method semi --real " .. real)
  tap.ok(code == 0, "gen --with compensated, semi with moving parts, " .. real, err)
  code = program.shell(string.format("make -s -C %s/out CFLAGS='-O0 -ffp-contract=off' check > %s/log 2>&1", dir, dir))
  tap.is(code, 0, "its self-test passes: what the parts do in steps too short to be seen is not lost, " .. real)
end

program.finish()
tap.done()
