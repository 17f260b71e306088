-- trails.lua -- the paths that the tips of the body's axes draw in space, on the unit sphere.
-- SPDX-License-Identifier: GPL-3.0-or-later

local rotation = require "generator.attitude.rotation"
local space = require "generator.plot.space"

local trails = {}

local function circle(a, b)
  local list = {}
  for n = 0, 96 do
    local c, s, p = math.cos(2 * math.pi * n / 96), math.sin(2 * math.pi * n / 96), {}
    for i = 1, 3 do p[i] = c * a[i] + s * b[i] end
    list[n + 1] = p
  end
  return list
end

-- The camera that sees most of the paths; of several axes the first one.
local function chosen(paths)
  local best, most
  for _, height in ipairs(#paths == 1 and { 22, -22 } or { 22 }) do
    for _, azimuth in ipairs(#paths == 1 and { 30, 120, -60, -150 } or { 30 }) do
      local camera, seen = space.camera(azimuth, height), 0.0
      for _, p in ipairs(paths[1]) do seen = seen + space.dot(p, camera.eye) end
      if not best or seen > most + 0.05 * #paths[1] then best, most = camera, seen end
    end
  end
  return best
end

-- axes: {{direction along the body, class, name}, ...}
function trails.draw(d, box, samples, axes)
  local paths = {}
  for n, a in ipairs(axes) do
    paths[n] = {}
    for i, s in ipairs(samples) do paths[n][i] = rotation.apply(s.q, a[1]) end
  end
  local camera = chosen(paths)
  local r = math.min(box.x1 - box.x0 - 36, box.y1 - box.y0 - 24) / 2
  local map = space.projection(camera, r, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2 + 6)
  local function front(p) return space.dot(p, camera.eye) end
  local middle = map { 0.0, 0.0, 0.0 }
  d:circle(middle[1], middle[2], r, "skin")
  space.draw(d, circle({ 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }), map, front, "level")
  for i, name in ipairs { "X", "Y", "Z" } do
    local p, q = { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }
    p[i], q[i] = 1.0, 1.14
    local from, to = map(p), map(q)
    d:line(from[1], from[2], to[1], to[2], front(p) >= 0 and "axis" or "axis far")
    d:math(to[1], to[2] + (i == 3 and -3 or 9), name, "end", "middle")
  end
  for n, a in ipairs(axes) do
    local points = paths[n]
    space.draw(d, points, map, front, "line " .. a[2])
    local start, last = map(points[1]), map(points[#points])
    d:circle(start[1], start[2], 3, front(points[1]) >= 0 and "start" or "start far")
    d:math(last[1] + 5, last[2] + 4, a[3], "math")
  end
end

return trails
