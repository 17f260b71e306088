#!/usr/bin/env lua5.4
-- semi.t - the semi-implicit step: order, what it keeps over 1e5 steps, every kind of state, its cost.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- As in midpoint.t; w* is one Newton iteration, so energy is kept to the order of the method only, L in space still to
-- rounding.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local driver = require "generator.driver"
local long = require "tests.methods.long"

local U = { double = 2.0 ^ -53, float = 2.0 ^ -24 }
local N, FEW, NORM = 100000, 8, 8 -- |q|: the roundings of two steps, as in its Newton step for 1/|q|

local brick = "tensor { mass = 1, xx = 2, yy = 3, zz = 4 }"
local top = "tensor { mass = 1, xx = 3, yy = %s, zz = 2, com = {0, 0, 0.5} }"

for _, c in ipairs(tier.every(4, { { brick, "" }, { "rod.straight { length = 3, mass = 1 }", "" },
  { "solid.sphere { r = 1, mass = 1 }", "" }, { "tensor { mass = 1, xx = 3, yy = 3, zz = 5 }", "", exact = true },
  { "tensor { mass = 1, xx = 3, yy = 3.5, zz = 4, xy = 0.3, xz = -0.5, yz = 0.25 }", "" },
  { brick, "effect.rotor { axis = {3, 0, 4}, momentum = 5 }", rotor = { 3, 0, 4 }, drifts = true } })) do
  for _, real in ipairs(tier.every(2, { "double", "float" })) do
    local what = c[1] .. (c.rotor and " with a rotor, " or ", ") .. real
    local build = long.build("semi", c[1], c[2], { real = real, rotor = c.rotor })
    local bar = FEW * U[real] * math.sqrt(N)
    local got = long.run(build, 0.05, N)
    tap.ok(got.L <= bar, string.format("%s: L in space to %.1g u sqrt(steps)", what,
      got.L / (U[real] * math.sqrt(N))), got.text)
    tap.ok(got.norm <= NORM * U[real] and got.finite == 1, what .. ": |q| = 1", got.text)
    local a = got.first[2] - got.first[1]
    if c.exact then
      tap.ok(a <= 2 * bar and got.second[2] - got.second[1] <= 2 * bar, what .. ": energy to rounding", got.text)
    elseif not c.drifts then -- a rotor's term is not Kahan's case: energy drifts with h^4
      tap.ok(got.second[1] >= 1.5 * got.first[1] - 0.5 * a - bar and
        got.second[2] <= 1.5 * got.first[2] + 0.5 * a + bar,
        what .. ": the energy of the second half stays where that of the first was", got.text)
    end
  end
end

for _, c in ipairs(tier.every(2, { { string.format(top, 3) }, { string.format(top, 4) },
  { "rod.between { from = {0, 0, 0}, to = {0, 0, 1}, mass = 1 }" } })) do
  local what = c[1] .. " and gravity"
  local build, ranges = long.build("semi", c[1], "effect.gravity { g = 8 }", { heavy = 4 }), {}
  for i, h in ipairs { 0.01, 0.005 } do
    local got = long.run(build, h, N)
    tap.ok(got.Lz <= FEW * U.double * math.sqrt(N), what .. ": L_z to rounding", got.text)
    local a, b = got.first[2] - got.first[1], got.second[2] - got.second[1]
    ranges[i] = math.max(a, b)
    tap.ok(got.second[1] >= 1.5 * got.first[1] - 0.5 * a and got.second[2] <= 1.5 * got.first[2] + 0.5 * a and
      got.finite == 1, what .. ": the energy of the second half stays where that of the first was", got.text)
  end
  tap.ok(ranges[2] < ranges[1] / 1.7, what .. ": and its range is of order h",
    string.format("%.3g, %.3g", ranges[1], ranges[2]))
end

do
  local got = long.run(long.build("semi", brick, "", { start = "omega = {0, 0, 0}" }), 0.1, 100)
  tap.ok(got.rate == 0 and got.back == 0 and got.finite == 1, "at rest: stays", got.text)
end

-- order 2 without torque, 1 with
for _, c in ipairs(tier.every(3, { { "a brick", brick, "", 4 },
  { "a rod", "rod.straight { length = 3, mass = 1 }", "", 4 },
  { "a heavy top", string.format(top, 4), "effect.gravity { g = 8 }", 2 },
  { "a damped brick with torque and rotor", brick, "effect.damping { c = {0.1, 0.2, 0.3} }, " ..
    "effect.torque { body = {0.5, -0.25, 0.125} }, effect.rotor { axis = {3, 0, 4}, momentum = 5 }", 2 } })) do
  local e, why = long.errors("semi", long.scene(c[2], c[3]), { 0.002, 0.001, 0.0005 }, 1)
  if tap.ok(e, c[1] .. ": runs", why) then
    for i = 1, 2 do
      local ratio = e[i] / e[i + 1]
      tap.ok(math.abs(ratio - c[4]) < 0.1 * c[4], string.format("%s: halving the step divides the error by %.3f", c[1],
        ratio))
    end
  end
end

-- position, velocity and a turning frame
for _, name in ipairs(tier.every(3, { "thrown_book", "foucault", "dropped_stone", "spun_up_top", "tumbling_box" })) do
  local text = scene.slurp("bodies/" .. name .. ".lua")
  local e, why = long.errors("semi", text, { 0.002, 0.001, 0.0005 }, 1)
  if tap.ok(e, name .. ": runs", why) then
    -- position by the new velocity: x = v t + g t (t + h)/2, first order
    tap.ok(e[1] / e[2] > 1.8 and e[2] / e[3] > 1.8, name .. ": first order", string.format("%g %g %g", e[1], e[2],
      e[3]))
  end
end

-- one evaluation: fewer operations than RK4's four, where a torque costs anything
for _, c in ipairs(tier.every(2, { { string.format(top, 3), "effect.gravity { g = 8 }" },
  { brick, "effect.damping { c = 0.1 }" } })) do
  local cost = {}
  for i, method in ipairs { "semi", "rk4" } do
    local job = assert(scene.read(long.scene(c[1], c[2])))
    job = driver.plan(job, { command = "", methods = { method } })
    local line = string.match(scene.files(job)["top.h"], "Operations of step: ([^\n]*)")
    cost[i] = 0
    for n in string.gmatch(line, "%d+") do cost[i] = cost[i] + tonumber(n) end
  end
  tap.ok(cost[1] < cost[2], string.format("%s: %d operations, RK4 has %d", c[2], cost[1], cost[2]))
end

program.finish()
tap.done()
