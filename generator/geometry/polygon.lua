-- polygon.lua -- simple polygons in the plane: signed area, one orientation, triangles (ear clipping, holes bridged).
--
-- A polygon is {{x, y}, ...}, simple, of either orientation, the last point not repeated.
-- O'Rourke, Computational Geometry in C (2nd ed.), section 1.6 (ears); holes are joined to the outer loop by a bridge
-- from their rightmost vertex to a vertex that it sees (Eberly, "Triangulation by Ear Clipping", section 3).
-- SPDX-License-Identifier: GPL-3.0-or-later

local polygon = {}

-- Twice the signed area of the triangle abc: positive when it turns left.
local function cross(a, b, c) return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]) end

-- Signed area, positive counter-clockwise; differences to one vertex, so a far polygon loses nothing.
function polygon.area(p)
  local s = 0.0
  for i = 2, #p - 1 do s = s + cross(p[1], p[i], p[i + 1]) end
  return s / 2
end

-- p counter-clockwise (or clockwise); p itself is not changed.
function polygon.oriented(p, clockwise)
  local out, flip = {}, (polygon.area(p) < 0) ~= (clockwise or false)
  for i = 1, #p do out[i] = flip and p[#p + 1 - i] or p[i] end
  return out
end

local function same(a, b) return a[1] == b[1] and a[2] == b[2] end

-- Is q in the closed triangle abc (counter-clockwise)?
local function inside(q, a, b, c) return cross(a, b, q) >= 0 and cross(b, c, q) >= 0 and cross(c, a, q) >= 0 end

-- Do the open segments pq and ab cross?
local function crossing(p, q, a, b)
  local d1, d2, d3, d4 = cross(p, q, a), cross(p, q, b), cross(a, b, p), cross(a, b, q)
  return (d1 > 0) ~= (d2 > 0) and (d3 > 0) ~= (d4 > 0) and d1 ~= 0 and d2 ~= 0 and d3 ~= 0 and d4 ~= 0
end

-- Does p see q: no edge of the loops between them, no vertex on the way?
local function sees(p, q, loops)
  local function between(v)
    if same(v, p) or same(v, q) or cross(p, q, v) ~= 0 then return false end
    local t = (v[1] - p[1]) * (q[1] - p[1]) + (v[2] - p[2]) * (q[2] - p[2])
    return t > 0 and t < (q[1] - p[1]) ^ 2 + (q[2] - p[2]) ^ 2
  end
  for _, loop in ipairs(loops) do
    for i = 1, #loop do
      if between(loop[i]) or crossing(p, q, loop[i], loop[i % #loop + 1]) then return false end
    end
  end
  return true
end

-- Is the direction to q inside the corner of `loop` at i (counter-clockwise loop)?
local function into(loop, i, q)
  local a, b, c = loop[(i - 2) % #loop + 1], loop[i], loop[i % #loop + 1]
  if cross(a, b, c) >= 0 then return cross(a, b, q) > 0 and cross(b, c, q) > 0 end
  return not (cross(c, b, q) >= 0 and cross(b, a, q) >= 0)
end

-- One loop of the outer polygon and its holes, joined by bridges that are walked twice.
-- nil where no vertex sees a hole: the holes are not inside.
local function joined(outer, holes)
  local loop, rest = polygon.oriented(outer), {}
  for i, h in ipairs(holes or {}) do
    local hole, first = polygon.oriented(h, true), 1
    for k = 2, #hole do if hole[k][1] > hole[first][1] then first = k end end
    rest[i] = { hole, first }
  end
  table.sort(rest, function(a, b) -- rightmost first: nothing of the others is in the way
    local p, q = a[1][a[2]], b[1][b[2]]
    return p[1] > q[1] or p[1] == q[1] and p[2] > q[2]
  end)
  for k, r in ipairs(rest) do
    local hole, first = r[1], r[2]
    local p, loops, best, nearest = hole[first], { loop }, nil, math.huge
    for j = k, #rest do loops[#loops + 1] = rest[j][1] end
    for i = 1, #loop do
      local d = (loop[i][1] - p[1]) ^ 2 + (loop[i][2] - p[2]) ^ 2
      if d < nearest and into(loop, i, p) and sees(p, loop[i], loops) then best, nearest = i, d end
    end
    if not best then return nil end
    local out = {}
    for i = 1, best do out[#out + 1] = loop[i] end
    for j = 0, #hole do out[#out + 1] = hole[(first + j - 1) % #hole + 1] end
    for i = best, #loop do out[#out + 1] = loop[i] end
    loop = out
  end
  return loop
end

-- Triangles {{a, b, c}, ...} of points, counter-clockwise, of the polygon without its holes.  What no ear can be found
-- for (a polygon that is not simple) is cut as it comes, so there is always an answer.
function polygon.triangles(outer, holes)
  local loop, list = joined(outer, holes) or polygon.oriented(outer), {}
  local left = {}
  for i, p in ipairs(loop) do left[i] = p end
  -- no other vertex in the closed triangle; strict: it is no straight line either
  local function ear(i, strict)
    local n = #left
    local a, b, c = left[(i - 2) % n + 1], left[i], left[i % n + 1]
    local turn = cross(a, b, c)
    if turn < 0 or strict and turn == 0 then return false end
    for k = 1, n do
      local q = left[k]
      if not (same(q, a) or same(q, b) or same(q, c)) and inside(q, a, b, c) then return false end
    end
    return true
  end
  while #left > 3 do
    local n, cut = #left, nil
    for i = 1, n do if ear(i, true) then cut = i break end end
    for i = 1, cut and 0 or n do if ear(i, false) then cut = i break end end
    cut = cut or 1
    local a, b, c = left[(cut - 2) % n + 1], left[cut], left[cut % n + 1]
    if cross(a, b, c) ~= 0 then list[#list + 1] = { a, b, c } end
    table.remove(left, cut)
  end
  if #left == 3 and cross(left[1], left[2], left[3]) ~= 0 then list[#list + 1] = left end
  return list
end

return polygon
