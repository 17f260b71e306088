#!/usr/bin/env lua5.4
-- bench.t - fronts, the best at a level, ratios to peers, tables, CSV and what is drawn, from rows made up by hand.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local bench = require "generator.report.bench"

local function row(name, group, real, time, error, more)
  local r = { name = name, family = string.match(name, "^%S+"), group = group, real = real, kind = "step",
    setting = 0.125, error = error, time = time, steps = 80, spread = 0.02, drift = { ["T+V"] = 1e-9 } }
  for k, v in pairs(more or {}) do r[k] = v end -- any order
  return r
end

local function study(rows)
  return { name = "top", horizon = 10.0, reference = "another road", own_error = 1e-17, epsilon = { double = 2.0 ^ -52,
    float = 2.0 ^ -23 }, condition = { number = 680.0, input = "wy", state = 1200.0 }, conserved = { "T+V", "|L|" },
    levels = { 1e-3, 1e-6, 1e-9 }, noise = { least = 1e-9, most = 1e-9, noisy = false }, rows = rows }
end

-- ---- fronts ----

local a, b = row("rk4", "portable", "double", 2e-6, 1e-2), row("rk4", "portable", "double", 4e-6, 1e-4)
local c, d = row("taylor 8", "portable", "double", 3e-6, 1e-2), row("taylor 8", "portable", "double", 8e-6, 1e-7)
local e = row("semi", "portable", "double", 1e-6, 1.5)
local f = row("rk4", "portable", "float", 4e-6, 1e-4)
local wild = row("adaptive", "portable", "double", 1e-7, math.huge)
local h = row("rk4", "host", "double", 1e-6, 1e-2)
local x = row("exact", "closed", "double", 1e-6, 1e-15, { kind = "none", setting = nil, evaluation = 4e-8,
  steps = nil, note = "rounding" })
x.setting, x.steps = nil, nil
local p1, p2 = row("GSL rk4", "peer", "double", 9e-6, 1e-3), row("CVODE Adams", "peer", "double", 9e-5, 1e-6)
a.operations = { add = 70, mul = 97, div = 1, sqrt = 0, call = 0, fma = 5 }
local s = study { x, a, b, c, d, e, f, wild, h, p1, p2 }

