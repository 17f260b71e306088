#!/usr/bin/env lua5.4
-- projects.t - the promises of docs/emitted.md, on every scene of bodies/ with every stepper; docs/promises.md.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each project is compiled once by build.sh, without optimisation, so that calls are those of the source, and judged by
-- judge.lua: no warning from gcc, clang, g++ and clang++, their standards by turns; no heap, recursion, call through a
-- pointer, frame of unknown size, data that may change, foreign symbol; names begin with the scene's; float is float.
-- That each of these can fail is controls.t.  Objects with optimisation, default functions: tests/emit/compile.t.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local judge = require "tests.promises.judge"
local projects = require "tests.promises.projects"

local dir = program.directory()
local list = projects.list(dir)

local C, CXX = { "c99", "c11", "c17", "c2x" }, { "g++ -std=c++98", "clang++ -std=c++98", "g++ -std=c++11",
  "clang++ -std=c++11", "g++ -std=c++17", "clang++ -std=c++17", "g++ -std=c++20", "clang++ -std=c++20" }
local lines = {}
for i, p in ipairs(list) do
  lines[i] = string.format("%s %s -O0 %s '%s'\n", p.where, p.name, C[i // 2 % #C + 1], CXX[i % #CXX + 1])
end
program.write(dir .. "/list", table.concat(lines))
program.shell("xargs -L 1 -P 2 sh tests/promises/build.sh <" .. dir .. "/list")

for _, p in ipairs(list) do
  local faults = judge.all(p, "-O0")
  tap.ok(#faults == 0, p.title .. ": keeps its promises", table.concat(faults, "\n"))
end

-- ---- what a user builds of several: all in one program, called from C++ ----

do
  local includes, calls, objects, seen = {}, {}, {}, {}
  for _, p in ipairs(list) do
    if not seen[p.name] then
      seen[p.name] = true
      includes[#includes + 1] = string.format('#include "%s/%s.h"\n', p.where, p.name)
      calls[#calls + 1] = string.format("  {\n    %s_model m;\n    if (%s_init(&m, 0) != 0) return 1;\n  }\n", p.name,
        p.name)
      objects[#objects + 1] = p.where .. "/" .. p.name .. ".o"
    end
  end
  program.write(dir .. "/all.cc", table.concat(includes) .. "int main()\n{\n" .. table.concat(calls) ..
    "  return 0;\n}\n")
  local code = program.shell(string.format("cd %s && g++ -Wall -Wextra -Werror all.cc %s -lm -o all >log 2>&1 && ./all",
    dir, table.concat(objects, " ")))
  tap.ok(code == 0 and #calls > 30, #calls .. " scenes, double and float mixed, link into one program of C++",
    code .. "\n" .. (program.read(dir .. "/log") or ""))
end

program.finish()
tap.done()
