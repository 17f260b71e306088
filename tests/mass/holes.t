#!/usr/bin/env lua5.4
-- holes.t - a hole lies inside the body it is cut from, is of its kind and no denser.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"

-- The messages of a body: its errors, or its warnings.
local function said(shape, params)
  local job, why = scene.body(shape, params)
  if not job then return why end
  local list = {}
  for i, w in ipairs(job.diag.warnings) do list[i] = "warning " .. w.message end
  return table.concat(list, "\n")
end

local function quiet(shape, name, params) return tap.is(said(shape, params), "", name) end
local function told(shape, part, name, params) return tap.like(said(shape, params), part, name) end

local function box(size) return "solid.box { x = " .. size .. ", y = 1, z = 1, density = 1 }" end
local function drill(r, h) return string.format("solid.cylinder { r = %s, h = %s, density = 1 }", r, h) end
local BOX = box(1)

-- ---- flush is inside ----

quiet(BOX .. " - " .. drill("0.1", "1"), "a hole right through, flush at both ends")
quiet(BOX .. " - " .. BOX:gsub("x = 1", "x = 0.5") .. ":at{0.25, 0, 0}", "half a box, flush on five faces")
quiet("(" .. BOX .. " - " .. drill("0.1", "1") .. "):at{1e6, 1e6, 0}:turned{axis = {1, 2, 3}, angle = 1}",
  "the whole far away and turned")
quiet(BOX .. ":at{1e6, 1e6, 0}:turned{axis = {1, 2, 3}, angle = 1} - " .. drill("0.1", "1") ..
  ":at{1e6, 1e6, 0}:turned{axis = {1, 2, 3}, angle = 1}",
    "body and hole each far away and turned: only rounding differs")
quiet("solid.cylinder { r = 1e3, h = 1, density = 1 } - " .. drill("1e-2", "1") .. ":at{9e2, 0, 0}",
  "a hole of a centimetre far out in a plate of 2 km")
quiet("solid.sphere { r = 1, density = 1 } - solid.sphere { r = 0.5, density = 1 }:at{0.5, 0, 0}", "balls that touch")
quiet(BOX .. " - (" .. drill("0.1", "1") .. " - " .. drill("0.05", "1") .. ")", "a hole that leaves a core")
quiet("solid.tube { r_in = 1, r_out = 2, h = 1, density = 1 } - " ..
  "solid.tube { r_in = 1, r_out = 1.5, h = 1, density = 1 }",
  "a tube's inner layer, its inner rims round")
quiet(box "2" .. " + " .. box "2" .. ":at{2, 0, 0} - " .. drill("0.1", "1") .. ":at{1, 0, 0}",
  "a hole across the joint of two boxes")
quiet("plate.rectangle { x = 1, y = 1, density = 1 } - plate.disc { r = 0.5, density = 1 }", "a disc in a plate")
quiet("rod.straight { length = 2, density = 1 } - rod.straight { length = 1, density = 1 }:at{0, 0, 0.5}",
  "a piece of a rod")
quiet("points { {1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0} } - points { {1, 0, 1, 0} }", "a particle taken away")
quiet(BOX .. " - solid.cylinder { r = s, h = 1, density = 1 }", "with parameters, at their defaults", { "s = 0.5" })

-- ---- what reaches out ----

told(BOX .. " - " .. drill("0.1", "1.02"),
  "hole: must lie inside the body it is cut from, got the point (0, 0, -0.51) " ..
  "of the hole (line 2), 0.01 m outside", "a drill longer than the plate")
told(BOX .. " - " .. drill("0.1", "1.000001"), "5e-07 m outside", "by half a millionth")
told(BOX .. " - " .. drill("0.1", "0.5") .. ":at{5, 0, 0}", "m outside", "a hole beside the body")
told(BOX .. " - " .. BOX .. ":at{-5, 0, 5}", "m outside", "or far from it, along two axes")
told(BOX .. " - solid.cylinder { r = s, h = 1, density = 1 }", "0.1 m outside", "a parameter's default too large",
  { "s = 0.6" })
