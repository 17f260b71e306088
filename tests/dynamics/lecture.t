#!/usr/bin/env lua5.4
-- lecture.t - the lecture row by row: frames, kinetic energy, tensors, principal axes, shifts of the origin.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each formula is proved as an identity of rational functions against its definition, written out here from v = w x r
-- or from the attitude quaternion itself; nothing is compared with what it was derived from.  The torque equation and
-- Euler's equations are in euler.t, the symmetric top in closed.t, stability in stability.t.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local calculus = require "generator.algebra.calculus"
local text = require "generator.formula.text"
local frames = require "generator.dynamics.frames"
local quantities = require "generator.dynamics.quantities"

local function symbols(list)
  local v = {}
  for name in list:gmatch "%S+" do v[#v + 1] = expr.sym(name, 8) end
  return v
end

-- cross and dot as the lecture writes them
local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function plus(a, b) return { a[1] + b[1], a[2] + b[2], a[3] + b[3] } end

local function identical(a, b, name)
  local n = 0
  for i = 1, math.max(#a, #b) do
    local d = a[i] - b[i]
    if not ratio.iszero(d) then
      return tap.ok(false, name, "entry " .. i .. " is off by " .. text.of((ratio.tidy(d))))
    end
    n = n + 1
  end
  return tap.ok(n > 0, name)
end

local w, dw = symbols "wx wy wz", symbols "dwx dwy dwz"
local r, v, a = symbols "rx ry rz", symbols "vx vy vz", symbols "ax ay az"

-- ---- rate of change in both frames ----

identical(frames.rate(w, r, v), plus(v, cross(w, r)), "rate of change: inertial = body + w x r")
identical(frames.body_rate(w, r, frames.rate(w, r, v)), v, "rate of change: there and back is the identity")

-- the same from the attitude: x = q r q*, with q' = q (0, w)/2 and r' = v, without |q| = 1
local q = symbols "qw qx qy qz"

local function hamilton(p, s)
  return { p[1] * s[1] - p[2] * s[2] - p[3] * s[3] - p[4] * s[4], p[1] * s[2] + p[2] * s[1] + p[3] * s[4] - p[4] * s[3],
    p[1] * s[3] - p[2] * s[4] + p[3] * s[1] + p[4] * s[2], p[1] * s[4] + p[2] * s[3] - p[3] * s[2] + p[4] * s[1] }
end

-- q (0, b) q*, three components; |q|^2 times the rotated vector
local function turned(b)
  local p = hamilton(hamilton(q, { expr.zero, b[1], b[2], b[3] }), { q[1], -q[2], -q[3], -q[4] })
  return { p[2], p[3], p[4] }
end

local qdot = hamilton(q, { expr.zero, w[1] / 2, w[2] / 2, w[3] / 2 })

-- d/dt of a vector by the chain rule, all of q, w, r, v depending on time
local function derivative(x)
  local rates = { { q, qdot }, { r, v }, { v, a }, { w, dw } }
  local out = {}
  for i, e in ipairs(x) do
    out[i] = expr.zero
    for _, pair in ipairs(rates) do
      for k, s in ipairs(pair[1]) do out[i] = out[i] + calculus.diff(e, s) * pair[2][k] end
    end
  end
  return out
end

local first = derivative(turned(r))
identical(first, turned(frames.rate(w, r, v)),
  "rate of change: the derivative of q r q* is q (v + w x r) q*, for every q")

-- ---- the four terms of the acceleration ----

do
  local f = frames.acceleration(w, dw, r, v, a)
  identical(f.relative, a, "acceleration: the relative term is a")
  identical(f.coriolis, plus(cross(w, v), cross(w, v)), "acceleration: the Coriolis term is 2 w x v")
  identical(f.euler, cross(dw, r), "acceleration: the Euler term is w' x r")
  identical(f.centripetal, cross(w, cross(w, r)), "acceleration: the centripetal term is w x (w x r)")
  local total = plus(plus(f.relative, f.coriolis), plus(f.euler, f.centripetal))
  -- B = r' inertial, in body axes; its body rate is a + w' x r + w x v
  local B = frames.rate(w, r, v)
  local dB = plus(plus(a, cross(dw, r)), cross(w, v))
  identical(frames.rate(w, B, dB), total, "acceleration: the rate of change applied twice is the sum of the four terms")
  identical(derivative(first), turned(total), "acceleration: so is the second derivative of q r q*, for every q")
  local outward = dot(f.centripetal, w)
  tap.ok(ratio.iszero(outward), "acceleration: the centripetal term has no component along w")

  local job = scene.plan(assert(scene.body("solid.sphere { r = 1, mass = 1 }")))
  local emitted = scene.results(job, scene.description(job, "acceleration"))
  identical(emitted.total, total, "emitted acceleration: the total")
  identical(emitted.coriolis, f.coriolis, "emitted acceleration: Coriolis")
  identical(emitted.euler, f.euler, "emitted acceleration: Euler")
  identical(emitted.centripetal, f.centripetal, "emitted acceleration: centripetal")
  local A, dA = symbols "ax ay az", symbols "dax day daz"
  emitted = scene.results(job, scene.description(job, "rate"))
  identical(emitted.out, plus(dA, cross(w, A)), "emitted rate: dA + w x A")
end

-- ---- kinetic energy and tensor of particles ----

local function apply(I, b)
  return { I[1] * b[1] + I[4] * b[2] + I[5] * b[3], I[4] * b[1] + I[2] * b[2] + I[6] * b[3],
    I[5] * b[1] + I[6] * b[2] + I[3] * b[3] }
end

do
  local job = scene.plan(assert(scene.body("points { {M, a, b, 0}, {M1, -b, 2*a, 0}, {3, b, -a, 0}, {2, 0, 0, a} }",
    { "M", "M1", "a", "b" }, "origin = {0, 0, 0}")))
  local M, M1 = expr.sym("M", 1, true), expr.sym("M1", 1, true)
  local x, y = expr.sym("a", 2), expr.sym("b", 2)
  local rows = { { M, { x, y, expr.zero } }, { M1, { -y, 2 * x, expr.zero } }, { expr.lift(3), { y, -x, expr.zero } },
    { expr.lift(2), { expr.zero, expr.zero, x } } }
  local T, L, I = expr.zero, { expr.zero, expr.zero, expr.zero }, {}
  for n = 1, 6 do I[n] = expr.zero end
  for _, p in ipairs(rows) do
    local m, s = p[1], p[2]
    local speed = cross(w, s)
    T = T + m * dot(speed, speed) / 2
    local moment = cross(s, speed)
    local square = dot(s, s)
    for i = 1, 3 do
      L[i] = L[i] + m * moment[i]
      I[i] = I[i] + m * (square - s[i] ^ 2)
    end
    I[4], I[5], I[6] = I[4] - m * s[1] * s[2], I[5] - m * s[1] * s[3], I[6] - m * s[2] * s[3]
  end
  local by_definition = scene.results(job, scene.description(job, "particle_energy")).result
  local by_tensor = scene.results(job, scene.description(job, "energy")).result
  identical(by_definition, { T }, "particles: the emitted sum m v^2/2 is the sum over the particles")
  identical(by_tensor, { T }, "particles: w.I.w/2 is the same, identically in w, masses and places")
  identical(job.model.inertia, I, "particles: the tensor is sum m (r^2 1 - r r^T)")
  identical(scene.results(job, scene.description(job, "momentum_body")).L, L, "particles: L = I w is sum m r x v")
  identical({ dot(w, apply(I, w)) / 2 }, { T }, "particles: half w.I.w with that tensor is T")
  tap.is(scene.description(scene.plan(assert(scene.body("solid.sphere { r = 1, mass = 1 }"))), "particle_energy"), nil,
    "a solid has no sum over particles")
end

-- ---- the brick ----

local function lines(I)
  local out = {}
  for n, e in ipairs(I) do out[n] = text.of(e, "plain") end
  return table.concat(out, ", ")
end

local brick = scene.file "bodies/brick.lua"
local M = expr.sym("M", 1, true)
local ea, eb, ec = expr.sym("a", 2), expr.sym("b", 2), expr.sym("c", 2)

tap.is(lines(brick.model.inertia),
  "M*(b^2 + c^2)/3, M*(a^2 + c^2)/3, M*(a^2 + b^2)/3, -M*a*b/4, -M*a*c/4, -M*b*c/4",
  "brick about its corner: the M/3 and M/4 terms exactly as in the lecture")
tap.is(lines(brick.model.centroidal),
  "M*(b^2 + c^2)/12, M*(a^2 + c^2)/12, M*(a^2 + b^2)/12, 0, 0, 0",
  "brick about its centroid: the M/12 terms and no product of inertia")
do
  -- the integral over the brick, term by term: int x^i y^j z^k over [0,a]x[0,b]x[0,c] is a product of a^(i+1)/(i+1)
  local function integral(i, j, k)
    return M / (ea * eb * ec) * ea ^ (i + 1) / (i + 1) * eb ^ (j + 1) / (j + 1) * ec ^ (k + 1) / (k + 1)
  end
  local xx, yy, zz = integral(2, 0, 0), integral(0, 2, 0), integral(0, 0, 2)
  identical(brick.model.inertia,
    { yy + zz, xx + zz, xx + yy, -integral(1, 1, 0), -integral(1, 0, 1), -integral(0, 1, 1) },
    "brick about its corner: the integrals of rho (r^2 d_ij - x_i x_j)")
  identical(brick.model.com, { ea / 2, eb / 2, ec / 2 }, "brick: the centre of mass from the corner is (a, b, c)/2")
end

do
  local cube = scene.file "bodies/cube_corner.lua"
  local s = cube.model.structure
  tap.is(lines { s.alpha, s.axial }, "11*M*a^2/12, M*a^2/6",
    "cube about its corner: moments 11/12 (twice) and 1/6 of M a^2")
  tap.is(lines(s.k), "1, 1, 1", "cube about its corner: the single axis is the space diagonal")
  -- characteristic polynomial of the tensor by hand: (2/3 - x)^3 - 3/16 (2/3 - x) - 1/32 in units of M a^2
  local function characteristic(x)
    local d = expr.lift "2/3" - x
    return d ^ 3 - 3 * d / 16 - expr.lift "1/32"
  end
  tap.ok(ratio.iszero(characteristic(expr.lift "1/6")) and ratio.iszero(characteristic(expr.lift "11/12")),
    "cube about its corner: 1/6 and 11/12 are roots of the characteristic equation")
end

-- ---- moving the origin ----

do
  local job = scene.plan(scene.file "bodies/brick.lua")
  local at = scene.results(job, scene.description(job, "inertia_at")).I
  local s = symbols "ax ay az"
  local R = { ea / 2, eb / 2, ec / 2 }
  local I = brick.model.inertia
  local general, pairs_ = {}, { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }
  for n, p in ipairs(pairs_) do
    local i, j = p[1], p[2]
    general[n] = I[n] - M * s[i] * s[j] + M * (s[i] * R[j] + s[j] * R[i])
    if i == j then general[n] = general[n] + M * dot(s, s) - 2 * M * dot(s, R) end
  end
  identical(at, general, "a shift by a: I' = I + M (a^2 1 - a a^T) - M (2 a.R 1 - a R^T - R a^T)")
  identical(quantities.shifted(I, M, R, s), general, "the general formula with the centre-of-mass terms")

  local function to(place)
    local map, out = {}, {}
    for i = 1, 3 do map[s[i]] = place[i] end
    for n = 1, 6 do out[n] = calculus.substitute(at[n], map) end
    return out
  end
  identical(to(R), brick.model.centroidal, "a shift from the corner to the centroid: the tensor becomes diagonal, M/12")
  local edge = to { ea / 2, expr.zero, expr.zero }
  local moved = assert(scene.body("solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b", "c" },
    "origin = {0, -b/2, -c/2}")).model
  identical(edge, moved.inertia, "a shift to the middle of an edge: as the scene with that origin")
  tap.ok(ratio.iszero(edge[4]) and ratio.iszero(edge[5]) and ratio.iszero(edge[6] + M * eb * ec / 4),
    "and it does not become diagonal: yz stays -M b c/4")
  local zero = { expr.zero, expr.zero, expr.zero }
  local back = quantities.shifted(brick.model.centroidal, M, zero, { -R[1], -R[2], -R[3] })
  identical(back, I, "and back from the centroid, where R = 0: Steiner's theorem")
end

-- ---- kinetic energy and angular momentum ----

do
  local job = scene.plan(scene.file "bodies/brick.lua")
  local I = brick.model.inertia
  local L = scene.results(job, scene.description(job, "momentum_body")).L
  local energy = scene.results(job, scene.description(job, "energy")).result
  identical(L, apply(I, w), "general axes: L = I w")
  identical(energy, { I[1] * w[1] ^ 2 / 2 + I[2] * w[2] ^ 2 / 2 + I[3] * w[3] ^ 2 / 2 + I[4] * w[1] * w[2]
    + I[5] * w[1] * w[3] + I[6] * w[2] * w[3] }, "general axes: T = sum I_ij w_i w_j/2")
  identical({ dot(w, L) / 2 }, energy, "general axes: T = w.L/2")
  for i = 1, 3 do
    identical({ calculus.diff(energy[1], w[i]) }, { L[i] }, "general axes: dT/dw_" .. i .. " = L_" .. i)
  end
  local inertial = scene.results(job, scene.description(job, "momentum")).L
  identical(inertial, turned(L), "L in inertial axes is q L q*")

  local principal = scene.plan(scene.file "bodies/brick_centroid.lua")
  local P = principal.model.inertia
  identical(scene.results(principal, scene.description(principal, "momentum_body")).L,
    { P[1] * w[1], P[2] * w[2], P[3] * w[3] }, "principal axes: L = (I1 w1, I2 w2, I3 w3)")
  identical(scene.results(principal, scene.description(principal, "energy")).result,
    { (P[1] * w[1] ^ 2 + P[2] * w[2] ^ 2 + P[3] * w[3] ^ 2) / 2 },
    "principal axes: T = (I1 w1^2 + I2 w2^2 + I3 w3^2)/2")
end

tap.done()
