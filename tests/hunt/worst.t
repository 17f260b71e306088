#!/usr/bin/env lua5.4
-- worst.t - the worst states that the hunt has kept, judged anew; and that the hunt finds what is planted.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each state of worst.tsv and found.lua must be within its bound, and those of worst.tsv as bad as they were recorded:
-- to a twentieth and half a unit, as another C library may round the oracle's start otherwise.  Where the emitted code
-- has changed, `make hunt` keeps new ones.  The judges are those of tests/hunt/*.c, with MPFR.
-- POLHODE names another generator.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local targets = require "tests.hunt.targets"
local records = require "tests.hunt.records"

local polhode = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local function words(line)
  local list = {}
  for word in string.gmatch(line, "%S+") do list[#list + 1] = word end
  return list
end

-- The judged errors of a list of states, by name.
local function judged(t, path, states)
  local lines = {}
  for i, genes in ipairs(states) do lines[i] = table.concat(genes, " ") .. "\n" end
  program.write(dir .. "/states", table.concat(lines))
  local code = program.shell(string.format("timeout 120 %s --replay < %s/states > %s/out", path, dir, dir))
  local answers, names = {}, targets.errors(t)
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do
    local answer = {}
    for i, word in ipairs(words(line)) do answer[names[i] or i] = tonumber(word) or math.huge end
    answers[#answers + 1] = answer
  end
  return tap.ok(code == 0 and #answers == #states, path:match "[^/]*$" .. ": judges " .. #states .. " states") and
    answers or {}
end

local worst, found = records.load_worst "tests/hunt/worst.tsv", dofile "tests/hunt/found.lua"
local count = 0

local function of(t, list)
  local own = {}
  for _, w in ipairs(list) do
    if w.target == t.name and w.real == t.real then own[#own + 1] = w end
  end
  return own
end

for _, t in ipairs(targets.list) do
  local path, said = targets.build(t, dir, polhode, { level = "-O1" })
  if tap.ok(path and said == "", t.name .. ", " .. t.real .. ": the program compiles", said) then
    local states, rows = {}, {}
    for _, w in ipairs(of(t, worst)) do
      for _, s in ipairs(w.states) do
        states[#states + 1] = s.genes
        rows[#rows + 1] = { name = s.name, error = w.error, bound = tonumber(w.bound),
          value = tonumber(s.value) }
      end
    end
    local bounds = {}
    for _, row in ipairs(rows) do bounds[row.error] = row.bound end
    for _, f in ipairs(of(t, found)) do
      states[#states + 1] = f.genes
      rows[#rows + 1] = { name = f.name, error = f.error, bound = bounds[f.error] }
    end
    local beyond, other = {}, {}
    for i, answer in ipairs(judged(t, path, states)) do
      local row = rows[i]
      local value = answer[row.error]
      local line = string.format("%s: %s, bound %s, recorded %s", row.name, value, row.bound, row.value)
      if not (value and value <= row.bound) then beyond[#beyond + 1] = line end
      if row.value and not (value and math.abs(value - row.value) <= 0.05*row.value + 0.5) then
        other[#other + 1] = line
      end
      count = count + 1
    end
    tap.is(table.concat(beyond, "\n"), "", t.name .. ", " .. t.real .. ": every kept state is within its bound")
    tap.is(table.concat(other, "\n"), "", t.name .. ", " .. t.real .. ": and as bad as it was recorded")
  end
end
tap.ok(count >= 100, count .. " states judged")

-- ---- what is planted is found, and nothing where nothing is ----

-- 1e5 states each; an error of at least so many u: a hill of 1e4 must be climbed, its foot is not enough
for defect, least in ipairs { [0] = 0, 36, 36, 5000 } do
  local t = targets.chosen("free_top_double")[1]
  local path = targets.build(t, dir, polhode, { define = "DEFECT=" .. defect, level = "-O1" })
  program.shell(string.format("timeout 120 %s --seed 1 --count 1e5 > %s/out 2> %s/err", path, dir, dir))
  local _, states = records.parse(program.read(dir .. "/out"), t)
  local most = 0
  for _, s in ipairs(states) do
    if s.error == "rates" or s.error == "attitude" then most = math.max(most, tonumber(s.value)) end
  end
  tap.ok(#states > 0 and most > least, string.format("planted defect %d: the search finds %.3g u", defect, most))
end

program.finish()
tap.done()
