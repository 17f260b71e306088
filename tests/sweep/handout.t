#!/usr/bin/env lua5.4
-- handout.t - a model of handing out blocks by one counter: is it enough for ten thousand ranks and unequal blocks?
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Simulated, not measured: a rank asks the counter for a block, waits while the counter serves others (`service` each,
-- one after the other), and is there and back after `latency`; then it computes.  It asks while it computes the block
-- before, as sweep_team.c does.  Efficiency is the work over ranks times the time of the last.  `lua5.4
-- tests/sweep/handout.t all` prints the table of docs/sweep.md.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"

-- Seconds of block i of mean 1: a hash of i, so that every run has the same.
local function uniform(i, k)
  local x = (i * 0x9E3779B97F4A7C15 + k * 0x2545F4914F6CDD1D) & -1
  x = (x ~ x >> 31) * 0xBF58476D1CE4E5B9
  x = (x ~ x >> 27) * 0x94D049BB133111EB
  return ((x >> 11) + 0.5) * 2.0 ^ -53
end

local function normal(i)
  return math.sqrt(-2 * math.log(uniform(i, 1))) * math.cos(2 * math.pi * uniform(i, 2))
end

-- Of 1024 members whose costs have Pareto's law P(X > x) = (0.6/x)^2.5, mean 1: those below 20 together are normal,
-- mean 0.9948 and deviation 0.706 each by integrals of x and x^2 over the law; one in 6408 is above.
local function pareto_members(i)
  local sum, k = 1024 * 0.9948 + 32 * 0.706 * normal(i), 3
  local left = 1024 * (0.6 / 20) ^ 2.5 -- the number above 20 is Poisson's: gaps are exponential
  while true do
    left = left + math.log(uniform(i, k))
    if left < 0 then return sum / 1024 end
    sum = sum + 20 * uniform(i, k + 1) ^ (-1 / 2.5)
    k = k + 2
  end
end

local COSTS = {
  equal = function() return 1.0 end,
  ["members of Pareto 2.5"] = pareto_members,
  ["blocks of lognormal 0.5"] = function(i) return math.exp(0.5 * normal(i) - 0.125) end,
  ["blocks of lognormal 1"] = function(i) return math.exp(normal(i) - 0.5) end,
}

-- Ranks in the order in which they are free again: a heap of times.
local function push(heap, x)
  local i = #heap + 1
  while i > 1 and heap[i // 2] > x do
    heap[i] = heap[i // 2]
    i = i // 2
  end
  heap[i] = x
end

local function replace_first(heap, x)
  local i, n = 1, #heap
  while true do
    local c = 2 * i
    if c > n then break end
    if c < n and heap[c + 1] < heap[c] then c = c + 1 end
    if heap[c] >= x then break end
    heap[i] = heap[c]
    i = c
  end
  heap[i] = x
end

local function efficiency(ranks, blocks, cost, mean, service, latency)
  local heap, counter, work, last = {}, 0.0, 0.0, 0.0
  for _ = 1, ranks do push(heap, 0.0) end
  for i = 1, blocks do
    local free = heap[1]
    -- asked for when the block before began, at the earliest; the counter serves in the order in which ranks are free
    counter = math.max(counter, free - mean) + service
    local begin = math.max(free, counter + latency)
    local t = cost(i) * mean
    work, last = work + t, math.max(last, begin + t)
    replace_first(heap, begin + t)
  end
  return work / (ranks * last)
end

local RANKS, BLOCKS, SERVICE, LATENCY = 10000, 1000000, 2e-6, 1e-5
local function at(cost, mean) return efficiency(RANKS, BLOCKS, COSTS[cost], mean, SERVICE, LATENCY) end

tap.ok(math.abs(efficiency(10, 1000, COSTS.equal, 1, 0, 0) - 1) < 1e-12,
  "equal blocks that divide evenly waste nothing")
tap.ok(math.abs(efficiency(10, 1001, COSTS.equal, 1, 0, 0) - 1001 / 1010) < 1e-12, "one block more is one more round")
tap.ok(efficiency(10000, 100000, COSTS.equal, 0.001, 2e-6, 0) < 0.06, "a counter of 2 us feeds 500 ranks of 1 ms")
local heavy = at("members of Pareto 2.5", 1.0)
tap.diag(string.format("members of Pareto 2.5, blocks of 1 s: %.3f", heavy))
tap.ok(heavy >= 0.95, "10^4 ranks, 10^9 members of heavy-tailed cost, blocks of 1024: efficiency at least 95 %")
tap.ok(at("blocks of lognormal 0.5", 1.0) < 0.95,
  "blocks that are as unequal themselves cost more: the last ones decide")

if arg[1] == "all" then
  for _, cost in ipairs { "equal", "members of Pareto 2.5", "blocks of lognormal 0.5", "blocks of lognormal 1" } do
    for _, mean in ipairs { 1.0, 0.1, 0.02, 0.01 } do
      print(string.format("# %-24s %5g s a block: %.3f", cost, mean, at(cost, mean)))
    end
  end
end

tap.done()
