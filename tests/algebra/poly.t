#!/usr/bin/env lua5.4
-- poly.t: polynomials over generators: arithmetic against exact values, relations, division.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local poly = require "generator.algebra.poly"
local evaluate = require "generator.algebra.evaluate"
local text = require "generator.formula.text"
local roots = require "generator.algebra.roots"
local recipe = require "tests.algebra.recipe"

local x, y = expr.sym "x", expr.sym "y"
local call, sqrt = expr.call, expr.sqrt

local function gens(...)
  local list = {}
  for i, g in ipairs(poly.ring({ ... }).gens) do list[i] = text.of(g) end
  return table.concat(list, " ")
end

-- The polynomial of e in its own ring, and back.
local function normal(e) return poly.expr(poly.from(poly.ring { e }, e)) end

-- ---- rings ----

tap.is(gens(x * y + y ^ 3), "x y", "the generators of a polynomial are its symbols")
tap.is(gens(call("cos", x)), "cos(x) sin(x)", "cos brings sin with it")
tap.is(gens(sqrt(x) + expr.pow(x, "1/3")), "x x^(1/6)", "roots of one base have one generator, the common root")
tap.is(gens(sqrt(2) * x), "sqrt(2) x", "the root of a number is a generator")
tap.is(gens(1 / (x + y)), "x y", "a denominator is walked too")

-- ---- relations ----

local function reduces(e, want, name) tap.ok(normal(e) == want, name, text.of(normal(e))) end
local s, c = call("sin", x), call("cos", x)
reduces(c ^ 2 + s ^ 2, expr.one, "cos^2 + sin^2 ==> 1")
reduces(c ^ 3, c - c * s ^ 2, "cos^3 ==> cos - cos sin^2")
reduces((1 + c) * (1 - c), s ^ 2, "(1 + cos)(1 - cos) ==> sin^2")
reduces((1 + sqrt(x)) * (1 - sqrt(x)), 1 - x, "(1 + sqrt x)(1 - sqrt x) ==> 1 - x")
reduces((1 + sqrt(2)) ^ 2, 3 + 2 * sqrt(2), "(1 + sqrt 2)^2 ==> 3 + 2 sqrt 2")
reduces((x + call("abs", y)) * (x - call("abs", y)), x ^ 2 - y ^ 2, "(x + |y|)(x - |y|) ==> x^2 - y^2")
do
  local root = sqrt(1 + sqrt(x)) -- nested: its square has the other root, whose square is x
  reduces((root + 1) * (root - 1), sqrt(x), "nested roots: (sqrt(1 + sqrt x) + 1)(... - 1) ==> sqrt x")
  reduces(root ^ 4 - 2 * sqrt(x) - 1, x, "nested roots: (1 + sqrt x)^2 ==> 1 + 2 sqrt x + x")
end
tap.ok(poly.from(poly.ring { x, 1 / y }, 1 / y) == nil, "1/y is no polynomial")
tap.ok(poly.from(poly.ring { x }, y) == nil, "a symbol that is no generator has no polynomial in the ring")

-- ---- arithmetic ----

do
  recipe.seed(31)
  local wrong = {}
  local names = {}
  for i, n in ipairs(recipe.names) do names[i] = expr.sym(n) end
  local ring = poly.ring(names)
  for n = 1, 60 do
    local e, f = recipe.build(recipe.random(5, { whole = true })), recipe.build(recipe.random(4, { whole = true }))
    local p, q = poly.from(ring, e), poly.from(ring, f)
    local at = recipe.point()
    local function value(polynomial) return evaluate.exact(poly.expr(polynomial), at) end
    local a, b = evaluate.exact(e, at), evaluate.exact(f, at)
    local function check(got, want, what)
      if got ~= want then wrong[#wrong + 1] = what .. " " .. n .. ": " .. text.of(e) .. " and " .. text.of(f) end
    end
    check(value(p), a, "conversion")
    check(value(poly.add(p, q)), a + b, "sum")
    check(value(poly.sub(p, q)), a - b, "difference")
    check(value(poly.mul(p, q)), a * b, "product")
    check(value(poly.power(q, 3)), b ^ 3, "power")
    check(value(poly.scale(p, R.new(-3, 7))), a * R.new(-3, 7), "multiple")
    check(poly.iszero(poly.sub(p, p)), true, "p - p")
    check(poly.expr(poly.mul(p, q)) == poly.expr(poly.mul(q, p)), true, "order of factors")
    if not poly.iszero(q) then
      local quotient = poly.divide(poly.mul(p, q), q)
      check(quotient and value(quotient), a, "division of a product")
      local one = poly.constant(ring, R.one)
      local more = poly.divide(poly.add(poly.mul(p, q), one), q)
      local constant = #poly.sorted(q) == 1 and f.kind == "num"
      check(constant or more == nil or poly.iszero(poly.sub(q, poly.constant(ring, b))), true, "division with a rest")
      local content, low = poly.content(q)
      local primitive = poly.shift(q, content, low)
      local unit = poly.content(primitive)
      check(unit, R.one, "content of the primitive part")
    end
  end
  tap.is(table.concat(wrong, "\n"), "",
    "60 pairs: sums, products, powers, division and content agree with exact values")
end

do
  local ring = poly.ring { x, y }
  local p = poly.from(ring, 6 * x ^ 2 * y - 4 * x * y ^ 3)
  local content, low = poly.content(p)
  tap.ok(content == R.new(2) and low[1] == 1 and low[2] == 1, "6 x^2 y - 4 x y^3 has content 2 and the monomial x y")
  tap.ok(poly.divide(poly.from(ring, x ^ 2 - y ^ 2), poly.from(ring, x - y)) ~= nil, "x - y divides x^2 - y^2")
  tap.ok(poly.divide(poly.from(ring, x ^ 2 + y ^ 2), poly.from(ring, x - y)) == nil, "x - y does not divide x^2 + y^2")
  tap.ok(poly.iszero(poly.from(ring, expr.zero)), "0 is the zero polynomial")
  local list = poly.sorted(poly.from(ring, y ^ 9 + x + 1))
  tap.ok(list[1].e[1] == 1 and list[2].e[2] == 9 and list[3].e[1] == 0,
    "terms are sorted with the first generator first")
end

-- ---- bounded work ----

do
  poly.budget = 1000
  local ring = poly.ring { x, y }
  local p = poly.from(ring, 1 + x + y)
  local ok, why = pcall(poly.power, p, 40)
  poly.budget = nil
  tap.ok(not ok and why == poly.exhausted, "an expansion beyond its budget is abandoned")
  tap.ok(pcall(poly.power, p, 5), "without a budget there is none")
end

-- (x - 1)(x - 2)(x - 3): each root is where Horner's sum is exactly 0
tap.is(table.concat(roots.between({ -6, 11, -6, 1 }, 0, 4), " "), "1.0 2.0 3.0",
  "real roots lie between those of the derivative")

tap.done()
