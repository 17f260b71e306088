-- surface.lua -- the boundary of a shape as polygons, for pictures, samples and boxes.
--
-- Plain numbers, no algebra: it takes shapes in the form dynamics/numeric_body.lua gives, and it shares nothing with
-- the catalogue of mass properties, so integrals over these surfaces are an independent check of that catalogue.
--
--     surface.of(node, n)     {faces =, lines =, points =, creases =} of one shape; n: segments of a full turn
--     surface.tree(tree, n)   the same of a tree of placements, sums and holes
--     surface.samples(tree)   points on the surface;  surface.box(tree)   lowest and highest corner
--
-- A face is a list of points, counter-clockwise seen from outside.  The faces of a solid close it: every edge is shared
-- by two faces that walk it in opposite directions.  Those of shells and plates need not.  The vertices lie on the
-- true surface; so do all points of faces that are marked `flat`.  A hole's faces are turned inside out.  creases:
-- lines along which a smooth-looking surface has an edge.
-- SPDX-License-Identifier: GPL-3.0-or-later

local turned = require "generator.geometry.turned"
local flat = require "generator.geometry.flat"
local curved = require "generator.geometry.curved"

local surface = {}

local family = {}
for _, part in ipairs { turned, flat, curved } do
  for name, f in pairs(part.family) do family[name] = f end -- order does not matter: a table is filled
end

local default = 48

-- Names of the shapes that have a surface, sorted.
function surface.names()
  local list = {}
  for name in pairs(family) do list[#list + 1] = name end -- order does not matter: sorted
  table.sort(list)
  return list
end

-- options: turn = {from, angle}: cut open, in turns (shapes of revolution); fine: longest straight piece.
function surface.of(node, n, options)
  local f = family[node.shape] or error("no surface for the shape " .. tostring(node.shape), 2)
  n = math.max(8, (n or default) + (-(n or default)) % 8) -- the quarters of a turn are among the points
  local out = { faces = {}, lines = {}, points = {}, creases = {} }
  f(out, node, n, options or {})
  return out
end

-- ---- placement ----

-- Every point through move, each once; flip: faces inside out.
-- Points that faces share stay shared.
local function moved(s, move, flip)
  local seen, out = {}, { faces = {}, lines = {}, points = {}, creases = {} }
  local function image(p)
    if not seen[p] then seen[p] = move(p) end
    return seen[p]
  end
  for i, face in ipairs(s.faces) do
    local f = { flat = face.flat, cut = face.cut, part = face.part }
    for k, p in ipairs(face) do f[flip and #face + 1 - k or k] = image(p) end
    out.faces[i] = f
  end
  for _, kind in ipairs { "lines", "creases" } do
    for i, line in ipairs(s[kind]) do
      local l = {}
      for k, p in ipairs(line) do l[k] = image(p) end
      out[kind][i] = l
    end
  end
  for i, p in ipairs(s.points) do out.points[i] = image(p) end
  return out
end

-- A is nine numbers, row by row.
local function linear(A)
  return function(p)
    return { A[1] * p[1] + A[2] * p[2] + A[3] * p[3], A[4] * p[1] + A[5] * p[2] + A[6] * p[3],
      A[7] * p[1] + A[8] * p[2] + A[9] * p[3] }
  end
end

local function determinant(A)
  return A[1] * (A[5] * A[9] - A[6] * A[8]) - A[2] * (A[4] * A[9] - A[6] * A[7]) + A[3] * (A[4] * A[8] - A[5] * A[7])
end

-- The rotation v -> q v q* of a quaternion, scalar first, row by row; q need not have length one.
local function rotation(q)
  local w, x, y, z = q[1], q[2], q[3], q[4]
  local s = 2 / (w * w + x * x + y * y + z * z)
  return { 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),
    s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x),
    s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y) }
end

local function identity(p) return p end

