#!/usr/bin/env lua5.4
-- claim.t - a special path is ruled out by any term that it does not know, in the equation of any state.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each path takes its scene, and does not where a thousandth of a product of a rate or velocity and other states is
-- added to one equation: what an effect or a frame that nobody has thought of would do.  (A kick may be any torque of
-- attitude and time.)

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local vec = require "generator.algebra.vec"
local constancy = require "generator.dynamics.constancy"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"
local methods = require "generator.methods.methods"
local special = require "generator.methods.taylor_special"

local function read(body, origin, effects)
  return assert(scene.read("return scene { name = \"s\", body = " .. body .. ", origin = " .. origin ..
    ", effects = {" .. effects .. "}, initial = { omega = {1, 2, 3}, attitude = {1, 2, 3, 4} } }"))
end

local top = "tensor { mass = 2, com = {0, 0, 0.1}, xx = 0.5, yy = 0.5, zz = 0.2, about = \"origin\" }"
local box = "solid.box { x = 1, y = 2, z = 3, mass = 2 }"
local gravity = "effect.gravity { g = 3 }"

-- The equations with `more` added to the rate of one state; its own constants may be asked for.
local function with(eq, name, more)
  local own = equations.fork(eq)
  local groups = vec.map(own.groups, function(g)
    return { why = g.why, where = g.where, turn = g.turn, defs = g.defs, outs = vec.map(g.outs, function(o)
      return { state = o.state, expr = o.state == name and o.expr + more or o.expr }
    end) }
  end)
  return setmetatable({ groups = groups }, { __index = own })
end

local function series(eq)
  local moving, zero = constancy.moving(eq)
  local seen = special.frame(eq, zero, moving)
  return { axis = seen.axis ~= nil, shift = seen.shift ~= nil, top = special.top(seen, moving) ~= nil }
end

local function takes(name)
  local method = methods.by_name[name]
  return function(eq)
    if methods.refused(eq, method) then return false end
    return not method.program or method.program(eq, {}) ~= nil
  end
end

local function key(name) return function(eq) return series(eq)[name] end end

-- { path, scene, does it take the equations?, the states in whose equations anything is unknown }
local turning = { "qw", "qx", "qy", "qz", "wx", "wy", "wz" }
local rows = {
  { "taylor, frame about an axis", { top, "{0, 0, 0}", "" }, key "axis", turning },
  { "taylor, heavy top", { top, "{0, 0, 0}", gravity }, key "top", turning },
  { "taylor, frame of L", { box, "\"centroid\"", "" }, key "shift", turning },
  { "midpoint", { top, "{0, 0, 0}", gravity }, takes "midpoint", turning },
  { "midpoint, inner dissipation", { box, "\"centroid\"", "effect.dissipation { k = 0.1 }" }, takes "midpoint",
    turning },
  { "semi", { box, "{0.1, 0.2, 0.3}", gravity }, takes "semi", turning },
  { "semi, moving parts in a frame", { box, "\"centroid\"", "effect.inertia_rate { xx = t }, effect.rotating_frame " ..
    "{ rate = {0, 0, 1} }" }, takes "semi", turning },
  { "split2, heavy top", { top, "{0, 0, 0}", gravity }, takes "split2", turning },
  { "split4, box", { box, "{0.1, 0.2, 0.3}", gravity }, takes "split4", turning },
  { "split6, in flight", { box, "\"centroid\"", "effect.translation { gravity = 1 }" }, takes "split6",
    { "qw", "wx", "rx", "ry", "rz", "vx", "vz" } },
}

local w, t = state.w, state.t
for _, row in ipairs(rows) do
  local what, given, fits, states = row[1], row[2], row[3], row[4]
  local eq = read(table.unpack(given)).equations
  tap.ok(fits(equations.fork(eq)), what .. ": its own scene")
  local bad = {}
  for _, name in ipairs(states) do
    for i, more in ipairs { w[1] * w[2] / 1000, w[1] * state.q[2] * t / 1000,
      states ~= turning and state.v[1] * state.q[2] / 1000 or nil } do
      if fits(with(eq, name, more)) then bad[#bad + 1] = name .. " " .. i end
    end
  end
  tap.is(table.concat(bad, ", "), "", what .. ": nothing else")
end
tap.ok(not series(with(read(top, "{0, 0, 0}", "").equations, "wx", -t * w[2] / 1000)).axis,
  "a rate about the axis that changes with time is no frame")

tap.done()
