#!/usr/bin/env lua5.4
-- slips.t - the slip that explains an impossible tensor is named; real ones first.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The right tensors are those of bodies, worked out here: a slip is made on purpose and must be found again.  Cases
-- from the field are cited.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"

local function told(entries, part, name)
  local job, why = scene.body("tensor { " .. entries .. " }")
  if job then return tap.ok(false, name, "it was accepted") end
  return tap.like(why, part, name)
end

-- ---- from the field ----

told("mass = 1.559, xx = 2661.9E-6, xy = -31.029E-6, xz = 9.34E-6, yy = 2302.5E-6, yz = 151.466E-6, zz = 1676359E-6",
  "zz <= xx + yy must hold, got 1.676359 > 0.0026619 + 0.0023025; most likely: zz has a slipped decimal point or is " ..
  "off by a unit's 1e3 (0.001676359 would satisfy it)",
  "github.com/RealManRobot/rm_models/issues/6: a missing decimal point; one entry, one value")
told("mass = 1, xx = 0.000115, xy = 0.000052, xz = 0.000025, yy = 0.000153, yz = 0.000034, zz = 0.00019",
  "got 0.000232 > 7.86e-05 + 0.000147", "github.com/Gepetto/example-robot-data/issues/130: its principal moments")
told("mass = 1, xx = 0.000115, xy = 0.000052, xz = 0.000025, yy = 0.000153, yz = 0.000034, zz = 0.00019",
  "most likely: xy, xz, yz are products of inertia and want the other sign", "the same: CAD exports products")

-- ---- made on purpose: particles of 1 kg at (2, 1, 3), (-2, -1, -3), (1, -1, 1), (-1, 1, -1) ----
-- sum x^2 = 10, y^2 = 4, z^2 = 20, x y = 2, x z = 14, y z = 4: a body in a plane, Sigma singular
local right = { xx = 24, yy = 30, zz = 14, xy = -2, xz = -14, yz = -4 }

