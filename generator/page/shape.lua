-- shape.lua -- a body as triangles and lines whose corners are linear in the scene's parameters.
--
--     shape.of(tree_of, params) -> {faces =, holes =, lines =, points =, fixed = bool}
-- tree_of(steps): the body's tree (geometry/surface.lua) with each parameter moved by that many of its steps; params:
-- list of {step = (size of one)}.  Each member is {at = numbers, by = {[parameter] = numbers}}: x, y, z of every corner
-- and their derivatives.  Where the corners are not linear in the parameters, to 1e-9 of the body's size, the shape is
-- `fixed`: it stays that of the scene's own parameters, and the page says so.
-- A hole is a surface of its own.  A body without any surface (a tensor, a mesh of which the moments alone are kept)
-- has none here either; the page draws the ellipsoid of equal moments.
-- SPDX-License-Identifier: GPL-3.0-or-later

local surface = require "generator.geometry.surface"

local shape = {}

local turn = 40 -- segments of a full turn
local slack = 1e-9
local kinds = { "faces", "holes", "lines", "points" }

-- Calls put(tree, hole) for each part that is one shape where it stands.
local function parts(node, put, hole, placed)
  if node.shape then return put(placed(node), hole) end
  if node.op == "sum" or node.op == "minus" then
    parts(node[1], put, hole, placed)
    return parts(node[2], put, hole ~= (node.op == "minus"), placed)
  end
  return parts(node.of, put, hole, function(inner)
    local copy = {}
    for k, v in pairs(node) do copy[k] = v end -- any order
    copy.of = inner
    return placed(copy)
  end)
end

local function put_point(list, p)
  for d = 1, 3 do list[#list + 1] = p[d] end
end

-- A face that is not a triangle is a fan about its first corner: faces are convex.
local function put_face(list, face)
  for k = 2, #face - 1 do
    for _, p in ipairs { face[1], face[k], face[k + 1] } do put_point(list, p) end
  end
end

local function put_line(list, line)
  for k = 1, #line - 1 do
    put_point(list, line[k])
    put_point(list, line[k + 1])
  end
end

local bare = { mesh = true, tensor = true, region = true }

-- All corners of a tree, by kind.
local function corners(tree)
  local out = { faces = {}, holes = {}, lines = {}, points = {} }
  parts(tree, function(part, hole)
    local leaf = part
    while leaf.of do leaf = leaf.of end
    if leaf.shape == "points" then
      for _, row in ipairs(leaf.list) do
        local spot = { table.unpack(row, 2, 4) }
        local at = { shape = "tensor", com = spot }
        local function placed(node)
          if node == leaf then return at end
          local copy = {}
          for k, v in pairs(node) do copy[k] = v end -- any order
          copy.of = placed(node.of)
          return copy
        end
        for _, p in ipairs(surface.tree(placed(part), turn).points) do put_point(out.points, p) end
      end
      return
    end
    if bare[leaf.shape] then return end
    local s = surface.tree(part, turn)
    for _, face in ipairs(s.faces) do put_face(hole and out.holes or out.faces, face) end
    for _, line in ipairs(s.lines) do put_line(out.lines, line) end
  end, false, function(node) return node end)
  return out
end

local function size_of(c)
  local most = 0.0
  for _, kind in ipairs(kinds) do
    for _, x in ipairs(c[kind]) do most = math.max(most, math.abs(x)) end
  end
  return most
end

-- Is b the point that lies as far beyond the middle as a lies before it, within the slack?
local function straight(a, middle, b, limit)
  for _, kind in ipairs(kinds) do
    if #a[kind] ~= #middle[kind] or #b[kind] ~= #middle[kind] then return false end
    for i, x in ipairs(middle[kind]) do
      if math.abs(a[kind][i] - 2 * x + b[kind][i]) > limit then return false end
    end
  end
  return true
end

-- Derivatives by one parameter, from one step each way: nil where a member does not move.
local function derivative(out, p, a, b, step, limit)
  for _, kind in ipairs(kinds) do
    local list, moves = {}, false
    for i, x in ipairs(b[kind]) do
      list[i] = (x - a[kind][i]) / (2 * step)
      moves = moves or math.abs(x - a[kind][i]) > limit
    end
    if moves then table.insert(out[kind].by, { parameter = p - 1, rate = list }) end
  end
end

-- Are the corners with all parameters moved at once those that the derivatives foretell?
local function foretold(out, params, all, limit)
  for _, kind in ipairs(kinds) do
    if #all[kind] ~= #out[kind].at then return false end
    for i, x in ipairs(out[kind].at) do
      for _, d in ipairs(out[kind].by) do x = x + d.rate[i] * params[d.parameter + 1].step end
      if math.abs(x - all[kind][i]) > limit then return false end
    end
  end
  return true
end

function shape.of(tree_of, params)
  local middle = corners(tree_of {})
  local out, limit, together = { fixed = false }, slack * size_of(middle), {}
  for _, kind in ipairs(kinds) do out[kind] = { at = middle[kind], by = {} } end
  for p, param in ipairs(params) do
    local a, b = corners(tree_of { [p] = -1 }), corners(tree_of { [p] = 1 })
    out.fixed = out.fixed or not straight(a, middle, b, limit)
    if not out.fixed then derivative(out, p, a, b, param.step, limit) end
    together[p] = 1
  end
  out.fixed = out.fixed or not foretold(out, params, corners(tree_of(together)), limit)
  if out.fixed then
    for _, kind in ipairs(kinds) do out[kind].by = {} end
  end
  return out
end

return shape
