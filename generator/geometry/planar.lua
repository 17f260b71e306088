-- planar.lua -- how far a point of the plane is outside a figure: excesses.
--
-- An excess is negative inside, zero on the border, positive outside, continuous, and near the border the distance to
-- it to first order; far away it may be smaller than the distance, never of the wrong sign.
-- SPDX-License-Identifier: GPL-3.0-or-later

local planar = {}

local max, min, abs, sqrt = math.max, math.min, math.abs, math.sqrt

-- sqrt(x^2 + y^2) and sqrt(x^2 + y^2 + z^2) without overflow.
function planar.length(x, y, z)
  local m = max(abs(x), abs(y), abs(z or 0))
  if m == 0 then return 0.0 end
  x, y, z = x / m, y / m, (z or 0) / m
  return m * sqrt(x * x + y * y + z * z)
end
local length = planar.length

function planar.rectangle(x, y, a, b) return max(abs(x) - a / 2, abs(y) - b / 2) end

-- Level sets g = sqrt(sum (x_i/a_i)^2) = 1: the distance is (g - 1)/|grad g| to first order.
function planar.ellipse(x, y, a, b)
  local u, v = x / a, y / b
  local g = length(u, v)
  return g > 0 and (g - 1) * g / length(u / a, v / b) or -min(a, b)
end

function planar.ellipsoid(x, y, z, a, b, c)
  local u, v, w = x / a, y / b, z / c
  local g = length(u, v, w)
  return g > 0 and (g - 1) * g / length(u / a, v / b, w / c) or -min(a, b, c)
end

-- 0 <= phi <= angle <= 2 pi, r unbounded: the distance to the nearer border ray.
function planar.angle(x, y, angle)
  if angle >= 2 * math.pi then return -math.huge end
  local r, phi = length(x, y), math.atan(y, x)
  if phi < 0 then phi = phi + 2 * math.pi end
  local inside = phi <= angle
  -- to the rays at 0 and at angle, either way round
  local first, second = min(phi, 2 * math.pi - phi), min(abs(phi - angle), 2 * math.pi - abs(phi - angle))
  local d = min(first, second)
  local near = d < math.pi / 2 and r * math.sin(d) or r
  return inside and -near or near
end

function planar.sector(x, y, r, angle) return max(length(x, y) - r, planar.angle(x, y, angle)) end

-- Distance to the segment from (ax, ay) to (bx, by).
function planar.segment(x, y, ax, ay, bx, by)
  local ux, uy, vx, vy = bx - ax, by - ay, x - ax, y - ay
  local l = length(ux, uy)
  if l == 0 then return length(vx, vy) end
  ux, uy = ux / l, uy / l
  local t = min(max(vx * ux + vy * uy, 0), l)
  return length(vx - t * ux, vy - t * uy)
end

-- Distance to the border, its sign by the parity of crossings of the ray to the right (O'Rourke, Computational Geometry
-- in C, section 7.4).  On the border the parity is anybody's guess and the distance zero.
local function polygon(x, y, p)
  local odd, near = false, math.huge
  for i = 1, #p do
    local a, b = p[i], p[i % #p + 1]
    near = min(near, planar.segment(x, y, a[1], a[2], b[1], b[2]))
    if (a[2] > y) ~= (b[2] > y) and x < a[1] + (y - a[2]) / (b[2] - a[2]) * (b[1] - a[1]) then odd = not odd end
  end
  return odd and -near or near
end

-- A hole's inside is outside; the largest excess is that of the difference.
function planar.polygon(x, y, p, holes)
  local e = polygon(x, y, p)
  for _, h in ipairs(holes or {}) do e = max(e, -polygon(x, y, h)) end
  return e
end

return planar
