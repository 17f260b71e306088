-- thin.lua - shells, plates, rods and wires, as handbooks print them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The form of a row: tests/handbook.lua.  Sources: Beer and Johnston, Vector Mechanics; Meriam and Kraige, Dynamics,
-- table D/4; Wikipedia, "List of moments of inertia"; Gradshteyn and Ryzhik 2.32, 2.63 for t cos t, t sin t, x cosh x.

local rows = {}
local function row(shape, args, params, at, of)
  rows[#rows + 1] = { shape = shape, args = args, params = params, at = at, of = of }
end

local function axial(x, z) return { x, x, z, 0, 0, 0 } end
local function height(z) return { 0, 0, z } end
local PAIRS = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }

-- ---- shells ----

row("shell.sphere", "r = r", { "r" }, { r = 1.2 }, function(e, f)
  return { measure = 4 * f.pi * e.r ^ 2, I = axial(2 * e.r ^ 2 / 3, 2 * e.r ^ 2 / 3),
    points = { pole = height(e.r), bottom = height(-e.r) } }
end)
row("shell.hemisphere", "r = r", { "r" }, { r = 1.2 }, function(e, f)
  return { measure = 2 * f.pi * e.r ^ 2, com = height(e.r / 2), I = axial(5 * e.r ^ 2 / 12, 2 * e.r ^ 2 / 3),
    points = { base = height(0), pole = height(e.r) } }
end)
-- Archimedes: equal heights, equal areas
row("shell.zone", "r = r, z1 = -p, z2 = q", { "p", "q", "r" }, { p = 0.4, q = 1, r = 1.2 }, function(e, f)
  local zz = (e.q ^ 3 + e.p ^ 3) / (3 * (e.p + e.q))
  return { measure = 2 * f.pi * e.r * (e.p + e.q), com = height((e.q - e.p) / 2),
    S = { (e.r ^ 2 - zz) / 2, (e.r ^ 2 - zz) / 2, zz, 0, 0, 0 }, points = { centre = height(0) } }
end)
-- the sphere; others are in algebra/special.t and, spheroids, in geometry/handbook.lua
row("shell.ellipsoid", "a = r, b = r, c = r", { "r" }, { r = 1.2 }, function(e, f)
  return { measure = 4 * f.pi * e.r ^ 2, I = axial(2 * e.r ^ 2 / 3, 2 * e.r ^ 2 / 3),
    points = { pole = height(e.r), bottom = height(-e.r) } }
end)
row("shell.cylinder", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  return { measure = 2 * f.pi * e.r * e.h, I = axial((6 * e.r ^ 2 + e.h ^ 2) / 12, e.r ^ 2),
    points = { base = height(-e.h / 2), top = height(e.h / 2) } }
end)
row("shell.cylinder", "r = r, h = h, ends = true", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  local side, ends = 2 * f.pi * e.r * e.h, 2 * f.pi * e.r ^ 2 -- the side, and two discs at h/2
  local x = side * (6 * e.r ^ 2 + e.h ^ 2) / 12 + ends * (e.r ^ 2 / 4 + e.h ^ 2 / 4)
  local z = side * e.r ^ 2 + ends * e.r ^ 2 / 2
  return { measure = side + ends, I = axial(x / (side + ends), z / (side + ends)),
    points = { base = height(-e.h / 2), top = height(e.h / 2) } }
end)
row("shell.cone", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  return { measure = f.pi * e.r * f.sqrt(e.r ^ 2 + e.h ^ 2), com = height(e.h / 3),
    I = axial(e.r ^ 2 / 4 + e.h ^ 2 / 18, e.r ^ 2 / 2), points = { apex = height(e.h), base = height(0) } }
end)
row("shell.torus", "R = r + d, r = r", { "r", "d" }, { r = 0.5, d = 1.2 }, function(e, f)
  local R = e.r + e.d
  return { measure = 4 * f.pi ^ 2 * R * e.r, I = axial((2 * R ^ 2 + 5 * e.r ^ 2) / 4, (2 * R ^ 2 + 3 * e.r ^ 2) / 2),
    points = { tube = { R, 0, 0 } } }
end)
row("shell.box", "x = a, y = b, z = c", { "a", "b", "c" }, { a = 3, b = 2, c = 1.5 }, function(e)
  local a, b, c = e.a, e.b, e.c
  local A = 2 * (a * b + b * c + c * a)
  -- moment about the axis of edge p: faces q x s across it, p x q and p x s at s/2 and q/2
  local function about(p, q, s)
    return (2 * q * s * (q ^ 2 + s ^ 2) / 12 + 2 * p * q * (q ^ 2 / 12 + s ^ 2 / 4) +
      2 * p * s * (s ^ 2 / 12 + q ^ 2 / 4)) / A
  end
  return { measure = A, I = { about(a, b, c), about(b, c, a), about(c, a, b), 0, 0, 0 },
    points = { corner = { -a / 2, -b / 2, -c / 2 } } }
end)

