#!/usr/bin/env lua5.4
-- within.t - the conditions under which a hole lies inside its body, against points of body and hole.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A scene of each pair of shapes is read with lawful defaults; its conditions (mass/within.lua: algebra, no points) are
-- evaluated for parameters drawn at random.  What they say is compared with mass/holes.lua, which asks some 800 points
-- of the hole for the same parameters and shares no formula with them.  The points miss a hole that reaches out between
-- them: a sphere's or a rim's 24 points are 1 - cos(pi/24) < 1e-2 of the radius inside of it.  So margins of less than
-- NEAR of the sizes, on either side, are left out; all are of lengths of about 1.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local validity = require "generator.mass.validity"
local body_at = require "generator.dynamics.body_at"
local tap = require "tests.tap"
local scene = require "tests.scene"

local NEAR = 0.03 -- 1e-2 of radii up to 1, squared forms twice that
local DRAWS = 30

local function with(shape) return (shape:gsub("}", ", density = 1000 }", 1)) end

-- {what, body, hole, parameter = {low, high} ...}: the first of the two is the default
local BOX = "solid.box { x = 2, y = 2, z = 2 }"
local PLACE = { x = { -0.9, 0.9, 0.1 }, y = { -0.9, 0.9, 0 }, z = { -0.9, 0.9, 0.1 } }
local AT = ":at{x, y, z}"
local TURN = ":turned{axis = {1, 2, 2}, angle = phi}"
local function pair(what, body, hole, ranges)
  local all = {}
  for _, list in ipairs { PLACE, ranges or { r = { 0.05, 0.9, 0.1 } } } do
    for k, v in pairs(list) do all[k] = v end -- order does not matter: into a table
  end
  return { what, with(body), hole, all }
end

local SIZES = { r = { 0.05, 0.9, 0.1 }, h = { 0.05, 1.8, 0.1 } }
local TURNED = { r = SIZES.r, h = SIZES.h, phi = { -3, 3, 0.3 } }

