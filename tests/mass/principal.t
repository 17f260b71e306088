#!/usr/bin/env lua5.4
-- principal.t - which structure a tensor has, its axes in closed form, and the numeric axes of reports.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Tensors are built from the answer: alpha 1 + beta k k^T with symbols is symmetric about k, whatever k is.  What is
-- found must rebuild the tensor identically.  Near misses differ from such a tensor by 1e-40 in one entry and must not
-- be taken for symmetric.  The numeric axes are judged exactly (tests/mass/axes.lua).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local principal = require "generator.mass.principal"
local jacobi = require "generator.mass.jacobi"
local axes = require "tests.mass.axes"

local zero, one = expr.zero, expr.one
local alpha, beta = expr.sym("alpha", 2, true), expr.sym("beta", 2)
local x, y, z = expr.sym("x", 2), expr.sym("y", 2), expr.sym("z", 2)

local function lift(v)
  local out = {}
  for i, e in ipairs(v) do out[i] = expr.lift(e) end
  return out
end

-- a 1 + b k k^T
local function axial(a, b, k)
  return { a + b * k[1] ^ 2, a + b * k[2] ^ 2, a + b * k[3] ^ 2, b * k[1] * k[2], b * k[1] * k[3], b * k[2] * k[3] }
end

local function equal(I, J)
  for n = 1, 6 do
    if not ratio.iszero(I[n] - J[n]) then return false end
  end
  return true
end

-- I = alpha 1 + (axial - alpha) k k^T/k2, as the classification claims
local function rebuilt(s)
  return axial(s.alpha, (s.axial - s.alpha) / s.k2, s.k)
end

local function is(I, kind, name)
  local s = principal.classify(lift(I))
  tap.is(s.kind, kind, name)
  return s
end

-- ---- spheres, and nothing ----

do
  local s = is({ alpha, alpha, alpha, 0, 0, 0 }, "sphere", "three equal moments: a sphere")
  tap.ok(s.alpha == alpha and not s.nothing and not s.rod, "its moment is alpha")
  local hidden = (x + y) ^ 2 / 4 - (x - y) ^ 2 / 4
  is({ hidden, x * y, x * y * (x + 1) / (x + 1), x - x, zero, zero }, "sphere",
    "equal moments that are written in different ways are equal")
  s = is({ 0, 0, 0, 0, 0, 0 }, "sphere", "no moment at all is a sphere")
  tap.ok(s.nothing, "and is marked as nothing")
end

-- ---- symmetric about any direction ----

local directions = {
  { "x", { one, zero, zero } }, { "y", { zero, one, zero } }, { "z", { zero, zero, one } },
  { "a direction in the plane xy", { x, y, zero } }, { "a direction in the plane xz", { x, zero, -z } },
  { "a direction in the plane yz", { zero, 3 * y, z } }, { "a direction with three symbols", { x, y, z } },
  { "(1, -1, 1)", lift { 1, -1, 1 } }, { "(-1, -1, 1)", lift { -1, -1, 1 } },
  { "a direction 1e-20 off the z axis", lift { "1e-20", 0, 1 } },
  { "a direction with a root", { one, expr.sqrt(2), expr.sqrt(3) } },
  { "a direction at angles", { expr.call("cos", x), expr.call("sin", x), zero } },
}

for _, d in ipairs(directions) do
  local name, k = d[1], d[2]
  local I = axial(alpha, beta, k)
  local s = is(I, "symmetric", "alpha 1 + beta k k^T about " .. name .. ": symmetric")
  tap.ok(s.kind == "symmetric" and equal(rebuilt(s), I) and not s.rod, "about " .. name .. ": k rebuilds the tensor")
  tap.ok(s.kind == "symmetric" and ratio.iszero(s.alpha - alpha), "about " .. name .. ": the double moment is alpha")
  -- a rod: no moment along its line
  local n = k[1] ^ 2 + k[2] ^ 2 + k[3] ^ 2
  I = axial(alpha * n, -alpha, k)
  s = is(I, "symmetric", "alpha (k^2 1 - k k^T) along " .. name .. ": symmetric")
  tap.ok(s.kind == "symmetric" and s.rod and ratio.iszero(s.axial), "and a rod")
