#!/usr/bin/env lua5.4
-- hard.t - the fast half of the hard cases, and that the judge can fail.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A case passes when every error is a number within its bound; what is hard and why that bound: the case itself.

local tap = require "tests.tap"
local catalogue = require "tests.hard.catalogue"
local judge = require "tests.hard.judge"
local run = require "tests.hard.run"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local hard, count = catalogue.load(), 0
local results = run.cases(binary, program.directory(), "fast", "", catalogue.files)
for _, file in ipairs(hard) do
  for _, case in ipairs(file.cases) do
    count = count + 1
    if case.fast then
      local v = judge.case(case, results[case.name])
      local w = v.worst.all
      tap.ok(v.fine, string.format("%s: %s", case.name, w and string.format("%.2g of the bound, by %s in %s", w.ratio,
        w.who, w.real) or "nobody"), table.concat(v.faults, "\n"))
    end
  end
end
tap.ok(count >= 80, count .. " cases in the catalogue")

-- ---- controls: what must not pass ----

local function verdict(case, lines)
  local r = {}
  for _, line in ipairs(lines) do judge.read(r, (string.gsub(line, " ", "\t"))) end
  return judge.case(case, r[case.name]).fine
end
local good = { "case f c", "row at double 1 2", "row at float 1 2", "naive 5", "end" }
local function with(k, line)
  local list = { table.unpack(good) }
  list[k] = line
  return list
end
tap.ok(verdict({ name = "c" }, good), "a case within its bounds passes")
for _, bad in ipairs { { 2, "row at double 3 2", "an error above its bound" }, { 3, "row at float nan 2", "a NaN" },
  { 2, "row at double -nan 2", "another NaN" }, { 2, "row at double inf 2", "an infinity" },
  { 2, "row at double 1 inf", "an infinite bound" }, { 2, "row at double 0 0", "a bound of 0" },
  { 2, "row at double 1 nan", "a bound that is no number" },
  { 3, "row at double 1 2", "a case without float" }, { 4, "broken why", "a case that broke" },
  { 4, "row at double 1 2", "a case without the naive formula" }, { 5, "", "a case that ended early" } } do
  tap.ok(not verdict({ name = "c" }, with(bad[1], bad[2])), bad[3] .. " does not pass")
end
tap.ok(not judge.case({ name = "d" }, nil).fine, "a case that did not run does not pass")
program.finish()
tap.done()
