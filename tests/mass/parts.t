#!/usr/bin/env lua5.4
-- parts.t - composite bodies in named steps: their values are the tensor's, exactly, and the report tells them in
-- order.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle is the definition: every piece's handbook tensor and Steiner's term, summed, in exact rationals at random
-- sizes; no expression of the body is asked.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local parts = require "generator.mass.parts"
local driver = require "generator.driver"
local explain = require "generator.report.explain"

local POINTS = 5
local NAMES = { "xx", "yy", "zz", "xy", "xz", "yz" }

-- I + m (r^2 1 - r r^T)
local function steiner(m, I, r)
  local n = r[1] ^ 2 + r[2] ^ 2 + r[3] ^ 2
  return { I[1] + m * (n - r[1] ^ 2), I[2] + m * (n - r[2] ^ 2), I[3] + m * (n - r[3] ^ 2), I[4] - m * r[1] * r[2],
    I[5] - m * r[1] * r[3], I[6] - m * r[2] * r[3] }
end

local function box(m, x, y, z) -- Meriam and Kraige, table D/4
  return { m * (y ^ 2 + z ^ 2) / 12, m * (x ^ 2 + z ^ 2) / 12, m * (x ^ 2 + y ^ 2) / 12, 0, 0, 0 }
end
local function cylinder(m, r, h)
  local across = m * (3 * r ^ 2 + h ^ 2) / 12
  return { across, across, m * r ^ 2 / 2, 0, 0, 0 }
end
local function ball(m, r)
  local i = 2 * m * r ^ 2 / 5
  return { i, i, i, 0, 0, 0 }
end
local function nothing() return { 0, 0, 0, 0, 0, 0 } end

-- shape, parameters, and the pieces {mass, centre, tensor about it} at the sizes e
local bodies = {
  { "two boxes", "solid.box { x = a, y = b, z = c, mass = M1 }:at{a/2, 0, 0} + " ..
    "solid.box { x = c, y = a, z = b, mass = M2 }:at{0, a, b}", { "M1", "M2", "a", "b", "c" }, function(e)
      return { { e.M1, { e.a / 2, 0, 0 }, box(e.M1, e.a, e.b, e.c) }, { e.M2, { 0, e.a, e.b }, box(e.M2, e.c, e.a,
        e.b) } }
    end },
  { "a box with a hole", "solid.box { x = 4*a, y = 4*b, z = 4*c, density = rho } - " ..
    "solid.box { x = a, y = b, z = c, density = rho }:at{a, -b, c/2}", { "rho", "a", "b", "c" }, function(e)
      local m = e.rho * e.a * e.b * e.c
      return { { 64 * m, { 0, 0, 0 }, box(64 * m, 4 * e.a, 4 * e.b, 4 * e.c) },
        { -m, { e.a, -e.b, e.c / 2 }, box(-m, e.a, e.b, e.c) } }
    end },
  { "three of kinds",
    "solid.box { x = a, y = b, z = c, mass = M1 } + solid.sphere { r = a, mass = M2 }:at{b, 0, c} + " ..
    "solid.cylinder { r = b, h = a, mass = M3 }:at{-a, b, 0}", { "M1", "M2", "M3", "a", "b", "c" }, function(e)
      return { { e.M1, { 0, 0, 0 }, box(e.M1, e.a, e.b, e.c) }, { e.M2, { e.b, 0, e.c }, ball(e.M2, e.a) },
        { e.M3, { -e.a, e.b, 0 }, cylinder(e.M3, e.b, e.a) } }
    end },
  { "points, a tensor and turned boxes",
    "solid.box { x = a, y = b, z = c, mass = M1 }:turned{axis = \"z\", angle = pi/2} " ..
    "+ tensor { mass = M2, xx = 5, yy = 6, zz = 7, xy = 1, xz = -1, yz = 0.5 }:at{0, a, 0} + " ..
    "points { {M1, b, 0, c}, {M2, 0, 0, -a} } + solid.sphere { r = b, mass = M1 }:mirrored \"x\":at{a, b, c}",
    { "M1", "M2", "a", "b", "c" }, function(e)
      return { { e.M1, { 0, 0, 0 }, box(e.M1, e.b, e.a, e.c) },
        { e.M2, { 0, e.a, 0 }, { 5, 6, 7, 1, -1, R.new(1, 2) } }, { e.M1, { e.b, 0, e.c }, nothing() },
        { e.M2, { 0, 0, -e.a }, nothing() }, { e.M1, { e.a, e.b, e.c }, ball(e.M1, e.b) } }
    end },
}

-- mass, centre and tensor about `about` (nil: the centre) of the pieces
local function oracle(list, about)
  local mass, first = R.zero, { R.zero, R.zero, R.zero }
  for _, p in ipairs(list) do
    mass = mass + p[1]
    for i = 1, 3 do first[i] = first[i] + p[1] * p[2][i] end
  end
  local com = { first[1] / mass, first[2] / mass, first[3] / mass }
  about = about or com
  local I = { R.zero, R.zero, R.zero, R.zero, R.zero, R.zero }
  for _, p in ipairs(list) do
    local piece = steiner(p[1], p[3], { p[2][1] - about[1], p[2][2] - about[2], p[2][3] - about[3] })
    for n = 1, 6 do I[n] = I[n] + piece[n] end
  end
  return mass, com, I
