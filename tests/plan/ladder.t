#!/usr/bin/env lua5.4
-- ladder.t - the rungs of a ladder: where it begins, how it goes down, where it ends.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The methods are made up: error = (h/h0)^p, never below a floor; time = cost * T/h.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local ladder = require "generator.plan.ladder"

local T = 100

local function never() return nil end

-- A method of order p that is useless above h0.
local function method(p, h0, floor, cost)
  local calls = {}
  return calls, function(h)
    calls[#calls + 1] = h
    return math.max((h / h0) ^ p, floor), cost * T / h
  end
end

local function climb(fields)
  local m = { T = T, kind = "step", floor = 1e-12, noise = 1e-9, least = 2 ^ -52, best = never, order = 4 }
  for k, v in pairs(fields) do m[k] = v end -- any order
  return ladder.climb(m)
end

for _, p in ipairs { 2, 4, 8, 20 } do
  local _, run = method(p, 0.5, 1e-13, 1e-7)
  local list = climb { order = p, run = run }
  local first, last, name = list[1], list[#list], "order " .. p .. ": "
  tap.ok(first.error < 1 and first.error > (p <= 4 and 0.02 or 1e-3), name .. "begins where the method begins to work")
  local falling, factor = true, 0
  for i = 2, #list do
    falling = falling and list[i].setting < list[i - 1].setting
    factor = math.max(factor, list[i - 1].error / list[i].error)
  end
  tap.ok(falling, name .. "steps fall")
  tap.ok(factor <= 16 * (1 + 1e-9), name .. "no rung is more than 16 times as accurate as the one before",
    "largest " .. factor)
  tap.ok(last.error <= 1e-12 or last.seconds > 0.4, name .. "ends at the floor, or where a run takes too long")
end

do
  local _, run = method(4, 0.5, 1e-30, 1e-9)
  local list = climb { run = run, floor = 1e-8 }
  local at = 0
  for _, r in ipairs(list) do at = at + (r.error <= 1e-8 and 1 or 0) end
  tap.is(at, 3, "three rungs at the floor end a ladder")
  list = climb { run = run, enough = 1e-5 }
  tap.ok(list[#list].error <= 1e-5 and list[#list - 1].error > 1e-5, "so does the first that is good enough")
  list = climb { run = run, best = function() return 1e-9 * T / 0.5 / 4 end }
  tap.ok(list[#list].seconds <= 2 * 20 * 1e-9 * T / 0.5 / 4, "so does one that is 20 times slower than another method")
  local function cut(limit) -- long steps are cut into pieces, and say nothing of the order
    return function(h) return h > limit and 1e-5 or 1e-5 * (h / limit) ^ 4, 1e-6 end
  end
  list = climb { run = cut(0.4) }
  tap.ok(list[1].error == 1e-5 and list[#list].error <= 1e-12, "a plateau far above rounding does not end it")
  list = climb { run = cut(0), noise = 1e-4 }
  tap.is(#list, 4, "one within rounding does: three rungs that are no better than the first")
  local calls
  calls, run = method(4, 0.5, 0.5, 1e-3)
  list = climb { run = run }
  tap.ok(#calls < 40, "a method that never works is given up when it becomes slow")
  for _, r in ipairs(list) do tap.ok(r.error < 1, "and its rungs tell an error below 1") end
end

do -- tolerances: the error is theirs, times 1000
  local tolerances = {}
  local function run(tolerance)
    tolerances[#tolerances + 1] = tolerance
    return (tolerance < 1e-14 or tolerance > 0.05) and math.huge or 1000 * tolerance, tolerance > 0.05 and 9 or 1e-6
  end
  local list = climb { kind = "tolerance", run = run, floor = 1e-30 }
  tap.is(tolerances[1], 0.1, "tolerances begin at a tenth")
  local good = true
  for i = 3, #tolerances do
    good = good and math.abs(tolerances[i - 2] / tolerances[i] - 10) < 1e-12 -- rounding of two powers
  end
  tap.ok(good, "two of them in a decade")
  tap.ok(list[1].error <= 1 and list[1].error > 0.09, "rungs without a result are left out")
  tap.ok(#list > 10, "a tolerance that is too loose to come to an end does not end the ladder")
  tap.ok(list[#list].error < 1e-10 and list[#list].setting >= 1e-14 * (1 - 1e-12),
    "a run that ends in nothing ends the ladder")
  list = climb { kind = "tolerance", floor = 1e-30, run = function(tolerance)
    return math.min(1e-3, tolerance), 1e-6
  end }
  tap.ok(list[#list].error < 1e-10, "a few tolerances that all do the same do not end it")
  tolerances = {}
  climb { kind = "tolerance", run = run, floor = 1e-30, least = 1e-6 }
  tap.ok(tolerances[#tolerances] >= 1e-6 * (1 - 1e-12), "no tolerance is below what the type can hold")
end

tap.done()
