#!/usr/bin/env lua5.4
-- estimator.t -- the emitted estimator of the tensor of inertia (gen --with estimator), double and float: against the
-- estimates of reference logs, against noise of its own, on exact data, on wrong data.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/emit/estimator.c runs it.  On the logs of tests/reference/fit it must agree with the most likely estimate,
-- which polhode fit finds (tests/fit/reference.t).  That one is efficient, so the covariance of the difference of
-- the two is the difference of their covariances (J. A. Hausman, Econometrica 46 (1978)): each entry within 3.9 of
-- its standard deviations, which a right one misses once in 1e4.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local dir, root = program.directory(), "tests/reference/fit/"
local binary = os.getenv "POLHODE" or "build/polhode"
local WARN = "-O2 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"
local RARE = 3.9

-- A body whose entries are off by up to a sixth from those of the tests.
program.write(dir .. "/unit.lua", [[
return scene { name = "unit", body = tensor { mass = 1, xx = 1, yy = 1.25, zz = 0.9 },
  initial = { omega = { 1, 0, 0 } } }
]])

local function shell(text) return program.shell("{ " .. text .. "; } >" .. dir .. "/said 2>&1") end

-- Rows of rates and torques of a reference case, nine numbers each.
local function log_of(folder)
  local rows, torque = {}, {}
  for line in (program.read(root .. folder .. "/torque.csv") or ""):gmatch "[^\n]+" do
    local t, x, y, z = line:match "^([%d.]+),([-%d.]+),([-%d.]+),([-%d.]+)$"
    if t then torque[#torque + 1] = { tonumber(t), tonumber(x), tonumber(y), tonumber(z) } end
  end
  local at = 1
  for line in program.read(root .. folder .. "/log.csv"):gmatch "[^\n]+" do
    local t, x, y, z = line:match "^([%d.]+),([-%d.]+),([-%d.]+),([-%d.]+)$"
    if t then
      local n = { 0, 0, 0 }
      t = tonumber(t)
      while torque[at + 1] and torque[at + 1][1] < t do at = at + 1 end
      local a, b = torque[at], torque[at + 1] or torque[at]
      for k = 1, a and 3 or 0 do
        n[k] = b[1] > a[1] and a[k + 1] + (b[k + 1] - a[k + 1]) * (t - a[1]) / (b[1] - a[1]) or a[k + 1]
      end
      rows[#rows + 1] = string.format("%s %s %s %.17g %.17g %.17g 0 0 0", x, y, z, n[1], n[2], n[3])
    end
  end
  return table.concat(rows, "\n") .. "\n"
end

-- window: of about a quarter to half a turn; dt; sigma; error: of the entries xx yy zz xy xz yz; names of case.json
local CASES = {
  { "01_free_ratios", 500, 0.01, "0.004 0.004 0.004", "0 1 1 0 0 0", { [2] = "I2", [3] = "I3" } },
  { "02_free_tensor", 100, 0.02, "0.004 0.005 0.006", "0 0.5 0.5 0.5 0.5 0.5",
    { [2] = "yy", [3] = "zz", [4] = "xy", [5] = "xz", [6] = "yz" } },
  { "03_torque_pulses", 200, 0.04, "0.002 0.002 0.002", "1 1 1 1 1 1",
    { "xx", "yy", "zz", "xy", "xz", "yz" } },
}

local function reference(case, real, run)
  local fit = json.read(program.read(root .. case[1] .. "/case.json")).fits[1]
  program.write(dir .. "/rows", log_of(case[1]))
  local code = shell(string.format("%s log %d %g %s %s < %s/rows", run, case[2], case[3], case[4], case[5], dir))
  local text, numbers = program.read(dir .. "/said"), {}
  for x in text:gmatch "%S+" do numbers[#numbers + 1] = tonumber(x) end
  local name = real .. ", " .. case[1]
  if not (tap.is(code, 0, name .. ": runs") and tap.is(#numbers, 19, name .. ": and prints its results")) then
    tap.diag(text)
    return
  end
  for i = 1, 6 do
    local value, error, what = numbers[2 * i - 1], numbers[2 * i], case[6][i]
    if what then
      local apart = math.abs(value - fit.estimate[what]) / math.sqrt(error ^ 2 - fit.sigma[what] ^ 2)
      tap.ok(error > fit.sigma[what] and error < 8 * fit.sigma[what], name .. ", " .. what ..
        ": less sure than the most likely estimate, and not by much", error / fit.sigma[what])
      tap.ok(apart < RARE, name .. ", " .. what .. ": is the fit's within the difference of their errors", apart)
    else
      local held = ({ 1, nil, nil, 0, 0, 0 })[i]
      tap.ok(value == held and error == 0, name .. ": a held entry stays", value)
    end
  end
  local chi2, rows = numbers[17], numbers[18]
  tap.ok(math.abs(chi2 - rows) < RARE * math.sqrt(2 * rows), name ..
    ": innovations are as large as their variances say", chi2 / rows)
  tap.is(numbers[19], 0, name .. ": nothing is refused")
end

for _, real in ipairs { "double", "float" } do
  local out = dir .. "/" .. real
  local map = { BINARY = binary, DIR = dir, OUT = out, REAL = real, WARN = WARN }
  local code = shell(([[BINARY gen DIR/unit.lua --with estimator --real REAL --layout single -o OUT &&
    gcc -std=c99 WARN -c -o OUT/unit.o OUT/unit.c && clang -std=c99 WARN -c -o OUT/other.o OUT/unit.c &&
    g++ WARN -x c++ -c -o OUT/plus.o OUT/unit.c && make -s -C OUT check &&
    gcc -std=gnu11 -O2 -include OUT/unit.h -DNAME=unit -o OUT/run tests/emit/estimator.c OUT/unit.o -lm]])
    :gsub("%u%u%u+", map))
  local text = program.read(dir .. "/said")
  tap.is(code, 0, real .. ": compiles without a warning, as C and C++, and its own test passes")
  if code ~= 0 then tap.diag(text) end
  tap.ok(text:find("estimator", 1, true), real .. ": which has a case for it")

  for _, case in ipairs(CASES) do reference(case, real, out .. "/run") end

  -- A sum of LOGS variables of mean 5 and variance 10; a binomial share.
  local LOGS = 400
  shell(out .. "/run cover " .. LOGS .. " 100 0.004")
  local mean, inside, bad = program.read(dir .. "/said"):match "^(%S+) (%S+) (%d+)"
  mean, inside = tonumber(mean or 0), tonumber(inside or 0)
  tap.ok(math.abs(mean - 5) < RARE * math.sqrt(10 / LOGS), real .. ": the covariance is that of the errors", mean)
  tap.ok(math.abs(inside - 0.95) < RARE * math.sqrt(0.95 * 0.05 / LOGS), real ..
    ": the 95 % region has the truth 95 times of 100", inside)
  tap.is(bad, "0", real .. ": nothing is refused")

  -- With rates that are polynomials of degree 2 the sums are exact.  What is left is the pull of the prior, errors of
  -- 1 against some (1e-3/sqrt(240))^2, and the rounding of sums of 128 products, of which f' over f has cancelled.
  shell(out .. "/run order")
  for x in program.read(dir .. "/said"):gmatch "%S+" do
    tap.ok(tonumber(x) < (real == "double" and 1e-8 or 2e-6), real .. ": exact data give the tensor", x)
  end
  shell(out .. "/run bad")
  local right, all = program.read(dir .. "/said"):match "^(%d+) (%d+)"
  tap.ok(right and right == all, real .. ": what is wrong is refused, and changes nothing", tostring(right))
end

local code = shell(binary .. " gen " .. dir .. "/unit.lua -o " .. dir .. "/none")
tap.ok(code == 0 and not (program.read(dir .. "/none/unit.h") or "_estimator"):find("_estimator", 1, true),
  "none unless it is asked for")
code = shell(binary .. " gen " .. dir .. "/unit.lua --with estimator -o " .. dir .. "/split")
tap.ok(code == 0 and program.read(dir .. "/split/unit_estimator.c"), "in a file of its own where the code is split")
code = shell(binary .. " gen dropped_stone --with estimator -o " .. dir .. "/stone")
tap.is(code, 1, "a scene without rates is refused")
tap.ok(program.read(dir .. "/said"):find("needs rates among the states", 1, true), "and told why")

program.finish()
tap.done()
