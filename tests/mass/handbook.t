#!/usr/bin/env lua5.4
-- handbook.t - every shape of the catalogue against the formulas of the handbooks.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The catalogue stores second moments per unit mass; the handbooks print moments of inertia (tests/handbook.lua has
-- them
-- with their sources). Both sides are evaluated at random rational sizes: exactly, where they are rational, so that
-- there
-- is no tolerance.  A shape without a row fails the test.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local text = require "generator.formula.text"
local handbook = require "tests.handbook"
local catalogue = require "generator.mass.catalogue"

local POINTS = 4
local NAMES = { "xx", "yy", "zz", "xy", "xz", "yz" }

-- ---- exact numbers ----

local functions = { pi = expr.pi, sqrt = expr.sqrt }
for _, name in ipairs { "abs", "sin", "cos", "sinh", "cosh" } do
  functions[name] = function(x) return expr.call(name, x) end
end

tap.ok(scene.same(expr.pi * 2, 2 * expr.pi) and not scene.same(expr.pi, expr.lift "355/113") and
  not scene.same(expr.lift "1/3", expr.lift(1 / 3)), "the comparison tells numbers apart")

-- Are the expressions what want(sizes) gives, at random positive sizes?
local function holds(list, want, names)
  for _ = 1, POINTS do
    local sizes, map = {}, {}
    for _, name in ipairs(names) do sizes[name] = expr.num(scene.rational()) end
    for _, e in ipairs(list) do
      for _, s in ipairs(expr.symbols(e)) do map[s] = sizes[s.name] end
    end
    for i, v in ipairs(want(sizes)) do
      local got = calculus.substitute(list[i], map)
      if not scene.same(got, expr.lift(v)) then
        return false, string.format("entry %d: %s instead of %s", i, text.of(got), text.of(expr.lift(v)))
      end
    end
  end
  return true
end

-- I + m (r^2 1 - r r^T): Steiner, from the centre of mass to the point at -r from it
local function steiner(m, I, r)
  local n = r[1] ^ 2 + r[2] ^ 2 + r[3] ^ 2
  return { I[1] + m * (n - r[1] ^ 2), I[2] + m * (n - r[2] ^ 2), I[3] + m * (n - r[3] ^ 2), I[4] - m * r[1] * r[2],
    I[5] - m * r[1] * r[3], I[6] - m * r[2] * r[3] }
end

local function lifted(v)
  local out = {}
  for i, x in ipairs(v) do out[i] = expr.lift(x) end
  return out
end

local function times(m, I)
  local out = {}
  for i, x in ipairs(I) do out[i] = m * x end
  return out
end

