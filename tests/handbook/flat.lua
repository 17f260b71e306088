-- flat.lua - solids with plane faces, and what polygons sweep out, as handbooks print them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The form of a row: tests/handbook.lua.  Sources: Beer and Johnston, Vector Mechanics; Tonon, J. Math. Stat. 1 (2004)
-- 8, for the tetrahedron (sums over pairs of corners); Weisstein, MathWorld, for the regular polyhedra (moments of the
-- dodecahedron and icosahedron there: (95 + 39 sqrt 5)/300 and (3 + sqrt 5)/20).  Prisms and turned bodies: sums over
-- rectangles, rings, cones and triangles.

local rows = {}
local function row(shape, args, params, at, of)
  rows[#rows + 1] = { shape = shape, args = args, params = params, at = at, of = of }
end

local PAIRS = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }

row("solid.pyramid", "x = a, y = b, h = h", { "a", "b", "h" }, { a = 3, b = 2, h = 2.5 }, function(e)
  return { measure = e.a * e.b * e.h / 3, com = { 0, 0, e.h / 4 },
    I = { (4 * e.b ^ 2 + 3 * e.h ^ 2) / 80, (4 * e.a ^ 2 + 3 * e.h ^ 2) / 80, (e.a ^ 2 + e.b ^ 2) / 20, 0, 0, 0 },
    points = { apex = { 0, 0, e.h }, base = { 0, 0, 0 } } }
end)
row("solid.wedge", "x = a, y = b, z = c", { "a", "b", "c" }, { a = 3, b = 2, c = 1.5 }, function(e)
  return { measure = e.a * e.b * e.c / 2, com = { e.a / 3, e.b / 3, e.c / 2 },
    I = { e.b ^ 2 / 18 + e.c ^ 2 / 12, e.a ^ 2 / 18 + e.c ^ 2 / 12, (e.a ^ 2 + e.b ^ 2) / 18, e.a * e.b / 36, 0, 0 },
    points = { corner = { 0, 0, 0 } } }
end)
-- right triangle: means x^2 = a^2/6, x y = a b/12
row("solid.prism", "profile = {{0, 0}, {0, b}, {a, 0}}, h = c", { "a", "b", "c" }, { a = 3, b = 2, c = 1.5 },
  function(e)
    local a, b, c = e.a, e.b, e.c
    return { measure = a * b * c / 2, com = { a / 3, b / 3, c / 2 },
      S = { a ^ 2 / 6, b ^ 2 / 6, c ^ 2 / 3, a * b / 12, a * c / 6, b * c / 6 } }
  end)

local function determinant(u, v, w)
  return u[1] * (v[2] * w[3] - v[3] * w[2]) - u[2] * (v[1] * w[3] - v[3] * w[1]) + u[3] * (v[1] * w[2] - v[2] * w[1])
end

-- Tonon: the mean of x_i x_j over a tetrahedron is the sum over all pairs of corners k <= l of v_k v_l, /10 (symmetric)
local function tetrahedron(v, volume)
  local com, S = {}, {}
  for i = 1, 3 do com[i] = (v[1][i] + v[2][i] + v[3][i] + v[4][i]) / 4 end
  for n, ij in ipairs(PAIRS) do
    local sum = 0
    for k = 1, 4 do
      for l = k, 4 do sum = sum + v[k][ij[1]] * v[l][ij[2]] + v[l][ij[1]] * v[k][ij[2]] end
    end
    S[n] = sum / 20
  end
  return { measure = volume, com = com, S = S, points = { v1 = v[1], v2 = v[2], v3 = v[3], v4 = v[4] } }
end
-- corners (p, q, p), + (a, q, 0), + (p, b, -q), + (0, p, c) from the first; and in the other order
for turn = 1, 2 do
  local list = { "{p, q, p}", "{p + a, 2*q, p}", "{2*p, q + b, p - q}", "{p, q + p, p + c}" }
  if turn == 2 then list[1], list[2] = list[2], list[1] end
  row("solid.tetrahedron", "vertices = {" .. table.concat(list, ", ") .. "}", { "a", "b", "c", "p", "q" },
    { a = 1.3, b = 1.2, c = 1.5, p = 0.2, q = 0.1 }, function(e, f)
      local p, q = e.p, e.q
      local v = { { p, q, p }, { p + e.a, 2 * q, p }, { 2 * p, q + e.b, p - q }, { p, q + p, p + e.c } }
      if turn == 2 then v[1], v[2] = v[2], v[1] end
      return tetrahedron(v, f.abs(determinant({ e.a, q, 0 }, { p, e.b, -q }, { 0, p, e.c })) / 6)
    end)