local pairs_of = {
  pair("a ball in a box", BOX, with "solid.sphere { r = r }" .. AT),
  pair("a cylinder in a box", BOX, with "solid.cylinder { r = r, h = h }" .. AT, SIZES),
  pair("a turned cylinder in a box", BOX, with "solid.cylinder { r = r, h = h }" .. TURN .. AT, TURNED),
  pair("a turned box in a box", BOX, with "solid.box { x = r, y = h, z = 0.2 }" .. TURN .. AT, TURNED),
  pair("a turned cone in a box", BOX, with "solid.cone { r = r, h = 1.5*h }" .. TURN .. AT, TURNED),
  pair("a frustum in a box", BOX, with "solid.frustum { r_base = r, r_top = h/2, h = 0.4 }" .. AT, SIZES),
  pair("a capsule in a box", BOX, with "solid.capsule { r = r, h = h }:turned{axis = \"x\", angle = phi}" .. AT,
    TURNED),
  pair("a wedge in a box", BOX, with "solid.wedge { x = r, y = h, z = 0.3 }" .. AT, SIZES),
  pair("a pyramid in a box", BOX, with "solid.pyramid { x = r, y = h, h = 0.3 }" .. AT, SIZES),
  pair("a scaled ball in a box", BOX, with "solid.sphere { r = r }" .. ":scaled{1, k, 0.5}" .. AT,
    { r = SIZES.r, k = { 0.1, 1.5, 0.5 } }),
  pair("a sheared box in a box", BOX, with "solid.box { x = r, y = h, z = 0.3 }" .. ":sheared{xz = 0.5}" .. AT, SIZES),
  pair("a prism in a box", BOX,
    "solid.prism { profile = { {0, 0}, {r, 0}, {r, h}, {r/2, 1.5*h} }, h = 0.3, density = 1000 }" .. AT, SIZES),
  pair("a ball in a ball", "solid.sphere { r = 1 }", with "solid.sphere { r = r }" .. AT),
  pair("a box in a ball", "solid.sphere { r = 1 }", with "solid.box { x = r, y = h, z = 0.2 }" .. AT, SIZES),
  pair("a turned cylinder in a ball", "solid.sphere { r = 1 }", with "solid.cylinder { r = r, h = h }" .. TURN .. AT,
    TURNED),
  pair("a box in an ellipsoid", "solid.ellipsoid { a = 1.5, b = 1, c = 1 }", with "solid.box { x = r, y = h, z = 0.2 }"
    .. AT, SIZES),
  pair("a ball in a cylinder", "solid.cylinder { r = 1, h = 2 }", with "solid.sphere { r = r }" .. AT),
  pair("a cylinder in a cylinder", "solid.cylinder { r = 1, h = 2 }", with "solid.cylinder { r = r, h = h }" .. AT,
    SIZES),
  pair("a drill across a cylinder", "solid.cylinder { r = 1, h = 2 }", with "solid.cylinder { r = r, h = h }" ..
    ":turned{axis = \"y\", angle = pi/2}" .. AT, SIZES),
  pair("a turned box in a cylinder", "solid.cylinder { r = 1, h = 2 }", with "solid.box { x = r, y = h, z = 0.2 }" ..
    TURN .. AT, TURNED),
  pair("a ball in a cone", "solid.cone { r = 1.5, h = 2 }", with "solid.sphere { r = r }" .. AT),
  pair("a cylinder in a frustum", "solid.frustum { r_base = 1, r_top = 1.5, h = 1 }",
    with "solid.cylinder { r = r, h = h }" .. ":at{x, y, z + 0.3}", SIZES),
  pair("a ball in a hemisphere", "solid.hemisphere { r = 1 }", with "solid.sphere { r = r/2 }" .. ":at{x, y, z + 0.1}"),
  pair("a ball in a cap", "solid.cap { r = 1, h = 1.2 }", with "solid.sphere { r = r/2 }" .. ":at{x, y, z + 0.1}"),
  pair("a ball in a zone", "solid.zone { r = 1, z1 = -0.5, z2 = 0.7 }", with "solid.sphere { r = r }" .. AT),
  pair("a box in half a cylinder", "solid.half_cylinder { r = 1, h = 2 }", with "solid.box { x = r, y = h, z = 0.2 }" ..
    ":at{x + 0.2, y, z}", SIZES),
  pair("a box in a quarter of a cylinder", "solid.quarter_cylinder { r = 1, h = 2 }",
    with "solid.box { x = r, y = h, z = 0.2 }" .. ":at{x + 0.2, y + 0.3, z}", SIZES),
  pair("a ball in a pyramid", "solid.pyramid { x = 2, y = 3, h = 2 }", with "solid.sphere { r = r }" ..
    ":at{x, y, z + 0.3}"),
  pair("a ball in a wedge", "solid.wedge { x = 2, y = 3, z = 2 }", with "solid.sphere { r = r }" ..
    ":at{x + 0.4, y + 0.5, z + 0.9}"),
  pair("a ball in a turned and scaled box", "(" .. with(BOX) .. "):scaled{1, 1.2, 0.8}:turned{axis = \"x\", " ..
    "angle = 0.5}:at{0.1, 0, 0}", "solid.sphere { r = r, density = 1000 }" .. AT),
  pair("a ball in a tube", "solid.tube { r_in = 0.5, r_out = 2, h = 2 }", with "solid.sphere { r = r/2 }" ..
    ":at{x + 1.2, y, z}"),
  pair("a ball in a shell", "solid.hollow_sphere { r_in = 0.5, r_out = 2 }", with "solid.sphere { r = r/2 }" ..
    ":at{x + 1.2, y, z}"),
  pair("a drill beside a drill", "solid.box { x = 2, y = 2, z = 2 }", with "solid.cylinder { r = 0.2, h = 1.8 }" ..
    " - " .. with "solid.cylinder { r = r, h = h }" .. ":at{x + 0.4, y, z}", SIZES),
  pair("a box beside a drill", BOX, with "solid.cylinder { r = 0.2, h = 1 }" .. " - " ..
    with "solid.box { x = r, y = h, z = 0.4 }" .. ":at{x + 0.4, y, z}", SIZES),
  pair("a box beside a box", BOX, with "solid.box { x = 0.4, y = 0.3, z = 1 }" .. " - " ..
    with "solid.box { x = r, y = h, z = 0.4 }" .. ":at{x + 0.4, y, z}", SIZES),
  pair("a ball beside a box", BOX, with "solid.box { x = 0.4, y = 0.3, z = 1 }" .. " - " ..
    with "solid.sphere { r = r/2 }" .. ":at{x + 0.4, y, z}", SIZES),
  pair("a ball beside a drill", BOX, with "solid.cylinder { r = 0.2, h = 1 }" .. " - " ..
    with "solid.sphere { r = r/2 }" .. ":at{x + 0.4, y, z}", SIZES),
  pair("two drills at once", BOX, "(" .. with "solid.cylinder { r = 0.2, h = 1.8 }" .. " + " ..
    with "solid.cylinder { r = r, h = h }" .. ":at{x + 0.4, y, z})", SIZES),
}
for _, p in ipairs(pairs_of) do -- beside each other they meet in a lens or along an edge, where few points are
  if p[1]:find "beside" then p.near = 0.1 end
