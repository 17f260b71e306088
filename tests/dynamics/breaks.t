#!/usr/bin/env lua5.4
-- breaks.t - where the equations of motion are not smooth: times that are known, expressions that vanish at others.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Expected: the laws as the scenes write them; the cosine of a plate's normal to the sun by the rotation matrix.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local breaks = require "generator.dynamics.breaks"
local switching = require "generator.dynamics.switching"
local evaluate = require "generator.algebra.evaluate"

local function equations(effects)
  local job = assert(scene.read("local k = param(\"k\", 2, \"N m\")\nreturn scene { name = \"s\", " ..
    "body = solid.box { x = 1, y = 2, z = 3, mass = 4 },\n  effects = { " .. effects .. " },\n" ..
    "  initial = { omega = { 1, 2, 3 } } }\n"))
  job = scene.plan(job)
  return job.equations
end

local env = { k = 2.0, qw = 0.5, qx = 0.1, qy = -0.7, qz = 0.5, wx = 1.5, wy = -2.5, wz = 0.25, t = 3.0 }

-- The first known time and the values of what else may vanish.
local function found(effects)
  local eq, values = equations(effects), {}
  local first = breaks.first(eq)
  for i, e in ipairs(switching.corners(eq)) do values[i] = evaluate.double(e, env) end
  return first and R.todouble(first), values
end

local function has(effects, first, values, what)
  local time, got = found(effects)
  tap.is(time, first, what .. ": the first time that is known")
  tap.is(#got, #values, what .. ": how many corners besides")
  for i, want in ipairs(values) do
    -- of either sign, without its content (1/5 to 2): only the zeros are asked for; 16 roundings of numbers below 4
    tap.near(math.abs(got[i] or 0), math.abs(want), 16 * 4 * 2.0 ^ -53, 0, what .. ": corner " .. i,
      "a quotient of products in 64 bits and its double")
  end
end

has("", nil, {}, "nothing")
has("effect.torque { body = {0, k*sin(t), 0} }", nil, {}, "a smooth torque")
has("effect.torque { body = {0, 0, {{-1, 0}, {1/2, 2}, {2, 0}}} }", 0.5, {}, "a table")
has("effect.custom { torque = function(s) return { k*abs(s.q[2] - 1/4), 0, 0 } end }", nil, { 4 * env.qx - 1 },
  "bars about a state")
has("effect.custom { torque = function(s) return { k*abs(sin(s.t)), 0, 0 } end }", nil, { math.sin(3) },
  "bars about a sine of time")
local qw, qx, qy, qz = env.qw, env.qx, env.qy, env.qz
local s = { 2 * (qx * qy + qw * qz), qw ^ 2 - qx ^ 2 + qy ^ 2 - qz ^ 2, 2 * (qy * qz - qw * qx) } -- R^T (0, 1, 0)
has("effect.solar_pressure { sun = {0, 3, 0}, plates = { { area = 1, normal = {1, 0, 0}, centre = {0, 1, 0} }, " ..
  "{ area = 2, normal = {0, 3, 4}, centre = {0, 1, 0} } } }", nil, { 3 * s[2] + 4 * s[3], s[1] / 2 }, "sunlight")
-- of choices: a - b of min and max, x - low and high - x of limits, and what stands inside is on its side: |qx| = qx
has("effect.custom { torque = function(s) return { k*min(abs(s.q[2]), max(s.q[3], 1/4)), 0, 0 } end }", nil,
  { env.qx, 4 * env.qy - 1, 2 * (4 * env.qx - 1) }, "the smaller and the larger")
has("effect.custom { torque = function(s) return { k*sign(s.t - 4*quantity(1, \"s\")), 0, 0 } end }", nil,
  { 1 }, "a sign of time")

tap.done()
