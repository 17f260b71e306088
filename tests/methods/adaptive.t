#!/usr/bin/env lua5.4
-- adaptive.t - the embedded pair: its order conditions exactly, and the emitted stepper on forced and free tops.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A Runge-Kutta method has order p iff for every rooted tree of at most p vertices the elementary weight is one over
-- the tree's density (Butcher 1963; Hairer, Norsett, Wanner I, theorem II.2.13): 17 trees for order 5, 8 for order 4.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local adaptive = require "generator.methods.adaptive"
local trees = require "tests.methods.trees"

local T = adaptive.tableau
local function stage_weights(t) -- the product over subtrees of sum_j a_ij phi_j, for each stage i
  local phi = {}
  for i = 1, #T.a do phi[i] = R.one end
  for _, s in ipairs(t.forest) do
    local inner = stage_weights(s)
    for i = 1, #T.a do
      local sum = R.zero
      for j, a in ipairs(T.a[i]) do sum = sum + a * inner[j] end
      phi[i] = phi[i] * sum
    end
  end
  return phi
end

local function weight(b, t)
  local phi, sum = stage_weights(t), R.zero
  for i, x in ipairs(b) do sum = sum + x * phi[i] end
  return sum
end

do
  local all = trees.build(6)
  local count, high, low, beyond = { 0, 0, 0, 0, 0, 0 }, true, true, { high = false, low = false }
  for _, t in ipairs(all) do
    count[t.size] = count[t.size] + 1
    local want = R.one / trees.density(t)
    local a, b = weight(T.a[7], t) == want, weight(T.low, t) == want
    if t.size <= 5 then high = high and a end
    if t.size <= 4 then low = low and b end
    if t.size == 6 and not a then beyond.high = true end
    if t.size == 5 and not b then beyond.low = true end
  end
  tap.is(table.concat(count, " "), "1 1 2 4 9 20", "rooted trees by their vertices (OEIS A000081)")
  tap.ok(high, "the kept result satisfies all 17 conditions of order 5 exactly")
  tap.ok(low, "the other all 8 of order 4")
  tap.ok(beyond.high and beyond.low, "and neither one order more")
  for i, row in ipairs(T.a) do
    local sum = R.zero
    for _, a in ipairs(row) do sum = sum + a end
    tap.ok(sum == T.c[i], "stage " .. i .. " stands at the time of its sum")
  end
end

local binary = program.quick()
local dir = program.directory()

-- The scene's motion by the emitted pair at a tolerance, by the library beside it: largest difference of the state.
local function difference(path, tolerance, real)
  local rows = {}
  for i, more in ipairs { "", string.format("--engine generated --method adaptive --tolerance %s%s", tolerance,
    real and " --real " .. real or "") } do
    local status = program.shell(string.format("POLHODE_SOURCE=. %s run %s --at 3 %s > %s/csv 2>&1", binary, path, more,
      dir))
    local text = program.read(dir .. "/csv")
    if status ~= 0 then return math.huge, text end
    rows[i] = {}
    for word in string.gmatch(string.match(text, "\n([^\n]*)"), "[^,]+") do rows[i][#rows[i] + 1] = tonumber(word) end
  end
  local d = 0.0
  for i = 2, 8 do d = math.max(d, math.abs(rows[1][i] - rows[2][i]) / (i > 5 and 10 or 1)) end
  return d
end

for _, name in ipairs { "brick", "gyroscope", "symmetric_top" } do
  local path = "bodies/" .. name .. ".lua"
  local coarse, fine = difference(path, "1e-6"), difference(path, "1e-9")
  -- some hundred steps, each with an error of at most the tolerance; the tolerance must be felt
  tap.ok(coarse <= 1e-3 and fine <= 1e-6 and fine < coarse / 30, name .. ": the error follows the tolerance",
    string.format("%.2g at 1e-6, %.2g at 1e-9", coarse, fine))
  local single = difference(path, "1e-5", "float")
  tap.ok(single <= 1e-2, name .. ": float", string.format("%.2g", single))
end

tap.done(program.finish())