end

local function counter()
  local taken = {}
  return function(name)
    local unique, n = name, 1
    while taken[unique] do
      n = n + 1
      unique = name .. n
    end
    taken[unique] = true
    return unique
  end
end

local far = { R.new(2) ^ 30, -(R.new(2) ^ 30), R.new(1, 3) }
local places = {
  { "its centre of mass" }, { "the frame's origin", { R.zero, R.zero, R.zero } }, { "a far point", far },
}
for _, b in ipairs(bodies) do
  local m = assert(scene.body(b[2], b[3])).model
  for _, place in ipairs(places) do
    local P = place[2] and { expr.num(place[2][1]), expr.num(place[2][2]), expr.num(place[2][3]) }
    local p = parts.of(m.body, P, counter())
    local wrong, earlier = {}, {}
    local entries = {}
    for n = 1, 6 do entries[n] = p:entry(n) end
    for _, name in ipairs(b[3]) do earlier[name] = true end
    for _, s in ipairs(p:needed(entries)) do
      for _, x in ipairs(expr.symbols(s.e)) do
        if not earlier[x.name] then wrong[#wrong + 1] = s.name .. " needs " .. x.name .. ", which comes later" end
      end
      if earlier[s.name] then wrong[#wrong + 1] = s.name .. " twice" end
      earlier[s.name] = true
    end
    for _ = 1, POINTS do
      local e = {}
      for _, name in ipairs(b[3]) do e[name] = scene.rational() end
      local env = setmetatable({}, { __index = e })
      local mass, com, I = oracle(b[4](e), place[2])
      for _, s in ipairs(p.list) do
        env[s.name] = scene.exact(s.e, env)
        if scene.exact(s.pure, e) ~= env[s.name] then wrong[#wrong + 1] = "pure " .. s.name end
      end
      if scene.exact(p.mass, env) ~= mass then wrong[#wrong + 1] = "mass" end
      for k = 1, 3 do
        if scene.exact(p.com[k], env) ~= com[k] then wrong[#wrong + 1] = "com " .. k end
        local j = k % 3 + 1
        if scene.exact(p:difference(j, k), env) ~= I[j] - I[k] then wrong[#wrong + 1] = "difference " .. j .. k end
      end
      for n = 1, 6 do
        if scene.exact(entries[n], env) ~= I[n] then wrong[#wrong + 1] = NAMES[n] end
      end
    end
    tap.is(table.concat(wrong, "; "), "", b[1] .. " about " .. place[1] ..
      ": steps in order, mass, centre, tensor and differences are those of the definition")
  end
end

-- ---- when there are steps ----

tap.ok(not parts.wanted(assert(scene.body("solid.box { x = a, y = 1, z = 1, mass = 1 }", { "a" })).model.body),
  "one piece needs no steps")
tap.ok(not parts.wanted(assert(scene.body("solid.box { x = 1, y = 1, z = 1, mass = 1 } + " ..
  "solid.sphere { r = 1, mass = 1 }:at{1, 0, 0}")).model.body), "nor do numbers")

-- ---- the report ----

do
  local shape = "solid.box { x = a, y = b, z = c, density = rho }:at{a/2, 0, 0} + " ..
    "solid.cylinder { r = b, h = a, mass = M }:turned{axis = \"x\", angle = pi/3}:at{0, a, b} + " ..
    "solid.box { x = b, y = b, z = b, mass = M }:scaled{2, 1, 1}:sheared{xy = 0.5}:mirrored \"z\" - " ..
    "solid.sphere { r = a/8, density = rho }:at{a/2, 0, 0}"
  local job = assert(scene.body(shape, { "rho = 7", "M", "a", "b", "c" }))
  job = driver.code(driver.plan(job, { real = "double", command = "" }))
  local text = explain.text(job, "text")
  for i, line in ipairs {
    "1. solid.box (line 6), of density rho, moved by (a/2, 0, 0)",
    "2. solid.cylinder (line 6), turned about (1, 0, 0) by pi/3, moved by (0, a, b)",
    "3. solid.box (line 6), scaled by (2, 1, 1), sheared by the rows (1, 1/2, 0) (0, 1, 0) (0, 0, 1), " ..
      "scaled by (1, 1, -1)",
    "4. minus solid.sphere (line 6), of density rho, moved by (a/2, 0, 0)",
  } do
    local _, at = text:find("\n  " .. line .. "\n", 1, true)
    tap.ok(at, "explain: piece " .. i .. " with its placement", line)
    tap.ok(at and text:find("^    mass = ", at + 1), "explain: and the mass of piece " .. i)
  end
  local last = 0
  local ordered = job.model.parts ~= nil
  for _, s in ipairs(job.model.parts and job.model.parts:needed(job.model.parts.entries) or {}) do
    local at = text:find("\n  " .. s.name .. " = ", 1, true)
    if not s.name:find "^m%d+$" then
      ordered = ordered and at and at > last
      last = at or last
    end
  end
  tap.ok(ordered and last > 0, "explain: the steps stand in the order in which they are computed")
  tap.ok(text:find("(Huygens, Steiner)", 1, true), "explain: and where the shifts come from")
end

tap.done()
