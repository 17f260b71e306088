-- solids.lua -- how far a point is outside a solid: the excess (see planar.lua) of every solid, in its own frame.
--
-- Each is the largest of the excesses of what bounds it: half spaces, balls, cones and cylinders, written down from
-- the shape's definition; a point is inside when all are negative.  `p` is {x, y, z}, `a` the shape's numbers.  The
-- largest of excesses is one: an intersection's border is where one is zero and none is positive, and next to it the
-- largest is the distance to first order.  Beside an edge it is less than the distance, by sqrt(2) where the edge is
-- a right angle and by more where it is sharper, never of the wrong sign.  A border f = 0 takes f/|gradient f|.
-- SPDX-License-Identifier: GPL-3.0-or-later

local planar = require "generator.geometry.planar"

local solids = {}

local max, abs, sqrt = math.max, math.abs, math.sqrt
local length = planar.length

local function slab(z, lo, hi) return max(lo - z, z - hi) end
local function centred(z, h) return abs(z) - h / 2 end
local function rho(p) return length(p[1], p[2]) end
local function radius(p) return length(p[1], p[2], p[3]) end
local function dot(u, v) return u[1] * v[1] + u[2] * v[2] + u[3] * v[3] end
local function sub(u, v) return { u[1] - v[1], u[2] - v[2], u[3] - v[3] } end
local function cross(u, v)
  return { u[2] * v[3] - u[3] * v[2], u[3] * v[1] - u[1] * v[3], u[1] * v[2] - u[2] * v[1] }
end
local function unit(v)
  local l = radius(v)
  return { v[1] / l, v[2] / l, v[3] / l }
end

solids["solid.box"] = function(p, a) return max(centred(p[1], a.x), centred(p[2], a.y), centred(p[3], a.z)) end
solids["solid.sphere"] = function(p, a) return radius(p) - a.r end
solids["solid.ellipsoid"] = function(p, a) return planar.ellipsoid(p[1], p[2], p[3], a.a, a.b, a.c) end
solids["solid.cylinder"] = function(p, a) return max(rho(p) - a.r, centred(p[3], a.h)) end
solids["solid.elliptic_cylinder"] = function(p, a)
  return max(planar.ellipse(p[1], p[2], a.a, a.b), centred(p[3], a.h))
end
solids["solid.tube"] = function(p, a)
  local d = rho(p)
  return max(d - a.r_out, a.r_in - d, centred(p[3], a.h))
end

-- rho <= r1 + (r2 - r1) z/h: a straight slope in the plane of rho and z.
local function slope(d, z, r1, r2, h) return (d - r1 - (r2 - r1) * (z / h)) / length(1, (r2 - r1) / h) end
solids["solid.frustum"] = function(p, a) return max(slope(rho(p), p[3], a.r_base, a.r_top, a.h), slab(p[3], 0, a.h)) end
solids["solid.cone"] = function(p, a) return max(slope(rho(p), p[3], a.r, 0, a.h), slab(p[3], 0, a.h)) end

-- g = sqrt((x/a)^2 + (y/b)^2) <= 1 - z/h; on the axis the cone is met by going up.
solids["solid.elliptic_cone"] = function(p, a)
  local u, v = p[1] / a.a, p[2] / a.b
  local g = length(u, v)
  local grad = g > 0 and length(u / a.a, v / a.b) / g or 0
  return max((g - 1 + p[3] / a.h) / length(grad, 1 / a.h), slab(p[3], 0, a.h))
end

solids["solid.capsule"] = function(p, a) return length(rho(p), max(centred(p[3], a.h), 0)) - a.r end
solids["solid.hemisphere"] = function(p, a) return max(radius(p) - a.r, -p[3]) end
-- the ball's centre is at z = h - r
solids["solid.cap"] = function(p, a) return max(length(p[1], p[2], p[3] - (a.h - a.r)) - a.r, -p[3]) end
solids["solid.zone"] = function(p, a) return max(radius(p) - a.r, slab(p[3], a.z1, a.z2)) end
-- |p| sin(angle from the axis - half angle): right for half angles up to pi
solids["solid.sector"] = function(p, a)
  local c = (a.r - a.h) / a.r
  local s = sqrt(max(0, a.h * (2 * a.r - a.h))) / a.r
  local d = rho(p)
  local cone = d * c - p[3] * s
  if c < 0 and d == 0 then cone = p[3] >= 0 and -abs(p[3]) or abs(p[3]) * s end -- the axis is inside, or its far end
  return max(radius(p) - a.r, cone)
end
solids["solid.half_cylinder"] = function(p, a) return max(rho(p) - a.r, -p[1], centred(p[3], a.h)) end
solids["solid.quarter_cylinder"] = function(p, a) return max(rho(p) - a.r, -p[1], -p[2], centred(p[3], a.h)) end
solids["solid.hoof"] = function(p, a)
  return max(rho(p) - a.r, -p[1], -p[3], (p[3] - a.h * (p[1] / a.r)) / length(1, a.h / a.r))