local function sorted(t)
  local list = {}
  for k in pairs(t) do list[#list + 1] = k end -- in hash order, so:
  table.sort(list)
  return list
end

-- ---- every shape ----

local seen = {}
for _, row in ipairs(handbook.rows) do seen[row.shape] = true end
for _, row in ipairs(tier.every(4, handbook.rows)) do
  local what = row.shape .. " { " .. row.args .. " }"
  if #what > 60 then what = row.shape .. " { " .. string.sub(row.args, 1, 40) .. " ... }" end
  local function values(e) return handbook.values(row, e, functions) end
  local names = { "M", table.unpack(row.params) }
  local defaults = {}
  for i, p in ipairs(names) do defaults[i] = row.at[p] and string.format("%s = %.17g", p, row.at[p]) or p end
  local shape = row.shape .. " { " .. row.args
  local function model(amount, more)
    return assert(scene.body(shape .. ", " .. amount .. " }", defaults, more)).model
  end
  local m = model "mass = M"
  tap.ok(holds({ m.mass }, function(e) return { e.M } end, names), what .. ": the mass is what was given")
  tap.ok(holds(m.inertia, function(e) return times(e.M, values(e).I) end, names),
    what .. ": tensor about the centroid as in the handbooks")
  local unlike = {} -- sizes by which nothing is zero that is not always
  for i, p in ipairs(row.params) do unlike[p] = expr.num(R.new(7 * i * i * i + 2, 3)) end
  local zeros = true
  for i, x in ipairs(values(unlike).I) do
    if x == 0 or x == expr.zero then zeros = zeros and m.inertia[i] == expr.zero end
  end
  tap.ok(zeros, what .. ": entries that vanish do so structurally, as the expression 0")

  m = model("mass = M", "origin = {0, 0, 0}")
  tap.ok(holds(m.com, function(e) return values(e).com end, names), what .. ": centre of mass in the natural frame")
  tap.ok(holds(m.inertia, function(e) return steiner(e.M, times(e.M, values(e).I), lifted(values(e).com)) end, names),
    what .. ": tensor about the frame's origin by Steiner's theorem")

  defaults[1] = "rho"
  m = model "density = rho"
  names[1] = "rho"
  tap.ok(holds({ m.mass }, function(e) return { e.rho * values(e).measure } end, names),
    what .. ": density times volume, area or length is the mass")
  tap.ok(holds(m.inertia, function(e) return times(e.rho * values(e).measure, values(e).I) end, names),
    what .. ": the tensor goes with the mass that a density gives")
  defaults[1], names[1] = "M", "M"

  local points = sorted(values(unlike).points)
  local have = sorted(m.body.points)
  for i = #have, 1, -1 do
    if have[i] == "centroid" then table.remove(have, i) end
  end
  tap.is(table.concat(have, " "), table.concat(points, " "), what .. ": its named points")
  for _, point in ipairs(points) do
    m = model("mass = M", 'origin = "' .. point .. '"')
    local function arm(e)
      local v = values(e)
      local c, p = lifted(v.com), lifted(v.points[point])
      return { c[1] - p[1], c[2] - p[2], c[3] - p[3] }
    end
    tap.ok(holds(m.com, arm, names), what .. ": the named point " .. point .. " is where it should be")
    tap.ok(holds(m.inertia, function(e) return steiner(e.M, times(e.M, values(e).I), arm(e)) end, names),
      what .. ": tensor about " .. point)
  end
end

for _, spec in ipairs(catalogue.list) do
  if not (spec.reader or spec.name == "tensor") then -- regions: region.t; points, tensor: below
    tap.ok(seen[spec.name], spec.name .. ": has a row of handbook formulas")
  end
end

-- ---- sizes that a double could not carry ----

do
  -- box 2^27 x 1 x 2^-27 about a point 2^30 away in each direction: I_xx = (b^2 + c^2)/12 + 2 2^60, every digit kept
  local m = assert(scene.body('solid.box { x = 2^27, y = 1, z = exact("1/134217728"), mass = 1 }', {},
    "origin = {2^30, 2^30, 2^30}")).model
  local far = R.new(2) ^ 60
  local small, large = R.new(2) ^ -54, R.new(2) ^ 54
  local want = { (1 + small) / 12 + 2 * far, (large + small) / 12 + 2 * far, (large + 1) / 12 + 2 * far, -far, -far,
    -far }
  for i = 1, 6 do
    tap.ok(m.inertia[i].kind == "num" and m.inertia[i].value == want[i],
      "plate 2^27 x 1 x 2^-27 about a point 2^30 away: I" .. NAMES[i] .. " is exact",
      tostring(m.inertia[i].value) .. " instead of " .. tostring(want[i]))
  end
  -- there and back: the shift leaves nothing behind
  m = assert(scene.body('solid.box { x = a, y = b, z = c, mass = M }:at{2^30, 2^30, -2^30}:at{-2^30, -2^30, 2^30}',
    { "M", "a", "b", "c" }, "origin = {0, 0, 0}")).model
  local plain = assert(scene.body('solid.box { x = a, y = b, z = c, mass = M }', { "M", "a", "b", "c" })).model
  local same = true
  for i = 1, 6 do same = same and m.inertia[i] == plain.inertia[i] end
  tap.ok(same, "a body that is moved 2^30 m away and back has the very same tensor expressions")
end

-- ---- shapes without sizes ----

do
  -- particles: I = sum m (r^2 1 - r r^T), the definition
  local m = assert(scene.body("points { {M, a, b, 0}, {M1, -b, 2*a, 0}, {3, b, -a, 0}, {2, 0, 0, a} }",
    { "M", "M1", "a", "b" }, "origin = {0, 0, 0}")).model
  local function particles(e)
    local zero = R.zero
    return { { e.M, e.a, e.b, zero }, { e.M1, -e.b, 2 * e.a, zero }, { R.new(3), e.b, -e.a, zero },
      { R.new(2), zero, zero, e.a } }
  end
  local all = { "M", "M1", "a", "b" }
  tap.ok(holds(m.inertia, function(e)
    local I = { 0, 0, 0, 0, 0, 0 }
    for _, p in ipairs(particles(e)) do I = steiner(p[1], I, { p[2], p[3], p[4] }) end
    return I
  end, all), "points: the tensor is the sum of the definition")
  tap.ok(holds(m.com, function(e)
    local total, first = R.zero, { R.zero, R.zero, R.zero }
    for _, p in ipairs(particles(e)) do
      total = total + p[1]
      for i = 1, 3 do first[i] = first[i] + p[1] * p[i + 1] end
    end
    return { first[1] / total, first[2] / total, first[3] / total }
  end, all), "points: the centre of mass is the mean of the positions")

  -- a tensor as given, about the centre of mass and about the origin
  local entries = "xx = 7, yy = 8, zz = 9, xy = 1, xz = -2, yz = 0.5"
  m = assert(scene.body("tensor { mass = 2, com = {0.5, -0.25, 1}, " .. entries .. " }", {},
    "origin = {0, 0, 0}")).model
  local given, arm = lifted { 7, 8, 9, 1, -2, 0.5 }, lifted { 0.5, -0.25, 1 }
  tap.ok(holds(m.centroidal, function() return given end, {}), "tensor: entries about the centre of mass are kept")
  tap.ok(holds(m.inertia, function() return steiner(R.new(2), given, arm) end, {}),
    "tensor: about another origin Steiner's term is added")
  m = assert(scene.body("tensor { mass = 2, com = {0.5, -0.25, 1}, about = \"origin\", " .. entries .. " }", {},
    "origin = {0, 0, 0}")).model
  tap.ok(holds(m.inertia, function() return given end, {}),
    "tensor about = \"origin\": the entries belong to the origin")
  tap.ok(holds(m.centroidal, function() return steiner(R.new(-2), given, arm) end, {}),
    "tensor about = \"origin\": about the centre of mass Steiner's term is taken off")
end

tap.done()
