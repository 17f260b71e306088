#!/usr/bin/env lua5.4
-- handbook.t - every shape of the catalogue against the formulas of the handbooks.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The catalogue stores second moments per unit mass; the handbooks print moments of inertia, and here they are as the
-- handbooks print them (Beer and Johnston, Vector Mechanics, tables of mass moments; Meriam and Kraige, Dynamics,
-- table D/4).  Both sides are evaluated exactly, at random rational sizes, so there is no tolerance at all.  A shape
-- without a row here fails the test.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local catalogue = require "generator.mass.catalogue"

local POINTS = 8
local NAMES = { "xx", "yy", "zz", "xy", "xz", "yz" }

local function axial(m, x, z) return { m * x, m * x, m * z, 0, 0, 0 } end

-- args: the shape's arguments; params: symbols in them; measure: volume, area or length over pi^k; com; I about com;
-- points: named points.  e: the sizes, e.M the mass.
local rows = {
  ["solid.box"] = { args = "x = a, y = b, z = c", params = { "a", "b", "c" }, k = 0,
    measure = function(e) return e.a * e.b * e.c end,
    I = function(m, e)
      return { m * (e.b ^ 2 + e.c ^ 2) / 12, m * (e.a ^ 2 + e.c ^ 2) / 12, m * (e.a ^ 2 + e.b ^ 2) / 12, 0, 0, 0 }
    end,
    points = { corner = function(e) return { -e.a / 2, -e.b / 2, -e.c / 2 } end,
      centroid = function() return { 0, 0, 0 } end } },
  ["solid.sphere"] = { args = "r = r", params = { "r" }, k = 1,
    measure = function(e) return 4 * e.r ^ 3 / 3 end,
    I = function(m, e) return axial(m, 2 * e.r ^ 2 / 5, 2 * e.r ^ 2 / 5) end },
  ["solid.ellipsoid"] = { args = "a = a, b = b, c = c", params = { "a", "b", "c" }, k = 1,
    measure = function(e) return 4 * e.a * e.b * e.c / 3 end,
    I = function(m, e)
      local a, b, c = e.a ^ 2, e.b ^ 2, e.c ^ 2
      return { m * (b + c) / 5, m * (a + c) / 5, m * (a + b) / 5, 0, 0, 0 }
    end },
  ["solid.cylinder"] = { args = "r = r, h = h", params = { "r", "h" }, k = 1,
    measure = function(e) return e.r ^ 2 * e.h end,
    I = function(m, e) return axial(m, (3 * e.r ^ 2 + e.h ^ 2) / 12, e.r ^ 2 / 2) end,
    points = { base = function(e) return { 0, 0, -e.h / 2 } end, top = function(e) return { 0, 0, e.h / 2 } end } },
  ["solid.elliptic_cylinder"] = { args = "a = a, b = b, h = h", params = { "a", "b", "h" }, k = 1,
    measure = function(e) return e.a * e.b * e.h end,
    I = function(m, e)
      local a, b, h = e.a ^ 2, e.b ^ 2, e.h ^ 2
      return { m * (3 * b + h) / 12, m * (3 * a + h) / 12, m * (a + b) / 4, 0, 0, 0 }
    end },
  ["solid.tube"] = { args = "r_in = s, r_out = s + d, h = h", params = { "s", "d", "h" }, k = 1,
    measure = function(e) return ((e.s + e.d) ^ 2 - e.s ^ 2) * e.h end,
    I = function(m, e)
      local sum = e.s ^ 2 + (e.s + e.d) ^ 2
      return axial(m, (3 * sum + e.h ^ 2) / 12, sum / 2)
    end },
  ["solid.cone"] = { args = "r = r, h = h", params = { "r", "h" }, k = 1,
    measure = function(e) return e.r ^ 2 * e.h / 3 end, com = function(e) return { 0, 0, e.h / 4 } end,
    I = function(m, e) return axial(m, 3 * (4 * e.r ^ 2 + e.h ^ 2) / 80, 3 * e.r ^ 2 / 10) end,
    points = { apex = function(e) return { 0, 0, e.h } end } },
  ["solid.hemisphere"] = { args = "r = r", params = { "r" }, k = 1,
    measure = function(e) return 2 * e.r ^ 3 / 3 end, com = function(e) return { 0, 0, 3 * e.r / 8 } end,
    I = function(m, e) return axial(m, 83 * e.r ^ 2 / 320, 2 * e.r ^ 2 / 5) end },
  ["solid.torus"] = { args = "R = r + d, r = r", params = { "r", "d" }, k = 2,
    measure = function(e) return 2 * (e.r + e.d) * e.r ^ 2 end,
    I = function(m, e)
      local big = e.r + e.d
      return axial(m, (4 * big ^ 2 + 5 * e.r ^ 2) / 8, (4 * big ^ 2 + 3 * e.r ^ 2) / 4)
    end },
  ["plate.disc"] = { args = "r = r", params = { "r" }, k = 1,
    measure = function(e) return e.r ^ 2 end, I = function(m, e) return axial(m, e.r ^ 2 / 4, e.r ^ 2 / 2) end },
  ["plate.rectangle"] = { args = "x = a, y = b", params = { "a", "b" }, k = 0,
    measure = function(e) return e.a * e.b end,
    I = function(m, e) return { m * e.b ^ 2 / 12, m * e.a ^ 2 / 12, m * (e.a ^ 2 + e.b ^ 2) / 12, 0, 0, 0 } end,
    points = { corner = function(e) return { -e.a / 2, -e.b / 2, 0 } end } },
  ["rod.straight"] = { args = "length = l", params = { "l" }, k = 0,
    measure = function(e) return e.l end, I = function(m, e) return axial(m, e.l ^ 2 / 12, 0) end,
    points = { ["end"] = function(e) return { 0, 0, -e.l / 2 } end } },
  -- from p to p + l (2, 3, 6)/7: the length is l; I = m l^2/12 (1 - u u^T) with the unit vector u
  ["rod.between"] = { args = "from = {p, -p, 2*p}, to = {p + 2*l/7, -p + 3*l/7, 2*p + 6*l/7}",
    params = { "p", "l" }, k = 0,
    measure = function(e) return e.l end,
    com = function(e) return { e.p + e.l / 7, -e.p + 3 * e.l / 14, 2 * e.p + 3 * e.l / 7 } end,
    I = function(m, e)
      local s = m * e.l ^ 2 / 12 / 49
      return { 45 * s, 40 * s, 13 * s, -6 * s, -12 * s, -18 * s }
    end,
    points = { from = function(e) return { e.p, -e.p, 2 * e.p } end } },
  ["wire.hoop"] = { args = "r = r", params = { "r" }, k = 1,
    measure = function(e) return 2 * e.r end, I = function(m, e) return axial(m, e.r ^ 2 / 2, e.r ^ 2) end },
  ["shell.ellipsoid"] = { args = "a = r, b = r, c = r", params = { "r" }, k = 1, -- the sphere; others: algebra/special.t
    measure = function(e) return 4 * e.r ^ 2 end,
    I = function(m, e) return axial(m, 2 * e.r ^ 2 / 3, 2 * e.r ^ 2 / 3) end },
}

