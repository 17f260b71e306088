-- cones.lua -- the cones of a free symmetric top: the body's, about its axis, rolls on the one in space, about L.
--
-- w is where they touch.  Their half angles follow from the angles that w has with the axis and with L.
-- SPDX-License-Identifier: GPL-3.0-or-later

local curve = require "generator.plot.curve"
local space = require "generator.plot.space"

local cones = {}

-- The half angles {body, space}, and unit vectors {axis, L, w}: w and L along body axes, k the axis of symmetry.  The
-- axis is turned to the side of L.
function cones.of(w, L, k)
  local axis = space.unit(k)
  if space.dot(axis, L) < 0 then axis = { -axis[1], -axis[2], -axis[3] } end
  local function angle(a, b) return math.atan(space.length(space.cross(a, b)), space.dot(a, b)) end
  return { body = angle(axis, w), space = angle(L, w), axis = axis, L = space.unit(L), w = space.unit(w) }
end

-- A frame with L up and the axis to the right of it: the vectors in it.
local function upright(c)
  local z = c.L
  local n = space.cross(c.L, c.axis)
  local y = space.length(n) > 1e-12 and space.unit(n) or space.across(z)
  local x = space.cross(y, z)
  return function(v) return { space.dot(x, v), space.dot(y, v), space.dot(z, v) } end
end

-- The rim of a cone about the unit vector a with its half angle, slant height 1, and its frame.
local function rim(a, half)
  local b, c = space.across(a)
  local list = {}
  for n = 0, 96 do
    local phi, p = 2 * math.pi * n / 96, {}
    for i = 1, 3 do
      p[i] = math.cos(half) * a[i] + math.sin(half) * (math.cos(phi) * b[i] + math.sin(phi) * c[i])
    end
    list[n + 1] = p
  end
  return list, b, c
end

-- The two lines from the tip at which the eye's rays touch the cone, as phases of the rim, where its normal is across
-- the eye: cos(phi) b.eye + sin(phi) c.eye = tan(half) a.eye; none if the eye looks inside.
local function silhouette(a, b, c, half, eye)
  local u, v, w = space.dot(b, eye), space.dot(c, eye), math.tan(half) * space.dot(a, eye)
  local size = math.sqrt(u * u + v * v)
  if size <= math.abs(w) then return {} end
  local middle, to = math.atan(v, u), math.acos(w / size)
  return { middle + to, middle - to }
end

local function cone(d, a, half, camera, map, class)
  local list, b, c = rim(a, half)
  local flat = {}
  for i, p in ipairs(list) do flat[i] = map(p) end
  local tip, lines = map { 0.0, 0.0, 0.0 }, {}
  local phases = silhouette(a, b, c, half, camera.eye)
  for n, phi in ipairs(phases) do
    local p = {}
    for i = 1, 3 do
      p[i] = math.cos(half) * a[i] + math.sin(half) * (math.cos(phi) * b[i] + math.sin(phi) * c[i])
    end
    lines[n] = map(p)
  end
  if #lines == 2 then d:polygon({ lines[1], tip, lines[2] }, "area " .. class) end
  d:polygon(flat, "area " .. class)
  d:path(curve.path(flat), "line " .. class)
  for _, p in ipairs(lines) do d:line(tip[1], tip[2], p[1], p[2], "line " .. class) end
end

local function arrow(d, map, v, length, name, class)
  local p, q = map { 0.0, 0.0, 0.0 }, map { length * v[1], length * v[2], length * v[3] }
  d:arrow(p[1], p[2], q[1], q[2], class, 7)
  d:math(q[1] + 6, q[2] - 4, name, "math")
end

function cones.draw(d, box, c)
  local turn = upright(c)
  local axis, L, w = turn(c.axis), turn(c.L), turn(c.w)
  local camera = space.camera(-62, 16)
  local reach, low, high = { { 0.0, 0.0, 0.0 } }, { math.huge, math.huge }, { -math.huge, -math.huge }
  for _, one in ipairs { { axis, c.body }, { L, c.space } } do
    for _, p in ipairs((rim(one[1], one[2]))) do reach[#reach + 1] = p end
    reach[#reach + 1] = { 1.2 * one[1][1], 1.2 * one[1][2], 1.2 * one[1][3] }
  end
  reach[#reach + 1] = { 1.34 * w[1], 1.34 * w[2], 1.34 * w[3] }
  for _, p in ipairs(reach) do
    for k, v in ipairs { space.dot(camera.right, p), space.dot(camera.up, p) } do
      low[k], high[k] = math.min(low[k], v), math.max(high[k], v)
    end
  end
  local scale = math.min((box.x1 - box.x0 - 40) / (high[1] - low[1]), (box.y1 - box.y0 - 24) / (high[2] - low[2]))
  local map = space.projection(camera, scale, (box.x0 + box.x1) / 2 - scale * (low[1] + high[1]) / 2,
    (box.y0 + box.y1) / 2 + scale * (low[2] + high[2]) / 2)
  cone(d, L, c.space, camera, map, "cz")
  cone(d, axis, c.body, camera, map, "cx")
  arrow(d, map, L, 1.16, "L", "axis")
  arrow(d, map, axis, 1.1, "axis", "axis")
  arrow(d, map, w, 1.26, "ω", "curve")
end

return cones
