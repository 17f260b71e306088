-- thin.lua -- how far a point is from a shell, a plate, a wire or a particle, in the shape's own frame.
--
-- Thin things have no inside: the excess is zero on them and positive beside them (a plate's rim counts as the distance
-- within its plane, see planar.lua).  `p` is {x, y, z}, `a` the shape's numbers.
-- SPDX-License-Identifier: GPL-3.0-or-later

local planar = require "generator.geometry.planar"
local solids = require "generator.geometry.solids"

local thin = {}

local max, min, abs = math.max, math.min, math.abs
local length = planar.length

local function rho(p) return length(p[1], p[2]) end
local function radius(p) return length(p[1], p[2], p[3]) end
local function dot(u, v) return u[1] * v[1] + u[2] * v[2] + u[3] * v[3] end
local function sub(u, v) return { u[1] - v[1], u[2] - v[2], u[3] - v[3] } end

-- ---- shells ----

-- The border of a solid.
local function border(name)
  return function(p, a) return abs(solids[name](p, a)) end
end
for _, name in ipairs { "sphere", "ellipsoid", "torus", "box" } do thin["shell." .. name] = border("solid." .. name) end

thin["shell.hemisphere"] = function(p, a) return max(abs(radius(p) - a.r), -p[3]) end
thin["shell.zone"] = function(p, a) return max(abs(radius(p) - a.r), a.z1 - p[3], p[3] - a.z2) end
-- side and ends, each a plate of its own
thin["shell.cylinder"] = function(p, a)
  local side, end_ = rho(p) - a.r, abs(p[3]) - a.h / 2
  local e = max(abs(side), end_)
  return a.ends and min(e, max(abs(end_), side)) or e
end
thin["shell.cone"] = function(p, a) return planar.segment(rho(p), p[3], a.r, 0, 0, a.h) end

-- ---- plates ----

local function flat(figure)
  return function(p, a) return max(abs(p[3]), figure(p[1], p[2], a)) end
end
thin["plate.disc"] = flat(function(x, y, a) return length(x, y) - a.r end)
thin["plate.annulus"] = flat(function(x, y, a) return max(length(x, y) - a.r_out, a.r_in - length(x, y)) end)
thin["plate.ellipse"] = flat(function(x, y, a) return planar.ellipse(x, y, a.a, a.b) end)
thin["plate.rectangle"] = flat(function(x, y, a) return planar.rectangle(x, y, a.x, a.y) end)
thin["plate.sector"] = flat(function(x, y, a) return planar.sector(x, y, a.r, a.angle) end)
thin["plate.polygon"] = flat(function(x, y, a) return planar.polygon(x, y, a.profile, a.holes) end)

local function scaled(v, k) return { v[1] * k, v[2] * k, v[3] * k } end

-- In the triangle's own plane: x along its first edge.
thin["plate.triangle"] = function(p, a)
  local o, u, v = a.vertices[1], sub(a.vertices[2], a.vertices[1]), sub(a.vertices[3], a.vertices[1])
  local ex = scaled(u, 1 / radius(u))
  local ey = sub(v, scaled(ex, dot(ex, v)))
  ey = scaled(ey, 1 / radius(ey))
  local ez = { ex[2] * ey[3] - ex[3] * ey[2], ex[3] * ey[1] - ex[1] * ey[3], ex[1] * ey[2] - ex[2] * ey[1] }
  local d = sub(p, o)
  local profile = { { 0, 0 }, { dot(ex, u), 0 }, { dot(ex, v), dot(ey, v) } }
  return max(abs(dot(ez, d)), planar.polygon(dot(ex, d), dot(ey, d), profile))
end

-- ---- rods and wires ----

-- The distance to the segment a b.
local function segment(p, a, b)
  local u, v = sub(b, a), sub(p, a)
  local l = radius(u)
  if l == 0 then return radius(v) end
  u = scaled(u, 1 / l)
  return radius(sub(v, scaled(u, min(max(dot(u, v), 0), l))))
end
thin["rod.straight"] = function(p, a) return length(rho(p), max(abs(p[3]) - a.length / 2, 0)) end
thin["rod.between"] = function(p, a) return segment(p, a.from, a.to) end
thin["wire.polyline"] = function(p, a)
  local e, n = math.huge, #a.points
  for i = 1, a.closed and n or n - 1 do e = min(e, segment(p, a.points[i], a.points[i % n + 1])) end
  return e
end
thin["wire.hoop"] = function(p, a) return length(rho(p) - a.r, p[3]) end

-- The circle where it is, else the nearer end.
thin["wire.arc"] = function(p, a)
  if planar.angle(p[1], p[2], a.angle) <= 0 then return thin["wire.hoop"](p, a) end
  local x, y = a.r * math.cos(a.angle), a.r * math.sin(a.angle)
  return min(length(p[1] - a.r, p[2], p[3]), length(p[1] - x, p[2] - y, p[3]))
end

-- The winding at p's own angle that is nearest, and the two ends; to first order near the wire.
thin["wire.helix"] = function(p, a)
  local last, turn = 2 * math.pi * a.turns, 2 * math.pi
  local function to(t)
    t = min(max(t, 0), last)
    return length(p[1] - a.r * math.cos(t), p[2] - a.r * math.sin(t), p[3] - a.pitch * (t / turn))
  end
  local phi = math.atan(p[2], p[1])
  local k = a.pitch ~= 0 and math.floor((p[3] / a.pitch * turn - phi) / turn + 0.5) or 0
  return min(to(0), to(last), to(phi + turn * (k - 1)), to(phi + turn * k), to(phi + turn * (k + 1)))
end

-- y = a cosh(x/a): the distance across the curve is the vertical one times sech(x/a).
thin["wire.catenary"] = function(p, a)
  local x = min(max(p[1], -a.span / 2), a.span / 2)
  local c = (math.exp(x / a.a) + math.exp(-x / a.a)) / 2
  return length(p[1] - x, (p[2] - a.a * c) / (x == p[1] and c or 1), p[3])
end

thin.points = function(p, a)
  local e = math.huge
  for _, row in ipairs(a.list) do e = min(e, radius { p[1] - row[2], p[2] - row[3], p[3] - row[4] }) end
  return e
end

return thin
