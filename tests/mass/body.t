#!/usr/bin/env lua5.4
-- body.t - placement: shifted, turned, scaled and mirrored bodies, sums and holes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The laws are written out here by their definitions (Goldstein, Poole, Safko, 3rd ed., 5.7 to 5.23): a turned body has
-- A I A^T, a scaled one K Sigma K with the second moments Sigma = tr(I)/2 1 - I, a shifted one Steiner's term, a sum
-- the sum.  Identities are proved as identities of rational functions, so there is no tolerance.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"

local function lift(v)
  local out = {}
  for i, x in ipairs(v) do out[i] = expr.lift(x) end
  return out
end

local function same(got, want)
  for i, w in ipairs(want) do
    local d = got[i] - expr.lift(w)
    if not ratio.iszero(d) then return false, "entry " .. i .. " is off by " .. text.of((ratio.tidy(d))) end
  end
  return true
end

local function model(shape, params, more) return assert(scene.body(shape, params, more)).model end

-- ---- a shift of the origin ----

-- I + M (d^2 1 - d d^T)
local function steiner(I, M, d)
  local n = d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2
  return { I[1] + M * (n - d[1] ^ 2), I[2] + M * (n - d[2] ^ 2), I[3] + M * (n - d[3] ^ 2), I[4] - M * d[1] * d[2],
    I[5] - M * d[1] * d[3], I[6] - M * d[2] * d[3] }
end

do
  local M, r, h = expr.sym("M", 1, true), expr.sym("r", 2), expr.sym("h", 2)
  local u, v = expr.sym("u", 2), expr.sym("v", 2)
  local cone = "solid.cone { r = r, h = h, mass = M }"
  local params = { "M", "r", "h", "u", "v" }
  local free = model(cone, params)
  local moved = model(cone .. ":at{u, -v, 2*u}", params, "origin = {v, 0, u}")
  local d = { u - v, -v, u + h / 4 }
  tap.ok(same(moved.com, d), "a cone moved to (u, -v, 2 u), seen from (v, 0, u): its centre of mass")
  tap.ok(same(moved.inertia, steiner(free.centroidal, M, d)), "the same: its tensor is Steiner's")
  tap.ok(same(moved.centroidal, free.centroidal), "the tensor about the centre of mass does not move with the body")
  local twice = model(cone .. ":at{u, 0, 0}:at{0, v, h}", params, "origin = {0, 0, 0}")
  local once = model(cone .. ":at{u, v, h}", params, "origin = {0, 0, 0}")
  tap.ok(same(twice.inertia, once.inertia) and same(twice.com, once.com), "two shifts are one")
  tap.ok(same(once.inertia, { M * (3 * r ^ 2 / 20 + h ^ 2 * R.new(3, 80)) + M * (v ^ 2 + (h * R.new(5, 4)) ^ 2) }),
    "the shifted cone's I_xx by hand")
  local named = model(cone .. ":at{u, v, h}", params, 'origin = "apex"')
  tap.ok(same(named.com, { 0, 0, h * R.new(-3, 4) }), "a named point moves with its shape")
end

-- ---- rotation ----

local function matmul(A, B)
  local C = {}
  for i = 1, 3 do
    C[i] = {}
    for j = 1, 3 do C[i][j] = A[i][1] * B[1][j] + A[i][2] * B[2][j] + A[i][3] * B[3][j] end
  end
  return C
end

local function transposed(A)
  return { { A[1][1], A[2][1], A[3][1] }, { A[1][2], A[2][2], A[3][2] }, { A[1][3], A[2][3], A[3][3] } }
end

local function full(I) return { { I[1], I[4], I[5] }, { I[4], I[2], I[6] }, { I[5], I[6], I[3] } } end
local function six(A) return { A[1][1], A[2][2], A[3][3], A[1][2], A[1][3], A[2][3] } end
local function congruent(A, I) return six(matmul(matmul(A, full(I)), transposed(A))) end