end
pairs_of[#pairs_of].near = 0.2 -- of the density half as many points are asked

-- ---- one pair ----

local state = 12345
local function uniform() -- Park and Miller
  state = state * 16807 % 2147483647
  return state / 2147483647
end

local function read(p)
  local names = {}
  for name in pairs(p[4]) do names[#names + 1] = name end
  table.sort(names)
  local params = {}
  for i, name in ipairs(names) do params[i] = name .. " = " .. p[4][name][3] end
  local job, why = scene.body(p[2] .. " - " .. p[3], params)
  return job, job and names or why
end

-- The least margin of the conditions of holes for the values; nil if there is none.
local function margin(job, values)
  local least
  for _, c in ipairs(job.model.conditions) do
    if c.text:find "^hole" then
      local e = R.todouble(evaluate.precise(c.e, values, 100))
      if not least or e < least then least = e end
    end
  end
  return least
end

for _, p in ipairs(pairs_of) do
  local job, names = read(p)
  if tap.ok(job, p[1] .. ": is a body", not job and names or nil) then
    tap.is(#job.model.unasked, 0, p[1] .. ": has conditions")
    local inside, outside, wrong = 0, 0, nil
    for _ = 1, DRAWS do
      local values, shown = {}, {}
      for i, name in ipairs(names) do
        local range = p[4][name]
        local x = range[3] + (range[1] + (range[2] - range[1]) * uniform() - range[3]) * uniform() ^ 0.5
        x = math.floor(x * 1e6) / 1e6
        values[name], shown[i] = R.decimal(x), name .. " = " .. x
      end
      local env = {}
      for k, v in pairs(values) do env[k] = v end
      for _, c in ipairs(validity.rounding(R.zero)) do env[c.sym.name] = c.value end
      local m = margin(job, env)
      if m and math.abs(m) > (p.near or NEAR) then
        local told = body_at(job, values)
        if m > 0 then inside = inside + 1 else outside = outside + 1 end
        if (told == nil) ~= (m > 0) then wrong = wrong or table.concat(shown, ", ") .. ": margin " .. m .. ", " ..
          (told or "inside") end
      end
    end
    tap.ok(not wrong, p[1] .. ": as the points say", wrong)
    tap.ok(inside > 0 and outside > 0, p[1] .. ": both answers occur", inside .. " inside, " .. outside ..
      " outside")
  end
end

tap.done()
