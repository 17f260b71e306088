-- convex.lua -- convex solids twice: what their hull is the sum of, and what bounds them; as expressions.
--
-- For holes whose place is a condition on parameters (within.lua).  A set is {c, e, v, disc, r}: all points
--     c + sum of s_i e_i, |s_i| <= 1 + a point of the ellipsoid with half axes v + a point of the ball of radius r
-- so a cylinder is a point, a segment and a disc.  An affine map sends it to one again; while it is a similarity, a
-- ball stays one and a disc keeps its unit normal and radius, disc = {m, rho}, which say the same as its two half axes.
-- The hull of a solid is that of a few sets.
-- A bound is what a point p of the solid must fulfil, in the solid's own frame:
--     {n =, d =}     n.p <= d               {ball =, at =}    |p - at| <= ball
--     {round =, s =}  the distance from the z axis <= round + s z
-- size: a length (n's unit) that is nothing small in the solid.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local cost = require "generator.algebra.cost"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local body = require "generator.mass.body"

local convex = {}

local zero, one, two = expr.zero, expr.one, expr.lift(2)
local origin = { zero, zero, zero }
local function tidy(e) return (ratio.tidy(e)) end
local function tidy_all(v) return vec.map(v, tidy) end
local function unit(i, x)
  local v = { zero, zero, zero }
  v[i] = x
  return v
end

-- ---- sets ----

local function set(c, e, v) return { c = c or origin, e = e or {}, v = v or {} } end
local function disc(c, rho, e)
  local s = set(c, e, { unit(1, rho), unit(2, rho) })
  s.disc = { m = unit(3, one), rho = rho }
  return s
end
local function ball(rho, e)
  local s = set(nil, e)
  s.r = rho
  return s
end
local function axial(z) return unit(3, z) end
local function points(list, e)
  return vec.map(list, function(p) return set({ p[1], p[2], p[3] or zero }, e and { e }) end)
end
-- between z = 0 and h, over the corners
local function prism(list, h)
  return points(vec.map(list, function(p) return { p[1], p[2], h / 2 } end), axial(h / 2))
end

-- The sets whose hull is that of the shape with the arguments a, in its own frame.
local hull = {
  ["solid.box"] = function(a) return { set(nil, { unit(1, a.x / 2), unit(2, a.y / 2), unit(3, a.z / 2) }) } end,
  ["solid.sphere"] = function(a) return { ball(a.r) } end,
  ["solid.hollow_sphere"] = function(a) return { ball(a.r_out) } end,
  ["solid.ellipsoid"] = function(a) return { set(nil, nil, { unit(1, a.a), unit(2, a.b), unit(3, a.c) }) } end,
  ["solid.cylinder"] = function(a) return { disc(nil, a.r, { axial(a.h / 2) }) } end,
  ["solid.tube"] = function(a) return { disc(nil, a.r_out, { axial(a.h / 2) }) } end,
  ["solid.elliptic_cylinder"] = function(a)
    return { set(nil, { axial(a.h / 2) }, { unit(1, a.a), unit(2, a.b) }) }
  end,
  ["solid.cone"] = function(a) return { disc(nil, a.r), set(axial(a.h)) } end,
  ["solid.frustum"] = function(a) return { disc(nil, a.r_base), disc(axial(a.h), a.r_top) } end,
  ["solid.elliptic_cone"] = function(a)
    return { set(nil, nil, { unit(1, a.a), unit(2, a.b) }), set(axial(a.h)) }
  end,
  ["solid.capsule"] = function(a) return { ball(a.r, { axial(a.h / 2) }) } end,
  ["solid.pyramid"] = function(a)
    return { set(nil, { unit(1, a.x / 2), unit(2, a.y / 2) }), set(axial(a.h)) }
  end,
  ["solid.wedge"] = function(a) return prism({ { zero, zero }, { a.x, zero }, { zero, a.y } }, a.z) end,
  ["solid.prism"] = function(a) return prism(a.profile, a.h) end,
  ["solid.tetrahedron"] = function(a) return points(a.vertices) end,
  ["solid.parallelepiped"] = function(a)
    local half = vec.map(a.edges, function(v) return vec.scale(one / 2, v) end)
    return { set(vec.add(vec.add(half[1], half[2]), half[3]), half) }
  end,
}
hull.extrude = hull["solid.prism"]

-- ---- bounds ----

local function plane(n, d, size) return { n = n, d = d, size = size } end
local function least(i, x, size) return plane(unit(i, -one), -x, size) end
local function most(i, x, size) return plane(unit(i, one), x, size) end
local function slab(i, width) return least(i, -width / 2, width), most(i, width / 2, width) end
local function round(r, s, size) return { round = r, s = s or zero, size = size or r } end

local function all(...) return { ... } end

-- The bounds of the shape; also what its points are scaled by before these are asked.
local bounds = {
  ["solid.box"] = function(a)
    local list = {}
    for i, x in ipairs { a.x, a.y, a.z } do list[2 * i - 1], list[2 * i] = slab(i, x) end
    return list
  end,
  ["solid.sphere"] = function(a) return { { ball = a.r, at = origin } } end,
  ["solid.ellipsoid"] = function(a) return { { ball = one, at = origin } }, { one / a.a, one / a.b, one / a.c } end,
  ["solid.cylinder"] = function(a) return all(round(a.r), slab(3, a.h)) end,
  ["solid.elliptic_cylinder"] = function(a)
    return all(round(one), slab(3, a.h)), { one / a.a, one / a.b, one }
  end,
  ["solid.half_cylinder"] = function(a) return all(round(a.r), least(1, zero, a.r), slab(3, a.h)) end,
  ["solid.quarter_cylinder"] = function(a)
    return all(round(a.r), least(1, zero, a.r), least(2, zero, a.r), slab(3, a.h))
  end,
  ["solid.cone"] = function(a) return all(round(a.r, -a.r / a.h), least(3, zero, a.h)) end,
  ["solid.frustum"] = function(a)
    return all(round(a.r_base, (a.r_top - a.r_base) / a.h, a.r_base + a.r_top), least(3, zero, a.h), most(3, a.h, a.h))
  end,
  ["solid.hemisphere"] = function(a) return all({ ball = a.r, at = origin }, least(3, zero, a.r)) end,
  ["solid.cap"] = function(a) return all({ ball = a.r, at = axial(a.h - a.r) }, least(3, zero, a.h)) end,
  ["solid.zone"] = function(a)
    local width = a.z2 - a.z1
    return all({ ball = a.r, at = origin }, least(3, a.z1, width), most(3, a.z2, width))
  end,
  ["solid.pyramid"] = function(a)
    local list = { least(3, zero, a.h) }
    for i, x in ipairs { a.x, a.y } do
      for _, s in ipairs { -one, one } do
        local n = unit(i, s)
        n[3] = x / (2 * a.h)
        list[#list + 1] = plane(n, x / 2, x)
      end
    end
    return list
  end,
  ["solid.wedge"] = function(a)
    return all(least(1, zero, a.x), least(2, zero, a.y), plane({ a.y, a.x, zero }, a.x * a.y, a.x * a.y),
      least(3, zero, a.z), most(3, a.z, a.z))
  end,
}
bounds["solid.tube"] = function(a) return bounds["solid.cylinder"] { r = a.r_out, h = a.h } end
bounds["solid.hollow_sphere"] = function(a) return bounds["solid.sphere"] { r = a.r_out } end

-- What is hollow in the shape: nodes of shapes in its frame.
local hollow = {
  ["solid.tube"] = function(a) return { shape = "solid.cylinder", a = { r = a.r_in, h = a.h } } end,
  ["solid.hollow_sphere"] = function(a) return { shape = "solid.sphere", a = { r = a.r_in } } end,
}

-- The three answers for a node of a shape, nil where there is none.
function convex.hull(node)
  local f = hull[node.shape]
  return f and not (node.a.holes and node.a.holes[1]) and f(node.a) or nil
end
function convex.bounds(node)
  local f = bounds[node.shape]
  if f then return f(node.a) end
end
function convex.hollow(node)
  local f = hollow[node.shape]
  return f and f(node.a)
end

-- Is the hull all of the solid?
function convex.full(node) return not hollow[node.shape] end

-- ---- maps ----

-- A, rows, of a set; k: the factor of a similarity, nil if it is none.  nil where the image is no such set.
local function image(s, A, k)
  local function move(x) return tidy_all(vec.matvec(A, x)) end
  local out = { c = move(s.c), e = vec.map(s.e, move), v = vec.map(s.v, move) }
  if k then
    out.disc = s.disc and { m = vec.scale(one / k, move(s.disc.m)), rho = k * s.disc.rho }
    out.r = s.r and k * s.r
  elseif s.r then
    if s.v[1] then return nil end
    for i = 1, 3 do out.v[i] = move(unit(i, s.r)) end
  end
  return out
end

local function diagonal(k) return { unit(1, k[1]), unit(2, k[2]), unit(3, k[3]) } end

-- The factor of a scaling that is a similarity.
local function similar(k)
  local v = vec.map(k, function(x) return expr.call("abs", x) end)
  return v[1] == v[2] and v[2] == v[3] and v[1] or nil
end

local function shifted(s, r)
  local out = {}
  for name, x in pairs(s) do out[name] = x end -- order does not matter: a copy
  out.c = tidy_all(vec.add(s.c, r))
  return out
end

local function inverse(A)
  local columns = { vec.cross(A[2], A[3]), vec.cross(A[3], A[1]), vec.cross(A[1], A[2]) }
  local det = vec.dot(A[1], columns[1])
  return vec.map(vec.transpose(columns), function(row) return vec.scale(one / det, row) end)
end

-- The set scaled by the three factors.
function convex.scaled(s, k) return image(s, diagonal(k), similar(k)) end

-- The set after the placement of the node, or before it.
function convex.placed(s, node, back)
  if node.op == "at" then return shifted(s, back and vec.scale(-one, node.r) or node.r) end
  if node.op == "turned" then
    local A = body.turn(node)
    return image(s, back and vec.transpose(A) or A, one)
  elseif node.op == "scaled" then
    return convex.scaled(s, back and vec.map(node.k, function(x) return one / x end) or node.k)
  end
  return image(s, back and inverse(node.A) or node.A, nil)
end

-- ---- margins: how far inside a bound a set is, >= 0 where it is ----

local function square(v) return tidy(vec.dot(v, v)) end

-- What the disc or the ellipsoid of s reaches in the direction n, times |n|.
-- Of several forms the simplest: it cancels least (r |cos a|, not r sqrt(1 - sin(a)^2)).
local function across(s, n)
  local sum, d = zero, s.disc
  for _, v in ipairs(s.v) do sum = sum + vec.dot(n, v) ^ 2 end
  local best = sum
  for _, e in ipairs { tidy(sum), d and d.rho ^ 2 * tidy(vec.dot(n, n) - vec.dot(n, d.m) ^ 2) } do
    if cost { e } < cost { best } then best = e end
  end
  return expr.sqrt(best)
end

local function in_plane(b, s)
  local reach = vec.dot(b.n, s.c) + across(s, b.n)
  for _, e in ipairs(s.e) do reach = reach + expr.call("abs", tidy(vec.dot(b.n, e))) end
  if s.r then reach = reach + s.r * expr.sqrt(vec.dot(b.n, b.n)) end
  return { { b.d - reach, b.size } }
end

-- The centres of s: c +- e.
local function corners(c, list)
  local out = { c }
  for _, e in ipairs(list) do
    local next_out = {}
    for _, p in ipairs(out) do
      next_out[#next_out + 1] = vec.add(p, e)
      next_out[#next_out + 1] = vec.sub(p, e)
    end
    out = next_out
  end
  return out
end

-- Of a point at the distance sqrt(far) with a ball of radius r, in a ball of radius R.
local function in_radius(R, far, r)
  if not r then return { R ^ 2 - far, two * R ^ 2 } end
  return { R - r - expr.sqrt(far), R }
end

-- The farthest point of a disc about c is |c|^2 + rho^2 + 2 rho |c's part in its plane| away.
local function in_ball(b, s)
  local list, d = {}, s.disc
  if s.v[1] and not d then return nil end
  for i, c in ipairs(corners(vec.sub(s.c, b.at), s.e)) do
    local far = square(c)
    if d then far = far + d.rho ^ 2 + 2 * across(s, c) end
    list[i] = in_radius(b.ball, far, s.r)
  end
  return list
end

-- Seen along z a disc is a disc, or a segment where its normal is level; the segment is right for a cylinder, the disc
-- for a cone, too.
local function in_round(b, s)
  local list, e, flat, d = {}, { table.unpack(s.e) }, zero, s.disc
  if d and d.m[1] == zero and d.m[2] == zero then
    flat = d.rho
  elseif d and d.m[3] == zero and b.s == zero then
    e[#e + 1] = { -d.rho * d.m[2], d.rho * d.m[1], zero }
  elseif s.v[1] then
    return nil
  end
  for i, c in ipairs(corners(s.c, e)) do
    local reach, far = flat, square { c[1], c[2], zero }
    if s.r then reach = reach + s.r * expr.sqrt(one + b.s ^ 2) end
    if b.s == zero then
      list[i] = in_radius(b.round, far, reach ~= zero and reach or nil)
    else
      list[i] = { b.round + b.s * c[3] - reach - expr.sqrt(far), b.size }
    end
  end
  return list
end

-- How far inside the bound the set is: a list of {margin, size}, all of which must be >= 0; nil: not known.
function convex.inside(b, s) return (b.n and in_plane or b.ball and in_ball or in_round)(b, s) end

-- ---- apart ----

-- A set as a figure in the plane z = 0 that is carried along z: {z = half its height, rho = of a disc | x, y = half
-- sides}; nil if it is none.  A ball has rho and no z.
local function upright(s)
  local f, d = { z = zero, x = zero, y = zero }, s.disc
  if s.r then return not (s.e[1] or s.v[1]) and { ball = s.r } or nil end
  if s.v[1] and not (d and d.m[1] == zero and d.m[2] == zero) then return nil end
  for _, e in ipairs(s.e) do
    local along
    for i, name in ipairs { "x", "y", "z" } do
      if e[i] ~= zero then
        if along then return nil end
        along = name
        f[name] = f[name] + expr.call("abs", e[i])
      end
    end
  end
  if d and (f.x ~= zero or f.y ~= zero) then return nil end
  f.rho = d and d.rho
  return f
end

local function max(a, b) return expr.call("max", a, b) end
local function beyond(list) -- how far away, of components >= 0 or none
  local sum = zero
  for _, x in ipairs(list) do sum = sum + max(x, zero) ^ 2 end
  return expr.sqrt(sum)
end

-- The gap between two sets, >= 0 where they have no inner point in common, and a size; nil: not known.  Both are
-- balls, or upright cylinders and boxes, or one of each.
function convex.gap(s, t)
  local f, g = upright(s), upright(t)
  if not f or not g then return nil end
  if g.ball and not f.ball then f, g = g, f end
  local c = tidy_all(vec.sub(s.c, t.c))
  if g.ball then return expr.sqrt(square(c)) - f.ball - g.ball, f.ball + g.ball end
  local function abs(i) return expr.call("abs", c[i]) end
  local rho = expr.sqrt(square { c[1], c[2], zero })
  if f.ball then
    local sides = g.rho and { rho - g.rho } or { abs(1) - g.x, abs(2) - g.y }
    return beyond { abs(3) - g.z, table.unpack(sides) } - f.ball, f.ball + g.z
  end
  local level
  if f.rho and g.rho then
    level = rho - f.rho - g.rho
  elseif f.rho or g.rho then
    local box = f.rho and g or f
    level = beyond { abs(1) - box.x, abs(2) - box.y } - (f.rho or g.rho)
  else
    level = max(abs(1) - f.x - g.x, abs(2) - f.y - g.y)
  end
  return level, (f.rho or f.x + f.y) + (g.rho or g.x + g.y), abs(3) - f.z - g.z
end

return convex
