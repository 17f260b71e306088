#!/usr/bin/env lua5.4
-- search.t - the search finds the cheapest candidate and its setting, in few runs.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Candidates here are laws: the error of n steps is (c/n)^p, never below a floor, so the cheapest is known: the least
-- w c limit^(-1/p).  The search promises a number of steps within 2 % and one of the least (search.lua: close).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local search = require "generator.plan.search"

local T = 10

-- A trial whose candidates obey laws; counts runs.
local function laws()
  local s = { T = T, runs = 0 }
  function s:measured(r) -- the search's log, not looked at here
    self.last = r
    return r
  end
  function s:worst(c, setting, _, limit)
    self.runs = self.runs + 1
    if c.setting == "none" then return c.floor, 1 end
    if c.setting == "tolerance" then
      return math.max(c.floor or 0, c.c * setting), 100 * setting ^ (-1 / c.power)
    end
    local n = T / setting
    self.longest = math.max(self.longest or 0, n)
    local _ = limit
    return math.max(c.floor or 0, n < (c.least or 0) and math.huge or (c.c / n) ^ c.power), n
  end
  return s
end

local function candidate(name, power, c, w, more)
  local out = { name = name, setting = "step", power = power, c = c, weight = function() return w end, spread = 2 }
  for k, v in pairs(more or {}) do out[k] = v end -- into a table: order is lost anyway
  return out
end

local function cheapest(list, limit)
  local s = laws()
  local best, found = search.cheapest({ trial = s, points = {}, epsilon = 2 ^ -52 }, list, limit)
  return best, found, s
end

local list = { candidate("p16", 16, 30, 1000), candidate("p8", 8, 25, 300), candidate("p4", 4, 20, 90),
  candidate("p2", 2, 20, 40), candidate("p1", 1, 10, 10) }
for _, limit in ipairs { 1e-1, 1e-3, 1e-6, 1e-9, 1e-12 } do
  local least, name = math.huge, nil
  for _, c in ipairs(list) do
    local cost = c.weight() * math.ceil(c.c * limit ^ (-1 / c.power))
    if cost < least then least, name = cost, c.name end
  end
  local best, found, s = cheapest(list, limit)
  tap.is(best.candidate.name, name, string.format("error %g: the cheapest method", limit))
  tap.ok(best.error <= limit and best.cost <= least * 1.02 + best.candidate.weight(),
    "and the longest step that holds", string.format("%g, least %g", best.cost, least))
  tap.ok(s.runs < 60, "in few runs", s.runs)
  for i, f in ipairs(found) do
    tap.ok(f.candidate == list[i] and (f.fits and f.error <= limit or f.dearer), "and says of " .. list[i].name ..
      " what came of it")
  end
end

local best = cheapest({ candidate("blind", 8, 25, 1, { floor = 1e-8 }), list[1] }, 1e-9)
tap.is(best.candidate.name, "p16", "what rounds too much cannot win")
local found, s
best, found, s = cheapest({ candidate("blind", 8, 25, 1, { floor = 1e-8 }) }, 1e-9)
tap.is(best, nil, "and alone it has no answer")
tap.is(found[1].error, 1e-8, "but its best error is known")
tap.ok(s.longest <= 2 ^ 20, "no run is longer than 2^20 steps")
best = cheapest({ candidate("stiff", 4, 2, 5, { least = 700 }) }, 1e-1)
tap.ok(best.steps >= 700 and best.steps <= 714, "a bound of stability is found, too", best.steps)
best = cheapest({ list[1], { name = "exact", setting = "none", floor = 1e-14, setup = 500,
  weight = function() return 50 end } }, 1e-9)
tap.ok(best.candidate.name == "exact" and best.cost == 550, "a closed form costs its set-up and one evaluation")
best = cheapest({ candidate("run", 20, 50, 400, { setting = "tolerance" }) }, 1e-9)
tap.ok(best.error <= 1e-9 and best.error > 1e-9 / 2.2, "a tolerance near the largest that holds", best.error)
tap.is(best.setting, search.rounded(best.setting, 2), "of two digits")
best = cheapest({ candidate("run", 20, 50, 400, { setting = "tolerance", floor = 1e-8 }) }, 1e-9)
tap.is(best, nil, "no tolerance below the floor")

-- ---- rounding down to digits ----

for _, c in ipairs { { 0.057159, 4, 0.05715 }, { 1.9999e-12, 2, 1.9e-12 }, { 1, 2, 1 }, { 600, 4, 600 },
  { 0.1, 2, 0.1 }, { 1.0001e-300, 2, 1e-300 }, { 99999, 4, 99990 } } do
  tap.is(search.rounded(c[1], c[2]) + 0.0, c[3] + 0.0, string.format("%.17g to %d digits, not above it", c[1], c[2]))
end

tap.done()