local function entries(changes, more)
  local list = { "mass = 4" }
  for _, k in ipairs { "xx", "yy", "zz", "xy", "xz", "yz" } do
    list[#list + 1] = k .. " = " .. (changes[k] or right[k])
  end
  return table.concat(list, ", ") .. (more or "")
end

tap.ok(scene.body("tensor { " .. entries {} .. " }"), "the right tensor, on the border of the lawful, is accepted")
told(entries { xy = 2, xz = 14, yz = 4 }, "most likely: xy, xz, yz are products of inertia and want the other sign",
  "products of inertia for tensor entries (github.com/mikedh/trimesh/pull/1074)")
told(entries { xy = -14, xz = -2 }, "xy and xz are swapped", "xy and xz swapped (github.com/dimforge/parry/issues/320)")
told(entries { yz = -14, xz = -4 }, "xz and yz are swapped", "xz and yz swapped")
told(entries { xx = 14, zz = 24 }, "xx and zz are swapped", "two moments swapped")
told(entries { yy = 300 }, "yy has a slipped decimal point (30 would satisfy it)", "ten times too large")
told(entries { yy = 30000 }, "yy has a slipped decimal point or is off by a unit's 1e3 (30 would satisfy it)",
  "a thousand times too large")
told(entries { yy = 30e6 }, "off by a unit's 1e6 (30 would satisfy it)", "mm^2 for m^2 in one entry")
told(entries { xx = "24e-3" }, "xx has a slipped decimal point or is off by a unit's 1e3 (24 would satisfy it)",
  "a thousand times too small")
told(entries { xz = -140 }, "xz has a slipped decimal point (-14 would satisfy it)", "a product ten times too large")
-- 0.0254^2 kg m^2 is 1 kg in^2
told("mass = 1, xx = 4, yy = 0.5, zz = 6200", "zz is in kg in^2 (3.999992 would satisfy it)",
  "square inches in one entry")
told("mass = 1, xx = \"123456/100000\", yy = \"234568/100000\", zz = \"358025/100000\"",
  "most likely: the entries of a flat or thin body were rounded",
  "a lamina whose entries were rounded to six digits, given as fractions, which are exact")
told("mass = 1, xx = 1, yy = 2, zz = \"3.00000000000000000000000001\"", "got 3 > 1 + 2 by 1e-26; most likely: the " ..
  "entries of a flat", "an excess that doubles do not show is given by its size")

-- ---- the point of reference ----

-- a cube of 6 kg and 1 m (moments 1 kg m^2) at (10, 0, 0): 1, 601, 601 about the origin
local function cube(m, x, I, more)
  return string.format("mass = %s, com = {%s, 0, 0}, xx = %s, yy = %s, zz = %s, about = \"origin\"%s", m, x, I[1], I[2],
    I[3], more or "")
end
tap.ok(scene.body("tensor { " .. cube(6, 10, { 1, 601, 601 }) .. " }"), "about the origin: the right one is accepted")
told(cube(6, 10, { 1, 1, 1 }), "the entries are about the centre of mass already (about = \"com\")",
  "about the centre of mass, said to be about the origin")
told(cube(6, "1/100", { "1e-6", "1e-12", "1e-6" }), "must not be negative", "each negative moment is named")
told(cube(6, 10, { "2e-6", "601e-6", "601e-6" }, ", yz = \"-1e-8\""), "about the centre of mass already",
  "what could be central is said to be so first")
told(cube(6000, 10, { 1, 601, 601 }), ", or mass is in g", "the mass in grams")
told(cube(6, 10000, { 1, 601, 601 }), ", or com is in mm", "the centre of mass in millimetres")

-- ---- nothing to say ----

do
  local _, why = scene.body "tensor { mass = 1, xx = 5, yy = 1, zz = 3 }"
  tap.like(why, "got 5 > 1 + 3; physical = false takes", "where no digit explains it, nothing is said of slips")
  _, why = scene.body "tensor { mass = 1, xx = 1, yy = 0, zz = 0 }"
  tap.like(why, "got 1 > 0 + 0\n", "and no hint is better than a wild one")
end

-- ---- implausible, and possible: a warning ----

local function warned(entries_, part, name)
  local job, why = scene.body("tensor { " .. entries_ .. " }")
  if not job then return tap.ok(false, name, why) end
  local said = {}
  for i, w in ipairs(job.diag.warnings) do said[i] = w.message end
  local text = table.concat(said, "\n")
  if part == "" then return tap.is(text, "", name) end
  return tap.like(text, part, name)
end

-- a satellite of 100 kg whose radius of gyration is 0.5 m
warned("mass = 100, xx = 20, yy = 22, zz = 25", "", "a satellite is plausible")
warned("mass = 100, xx = 20e6, yy = 22e6, zz = 25e6",
  "too large for the mass: the radius of gyration sqrt(I/mass) is 500 m (in kg mm^2 it would be 0.5 m)",
  "its moments in kg mm^2 are not")
warned("mass = 100, xx = 20e-6, yy = 22e-6, zz = 25e-6", "denser than any metal", "a moment too small for the mass")
warned("mass = 100e3, xx = 20, yy = 22, zz = 25", "with the mass in g it would be 0.5 m", "its mass in grams")
warned("mass = 100, xx = 20, yy = 22, zz = 25, com = {1000, 0, 0}",
  "com is 1e+03 m from the origin, 2e+03 radii of gyration: is it in metres?", "a centre of mass in millimetres")
warned("mass = 100, xx = 20, yy = 22, zz = 25, com = {50, 0, 0}", "", "an origin a hundred radii away is quiet")
warned("mass = 5.9722e24, xx = 8.0365e37, yy = 8.0365e37, zz = 8.0629e37", "", "the Earth is quiet")
warned("mass = 2.99e-26, xx = 1.02e-47, yy = 1.92e-47, zz = 2.94e-47", "", "a molecule of water is quiet")
-- rod of 10 m and 1 kg: I = m l^2/12
warned("mass = 1, xx = 8.3, yy = 8.3, zz = 0", "", "a thin boom is quiet")

do
  local function pair(size)
    local job = assert(scene.body("solid.sphere { r = 1, mass = 1 } + solid.sphere { r = " .. size ..
      ", mass = 1 }:at{3, 0, 0}"))
    return job.diag.warnings[1] and job.diag.warnings[1].message or ""
  end
  tap.like(pair "1e-7", "is 1e+07 times smaller", "parts that differ by seven orders are questioned")
  tap.is(pair "1e-5", "", "parts that differ by five are not")
end

tap.done()
