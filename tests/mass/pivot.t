#!/usr/bin/env lua5.4
-- pivot.t - a top of which the moments about its pivot and M g l are known: the motion is that of every mass.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: Lagrange's top in the textbook's own numbers (I1, I3, M g l: Goldstein, Poole, Safko, section 5.7), and the
-- least mass by hand: a lamina through the centre of mass, I1 - M l^2 = I3/2.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"

local I1, I3, Mgl, g = R.parse "0.002", R.parse "0.0008", R.parse "0.15", R.parse "9.81"

local function text(mass, more)
  return string.format([[
local g = quantity("9.81", "m/s^2")
local I1, I3 = param("I1", %s, "kg m^2"), param("I3", %s, "kg m^2")
local Mgl, M = param("Mgl", "0.15", "N m"), quantity(%q, "kg")
return scene { name = "top",
  body = tensor { mass = M, com = {0, 0, Mgl/(M*g)}, xx = I1, yy = I1, zz = I3, about = "origin" },
  origin = {0, 0, 0}, effects = { effect.gravity { g = g } },
  initial = { attitude = { axis = "x", angle = 0.5 }, omega = {0, 0, 200} }, %s }
]], "\"0.002\"", "\"0.0008\"", mass, more or "")
end

-- The rates of change, and the constants of the closed form, in the parameters alone.
local function motion(mass)
  local job = assert(scene.read(text(mass)))
  local plan = assert(scene.plan(job, { real = "double" }))
  local map, constants = {}, {}
  for _, member in ipairs(plan.model.members) do map[member.sym] = member.e end
  for name, e in pairs(plan.closed_constants) do constants[name] = calculus.substitute(e, map) end -- a set
  return job, scene.rates(plan), constants
end

local job, rates, constants = motion "1"
tap.is(job.closed.kind, "lagrange", "it has the closed form of the heavy symmetric top")
local e = { I1 = I1, I3 = I3, Mgl = Mgl }
for name, want in pairs { I1 = I1, I3 = I3, Mgk = Mgl } do -- three tests, in any order
  tap.ok(scene.exact(constants[name], e) == want, "the closed form's " .. name .. " is what was given")
end

local _, heavy, other = motion "7"
local wrong = {}
for name, rate in pairs(rates) do
  if not ratio.iszero(rate - heavy[name]) then wrong[#wrong + 1] = name end
end
for name, c in pairs(constants) do
  if not ratio.iszero(expr.lift(c) - other[name]) then wrong[#wrong + 1] = name end
end
tap.is(table.concat(wrong, " "), "", "a mass of 7 kg has the equations and the closed form of 1 kg")

-- Euler's equations of the top: I1 w1' = (I1 - I3) w2 w3 + Mgl u.y2, u = R^T z, written out here.
local point = { I1 = I1, I3 = I3, Mgl = Mgl, qw = R.new(1, 2), qx = R.new(1, 2), qy = R.new(-1, 2), qz = R.new(1, 2),
  wx = R.new(3), wy = R.new(-2), wz = R.new(11) }
local function value(x) return scene.exact(x, point) end
local up = { R.new(2) * (point.qx * point.qz - point.qw * point.qy),
  R.new(2) * (point.qy * point.qz + point.qw * point.qx) }
tap.ok(value(rates.wx) == ((I1 - I3) * point.wy * point.wz + Mgl * up[2]) / I1, "I1 w1' = (I1 - I3) w2 w3 + M g l u2")
tap.ok(value(rates.wy) == ((I3 - I1) * point.wz * point.wx - Mgl * up[1]) / I1, "I1 w2' = (I3 - I1) w3 w1 - M g l u1")
tap.ok(value(rates.wz) == R.zero, "w3' = 0")

---- the least mass ----

local least = R.todouble((Mgl / g) ^ 2 / (I1 - I3 / R.new(2)))
tap.ok(scene.read(text(string.format("%.12f", least * (1 + 1e-6)))), "a mass above the least one is taken", least)
local job2, why = scene.read(text(string.format("%.12f", least * (1 - 1e-6))))
tap.ok(not job2, "one below it is not")
local said = why and tonumber(why:match "mass is too small %(with the same mass%*com, ([%d.e-]+) kg and more")
tap.ok(said and said >= least and said < 1.02 * least, "and the message says which would do", why)
local _, broken = scene.read((text "1":gsub('"0.0008"', '"0.0042"')))
tap.ok(broken and broken:find "triangle inequality" and not broken:find "mass is too small",
  "moments that no mass makes a body: I3 > 2 I1", broken)

tap.done()
