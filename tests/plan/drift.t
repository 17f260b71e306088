#!/usr/bin/env lua5.4
-- drift.t - the drift of conserved quantities: what is compared with what.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The plugin is made up: energy is wx^2, the momentum (wx, wy, wz).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local drift = require "generator.plan.drift"

local job = { states = { { name = "wx" }, { name = "wy" }, { name = "wz" } } }
local plugin = {
  info = function() return { has = { energy = true, momentum = true } } end,
  energy = function(_, x) return x[1] * x[1] end,
  momentum = function(_, x) return x end,
}

local function of(laws, x0, ...)
  local is = {}
  for _, law in ipairs(laws) do is[law] = true end
  job.conserved = { is = is }
  return drift.of(job, plugin, x0)({ ... })
end

local all = { "T+V", "|L|", "L", "L_z", "w3" }
-- powers of two and 3-4-5: every number here is exact
local d = of(all, { 3.0, 0.0, 4.0 }, { 3.0, 0.0, 4.0 }, { 5.0, 0.0, 0.0 })
tap.is(d["T+V"], 16 / 9, "energy relative to its start")
tap.is(d["|L|"], 0.0, "a vector that only turns keeps its length")
tap.is(d.L, math.sqrt(4 + 16) / 5, "but not itself: the difference over its length")
tap.is(d.L_z, 4 / 5, "a component goes by the length of the whole")
tap.is(d.w3, 4 / 5, "so does a rate")
d = of(all, { 3.0, 0.0, 4.0 }, { 3.0, 8.0, 4.0 }, { 3.0, 0.0, 4.0 })
tap.is(d.L, 8 / 5, "the largest of the rows counts")
d = of({ "T+V" }, { 0.0, 0.0, 1.0 }, { 0.5, 0.0, 1.0 })
tap.is(d["T+V"], 0.25, "what was zero goes absolutely")
tap.ok(d.L == nil and d.w3 == nil, "laws that the scene does not have are left out")
d = of({ "T+V" }, { 1.0, 0.0, 1.0 }, { 0 / 0, 0.0, 1.0 }, { 1.0, 0.0, 1.0 })
tap.is(d["T+V"], math.huge, "what is no number is an infinite drift")
tap.done()