do
  bench.mark(s)
  local function marks(...)
    local list = {}
    for i, r in ipairs { ... } do list[i] = r.front and "1" or "0" end
    return table.concat(list)
  end
  tap.is(marks(a, b, d), "111", "what nothing of its kind beats is on the front")
  tap.is(marks(c), "0", "what is slower at the same error is not")
  tap.is(marks(f), "0", "of two rows that are alike the first is")
  tap.is(marks(e, wild), "00", "an error above 1, or none, is no result")
  tap.is(marks(h, x, p1, p2), "1111", "each kind has a front of its own")
  tap.is(#bench.front {}, 0, "nothing has no front")
end

-- ---- levels ----

do
  local list = bench.of_group(s, "portable")
  tap.ok(bench.best(list, 1e-3) == b, "the best at a level is the fastest that is exact enough")
  tap.ok(bench.best(list, 1e-2) == a, "an error that is the level is exact enough")
  tap.is(bench.best(list, 1e-9), nil, "there may be none")
  local sum = bench.summary(s)
  tap.is(sum[1].ratio.portable, 9e-6 / 4e-6, "times faster than the best peer")
  tap.is(sum[2].ratio.closed, 9e-5 / 1e-6, "the peer has to be exact enough, too")
  tap.is(sum[3].ratio.closed, nil, "where no peer is there is no ratio")
  tap.is(sum[3].peer, nil, "and no peer")
end

-- ---- words ----

for seconds, want in pairs { [2.5e-9] = "2.50 ns", [0.99996e-6] = "1.00 µs", [1e-6] = "1.00 µs", [12.34e-6] = "12.3 µs",
  [123.4e-6] = "123 µs", [0.5] = "500 ms", [2.0] = "2.00 s", [1234.0] = "1234 s" } do -- any order
  tap.is(bench.time_text(seconds), want, "a time: " .. want)
end
for value, want in pairs { [1e-3] = "0.001", [1e-11] = "1e-11", [0.25] = "0.25", [2.5e-7] = "2.5e-7" } do -- any order
  tap.is(bench.level_text(value), want, "a level: " .. want)
end
tap.is(bench.error_text(1.24e-9), "1.2e-9", "an error has two digits")
tap.is(bench.error_text(math.huge), "none", "no result has none")

-- ---- the tables ----

do
  local text = bench.text(s, { format = "text" })
  tap.like(text, "condition number 680 (worst input: wy): one ulp of it moves the end by 1.5e-13 in double, 8.1e-5",
    "the condition number and what it means")
  tap.like(text, "moves the end by up to 2.7e-13 in double, 1.4e-4 in float. Errors near these are named rounding",
    "and that of the state")
  tap.like(text, "\nrk4 +4.00 µs%*", "the best of its kind at a level is marked", true)
  tap.like(text, "exact +%- +1.0e%-15 +rounding", "an error at the floor is named", true)
  tap.like(text, "ns +168 +2.00", "operations of a step: additions, multiplications and so on", true)
  tap.like(text, "portable C +rk4, 4.00 µs %(2.25 x%) +taylor 8, 8.00 µs %(11.%d x%) +%.", "the summary", true)
  tap.ok(not text:find("* rk4", 1, true), "without --all only fronts are listed")
  local wide = true
  for line in text:gmatch "[^\n]+" do wide = wide and not line:find " $" end
  tap.ok(wide, "no line ends in a blank")
  local full = bench.text(s, { format = "text", all = true })
  tap.like(full, "\n* rk4", "with it all rows, marked")
  tap.like(full, "\n  taylor 8", "or not")
  local md = bench.text(s, { format = "markdown" })
  local columns, even = nil, true
  for line in md:gmatch "[^\n]*" do
    if line:sub(1, 1) == "|" then
      local _, n = line:gsub("\\|", ""):gsub("|", "")
      columns = columns or n
      even = even and n == columns
    else
      columns = nil
    end
  end
  tap.ok(even, "every line of a table in Markdown has as many cells as its head")
  tap.like(md, "drift \\|L\\|", "a bar in a cell is escaped")
  tap.is(bench.noise(s), nil, "a quiet machine is not spoken of")
  s.noise = { least = 1e-9, most = 1.5e-9, noisy = true }
  tap.like(bench.noise(s), "1.00 ns to 1.50 ns", "a noisy one is")
end

-- ---- CSV ----

do
  local lines = {}
  for line in bench.csv(s):gmatch "[^\n]+" do lines[#lines + 1] = line end
  tap.is(#lines, 1 + #s.rows, "one line a row")
  tap.is(lines[1], "scene,group,method,real,kind,setting,error,note,drift T+V,drift |L|,steps,seconds_step,seconds," ..
    "spread,add,mul,div,sqrt,call,front", "the head")
  tap.is(lines[2], "top,closed,exact,double,none,,1.0000000000000001e-15,rounding,1.0000000000000001e-09,,," ..
    "4.0000000000000001e-08,9.9999999999999995e-07,0.02,,,,,,1", "a closed form: no setting, no steps")
  tap.like(lines[3], ",80,2.4999999999999999e-08,1.9999999999999999e-06,0.02,70,97,1,0,0,1", "a step")
  tap.like(lines[9], ",inf,", "no result is infinite")
end

-- ---- the curves ----

do
  local names = {}
  for i, curve in ipairs(bench.curves(s)) do names[i] = curve.label .. ":" .. curve.kind .. ":" .. #curve.points end
  tap.is(table.concat(names, " "), "closed form:spot:1 rk4:own:2 taylor:own:2 this machine, best:group:1 " ..
    "float, best:group:1 GSL rk4:peer:1 CVODE Adams:peer:1", "curves: fronts of families, of kinds, and peers")
  tap.like(bench.picture(s), "<svg ", "and they are drawn")
  s.rows = { wild }
  tap.is(bench.picture(s), nil, "nothing is not")
end

tap.done()
