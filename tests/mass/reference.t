#!/usr/bin/env lua5.4
-- reference.t - mass, centroid and tensors of bodies against exact values integrated elsewhere.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The table and its provenance: tests/reference/inertia.lua.  Values with pi are compared as rational functions of
-- pi, which is transcendental, so equality of the numbers is equality of the functions: no tolerance anywhere.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local text = require "generator.algebra.text"
local rows = require "tests.reference.inertia"

-- The expression that a sympy text denotes; whole numbers must not become doubles on the way.
local function value(s)
  local lua = "return " .. s:gsub("%*%*", "^"):gsub("%d+", 'n"%0"')
  return expr.lift(assert(load(lua, lua, "t", { n = expr.lift, pi = expr.pi, sqrt = expr.sqrt }))())
end

local function same(got, want)
  for i, w in ipairs(want) do
    if not ratio.iszero(got[i] - value(w)) then
      return false, "entry " .. i .. ": " .. text.of(got[i]) .. " instead of " .. w
    end
  end
  return true
end

-- the comparison can fail
tap.ok(not same({ expr.pi }, { "355/113" }) and same({ expr.pi ^ 2 * 3 / 4 }, { "pi**2*3/4" }),
  "355/113 is not pi, and pi**2*3/4 is 3 pi^2/4")

for _, row in ipairs(rows) do
  local m = assert(scene.body(row.body, {}, "origin = {0, 0, 0}")).model
  tap.ok(same({ m.mass }, { row.mass }), row.id .. ": mass")
  tap.ok(same(m.com, row.centroid), row.id .. ": centroid")
  tap.ok(same(m.centroidal, row.tensor), row.id .. ": tensor about the centroid")
  local point = table.concat(row.point, ", "):gsub("([%w/]+)", 'exact("%1")')
  m = assert(scene.body(row.body, {}, "origin = {" .. point .. "}")).model
  tap.ok(same(m.inertia, row.about), row.id .. ": tensor about the second point")
end

tap.done()
