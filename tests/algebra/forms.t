#!/usr/bin/env lua5.4
-- forms.t: factored and nested forms, costs, and polynomials in coordinates keep the value and find the factors.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local coordinate = require "generator.algebra.coordinate"
local cost = require "generator.algebra.cost"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local factor = require "generator.algebra.factor"
local gcd = require "generator.algebra.gcd"
local nest = require "generator.algebra.nest"
local poly = require "generator.algebra.poly"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local random = require "tests.ir.random"
local recipe = require "tests.algebra.recipe"

local function positive(name) return expr.sym(name, 2, true) end
local M, a, b, c, h, i, o, r = positive "M", positive "a", positive "b", positive "c", positive "h", positive "i",
  positive "o", positive "r"

-- ---- factored forms: the way a person writes them ----

for _, case in ipairs {
  { M * b ^ 2 / 12 + M * c ^ 2 / 12, M * (b ^ 2 + c ^ 2) / 12, "a box: the mass and 1/12 stand in front" },
  { M * r ^ 2 / 4 + M * h ^ 2 / 12, M * (3 * r ^ 2 + h ^ 2) / 12, "a cylinder" },
  { (o - i) * (o ^ 2 + o * i + i ^ 2) * 4 * expr.pi / 3, 4 * expr.pi * (o - i) * (o ^ 2 + o * i + i ^ 2) / 3,
    "a hollow ball: the wall o - i stays a factor of its volume" },
  { expr.pi * (o - i) * (o + i) * h, expr.pi * h * (o - i) * (o + i), "a tube: the wall and the sum of its radii" },
  { M * (o - i) * (o + i) * (o ^ 2 + i ^ 2) / (o - i), M * (o + i) * (o ^ 2 + i ^ 2),
    "a wall above and below is cancelled" },
  { a ^ 2 * b + 2 * a * b ^ 2 + b ^ 3, b * (a + b) ^ 2, "a square is found (Yun)" },
  { a ^ 3 + 3 * a ^ 2 * b + 3 * a * b ^ 2 + b ^ 3, (a + b) ^ 3, "a cube" },
  { a * c + a * h + b * c + b * h, (a + b) * (c + h), "contents in one variable" },
} do
  local got = ratio.tidy(case[1])
  tap.ok(got == case[2], case[3], "got  " .. text.of(got) .. "\nwant " .. text.of(case[2]))
end

-- ---- laws at random ----

-- A random polynomial in x, y, z of a few terms.
local X = { expr.sym "x", expr.sym "y", expr.sym "z" }
local function polynomial(terms, degree)
  local sum = expr.zero
  for _ = 1, terms do
    local t = expr.num(R.new(random.int(19) - 10, random.int(5)))
    for k = 1, 3 do t = t * X[k] ^ (random.int(degree + 1) - 1) end
    sum = sum + t
  end
  return sum
end

local function same_value(e, f)
  for _ = 1, 3 do
    local at = recipe.point()
    if evaluate.exact(e, at) ~= evaluate.exact(f, at) then return false end
  end
  return true
end

