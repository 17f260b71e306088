#!/usr/bin/env lua5.4
-- states.t - which states a scene has and why, what contradicts itself, what is conserved, what costs nothing.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local effects = require "generator.effects.effects"

-- A driven wheel about z, whose inertia J is not the body's: its angular momentum J s, its speed s' = drive/J.
table.insert(effects, { name = "effect.flywheel", about = "for this test", formula = "J s' = drive",
  args = { { name = "drive", dim = "torque" }, { name = "J", dim = "inertia" } },
  states = function()
    return { { name = "speed", initial = expr.lift(3), unit = "rad/s", about = "speed of the wheel" } }
  end,
  derivative = function(a, c) return { speed = c.constant("drive", a.drive / a.J, "of the wheel, rad/s^2") } end,
  momentum = function(a, c) return { expr.zero, expr.zero, c.constant("Jw", a.J, "of the wheel") * c.own.speed } end,
  numeric = function() return { kind = "control" } end, conserves = { "L" } })

local BOX = "solid.box { x = 2, y = 3, z = 5, mass = 7 }"
local TOP = "solid.cone { r = 1, h = 3, mass = 7 }"

local function read(body, effect, more)
  local text = "local s = scene {\n  name = \"b\",\n  body = %s,\n  effects = {%s},\n  %s\n}\nreturn s\n"
  return scene.read(string.format(text, body, effect, more or ""))
end

local function names(job)
  local list = {}
  for i, s in ipairs(job.states) do list[i] = s.name end
  return table.concat(list, " ")
end

local ROTATION, RATES, PLACE = "qw qx qy qz wx wy wz", "wx wy wz", "rx ry rz vx vy vz"
local FRAME = "effect.rotating_frame { rate = {0, 0, 1} }"

