-- flat.lua -- shapes with plane faces: boxes, polyhedra, prisms, plates with straight edges.
--
-- A face is a list of points, counter-clockwise from outside; `flat` says that points between them lie on the surface.
-- Nothing is approximated here: integrals over these faces are those of the shape but for rounding.
-- SPDX-License-Identifier: GPL-3.0-or-later

local polygon = require "generator.geometry.polygon"

local flat = { family = {} }

local function put(out, face)
  face.flat = true
  out.faces[#out.faces + 1] = face
end

local function sub(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

-- The six faces of the parallelepiped at `corner` with edges e1, e2, e3.
-- Left-handed edges change places, or the faces would look inwards.
local function block(out, corner, e1, e2, e3)
  if dot(cross(e1, e2), e3) < 0 then e1, e2 = e2, e1 end
  local function at(i, j, k)
    local p = {}
    for d = 1, 3 do p[d] = corner[d] + i * e1[d] + j * e2[d] + k * e3[d] end
    return p
  end
  put(out, { at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0) })
  put(out, { at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1) })
  put(out, { at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1) })
  put(out, { at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0) })
  put(out, { at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0) })
  put(out, { at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1) })
end

local function box(out, a)
  block(out, { -a.x / 2, -a.y / 2, -a.z / 2 }, { a.x, 0, 0 }, { 0, a.y, 0 }, { 0, 0, a.z })
end
flat.family["solid.box"], flat.family["shell.box"] = box, box
flat.family["solid.parallelepiped"] = function(out, a) block(out, { 0, 0, 0 }, a.edges[1], a.edges[2], a.edges[3]) end

flat.family["solid.pyramid"] = function(out, a)
  local x, y, apex = a.x / 2, a.y / 2, { 0, 0, a.h }
  local base = { { x, -y, 0 }, { x, y, 0 }, { -x, y, 0 }, { -x, -y, 0 } }
  put(out, { base[4], base[3], base[2], base[1] })
  for i = 1, 4 do put(out, { base[i], base[i % 4 + 1], apex }) end
end

flat.family["solid.tetrahedron"] = function(out, a)
  local v = a.vertices
  local p, q, r, s = v[1], v[2], v[3], v[4]
  if dot(cross(sub(q, p), sub(r, p)), sub(s, p)) < 0 then q, r = r, q end
  put(out, { p, r, q })
  put(out, { p, q, s })
  put(out, { q, r, s })
  put(out, { r, p, s })
end

-- The prism over a polygon with holes, from z = 0 to h.
-- Holes are walked clockwise, so their walls look into them.
local function prism(out, outer, holes, h)
  local function lifted(p, z) return { p[1], p[2], z } end
  for _, t in ipairs(polygon.triangles(outer, holes)) do
    put(out, { lifted(t[1], 0), lifted(t[3], 0), lifted(t[2], 0) })
    put(out, { lifted(t[1], h), lifted(t[2], h), lifted(t[3], h) })
  end
  local loops = { polygon.oriented(outer) }
  for i, p in ipairs(holes or {}) do loops[i + 1] = polygon.oriented(p, true) end
  for _, p in ipairs(loops) do
    for i = 1, #p do
      local u, v = p[i], p[i % #p + 1]
      put(out, { lifted(u, 0), lifted(v, 0), lifted(v, h), lifted(u, h) })
    end
  end
end
flat.family["solid.prism"] = function(out, a) prism(out, a.profile, a.holes, a.h) end
flat.family.extrude = flat.family["solid.prism"]
flat.family["solid.wedge"] = function(out, a) prism(out, { { 0, 0 }, { a.x, 0 }, { 0, a.y } }, nil, a.z) end

-- ---- regular polyhedra ----

local phi = (1 + math.sqrt(5)) / 2

-- (a, b, c) and its cyclic shifts, with every sign of what is not zero.
-- (0, 1, phi): four signs, three shifts, 12 vertices.  A zero has one sign, and three equal entries one shift.
local function family_of(a, b, c)
  local list = {}
  for shift = 0, 2 do
    for signs = 0, 7 do
      local v, fresh = { a, b, c }, true
      for i = 1, 3 do
        if signs >> (i - 1) & 1 == 1 then
          fresh = fresh and v[i] ~= 0
          v[i] = -v[i]
        end
      end
      if fresh then list[#list + 1] = { v[1 + shift], v[1 + (1 + shift) % 3], v[1 + (2 + shift) % 3] } end
    end
    if a == b and b == c then break end
  end
  return list
end

local function with(list, more)
  for _, v in ipairs(more) do list[#list + 1] = v end
  return list
end

local tetrahedron = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } }
local dual = { { -1, -1, -1 }, { -1, 1, 1 }, { 1, -1, 1 }, { 1, 1, -1 } }
local cube, octahedron, icosahedron = family_of(1, 1, 1), family_of(1, 0, 0), family_of(0, 1, phi)
local dodecahedron = with(family_of(1, 1, 1), family_of(0, 1 / phi, phi))
-- faces -> vertices, directions of the faces (the vertices of the dual), what makes the edge 1
local regular = {
  [4] = { tetrahedron, dual, 1 / math.sqrt(8) },
  [6] = { cube, octahedron, 1 / 2 },
  [8] = { octahedron, cube, 1 / math.sqrt(2) },
  [12] = { dodecahedron, family_of(0, phi, 1), phi / 2 }, -- the duals have the other handedness of the two families
  [20] = { icosahedron, with(family_of(1, 1, 1), family_of(0, phi, 1 / phi)), 1 / 2 },
}

flat.family["solid.regular"] = function(out, a)
  local r = regular[a.faces] or error("a regular polyhedron has 4, 6, 8, 12 or 20 faces", 0)
  for _, d in ipairs(r[2]) do
    -- a face has the vertices that are farthest in its direction; the next ones are more than 0.1 behind
    local top, face = -math.huge, {}
    for _, v in ipairs(r[1]) do top = math.max(top, dot(v, d)) end
    for _, v in ipairs(r[1]) do
      if dot(v, d) > top - 0.1 then face[#face + 1] = v end
    end
    -- around the direction d, counter-clockwise
    local e1 = cross(d, math.abs(d[1]) < math.abs(d[3]) and { 1, 0, 0 } or { 0, 0, 1 })
    local e2 = cross(d, e1)
    local size = math.sqrt(dot(d, d))
    local function angle(v) return math.atan(dot(v, e2) / size, dot(v, e1)) end
    table.sort(face, function(u, v) return angle(u) < angle(v) end)
    local k = a.edge * r[3]
    for i, v in ipairs(face) do face[i] = { k * v[1], k * v[2], k * v[3] } end
    put(out, face)
  end
end

-- ---- plates ----

flat.family["plate.rectangle"] = function(out, a)
  local x, y = a.x / 2, a.y / 2
  put(out, { { -x, -y, 0 }, { x, -y, 0 }, { x, y, 0 }, { -x, y, 0 } })
end
flat.family["plate.triangle"] = function(out, a) put(out, { a.vertices[1], a.vertices[2], a.vertices[3] }) end
flat.family["plate.polygon"] = function(out, a)
  for _, t in ipairs(polygon.triangles(a.profile, a.holes)) do
    put(out, { { t[1][1], t[1][2], 0 }, { t[2][1], t[2][2], 0 }, { t[3][1], t[3][2], 0 } })
  end
end

return flat
