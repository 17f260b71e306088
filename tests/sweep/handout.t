#!/usr/bin/env lua5.4
-- handout.t - a model of handing out blocks by one counter: is it enough for ten thousand ranks and unequal blocks?
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The division into blocks is the program's own: templates/sweep/sweep_blocks.c, compiled and asked.  The rest is
-- simulated, not measured: a rank with one thread asks the counter for a block, waits while the counter serves others
-- (`service` each, one after the other), and is there and back after `latency`; then it computes.  As sweep_team.c, it
-- asks when it begins the block before, and from the first smaller block on when it has none.  Efficiency is the work
-- over ranks times the time of the last.  `lua5.4 tests/sweep/handout.t all` prints the table of docs/sweep.md.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

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

-- Ranks in the order in which they ask: a heap of times, and beside each when its rank is free.
local function push(heap, free, x, f)
  local i = #heap + 1
  while i > 1 and heap[i // 2] > x do
    heap[i], free[i] = heap[i // 2], free[i // 2]
    i = i // 2
  end
  heap[i], free[i] = x, f
end

local function replace_first(heap, free, x, f)
  local i, n = 1, #heap
  while true do
    local c = 2 * i
    if c > n then break end
    if c < n and heap[c + 1] < heap[c] then c = c + 1 end
    if heap[c] >= x then break end
    heap[i], free[i] = heap[c], free[c]
    i = c
  end
  heap[i], free[i] = x, f
end

local dir = program.directory()
local built = program.shell("cc -std=c99 -O1 -Itemplates/sweep -o " .. dir .. "/blocks tests/sweep/blocks.c " ..
  "templates/sweep/sweep_blocks.c") == 0
if not tap.ok(built, "the program's division into blocks compiles") then
  program.finish()
  tap.done()
end

-- Levels of the division: first member, size, number of blocks.
local function divided(members, block, workers, lanes)
  local pipe = assert(io.popen(string.format("%s/blocks %d %d %d %d", dir, members, block, workers, lanes)))
  local levels = {}
  for size, count, first in pipe:read("a"):gmatch "(%d+) (%d+) (%d+)\n" do
    levels[#levels + 1] = { size = math.tointeger(size), count = math.tointeger(count),
      first = math.tointeger(first) }
  end
  pipe:close()
  return levels
end

-- mean: seconds of `region` neighbouring members, by default a whole block.  cost(i): of region i, in parts of the
-- mean; each part of a region costs its part.
local function efficiency(ranks, levels, cost, mean, service, latency, region)
  local heap, free, counter, work, last = {}, {}, 0.0, 0.0, 0.0
  local whole, total = levels[1].size, 0
  region = region or whole
  for _ = 1, ranks do push(heap, free, 0.0, 0.0) end
  for _, level in ipairs(levels) do
    local late = level.size < whole
    for j = 0, level.count - 1 do
      local asked, busy = heap[1], free[1]
      counter = math.max(counter, asked) + service
      local begin = math.max(busy, counter + latency)
      local t = cost((level.first + j * level.size) // region) * mean * level.size / region
      work, last, total = work + t, math.max(last, begin + t), total + 1
      replace_first(heap, free, late and begin + t or begin, begin + t)
    end
  end
  return work / (ranks * last), total
end

local RANKS, MEMBERS, BLOCK, LANES = 10000, 1024 * 1000000, 1024, 16
local SERVICE, LATENCY = 2e-6, 1e-5
local LEVELS = divided(MEMBERS, BLOCK, RANKS, LANES)
local function at(cost, mean) return efficiency(RANKS, LEVELS, COSTS[cost], mean, SERVICE, LATENCY) end
local function alike(n) return { { size = 1, count = n, first = 0 } } end

-- ---- the division ----

do
  local wrong, smallest = 0, 0
  for _, case in ipairs { { MEMBERS, BLOCK, RANKS, LANES }, { 20000, 777, 1, 8 }, { 100, 1, 4, 16 }, { 5, 1024, 2, 16 },
    { 8281, 1024, 2, 16 }, { 65536, 100, 64, 8 }, { 4294967295, 4294967295, 3, 8 }, { 1, 1, 1, 1 } } do
    local member, before = 0, math.huge
    for i, level in ipairs(divided(table.unpack(case))) do
      wrong = wrong + (level.first == member and level.size < before and level.size <= case[2] and 0 or 1) +
        ((i == 1 or level.size % case[4] == 0) and level.count > 0 and 0 or 1)
      member, before = member + level.size * level.count, level.size
    end
    if member < case[1] or member - before >= case[1] then wrong = wrong + 1 end
    smallest = case[2] == BLOCK and case[1] == MEMBERS and before or smallest
  end
  tap.is(wrong, 0, "the blocks have every member once, whole lanes behind the first size, and become smaller")
  tap.is(smallest, 32, "down to a thirty-second")
end

-- ---- the hand-out ----

tap.ok(math.abs(efficiency(10, alike(1000), COSTS.equal, 1, 0, 0) - 1) < 1e-12,
  "equal blocks that divide evenly waste nothing")
tap.ok(math.abs(efficiency(10, alike(1001), COSTS.equal, 1, 0, 0) - 1001 / 1010) < 1e-12,
  "one block more is one more round")
tap.ok(efficiency(10000, alike(100000), COSTS.equal, 0.001, 2e-6, 0) < 0.06,
  "a counter of 2 us feeds 500 ranks of 1 ms")
for _, cost in ipairs { "members of Pareto 2.5", "blocks of lognormal 0.5" } do
  local e = at(cost, 1.0)
  tap.diag(string.format("%s, blocks of 1 s: %.3f", cost, e))
  tap.ok(e >= 0.95, cost .. ": 10^4 ranks, 10^9 members: efficiency at least 95 %")
end
tap.ok(efficiency(RANKS, alike(1000000), COSTS["blocks of lognormal 0.5"], 1.0, SERVICE, LATENCY) < 0.95,
  "without smaller blocks at the end it is less: the last ones decide")

if arg[1] == "all" then
  for _, cost in ipairs { "equal", "members of Pareto 2.5", "blocks of lognormal 0.5", "blocks of lognormal 1" } do
    for _, mean in ipairs { 1.0, 0.1, 0.02, 0.01 } do
      print(string.format("# %-24s %5g s a block: %.3f, %d blocks", cost, mean, at(cost, mean)))
    end
  end
  for _, block in ipairs { 512, 256, 128 } do
    print(string.format("# lognormal 1, 1 s for 1024 members, --block %d: %.3f, %d blocks", block,
      efficiency(RANKS, divided(MEMBERS, block, RANKS, LANES), COSTS["blocks of lognormal 1"], 1.0, SERVICE, LATENCY,
        1024)))
  end
end

program.finish()
tap.done()
