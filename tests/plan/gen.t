#!/usr/bin/env lua5.4
-- gen.t - `polhode gen` with an accuracy: files, header, self-test, cache, refusals.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The emitted self-test is compiled and run: it holds the planned method against the general library's state at the
-- horizon.  Bytes: planned twice, from the cache and with broken caches they must be the same.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local root = assert(io.popen("pwd")):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local cc = os.getenv "CC" or "cc"
local flags = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off -O1"

-- Status and standard error of `polhode ARGS`; cache: the value of XDG_CACHE_HOME.
local function run(args, cache)
  local status = program.shell(string.format("cd %s && XDG_CACHE_HOME=%s HOME= timeout 120 %s %s >stdout 2>stderr", dir,
    cache or dir .. "/none/such", binary, args))
  return status, program.read(dir .. "/stderr")
end

local function files(name)
  local out = {}
  for _, f in ipairs { name .. ".h", name .. ".c", name .. "_test.c", "Makefile", "README.md" } do
    out[#out + 1] = program.read(dir .. "/out/" .. f)
  end
  return table.concat(out)
end

program.write(dir .. "/ball.lua", [[
return scene { name = "ball", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 3 },
  effects = { effect.drag { c = 0.001 } }, initial = { omega = {1, 2, 3} }, time = { horizon = 4 },
  accuracy = 1e-6, ranges = { omega = {1, 3}, attitude = 0.5 } }
]])

-- ---- what is emitted ----

local status, err = run("gen ball.lua -o out")
tap.ok(status == 0 and err == "", "a scene with an accuracy is emitted, nothing said where no terminal is", err)
local header = program.read(dir .. "/out/ball.h") or ""
local banner = header:match "^/%*(.-)%*/" or ""
banner = banner:gsub("\n %* *", " "):gsub("%s+", " ")
for _, part in ipairs { "Planned for an accuracy of 1e%-6 over 4 s: %w+", "by ball_advance", "Measured: largest error",
  "from %d+ states: wx from 1 to 3, wy from 1 to 3, wz from 1 to 3, attitude within 0%.5 rad of the scene's",
  "Cost: [%d.]+ steps? .-of %d+ operations %(", "by the table for x86%-64 [%d.e]+ cycles", "At other costs: " } do
  tap.like(banner, part, "the header says: " .. part, true)
end
local planned = header:match "\n#define BALL_PLANNED_(%w+) %("
tap.ok(planned == "STEP" or planned == "TOLERANCE", "and has the planned step or tolerance as a constant")
tap.like(header:gsub("%s+", " "),
  "int ball_advance(const ball_model *m, ball_real t0, ball_real x[], const ball_real u[], ball_real t1);",
  "and the function")
local steppers = 0
for _ in header:gmatch "\nvoid ball_step%(" do steppers = steppers + 1 end
tap.is(steppers, 1, "one stepper, not several")

local function self_test(name, more)
  return program.shell(string.format("cd %s/out && %s %s %s %s*.c -o test -lm 2>log && ./test >result 2>&1",
    dir, cc, flags, more or "", name)), program.read(dir .. "/out/result") or "", program.read(dir .. "/out/log")
end
local code, result, log = self_test "ball"
tap.ok(code == 0 and log == "", "compiles without a warning, and passes its own test", (log or "") .. result)
tap.like(result, "the planned method reaches the horizon within its accuracy", "which runs the planned method")