end
-- a parallelepiped with edges u, v, w: x = s u + t v + r w with s, t, r uniform in (0, 1): mean s^2 1/3, s t 1/4
row("solid.parallelepiped", "edges = {{a, q, 0}, {p, b, -q}, {0, p, c}}", { "a", "b", "c", "p", "q" },
  { a = 1.3, b = 1.2, c = 1.5, p = 0.2, q = 0.1 }, function(e, f)
    local u = { { e.a, e.q, 0 }, { e.p, e.b, -e.q }, { 0, e.p, e.c } }
    local com, S = {}, {}
    for i = 1, 3 do com[i] = (u[1][i] + u[2][i] + u[3][i]) / 2 end
    for n, ij in ipairs(PAIRS) do
      local sum = 0
      for k = 1, 3 do
        for l = 1, 3 do sum = sum + u[k][ij[1]] * u[l][ij[2]] / (k == l and 3 or 4) end
      end
      S[n] = sum
    end
    return { measure = f.abs(determinant(u[1], u[2], u[3])), com = com, S = S, points = { corner = { 0, 0, 0 } } }
  end)

-- volume, moment, and a vertex: the corners as the frame of the shape has them
local regular = {
  [4] = function(e, f) return e.s ^ 3 / (6 * f.sqrt(2)), e.s ^ 2 / 20, { 1, 1, 1 }, e.s / (2 * f.sqrt(2)) end,
  [6] = function(e) return e.s ^ 3, e.s ^ 2 / 6, { -1, -1, -1 }, e.s / 2 end,
  [8] = function(e, f) return f.sqrt(2) * e.s ^ 3 / 3, e.s ^ 2 / 10, { 1, 0, 0 }, e.s / f.sqrt(2) end,
  [12] = function(e, f)
    return (15 + 7 * f.sqrt(5)) * e.s ^ 3 / 4, (95 + 39 * f.sqrt(5)) * e.s ^ 2 / 300, { 1, 1, 1 },
      e.s * (1 + f.sqrt(5)) / 4
  end,
  [20] = function(e, f)
    return 5 * (3 + f.sqrt(5)) * e.s ^ 3 / 12, (3 + f.sqrt(5)) * e.s ^ 2 / 20, { 0, 1, (1 + f.sqrt(5)) / 2 }, e.s / 2
  end,
}
for _, faces in ipairs { 4, 6, 8, 12, 20 } do
  row("solid.regular", "faces = " .. faces .. ", edge = s", { "s" }, { s = 1.4 }, function(e, f)
    local V, I, vertex, unit = regular[faces](e, f)
    return { measure = V, I = { I, I, I, 0, 0, 0 },
      points = { vertex = { vertex[1] * unit, vertex[2] * unit, vertex[3] * unit } } }
  end)
end

-- ---- polygons with holes ----

-- Means over parts {weight, {f = value}}, the weight of a hole negative: of every key, and the total weight.
local function mean(parts)
  local total, out = 0, {}
  for _, p in ipairs(parts) do
    total = total + p[1]
    for k, v in pairs(p[2]) do out[k] = (out[k] or 0) + p[1] * v end -- in any order: sums by key
  end
  for k, v in pairs(out) do out[k] = v / total end -- in any order
  return total, out
end

local function rectangle(x1, x2, y1, y2)
  return (x2 - x1) * (y2 - y1), { x = (x1 + x2) / 2, y = (y1 + y2) / 2, xx = (x1 ^ 2 + x1 * x2 + x2 ^ 2) / 3,
    yy = (y1 ^ 2 + y1 * y2 + y2 ^ 2) / 3, xy = (x1 + x2) * (y1 + y2) / 4 }
end

