#!/usr/bin/env lua5.4
-- lagrange.t -- when the heavy top's closed form applies, and what is said where it does not.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"

local gravity = "effects = { effect.gravity{} }"

local function detected(shape, params, more) return assert(scene.body(shape, params, more)).closed end

local function accepted(what, shape, params, more)
  local form = detected(shape, params, more)
  tap.is(form.kind, "lagrange", what .. ": the heavy symmetric top", form.refused)
end

local function refused(what, reason, shape, params, more)
  local form = detected(shape, params, more)
  tap.is(form.kind, nil, what .. ": no closed form")
  tap.ok(form.refused and string.find(form.refused, reason, 1, true), what .. ": says why", form.refused)
end

accepted("a cone on its tip", "solid.cone{ r = r, h = h, mass = M }", { "r", "h", "M" },
  "origin = {0, 0, h}, " .. gravity)
accepted("a rod about a point of its line", "rod.straight{ length = a, mass = M }", { "a", "M" },
  "origin = {0, 0, -a/2}, " .. gravity)
accepted("gravity along any direction", "solid.cylinder{ r = r, h = h, mass = M }", { "r", "h", "M" },
  "origin = {0, 0, h}, effects = { effect.gravity{ direction = {1, 2, h/r} } }")
accepted("an oblique axis: a cube on its corner", "solid.box{ x = a, y = a, z = a, mass = M }", { "a", "M" },
  'origin = "corner", ' .. gravity)
tap.is(detected("solid.cylinder{ r = r, h = h, mass = M }", { "r", "h", "M" }, gravity).kind, "symmetric",
  "a cylinder about its centroid feels no weight: free")
accepted("a sphere held elsewhere", "solid.sphere{ r = r, mass = M }", { "r", "M" },
  "origin = {r, 2*r, 3*r}, " .. gravity)
accepted("equal moments about the origin, the centre of mass anywhere", "tensor{ mass = M, com = {a, 2*a, a}, " ..
  "about = 'origin', xx = k*M*a^2, yy = k*M*a^2, zz = k*M*a^2, xy = 0, xz = 0, yz = 0 }", { "a", "M", "k = 99" },
  "origin = {0, 0, 0}, " .. gravity)

refused("a box", "no two moments about the origin of rotation are equal", "solid.box{ x = a, y = b, z = c, mass = M }",
  { "a", "b", "c", "M" }, 'origin = "corner", ' .. gravity)
refused("the axis beside the centre of mass", "its centre of mass is not on the symmetry axis",
  "tensor{ mass = M, com = {a, 0, 0}, about = 'origin', xx = k*M*a^2, yy = k*M*a^2, zz = 5*M*a^2, xy = 0, xz = 0, " ..
  "yz = 0 }", { "a", "M", "k = 9" }, "origin = {0, 0, 0}, " .. gravity)
refused("gravity and damping", "not gravity alone", "solid.cone{ r = r, h = h, mass = M }", { "r", "h", "M" },
  "origin = {0, 0, h}, effects = { effect.gravity{}, effect.damping{ c = 1 } }")
refused("gravity twice", "write it as one", "solid.cone{ r = r, h = h, mass = M }", { "r", "h", "M" },
  "origin = {0, 0, h}, effects = { effect.gravity{}, effect.gravity{} }")

local free = detected("solid.cone{ r = r, h = h, mass = M }", { "r", "h", "M" })
local told
for _, o in ipairs(free.others) do
  if o.name == "heavy symmetric top (Lagrange)" then told = o.reason end
end
tap.is(told, "no gravity acts", "a free body: no gravity acts")

tap.done()
