#!/usr/bin/env lua5.4
-- reference.t - mass, centroid and tensors of bodies against exact values integrated elsewhere.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The table and its provenance: tests/reference/inertia.lua. Values with pi and roots are compared as rational
-- functions
-- of them, so equality of the numbers is equality of the functions, and there is no tolerance; those with hyperbolic
-- functions to 500 bits.  Each row is also held against the 34 digits of tests/reference/inertia.h, so that neither
-- table is copied wrongly.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local rows = require "tests.reference.inertia"
local exact = require "tests.reference.exact"

local function same(got, want)
  for i, w in ipairs(want) do
    local v = exact.value(w)
    local equal = exact.transcendental(w) and scene.same(got[i], v)
    if not equal and not (not exact.transcendental(w) and ratio.iszero(got[i] - v)) then
      return false, "entry " .. i .. ": " .. text.of(got[i]) .. " instead of " .. w
    end
  end
  return true
end

-- the comparison can fail
tap.ok(not same({ expr.pi }, { "355/113" }) and same({ expr.pi ^ 2 * 3 / 4 }, { "pi**2*3/4" }),
  "355/113 is not pi, and pi**2*3/4 is 3 pi^2/4")
tap.ok(same({ expr.call("sinh", expr.one) }, { "(E - exp(-1))/2" }) and
  not same({ expr.call("sinh", expr.one) }, { "(E - exp(-1))*(1/2 + 1/10**140)" }), "and sinh 1 is (e - 1/e)/2")

local digits = exact.decimals "tests/reference/inertia.h"

-- Do the exact values have these decimals?  34 digits: half a unit of the last is below 10^-33 of the value.
local function spelled(want, decimals)
  for i, w in ipairs(want) do
    local v = evaluate.precise(exact.value(w), {}, 240)
    local d = R.abs(v - decimals[i])
    if R.sign(d) ~= 0 and d > R.abs(v) * R.parse "1e-33" then return false, w .. " is not " .. tostring(decimals[i]) end
  end
  return true
end

local seen = 0
for _, row in ipairs(rows) do
  seen = seen + 1
  local m = assert(scene.body(row.body, {}, "origin = {0, 0, 0}")).model
  tap.ok(same({ m.mass }, { row.mass }), row.id .. ": mass")
  tap.ok(same(m.com, row.centroid), row.id .. ": centroid")
  tap.ok(same(m.centroidal, row.tensor), row.id .. ": tensor about the centroid")
  m = assert(scene.body(row.body, {}, "origin = " .. exact.point(row))).model
  tap.ok(same(m.inertia, row.about), row.id .. ": tensor about the second point")
  local d = digits[row.id]
  tap.ok(spelled({ row.mass }, { d.mass }) and spelled(row.centroid, d.centroid) and spelled(row.tensor, d.tensor) and
    spelled(row.about, d.about), row.id .. ": the exact values have the 34 digits of the other table")
  if row.how then tap.diag(row.id .. " is not said as what it is: " .. row.how) end
end
local all = 0
for _ in pairs(digits) do all = all + 1 end -- counted: in any order
tap.is(seen, all, "every body of the reference set is here")

tap.done()