-- Rodrigues: R = c 1 + s [n]x + (1 - c) n n^T
local function rodrigues(n, s, c)
  local A = {}
  local cross = { { 0, -n[3], n[2] }, { n[3], 0, -n[1] }, { -n[2], n[1], 0 } }
  for i = 1, 3 do
    A[i] = {}
    for j = 1, 3 do A[i][j] = (i == j and c or 0) + s * cross[i][j] + (1 - c) * n[i] * n[j] end
  end
  return A
end

do
  local params = { "M", "a", "b", "c", "phi" }
  local box = "solid.box { x = a, y = b, z = c, mass = M }"
  local plain = model(box, params).inertia
  local phi = expr.sym("phi", 2)
  local s, c = expr.call("sin", phi), expr.call("cos", phi)
  for i, axis in ipairs { "x", "y", "z" } do
    local n = { 0, 0, 0 }
    n[i] = 1
    local turned = model(box .. ":turned{axis = \"" .. axis .. "\", angle = phi}", params)
    tap.ok(same(turned.inertia, congruent(rodrigues(lift(n), s, c), plain)),
      "a box turned by phi about " .. axis .. " has the tensor A I A^T")
  end
  local n = { R.new(2, 7), R.new(3, 7), R.new(-6, 7) }
  local oblique = model(box .. ":turned{axis = {2, 3, -6}, angle = phi}", params)
  tap.ok(same(oblique.inertia, congruent(rodrigues(lift(n), s, c), plain)),
    "a box turned by phi about (2, 3, -6), whose length is 7: A I A^T")

  -- the quaternion (2, 1, -2, 4)/5 in rationals: w^2 + |v|^2 = 25
  local A = rodrigues(lift { R.new(1), R.new(-2), R.new(4) }, expr.zero, expr.zero)
  local w, v = R.new(2, 5), { R.new(1, 5), R.new(-2, 5), R.new(4, 5) }
  for i = 1, 3 do
    for j = 1, 3 do -- R = (w^2 - v^2) 1 + 2 v v^T + 2 w [v]x
      local vv = v[1] * v[1] + v[2] * v[2] + v[3] * v[3]
      local k = 6 - i - j
      local cross = i == j and R.zero or v[k] * ((j - i) % 3 == 1 and -1 or 1)
      A[i][j] = expr.lift((i == j and w * w - vv or R.zero) + v[i] * v[j] * 2 + cross * w * 2)
    end
  end
  local by_quaternion = model(box .. ":turned{quaternion = {2, 1, -2, 4}}", params)
  tap.ok(same(by_quaternion.inertia, congruent(A, plain)),
    "a quaternion of any length turns: A I A^T with (2, 1, -2, 4)/5")

  -- turning moves the centre of mass with the axes through the frame's origin: active rotation
  local cone = "solid.cone { r = a, h = b, mass = M }"
  local b = expr.sym("b", 2)
  local tipped = model(cone .. ":turned{axis = \"x\", angle = pi/2}", { "M", "a", "b" }, "origin = {0, 0, 0}")
  tap.ok(same(tipped.com, { 0, -b / 4, 0 }),
    "a cone turned by +90 degrees about x points along -y: rotations are active")
  tipped = model(cone .. ":at{0, 0, 4*b}:turned{axis = \"y\", angle = pi/2}", { "M", "a", "b" }, "origin = {0, 0, 0}")
  tap.ok(same(tipped.com, { 17 * b / 4, 0, 0 }), "at, then turned: the shift is turned with the body")
  tipped = model(cone .. ":turned{axis = \"y\", angle = pi/2}:at{0, 0, 4*b}", { "M", "a", "b" }, "origin = {0, 0, 0}")
  tap.ok(same(tipped.com, { b / 4, 0, 4 * b }), "turned, then at: the shift is not turned")
  local there = model(box .. ":turned{axis = {1, 2, 2}, angle = phi}:turned{axis = {1, 2, 2}, angle = -phi}", params)
  tap.ok(same(there.inertia, plain), "turned there and back: the tensor of the start")
  local sixth = model(box .. string.rep(":turned{axis = \"z\", angle = pi/6}", 3), params)
  tap.ok(sixth.inertia[1] == plain[2] and sixth.inertia[2] == plain[1] and sixth.inertia[4] == expr.zero,
    "three turns of 30 degrees are exactly one of 90: the radicals are gone")