-- Are the expressions the numbers that want(env) gives, at random positive sizes?
local function holds(list, want, names, extra)
  for _ = 1, POINTS do
    local env = {}
    for _, name in ipairs(names) do env[name] = scene.rational() end
    for _, name in ipairs(extra or {}) do env[name] = scene.rational() end
    for i, v in ipairs(want(env)) do
      local got = scene.exact(list[i], env)
      if got ~= R.lift(v) then
        return false, string.format("entry %d: %s instead of %s", i, tostring(got), tostring(v))
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
  for i, x in ipairs(v) do out[i] = R.lift(x) end
  return out
end

for _, spec in ipairs(catalogue.list) do
  local name, row = spec.name, rows[spec.name]
  if name ~= "points" and name ~= "tensor" and tap.ok(row ~= nil, name .. ": has a row of handbook formulas") then
    local function com(e) return lifted(row.com and row.com(e) or { 0, 0, 0 }) end
    local params = { "M", table.unpack(row.params) }
    local defaults = { "M" }
    for i, p in ipairs(row.params) do defaults[i + 1] = p end
    local shape = name .. " { " .. row.args
    local about = assert(scene.body(shape .. ", mass = M }", defaults))
    local m = about.model
    tap.ok(holds({ m.mass }, function(e) return { e.M } end, params), name .. ": the mass is what was given")
    tap.ok(holds(m.inertia, function(e) return row.I(e.M, e) end, params),
      name .. ": tensor about the centroid as in the handbooks")
    local zeros = true
    for i = 4, 6 do
      if row.I(R.one, setmetatable({}, { __index = function() return R.one end }))[i] == 0 then
        zeros = zeros and m.inertia[i] == expr.zero
      end
    end
    tap.ok(zeros, name .. ": products of inertia that vanish do so structurally, as the expression 0")

    m = assert(scene.body(shape .. ", mass = M }", defaults, "origin = {0, 0, 0}")).model
    tap.ok(holds(m.com, com, params), name .. ": centre of mass in the natural frame")
    tap.ok(holds(m.inertia, function(e) return steiner(e.M, row.I(e.M, e), com(e)) end, params),
      name .. ": tensor about the frame's origin by Steiner's theorem")

    m = assert(scene.body(shape .. ", density = rho }", { "rho", table.unpack(row.params) })).model
    local per_pi = ratio.tidy(m.mass / expr.pi ^ row.k)
    tap.ok(holds({ per_pi }, function(e) return { e.rho * row.measure(e) } end, row.params, { "rho" }),
      name .. ": density times volume, area or length is the mass")
    local over = {}
    for i = 1, 6 do over[i] = ratio.tidy(m.inertia[i] / expr.pi ^ row.k) end
    tap.ok(holds(over, function(e) return row.I(e.rho * row.measure(e), e) end, row.params, { "rho" }),
      name .. ": the tensor goes with the mass that a density gives")

    local points = {}
    for point in pairs(row.points or {}) do points[#points + 1] = point end
    table.sort(points)
    for _, point in ipairs(points) do
      m = assert(scene.body(shape .. ", mass = M }", defaults, 'origin = "' .. point .. '"')).model
      local function arm(e)
        local c, p = com(e), lifted(row.points[point](e))
        return { c[1] - p[1], c[2] - p[2], c[3] - p[3] }
      end
      tap.ok(holds(m.com, arm, params), name .. ": the named point " .. point .. " is where it should be")
      tap.ok(holds(m.inertia, function(e) return steiner(e.M, row.I(e.M, e), arm(e)) end, params),
        name .. ": tensor about " .. point)
    end
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
