#!/usr/bin/env lua5.4
-- reports.t - what analysers say of emitted code: nothing, or what docs/misra.md lists with a reason.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- gcc -fanalyzer, clang --analyze and cppcheck are clean, each of them shown to see a planted defect; cppcheck's MISRA
-- addon reports the rules of docs/misra.md and no others, no fewer.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local projects = require "tests.promises.projects"

for _, tool in ipairs { "cppcheck", "clang", "gcc" } do
  if program.shell("command -v " .. tool .. " >/dev/null") ~= 0 then
    tap.skip("what analysers say", "apt-get install " .. tool)
    tap.done()
  end
end

local dir = program.directory()
local stone = projects.one(dir, "bodies/dropped_stone.lua", "double")
local brick = projects.one(dir, "bodies/damped_brick.lua", "float")
local wheels = projects.one(dir, "bodies/wheels.lua", "double", "--method rk4,adaptive,semi")

local function says(p, format)
  program.shell(string.format("cd %s && { timeout 100 " .. format .. " || echo status $?; } >said 2>&1", p.where,
    p.name .. ".c"))
  return program.read(p.where .. "/said")
end

-- ---- analysers ----

local analysers = { -- and how each names the defect that is planted below
  -- these two not of closed forms: gcc 12 takes minutes for one
  { "gcc -fanalyzer", "gcc -std=c99 -O1 -fanalyzer -c %s -o analysed.o", "analyzer%-null%-dereference", short = true },
  { "clang --analyze", "clang --analyze -std=c99 %s", "[Dd]ereference of null", short = true },
  { "cppcheck", "cppcheck --quiet --enable=warning,performance,portability --std=c99 " ..
    "--suppress=missingIncludeSystem %s", "nullPointer" },
}
for _, a in ipairs(analysers) do
  for _, p in ipairs { stone, wheels, not a.short and brick or nil } do
    tap.is(says(p, a[2]), "", p.title .. ": " .. a[1] .. " has nothing to say")
  end
end

-- ---- MISRA ----

local listed, list = {}, {}
for rule in string.gmatch(program.read "docs/misra.md", "\n| (%d+%.%d+) |") do
  listed[rule], list[#list + 1] = true, rule
end

local function reported(p, counts)
  local text = says(p, "cppcheck --quiet --addon=misra --std=c99 --suppress=missingIncludeSystem %s")
  for rule in string.gmatch(text, "misra%-c2012%-(%d+%.%d+)") do counts[rule] = (counts[rule] or 0) + 1 end
  return counts
end

local function beyond(counts)
  local more = {}
  for rule, n in pairs(counts) do
    if not listed[rule] then more[#more + 1] = rule .. ": " .. n end
  end
  table.sort(more)
  return table.concat(more, ", ")
end

local counts = reported(brick, reported(stone, {}))
tap.is(beyond(counts), "", "no rule is reported that docs/misra.md does not have")
local gone = {}
for _, rule in ipairs(list) do
  if not counts[rule] then gone[#gone + 1] = rule end
end
tap.ok(#list > 10 and #gone == 0, "all " .. #list .. " that it lists are reported", table.concat(gone, " "))

-- ---- and that they can ----

program.write(stone.where .. "/dropped_stone.c", stone.source ..
  "\nint dropped_stone_planted(int n)\n{\n  int *p = 0;\n\n  if (n == 3) goto end;\n  return *p;\n" ..
  "end:\n  return n;\n}\nint dropped_stone_null(void)\n{\n  int *p = 0;\n\n  return *p;\n}\n")
for _, a in ipairs(analysers) do
  tap.like(says(stone, a[2]), a[3], a[1] .. " sees a planted null pointer", true)
end
tap.like(beyond(reported(stone, {})), "15.1", "a goto is a rule that is not listed")

program.finish()
tap.done()
