#!/usr/bin/env lua5.4
-- least.t - the emitted right-hand side takes the operations of the equations written down by hand, no more.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The minimum by hand, constants of the parameters free (they are computed once), a sign free:
--
-- Attitude, q' = q (0, w)/2: with the halves of the rates (3 products) 4 sums of 3 products each: 15 *, 8 +.
--
-- Heavy symmetric top, centre of mass on the axis z, with k = (I3 - I1)/I1 and G = 2 m g l/I1:
--     Omega = k wz
--     wx' = G (qw qx + qy qz) - Omega wy        wy' = G (qw qy - qx qz) + Omega wx        wz' = 0
-- as N = l ez x m g d, d = -(2 (qx qz - qw qy), 2 (qy qz + qw qx), ..) the direction of gravity in body axes.
-- 1 + 2 (2 + 1 + 1) = 9 *, 2 (1 + 1) = 4 +.  With the attitude 24 *, 12 +.
--
-- Brick on its principal axes, linear damping C = diag(C1, C2, C3), or one number, or -rate L:
--     w1' = c1 w2 w3 - (C1/I1) w1, cyclic       3 (2 + 1) = 9 *, 3 +; with the attitude 24 *, 11 +.
--
-- Satellite on its principal axes, circular orbit of rate n in the inertial x-y plane; o the vertical in body axes,
-- K = 3 mu/r^3, and N1 = K (I3 - I2) o2 o3, so w1' = c1 (w2 w3 - K o2 o3), cyclic.
-- With p the attitude seen from the orbit, p = (cos(n t/2) - k sin(n t/2)) q, 8 *, 4 +, the angle 1 *, 2 calls,
-- o is the first row of R(p): o1 = 1 - 2 b, o2 = 2 a2, o3 = 2 a3 with b = py^2 + pz^2, a2 = px py - pw pz,
-- a3 = px pz + pw py: 6 *, 3 +.  With A = 4 K a2 and B = 2 K - 4 K b, 2 *, 1 +, the products K o2 o3 = A a3,
-- K o3 o1 = B a3, K o1 o2 = B a2 are 3 *; w2 w3 and c1 and the difference for each component 6 *, 3 +.
-- 26 *, 11 +, 2 calls; with the attitude 41 *, 19 +, 2 calls.  With numbers for parameters B is a number times
-- 1 - 2 b, in two products, and what it multiplies takes the number along: 43 *.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local effects = require "generator.effects.effects"
local attribution = require "generator.report.attribution"

local BRICK = 'solid.box { x = param("a", 0.2, "m"), y = param("b", 0.1, "m"), z = param("c", 0.05, "m"), ' ..
  'mass = param("M", 2.4, "kg") }'
local TOP = 'solid.cone { r = param("r", 0.05, "m"), h = param("h", 0.1, "m"), mass = 1 }:turned { axis = "x", ' ..
  "angle = pi }"

-- {what, body, effect, more, by hand: operations of all; of these the effect's; numbers = operations with numbers}
local rows = {
  { "free brick", BRICK, "", "", { mul = 21, add = 8 } },
  { "heavy symmetric top", TOP, "effect.gravity {}", 'origin = "apex"', { mul = 24, add = 12 }, { mul = 6, add = 4 } },
  { "brick damped along each axis", BRICK, 'effect.damping { c = { param("p", 1, "N m s"), param("q", 2, "N m s"), ' ..
    'param("s", 3, "N m s") } }', "", { mul = 24, add = 11 }, { mul = 3, add = 3 } },
  { "brick damped alike", BRICK, 'effect.damping { c = param("p", 1, "N m s") }', "", { mul = 24, add = 11 },
    { mul = 3, add = 3 } },
  { "brick whose L is damped", BRICK, 'effect.damping { rate = param("p", 1, "1/s") }', "", { mul = 24, add = 11 },
    { mul = 3, add = 3 } },
}
for _, e in ipairs(effects) do
  if e.name == "effect.gravity_gradient" then
    rows[#rows + 1] = { "satellite", BRICK, 'effect.gravity_gradient { mu = param("mu", 3.986e14, "m^3/s^2"), ' ..
      'orbit = { radius = param("R", 7e6, "m") } }', "",
      { mul = 41, add = 19, call = 2 }, { mul = 20, add = 11, call = 2 },
      numbers = { mul = 43, add = 19 } }
  end
end

local function words(c) return attribution.words(c) end

for _, row in ipairs(rows) do
  for _, bake in ipairs { false, true } do
    local what = row[1] .. (bake and ", numbers" or "")
    local job, why = scene.read("local s = scene { name = \"b\", body = " .. row[2] .. ",\n  effects = {" .. row[3] ..
      "}, initial = { omega = {1, 2, 3} },\n  " .. row[4] .. " }\nreturn s\n", { bake = bake })
    if tap.ok(job ~= nil, what .. ": is a scene", why) then
      job = scene.plan(job, { real = "double" })
      local cost = attribution.cost(job, scene.description(job, "rhs"))
      if bake then -- a number may be 1, so there may be less to do
        local most = row.numbers or row[5]
        tap.ok(cost.mul <= most.mul and cost.add <= most.add and cost.div == 0, what .. ": no more than by hand: " ..
          words(cost))
      else
        tap.is(words(cost), words(row[5]), what .. ": as by hand")
      end
      local a = attribution.of(job)
      local sum, parts = {}, { table.unpack(a.rows) }
      if a.shared then parts[#parts + 1] = { cost = a.shared } end
      for _, r in ipairs(parts) do
        for _, c in ipairs(attribution.classes) do sum[c] = (sum[c] or 0) + r.cost[c] end
      end
      -- with --bake: of the numbers' form; emitted may be the one with constants by their names, where it costs less
      tap.is(words(sum), words(bake and a.total or cost), what .. ": the rows of the table add up to the whole")
      tap.ok(cost.mul <= a.total.mul and cost.add <= a.total.add, what .. ": which is no less than what is emitted")
      if row[6] and not bake then
        tap.is(words(a.rows[#a.rows].cost), words(row[6]), what .. ": what the effect makes of it")
      end
    end
  end
end

-- Of two effects each has its own: |w| of drag is the one root.
do
  local job = scene.plan(assert(scene.read [[local brick = solid.box { x = 3, y = 2, z = 1, mass = 1 }
return scene { name = "b", body = brick,
    effects = { effect.damping { rate = 0.1 }, effect.drag { c = 0.2 } } }]]), { real = "double" })
  local own = {}
  for _, r in ipairs(attribution.of(job).rows) do own[r.name] = r.cost.sqrt end
  tap.is(own.damping, 0, "of damping and drag the first takes no root")
  tap.is(own.drag, 1, "the second takes one")
end

tap.done()
