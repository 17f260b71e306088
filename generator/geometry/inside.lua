-- inside.lua -- is a point inside a shape, and if not, how far outside?
--
-- Plain numbers, no algebra: trees in the form dynamics/numeric_body.lua gives.  Solids by their exact definition, thin
-- things within `slack` of them; a sum holds what either part holds, a difference what is in the body and not strictly
-- inside the hole.  Placements are undone on the point.  A mesh asks its faces, which the host keeps.  Of a tensor
-- nothing is known: the answer is nil unless the rest of the tree decides.  Shares nothing with surface.lua, so each
-- checks the other.
--     inside.excess(tree, p)            negative inside, 0 on the border, positive outside; nil: cannot say
--     inside.contains(tree, p, slack)   true, false or nil
--     inside.distance(tree, p, step)    the excess as a distance: divided by its slope
-- SPDX-License-Identifier: GPL-3.0-or-later

local planar = require "generator.geometry.planar"
local solids = require "generator.geometry.solids"
local thin = require "generator.geometry.thin"

local inside = {}

local max, min, abs = math.max, math.min, math.abs

local function cross(u, v)
  return { u[2] * v[3] - u[3] * v[2], u[3] * v[1] - u[1] * v[3], u[1] * v[2] - u[2] * v[1] }
end

-- q* p q, for q of any length but 0.
-- p + 2 w v x p + 2 v x (v x p) for the unit quaternion (w, v), here that of q*.
local function turned_back(q, p)
  local s = planar.length(planar.length(q[1], q[2]), q[3], q[4])
  local w, v = q[1] / s, { -q[2] / s, -q[3] / s, -q[4] / s }
  local t = cross(v, p)
  t = { 2 * t[1], 2 * t[2], 2 * t[3] }
  local u = cross(v, t)
  return { p[1] + w * t[1] + u[1], p[2] + w * t[2] + u[2], p[3] + w * t[3] + u[3] }
end

-- A^-1 p by Cramer's rule, rows of A in turn.
local function solved(A, p)
  local r1, r2, r3 = { A[1], A[2], A[3] }, { A[4], A[5], A[6] }, { A[7], A[8], A[9] }
  local c1, c2, c3 = cross(r2, r3), cross(r3, r1), cross(r1, r2)
  local det = r1[1] * c1[1] + r1[2] * c1[2] + r1[3] * c1[3]
  local x = {}
  for i = 1, 3 do x[i] = (c1[i] * p[1] + c2[i] * p[2] + c3[i] * p[3]) / det end
  return x
end

-- p before the map of a placement, and how much an excess measured there is worth here: at most the largest factor of
-- the map, for an excess must never be made too small beside a slack (distance() corrects the number for people).
function inside.back(node, p)
  if node.op == "at" then
    return { p[1] - node.r[1], p[2] - node.r[2], p[3] - node.r[3] }, 1
  elseif node.op == "turned" then
    return turned_back(node.q, p), 1
  elseif node.op == "scaled" then
    local k = node.k
    return { p[1] / k[1], p[2] / k[2], p[3] / k[3] }, max(abs(k[1]), abs(k[2]), abs(k[3]))
  elseif node.op == "affine" then
    local largest = 0.0
    for i = 1, 9 do largest = max(largest, abs(node.A[i])) end
    return solved(node.A, p), 3 * largest -- bounds the stretch by rows
  end
  error("unknown node in a shape tree: " .. tostring(node.op))
end

-- Of a mesh: the distance from its faces (of wires, from its edges), negative inside of a volume.
-- Coordinates here are from the mesh's centre; `at` is the centre in the file's unit, `unit` this unit.
local function mesh(p, node)
  if not node.faces then return nil end
  local u, at = node.unit, node.at
  return u * node.faces:excess(p[1] / u + at[1], p[2] / u + at[2], p[3] / u + at[3])
end

-- Of a sum with an unknown part only "inside" can be said; of a difference "outside" by the body alone, or by the hole.
function inside.excess(node, p)
  if node.shape then
    local f = node.shape == "mesh" and mesh or solids[node.shape] or thin[node.shape]
    return f and f(p, node)
  elseif node.of then
    local q, k = inside.back(node, p)
    local e = inside.excess(node.of, q)
    return e and e * k
  end
  local a, b = inside.excess(node[1], p), inside.excess(node[2], p)
  if node.op == "sum" then
    if a and b then return min(a, b) end
    local known = a or b
    return known and known <= 0 and known or nil
  elseif node.op == "minus" then
    if a and b then return max(a, -b) end
    return a and a > 0 and a or b and b < 0 and -b or nil
  end
  error("unknown node in a shape tree: " .. tostring(node.op))
end

function inside.contains(node, p, slack)
  local e = inside.excess(node, p)
  if e == nil then return nil end
  return e <= (slack or 0)
end

-- The distance from p, which is outside, to the shape, to first order: excess over slope, the slope by differences of
-- the width `step`; the excess itself where it has no slope.
function inside.distance(node, p, step)
  local e, slope = inside.excess(node, p), {}
  for i = 1, 3 do
    local q, r = { p[1], p[2], p[3] }, { p[1], p[2], p[3] }
    q[i], r[i] = p[i] + step, p[i] - step
    local up, down = inside.excess(node, q), inside.excess(node, r)
    slope[i] = up and down and (up - down) / (q[i] - r[i]) or 0
  end
  local s = planar.length(slope[1], slope[2], slope[3])
  return e and s > 0 and s < math.huge and e / s or e
end

-- "volume", "area", "length" or "particles" for the kind of thing a shape is; nil where that is not known.
function inside.kind(node)
  if node.shape == "mesh" then return node.faces and node.measure end
  local family = string.match(node.shape, "^(%a+)%.") or node.shape
  local kinds = { solid = "volume", extrude = "volume", revolve = "volume", region = "volume", shell = "area",
    plate = "area", rod = "length", wire = "length", points = "particles" }
  return kinds[family]
end

return inside
