#!/usr/bin/env lua5.4
-- replay.t - the corpora and the regressions of the fuzz targets are quiet, and planted defects are not.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The same targets as `make fuzz`, built by the compiler that is there and with replay.c instead of libFuzzer.  Under
-- `make sanitize` the objects they are linked with are sanitized ones.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local build = binary:match "^(.*)/[^/]*$" or "."
if build:sub(1, 1) ~= "/" then build = assert(io.popen "pwd"):read "l" .. "/" .. build end

local TARGETS = { "scene", "table", "command", "robot", "mesh_stl", "mesh_obj", "mesh_ply", "init" }

-- As libFuzzer runs them: in the folder of the files that scenes may name.
local function run(target, files, environment)
  return program.shell(string.format("cd tests/fuzz/files && %s FUZZ_DIR=.. timeout 300 %s/fuzz/replay/%s %s " ..
    ">%s/stdout 2>%s/stderr", environment or "", build, target, files, dir, dir))
end

local function said() return (program.read(dir .. "/stderr"):sub(1, 2000)) end

-- The file that was being fed: the last that was named.
local function last() return program.read(dir .. "/stdout"):match "([^\n]*)\n$" or "nothing was fed" end

local sanitized = os.getenv "POLHODE_SANITIZED"
local status = program.shell(string.format("env -u MAKEFLAGS -u MAKELEVEL make fuzz-replay BUILD=%s CFLAGS='%s' " ..
  ">%s/stdout 2>&1", build, sanitized and "-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all" or "-O0",
  dir))
if not tap.ok(status == 0, "the targets are built", program.read(dir .. "/stdout")) then
  tap.done(program.finish())
end

for _, target in ipairs(TARGETS) do
  local count = tonumber(assert(io.popen("ls tests/fuzz/corpus/" .. target .. " | wc -l")):read "n")
  tap.ok(count >= 10, target .. ": its corpus has " .. count .. " files")
  local ended = run(target, string.format("$(find ../corpus/%s ../regressions/%s -type f | sort)", target, target))
  tap.ok(ended == 0, target .. ": corpus and regressions are quiet", last(), said())
end

-- Controls: each kind of finding, planted.  abort() is 128 + 6 to a shell.
program.write(dir .. "/planted.lua", "-- planted\n" .. program.read "bodies/coin.lua")
for _, c in ipairs {
  { "scene", dir .. "/planted.lua", "error", "a planted defect", "an error nobody caught" },
  { "scene", dir .. "/planted.lua", "status", "status 4", "an exit status that no command has" },
  { "mesh_stl", "../files/t.stl", "nan", "a mass of", "a mass that is no number" },
  { "mesh_stl", "../files/t.stl", "open", "a volume of an open surface", "a volume of an open surface" },
  { "init", "../corpus/init/own*", "nan", "the model is not finite", "a number that is none in a model" },
} do
  local ended = run(c[1], c[2], "FUZZ_PLANT=" .. c[3])
  tap.ok(ended ~= 0 and said():find("FINDING", 1, true) and said():find(c[4], 1, true), "planted and found: " .. c[5],
    tostring(ended), said())
end

tap.done(program.finish())
