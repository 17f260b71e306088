-- moments.lua -- bodies by their definition, in exact rationals: the oracle of the hard cases of mass properties.
--
-- A body is its moments about the origin of coordinates: m = integral of 1, f = of r, s = of r r^T (xx yy zz xy xz yz),
-- times the density.  They add and subtract exactly, so a thin wall or a far origin loses nothing, and no formula
-- of the generator is used: bodies of revolution are integrals of polynomials in z, polyhedra sums of tetrahedra.
-- pi has 600 bits.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local moments = {}

local zero, one = R.new(0), R.new(1)
local place = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }
local function q(x)
  if type(x) == "string" then return R.parse(x) end
  return R.is(x) and x or math.type(x) == "integer" and R.new(x) or R.fromdouble(x)
end
moments.q = q
moments.bits = 600
function moments.pi() return R.apply("pi", moments.bits) end
function moments.sqrt(x) return R.apply("sqrt", moments.bits, x) end

-- ---- the ring of bodies ----

function moments.none() return { m = zero, f = { zero, zero, zero }, s = { zero, zero, zero, zero, zero, zero } } end

-- k a + b
local function with(k, a, b)
  local out = { m = k * a.m + b.m, f = {}, s = {} }
  for i = 1, 3 do out.f[i] = k * a.f[i] + b.f[i] end
  for i = 1, 6 do out.s[i] = k * a.s[i] + b.s[i] end
  return out
end
function moments.times(k, a) return with(q(k), a, moments.none()) end
function moments.add(a, b) return with(one, a, b) end
function moments.minus(a, b) return with(-one, b, a) end
function moments.of_mass(a, mass) return moments.times(q(mass) / a.m, a) end

-- r -> A r + d, the mass kept; A: three rows.
function moments.affine(a, A, d)
  local rows, at, full = {}, { q(d[1]), q(d[2]), q(d[3]) }, { { 1, 4, 5 }, { 4, 2, 6 }, { 5, 6, 3 } }
  local out = { m = a.m, f = {}, s = {} }
  for i = 1, 3 do rows[i] = { q(A[i][1]), q(A[i][2]), q(A[i][3]) } end
  local function turned(i) return rows[i][1] * a.f[1] + rows[i][2] * a.f[2] + rows[i][3] * a.f[3] end
  for i = 1, 3 do out.f[i] = turned(i) + a.m * at[i] end
  for n, ij in ipairs(place) do
    local i, j, sum = ij[1], ij[2], zero
    for k = 1, 3 do
      for l = 1, 3 do sum = sum + rows[i][k] * rows[j][l] * a.s[full[k][l]] end
    end
    out.s[n] = sum + at[i] * turned(j) + at[j] * turned(i) + a.m * at[i] * at[j]
  end
  return out
end
function moments.at(a, d) return moments.affine(a, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, d) end
function moments.scaled(a, x, y, z) return moments.affine(a, { { x, 0, 0 }, { 0, y, 0 }, { 0, 0, z } }, { 0, 0, 0 }) end

-- ---- simple bodies, of density 1 ----

-- m at r
function moments.point(m, r)
  local out = moments.none()
  m = q(m)
  out.m = m
  for i = 1, 3 do out.f[i] = m * q(r[i]) end
  for n, ij in ipairs(place) do out.s[n] = m * q(r[ij[1]]) * q(r[ij[2]]) end
  return out
end

-- The simplex of n corners of the measure: mean of r_i r_j = (sum of all products + sum of own ones)/(n (n + 1)).
function moments.simplex(corners, measure)
  local n, out = #corners, moments.none()
  local sum = { zero, zero, zero }
  for _, c in ipairs(corners) do
    for i = 1, 3 do sum[i] = sum[i] + q(c[i]) end
  end
  out.m = q(measure)
  for i = 1, 3 do out.f[i] = out.m * sum[i] / R.new(n) end
  for k, ij in ipairs(place) do
    local i, j, own = ij[1], ij[2], zero
    for _, c in ipairs(corners) do own = own + q(c[i]) * q(c[j]) end
    out.s[k] = out.m * (sum[i] * sum[j] + own) / R.new(n * (n + 1))
  end
  return out
