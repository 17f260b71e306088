-- quadric.lua -- a motion on an ellipsoid among its neighbours: polhodes, and the phase portrait of the momentum.
--
-- The surface is x_i = a_i u_i with |u| = 1 along the principal axes; the neighbours are curves of u (plot/levels.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local levels = require "generator.plot.levels"
local space = require "generator.plot.space"

local quadric = {}

local neighbours = 5 -- around each axis
local height = 24 -- of the eye, degrees

-- Where the eye's rays touch the surface: its normal there, x_i/a_i^2, is across the eye, so u is across eye_i/a_i.
local function outline(a, eye)
  local u, v = space.across { eye[1] / a[1], eye[2] / a[2], eye[3] / a[3] }
  local list = {}
  for n = 0, 120 do
    local c, s, p = math.cos(2 * math.pi * n / 120), math.sin(2 * math.pi * n / 120), {}
    for i = 1, 3 do p[i] = a[i] * (c * u[i] + s * v[i]) end
    list[n + 1] = p
  end
  return list
end

-- The camera from which most of the curve, by its length, lies well within the near side.
local function chosen(points, a)
  local best, most
  for _, up in ipairs { height, -height } do
    for _, azimuth in ipairs { 35, 145, -35, -145 } do
      local camera, seen = space.camera(azimuth, up), 0.0
      for k = 2, #points do
        local p, q, dot, n, length = points[k], points[k - 1], 0.0, 0.0, 0.0
        for i = 1, 3 do
          dot, n = dot + p[i] / a[i] ^ 2 * camera.eye[i], n + (p[i] / a[i] ^ 2) ^ 2
          length = length + ((p[i] - q[i]) / a[i]) ^ 2
        end
        seen = seen + math.sqrt(length) * math.min(dot / math.sqrt(n), 0.5)
      end
      if not best or seen > most + 1e-3 * math.abs(most) then best, most = camera, seen end
    end
  end
  return best
end

local names_need = 22 -- pixels around, beyond the arrows' heads

-- The scale and place at which all points fit into the box, with their names.
local function fitted(camera, points, box)
  local low, high = { math.huge, math.huge }, { -math.huge, -math.huge }
  for _, p in ipairs(points) do
    for k, v in ipairs { space.dot(camera.right, p), space.dot(camera.up, p) } do
      low[k], high[k] = math.min(low[k], v), math.max(high[k], v)
    end
  end
  local scale = math.min((box.x1 - box.x0 - 2 * names_need) / (high[1] - low[1]),
    (box.y1 - box.y0 - 2 * names_need) / (high[2] - low[2]))
  return space.projection(camera, scale, (box.x0 + box.x1) / 2 - scale * (low[1] + high[1]) / 2,
    (box.y0 + box.y1) / 2 + scale * (low[2] + high[2]) / 2)
end

local longer = 0.22 -- of the longest half axis: the arrows

-- The ends of axis i on the side of the eye: on the surface, and the arrow's.
local function ends(a, i, camera)
  local from, to = { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }
  from[i], to[i] = a[i], a[i] + longer * math.max(a[1], a[2], a[3])
  return from, to, camera.eye[i] >= 0
end

local function axes(d, a, map, camera, names)
  local taken = {}
  for i = 1, 3 do
    local from, to, near = ends(a, i, camera)
    space.arrow(d, map(from), map(to), names[i], near and "axis" or "axis far", taken)
  end
end

-- q: {a = semi-axes, c = of the levels, points = the motion, in principal axes, names = of the axes}
function quadric.draw(d, box, q)
  local a = q.a
  local camera = chosen(q.points, a)
  local edge = outline(a, camera.eye)
  local reach = { table.unpack(edge) }
  for i = 1, 3 do
    local _, tip = ends(a, i, camera)
    reach[#reach + 1] = tip
  end
  local map = fitted(camera, reach, box)
  local function front(p)
    return camera.eye[1] * p[1] / a[1] ^ 2 + camera.eye[2] * p[2] / a[2] ^ 2 + camera.eye[3] * p[3] / a[3] ^ 2
  end
  local flat = {}
  for i, p in ipairs(edge) do flat[i] = map(p) end
  d:polygon(flat, "skin")
  local function curves(list, class)
    for _, u in ipairs(list) do
      local points = {}
      for n, v in ipairs(u) do points[n] = { a[1] * v[1], a[2] * v[2], a[3] * v[3] } end
      space.draw(d, points, map, front, class)
    end
  end
  curves(q.c and levels.family(q.c, neighbours) or {}, "level")
  curves(q.c and levels.separatrix(q.c) or {}, "separatrix")
  space.draw(d, q.points, map, front, "trace")
  axes(d, a, map, camera, q.names)
  local start = map(q.points[1])
  d:circle(start[1], start[2], 3.2, front(q.points[1]) >= 0 and "start" or "start far")
end

return quadric