end
-- a circle in the plane of rho and z
solids["solid.torus"] = function(p, a) return length(rho(p) - a.R, p[3]) - a.r end
solids["solid.hollow_sphere"] = function(p, a)
  local d = radius(p)
  return max(d - a.r_out, a.r_in - d)
end
-- rho - r sqrt(z/h) has no slope at the vertex; (rho^2 - r^2 z/h)/|gradient| has
solids["solid.paraboloid"] = function(p, a)
  local d, k = rho(p) / a.r, a.r / (2 * a.h)
  return max(a.r / 2 * (d * d - p[3] / a.h) / length(d, k), p[3] - a.h)
end
solids["solid.pyramid"] = function(p, a)
  return max(slope(abs(p[1]), p[3], a.x / 2, 0, a.h), slope(abs(p[2]), p[3], a.y / 2, 0, a.h), slab(p[3], 0, a.h))
end
solids["solid.bicylinder"] = function(p, a) return max(length(p[1], p[3]), length(p[2], p[3])) - a.r end

local function prism(p, a) return max(planar.polygon(p[1], p[2], a.profile, a.holes), slab(p[3], 0, a.h)) end
solids["solid.prism"], solids.extrude = prism, prism
solids["solid.wedge"] = function(p, a)
  return max(-p[1], -p[2], (p[1] / a.x + p[2] / a.y - 1) / length(1 / a.x, 1 / a.y), slab(p[3], 0, a.z))
end
solids.revolve = function(p, a) return planar.polygon(rho(p), p[3], a.profile, a.holes) end

-- Half spaces through a face, the body on the side of `within`.
local function face(p, a, b, c, within)
  local n = unit(cross(unit(sub(b, a)), unit(sub(c, a))))
  local side = dot(n, sub(within, a))
  local e = dot(n, sub(p, a))
  return side > 0 and -e or e
end
-- the four faces, each with the vertex that it does not have
solids["solid.tetrahedron"] = function(p, a)
  local v = a.vertices
  return max(face(p, v[2], v[3], v[4], v[1]), face(p, v[1], v[3], v[4], v[2]), face(p, v[1], v[2], v[4], v[3]),
    face(p, v[1], v[2], v[3], v[4]))
end
-- three slabs
solids["solid.parallelepiped"] = function(p, a)
  local e = -math.huge
  for i = 1, 3 do -- between the face through the origin and the one through the third edge's end
    local n = unit(cross(unit(a.edges[i % 3 + 1]), unit(a.edges[(i + 1) % 3 + 1])))
    local d, t = dot(n, a.edges[i]), dot(n, p)
    if d < 0 then d, t = -d, -t end
    e = max(e, -t, t - d)
  end
  return e
end

-- Regular polyhedra: |n.p| <= inradius for the directions n of the faces (Coxeter, Regular Polytopes, table I).
local phi = (1 + sqrt(5)) / 2
local normals = {
  [6] = { inradius = 1 / 2, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
  [8] = { inradius = sqrt(6) / 6, { 1, 1, 1 }, { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 } },
  [12] = { inradius = phi * phi / (2 * sqrt(3 - phi)), { 1, 0, phi }, { -1, 0, phi }, { phi, 1, 0 }, { phi, -1, 0 },
    { 0, phi, 1 }, { 0, phi, -1 } },
  [20] = { inradius = phi * phi / (2 * sqrt(3)), { 1, 1, 1 }, { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 },
    { 1 / phi, 0, phi }, { -1 / phi, 0, phi }, { phi, 1 / phi, 0 }, { phi, -1 / phi, 0 }, { 0, phi, 1 / phi },
    { 0, phi, -1 / phi } },
}
solids["solid.regular"] = function(p, a)
  local e, list = -math.huge, normals[math.tointeger(a.faces)]
  if list then
    for _, n in ipairs(list) do e = max(e, abs(dot(unit(n), p)) - list.inradius * a.edge) end
    return e
  end
  for _, n in ipairs { { -1, -1, -1 }, { -1, 1, 1 }, { 1, -1, 1 }, { 1, 1, -1 } } do -- opposite to the vertices
    e = max(e, dot(unit(n), p) - sqrt(6) / 12 * a.edge)
  end
  return e
end

-- A polynomial {{coefficient, i, j, k}, ...} at p.
local function value(terms, p)
  local s = 0.0
  for _, t in ipairs(terms) do s = s + t[1] * p[1] ^ t[2] * p[2] ^ t[3] * p[3] ^ t[4] end
  return s
end

-- Iterated limits, each measured along its own axis; where an outer variable is out of its limits only that counts.
solids.region = function(p, a)
  local e = -math.huge
  for n = 1, 3 do
    local x, l = p[a.order[n]], a.limits[n]
    e = max(e, value(l[1], p) - x, x - value(l[2], p))
    if e > 0 then return e end
  end
  return e
end

return solids
