-- numeric_body.lua -- a body's tree of shapes as plain numbers, for the general library.
--
-- The tree keeps its form: shapes with their arguments, placements, sums and holes.  Numbers are evaluated exactly and
-- rounded once, to doubles; what a double cannot hold of a position goes on as a second, small shift, and shapes given
-- by points are told relative to their first point.  So a body far from the origin is the same body for the library as
-- it is here, to the last digit of its own size, and the comparison of both is about formulas and not about reading.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local body = require "generator.mass.body"
local slips = require "generator.mass.slips"
local validity = require "generator.mass.validity"

-- N is one reading: exact(e) -> rational, num(e) -> double, nums(list).
local function reading(exact)
  local function num(e) return R.todouble(exact(e)) end
  return { exact = exact, num = num, nums = function(v) return vec.map(v, num) end }
end

-- An argument of a shape: an expression, a word or flag, or a list of such.
local function plain(N, v)
  if expr.is(v) then return N.num(v) end
  return type(v) == "table" and vec.map(v, function(x) return plain(N, x) end) or v
end

-- t moved by r, which need not be a double: what is left of it is a second, small shift.  own: the scene moves it;
-- other shifts are marked `extra`, as the scene's tree has no such node.
local function shifted(N, t, r, own)
  local high, low, whole = N.nums(r), {}, true
  for i, e in ipairs(r) do
    low[i] = R.todouble(N.exact(e) - R.fromdouble(high[i]))
    whole = whole and low[i] == 0
  end
  local moved = { op = "at", of = t, r = high, extra = not own }
  return whole and moved or { op = "at", of = moved, r = low, extra = true }
end

-- Coordinates are rounded relative to the first point, so that a far body keeps its small distances.  Returns the
-- arguments and that point, or nil for shapes that are not given by points.
local function relative(a)
  local key = a.vertices and "vertices" or a.points and "points" or a.profile and a.h and "profile"
  if a.from then
    return { from = vec.sub(a.from, a.from), to = vec.sub(a.to, a.from) }, a.from
  elseif not key then
    return a, nil
  end
  local base, out = a[key][1], {}
  local function local_rows(rows) return vec.map(rows, function(r) return vec.sub(r, base) end) end
  for k, v in pairs(a) do out[k] = v end -- order does not matter: a table of named arguments
  out[key] = local_rows(a[key])
  if a.holes then out.holes = vec.map(a.holes, local_rows) end
  return out, { base[1], base[2], base[3] or expr.zero }
end

-- The terms of a polynomial in the coordinates: {coefficient, i, j, k}.
local function terms(N, p, factor)
  return vec.map(p, function(t) return { N.num(factor * t.c), t[1], t[2], t[3] } end)
end

-- ---- shapes ----
--
-- growth: of volumes, areas and lengths under the scalings around a shape, by which a density is multiplied: the
-- library's scaling keeps the mass.

local function region(N, node, growth)
  local limits = {}
  for n, l in ipairs(node.a.limits) do limits[n] = { terms(N, l[1], expr.one), terms(N, l[2], expr.one) } end
  return { shape = "region", order = node.a.order, limits = limits, mass = node.mass and N.num(node.mass),
    density = not node.mass and terms(N, node.a.density, growth.volume) or nil }
end

-- Places relative to the first one.
local function points(N, node)
  local rows, first = {}, node.rows[1]
  local base = { first[2], first[3], first[4] }
  for i, row in ipairs(node.rows) do
    rows[i] = { N.num(row[1]), table.unpack(N.nums(vec.sub({ row[2], row[3], row[4] }, base))) }
  end
  return shifted(N, { shape = "points", list = rows }, base)
end

local function mesh(N, node, growth)
  local a, k = node.a, node.unit or expr.one
  return shifted(N, { shape = "mesh", mass = N.num(node.mass or node.density * growth[node.measure] * a.measure),
    com = { 0.0, 0.0, 0.0 }, sigma = N.nums(a.sigma), measure = node.measure, faces = node.faces, unit = N.num(k),
    at = N.nums(vec.map(a.com, function(c) return c / k end)) }, a.com)
end

-- A tensor that no body has was taken as it is: the library is told so, about the centre of mass.
local function formal(N, a)
  local I = vec.map({ a.xx, a.yy, a.zz, a.xy, a.xz, a.yz }, N.exact)
  if a.about == "origin" then I = vec.sub(I, slips.steiner(N.exact(a.mass), vec.map(a.com, N.exact))) end
  if validity.lawful(I) then return nil end
  local out = { shape = "tensor", formal = true, mass = N.num(a.mass), com = N.nums(a.com) }
  for i, name in ipairs(vec.entry) do out[name] = R.todouble(I[i]) end
  return out
end

-- The node of the library's tree, with a shift where the shape is told relative to its first point.
local function shape(N, node, growth)
  if node.shape == "points" then return points(N, node) end
  if node.shape == "mesh" then return mesh(N, node, growth) end
  if node.shape == "region" then return region(N, node, growth) end
  local unlawful = node.shape == "tensor" and node.name ~= "inertial" and formal(N, node.a)
  if unlawful then return unlawful end
  local out = { shape = node.shape, mass = node.mass and N.num(node.mass),
    density = node.density and N.num(node.density * growth[node.measure]) }
  local a, base = relative(node.a)
  for k, v in pairs(a) do -- order does not matter: a table of named numbers
    out[k] = plain(N, v)
  end
  return base and shifted(N, out, base) or out
end

-- ---- placements, sums and holes ----

local operations = {}

local function tree(N, node, growth)
  if node.shape then return shape(N, node, growth) end
  local operation = operations[node.op] or error("unknown node in a shape tree: " .. tostring(node.op))
  return operation(N, node, growth)
end

function operations.at(N, node, growth) return shifted(N, tree(N, node.of, growth), node.r, true) end

function operations.turned(N, node, growth)
  return { op = "turned", of = tree(N, node.of, growth), q = N.nums(node.q) }
end

-- What is below weighs its density times the growth of all scalings above it.
function operations.scaled(N, node, growth)
  local inner = {}
  for _, measure in ipairs { "volume", "area", "length" } do
    inner[measure] = growth[measure] * body.growth(node.k, measure)
  end
  return { op = "scaled", of = tree(N, node.of, inner), k = N.nums(node.k) }
end

function operations.sheared(N, node, growth)
  local A, list = node.A, {}
  local inner = { volume = growth.volume * body.determinant(A), area = growth.area, length = growth.length }
  for i = 1, 3 do
    for j = 1, 3 do list[#list + 1] = N.num(A[i][j]) end
  end
  return { op = "affine", of = tree(N, node.of, inner), A = list }
end

function operations.sum(N, node, growth)
  return { op = "sum", tree(N, node[1], growth), tree(N, node[2], growth) }
end

function operations.minus(N, node, growth)
  return { op = "minus", tree(N, node[1], growth), tree(N, node[2], growth), line = node.line }
end

-- The tree of a record's body, its origin of rotation moved to that of the coordinates; exact: expression -> rational.
return function(root, origin, exact)
  local N = reading(exact)
  local whole = tree(N, root, { volume = expr.one, area = expr.one, length = expr.one })
  return shifted(N, whole, vec.map(origin, function(e) return -e end))
end