-- The map a node applies to its `of`, and whether it turns faces inside out.
local function motion(node)
  if node.op == "at" then
    local r = node.r
    return function(p) return { p[1] + r[1], p[2] + r[2], p[3] + r[3] } end, false
  end
  local A = node.A
  if node.op == "turned" then
    A = rotation(node.q)
  elseif node.op == "scaled" then
    A = { node.k[1], 0, 0, 0, node.k[2], 0, 0, 0, node.k[3] }
  end
  if not A then error("unknown node in a shape tree: " .. tostring(node.op)) end
  return linear(A), determinant(A) < 0
end

-- A hole's faces look into it.
function surface.tree(node, n)
  if node.shape then
    return surface.of(node, n)
  elseif node.op == "sum" or node.op == "minus" then
    local a, b = surface.tree(node[1], n), surface.tree(node[2], n)
    if node.op == "minus" then b = moved(b, identity, true) end
    for _, kind in ipairs { "faces", "lines", "points", "creases" } do
      for _, item in ipairs(b[kind]) do table.insert(a[kind], item) end
    end
    return a
  end
  local move, flip = motion(node)
  return moved(surface.tree(node.of, n), move, flip)
end

-- ---- boxes and samples ----

local function each_point(s, visit)
  for _, list in ipairs { s.faces, s.lines, { s.points } } do
    for _, item in ipairs(list) do
      for _, p in ipairs(item) do visit(p) end
    end
  end
end

local function bounds(s)
  local lo, hi = { math.huge, math.huge, math.huge }, { -math.huge, -math.huge, -math.huge }
  each_point(s, function(p)
    for d = 1, 3 do lo[d], hi[d] = math.min(lo[d], p[d]), math.max(hi[d], p[d]) end
  end)
  return lo, hi
end

-- The box around the vertices: exact for plane faces and for round ones in their own frame, else too small by less than
-- the sagitta of a segment.
function surface.box(tree, n) return bounds(surface.tree(tree, n)) end

local function distance(p, q) return math.sqrt((p[1] - q[1]) ^ 2 + (p[2] - q[2]) ^ 2 + (p[3] - q[3]) ^ 2) end

-- Points of a triangle's lattice, its corners left out.
-- The corners are there already.
local function lattice(list, a, b, c, step)
  local longest = math.max(distance(a, b), distance(b, c), distance(c, a))
  local k = math.max(2, math.ceil(longest / step))
  for i = 0, k do
    for j = 0, k - i do
      if i < k and j < k and i + j > 0 then
        local p = {}
        for d = 1, 3 do p[d] = a[d] + (b[d] - a[d]) * i / k + (c[d] - a[d]) * j / k end
        list[#list + 1] = p
      end
    end
  end
end

-- Points on the surface (and on wires, and the particles), about size/n apart: vertices, and lattices on plane faces.
-- All lie on the true surface but for rounding.
function surface.samples(tree, n)
  n = n or 24
  local function collect(node) -- each shape at the fineness of its own size
    if node.shape then
      local lo, hi = bounds(surface.of(node, 8))
      local size = math.max(hi[1] - lo[1], hi[2] - lo[2], hi[3] - lo[3])
      local step = size > 0 and size / n or math.huge
      local s, seen, list = surface.of(node, n, { fine = step }), {}, {}
      each_point(s, function(p)
        local key = string.format("%.17g %.17g %.17g", p[1], p[2], p[3])
        if not seen[key] then
          seen[key] = true
          list[#list + 1] = p
        end
      end)
      for _, f in ipairs(s.faces) do
        for i = 2, f.flat and #f - 1 or 0 do lattice(list, f[1], f[i], f[i + 1], step) end
      end
      return list
    elseif node.op == "sum" or node.op == "minus" then
      local list = collect(node[1])
      for _, p in ipairs(collect(node[2])) do list[#list + 1] = p end
      return list
    end
    local move, list = motion(node), collect(node.of)
    for i, p in ipairs(list) do list[i] = move(p) end
    return list
  end
  return collect(tree)
end

return surface
