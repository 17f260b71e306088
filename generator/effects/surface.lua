-- surface.lua -- the point of a body's surface that touches a plane, and how it moves over the body.
--
-- In the axes of the surface (to the body's by the matrix A), n the outward normal at the point, -n = A^T g with the
-- plane's normal g in body axes.  The point is -A^T y from the surface's centre:
--     ellipsoid    y = B g/sqrt(g.B g), B = A diag(squared half axes) A^T      y' = (B g' - y (y.g'))/sqrt(g.B g)
--     paraboloid   p = A^T g, s = (p1/p3, p2/p3):  A^T y = (a s1, b s2, -(a s1^2 + b s2^2)/2)
--     support h    -A^T y = G + (h - n.G) n, with G the gradient of h and H its matrix of second derivatives:
--                  (-A^T y)' = K + (h - n.G) n' - (n.K) n,  K = H n'      (any h that is right for n.n = 1)
-- A sphere or an ellipsoid of revolution whose axis is the body's z has, with A = a^2, C = c^2, Q = g3' = g1 w2 - g2 w1
-- and its centre c3 on that axis,
--     far = centre - y = -A/root g + b z,  root^2 = A (g1^2 + g2^2) + C g3^2,  b = c3 - (C - A) g3/root
--     k = e (g3 g - z) + b w x z,  e = A (C - A) Q/root^3,   far x g = b z x g
--     g.(w x k) = k.(g x w) = b (w3 (g1 w1 + g2 w2) - g3 (w1^2 + w2^2)) - e Q
-- in which the terms of y' have cancelled, and nothing is divided by rho.
-- Bonnesen and Fenchel, Theory of Convex Bodies, 15 and 38.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local surface = {}

local one = expr.one

-- y and y' as in the head, with B as six constants.
local function ellipsoid(s, c, up, name)
  local A, B = vec.rotation(s.axes), {}
  local squares = vec.map(s.half, function(x) return x ^ 2 end)
  for i, p in ipairs(vec.pair) do
    local sum = expr.zero
    for j = 1, 3 do sum = sum + A[p[1]][j] * A[p[2]][j] * squares[j] end
    B[i] = c.constant("B" .. vec.entry[i], ratio.tidy(sum), "matrix of the ellipsoid, " .. vec.entry[i] .. ", m^2")
  end
  local b = name("Bup_", vec.apply(B, up))
  local root = name("root", { expr.sqrt(vec.dot(up, b)) })[1]
  local y = name("touch_", vec.scale(one / root, b))
  return y, function(rate)
    local along = name("along", { vec.dot(y, rate) })[1]
    return vec.map(vec.apply(B, rate), function(x, i) return (x - y[i] * along) / root end)
  end
end

-- Turning vectors into the surface's axes and back; nothing where they are the body's.
local function axes(s, c)
  if s.axes[2] == expr.zero and s.axes[3] == expr.zero and s.axes[4] == expr.zero then
    local function same(v) return v end
    return same, same
  end
  local A = vec.rotation(s.axes)
  for i = 1, 3 do
    A[i] = vec.map(A[i], function(x, j)
      return c.constant("A" .. string.sub("xyz", i, i) .. string.sub("xyz", j, j), ratio.tidy(x),
        "matrix from the surface's axes to the body's")
    end)
  end
  local back = vec.transpose(A)
  return function(v) return vec.matvec(back, v) end, function(v) return vec.matvec(A, v) end
end

-- s1, s2 are the slopes of the plane in the surface's axes; s' = (p1' - s1 p3')/p3.
local function paraboloid(s, c, up, name)
  local into, out = axes(s, c)
  local a = c.constant("bend_x", s.half[1], "radius of curvature along x, m")
  local b = c.constant("bend_y", s.half[2], "radius of curvature along y, m")
  local p = name("tilt_", into(up))
  local over = name("over", { one / p[3] })[1]
  local s1, s2 = name("lean_x", { p[1] * over })[1], name("lean_y", { p[2] * over })[1]
  local y = name("touch_", out { a * s1, b * s2, -(a * s1 ^ 2 + b * s2 ^ 2) / 2 })
  return y, function(rate)
    local d = name("tilt_rate_", into(rate))
    local d1, d2 = name("lean_rate_x", { (d[1] - s1 * d[3]) * over })[1],
      name("lean_rate_y", { (d[2] - s2 * d[3]) * over })[1]
    return out { a * d1, b * d2, -(a * s1 * d1 + b * s2 * d2) }
  end
end

-- Of an h that is homogeneous of degree 1, h = n.G, two terms are zero.
local function support(s, c, up, name)
  local into, out = axes(s, c)
  local N = { motion.sym "@nx", motion.sym "@ny", motion.sym "@nz" }
  local n = name("out_", vec.scale(-one, into(up)))
  local map = { [N[1]] = n[1], [N[2]] = n[2], [N[3]] = n[3] }
  local h = c.lift(s.support, "support", "constant of the support function")
  local G = vec.map(N, function(x) return calculus.diff(h, x) end)
  local H = {}
  for i, p in ipairs(vec.pair) do H[i] = calculus.diff(G[p[1]], N[p[2]]) end
  local function at(v) return vec.map(v, function(x) return calculus.substitute(x, map) end) end
  local rest = ratio.tidy(h - vec.dot(N, G)) -- 0 for what Euler's theorem calls homogeneous
  rest = name("rest", at { rest })[1]
  local y = name("touch_", out(vec.map(at(G), function(x, i) return -(x + rest * n[i]) end)))
  H = at(H)
  return y, function(rate)
    local d = name("out_rate_", vec.scale(-one, into(rate)))
    local K = name("bend_", vec.apply(H, d))
    local along = name("along", { rest == expr.zero and expr.zero or vec.dot(n, K) })[1]
    return out(vec.map(K, function(x, i) return -(x + rest * d[i] - along * n[i]) end))
  end
end

-- Is it an ellipsoid of revolution about an axis z through the centre of mass, or a sphere with its centre on z and not
-- there?
local function turned(s, centre)
  if s.paraboloid or s.support or centre[1] ~= expr.zero or centre[2] ~= expr.zero then return false end
  if s.half[1] == expr.zero then return centre[3] ~= expr.zero end
  return s.half[1] == s.half[2] and s.half[3] ~= expr.zero and s.axes[2] == expr.zero and s.axes[3] == expr.zero and
    s.axes[4] == expr.zero
end

-- Of such a surface: far, and a function of w that gives k, far x g and g.(w x k); nil of any other.
function surface.revolved(s, c, centre, up, name)
  if not turned(s, centre) then return nil end
  local A, C = s.half[1] ^ 2, s.half[3] ^ 2
  local round = A == expr.zero
  local far, b, over = centre, centre[3], nil
  if not round then
    local Bxx, Bzz = c.constant("Bxx", ratio.tidy(A), "matrix of the ellipsoid, xx, m^2"),
      c.constant("Bzz", ratio.tidy(C), "matrix of the ellipsoid, zz, m^2")
    over = name("over", { one / expr.sqrt(Bxx * (up[1] ^ 2 + up[2] ^ 2) + Bzz * up[3] ^ 2) })[1]
    local x, z = name("wide", { Bxx * over })[1], name("over_z", { over * up[3] })[1]
    far = name("far_", { -x * up[1], -x * up[2], centre[3] - Bzz * z })
    b = name("offset", { centre[3] - c.constant("Bzz_Bxx", ratio.tidy(C - A), "Bzz - Bxx, m^2") * z })[1]
  end
  return far, function(w)
    local e = expr.zero
    local Q = name("sink", { up[1] * w[2] - up[2] * w[1] })[1]
    if not round then
      e = name("swing", { c.constant("Bturn", ratio.tidy(A * (C - A)), "Bxx (Bzz - Bxx), m^4") * Q * over ^ 3 })[1]
    end
    local lean = name("swing_z", { e * up[3] })[1]
    local k = { lean * up[1] + b * w[2], lean * up[2] - b * w[1], -e * (up[1] ^ 2 + up[2] ^ 2) }
    local along = w[3] * (up[1] * w[1] + up[2] * w[2]) - up[3] * (w[1] ^ 2 + w[2] ^ 2)
    return k, { -b * up[2], b * up[1], expr.zero }, b * along - e * Q
  end
end

-- s: of dsl/contact.lua; c: the effect's context; up: g; name(prefix, vector): gives names to components.  Returns y in
-- body axes and a function of g' that gives y'; nil for a sphere.
function surface.point(s, c, up, name)
  if s.support then return support(s, c, up, name) end
  if s.paraboloid then return paraboloid(s, c, up, name) end
  if s.half[1] ~= expr.zero then return ellipsoid(s, c, up, name) end
  return nil
end

return surface