end

-- ---- scaling and mirrors ----

do
  local M, a = expr.sym("M", 1, true), expr.sym("a", 2)
  local params, factors = { "M", "a", "b", "c" }, { "M", "a", "k1", "k2", "k3" }
  local ball = model("solid.sphere { r = a, mass = M }:scaled{k1, k2, k3}", factors)
  local ellipsoid = "solid.ellipsoid { a = a*k1, b = a*k2, c = a*k3, "
  tap.ok(same(ball.inertia, model(ellipsoid .. "mass = M }", factors).inertia),
    "a ball scaled by (k1, k2, k3) is the ellipsoid, its mass kept")
  ball = model("solid.sphere { r = a, density = 7 }:scaled{k1, k2, k3}", factors)
  ellipsoid = model(ellipsoid .. "density = 7 }", factors)
  local env = { a = R.new(2), k1 = R.new(3), k2 = R.new(5), k3 = R.new(7) }
  tap.ok(scene.exact(ratio.tidy(ball.mass / expr.pi), env) == scene.exact(ratio.tidy(ellipsoid.mass / expr.pi), env),
    "a density is kept by scaling: the mass follows the volume")
  local cube, k = model("solid.box { x = a, y = a, z = a, mass = M }:scaled{k}", { "M", "a", "k" }), expr.sym("k", 2)
  local moment = M * a ^ 2 * k ^ 2 / 6
  tap.ok(same(cube.inertia, { moment, moment, moment, 0, 0, 0 }), "one factor scales all directions")
  -- a bar along (1, 1, 0), mirrored in x: along (-1, 1, 0); products with x change their sign, the rest stays
  local bar = "rod.between { from = {0, 0, 0}, to = {a, b, c}, mass = M }"
  local plain = model(bar, params, "origin = {0, 0, 0}")
  for i, axis in ipairs { "x", "y", "z" } do
    local image = model(bar .. ":mirrored \"" .. axis .. "\"", params, "origin = {0, 0, 0}")
    local sign = { 1, 1, 1 }
    sign[i] = -1
    local I, S = plain.inertia, { 1, 1, 1, sign[1] * sign[2], sign[1] * sign[3], sign[2] * sign[3] }
    local want, com = {}, {}
    for n = 1, 6 do want[n] = S[n] * I[n] end
    for n = 1, 3 do com[n] = sign[n] * plain.com[n] end
    tap.ok(same(image.inertia, want) and same(image.com, com), "mirrored in " .. axis ..
      ": the products with " .. axis .. " change sign, moments stay")
  end
  tap.ok(same(model(bar .. ":scaled{2, 1, 1}", params).inertia,
    model("rod.between { from = {0, 0, 0}, to = {2*a, b, c}, mass = M }", params).inertia),
    "a scaled rod is the rod between the scaled ends")
end

-- ---- sums and holes ----

