#!/usr/bin/env lua5.4
-- round.t - a body written as URDF, MJCF or SDF and read again is the same body to the last bit.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- For every body: scene -> urdf -> inertial{} -> urdf must give the same bytes, urdf -> mjcf -> sdf -> urdf too, and
-- the doubles of `explain --format json` must not move.  Bodies: composed scenes, the bounds of validity (plates and
-- rods in oblique axes, whose written tensor may break zz = xx + yy in its last place), needles, far origins, small and
-- large units, and random heaps of particles, which are valid by construction.
-- The quick tier takes a part of its cases.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local run = require "tests.interchange.program"

-- ---- the bodies ----

local bodies = {}
local function body(name, shape, head) bodies[#bodies + 1] = { name = name, shape = shape, head = head or "" } end

body("a box", "solid.box { x = 0.1, y = 0.2, z = 0.3, mass = 2.4 }")
body("a turned cone off the origin",
  "solid.cone { r = 0.3, h = 0.7, density = 2700 }:turned{axis = {1, 2, 3}, angle = 0.7}:at{0.1, -5e-3, 7}")
body("a box with a hole and a counterweight",
  "solid.box { x = 1, y = 2, z = 3, density = 1000 } - solid.cylinder { r = 0.2, h = 3, density = 1000 }" ..
  ":at{0.1, 0.3, 0} + solid.sphere { r = 0.1, mass = 70 }:at{0.7, 0.6, 0.5}")
body("parameters at their defaults", "solid.box { x = a, y = a/3, z = 1, mass = 2 }:at{a, a, a}",
  'local a = param("a", 0.7, "m")\n')
body("a plate in oblique axes", "plate.disc { r = 0.3, mass = 1.7 }:turned{axis = {1, -1, 2}, angle = 1}")
body("another plate", "plate.rectangle { x = 0.1, y = 0.7, mass = 0.3 }:turned{axis = {3, 1, 2}, angle = 2}")
body("a rod in oblique axes", "rod.between { from = {0, 0, 0}, to = {0.1, 0.2, 0.7}, mass = 3 }")
body("a rod along z", "rod.straight { length = 0.3, mass = 3 }")
body("a needle, 1e8", "solid.box { x = 1e-8, y = 1, z = 1e-8, mass = 1 }:turned{axis = {1, 1, 1}, angle = 0.3}")
body("an origin 1e6 away", "solid.box { x = 0.1, y = 0.2, z = 0.3, mass = 1/3 }:at{1e6, -1e6, 1/3}")
body("kilograms of 1e-30", "solid.sphere { r = 1e-10/3, mass = 1e-30/7 } + solid.box { x = 1e-10, y = 2e-10, " ..
  "z = 3e-10, mass = 1e-30 }:at{1e-9, 0, 0}")
body("kilograms of 1e30", "solid.sphere { r = 6.4e6, mass = 6e24 } + solid.sphere { r = 7e8, mass = 2e30 }" ..
  ":at{1.5e11, 1e9, 0}")
body("a cube about its corner", "solid.box { x = 1, y = 1, z = 1, mass = 1 }:at{0.5, 0.5, 0.5}")

-- Heaps of particles: numbers of 1 to 15 digits over many scales, by Park and Miller's generator.
local state = 20240131
local function int(n)
  state = state * 16807 % 2147483647
  return state % n + 1
end
local function decimal(signed)
  local digits = tostring(int(9))
  for _ = 1, int(15) - 1 do digits = digits .. (int(10) - 1) end
  return (signed and int(2) == 1 and "-" or "") .. "0." .. digits
end
for k = 1, tier.quick and 5 or 40 do
  local rows, scale = {}, ({ 0, 0, -20, 20, -6 })[int(5)]
  for i = 1, 2 + int(5) do
    rows[i] = string.format("{%se%d, %se%d, %se%d, %se%d}", decimal(), scale // 2, decimal(true), scale, decimal(true),
      scale, decimal(true), scale)
  end
  body("random particles " .. k, "points { " .. table.concat(rows, ", ") .. " }")
end

-- ---- the trip ----

local function same(a, b)
  for i = 1, 10 do
    if not a[i] or a[i] ~= b[i] then return false end -- doubles: equal, or the test fails
  end
  return true
end

local scene = '%sreturn scene { name = "b", body = %s }'

for _, b in ipairs(tier.every(6, bodies, 2)) do
  local text = string.format(scene, b.head, b.shape)
  local status, urdf, err = run.explain(text, "urdf")
  run.write("b.urdf", urdf)
  if tap.ok(status == 0 and urdf:find "<inertial>", b.name .. ": is written", err) then
    local _, again, why = run.inertial("b.urdf", "urdf")
    tap.ok(again == urdf, b.name .. ": urdf read and written again is the same bytes", why .. again .. urdf)
    local _, direct = run.explain(text, "mjcf")
    local mjcf, sdf, last
    _, mjcf = run.inertial("b.urdf", "mjcf")
    run.write("b.mjcf", mjcf)
    tap.ok(mjcf == direct and mjcf ~= "", b.name .. ": by way of urdf the mjcf is the same as written at once",
      mjcf .. direct)
    _, direct = run.explain(text, "sdf")
    _, sdf = run.inertial("b.mjcf", "sdf")
    run.write("b.sdf", sdf)
    tap.ok(sdf == direct and sdf ~= "", b.name .. ": by way of urdf and mjcf the sdf is too", sdf .. direct)
    _, last = run.inertial("b.sdf", "urdf")
    tap.ok(last == urdf, b.name .. ": urdf -> mjcf -> sdf -> urdf is the same bytes", last .. urdf)
  end
end

for i = 1, tier.quick and 2 or 16 do
  local b = bodies[i]
  local _, urdf = run.explain(string.format(scene, b.head, b.shape), "urdf")
  run.write("b.urdf", urdf)
  local _, one, err1 = run.explain(string.format(scene, b.head, b.shape), "json")
  local _, two, err2 = run.inertial("b.urdf", "json")
  local x, y = run.numbers(one, err1), run.numbers(two, err2)
  tap.ok(x and y and same(x, y), b.name .. ": mass, centre and tensor in JSON are the same doubles", err1 .. err2)
end

-- ---- an inertial frame that is turned: rounded once, then stable ----

run.write("t.urdf", [[<inertial><origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 1.1"/><mass value="1.5"/>
  <inertia ixx="0.01" ixy="0.001" ixz="-2e-4" iyy="0.02" iyz="0.0003" izz="0.015"/></inertial>]])
local _, once = run.inertial("t.urdf", "urdf")
run.write("b.urdf", once)
local _, twice = run.inertial("b.urdf", "urdf")
tap.ok(once == twice and once:find('rpy="0 0 0"', 1, true), "a turned frame is written parallel, and then stays", twice)

-- A body that is moved in the scene moves as a whole.
local _, moved = run.explain('return scene { name = "b", body = inertial { file = "t.urdf" }:at{1, 1, 1} }', "urdf")
tap.ok(moved == (once:gsub('xyz="0.1 0.2 0.3"', 'xyz="1.1 1.2 1.3"')) and moved ~= once,
  "inertial{} can be placed like any shape", moved)

run.finish()
tap.done()
