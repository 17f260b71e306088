-- space.lua -- figures in space seen from far away: a camera, and what of a curve lies on the near side.
-- SPDX-License-Identifier: GPL-3.0-or-later

local curve = require "generator.plot.curve"

local space = {}

function space.dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

function space.cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

function space.length(v) return math.sqrt(space.dot(v, v)) end

function space.unit(v)
  local l = space.length(v)
  return { v[1] / l, v[2] / l, v[3] / l }
end

-- Two unit vectors across v, with which it makes a right-handed frame.
function space.across(v)
  local k = space.unit(v)
  local least = 1
  for i = 2, 3 do
    if math.abs(k[i]) < math.abs(k[least]) then least = i end
  end
  local e = { 0.0, 0.0, 0.0 }
  e[least] = 1.0
  local a = space.unit(space.cross(e, k))
  return a, space.cross(k, a)
end

-- Directions of the eye in degrees: azimuth from x towards y, height over z = 0.  eye: towards the viewer.
function space.camera(azimuth, height)
  local a, h = math.rad(azimuth), math.rad(height)
  local ca, sa, ch, sh = math.cos(a), math.sin(a), math.cos(h), math.sin(h)
  return { eye = { ch * ca, ch * sa, sh }, right = { -sa, ca, 0.0 }, up = { -sh * ca, -sh * sa, ch } }
end

-- How a camera puts points on paper: `centre` of space at (x, y), `scale` pixels to the unit.
function space.projection(camera, scale, x, y, centre)
  centre = centre or { 0.0, 0.0, 0.0 }
  return function(p)
    local v = { p[1] - centre[1], p[2] - centre[2], p[3] - centre[3] }
    return { x + scale * space.dot(camera.right, v), y - scale * space.dot(camera.up, v) }
  end
end

-- A curve in pieces that are in front or behind: value(p) is positive in front.  Pieces end where it is 0, on the
-- chord.  Each piece: {points..., front = bool}.
function space.pieces(points, value)
  local list, here, before = {}, nil, nil
  for i, p in ipairs(points) do
    local v = value(p)
    local front = v >= 0
    if here and front ~= here.front then
      local q, s = points[i - 1], before / (before - v)
      local cut = {}
      for n = 1, 3 do cut[n] = q[n] + s * (p[n] - q[n]) end
      here[#here + 1] = cut
      here = { cut, front = front }
      list[#list + 1] = here
    end
    if not here then
      here = { front = front }
      list[1] = here
    end
    here[#here + 1] = p
    before = v
  end
  return list
end

-- Draws a curve of space, what is behind thinner: with the class and " far".
function space.draw(d, points, map, value, class)
  for _, far in ipairs { true, false } do
    local data = {}
    for _, piece in ipairs(space.pieces(points, value)) do
      if #piece > 1 and piece.front ~= far then
        local flat = {}
        for i, p in ipairs(piece) do flat[i] = map(p) end
        data[#data + 1] = curve.path(flat)
      end
    end
    if #data > 0 then d:path(table.concat(data), class .. (far and " far" or "")) end
  end
end

-- An arrow on paper from p to q with its name beyond the head; `taken`: where names are already, which it avoids.
function space.arrow(d, p, q, name, class, taken)
  local far = math.max(1e-9, math.sqrt((q[1] - p[1]) ^ 2 + (q[2] - p[2]) ^ 2))
  local ux, uy = (q[1] - p[1]) / far, (q[2] - p[2]) / far
  d:arrow(p[1], p[2], q[1], q[2], class, 6)
  local x, y = q[1] + 10 * ux, q[2] + 12 * uy + 4
  for _, other in ipairs(taken) do
    if math.abs(other[1] - x) < 30 and math.abs(other[2] - y) < 15 then y = other[2] - 15 end
  end
  taken[#taken + 1] = { x, y }
  d:math(x, y, name, "math", ux > 0.3 and "start" or ux < -0.3 and "end" or "middle")
end

return space