end

do -- the lecture's cube about its corner, edge and mass symbolic
  local M, a = expr.sym("M", 1, true), expr.sym("a", 2)
  local d, o = 2 * M * a ^ 2 / 3, -(M * a ^ 2) / 4
  local s = is({ d, d, d, o, o, o }, "symmetric", "cube about its corner: symmetric about the space diagonal")
  tap.ok(s.k[1] == one and s.k[2] == one and s.k[3] == one, "the axis is (1, 1, 1)")
  tap.ok(s.alpha == 11 * M * a ^ 2 / 12 and s.axial == M * a ^ 2 / 6, "the moments are 11/12, 11/12 and 1/6 of M a^2")
end

-- ---- everything else ----

do
  is({ alpha, alpha + x, alpha + 2 * x, 0, 0, 0 }, "diagonal",
    "three different moments on the coordinate axes: diagonal")
  local s = is({ 4, 5, 6, 1, 0, 0 }, "full", "one product of inertia: full")
  tap.ok(s.block and s.block[1] == 1 and s.block[2] == 2 and s.block[3] == 3, "with the block xy")
  s = is({ 4, 5, 6, 0, 1, 0 }, "full", "the product xz: full")
  tap.ok(s.block and s.block[3] == 2, "with the block xz")
  s = is({ 4, 5, 6, 0, 0, 1 }, "full", "the product yz: full")
  tap.ok(s.block and s.block[3] == 1, "with the block yz")
  for _, I in ipairs { { 4, 5, 6, 1, 1, 0 }, { 4, 5, 6, 1, 0, 1 }, { 4, 5, 6, 0, 1, 1 }, { 5, 5, 5, 1, 1, 0 } } do
    s = is(I, "full", string.format("two products (%d %d %d %d %d %d): full, never symmetric", table.unpack(I)))
    tap.ok(not s.block, "and no block")
  end
  is({ 4, 5, 6, 1, 1, 1 }, "full", "three products in general: full")
end

-- ---- near misses ----

local tiny = expr.lift "1e-40"
for _, base in ipairs {
  { "a sphere", lift { 2, 2, 2, 0, 0, 0 } }, { "symmetric about z", lift { 2, 2, 3, 0, 0, 0 } },
  { "symmetric about (1, 2, 0)", axial(expr.lift(5), expr.lift(-1, 2), lift { 1, 2, 0 }) },
  { "symmetric about (1, 2, -3)", axial(expr.lift(29), expr.lift(-1), lift { 1, 2, -3 }) },
  { "a rod along (1, 2, 2)", axial(expr.lift(9), expr.lift(-1), lift { 1, 2, 2 }) },
} do
  local names = { "xx", "yy", "zz", "xy", "xz", "yz" }
  local before = principal.classify(base[2])
  tap.ok(before.kind ~= "full" and before.kind ~= "diagonal", base[1] .. ": is recognised")
  for n = 1, 6 do
    local I = { table.unpack(base[2]) }
    I[n] = I[n] + tiny
    local s = principal.classify(I)
    -- what may be claimed is what rebuilds the very tensor, to the last digit
    local fine = (s.kind == "full" or s.kind == "diagonal") or s.kind == "symmetric" and equal(rebuilt(s), I)
    tap.ok(fine and s.kind ~= "sphere" and not (s.rod and n <= 3), base[1] .. ", I" .. names[n] ..
      " larger by 1e-40: not taken for what it was", s.kind)
  end
end

-- ---- closed moments and axes ----

local function eigen(I, name)
  local s = principal.classify(I)
  local list = principal.closed(I, s)
  if not list then return tap.ok(false, name .. ": has a closed form") end
  local trace, count = zero, 0
  for _, p in ipairs(list) do
    trace, count = trace + p.multiplicity * p.moment, count + p.multiplicity
    if p.axis then
      local a = p.axis
      local residue = { I[1] * a[1] + I[4] * a[2] + I[5] * a[3] - p.moment * a[1],
        I[4] * a[1] + I[2] * a[2] + I[6] * a[3] - p.moment * a[2],
        I[5] * a[1] + I[6] * a[2] + I[3] * a[3] - p.moment * a[3] }
      tap.ok(ratio.iszero(residue[1]) and ratio.iszero(residue[2]) and ratio.iszero(residue[3])
        and not (ratio.iszero(a[1]) and ratio.iszero(a[2]) and ratio.iszero(a[3])),
        name .. ": I axis = moment axis, identically, and the axis is not zero")
    end
  end
  tap.ok(count == 3 and ratio.iszero(trace - (I[1] + I[2] + I[3])), name .. ": three moments, whose sum is the trace")
