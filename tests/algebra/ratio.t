#!/usr/bin/env lua5.4
-- ratio.t: the zero test decides, and tidy() changes the form and never the value.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local poly = require "generator.algebra.poly"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"
local recipe = require "tests.algebra.recipe"

local x, y, z, u, w = expr.sym "x", expr.sym "y", expr.sym "z", expr.sym "u", expr.sym "w"
local call, sqrt = expr.call, expr.sqrt
local iszero, tidy = ratio.iszero, ratio.tidy

-- A polynomial multiplied out.
local function expand(e) return poly.expr(assert(poly.from(poly.ring { e }, e))) end

-- Zero; and what differs from it by a little is not.
local function zero(e, name)
  tap.ok(iszero(e), name)
  tap.ok(not iszero(e + x / 1000000), "and plus x/10^6 it is not 0: " .. name)
end

-- ---- the zero test ----

for n = 2, 8 do
  local sum, binomial = expr.zero, 1
  for k = 0, n do
    sum = sum + binomial * x ^ k * y ^ (n - k)
    binomial = binomial * (n - k) // (k + 1)
  end
  zero((x + y) ^ n - sum, "(x + y)^" .. n .. " is the binomial sum")
end
do
  local S = { x, y, z, u, w, expr.sym "v" }
  local adj, det = vec.adjugate(S)
  local P = vec.matmul(vec.full(S), vec.full(adj))
  for i = 1, 3 do
    for j = 1, 3 do
      zero(P[i][j] - (i == j and det or 0), "(S adj S)[" .. i .. j .. "] = " .. (i == j and "det" or "0"))
    end
  end
end
zero(call("sin", x) ^ 2 + call("cos", x) ^ 2 - 1, "sin^2 + cos^2 = 1")
zero(call("sin", x) ^ 4 - (1 - call("cos", x) ^ 2) ^ 2, "sin^4 = (1 - cos^2)^2")
zero(1 / (1 + call("cos", x)) - (1 - call("cos", x)) / call("sin", x) ^ 2, "1/(1 + cos) = (1 - cos)/sin^2")
zero(1 / (x - y) - (x + y) / (x ^ 2 - y ^ 2), "1/(x - y) = (x + y)/(x^2 - y^2)")
zero(1 / (sqrt(x) - sqrt(y)) - (sqrt(x) + sqrt(y)) / (x - y), "1/(sqrt x - sqrt y) = (sqrt x + sqrt y)/(x - y)")
zero(1 / sqrt(x + 1) - sqrt(x + 1) / (x + 1), "1/sqrt(x + 1) = sqrt(x + 1)/(x + 1)")
zero((expr.pow(x, "1/3") + 1) * (sqrt(x) + 1) - expr.pow(x, "5/6") - sqrt(x) - expr.pow(x, "1/3") - 1,
  "(x^(1/3) + 1)(x^(1/2) + 1) multiplied out")
zero(call("abs", x - y) ^ 2 - (x - y) ^ 2, "|x - y|^2 = (x - y)^2")
zero((1 + sqrt(2)) * (sqrt(2) - 1) - 1, "(1 + sqrt 2)(sqrt 2 - 1) = 1")
zero(x / y + y / x - (x ^ 2 + y ^ 2) / (x * y), "x/y + y/x = (x^2 + y^2)/(x y)")
for _, case in ipairs {
  { x, "x" }, { (x + y) ^ 2 - x ^ 2 - y ^ 2, "(x + y)^2 - x^2 - y^2" }, { sqrt(x ^ 2 + 1) - x, "sqrt(x^2 + 1) - x" },
  { call("sin", x) ^ 2 - call("cos", x) ^ 2 + 1, "sin^2 - cos^2 + 1" },
  { sqrt(2) - expr.lift "99/70", "sqrt 2 - 99/70" },
  { call("sin", 2 * x) - 2 * call("sin", x), "sin 2x - 2 sin x" },
  { call("abs", x - 3) - (x - 3), "|x - 3| - (x - 3)" },
  { x ^ 7 - y ^ 7, "x^7 - y^7" }, { sqrt(x) * sqrt(y) - sqrt(x * y) + 1, "sqrt x sqrt y - sqrt(x y) + 1" },
} do
  tap.ok(not iszero(case[1]), case[2] .. " is not 0")