-- {what, body, effects, more, states, conserved}
for _, c in ipairs {
  { "a free body", BOX, "", "", ROTATION, "T+V |L| L L_z" },
  { "a free symmetric body", TOP, "", "", ROTATION, "T+V |L| L L_z w3" },
  { "a body that flies", BOX, "effect.translation{}", "initial = { omega = {1, 2, 3} }", ROTATION .. " " .. PLACE,
    "T+V |L| L L_z" },
  { "a body that flies with its attitude given", BOX, "effect.translation{}", "initial = { attitude = {1, 0, 0, 0} }",
    ROTATION .. " " .. PLACE, "T+V |L| L L_z" },
  { "a body that flies and is turned", BOX, "effect.translation{}, effect.torque { body = {1, 0, 0} }", "",
    ROTATION .. " " .. PLACE, "" },
  { "a point", BOX, "effect.translation { drag = 1 }", "", PLACE, "" },
  { "a particle", "points {{1, 0, 0, 0}}", "effect.translation { gravity = {1, 2, 3} }", "", PLACE, "T+V" },
  { "a point in a turning frame", BOX, FRAME, "initial = { position = {1, 0, 0} }", PLACE, "T+V" },
  { "a body in a turning frame", BOX, FRAME, "initial = { omega = {1, 0, 0} }", ROTATION, "T+V |L| L_z" },
  { "a frame whose rate changes", BOX, "effect.rotating_frame { rate = {0, 0, 1}, rate_dot = {1, 0, 0} }",
    "initial = { omega = {1, 0, 0} }", ROTATION, "T+V |L|" },
  { "rates alone", BOX, "", "outputs = { \"rates\" }", RATES, "T+V |L|" },
  { "rates with the energy", BOX, "", "outputs = { \"rates\", \"energy\" }", RATES, "T+V |L|" },
  { "the momentum needs the attitude", BOX, "", "outputs = { \"momentum\" }", ROTATION, "T+V |L| L L_z" },
  { "gravity needs the attitude", BOX, "effect.gravity{}", 'origin = "corner", outputs = { "rates" }', ROTATION,
    "T+V L_z" },
  { "damping does not", BOX, "effect.damping { c = 1 }", "outputs = { \"rates\" }", RATES, "" },
  { "an inertial torque does", BOX, "effect.torque { inertial = {1, 0, 0} }", "outputs = { \"rates\" }", ROTATION,
    "L_z" },
  { "the frame's energy does", BOX, FRAME, "outputs = { \"rates\" }", ROTATION, "T+V |L| L_z" },
  { "the heavy top", TOP, "effect.gravity{}", "origin = {0, 0, 0}", ROTATION, "T+V L_z w3" },
  { "gravity aslant", TOP, "effect.gravity { direction = {1, 0, -1} }", "origin = {0, 0, 0}", ROTATION, "T+V w3" },
  { "a body torque across the axis", TOP, "effect.torque { body = {1, 2, 0} }", "", ROTATION, "w3" },
  { "a potential of the axis' direction, across and along", TOP,
    "effect.custom { potential = function(s) local q = s.q\n" ..
    "return quantity(1, \"J\")*(2*(q[2]*q[4] + q[1]*q[3]) + q[1]^2 - q[2]^2 - q[3]^2 + q[4]^2) end }", "", ROTATION,
    "T+V w3" }, -- V = (R e3).(e1 + e3): a turn about e3 of the body changes nothing
  { "the same by a magnet", TOP, "effect.magnetic { moment = {0, 0, 1}, field = {-1, 0, -1} }", "", ROTATION,
    "T+V w3" },
  { "two wheels", BOX, "effect.flywheel { drive = 1, J = 2 }, effect.flywheel { drive = 2, J = 2 }", "",
    ROTATION .. " speed speed_2", "|L| L L_z" },
} do
  local job, why = read(c[2], c[3], c[4])
  tap.ok(job ~= nil, c[1] .. ": is a scene", why)
  if job then
    tap.is(names(job), c[5], c[1] .. ": its states")
    tap.is(table.concat(job.conserved, " "), c[6], c[1] .. ": what is conserved")
    job = scene.plan(job)
    local files, where = scene.files(job), string.upper("b")
    for _, s in ipairs(job.states) do
      tap.ok(string.find(files["b.h"], where .. "_" .. string.upper(s.name) .. ",", 1, true), c[1] .. ": " .. s.name ..
        " is in the header")
    end
    local has = {}
    for _, f in ipairs(job.functions) do has[f.name] = true end
    local rates, attitude = string.find(c[5], "wx") ~= nil, string.find(c[5], "qw") ~= nil
    tap.ok((has.inertia or false) == rates and (has.momentum_body or false) == rates, c[1] .. ": functions of turning")
    tap.is(has.momentum or false, attitude, c[1] .. ": angular momentum in inertial axes")
    tap.ok(#job.model.reasons >= 3, c[1] .. ": reasons are told")
  end
end

-- what does nothing is not there: the same files, line numbers apart, as those of the scene without it
local function emitted(body, effect, more)
  local job = assert(read(body, effect, more))
  job = scene.plan(job)
  return scene.files(job)
end
for _, c in ipairs {
  { "gravity about the centroid", "effect.gravity{}", "" },
  { "gravity without strength", "effect.gravity { g = 0 }", 'origin = "corner"' },
  { "damping without strength", "effect.damping { c = 0 }", "" },
  { "no torque", "effect.torque { body = {0, 0, 0} }", "" },
  { "a frame at rest", "effect.rotating_frame { rate = {0, 0, 0} }", "" },
} do
  local with, without = emitted(BOX, c[2], c[3]), emitted(BOX, "", c[3])
  for _, file in ipairs { "b.h", "b.c", "b_test.c", "README.md" } do
    tap.ok(with[file] == without[file], c[1] .. " leaves " .. file .. " as it is")
  end
end

-- contradictions
for _, c in ipairs {
  { "effect.translation{}, effect.translation{}", "", "test.lua:4: effect.translation: is given twice" },
  { FRAME .. ", " .. FRAME, "", "test.lua:4: effect.rotating_frame: is given twice" },
  { "effect.translation{}, effect.gravity{}", "",
    "test.lua:4: effect.gravity: acts about a fixed point, and effect.translation (line 4) moves the body: give " ..
      "gravity = to effect.translation" },
  { "", "initial = { velocity = {1, 2, 3} }", "test.lua:5: initial: position and velocity need an effect that moves" },
  { "effect.translation{}", 'origin = "corner", initial = { omega = {1, 0, 0} }',
    "test.lua:5: origin: must be the centroid, as effect.translation (line 4) moves the body" },
  { "", 'outputs = { "speed" }', "test.lua:5: outputs: must be names of states or of attitude, rates" },
  { "", "outputs = 3", "test.lua:5: outputs: must be a list of names, got 3" },
  { 'effect.translation { drag = quantity(1, "kg/s") }', "", "effect.translation: drag must be in kg/m, got 1 kg/s" },
  { "effect.translation { drag = -1 }", "", "effect.translation: drag must not be negative, got -1" },
  { 'effect.translation { gravity = {0, 0, quantity(1, "N")} }', "", "gravity[3] must be in m/s^2, got 1 kg m/s^2" },
  { "effect.translation { stiffness = {1, 2} }", "", "stiffness must be a list of 3 numbers, got {1, 2}" },
  { 'effect.rotating_frame { rate = {0, 0, quantity(1, "m")} }', "", "rate[3] must be in 1/s, got 1 m" },
  { "effect.rotating_frame { rate = {0, 0, 1}, centrifugal = 1 }", "", "centrifugal must be true or false, got 1" },
  { "effect.rotating_frame {}", "", "effect.rotating_frame: rate is missing" },
} do
  local job, why = read(BOX, c[1], c[2])
  tap.ok(not job and string.find(why, c[3], 1, true), "refused: " .. c[3], why)
end
do
  local job, why = scene.read('local rx = param("rx", 1, "m")\nreturn scene { name = "b", body = ' .. BOX ..
    ",\n effects = { effect.translation{} } }")
  tap.ok(not job and string.find(why, "test.lua:1: param: name is taken by a state of the scene", 1, true),
    "refused: a parameter with the name of a state", why)
end

-- the wheel: (I w)' + h' + w x (I w + h) = 0, proved by the equations themselves
do
  local job = assert(read(BOX, "effect.flywheel { drive = 1, J = 2 }"))
  local equations = require "generator.dynamics.equations"
  local calculus = require "generator.algebra.calculus"
  local ratio = require "generator.algebra.ratio"
  local state = require "generator.dynamics.state"
  local dw, ds = {}, nil
  for _, g in ipairs(job.equations.groups) do
    for _, o in ipairs(g.outs) do
      local e = equations.inline(job.equations.groups, o.expr)
      for i, n in ipairs(state.names.rates) do
        if n == o.state then dw[i] = e end
      end
      if o.state == "speed" then ds = e end
    end
  end
  tap.is(ds, expr.lift "1/2", "the wheel's own rate")
  local I, h = job.model.inertia, { expr.zero, expr.zero, 2 * state.sym "speed" }
  local L = vec.add(vec.apply(I, state.w), h)
  local rest = vec.add(vec.add(vec.apply(I, dw), { expr.zero, expr.zero, 2 * ds }), vec.cross(state.w, L))
  local zero = true
  for i = 1, 3 do zero = zero and ratio.iszero(calculus.substitute(rest[i], {})) end
  tap.ok(zero, "a wheel's momentum enters Euler's equations")
  local quantities = require "generator.dynamics.quantities"
  local held = quantities.momentum_body(equations.fork(job.equations).model).groups[1].outs
  local same = true
  for i = 1, 3 do same = same and ratio.iszero(held[i].expr - L[i]) end
  tap.ok(same, "and the angular momentum")
end

tap.done()
