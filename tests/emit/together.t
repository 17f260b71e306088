#!/usr/bin/env lua5.4
-- together.t - all that --with adds in one file: no two parts share a name, and the self-test reads no foreign memory.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Other tests ask for one part at a time.  In one file (--layout single) the parts' own functions stand side by side,
-- and with all of them the self-test has all its parts, too, those for inputs among them: the sanitizers look on.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local STRICT = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off"
local SANITIZERS = "-fsanitize=address,undefined,float-divide-by-zero -fno-sanitize-recover=all"

-- body, real, methods, parts besides those that every scene with rates can have
local EVERY = "analysis,attitude,batch,jacobians,compensated,estimator"
for i, row in ipairs {
  { "gyroscope", "double", "rk4,adaptive,taylor,semi" }, { "heavy_top", "double", "exact,taylor", ",orbit" },
  { "gyrostat", "float", "exact,rk4", ",orbit" }, { "symmetric_top", "double", "exact,taylor", ",orbit" },
  { "brick_centroid", "float", "exact,rk4", ",orbit" },
} do
  local body, real, methods, more = table.unpack(row)
  local what = string.format("%s in %s, %s, with everything in one file: ", body, real, methods)
  local at = dir .. "/" .. body
  local status = program.shell(string.format(
    "%s gen bodies/%s.lua --layout single --real %s --method %s --with %s%s -o %s >%s/log 2>&1",
    binary, body, real, methods, EVERY, more or "", at, dir))
  tap.is(status, 0, what .. "it is emitted")
  if status ~= 0 then tap.diag(program.read(dir .. "/log")) end
  status = program.shell(string.format("cd %s && gcc %s -fsyntax-only %s.c >log 2>&1", at, STRICT, body))
  tap.ok(status == 0, what .. "no name is used twice, no warning", program.read(at .. "/log"))
  if i == 1 or not tier.quick then
    status = program.shell(string.format("cd %s && { gcc -std=c99 -O0 %s %s.c %s_test.c -lm -o test && ./test; } " ..
      ">log 2>&1", at, SANITIZERS, body, body))
    local log = program.read(at .. "/log") or ""
    tap.ok(status == 0 and log:find "\n1%.%.%d+" and not log:find "\nnot ok", what .. "the self-test under sanitizers",
      log:sub(-2000))
  end
end

program.finish()
tap.done()
