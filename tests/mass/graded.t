#!/usr/bin/env lua5.4
-- graded.t - regions between polynomial limits against integrals that were done elsewhere.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Mass, centroid and tensor about the centroid were integrated by SymPy 1.14, row by row from the innermost, and are
-- exact, so there is no tolerance.  With units on all coefficients, with plain numbers and with a parameter, a region
-- is the same.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"

local first = { mass = "421675/693", com = { "14355/33734", "270058/657813", "37873/202404" },
  tensor = { "302227281137675/4835809650672", "21711748521475/371985357744", "5325573391475/71114847804",
    "5405267675/331537752", "11514565735/3646915272", "15579475525/5470372908" } }
local second = { mass = "184501/5040", com = { "-2738482/6088533", "34016143/79150929", "2339017/4059022" },
  tensor = { "77425112512318757/684547890586560", "1796244181309343/52657530045120", "6909404014648607/48896277899040",
    "-502244598418067/105315060090240", "2012727371773/1097031875940", "-185913534017/975139445280" } }

-- of the parameters' defaults; what is wrong, or nil
local function differs(m, want)
  local function compare(what, got, expected)
    local v = evaluate.exact(got, m.defaults)
    if v ~= R.parse(expected) then return what .. " " .. tostring(v) .. " instead of " .. expected end
  end
  local why = compare("mass", m.mass, want.mass)
  for i = 1, 3 do why = why or compare("com " .. i, m.com[i], want.com[i]) end
  for i = 1, 6 do why = why or compare("tensor " .. i, m.centroidal[i], want.tensor[i]) end
  return why
end

local function region(body, before)
  return scene.read((before or "") .. ' return scene { name = "r", body = ' .. body .. ", origin = {0, 0, 0} }")
end

for _, case in ipairs {
  { "plain numbers", first, "region { {x, 0, 1}, {y, 0, 1 - x^2}, {z, -x*y, 0.5}, density = 1000*(1 + x + y*z) }" },
  { "a parameter without a unit", first, [[region { {x, 0, 1}, {y, 0, k/2 - x^2}, {z, -x*y, 1/k},
    density = 1000*(1 + x + y*z) }]], 'local k = param("k", 2)' },
  { "units everywhere", first, [[region { {x, 0, a}, {y, 0, a - x^2/a}, {z, -x*y/a, a/2},
    density = rho*(1 + x/a + y*z/a^2) }]], 'local a, rho = param("a", 1, "m"), quantity(1000, "kg/m^3")' },
  { "units and plain terms", first, [[region { {x, 0, quantity(1000, "mm")}, {y, 0, 1 - x^2}, {z, -x*y, 1/2},
    density = 1000 + quantity(1000, "kg/m^4")*(x + y*z/quantity(1, "m")) }]] },
  { "z outermost, limits of both signs", second,
    "region { {z, 0, 1}, {x, -1 - z, 1 + z^2}, {y, x - 2, 3 - x*z}, density = 2 + x^2 - z/2 }" },
} do
  local job, why = region(case[3], case[4])
  why = why or differs(job.model, case[2])
  tap.ok(not why, case[1], why)
end

local job = assert(region "region { {x, 0, 1}, {y, 0, 1}, {z, 0, 1}, mass = 1 }")
tap.ok(differs(job.model, first) ~= nil, "another region is told apart")

-- ---- other parameters: what NAME_init asks ----

-- Do all conditions of the model hold for a and b?
local function holds(m, a, b)
  for _, c in ipairs(m.conditions) do
    local s = R.sign(evaluate.exact(c.e, { a = R.new(a), b = R.new(b) }))
    if s < 0 or s == 0 and not c.allow_zero then return false end
  end
  return true
end

for _, case in ipairs {
  { "limits that cross", "{x, 0, a}, {y, 0, b - x}, {z, 0, x}, mass = 1", { 2, 3 }, { 3, 3 }, { 4, 3 } },
  { "a density that becomes negative", [[{x, 0, 1}, {y, 0, 1}, {z, 0, 1},
    density = quantity(1, "kg/m^4")*(a - b*x/quantity(1, "m"))]], { 3, 2 }, { 3, 3 }, { 3, 4 } },
} do
  local m = assert(region("region { " .. case[2] .. " }", string.format(
    'local a, b = param("a", %d, "m"), param("b", %d, "m")', case[3][1], case[3][2]))).model
  local fine = holds(m, table.unpack(case[3])) and holds(m, table.unpack(case[4]))
  tap.ok(fine and not holds(m, table.unpack(case[5])), case[1] .. ": asked again for other parameters")
end

tap.done()
