#!/usr/bin/env lua5.4
-- calls.t - the program that calls every function of a scene for counting: none is forgotten, and it compiles and runs.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What the counts are worth is tests/target/sheet.t's.  Here the marks count on the host: each is called, twice.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local driver = require "generator.driver"
local calls = require "generator.emit.calls"

-- A program that only says how often it came to end(); the status is main's.
local MARKS = [[
#include <stdio.h>
static int ends;
void begin(void); void end(void);
void begin(void) {}
void end(void) { ends++; }
static int finish(int status) { return printf("%d\n", ends), status; }
#define FINISH(status) finish(status)
]]

local SCENES = { -- between them every kind of argument
  { "brick_centroid", { methods = { "rk4", "taylor", "adaptive", "exact" }, jacobians = true, order = 4 } },
  { "wheels", { jacobians = true, estimator = true } },
  { "dropped_stone", { methods = { "rk4", "exact" }, real = "float" } },
  { "heavy_top", { methods = { "split4", "semi", "exact" }, real = "float" } },
}

local dir = program.directory()
for _, case in ipairs(SCENES) do
  local name, options = case[1], case[2]
  local job = scene.plan(scene.file("bodies/" .. name .. ".lua"), options)
  job.templates["templates/target/calls.c"] = program.read "templates/target/calls.c"
  local code = driver.code(job).code
  local plan = calls.of(job, { { header = code.header, source = code.source } })
  local listed, idle = {}, {}
  for _, f in ipairs(plan.list) do
    listed[f.symbol] = true
    if f.why then idle[#idle + 1] = f.name .. ": " .. f.why end
  end
  tap.is(table.concat(idle, ", "), "", name .. ": no argument is of an unknown kind")
  for file, text in pairs { [".h"] = code.header, [".c"] = code.source } do
    program.write(dir .. "/" .. name .. file, text)
  end
  program.write(dir .. "/calls.c", plan.program)
  program.write(dir .. "/marks.h", MARKS)
  local options_of_cc = "-std=c99 -O0 -w -ffunction-sections -Werror=implicit -Werror=incompatible-pointer-types"
  tap.is(program.shell(string.format("cd %s && cc %s -c %s.c -o x.o && cc %s x.o calls.c -lm -o calls", dir,
    options_of_cc, name, options_of_cc)),
    0, name .. ": the program compiles")
  local forgotten = {}
  local pipe = io.popen(string.format("cd %s && nm -g --defined-only x.o", dir))
  for symbol in string.gmatch(pipe:read "a", " T ([%w_]+)") do
    if not listed[symbol] then forgotten[#forgotten + 1] = symbol end
  end
  pipe:close()
  tap.is(table.concat(forgotten, " "), "", name .. ": every function of the object is called")
  tap.is(program.shell(string.format("cd %s && timeout 60 ./calls > calls.out", dir)), 0,
    name .. ": the initial state is accepted")
  tap.is(tonumber(program.read(dir .. "/calls.out")), 2 * (#plan.list + 1), name .. ": all are called twice")
end

program.finish()
tap.done()
