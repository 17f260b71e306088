-- cones.lua -- the cones of a free symmetric top: the body's, about its axis, rolls on the one in space, about L.
--
-- w is where they touch.  Their half angles follow from the angles that w has with the axis and with L.  Colours are
-- those of the page that `polhode view` makes (templates/page/space.js): space cx, body cy, axis cz.
-- SPDX-License-Identifier: GPL-3.0-or-later

local curve = require "generator.plot.curve"
local space = require "generator.plot.space"

local cones = {}

-- The half angles {body, space}; axis: the unit vector, turned to the side of L; inside: does the space cone lie within
-- the body's, as that of an oblate body does?  w and L along body axes, k the axis of symmetry.
function cones.of(w, L, k)
  local axis = space.unit(k)
  if space.dot(axis, L) < 0 then axis = { -axis[1], -axis[2], -axis[3] } end
  local function angle(a, b) return math.atan(space.length(space.cross(a, b)), space.dot(a, b)) end
  return { body = angle(axis, w), space = angle(L, w), axis = axis, inside = angle(axis, L) < angle(axis, w) }
end

local turns = 96 -- points of a rim
local wide = math.rad(80) -- what narrow cones are opened to, at most

-- A point of the rim of a cone about a with its half angle, slant height 1, at a phase in the frame b, c across a.
local function on_rim(a, b, c, half, phi)
  local p = {}
  for i = 1, 3 do p[i] = math.cos(half) * a[i] + math.sin(half) * (math.cos(phi) * b[i] + math.sin(phi) * c[i]) end
  return p
end

local function arc(a, half, from, to)
  local b, c = space.across(a)
  local list = {}
  for n = 0, turns do list[n + 1] = on_rim(a, b, c, half, from + (to - from) * n / turns) end
  return list
end

local function rim(a, half) return arc(a, half, 0, 2 * math.pi) end

-- The phases between which the eye sees the outside of the cone, where the normal is towards it: cos(phi) b.eye +
-- sin(phi) c.eye >= tan(half) a.eye; nil if it looks inside alone.
local function outside(a, half, eye)
  local b, c = space.across(a)
  local u, v, w = space.dot(b, eye), space.dot(c, eye), math.tan(half) * space.dot(a, eye)
  local size = math.sqrt(u * u + v * v)
  if size <= math.abs(w) then return nil end
  local middle, to = math.atan(v, u), math.acos(w / size)
  return middle - to, middle + to
end

local function mapped(points, map)
  local flat = {}
  for i, p in ipairs(points) do flat[i] = map(p) end
  return flat
end

-- The mantle as far as its outside is seen, and through the mouth the inside, which is darker.
local function cone(d, a, half, camera, map, class)
  local mouth, tip = mapped(rim(a, half), map), map { 0.0, 0.0, 0.0 }
  if space.dot(a, camera.eye) > 0 then
    d:polygon(mouth, "area " .. class)
    d:polygon(mouth, "area " .. class)
  end
  local from, to = outside(a, half, camera.eye)
  if from then
    local edge = mapped(arc(a, half, from, to), map)
    edge[#edge + 1] = tip
    d:polygon(edge, "area " .. class)
    d:path({ edge[1], tip, edge[#edge - 1] }, "line " .. class)
  end
  d:path(curve.path(mouth), "line " .. class)
end

-- How many times the angles are as large in the picture: a whole number of one digit that leaves all of it within
-- `wide`, where the cones are narrow.  Opened alike they still touch in w, for their axes and w lie in one plane.
function cones.opened(c)
  local most = math.floor(wide / (2 * math.max(c.body, c.space, c.inside and 0 or c.body + c.space)))
  if most < 2 then return 1 end
  local power = math.tointeger(10 ^ math.floor(math.log(most, 10) + 1e-9))
  return most // power * power
end

-- The axis, L and w in one plane, L upwards and the axis to its right, with these angles from L.
local function set_up(c, times)
  local function at(angle) return { math.sin(angle), 0.0, math.cos(angle) } end
  local axis = times * (c.inside and c.body - c.space or c.body + c.space)
  return at(axis), at(times * (c.inside and -c.space or c.space))
end

function cones.draw(d, box, c)
  local times = cones.opened(c)
  local L, axis, w = { 0.0, 0.0, 1.0 }, set_up(c, times)
  local body, outer = times * c.body, times * c.space
  local camera = space.camera(-62, 16)
  local reach, low, high = { { 0.0, 0.0, 0.0 } }, { math.huge, math.huge }, { -math.huge, -math.huge }
  for _, one in ipairs { { axis, body, 1.1 }, { L, outer, 1.2 } } do
    for _, p in ipairs(rim(one[1], one[2])) do reach[#reach + 1] = p end
    reach[#reach + 1] = { one[3] * one[1][1], one[3] * one[1][2], one[3] * one[1][3] }
  end
  reach[#reach + 1] = { 1.3 * w[1], 1.3 * w[2], 1.3 * w[3] }
  for _, p in ipairs(reach) do
    for k, v in ipairs { space.dot(camera.right, p), space.dot(camera.up, p) } do
      low[k], high[k] = math.min(low[k], v), math.max(high[k], v)
    end
  end
  local scale = math.min((box.x1 - box.x0 - 90) / (high[1] - low[1]), (box.y1 - box.y0 - 44) / (high[2] - low[2]))
  local map = space.projection(camera, scale, (box.x0 + box.x1) / 2 - scale * (low[1] + high[1]) / 2,
    (box.y0 + box.y1) / 2 + scale * (low[2] + high[2]) / 2)
  cone(d, L, outer, camera, map, "cx")
  cone(d, axis, body, camera, map, "cy")
  local tip, taken = map { 0.0, 0.0, 0.0 }, {}
  for _, one in ipairs { { L, 1.2, "L", "axis" }, { axis, 1.1, "axis", "line cz" }, { w, 1.3, "ω", "line ce" } } do
    local v, length = one[1], one[2]
    space.arrow(d, tip, map { length * v[1], length * v[2], length * v[3] }, one[3], one[4], taken)
  end
end

return cones