end

-- Signed by the corners' order.
function moments.tetrahedron(a, b, c, d)
  local e = {}
  for k, p in ipairs { b, c, d } do e[k] = { q(p[1]) - q(a[1]), q(p[2]) - q(a[2]), q(p[3]) - q(a[3]) } end
  local x, y, z = e[1], e[2], e[3]
  local det = x[1] * (y[2] * z[3] - y[3] * z[2]) - x[2] * (y[1] * z[3] - y[3] * z[1]) +
    x[3] * (y[1] * z[2] - y[2] * z[1])
  return moments.simplex({ a, b, c, d }, det / R.new(6))
end

-- Triangles of corners, outward: tetrahedra from the origin.
function moments.mesh(triangles)
  local out = moments.none()
  for _, t in ipairs(triangles) do out = moments.add(out, moments.tetrahedron({ 0, 0, 0 }, t[1], t[2], t[3])) end
  return out
end

-- A plane polygon {x, y}, counter-clockwise: triangles from the origin.
function moments.polygon(points)
  local out = moments.none()
  for i, a in ipairs(points) do
    local b = points[i % #points + 1]
    local area = (q(a[1]) * q(b[2]) - q(a[2]) * q(b[1])) / R.new(2)
    out = moments.add(out, moments.simplex({ { 0, 0, 0 }, { a[1], a[2], 0 }, { b[1], b[2], 0 } }, area))
  end
  return out
end

-- x from x1 to x2, and so on
function moments.box(x1, x2, y1, y2, z1, z2)
  local at = { { q(x1), q(x2) }, { q(y1), q(y2) }, { q(z1), q(z2) } }
  local function mean(i, n) -- integral of x^n
    return (at[i][2] ^ (n + 1) - at[i][1] ^ (n + 1)) / R.new(n + 1)
  end
  local out = moments.none()
  out.m = mean(1, 0) * mean(2, 0) * mean(3, 0)
  for i = 1, 3 do out.f[i] = out.m / mean(i, 0) * mean(i, 1) end
  for n, ij in ipairs(place) do
    local i, j = ij[1], ij[2]
    out.s[n] = i == j and out.m / mean(i, 0) * mean(i, 2) or
      out.m / mean(i, 0) / mean(j, 0) * mean(i, 1) * mean(j, 1)
  end
  return out
end

-- Turned about z, z1 <= z <= z2, radius squared = sum of c[k] z^(k - 1): discs pi r^2 with r^4 pi/4 across.
function moments.revolved(c, z1, z2)
  local p, low, high = {}, q(z1), q(z2)
  for k, x in ipairs(c) do p[k] = q(x) end
  local function integral(list, power)
    local sum = zero
    for k, x in ipairs(list) do
      local n = k + power
      sum = sum + x * (high ^ n - low ^ n) / R.new(n)
    end
    return sum
  end
  local square = {}
  for i, a in ipairs(p) do
    for j, b in ipairs(p) do square[i + j - 1] = (square[i + j - 1] or zero) + a * b end
  end
  local pi, out = moments.pi(), moments.none()
  out.m, out.f[3], out.s[3] = pi * integral(p, 0), pi * integral(p, 1), pi * integral(p, 2)
  out.s[1] = pi / R.new(4) * integral(square, 0)
  out.s[2] = out.s[1]
  return out
end
function moments.ball(r) return moments.revolved({ q(r) ^ 2, 0, -1 }, -q(r), q(r)) end

-- ---- what is asked ----

function moments.com(a) return { a.f[1] / a.m, a.f[2] / a.m, a.f[3] / a.m } end

-- The tensor about the point p (nil: the origin of coordinates): tr S 1 - S.
function moments.tensor(a, p)
  if p then a = moments.at(a, { -q(p[1]), -q(p[2]), -q(p[3]) }) end
  local s = a.s
  return { s[2] + s[3], s[1] + s[3], s[1] + s[2], -s[4], -s[5], -s[6] }
end

return moments
