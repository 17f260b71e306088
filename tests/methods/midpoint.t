#!/usr/bin/env lua5.4
-- midpoint.t - the midpoint rule: order, what it keeps over 1e5 steps, reversibility, what it refuses.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Invariants are formed by long.c from the tensor in long double, the true motion is the library's.  u = 2^-53 (2^-24):
-- a step rounds each component of w, q and of the products that turn L a few times; independent roundings of n steps
-- add to sqrt(n) of them.
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
local N = 100000
local FEW = 8 -- roundings of a step, in units of u |L|
local NORM = 4 -- |q|: a product, three sums, a root, a division, a product

local function shown(t) return t.text end

-- ---- what is kept ----

local brick = "tensor { mass = 1, xx = 2, yy = 3, zz = 4 }"
local free = {
  { brick, "" },
  { "tensor { mass = 1, xx = 3, yy = 3.5, zz = 4, xy = 0.3, xz = -0.5, yz = 0.25 }", "" },
  { "tensor { mass = 1, xx = 1, yy = 1.000000001, zz = 2 }", "", double_only = true }, -- a float cannot tell them
  { "tensor { mass = 1, xx = 1e-6, yy = 1, zz = 1 }", "" },
  { "tensor { mass = 1e20, xx = 2e20, yy = 3e20, zz = 4e20 }", "", double_only = true },
  { "tensor { mass = 1, xx = 3, yy = 3, zz = 5 }", "" },
  { "solid.sphere { r = 1, mass = 1 }", "" },
  { "rod.straight { length = 3, mass = 1 }", "" },
  { "points { {1, 0, 0, 0}, {1, 0.6, 0, 0.8} }", "" },
  { brick, "effect.rotor { axis = {3, 0, 4}, momentum = 5 }", rotor = { 3, 0, 4 } },
}
for _, c in ipairs(tier.every(4, free)) do
  for _, real in ipairs((c.double_only or tier.quick) and { "double" } or { "double", "float" }) do
    local what = c[1] .. (c.rotor and " with a rotor, " or ", ") .. real
    local build = long.build("midpoint", c[1], c[2], { real = real, rotor = c.rotor })
    local bar = FEW * U[real] * math.sqrt(N)
    for _, h in ipairs { 0.1, 0.01 } do
      local got = long.run(build, h, N)
      local keeps = got.L <= bar
      tap.ok(keeps, string.format("%s: L in space to %.1g u sqrt(steps), h = %g", what,
        got.L / (U[real] * math.sqrt(N)), h), shown(got))
      local energy = math.max(got.first[2], got.second[2], -got.first[1], -got.second[1])
      -- E is quadratic, so twice L's roundings
      tap.ok(energy <= 2 * bar, what .. ": energy to rounding", shown(got))
      tap.ok(got.norm <= NORM * U[real] and got.finite == 1, what .. ": |q| = 1", shown(got))
    end
    -- roundings of 1000 steps out, grown by the shear of neighbouring tori (linearly), and back
    local there = long.run(build, 0.05, 1000)
    tap.ok(there.back <= FEW * U[real] * 1000 * math.sqrt(1000), what .. ": steps of -h undo those of h", shown(there))
  end
end

-- ---- heavy tops ----

local top = "tensor { mass = 1, xx = 3, yy = %s, zz = 2, com = {0, 0, 0.5} }"
for _, c in ipairs(tier.every(2, { { string.format(top, 3), true }, { string.format(top, 4), true },
  { "rod.between { from = {0, 0, 0}, to = {0, 0, 1}, mass = 1 }", false } })) do
  for _, real in ipairs { "double", "float" } do
    local what = c[1] .. " and gravity, " .. real
    local build = long.build("midpoint", c[1], "effect.gravity { g = 8 }", { real = real, heavy = 4 })
    local ranges = {}
    for i, h in ipairs { 0.02, 0.01 } do
      local got = long.run(build, h, N)
      if c[2] then
        tap.ok(got.Lz <= FEW * U[real] * math.sqrt(N), what .. ": L_z to rounding", shown(got))
      end
      local a, b = got.first[2] - got.first[1], got.second[2] - got.second[1]
      ranges[i] = math.max(a, b)
      -- an error that drifted would be twice as wide, and displaced, in the second half; a chaotic top's halves visit
      -- different states
      tap.ok(got.second[1] >= 1.5 * got.first[1] - 0.5 * a and got.second[2] <= 1.5 * got.first[2] + 0.5 * a and
        got.finite == 1, what .. ": the energy of the second half stays where that of the first was", shown(got))
      tap.ok(got.norm <= NORM * U[real], what .. ": |q| = 1", shown(got))
    end
    if real == "double" then
      tap.ok(ranges[2] < ranges[1] / 3, what .. ": and its range is of order h^2",
        string.format("%.3g, %.3g", ranges[1], ranges[2]))
    end
  end
end

-- ---- at rest; steps that are far too large ----

do
  local rest = long.build("midpoint", brick, "", { start = "omega = {0, 0, 0}" })
  local got = long.run(rest, 0.1, 100)
  tap.ok(got.rate == 0 and got.L == 0 and got.back == 0 and got.finite == 1, "at rest: stays", shown(got))
  local build = long.build("midpoint", brick, "", {})
  for _, h in ipairs { 1, 3, 100, 1e6 } do
    got = long.run(build, h, 1000)
    tap.ok(got.finite == 1 and got.norm <= NORM * U.double and got.L <= FEW * U.double * 1000,
      string.format("h = %g: the motion is wrong, |q| and L are kept", h), shown(got))
  end
end

-- ---- order ----

for _, c in ipairs(tier.every(3, { { "a brick", brick, "" }, { "a rod", "rod.straight { length = 3, mass = 1 }", "" },
  { "a heavy top", string.format(top, 4), "effect.gravity { g = 8 }" },
  { "a heavy rod", "rod.between { from = {0, 0, 0}, to = {0, 0, 1}, mass = 1 }", "effect.gravity { g = 8 }" },
  { "a damped brick with torque and rotor", brick, "effect.damping { c = {0.1, 0.2, 0.3} }, " ..
    "effect.torque { body = {0.5, -0.25, 0.125} }, effect.rotor { axis = {3, 0, 4}, momentum = 5 }" } })) do
  local e, why = long.errors("midpoint", long.scene(c[2], c[3]), { 0.02, 0.01, 0.005 }, 3)
  if tap.ok(e, c[1] .. ": runs", why) then
    -- e = a h^2 + b h^4: 4 up to h^2
    for i = 1, 2 do
      local ratio = e[i] / e[i + 1]
      tap.ok(ratio > 3.7 and ratio < 4.3, string.format("%s: halving the step divides the error by %.3f", c[1], ratio))
    end
  end
end

-- ---- what it cannot do ----

for _, c in ipairs { { "effect.translation { gravity = {0, 0, -9.81} }", "moves through space" } } do
  local job = assert(scene.read('return scene { name = "top", body = solid.sphere { r = 1, mass = 1 }, effects = { ' ..
    c[1] .. " }, initial = { omega = {1, 0, 0} } }\n"))
  local plan, d = driver.plan(job, { command = "", methods = { "midpoint" } })
  tap.ok(not plan and string.find(d:report(), c[2], 1, true), "refused: " .. c[2], d:report())
end

program.finish()
tap.done()
