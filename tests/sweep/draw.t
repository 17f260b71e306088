#!/usr/bin/env lua5.4
-- draw.t - random numbers by counter, normal deviates, Sobol's points, permutations, exact sums of a sweep's program.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The C of an emitted program is compiled with tests/sweep/draw.c, which has the oracles; both compilers, and with
-- instructions that could contract: the bits of what they draw must be the same.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function output(format, ...)
  local pipe = assert(io.popen("{ " .. string.format(format, ...) .. "; } 2>&1"))
  local text = pipe:read "a"
  return pipe:close(), text
end

local emitted, said = output("POLHODE_SOURCE=. %s sweep tumbling_box --over wx=1:2:3 --emit %s/p", binary, dir)
tap.ok(emitted, "the program of a sweep is emitted")
if not emitted then tap.diag(said) end

local SOURCES = { "draw", "sobol", "math", "exact" }
local function build(compiler, flags, name)
  local list = {}
  for i, s in ipairs(SOURCES) do list[i] = dir .. "/p/sweep_" .. s .. ".c" end
  return output("%s -std=c11 -D_GNU_SOURCE %s -ffp-contract=off -Itests -I%s/p -o %s/%s tests/sweep/draw.c %s " ..
    "-lmpfr -lgmp -lm", compiler, flags, dir, dir, name, table.concat(list, " "))
end

local built, why = build("gcc", "-O2 -march=native -fno-math-errno -fno-tree-slp-vectorize", "gcc")
tap.ok(built, "it compiles with the oracles")
if not built then tap.diag(why) end
local _, text = output("%s/gcc %d", dir, tier.quick and 20000 or 400000)
for line in text:gmatch "[^\n]+" do
  local good, name = line:match "^ok %d+ %- (.*)", line:match "^not ok %d+ %- (.*)"
  if good then tap.ok(true, good) elseif name then tap.ok(false, name) elseif line:match "^#" then print(line) end
end
tap.ok(text:find "\n1%.%.%d+" ~= nil, "and runs to its end")

-- Strict and quiet: what emitted code promises.
local STRICT = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off"
for _, compiler in ipairs { "gcc", "clang" } do
  local quiet = true
  for path in io.popen("ls " .. dir .. "/p/*.c"):lines() do
    local fine, message = output("%s -O2 -fno-math-errno %s -c -o /dev/null %s", compiler, STRICT, path)
    quiet = quiet and fine
    if not fine then tap.diag(message) end
  end
  tap.ok(quiet, "the program compiles without a warning by " .. compiler)
end

program.finish()
tap.done()