-- NAME_advance itself: back where it came from, halves, nothing for no time, refusals
program.write(dir .. "/out/use.c", [[
#include "ball.h"
#include <math.h>
#include <stdio.h>
int main(void)
{
  ball_model m;
  ball_real x0[BALL_NX], x[BALL_NX], y[BALL_NX], worst = 0;
  int i, n, half;
  ball_init(&m, 0);
  ball_initial(&m, x0);
  for (i = 0; i < BALL_NX; i++) x[i] = y[i] = x0[i];
  n = ball_advance(&m, 0, x, 0, 4);
  half = ball_advance(&m, 0, y, 0, 2);
  i = ball_advance(&m, 2, y, 0, 4);
  printf("%d %d %d", n, half, i);
  for (i = 0; i < BALL_NX; i++) worst = fabs(x[i] - y[i]) > worst ? fabs(x[i] - y[i]) : worst;
  ball_advance(&m, 4, x, 0, 0);
  printf(" %.3g", (double)worst);
  for (worst = 0, i = 0; i < BALL_NX; i++) worst = fabs(x[i] - x0[i]) > worst ? fabs(x[i] - x0[i]) : worst;
  printf(" %.3g %d %d", (double)worst, ball_advance(&m, 1, x, 0, 1), ball_advance(&m, 0, x, 0, (ball_real)NAN));
  x[BALL_WX] = (ball_real)INFINITY;
  printf(" %d\n", ball_advance(&m, 0, x, 0, 1));
  return 0;
}
]])
code = program.shell("cd " .. dir .. "/out && " .. cc .. " -O1 ball.c use.c -o use -lm && ./use > used")
local used = {}
for w in (program.read(dir .. "/out/used") or ""):gmatch "%S+" do used[#used + 1] = tonumber(w) end
tap.ok(code == 0 and used[1] and used[1] > 0 and used[2] > 0 and used[3] > 0, "whole and halves take steps")
-- each is within 1e-6 of the truth (of rates up to 5); back again, too
tap.ok(used[4] and used[4] <= 2 * 5e-6 and used[5] <= 2 * 5e-6, "the halves meet the whole, and the way back the start",
  table.concat(used, " "))
tap.ok(used[6] == 0 and used[7] == -1 and used[8] == -1, "no time: 0; a time or state that is no number: -1",
  table.concat(used, " "))

-- ---- the same bytes, cached or not ----

local cache = dir .. "/cache"
local first = files "ball"
program.shell("mkdir " .. cache)
status = run("gen ball.lua -o out", cache)
tap.ok(status == 0 and files "ball" == first, "planned again: the same bytes")
local list = io.popen("ls -a " .. cache .. "/polhode")
local kept = {}
for name in list:lines() do
  if name ~= "." and name ~= ".." then kept[#kept + 1] = name end
end
list:close()
tap.ok(#kept == 1 and kept[1]:find "^%x+$" and #kept[1] == 32, "one file is kept, and no temporary one",
  table.concat(kept, " "))
local path = cache .. "/polhode/" .. kept[1]
local text = program.read(path)
program.write(path, (text:gsub("title [^\n]*", "title from the cache")))
run("gen ball.lua -o out", cache)
tap.like(files "ball", "from the cache", "the next time it is read")
for what, bad in pairs { ["empty"] = "", ["cut"] = text:sub(1, -20), ["garbage"] = "\0\255{}\n" } do -- in any order
  program.write(path, bad)
  status, err = run("gen ball.lua -o out", cache)
  tap.ok(status == 0 and err == "" and files "ball" == first and program.read(path) == text,
    "a file that is " .. what .. " is made anew")
end
program.shell("rm " .. path .. " && mkdir " .. path)
status, err = run("gen ball.lua -o out", cache)
tap.ok(status == 0 and err == "" and files "ball" == first, "a folder in its place does no harm")
status, err = run("gen ball.lua -o out", "relative")
tap.ok(status == 0 and err == "" and files "ball" == first and program.shell("test -e " .. dir .. "/relative") ~= 0,
  "a relative XDG_CACHE_HOME counts as none")

-- ---- a closed form; float; the command line ----

program.write(dir .. "/top.lua", [[return scene { name = "top",
  body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 3 },
  initial = { omega = {1, 2, 3} }, time = { horizon = 20 } }
]])
status, err = run("gen top.lua --accuracy 1e-9 -o out", cache)
header = program.read(dir .. "/out/top.h") or ""
tap.ok(status == 0 and header:find("Planned for an accuracy of 1e-9 over 20 s: the closed form, by top_advance", 1,
  true) and not header:find("#define TOP_PLANNED", 1, true), "many digits of a free body: its closed form", err)
tap.like(header, "polhode gen top.lua --accuracy 1e-9\n", "the header repeats the command")
code, result, log = self_test "top"
tap.ok(code == 0, "which passes its test", (log or "") .. result)
status, err = run("gen top.lua --accuracy 1e-3 --real float --method rk4,adaptive -o out", cache)
header = program.read(dir .. "/out/top.h") or ""
tap.ok(status == 0 and header:find "over 20 s:[ \n*]+rk4" or header:find "over 20 s:[ \n*]+adaptive",
  "--method names those that compete", err)
tap.like(header, "typedef float", "--real as ever")
code, result, log = self_test "top"
tap.ok(code == 0, "and the test passes in float", (log or "") .. result)

-- ---- refusals ----

local function refused(args, part, name, want)
  program.shell("rm -rf " .. dir .. "/out")
  status, err = run(args, cache)
  tap.ok(status == (want or 1) and err:find(part, 1, true) and program.shell("test -e " .. dir .. "/out") ~= 0,
    name, err)
end
refused("gen top.lua --accuracy 2 -o out", "polhode gen: --accuracy must be between 0 and 1, got 2",
  "no accuracy at all", 2)
refused("gen top.lua --accuracy 1e-9 --real float -o out", "what limits it is the rounding of float, got 1e-9",
  "float cannot hold 1e-9, and the best that can be is told")
refused("gen top.lua --accuracy 1e-18 -o out", "top.lua:1: accuracy: ", "nor double 1e-18; the scene's line is blamed")
program.write(dir .. "/ctl.lua", [[return scene { name = "ctl",
  body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 3 },
  effects = { effect.control {} }, accuracy = 1e-3 }
]])
refused("gen ctl.lua -o out", "accuracy: needs the limits of all inputs: effect.control{ max = }, " ..
  "input(name, unit, { min =, max = }), got 0.001",
  "an input of any size cannot be planned for")
program.write(dir .. "/top.lua", (program.read(dir .. "/top.lua"):gsub("time =",
  "accuracy = 1e-3,\n  budget = { ops = 20 }, time =")))
refused("gen top.lua -o out", "budget.ops leaves no method: the least, ", "no step has 20 operations")

program.finish()
tap.done()
