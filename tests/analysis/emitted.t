#!/usr/bin/env lua5.4
-- emitted.t - emitted self-tests under the sanitizers, with x/0 and conversions that overflow, in float and double.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/emit/compile.t has every closed form and every kind of state in double, with a walk along the edges of the
-- valid.  Here is what it does not have: closed forms in float, whose limits are nearer, the other steppers, and
-- effects.  No function is excepted: where the emitted code divides, it has looked at the divisor before.
-- The quick tier takes every fourth.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local SANITIZERS = "-fsanitize=address,undefined,float-divide-by-zero,float-cast-overflow -fno-sanitize-recover=all"
local DEFAULT = "exact,rk4"

-- body, real, methods; -O0: what is looked at are the operations of the source, and most of the time is gcc's
local all = {
  { "brick_centroid", "float", DEFAULT }, { "heavy_top", "float", DEFAULT }, { "damped_brick", "float", DEFAULT },
  { "heavy_top", "double", "midpoint,semi" }, { "gyrostat", "float", "split4,split2" },
  { "kapitza", "double", "adaptive" }, { "torsion_pendulum", "double", "taylor" },
  { "solar_sail", "float", "rk4" }, { "wheels", "double", "rk4,semi" }, { "skater", "float", "rk4" },
}

-- The status of the whole, and what the self-test printed.
local function run(i, body, real, methods)
  return program.shell(string.format("%s gen bodies/%s.lua --layout single --with analysis --real %s --method %s " ..
    "-o %s/%d >%s/log 2>&1 && " ..
    "cd %s/%d && { gcc -std=c99 -O0 -g %s %s.c %s_test.c -lm -o test && ./test; } >>%s/log 2>&1", binary, body, real,
    methods, dir,
    i, dir, dir, i, SANITIZERS, body, body, dir)), program.read(dir .. "/log")
end

for i, one in ipairs(tier.every(4, all)) do
  local body, real, methods = one[1], one[2], one[3]
  local code, log = run(i, body, real, methods)
  tap.ok(code == 0 and log:find "\n1%.%.%d+" and not log:find "runtime error",
    string.format("%s in %s, %s: the self-test passes and the sanitizers find nothing", body, real, methods),
    "status " .. code .. "\n" .. log:sub(-3000))
end

-- What would be found.
program.write(dir .. "/zero.c", "int main(int n, char **v) {\n  volatile float x = 1;\n  (void)v;\n" ..
  "  return x/(float)(n - 1) > 2;\n}\n")
program.write(dir .. "/far.c", "int main(int n, char **v) {\n  volatile double x = 1e30;\n  (void)v;\n" ..
  "  return (int)(x*n) == 3;\n}\n")
for _, name in ipairs { "zero", "far" } do
  local code = program.shell(string.format("cd %s && gcc -O0 %s %s.c -o %s && ./%s 2>err", dir, SANITIZERS, name, name,
    name))
  tap.ok(code ~= 0 and program.read(dir .. "/err"):find("runtime error", 1, true), name .. ": would be found")
end

program.finish()
tap.done()
