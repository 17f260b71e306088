#!/usr/bin/env lua5.4
-- plane.t - bodies on a plane: the emitted Taylor series against reference tables of 32 digits, through scenes as users
-- write them; the reaction, where contact is lost; what cannot be, answered.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle: tests/reference/plane.h (README there).  tests/runtime/plane.c holds the library to the same rows; `polhode
-- check` of the scenes in bodies/ compares the two; plane_methods.t has the other methods.
-- Bars: 1e-11, or 20 times what the inputs' rounding moves.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local tier = require "tests.tier"
local plane_rows = require "tests.effects.plane_rows"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local rows, cases, scene_of = plane_rows.rows, plane_rows.cases, plane_rows.scene

for n = 1, #cases, tier.quick and 6 or 1 do
  local case = cases[n]
  local list, why = plane_rows.run(binary, dir, case, "--engine generated --method taylor --tolerance 1e-15")
  local worst = list and plane_rows.worst(case, list, function(moved) return math.max(1e-11, 20 * moved) end)
  tap.ok(worst and worst <= 1, string.format("%s: attitude, rates, place, velocity and reaction at %d times",
    case[1][1], #case), why or worst)
end

-- the instant at which contact is lost, plane.json
for _, row in ipairs(rows) do
  if row[1] == "contact_lost_smooth" then program.write(dir .. "/body.lua", scene_of(row)) end
end
for _, engine in ipairs { "general", "generated --method taylor --tolerance 1e-15" } do
  program.shell(string.format("%s run %s/body.lua --engine %s --until 0.1 --columns t,N >%s/out.csv 2>&1", binary, dir,
    engine, dir))
  local t, N = (program.read(dir .. "/out.csv") or ""):match "contact_lost,([%d.e-]+),([%d.e-]+)"
  -- a hundred roundings of t; of a run by tolerance 1e-15
  tap.ok(t and math.abs(tonumber(t) - 0.026123754109169372568) < 1e-14,
    "contact is lost where N = 0, and the run ends: " .. engine, t)
  tap.ok(N and math.abs(tonumber(N)) < 1e-9, "N is 0 there", N)
end

-- ---- what cannot be ----

local function refused(what, effects, want, more)
  program.write(dir .. "/bad.lua", string.format([[
return scene { name = "bad", body = solid.box { x = 1, y = 1, z = 1, mass = 1 }, %s
  effects = { %s }, initial = { omega = { 1, 2, 3 } } }
]], more or "", effects))
  local code = program.shell(string.format("%s explain %s/bad.lua >%s/said 2>&1", binary, dir, dir))
  local said = program.read(dir .. "/said") or ""
  tap.ok(code == 1 and said:find("bad.lua:[12]") and said:find(want, 1, true), what, said)
end
local SPHERE = "surface = contact.sphere { r = 1 }"
refused("a radius that is none", "effect.plane { surface = contact.sphere { r = -1 } }", "r must be positive, got -1")
refused("no surface", "effect.plane {}", "surface is missing")
refused("a surface that is none", "effect.plane { surface = 3 }", "surface must be a contact")
refused("an unknown surface", "effect.plane { surface = contact.cone {} }", "has no \"cone\"")
refused("an unknown law", "effect.plane { " .. SPHERE .. ", law = \"gliding\" }", "law must be")
refused("sliding without friction", "effect.plane { " .. SPHERE .. ", law = \"sliding\" }", "needs friction")
refused("friction without sliding", "effect.plane { " .. SPHERE .. ", friction = { viscous = 1 } }", "needs law")
refused("negative friction", "effect.plane { " .. SPHERE .. ", law = \"sliding\", friction = { viscous = -1 } }",
  "must not be negative")
refused("Coulomb's without smoothing", "effect.plane { " .. SPHERE ..
  ", law = \"sliding\", friction = { coulomb = 1 } }",
  "smoothing is missing")
refused("no normal", "effect.plane { " .. SPHERE .. ", normal = { 0, 0, 0 } }", "normal must not be zero")
refused("a smooth plane that turns", "effect.plane { " .. SPHERE .. ", law = \"smooth\", turntable = 1 }", "no effect")
refused("gravity twice", "effect.plane { " .. SPHERE .. " }, effect.gravity {}", "effect.gravity")
refused("two planes", "effect.plane { " .. SPHERE .. " }, effect.plane { " .. SPHERE .. " }", "given twice")
refused("a wheel beside it", "effect.plane { " .. SPHERE ..
  " }, effect.wheel { axis = { 0, 0, 1 }, inertia = 0.1, included = false }", "effect.plane")
refused("a body that flies", "effect.plane { " .. SPHERE .. " }, effect.translation {}", "effect.plane")
refused("a force of the scene's own", "effect.plane { " .. SPHERE .. " }, effect.custom { force = function(s) " ..
  "return { quantity(1, \"N\"), 0, 0 } end }", "effect.custom: cannot be together with effect.plane")
refused("a torque that depends on the place", "effect.plane { " .. SPHERE .. " }, effect.torque { body = " ..
  "{ quantity(1, \"N\")*rx, 0, 0 } }", "effect.torque: depends on rx, which a body on a plane (line 2) does not have")
refused("an origin elsewhere", "effect.plane { " .. SPHERE .. " }", "must be the centroid", "origin = \"corner\",")
for _, method in ipairs { "semi", "midpoint", "split2" } do
  local code = program.shell(string.format("%s gen rolling_coin --method %s -o %s/none >%s/said 2>&1", binary, method,
    dir, dir))
  tap.ok(code == 1 and (program.read(dir .. "/said") or ""):find("touches a plane", 1, true), method .. " is refused")
end

program.finish()
tap.done()
