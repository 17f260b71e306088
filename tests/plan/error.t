#!/usr/bin/env lua5.4
-- error.t - the measure of an error: groups, scales, signs, and what is not finite.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Expected values are worked out by hand, with numbers whose squares and roots are exact in binary (3, 4, 5).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local err = require "generator.plan.error"

local function job(...)
  local states = {}
  for i, s in ipairs { ... } do
    local name, kind = s:match "^(%w+)=?(%w*)$"
    states[i] = { name = name, kind = kind ~= "" and kind or name }
  end
  return { states = states }
end

local top = job("qw=attitude", "qx=attitude", "qy=attitude", "qz=attitude", "wx=rates", "wy=rates", "wz=rates")

-- ---- times ----

local t = err.times(200)
tap.is(#t, 40, "40 end times")
tap.is(t[40], 200.0, "the last is the horizon itself, without a rounding")
tap.is(t[20], 190.0, "the 20th of 200 s is at 0.95 T")
tap.is(t[1] > 180 and t[1] < 180.6, true, "the first is after 0.9 T")

-- ---- groups ----

local same = { 1, 0, 0, 0, 2, 0, 0 }
tap.is(err.of(top, { same }, { same }), 0.0, "a row against itself: no error")

local e, parts, _
e, parts = err.of(top, { { 1, 0.375, 0.5, 0, 2, 0, 0 } }, { same })
tap.is(parts.attitude, 0.625, "attitude: Euclidean norm of the difference")
tap.is(parts.rates, 0.0, "nothing of it goes to the rates")
tap.is(e, 0.625, "the error is the largest group's")

_, parts = err.of(top, { { -1, 0, 0, 0, 2, 0, 0 } }, { same })
tap.is(parts.attitude, 0.0, "-q is the same attitude")

_, parts = err.of(top, { { 1, 0, 0, 0, 2, 3, 4 }, { 1, 0, 0, 0, 10, 0, 0 } },
  { same, { 1, 0, 0, 0, 10, 0, 0 } })
tap.is(parts.rates, 0.5, "rates: over the largest |w| of all reference rows, not of their own row")

_, parts = err.of(top, { { 1, 0, 0, 0, 0.75, 1, 0 } }, { { 1, 0, 0, 0, 0, 0, 0 } })
tap.is(parts.rates, 1.25, "rates that are zero in the reference count absolutely")

local more = job("rx=position", "ry=position", "rz=position", "vx=velocity", "vy=velocity", "vz=velocity", "speed",
  "charge")
e, parts = err.of(more, { { 0, 4, 0, 8, 0, 2, 1.5, 30 } }, { { 0, 8, 0, 8, 0, 0, 1, 32 } })
tap.is(parts.position, 0.5, "position by its norm")
tap.is(parts.velocity, 0.25, "velocity by its own")
tap.is(parts.speed, 0.5, "a further state by itself")
tap.is(parts.charge, 0.0625, "and each of them apart")
tap.is(table.concat(parts, " "), "position velocity speed charge", "groups in the order of the states")
tap.is(e, 0.5, "the largest of them")

-- ---- what is not finite, and extremes of scale ----

local nan = 0 / 0
tap.is(err.of(top, { { 1, 0, 0, 0, nan, 0, 0 } }, { same }), math.huge, "a NaN is an infinite error")
tap.is(err.of(top, { { nan, nan, nan, nan, 2, 0, 0 } }, { same }), math.huge, "also in the attitude, of both signs")
tap.is(err.of(top, { { 1, 0, 0, 0, math.huge, 0, 0 } }, { same }), math.huge, "so is infinity")
tap.is(err.of(top, { { 1, 0, 0, 0, 3e300, 4e300, 0 } }, { { 1, 0, 0, 0, 0, 0, 0 } }), 5e300,
  "squares do not overflow")
_, parts = err.of(top, { { 1, 0, 0, 0, 1e-300, 0, 0 } }, { { 1, 0, 0, 0, 2e-300, 0, 0 } })
tap.is(parts.rates, 0.5, "nor vanish")

local rows = err.states { { t = 0.5, x = { 1, 2 } }, { t = 1.0, x = { 3, 4 } } }
tap.is(table.concat(rows[1], " ") .. ", " .. table.concat(rows[2], " "), "1 2, 3 4", "rows without their time")

tap.done()