do
  local params = { "rho", "a", "b", "c" }
  local left = "solid.box { x = a, y = b, z = c, density = rho }:at{a/2, 0, 0}"
  local right = "solid.box { x = a, y = b, z = c, density = rho }:at{-a/2, 0, 0}"
  local whole = model("solid.box { x = 2*a, y = b, z = c, density = rho }", params)
  local halves = model(left .. " + " .. right, params)
  tap.ok(same(halves.inertia, whole.inertia) and same({ halves.mass }, { whole.mass }), "two halves make the box")
  local back = model("solid.box { x = 2*a, y = b, z = c, density = rho } - " .. left, params, "origin = {0, 0, 0}")
  local want = model(right, params, "origin = {0, 0, 0}")
  tap.ok(same(back.inertia, want.inertia) and same(back.com, want.com) and same({ back.mass }, { want.mass }),
    "the box without one half is the other half: mass, centre and tensor")
  local tube = model("solid.tube { r_in = a, r_out = a + b, h = c, density = 3 }", { "a", "b", "c" })
  local bored = model("solid.cylinder { r = a + b, h = c, density = 3 } - solid.cylinder { r = a, h = c, density = 3 }",
    { "a", "b", "c" })
  tap.ok(same(bored.inertia, tube.inertia) and same({ bored.mass }, { tube.mass }), "a bored cylinder is the tube")
  local ring = model("extrude { profile = {{0, 0}, {a, 0}, {a, b}, {0, 0}}, h = c, mass = 3 }", { "a", "b", "c" })
  local open = model("extrude { profile = {{0, 0}, {a, 0}, {a, b}}, h = c, mass = 3 }", { "a", "b", "c" })
  tap.ok(same(ring.inertia, open.inertia) and same(ring.com, open.com), "a last corner on the first changes nothing")
  local s = model("(points{ {2, a, 0, 0} } + points{ {3, 0, b, 0} }) + points{ {5, 0, 0, c} }", { "a", "b", "c" })
  local t = model("points{ {5, 0, 0, c}, {3, 0, b, 0}, {2, a, 0, 0} }", { "a", "b", "c" })
  tap.ok(same(s.inertia, t.inertia) and same(s.com, t.com), "the order and the grouping of a sum do not matter")
  local group = model("(" .. left .. " + solid.sphere { r = c, density = rho })" ..
    ":turned{axis = \"z\", angle = pi/2}:at{0, 0, b}", params, "origin = {0, 0, 0}")
  local single = model("solid.box { x = b, y = a, z = c, density = rho }:at{0, a/2, b} + " ..
    "solid.sphere { r = c, density = rho }:at{0, 0, b}", params, "origin = {0, 0, 0}")
  tap.ok(same(group.inertia, single.inertia) and same(group.com, single.com), "a placed sum is the sum of the placed")
  -- a wheel of n equal particles: the exact radicals of cos(2 pi k/n) cancel to a symmetric top
  local rows = {}
  for k = 0, 11 do rows[#rows + 1] = string.format("{1, a*cos(%d*pi/6), a*sin(%d*pi/6), 0}", k, k) end
  ring = model("points { " .. table.concat(rows, ", ") .. " }", { "a" })
  local a = expr.sym("a", 2)
  tap.ok(same(ring.inertia, { 6 * a ^ 2, 6 * a ^ 2, 12 * a ^ 2, 0, 0, 0 }) and ring.structure.kind == "symmetric",
    "twelve particles on a ring: 6 a^2, 6 a^2, 12 a^2, a symmetric top although the coordinates are radicals")
end

-- ---- bodies without any symmetry ----

-- The inverse of such a tensor is a large rational function; reading the scene must end, and soon.
for _, case in ipairs {
  { "three particles with two symbolic masses and lengths", { "M", "M1", "a", "b" },
    "points { {M, a, b, a}, {M1, -b, 2*a, a}, {3, b, -a, 3*b} }" },
  { "three particles in general position, all symbolic", { "M", "M1", "M2", "a", "b", "c" },
    "points { {M, a, b, c}, {M1, -b, 2*c, a}, {M2, c, -a, 3*b} }" },
  { "a box turned by two symbolic angles", { "M", "a", "b", "c", "phi", "phi1" }, [[
    solid.box { x = a, y = b, z = c, mass = M }:turned{axis = "x", angle = phi}:turned{axis = "z", angle = phi1}]] },
} do
  local start = os.clock()
  local fine, job = pcall(scene.body, case[3], case[2], "origin = {0, 0, 0}")
  -- 2 s of processor time: twenty times what a scene may take (100 ms), so that a slow machine passes too
  tap.ok(fine and job and os.clock() - start < 2, case[1] .. ": the scene is read within 2 s",
    fine and string.format("%.1f s", os.clock() - start) or tostring(job))
end

tap.done()