-- ---- plates ----

row("plate.disc", "r = r", { "r" }, { r = 1.2 }, function(e, f)
  return { measure = f.pi * e.r ^ 2, I = axial(e.r ^ 2 / 4, e.r ^ 2 / 2), points = { rim = { e.r, 0, 0 } } }
end)
row("plate.annulus", "r_in = s, r_out = s + d", { "s", "d" }, { s = 0.5, d = 0.7 }, function(e, f)
  local p, q = e.s, e.s + e.d
  return { measure = f.pi * (q ^ 2 - p ^ 2), I = axial((p ^ 2 + q ^ 2) / 4, (p ^ 2 + q ^ 2) / 2),
    points = { rim = { q, 0, 0 } } }
end)
row("plate.ellipse", "a = a, b = b", { "a", "b" }, { a = 1.4, b = 0.9 }, function(e, f)
  return { measure = f.pi * e.a * e.b, I = { e.b ^ 2 / 4, e.a ^ 2 / 4, (e.a ^ 2 + e.b ^ 2) / 4, 0, 0, 0 },
    points = { rim = { e.a, 0, 0 } } }
end)
row("plate.rectangle", "x = a, y = b", { "a", "b" }, { a = 3, b = 2 }, function(e)
  return { measure = e.a * e.b, I = { e.b ^ 2 / 12, e.a ^ 2 / 12, (e.a ^ 2 + e.b ^ 2) / 12, 0, 0, 0 },
    points = { corner = { -e.a / 2, -e.b / 2, 0 } } }
end)
-- corners in space, twice the area by Lagrange's identity
row("plate.triangle", "vertices = {{p, q, p}, {p + a, q, p}, {p, q + b, p + c}}", { "a", "b", "c", "p", "q" },
  { a = 2, b = 1, c = 1, p = 0.3, q = 0.1 }, function(e, f)
    local p, q = e.p, e.q
    local v = { { p, q, p }, { p + e.a, q, p }, { p, q + e.b, p + e.c } }
    local com, S = {}, {}
    for i = 1, 3 do com[i] = (v[1][i] + v[2][i] + v[3][i]) / 3 end
    for n, ij in ipairs(PAIRS) do -- mean of x_i x_j: the sum over pairs of corners k <= l, symmetric, /6
      local sum = 0
      for k = 1, 3 do
        for l = k, 3 do sum = sum + v[k][ij[1]] * v[l][ij[2]] + v[l][ij[1]] * v[k][ij[2]] end
      end
      S[n] = sum / 12
    end
    return { measure = e.a * f.sqrt(e.b ^ 2 + e.c ^ 2) / 2, com = com, S = S,
      points = { v1 = v[1], v2 = v[2], v3 = v[3] } }
  end)

for _, phi in ipairs { 3 * math.pi / 4, math.pi, 2 * math.pi } do
  row("plate.sector", "r = r, angle = phi", { "r", "phi" }, { r = 1.2, phi = phi }, function(e, f)
    local r, w = e.r, e.phi
    local s = f.sin(2 * w) / (2 * w)
    return { measure = w * r ^ 2 / 2, com = { 2 * r * f.sin(w) / (3 * w), 2 * r * (1 - f.cos(w)) / (3 * w), 0 },
      S = { r ^ 2 * (1 + s) / 4, r ^ 2 * (1 - s) / 4, 0, r ^ 2 * f.sin(w) ^ 2 / (4 * w), 0, 0 },
      points = { apex = height(0) } }
  end)
  row("wire.arc", "r = r, angle = phi", { "r", "phi" }, { r = 1.2, phi = phi }, function(e, f)
    local r, w = e.r, e.phi
    local s = f.sin(2 * w) / (2 * w)
    return { measure = r * w, com = { r * f.sin(w) / w, r * (1 - f.cos(w)) / w, 0 },
      S = { r ^ 2 * (1 + s) / 2, r ^ 2 * (1 - s) / 2, 0, r ^ 2 * f.sin(w) ^ 2 / (2 * w), 0, 0 },
      points = { centre = height(0), first = { r, 0, 0 } } }
  end)
end

-- ---- rods and wires ----