do
  recipe.seed(71)
  local wrong, factors = {}, 0
  local function fault(what, n, e) wrong[#wrong + 1] = what .. " " .. n .. ": " .. text.of(e) end
  for n = 1, 60 do
    local p, q = polynomial(3, 1), polynomial(2, 2)
    local e = p ^ random.int(3) * q
    if e.kind ~= "num" then
      local ring = poly.ring { e }
      local whole = poly.from(ring, e)
      local f = poly.iszero(whole) and expr.zero or factor.product(whole, factor.hints(ring, e))
      if not same_value(e, f) then fault("factor", n, e) end
      if f.kind == "mul" then factors = factors + 1 end
      local tidy = ratio.tidy(e)
      if not same_value(e, tidy) then fault("tidy", n, e) end
      if ratio.tidy(tidy) ~= tidy then fault("tidy twice", n, e) end
      local open = poly.expr(whole)
      for _, last in ipairs { false, true } do
        local nested = nest(open, last)
        if not same_value(e, nested) then fault("nest", n, e) end
        if cost { nested } > cost { open } then fault("nest costs more", n, e) end
      end
    end
  end
  tap.is(table.concat(wrong, "\n"), "", "60 products: factored, tidied and nested they keep their value, tidying " ..
    "twice is tidying once, and nesting costs no more")
  tap.ok(factors > 40, "most are found to be products", factors .. " of 60")
end

do -- a divisor divides both, and holds what was put into both
  recipe.seed(72)
  local wrong, found = {}, 0
  for n = 1, 60 do
    local p, q, g = polynomial(2, 1) + 1, polynomial(2, 1) + X[1], polynomial(2, 1) + X[2] * X[3]
    local ring = poly.ring { p, q, g, X[1] }
    local P, Q, G = poly.from(ring, p * g), poly.from(ring, q * g), poly.from(ring, g)
    if not poly.iszero(P) and not poly.iszero(Q) and not poly.iszero(G) then
      local d = gcd.of(P, Q)
      if not poly.divide(P, d) or not poly.divide(Q, d) then wrong[#wrong + 1] = n .. ": no divisor" end
      if poly.divide(d, G) then found = found + 1 else wrong[#wrong + 1] = n .. ": " .. text.of(g) ..
        " is not found" end
    end
  end
  tap.is(table.concat(wrong, "\n"), "",
    "60 pairs with a common factor: the greatest common divisor has it and divides both")
  tap.ok(found > 50, "which were pairs", found .. "")
end

-- ---- costs ----

for _, case in ipairs {
  { { a + b }, 1 }, { { a * b * c }, 2 }, { { a ^ 2 }, 1 }, { { a ^ 3 }, 2 }, { { a ^ 4 }, 2 }, { { a ^ 7 }, 4 },
  { { a / b }, 3 }, { { expr.sqrt(a) }, 1 }, { { expr.call("sin", a + b) }, 2 },
  { { a + b, (a + b) * c }, 2 }, { { expr.lift(3), a }, 0 },
} do
  tap.is(cost(case[1]), case[2], "cost of " .. text.of(case[1][#case[1]]))
end
do
  local known = {}
  cost({ a + b }, known)
  tap.is(cost({ (a + b) * c }, known), 1, "what is known costs nothing")
end

-- ---- polynomials in the coordinates ----

do
  recipe.seed(73)
  local S = coordinate.symbols
  local wrong = {}
  -- value of a polynomial, with rational coefficients, at a point
  local function at(p, v)
    local sum = R.zero
    for _, t in ipairs(p) do sum = sum + t.c.value * v[1] ^ t[1] * v[2] ^ t[2] * v[3] ^ t[3] end
    return sum
  end
  local function random_form(terms)
    local p = {}
    for _ = 1, terms do
      p = coordinate.add(p, coordinate.scale(expr.num(R.new(random.int(9) - 5, random.int(4))),
        coordinate.monomial(random.int(3) - 1, random.int(3) - 1, random.int(3) - 1)))
    end
    return p
  end
  local function without(p, v) -- of the other coordinates alone
    local out = {}
    for _, t in ipairs(p) do
      if t[v] == 0 then out[#out + 1] = t end
    end
    return out
  end
  for n = 1, 40 do
    local p, q = random_form(4), random_form(3)
    local v = { R.new(random.int(9), 2), R.new(random.int(9), 5), R.new(-random.int(9), 7) }
    if at(coordinate.add(p, q), v) ~= at(p, v) + at(q, v) then wrong[#wrong + 1] = "add " .. n end
    if at(coordinate.mul(p, q), v) ~= at(p, v) * at(q, v) then wrong[#wrong + 1] = "mul " .. n end
    if at(coordinate.power(q, 3), v) ~= at(q, v) ^ 3 then wrong[#wrong + 1] = "power " .. n end
    local k = n % 3 + 1
    local lo, hi = without(random_form(2), k), without(random_form(2), k)
    -- d/dx of the integral up to x is the integrand; and Simpson's rule is exact for the degree that it has, at most 3
    local f = coordinate.integrate(p, k, lo, hi)
    local ends = { at(lo, v), at(hi, v) }
    local function value(x)
      local w = { v[1], v[2], v[3] }
      w[k] = x
      return at(p, w)
    end
    local simpson = (ends[2] - ends[1]) / R.new(6) *
      (value(ends[1]) + R.new(4) * value((ends[1] + ends[2]) / R.new(2)) + value(ends[2]))
    if at(f, v) ~= simpson then wrong[#wrong + 1] = "integral " .. n end
    for _, t in ipairs(f) do
      if t[k] ~= 0 then wrong[#wrong + 1] = "integral keeps its coordinate " .. n end
    end
  end
  tap.is(table.concat(wrong, "; "), "", "sums, products, powers and integrals of 40 polynomials in the coordinates")
  tap.ok(coordinate.of(1 / S[1]) == nil and coordinate.of(expr.sqrt(S[2] + 1)) == nil and
    coordinate.of(expr.call("sin", S[3])) == nil, "a quotient, a root and a sine of a coordinate are no polynomials")
  tap.is(#coordinate.of(a / b + expr.sqrt(c)), 1, "of parameters they are constants")
  tap.is(#coordinate.of((S[1] + a * S[2]) ^ 3), 4, "a power is multiplied out")
  tap.ok(coordinate.of(S[1] ^ 41) == nil and coordinate.of(S[1] ^ 40) ~= nil, "degrees end at 40")
  tap.ok(coordinate.of(S[1] ^ 20 * S[2] ^ 21) == nil, "in all")
end

-- ---- bounded work ----

do
  local product = expr.one
  for k = 1, 12 do product = product * (expr.sym("s" .. k) + k) ^ 3 end
  local start = os.clock()
  local t, done = ratio.tidy(ratio.tidy(product + a) / (product - b), 500)
  tap.ok(done == false and t ~= nil, "a small grant ends the work and leaves the form")
  tap.ok(os.clock() - start < 20, "in bounded time", os.clock() - start .. " s")
end

tap.done()