end

eigen({ alpha, alpha, alpha, zero, zero, zero }, "sphere")
eigen(axial(alpha, beta, { x, y, z }), "symmetric about any direction")
eigen({ alpha, beta, alpha + beta, zero, zero, zero }, "diagonal")
eigen({ alpha, beta, x, y, zero, zero }, "block xy")
eigen({ alpha, beta, x, zero, y, zero }, "block xz")
eigen({ alpha, beta, x, zero, zero, y }, "block yz")
tap.is(principal.closed(lift { 4, 5, 6, 1, 1, 1 }, principal.classify(lift { 4, 5, 6, 1, 1, 1 })), nil,
  "a full tensor has no closed form worth printing: nil")

-- ---- a scene's structure ----

do
  local kinds = { bodies = { "brick", "full", "brick_centroid", "diagonal", "cube_corner", "symmetric", "dumbbell",
    "symmetric", "coin", "symmetric", "earth", "symmetric", "gyroscope", "symmetric", "tennis_racket", "diagonal",
    "water", "diagonal", "symmetric_top", "symmetric", "book", "diagonal", "nasa_brick", "diagonal" } }
  for i = 1, #kinds.bodies, 2 do
    tap.is(scene.file("bodies/" .. kinds.bodies[i] .. ".lua").model.structure.kind, kinds.bodies[i + 1],
      kinds.bodies[i] .. ": is " .. kinds.bodies[i + 1])
  end
  tap.ok(scene.file("bodies/dumbbell.lua").model.structure.rod, "dumbbell: is a rod")
end

-- ---- numeric axes ----

-- Moments and axes are computed with 128 bits and rounded once: half a unit, in a moment's own last place where the
-- tensor is positive definite (the judge's steps are an eighth; where its condition is below 2^70 or so), and products
-- of the axes off by at most the epsilon.
local HALF, ONCE = 0.5, 1 + 2.0 ^ -20

local worst, bad, count = { norm = 0.0, own = 0.0, skew = 0.0, residue = 0.0 }, nil, 0

local function judged(id, I, graded)
  local moments, a = jacobi.run(I)
  local e = axes.measure(I, moments, { a[1][1], a[1][2], a[1][3], a[2][1], a[2][2], a[2][3], a[3][1], a[3][2],
    a[3][3] },
    axes.double, graded)
  for k, v in pairs(worst) do worst[k] = math.max(v, e[k]) end -- the order does not matter
  count = count + 1
  if not (e.handed and e.ascending and e.signed) then bad = id end
end

for id, category, I in axes.reference(scene.slurp "tests/reference/eigen.h") do
  judged(id, I, category == "graded")
end
tap.is(count, 44, "the reference table was read")
for family, I, condition in axes.families(axes.double, 20) do judged(family, I, condition) end
tap.ok(worst.norm <= HALF and worst.own <= HALF, "reports: moments are rounded once",
  string.format("%.3f units of the largest, %.3f of their own", worst.norm, worst.own))
tap.ok(worst.skew <= ONCE and worst.residue <= ONCE, "reports: axes are orthonormal, and I axis = moment axis",
  string.format("skew %.3f, residue %.3f epsilons", worst.skew, worst.residue))
tap.ok(not bad, "reports: axes are right-handed, their signs by the rule, the moments ascend", bad)

do -- rationals beyond the range of double are as good
  local huge = R.new(10) ^ 400
  local moments, a = jacobi.run { R.one / huge, R.new(2) / huge, R.new(2) / huge, R.one / huge / huge, R.zero, R.zero }
  tap.ok(moments[1] == 0 and a[1][1] == 1 and a[3][3] == 1, "reports: a tensor of 1e-400 has axes")
end

tap.done()
