-- polygon.lua -- exact integrals over plane polygons with holes, and over what revolves them.
--
-- A loop is an anticlockwise list of {x, y}; the first is the outer one, the others are holes in it.  Each loop is cut
-- into triangles from its first vertex o, with signed areas, so that far polygons keep their digits:
-- for a triangle of area A with corners p, q, s
--     integral of f^n  =  2 A n!/(n+2)!  h_n(f_p, f_q, f_s)      f linear, h_n complete homogeneous symmetric
-- and by polarisation of x f^2 and the like (Lasserre, Avrachenkov, Am. Math. Monthly 108 (2001) 151).
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local polygon = {}

local tidy = ratio.tidy

-- Calls f(c, d1, d2) for each triangle of the fan: c twice its signed area, d1, d2 its other corners from the first.
local function fan(loop, f)
  local o = loop[1]
  for i = 2, #loop - 1 do
    local x1, y1 = loop[i][1] - o[1], loop[i][2] - o[2]
    local x2, y2 = loop[i + 1][1] - o[1], loop[i + 1][2] - o[2]
    f(x1 * y2 - x2 * y1, { x1, y1 }, { x2, y2 })
  end
end

-- One loop: area, centroid {x, y}, second moments about it per unit area {xx, yy, xy}.
-- S is twice the area, F and Q are 6 and 24 times the first and second moments about the first vertex.
local function moments(loop)
  local S, F, Q = expr.zero, { expr.zero, expr.zero }, { expr.zero, expr.zero, expr.zero }
  fan(loop, function(c, a, b)
    local s = { a[1] + b[1], a[2] + b[2] }
    S = S + c
    for k = 1, 2 do
      F[k] = F[k] + c * s[k]
      Q[k] = Q[k] + c * (s[k] ^ 2 + a[k] ^ 2 + b[k] ^ 2)
    end
    Q[3] = Q[3] + c * (s[1] * s[2] + a[1] * a[2] + b[1] * b[2])
  end)
  local d = { tidy(F[1] / (3 * S)), tidy(F[2] / (3 * S)) }
  return tidy(S / 2), { tidy(loop[1][1] + d[1]), tidy(loop[1][2] + d[2]) },
    { tidy(Q[1] / (12 * S) - d[1] ^ 2), tidy(Q[2] / (12 * S) - d[2] ^ 2), tidy(Q[3] / (12 * S) - d[1] * d[2]) }
end

-- The polygon with its holes: area (positive), centroid, second moments about it per unit area {xx, yy, xy}.
function polygon.moments(profile, holes)
  local area, c, q = moments(profile)
  if #holes == 0 then return area, c, q end
  local parts = { { area, c, q } }
  for _, h in ipairs(holes) do
    local a, hc, hq = moments(h)
    parts[#parts + 1] = { -a, hc, hq }
  end
  local total, first = expr.zero, { expr.zero, expr.zero }
  for _, p in ipairs(parts) do
    total = total + p[1]
    for k = 1, 2 do first[k] = first[k] + p[1] * p[2][k] end
  end
  local com = { tidy(first[1] / total), tidy(first[2] / total) }
  local sum = { expr.zero, expr.zero, expr.zero }
  for _, p in ipairs(parts) do
    local dx, dy = p[2][1] - com[1], p[2][2] - com[2]
    local d = { dx ^ 2, dy ^ 2, dx * dy }
    for k = 1, 3 do sum[k] = sum[k] + p[1] * (p[3][k] + d[k]) end
  end
  return tidy(total), com, vec.map(sum, function(e) return tidy(e / total) end)
end

-- Integrals over one loop of {radius, z} for its solid of revolution: of x, x^3, x z, x z^2, z from the loop's first
-- vertex.
local function revolved(loop)
  local sums = { expr.zero, expr.zero, expr.zero, expr.zero }
  local r0 = loop[1][1]
  fan(loop, function(c, a, b)
    local x, z = { r0, r0 + a[1], r0 + b[1] }, { expr.zero, a[2], b[2] }
    local X, Z, xx, xxx, xz, zz, xzz = x[1] + x[2] + x[3], z[2] + z[3], expr.zero, expr.zero, expr.zero, expr.zero,
      expr.zero
    for k = 1, 3 do
      xx, xxx = xx + x[k] ^ 2, xxx + x[k] ^ 3
      xz, zz, xzz = xz + x[k] * z[k], zz + z[k] ^ 2, xzz + x[k] * z[k] ^ 2
    end
    sums[1] = sums[1] + c * X / 6
    sums[2] = sums[2] + c * (X ^ 3 + 3 * X * xx + 2 * xxx) / 120
    sums[3] = sums[3] + c * (X * Z + xz) / 24
    sums[4] = sums[4] + c * (X * Z ^ 2 + X * zz + 2 * Z * xz + 2 * xzz) / 120
  end)
  return sums
end

-- The solid of revolution about z of a profile of {radius, z} with holes: volume, height of the centroid, and second
-- moments about it per unit volume: across the axis and along it.
-- Pappus: an area dA at the distance x sweeps out 2 pi x dA.  Across the axis half of the mean of x^2, by symmetry.
function polygon.revolved(profile, holes)
  local z0, parts = profile[1][2], {}
  local loops = { profile, table.unpack(holes) }
  for n, loop in ipairs(loops) do
    local s = revolved(loop)
    local shift = loop[1][2] - z0
    s[4] = s[4] + 2 * shift * s[3] + shift ^ 2 * s[1]
    s[3] = s[3] + shift * s[1]
    if n > 1 then
      for k = 1, 4 do s[k] = -s[k] end
    end
    parts[n] = s
  end
  local total = { expr.zero, expr.zero, expr.zero, expr.zero }
  for _, s in ipairs(parts) do
    for k = 1, 4 do total[k] = total[k] + s[k] end
  end
  local z = tidy(total[3] / total[1])
  return tidy(2 * expr.pi * total[1]), tidy(z0 + z), tidy(total[2] / (2 * total[1])),
    tidy(total[4] / total[1] - z ^ 2)
end

return polygon