told(BOX .. " - " .. drill("0.1", "1") .. " - " .. drill("0.1", "1") .. ":at{0.15, 0, 0}", "m outside",
  "two holes that overlap: the second takes what is no longer there")
told(BOX .. " - solid.sphere { r = 0.1, density = 1 } - solid.sphere { r = 0.2, density = 1 }", "m outside",
  "a hole around a cavity")
told("solid.tube { r_in = 0.2, r_out = 1, h = 1, density = 1 } - " .. drill("0.3", "1"), "m outside",
  "a hole over a tube's own")
told("(" .. BOX .. " - " .. drill("0.6", "1") .. "):at{1, 2, 3} + " .. BOX, "m outside", "a hole deep in the tree")
told("plate.rectangle { x = 1, y = 1, density = 1 } - plate.disc { r = 0.1, density = 1 }:at{0, 0, 0.01}",
  "0.01 m outside", "a plate beside its plate")
told("points { {1, 0, 0, 0}, {1, 1, 0, 0} } - points { {1, 0, 1, 0} }", "m outside", "a particle that is not there")

-- ---- kinds ----

told(BOX .. " - plate.disc { r = 0.1, density = 1 }",
  "must be of the same kind (volume, area, length or particles) as " ..
  "the body it is cut from, got an area from a volume", "a plate cut from a solid")
told("plate.disc { r = 1, density = 1 } - rod.straight { length = 0.1, density = 1 }", "got a length from an area",
  "a rod cut from a plate")
told(BOX .. " + plate.disc { r = 1, density = 1 }:at{0, 0, 2} - plate.disc { r = 0.1, density = 1 }", "m outside",
  "a plate cut where there is only solid")
quiet(BOX .. " + plate.disc { r = 1, density = 1 }:at{0, 0, 2} - plate.disc { r = 0.1, density = 1 }:at{0, 0, 2}",
  "a plate cut from the plate of a body of several kinds")
quiet("tensor { mass = 9, xx = 1, yy = 1, zz = 1 } - solid.sphere { r = 0.1, density = 1 }",
  "of a tensor's extent nothing is known and nothing said")

-- ---- density ----

told(BOX .. " - solid.sphere { r = 0.1, density = 1.001 }",
  "hole: must not be denser than the body it is cut from, got",
  "a hole denser than its body")
told(BOX .. " - solid.sphere { r = 0.1, density = 0.5 }",
  "warning hole: is less dense than the body it is cut from, 0.5 <",
  "a lighter one leaves something in the hole")
-- balls of 1 m and 1/2 m: an eighth of the volume
told("solid.sphere { r = 1, mass = 2 } - solid.sphere { r = 0.5, mass = 1 }",
  "warning hole: is denser than the body it " ..
  "is cut from, 1.91 > 0.477 kg/m^3", "a hole of half the mass and an eighth of the volume")
quiet("solid.sphere { r = 1, mass = 8 } - solid.sphere { r = 0.5, mass = 1 }", "a mass that fits the volume")
quiet("solid.sphere { r = 1, mass = 8 } - solid.sphere { r = 0.5, mass = 0.998 }", "a mass that was weighed")
quiet("solid.sphere { r = 1, mass = 8 } - solid.sphere { r = 1, mass = 1 }:scaled{0.5}", "a mass that was scaled")
-- the determinant is 1 + 1/8: a part of its second term counts
quiet("solid.sphere { r = 1, mass = 8 } - solid.sphere { r = 0.5, mass = 1.125 }:sheared{xy = 0.5, yz = 0.5, zx = 0.5}",
  "a mass that fits the volume of a sheared hole")
quiet("solid.sphere { r = 1, density = 3 } - solid.sphere { r = 1, density = 3 }:scaled{0.5, 0.25, 0.125}",
  "a density that was scaled by three factors")
do
  local two = BOX .. " + " .. BOX:gsub("density = 1", "density = 8") .. ":at{0, 0, 1}"
  quiet(two .. " - solid.sphere { r = 0.1, density = 8 }:at{0, 0, 1}",
    "the density where the hole is counts: the heavy part")
  told(two .. " - solid.sphere { r = 0.1, density = 8 }", "got 8 > 1 kg/m^3", "and the light part")
end

tap.done()