end
tap.ok(iszero(expr.zero) and not iszero(expr.lift "1e-300"), "0 is zero and 10^-300 is not")
tap.ok(ratio.equal(x, x) and ratio.equal((x + 1) ^ 2, x ^ 2 + 2 * x + 1) and not ratio.equal(x, y),
  "equal() is the zero test of the difference")

-- Scales: a physical tensor is 1e-47 or 1e37 kg m^2, and its determinant the third power.
for _, power in ipairs { 60, -60, 300, -300 } do
  local k = expr.num(R.new(10) ^ power)
  local e = (k * x + y) ^ 3 - k ^ 3 * x ^ 3 - 3 * k ^ 2 * x ^ 2 * y - 3 * k * x * y ^ 2 - y ^ 3
  tap.ok(iszero(e), "(k x + y)^3 multiplied out, k = 10^" .. power .. ": 0")
  tap.ok(not iszero(e + k * k * x), "(k x + y)^3 multiplied out, k = 10^" .. power .. ", plus k^2 x: not 0")
  tap.ok(iszero(sqrt(k * x) ^ 2 / k - x), "(sqrt(k x))^2/k - x = 0, k = 10^" .. power)
end

-- Random rational functions: f - f' is zero for f' = tidy(f), f in another order, and f multiplied out over g.
do
  recipe.seed(41)
  local wrong = {}
  for n = 1, 80 do
    local r, s = recipe.random(5, {}), recipe.random(3, {})
    local f, g = recipe.build(r), recipe.build(s)
    local h = 1 + g ^ 2
    local function expect(e, what)
      if not iszero(e) then wrong[#wrong + 1] = what .. " " .. n .. ": " .. text.of(f) .. " and " .. text.of(g) end
    end
    expect(f - tidy(f), "tidy")
    expect((f * h) / h - f, "cancelled factor")
    expect((f + g) ^ 2 - f ^ 2 - 2 * f * g - g ^ 2, "square of a sum")
    expect(f / h + g / (h + 1) - (f * (h + 1) + g * h) / (h * (h + 1)), "common denominator")
    if iszero(f - tidy(f) + expr.lift "1/1000000007") then wrong[#wrong + 1] = "not zero " .. n end
  end
  tap.is(table.concat(wrong, "\n"), "", "80 random rational functions: identities are 0, neighbours are not")
end

-- ---- tidy ----

local function tidies(e, want, name)
  local got = tidy(e)
  tap.ok(got == want, name, "got  " .. text.of(got) .. "\nwant " .. text.of(want))
end
tidies((x ^ 2 - y ^ 2) / (x - y), x + y, "(x^2 - y^2)/(x - y) ==> x + y")
tidies((x ^ 3 - y ^ 3) / (x - y), x ^ 2 + x * y + y ^ 2, "(x^3 - y^3)/(x - y) ==> x^2 + x y + y^2")
tidies((x ^ 2 - 1) / (x ^ 2 + 2 * x + 1), (x - 1) / (x + 1), "(x^2 - 1)/(x^2 + 2x + 1) ==> (x - 1)/(x + 1)")
tidies(x / y - x / y, expr.zero, "x/y - x/y ==> 0")
tidies((2 * x + 2 * y) / (4 * x + 4 * y), expr.lift "1/2", "(2x + 2y)/(4x + 4y) ==> 1/2")
tidies(x * y * (x + 1) / (x * (x * y + y)), expr.one, "x y (x + 1)/(x (x y + y)) ==> 1")
tidies((u * (x ^ 2 + z ^ 2) / 12 - u * (x ^ 2 + y ^ 2) / 12) / (u * (y ^ 2 + z ^ 2) / 12),
  (z ^ 2 - y ^ 2) / (y ^ 2 + z ^ 2), "(I3 - I2)/I1 of the brick ==> (c^2 - b^2)/(b^2 + c^2)")
tidies(1 / (1 / x + 1 / y), x * y / (x + y), "1/(1/x + 1/y) ==> x y/(x + y)")
tidies(call("sin", x) ^ 2 + call("cos", x) ^ 2, expr.one, "sin^2 + cos^2 ==> 1")
tidies((1 - call("cos", x) ^ 2) / call("sin", x), call("sin", x), "(1 - cos^2)/sin ==> sin")
tidies(u * x ^ 5 - u * y ^ 5, u * (x - y) * (x ^ 4 + x ^ 3 * y + x ^ 2 * y ^ 2 + x * y ^ 3 + y ^ 4),
  "u x^5 - u y^5 ==> u (x - y) (x^4 + x^3 y + x^2 y^2 + x y^3 + y^4)")
tidies(((x - y) ^ 2 + (z - u) ^ 2) / 12, ((x - y) ^ 2 + (z - u) ^ 2) / 12, "squares of differences stay such")
tidies((x - y) ^ 2 + (x + y) ^ 2, 2 * (x ^ 2 + y ^ 2), "what changes when x and y move together is multiplied out")
tap.ok(tidy(x) == x and tidy(expr.lift(3)) == expr.lift(3), "symbols and numbers are tidy")

-- The value is exactly the same, tidying twice is tidying once, and factors that were multiplied in are gone.
do
  recipe.seed(42)
  local wrong = {}
  local function fault(what, n, e) wrong[#wrong + 1] = what .. " " .. n .. ": " .. text.of(e) end
  for n = 1, 80 do
    local e = recipe.build(recipe.random(6, {}))
    local t = tidy(e)
    for _ = 1, 2 do
      local at = recipe.point()
      if evaluate.exact(e, at) ~= evaluate.exact(t, at) then fault("value", n, e) end
    end
    if tidy(t) ~= t then fault("twice", n, e) end
  end
  tap.is(table.concat(wrong, "\n"), "", "80 random rational functions keep their exact value; tidy of tidy is tidy")

  wrong = {}
  local cancelled = 0
  for n = 1, 40 do
    local p, q, g = recipe.build(recipe.random(2, { whole = true })), recipe.build(recipe.random(2, { whole = true })),
      recipe.build(recipe.random(2, { whole = true }))
    q, g = q ^ 2 + 1, g + x + 3
    -- multiplied out, so that the common factor is hidden
    local top, bottom = expand(p * g), expand(q * g)
    local t = tidy(top / bottom)
    if t ~= tidy(p / q) then fault("gcd", n, top / bottom) else cancelled = cancelled + 1 end
  end
  tap.is(table.concat(wrong, "\n"), "", "40 hidden common factors are cancelled")
  tap.is(cancelled, 40, "all 40 were tried")
end

-- ---- opaque generators ----

do
  local a, b, whole = expr.sym "a", expr.sym "b", expr.sym "a" * expr.sym "b" + 1
  local s = expr.call("opaque", whole)
  tap.ok(expr.call("opaque", 3 * x) == 3 * x, "what is one term is not made opaque")
  tap.ok(tidy((s * x + s) ^ 2 - s ^ 2 * x ^ 2) == s ^ 2 * (2 * x + 1), "an opaque sum is one generator")
  tap.ok(iszero(s - whole) and iszero(s ^ 2 - a ^ 2 * b ^ 2 - 2 * a * b - 1), "its value is still that of the sum")
  tap.ok(not iszero(s - a - b ^ 2), "and no other")
  local c, d = expr.call("opaque", expr.call("cos", a) * 2 - b), expr.call("opaque", expr.call("sin", a) * 2 + b)
  tap.ok(iszero((c + b) ^ 2 + (d - b) ^ 2 - 4), "what two have to do with each other is seen at points")
  local point = { a = R.new(2), b = R.new(3) }
  tap.ok(evaluate.exact(calculus.diff(s ^ 2, a), point) == R.new(2 * 7 * 3), "and (s^2)' is 2 s s'")
end

-- ---- bounded work ----

do
  local product, sum, left = expr.one, expr.zero, expr.zero
  for i = 1, 40 do
    local s = expr.sym("s" .. i)
    product, sum = product * (s + i), sum + s
    left = left + 1 / (s + i)
  end
  local start = os.clock()
  local huge = (product + sum) ^ 3 * left
  local t, done = tidy(huge)
  tap.ok(t == huge and done == false, "what would expand to 2^40 terms is left as it is")
  tap.ok(not iszero(huge), "and is seen not to be 0")
  local again = product * (product + sum) - product ^ 2 - product * sum
  tap.ok(iszero(again), "while P(P + S) - P^2 - P S, with P of 2^40 terms, is seen to be 0")
  tap.ok(not iszero(again + 1), "and plus 1 it is not")
  tap.ok(os.clock() - start < 20, "in bounded time", os.clock() - start .. " s")
end

tap.done()
