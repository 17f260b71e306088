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
  program.shell(string.format("%s run %s/body.lua --engine %s --until 0.1 --columns t,N --events %s/out.csv " ..
    ">%s/said 2>&1", binary, dir, engine, dir, dir))
  local t, N = (program.read(dir .. "/out.csv") or ""):match "contact_lost,([%d.e-]+),([%d.e-]+)"
  -- a hundred roundings of t; of a run by tolerance 1e-15
  tap.ok(t and math.abs(tonumber(t) - 0.026123754109169372568) < 1e-14,
    "contact is lost where N = 0, and the run ends: " .. engine, t)
  tap.ok(N and math.abs(tonumber(N)) < 1e-9, "N is 0 there", N)
end

-- ---- a start that the plane does not allow, at every door ----

program.write(dir .. "/dropped.lua", [[
return scene { name = "dropped", body = solid.sphere { r = 0.03, mass = 0.2 },
  effects = { effect.plane { surface = contact.sphere { r = 0.03 } } },
  initial = { velocity = { 0.5, 0, 0 },
    position = { 0, 0, 0.1 } } }
]])
for _, door in ipairs { "run SCENE", "gen SCENE -o DIR/gen", "explain SCENE", "check SCENE", "plot SCENE -o DIR/a.svg",
  "view SCENE -o DIR/a.html", "sweep SCENE --over wx=0:1:2" } do
  local code, out, said = program.output(binary .. " " .. door:gsub("SCENE", dir .. "/dropped.lua"):gsub("DIR", dir))
  said = out .. said
  tap.ok(code ~= 0 and said:find("dropped.lua:3: initial: velocity must be that of rolling", 1, true) and
    said:find("dropped.lua:4: initial: position must have the centre of mass", 1, true), "refused: " .. door, said)
end
-- what is right to four digits, and what follows exactly, is taken
for _, initial in ipairs { "omega = {0, 10, 0}, velocity = {0.3001, 0, 0}, position = {1, 2, 0.03001}",
  "omega = {0, 10, 0}, velocity = {0.3, 0, 0}, position = {1, 2, 0}" } do
  program.write(dir .. "/taken.lua", (program.read(dir .. "/dropped.lua"):gsub("initial = .*", function()
    return "initial = { " .. initial .. " } }\n"
  end)))
  local code, _, said = program.output(binary .. " run " .. dir .. "/taken.lua --until 0.01")
  tap.ok(code == 0, "taken: " .. initial, said)
end

-- ---- gravity along a normal of irrational length ----

-- What it has along the plane is 0, not what the normal's rounding leaves.  A ball that slides without spin: the centre
-- has V = V0 (1 - 2/7 (1 - exp(-r t))), r = 7/2 c G, G = sqrt(14) (Newton, Euler, J/(J + m R^2) = 2/7).
local function skew(surface, law)
  program.write(dir .. "/skew.lua", string.format([[
return scene { name = "skew", body = solid.sphere { r = 0.1, mass = 1 },
  effects = { effect.plane { surface = contact.%s, %s, normal = { 1, 2, 3 }, gravity = { -1, -2, -3 } } },
  initial = { omega = { 0, 0, 0 }, velocity = { 3, 0, -1 } } }
]], surface, law))
end
for _, law in ipairs { 'law = "rolling"', 'law = "smooth"', 'law = "sliding", friction = { viscous = 0.2 }' } do
  for _, surface in ipairs { "sphere { r = 0.1 }", "disc { r = 0.1 }", "ellipsoid { a = 0.1, b = 0.1, c = 0.1 }" } do
    skew(surface, law)
    if law:find "rolling" then -- which has no velocity of its own
      program.write(dir .. "/skew.lua", (program.read(dir .. "/skew.lua"):gsub(", velocity = %b{}", "")))
    end
    local code = program.shell(string.format("%s gen %s/skew.lua --real float --method rk4 -o %s/skew >%s/said 2>&1",
      binary, dir, dir, dir))
    local tiny = (program.read(dir .. "/skew/skew.c") or ""):match "%d%.?%d*e%-[2-9]%d"
    tap.ok(code == 0 and not tiny, "gravity along (1, 2, 3): " .. law .. ", " .. surface,
      tiny or program.read(dir .. "/said"))
  end
end
skew("sphere { r = 0.1 }", 'law = "sliding", friction = { viscous = 0.2 }')
do
  local V = 1 - 2 / 7 * (1 - math.exp(-3.5 * 0.2 * math.sqrt(14) * 0.5))
  for _, row in ipairs { { "", 1e-12 }, { "--engine generated --method taylor", 1e-12 },
    { "--engine generated --real float --method taylor --tolerance 2e-7", 1e-5 } } do
    program.shell(string.format("%s run %s/skew.lua --at 0.5 --columns com_velocity_x,com_velocity_z,N %s " ..
      ">%s/out.csv 2>&1", binary, dir, row[1], dir))
    local x, z, N = (program.read(dir .. "/out.csv") or ""):match "\n([%d.e-]+),([%d.e-]+),([%d.e-]+)"
    -- a hundred tolerances of 1e-14 a step, or of 2e-7 over some ten steps
    tap.ok(x and math.abs(x / 3 - V) < row[2] and math.abs(-z - V) < row[2] and
      math.abs(N / math.sqrt(14) - 1) < row[2], "a ball slides along (3, 0, -1): " .. row[1], x)
  end
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