row("rod.straight", "length = l", { "l" }, { l = 2.5 }, function(e)
  return { measure = e.l, I = axial(e.l ^ 2 / 12, 0), points = { ["end"] = height(-e.l / 2) } }
end)
-- from p to p + l (2, 3, 6)/7: the length is l; I = l^2/12 (1 - u u^T) with the unit vector u
row("rod.between", "from = {p, -p, 2*p}, to = {p + 2*l/7, -p + 3*l/7, 2*p + 6*l/7}", { "p", "l" },
  { p = 0.3, l = 2.1 }, function(e)
    local s = e.l ^ 2 / 588
    return { measure = e.l, com = { e.p + e.l / 7, -e.p + 3 * e.l / 14, 2 * e.p + 3 * e.l / 7 },
      I = { 45 * s, 40 * s, 13 * s, -6 * s, -12 * s, -18 * s },
      points = { from = { e.p, -e.p, 2 * e.p },
        to = { e.p + 2 * e.l / 7, -e.p + 3 * e.l / 7, 2 * e.p + 6 * e.l / 7 } } }
  end)
row("wire.hoop", "r = r", { "r" }, { r = 1.2 }, function(e, f)
  return { measure = 2 * f.pi * e.r, I = axial(e.r ^ 2 / 2, e.r ^ 2), points = { rim = { e.r, 0, 0 } } }
end)
-- legs along x, y and z, one after the other; then back to the start
local function legs(e, f, closed)
  local list = { { 0, 0, 0, e.a, 0, 0, e.a }, { e.a, 0, 0, e.a, e.b, 0, e.b }, { e.a, e.b, 0, e.a, e.b, e.c, e.c } }
  if closed then list[4] = { e.a, e.b, e.c, 0, 0, 0, f.sqrt(e.a ^ 2 + e.b ^ 2 + e.c ^ 2) } end
  local L, first, second = 0, { 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }
  local o = { e.p, e.q, e.p }
  for _, s in ipairs(list) do
    L = L + s[7]
    local u, v = {}, {}
    for i = 1, 3 do
      u[i], v[i] = o[i] + s[i], o[i] + s[3 + i]
      first[i] = first[i] + s[7] * (u[i] + v[i]) / 2
    end
    for n, ij in ipairs(PAIRS) do
      local i, j = ij[1], ij[2]
      second[n] = second[n] + s[7] * (2 * u[i] * u[j] + 2 * v[i] * v[j] + u[i] * v[j] + v[i] * u[j]) / 6
    end
  end
  for i = 1, 3 do first[i] = first[i] / L end
  for n = 1, 6 do second[n] = second[n] / L end
  local start, last = { o[1], o[2], o[3] }, { o[1] + e.a, o[2] + e.b, o[3] + e.c }
  return { measure = L, com = first, S = second, points = { first = start, last = last } }
end
local POINTS = "points = {{p, q, p}, {p + a, q, p}, {p + a, q + b, p}, {p + a, q + b, p + c}}"
for _, closed in ipairs { false, true } do
  row("wire.polyline", POINTS .. (closed and ", closed = true" or ""), { "a", "b", "c", "p", "q" },
    { a = 3, b = 4, c = 1.5, p = 0.3, q = -0.2 }, function(e, f) return legs(e, f, closed) end)
end
for _, turns in ipairs { 2.25, 1 } do
  row("wire.helix", turns == 1 and "r = r, pitch = -p, turns = k1" or "r = r, pitch = p, turns = k1",
    { "r", "p", "k1" }, { r = 1.2, p = 0.8, k1 = turns }, function(e, f)
      local r, T = e.r, 2 * f.pi * e.k1
      local k = (turns == 1 and -1 or 1) * e.p / (2 * f.pi) -- z = k t
      local s = f.sin(2 * T) / (2 * T)
      return { measure = T * f.sqrt(r ^ 2 + k ^ 2),
        com = { r * f.sin(T) / T, r * (1 - f.cos(T)) / T, k * T / 2 },
        S = { r ^ 2 * (1 + s) / 2, r ^ 2 * (1 - s) / 2, k ^ 2 * T ^ 2 / 3, r ^ 2 * f.sin(T) ^ 2 / (2 * T),
          r * k * (f.cos(T) + T * f.sin(T) - 1) / T, r * k * (f.sin(T) - T * f.cos(T)) / T },
        points = { axis = height(0), first = { r, 0, 0 } } }
    end)
end
row("wire.catenary", "a = a, span = l", { "a", "l" }, { a = 1.4, l = 3 }, function(e, f)
  local a, u = e.a, e.l / (2 * e.a)
  local s, c = f.sinh(u), f.cosh(u)
  return { measure = 2 * a * s, com = { 0, a * (u / s + c) / 2, 0 },
    S = { a ^ 2 * ((u ^ 2 + 2) * s - 2 * u * c) / s, a ^ 2 * (1 + s ^ 2 / 3), 0, 0, 0, 0 },
    points = { vertex = { 0, a, 0 } } }
end)

return rows
