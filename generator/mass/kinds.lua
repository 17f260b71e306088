-- kinds.lua -- what kinds of things (volume, area, length, particles) are in a tree of shapes in plain numbers.
--
-- For holes.lua and overlaps.lua, which compare like with like.  SPDX-License-Identifier: GPL-3.0-or-later

local inside = (require "generator.later") "generator.geometry.inside"

local kinds = { list = { "volume", "area", "length", "particles" } }

-- The kinds that occur in a tree; kind "unknown" for what has no geometry here.
-- A set.
function kinds.of(node, set)
  set = set or {}
  if node.shape then
    set[inside.kind(node) or "unknown"] = true
  elseif node.of then
    kinds.of(node.of, set)
  else
    kinds.of(node[1], set)
    if node.op == "sum" then kinds.of(node[2], set) end -- what is cut out adds no kind
  end
  return set
end

-- The part of a tree that is of one kind (or unknown), nil if there is none.
function kinds.part(node, kind)
  if node.shape then
    local k = inside.kind(node)
    return (k == kind or k == nil) and node or nil
  elseif node.of then
    local of = kinds.part(node.of, kind)
    return of and setmetatable({ of = of }, { __index = node })
  end
  local a, b = kinds.part(node[1], kind), kinds.part(node[2], kind)
  if a and b then return setmetatable({ a, b }, { __index = node }) end
  return a or node.op == "sum" and b or nil
end

local function meshes(node)
  if node.shape then return node.shape == "mesh" end
  if node.of then return meshes(node.of) end
  return meshes(node[1]) or meshes(node[2])
end

-- What is nothing beside `size`, with coordinates up to `reach`: see holes.lua.
function kinds.slack(size, reach, a, b)
  if meshes(a) or meshes(b) then return 1e-6 * size + 2.0 ^ -22 * reach end
  return 1e-9 * size + 64 * 2.0 ^ -52 * reach
end

return kinds