-- the right triangle (x, y), (x + a, y), (x, y + b)
local function triangle(x, y, a, b)
  return a * b / 2, { x = x + a / 3, y = y + b / 3, xx = x ^ 2 + 2 * x * a / 3 + a ^ 2 / 6,
    yy = y ^ 2 + 2 * y * b / 3 + b ^ 2 / 6, xy = x * y + x * b / 3 + y * a / 3 + a * b / 12 }
end

-- a rectangle 6 a x 4 b with its corner at (p, q), without a rectangle a x b and a triangle; holes wind either way
local FRAME = "profile = {{p, q}, {p, q + 4*b}, {p + 6*a, q + 4*b}, {p + 6*a, q}}, holes = " ..
  "{{{p + a, q + b}, {p + a, q + 2*b}, {p + 2*a, q + 2*b}, {p + 2*a, q + b}}, " ..
  "{{p + 3*a, q + b}, {p + 5*a, q + b}, {p + 3*a, q + 3*b}}}"
local PARAMS = { "a", "b", "p", "q" }
local function frame(e)
  local function hole(area, m) return { -area, m } end
  return mean { { rectangle(e.p, e.p + 6 * e.a, e.q, e.q + 4 * e.b) },
    hole(rectangle(e.p + e.a, e.p + 2 * e.a, e.q + e.b, e.q + 2 * e.b)),
    hole(triangle(e.p + 3 * e.a, e.q + e.b, 2 * e.a, 2 * e.b)) }
end
row("plate.polygon", FRAME, PARAMS, { a = 0.5, b = 0.4, p = -0.3, q = 0.2 }, function(e)
  local area, m = frame(e)
  return { measure = area, com = { m.x, m.y, 0 }, S = { m.xx, m.yy, 0, m.xy, 0, 0 } }
end)
row("extrude", FRAME .. ", h = h", { "a", "b", "p", "q", "h" }, { a = 0.5, b = 0.4, p = -0.3, q = 0.2, h = 1.7 },
  function(e)
    local area, m = frame(e)
    return { measure = area * e.h, com = { m.x, m.y, e.h / 2 },
      S = { m.xx, m.yy, e.h ^ 2 / 3, m.xy, m.x * e.h / 2, m.y * e.h / 2 } }
  end)

-- ---- turned ----

local function ring(f, p, q, s, t) -- radii p < q, heights s < t
  return f.pi * (q ^ 2 - p ^ 2) * (t - s),
    { xx = (p ^ 2 + q ^ 2) / 4, z = (s + t) / 2, zz = (s ^ 2 + s * t + t ^ 2) / 3 }
end
local function cone(f, r, s, h) -- base of radius r at height s, apex at s + h: moments of the tables about the base
  return f.pi * r ^ 2 * h / 3, { xx = 3 * r ^ 2 / 20, z = s + h / 4, zz = s ^ 2 + s * h / 2 + h ^ 2 / 10 }
end
local function turned(parts)
  local V, m = mean(parts)
  return { measure = V, com = { 0, 0, m.z }, S = { m.xx, m.xx, m.zz, 0, 0, 0 }, points = { origin = { 0, 0, 0 } } }
end
-- a ring with a hollow ring inside, beginning at height p
row("revolve", "profile = {{r, p}, {r, p + 3*c}, {r + 4*a, p + 3*c}, {r + 4*a, p}}, " ..
  "holes = {{{r + a, p + c}, {r + 2*a, p + c}, {r + 2*a, p + 2*c}, {r + a, p + 2*c}}}",
  { "a", "c", "p", "r" }, { a = 0.25, c = 1, p = -0.4, r = 1 }, function(e, f)
    local V, m = ring(f, e.r, e.r + 4 * e.a, e.p, e.p + 3 * e.c)
    local W, n = ring(f, e.r + e.a, e.r + 2 * e.a, e.p + e.c, e.p + 2 * e.c)
    return turned { { V, m }, { -W, n } }
  end)
-- a cone on a cylinder: the sloping side
row("revolve", "profile = {{0, p}, {r, p}, {r, p + h}, {0, p + h + l}}", { "r", "h", "p", "l" },
  { r = 0.8, h = 0.7, p = 0.2, l = 1.1 }, function(e, f)
    local V, m = ring(f, 0, e.r, e.p, e.p + e.h)
    local W, n = cone(f, e.r, e.p + e.h, e.l)
    return turned { { V, m }, { W, n } }
  end)

return rows
