-- numeric.lua -- a scene as plain numbers, for the general library.
--
-- The library gets the SHAPES and the effects, not our tensor: it computes mass properties and motion by its own
-- formulas, which is what makes it a second road.  Parameters take given values (their defaults, or random ones).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local vec = require "generator.algebra.vec"
local body = require "generator.mass.body"

local numeric = {}

-- job: driver.read's result; values: {name -> rational} for all parameters (nil: defaults).
-- Returns {name, body, origin, effects, q, w} as the host's engine takes it.
function numeric.scene(job, values)
  local m, record = job.model, job.record
  local env = {}
  for _, p in ipairs(record.params) do env[p.name] = values and values[p.name] or p.default end
  local function exact(e) return evaluate.precise(e, env, 240) end
  local function num(e) return R.todouble(exact(e)) end
  local function nums(v) return vec.map(v, num) end

  -- an argument of a shape: an expression, a word or flag, or a list of such
  local function plain(v)
    if expr.is(v) then return num(v) end
    return type(v) == "table" and vec.map(v, plain) or v
  end

  -- the terms of a polynomial in the coordinates: {coefficient, i, j, k}
  local function terms(p, factor)
    return vec.map(p, function(t) return { num(factor * t.c), t[1], t[2], t[3] } end)
  end

  local function region(node, growth)
    local limits = {}
    for n, l in ipairs(node.a.limits) do limits[n] = { terms(l[1], expr.one), terms(l[2], expr.one) } end
    return { shape = "region", order = node.a.order, limits = limits, mass = node.mass and num(node.mass),
      density = not node.mass and terms(node.a.density, growth.volume) or nil }
  end

  -- density is multiplied by the growth of its shape under the scalings around it: the library's scaling keeps mass
  local function tree(node, growth)
    if node.shape == "points" then
      local rows = {}
      for i, row in ipairs(node.rows) do rows[i] = nums(row) end
      return { shape = "points", list = rows }
    elseif node.shape == "mesh" then
      local a = node.a
      return { shape = "mesh", mass = num(node.mass or node.density * growth[node.measure] * a.measure),
        com = nums(a.com), sigma = nums(a.sigma) }
    elseif node.shape == "region" then
      return region(node, growth)
    elseif node.shape then
      local out = { shape = node.shape, mass = node.mass and num(node.mass),
        density = node.density and num(node.density * growth[node.measure]) }
      for k, v in pairs(node.a) do -- order does not matter: a table of named numbers
        out[k] = plain(v)
      end
      return out
    elseif node.op == "at" then
      local r, rest, exact_shift = nums(node.r), {}, true
      for i, e in ipairs(node.r) do -- a shift is no double: what is left of it is a second, small one
        rest[i] = R.todouble(exact(e) - R.fromdouble(r[i]))
        exact_shift = exact_shift and rest[i] == 0
      end
      local moved = { op = "at", of = tree(node.of, growth), r = r }
      return exact_shift and moved or { op = "at", of = moved, r = rest }
    elseif node.op == "turned" then
      return { op = "turned", of = tree(node.of, growth), q = nums(node.q) }
    elseif node.op == "scaled" then
      local inner = {}
      for _, measure in ipairs { "volume", "area", "length" } do
        inner[measure] = growth[measure] * body.growth(node.k, measure)
      end
      return { op = "scaled", of = tree(node.of, inner), k = nums(node.k) }
    elseif node.op == "sheared" then
      local A = node.A
      local inner = { volume = growth.volume * body.determinant(A), area = growth.area, length = growth.length }
      return { op = "affine", of = tree(node.of, inner),
        A = { num(A[1][1]), num(A[1][2]), num(A[1][3]), num(A[2][1]), num(A[2][2]), num(A[2][3]), num(A[3][1]),
          num(A[3][2]), num(A[3][3]) } }
    elseif node.op == "sum" then
      return { op = "sum", tree(node[1], growth), tree(node[2], growth) }
    elseif node.op == "minus" then
      return { op = "minus", tree(node[1], growth), tree(node[2], growth), line = node.line }
    end
    error("unknown node in a shape tree: " .. tostring(node.op))
  end

  local effects = {}
  for i, e in ipairs(record.effects) do effects[i] = e.spec.numeric(e.a, num) end
  local body_tree = tree(record.body, { volume = expr.one, area = expr.one, length = expr.one })
  return { name = m.name, body = body_tree, origin = nums(m.origin), effects = effects,
    q = nums(record.attitude), w = nums(record.omega) }
end

return numeric
