-- handbook.lua - measure, centroid and second moments of every shape, as handbooks print them, for surface.t.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A row: {node, measure =, com = {x, y, z} (default the origin), and one of
--   I = {xx, yy, zz, xy, xz, yz}  tensor about the centroid per unit mass (off-diagonals: tensor entries, default 0)
--   S = {xx, yy, zz, xy, xz, yz}  mean of x_i x_j about the frame's origin}
-- Sources: Goldstein, Classical Mechanics, ch. 5; Gradshteyn, Ryzhik for the integrals; Weisstein, MathWorld, for the
-- sector ("Spherical Sector"), capsule, bicylinder ("Steinmetz Solid"), hoof ("Cylindrical Wedge") and the regular
-- polyhedra; Tonon, J. Math. Stat. 1 (2004) 8 for the tetrahedron.  The others are one elementary integral each.

local pi, sqrt, sin, cos = math.pi, math.sqrt, math.sin, math.cos
local phi = (1 + sqrt(5)) / 2
local rows = {}
local function row(node, fields)
  fields.node = node
  rows[#rows + 1] = fields
end

-- [F(z)] from z1 to z2
local function between(F, z1, z2) return F(z2) - F(z1) end
-- mean of (v - c)(v - c)^T times k
local function spread(k, list)
  local c, S = { 0, 0, 0 }, {}
  for _, v in ipairs(list) do for i = 1, 3 do c[i] = c[i] + v[i] / #list end end
  for n, ij in ipairs { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } do
    S[n] = c[ij[1]] * c[ij[2]]
    for _, v in ipairs(list) do S[n] = S[n] + k * (v[ij[1]] - c[ij[1]]) * (v[ij[2]] - c[ij[2]]) end
  end
  return c, S
end

-- ---- solids ----

local x, y, z, r, h, a, b, c = 3, 2, 1.5, 1.2, 2.5, 1.4, 0.9, 0.6

row({ shape = "solid.box", x = x, y = y, z = z },
  { measure = x * y * z, I = { (y ^ 2 + z ^ 2) / 12, (x ^ 2 + z ^ 2) / 12, (x ^ 2 + y ^ 2) / 12 } })
row({ shape = "solid.sphere", r = r }, { measure = 4 / 3 * pi * r ^ 3, I = { 0.4 * r ^ 2, 0.4 * r ^ 2, 0.4 * r ^ 2 } })
row({ shape = "solid.ellipsoid", a = a, b = b, c = c }, { measure = 4 / 3 * pi * a * b * c,
  I = { (b ^ 2 + c ^ 2) / 5, (a ^ 2 + c ^ 2) / 5, (a ^ 2 + b ^ 2) / 5 } })
do
  local I = (3 * r ^ 2 + h ^ 2) / 12
  row({ shape = "solid.cylinder", r = r, h = h }, { measure = pi * r ^ 2 * h, I = { I, I, r ^ 2 / 2 } })
end
row({ shape = "solid.elliptic_cylinder", a = a, b = b, h = h }, { measure = pi * a * b * h,
  I = { b ^ 2 / 4 + h ^ 2 / 12, a ^ 2 / 4 + h ^ 2 / 12, (a ^ 2 + b ^ 2) / 4 } })
do
  local p, q = 0.7, 1.1
  local I = (3 * (p ^ 2 + q ^ 2) + h ^ 2) / 12
  row({ shape = "solid.tube", r_in = p, r_out = q, h = h }, { measure = pi * (q ^ 2 - p ^ 2) * h,
    I = { I, I, (p ^ 2 + q ^ 2) / 2 } })
  local f = 0.4 * (q ^ 5 - p ^ 5) / (q ^ 3 - p ^ 3)
  row({ shape = "solid.hollow_sphere", r_in = p, r_out = q },
    { measure = 4 / 3 * pi * (q ^ 3 - p ^ 3), I = { f, f, f } })
end
do
  local I = 3 / 20 * r ^ 2 + 3 / 80 * h ^ 2
  row({ shape = "solid.cone", r = r, h = h }, { measure = pi * r ^ 2 * h / 3, com = { 0, 0, h / 4 },
    I = { I, I, 0.3 * r ^ 2 } })
end
row({ shape = "solid.elliptic_cone", a = a, b = b, h = h }, { measure = pi * a * b * h / 3, com = { 0, 0, h / 4 },
  I = { 3 / 20 * b ^ 2 + 3 / 80 * h ^ 2, 3 / 20 * a ^ 2 + 3 / 80 * h ^ 2, 3 / 20 * (a ^ 2 + b ^ 2) } })
do
  local R, q = 1.3, 0.5
  local s, xx = R ^ 2 + R * q + q ^ 2, 3 / 20 * (R ^ 5 - q ^ 5) / (R ^ 3 - q ^ 3)
  row({ shape = "solid.frustum", r_base = R, r_top = q, h = h }, { measure = pi * h * s / 3,
    com = { 0, 0, h * (R ^ 2 + 2 * R * q + 3 * q ^ 2) / (4 * s) },
    S = { xx, xx, h ^ 2 / 10 * (R ^ 2 + 3 * R * q + 6 * q ^ 2) / s } })
end
do
  local mc, ms = pi * r ^ 2 * h, 4 / 3 * pi * r ^ 3
  local I = (mc * (h ^ 2 / 12 + r ^ 2 / 4) + ms * (0.4 * r ^ 2 + h ^ 2 / 4 + 3 * h * r / 8)) / (mc + ms)
  row({ shape = "solid.capsule", r = r, h = h }, { measure = mc + ms,
    I = { I, I, (mc * r ^ 2 / 2 + 0.4 * ms * r ^ 2) / (mc + ms) } })
end
row({ shape = "solid.hemisphere", r = r }, { measure = 2 / 3 * pi * r ^ 3, com = { 0, 0, 3 / 8 * r },
  S = { r ^ 2 / 5, r ^ 2 / 5, r ^ 2 / 5 } })

-- a ball between two planes, about its centre: pi int (r^2 - z^2) f dz
local function ball_zone(z1, z2)
  local V = between(function(t) return pi * (r ^ 2 * t - t ^ 3 / 3) end, z1, z2)
  local first = between(function(t) return pi * (r ^ 2 * t ^ 2 / 2 - t ^ 4 / 4) end, z1, z2)
  local zz = between(function(t) return pi * (r ^ 2 * t ^ 3 / 3 - t ^ 5 / 5) end, z1, z2)
  local xx = between(function(t) return pi / 4 * (r ^ 4 * t - 2 / 3 * r ^ 2 * t ^ 3 + t ^ 5 / 5) end, z1, z2)
  return V, first / V, xx / V, zz / V
end
row({ shape = "solid.zone", r = r, z1 = -0.3, z2 = 0.9 }, (function()
  local V, zm, xx, zz = ball_zone(-0.3, 0.9)
  return { measure = V, com = { 0, 0, zm }, S = { xx, xx, zz } }
end)())
for _, t in ipairs { 0.7, 1.9 } do -- less and more than half a ball
  local _, zm, xx, zz = ball_zone(r - t, r)
  local d = t - r
  row({ shape = "solid.cap", r = r, h = t }, { measure = pi * t ^ 2 * (3 * r - t) / 3,
    com = { 0, 0, d + 3 * (2 * r - t) ^ 2 / (4 * (3 * r - t)) }, S = { xx, xx, zz + 2 * d * zm + d ^ 2 } })
  local Izz = t * (3 * r - t) / 5
  row({ shape = "solid.sector", r = r, h = t },
    { measure = 2 / 3 * pi * r ^ 2 * t, com = { 0, 0, 3 / 8 * (2 * r - t) },
    S = { Izz / 2, Izz / 2, 3 / 5 * r ^ 2 - Izz } })
end
row({ shape = "solid.half_cylinder", r = r, h = h }, { measure = pi * r ^ 2 * h / 2, com = { 4 * r / (3 * pi), 0, 0 },
  S = { r ^ 2 / 4, r ^ 2 / 4, h ^ 2 / 12 } })
row({ shape = "solid.quarter_cylinder", r = r, h = h }, { measure = pi * r ^ 2 * h / 4,
  com = { 4 * r / (3 * pi), 4 * r / (3 * pi), 0 }, S = { r ^ 2 / 4, r ^ 2 / 4, h ^ 2 / 12, r ^ 2 / (2 * pi) } })
row({ shape = "solid.hoof", r = r, h = h }, { measure = 2 / 3 * r ^ 2 * h,
  com = { 3 * pi * r / 16, 0, 3 * pi * h / 32 },
  S = { 2 / 5 * r ^ 2, r ^ 2 / 5, 2 / 15 * h ^ 2, 0, r * h / 5 } })
do
  local R, q = 1.7, 0.5
  local I = R ^ 2 / 2 + 5 / 8 * q ^ 2
  row({ shape = "solid.torus", R = R, r = q },
    { measure = 2 * pi ^ 2 * R * q ^ 2, I = { I, I, R ^ 2 + 3 / 4 * q ^ 2 } })
  I = R ^ 2 / 2 + 5 / 4 * q ^ 2
  row({ shape = "shell.torus", R = R, r = q }, { measure = 4 * pi ^ 2 * R * q, I = { I, I, R ^ 2 + 3 / 2 * q ^ 2 } })
end
row({ shape = "solid.paraboloid", r = r, h = h }, { measure = pi * r ^ 2 * h / 2, com = { 0, 0, 2 / 3 * h },
  I = { (3 * r ^ 2 + h ^ 2) / 18, (3 * r ^ 2 + h ^ 2) / 18, r ^ 2 / 3 } })
row({ shape = "solid.pyramid", x = x, y = y, h = h }, { measure = x * y * h / 3, com = { 0, 0, h / 4 },
  I = { y ^ 2 / 20 + 3 / 80 * h ^ 2, x ^ 2 / 20 + 3 / 80 * h ^ 2, (x ^ 2 + y ^ 2) / 20 } })
row({ shape = "solid.wedge", x = x, y = y, z = z }, { measure = x * y * z / 2, com = { x / 3, y / 3, z / 2 },
  I = { y ^ 2 / 18 + z ^ 2 / 12, x ^ 2 / 18 + z ^ 2 / 12, (x ^ 2 + y ^ 2) / 18, x * y / 36 } })
row({ shape = "solid.prism", profile = { { 0, 0 }, { 0, y }, { x, 0 } }, h = z }, { measure = x * y * z / 2,
  com = { x / 3, y / 3, z / 2 }, S = { x ^ 2 / 6, y ^ 2 / 6, z ^ 2 / 3, x * y / 12, x * z / 6, y * z / 6 } })
for turn = 1, 2 do -- both orders of the vertices
  local v = { { 0.2, -0.1, 0.3 }, { 1.5, 0.2, 0 }, { 0.1, 1.1, -0.2 }, { 0.4, 0.3, 1.6 } }
  if turn == 2 then v[1], v[2] = v[2], v[1] end
  local com, S = spread(1 / 20, v)
  local e = {}
  for i = 2, 4 do e[i - 1] = { v[i][1] - v[1][1], v[i][2] - v[1][2], v[i][3] - v[1][3] } end
  local det = e[1][1] * (e[2][2] * e[3][3] - e[2][3] * e[3][2]) - e[1][2] * (e[2][1] * e[3][3] - e[2][3] * e[3][1])
    + e[1][3] * (e[2][1] * e[3][2] - e[2][2] * e[3][1])
  row({ shape = "solid.tetrahedron", vertices = v }, { measure = math.abs(det) / 6, com = com, S = S })
  local middle, T = { 0, 0, 0 }, {}
  for _, f in ipairs(e) do for i = 1, 3 do middle[i] = middle[i] + f[i] / 2 end end
  for n, ij in ipairs { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } do
    T[n] = middle[ij[1]] * middle[ij[2]]
    for _, f in ipairs(e) do T[n] = T[n] + f[ij[1]] * f[ij[2]] / 12 end
  end
  row({ shape = "solid.parallelepiped", edges = e }, { measure = math.abs(det), com = middle, S = T })
end
for faces, q in pairs { [4] = { 1 / (6 * sqrt(2)), 1 / 20 }, [6] = { 1, 1 / 6 }, [8] = { sqrt(2) / 3, 1 / 10 },
  [12] = { (15 + 7 * sqrt(5)) / 4, (95 + 39 * sqrt(5)) / 300 }, [20] = { 5 * (3 + sqrt(5)) / 12, phi ^ 2 / 10 } } do
  local I = q[2] * a ^ 2
  row({ shape = "solid.regular", faces = faces, edge = a }, { measure = q[1] * a ^ 3, I = { I, I, I } })
end
row({ shape = "solid.bicylinder", r = r }, { measure = 16 / 3 * r ^ 3,
  I = { 7 / 15 * r ^ 2, 7 / 15 * r ^ 2, 8 / 15 * r ^ 2 } })

-- ---- shells ----

row({ shape = "shell.sphere", r = r },
  { measure = 4 * pi * r ^ 2, I = { 2 / 3 * r ^ 2, 2 / 3 * r ^ 2, 2 / 3 * r ^ 2 } })
row({ shape = "shell.hemisphere", r = r }, { measure = 2 * pi * r ^ 2, com = { 0, 0, r / 2 },
  S = { r ^ 2 / 3, r ^ 2 / 3, r ^ 2 / 3 } })
do -- Archimedes: equal heights, equal areas
  local z1, z2 = -0.4, 1
  local zz = (z1 ^ 2 + z1 * z2 + z2 ^ 2) / 3
  row({ shape = "shell.zone", r = r, z1 = z1, z2 = z2 },
    { measure = 2 * pi * r * (z2 - z1), com = { 0, 0, (z1 + z2) / 2 },
    S = { (r ^ 2 - zz) / 2, (r ^ 2 - zz) / 2, zz } })
end
do -- prolate spheroid, s = sin(latitude): dA = 2 pi a sqrt(p - q s^2) ds, p = l^2, q = l^2 - a^2, sin u = e
  local l = 2
  local p, q = l ^ 2, l ^ 2 - a ^ 2
  local u = math.asin(sqrt(q / p))
  local I0 = p / (2 * sqrt(q)) * (u + sin(2 * u) / 2) -- int_0^1 sqrt(p - q s^2)
  local I2 = p ^ 2 / (8 * q ^ 1.5) * (u - sin(4 * u) / 4) -- int_0^1 s^2 sqrt(p - q s^2)
  local xx = a ^ 2 / 2 * (1 - I2 / I0)
  row({ shape = "shell.ellipsoid", a = a, b = a, c = l }, { measure = 4 * pi * a * I0, S = { xx, xx, p * I2 / I0 } })
  row({ shape = "shell.ellipsoid", a = l, b = a, c = a }, { measure = 4 * pi * a * I0, S = { p * I2 / I0, xx, xx } })
end
row({ shape = "shell.cylinder", r = r, h = h, ends = false }, { measure = 2 * pi * r * h,
  I = { r ^ 2 / 2 + h ^ 2 / 12, r ^ 2 / 2 + h ^ 2 / 12, r ^ 2 } })
do
  local L, D = 2 * pi * r * h, 2 * pi * r ^ 2
  local I = (L * (r ^ 2 / 2 + h ^ 2 / 12) + D * (r ^ 2 / 4 + h ^ 2 / 4)) / (L + D)
  row({ shape = "shell.cylinder", r = r, h = h, ends = true }, { measure = L + D,
    I = { I, I, (L + D / 2) * r ^ 2 / (L + D) } })
end
row({ shape = "shell.cone", r = r, h = h }, { measure = pi * r * sqrt(r ^ 2 + h ^ 2), com = { 0, 0, h / 3 },
  I = { r ^ 2 / 4 + h ^ 2 / 18, r ^ 2 / 4 + h ^ 2 / 18, r ^ 2 / 2 } })
do
  local A = 2 * (x * y + y * z + z * x)
  row({ shape = "shell.box", x = x, y = y, z = z }, { measure = A, S = {
    (y * z / 2 + (x * y + x * z) / 6) * x ^ 2 / A, (x * z / 2 + (x * y + y * z) / 6) * y ^ 2 / A,
    (x * y / 2 + (x * z + y * z) / 6) * z ^ 2 / A } })
end

-- ---- plates ----

row({ shape = "plate.disc", r = r }, { measure = pi * r ^ 2, I = { r ^ 2 / 4, r ^ 2 / 4, r ^ 2 / 2 } })
do
  local s = (0.5 ^ 2 + r ^ 2) / 4
  row({ shape = "plate.annulus", r_in = 0.5, r_out = r }, { measure = pi * (r ^ 2 - 0.5 ^ 2), I = { s, s, 2 * s } })
end
row({ shape = "plate.ellipse", a = a, b = b }, { measure = pi * a * b,
  I = { b ^ 2 / 4, a ^ 2 / 4, (a ^ 2 + b ^ 2) / 4 } })
row({ shape = "plate.rectangle", x = x, y = y },
  { measure = x * y, I = { y ^ 2 / 12, x ^ 2 / 12, (x ^ 2 + y ^ 2) / 12 } })
for _, t in ipairs { 3 / 4 * pi, pi, 2 * pi } do
  local s = sin(2 * t) / (2 * t)
  row({ shape = "plate.sector", r = r, angle = t }, { measure = t * r ^ 2 / 2,
    com = { 2 * r / (3 * t) * sin(t), 2 * r / (3 * t) * (1 - cos(t)), 0 },
    S = { r ^ 2 / 4 * (1 + s), r ^ 2 / 4 * (1 - s), 0, r ^ 2 / 4 * sin(t) ^ 2 / t } })
  row({ shape = "wire.arc", r = r, angle = t }, { measure = r * t,
    com = { r / t * sin(t), r / t * (1 - cos(t)), 0 },
    S = { r ^ 2 / 2 * (1 + s), r ^ 2 / 2 * (1 - s), 0, r ^ 2 / 2 * sin(t) ^ 2 / t } })
end
do
  local v = { { 0, 0, 1 }, { 2, 0, 1 }, { 0, 1, 2 } } -- cross product (0, -2, 2)
  local com, S = spread(1 / 12, v)
  row({ shape = "plate.triangle", vertices = v }, { measure = sqrt(8) / 2, com = com, S = S })
end

-- A rectangle without another one: measure and means, as sums over the two.
local function framed(x1, x2, y1, y2, u1, u2, v1, v2)
  local A, B = (x2 - x1) * (y2 - y1), (u2 - u1) * (v2 - v1)
  local function mean(f) return (A * f(x1, x2, y1, y2) - B * f(u1, u2, v1, v2)) / (A - B) end
  local function square(s, t) return (s ^ 2 + s * t + t ^ 2) / 3 end
  return A - B, mean(function(p, q) return (p + q) / 2 end), mean(function(_, _, p, q) return (p + q) / 2 end),
    mean(square), mean(function(_, _, p, q) return square(p, q) end),
    mean(function(p, q, s, t) return (p + q) * (s + t) / 4 end)
end
do
  local frame = { { 0, 0 }, { 0, 2 }, { 3, 2 }, { 3, 0 } }
  local hole = { { 1, 0.5 }, { 1, 1.5 }, { 1.5, 1.5 }, { 1.5, 0.5 } }
  local A, xm, ym, xx, yy, xy = framed(0, 3, 0, 2, 1, 1.5, 0.5, 1.5)
  row({ shape = "plate.polygon", profile = frame, holes = { hole } }, { measure = A, com = { xm, ym, 0 },
    S = { xx, yy, 0, xy } })
  row({ shape = "extrude", profile = frame, holes = { hole }, h = h }, { measure = A * h, com = { xm, ym, h / 2 },
    S = { xx, yy, h ^ 2 / 3, xy, xm * h / 2, ym * h / 2 } })
  -- rings: radii 1..2 by height 0..3 without 1.2..1.7 by 1..2
  local function ring(p, q, s, t) return pi * (q ^ 2 - p ^ 2) * (t - s), (p ^ 2 + q ^ 2) / 4, (s + t) / 2,
    (s ^ 2 + s * t + t ^ 2) / 3 end
  local V, u, zm, zz = ring(1, 2, 0, 3)
  local W, uh, zh, zzh = ring(1.2, 1.7, 1, 2)
  local function mean(p, q) return (V * p - W * q) / (V - W) end
  row({ shape = "revolve", profile = { { 1, 0 }, { 1, 3 }, { 2, 3 }, { 2, 0 } },
    holes = { { { 1.2, 1 }, { 1.7, 1 }, { 1.7, 2 }, { 1.2, 2 } } } },
    { measure = V - W, com = { 0, 0, mean(zm, zh) }, S = { mean(u, uh), mean(u, uh), mean(zz, zzh) } })
end

-- ---- rods and wires ----

row({ shape = "rod.straight", length = h }, { measure = h, I = { h ^ 2 / 12, h ^ 2 / 12, 0 } })
row({ shape = "rod.between", from = { 1, 0, 2 }, to = { 3, 1, 0 } }, { measure = 3, com = { 2, 0.5, 1 },
  S = { 4 + 4 / 12, 0.25 + 1 / 12, 1 + 4 / 12, 1 + 2 / 12, 2 - 4 / 12, 0.5 - 2 / 12 } })
row({ shape = "wire.hoop", r = r }, { measure = 2 * pi * r, I = { r ^ 2 / 2, r ^ 2 / 2, r ^ 2 } })
row({ shape = "wire.polyline", points = { { 3, 0, 0 }, { 0, 0, 0 }, { 0, 4, 0 } } }, { measure = 7,
  com = { 4.5 / 7, 8 / 7, 0 }, S = { 9 / 7, 64 / 21, 0 } })
row({ shape = "wire.polyline", points = { { 0, 0, 0 }, { a, 0, 0 }, { a, a, 0 }, { 0, a, 0 } }, closed = true },
  { measure = 4 * a, com = { a / 2, a / 2, 0 }, I = { a ^ 2 / 6, a ^ 2 / 6, a ^ 2 / 3 } })
for _, turns in ipairs { 2.25, 1 } do
  local p = turns == 1 and -0.6 or 0.8
  local T, k = 2 * pi * turns, p / (2 * pi)
  local s = sin(2 * T) / (2 * T)
  row({ shape = "wire.helix", r = r, pitch = p, turns = turns }, { measure = T * sqrt(r ^ 2 + k ^ 2),
    com = { r * sin(T) / T, r * (1 - cos(T)) / T, k * T / 2 },
    S = { r ^ 2 / 2 * (1 + s), r ^ 2 / 2 * (1 - s), (k * T) ^ 2 / 3, r ^ 2 / 2 * sin(T) ^ 2 / T,
      r * k * (cos(T) + T * sin(T) - 1) / T, r * k * (sin(T) - T * cos(T)) / T } })
end
do
  local u = x / (2 * a)
  local sh, ch = (math.exp(u) - math.exp(-u)) / 2, (math.exp(u) + math.exp(-u)) / 2
  row({ shape = "wire.catenary", a = a, span = x }, { measure = 2 * a * sh, com = { 0, a / 2 * (u / sh + ch), 0 },
    S = { a ^ 2 * ((u ^ 2 + 2) * sh - 2 * u * ch) / sh, a ^ 2 * (1 + sh ^ 2 / 3), 0 } })
end

-- ---- regions: a slab over the parabola 0 <= q <= 1 - p^2, |p| <= 1, in all six orders of the variables ----

for _, o in ipairs { { 1, 2, 3 }, { 1, 3, 2 }, { 2, 1, 3 }, { 2, 3, 1 }, { 3, 1, 2 }, { 3, 2, 1 } } do
  local square = { -1, 0, 0, 0 }
  square[1 + o[1]] = 2
  local com, S = { 0, 0, 0 }, {}
  com[o[2]], com[o[3]] = 2 / 5, 1 / 2
  S[o[1]], S[o[2]], S[o[3]] = 1 / 5, 8 / 35, 1 / 3
  local product = { [3] = 4, [4] = 5, [5] = 6 } -- (1,2) (1,3) (2,3) by their sum
  S[4], S[5], S[6] = 0, 0, 0
  S[product[o[2] + o[3]]] = 1 / 5
  row({ shape = "region", order = o, limits = { { { { -1, 0, 0, 0 } }, { { 1, 0, 0, 0 } } },
    { {}, { { 1, 0, 0, 0 }, square } }, { {}, { { 1, 0, 0, 0 } } } } }, { measure = 4 / 3, com = com, S = S })
end

return rows
