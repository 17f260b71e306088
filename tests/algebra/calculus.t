#!/usr/bin/env lua5.4
-- calculus.t: derivatives against exact identities and high-precision differences; substitution.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local recipe = require "tests.algebra.recipe"

local x, y, z = expr.sym "x", expr.sym "y", expr.sym "z"
local diff, call = calculus.diff, expr.call

local function same(got, want, name)
  return tap.ok(ratio.equal(got, want), name, "got  " .. text.of(got) .. "\nwant " .. text.of(want))
end

-- ---- exact ----

for n = -3, 5 do
  same(diff(x ^ n, x), n * x ^ (n - 1), "d x^" .. n .. "/dx = " .. n .. " x^" .. n - 1)
end
same(diff(expr.sqrt(x), x), 1 / (2 * expr.sqrt(x)), "d sqrt(x)/dx = 1/(2 sqrt(x))")
same(diff(expr.pow(x, "1/3"), x), expr.pow(x, "-2/3") / 3, "d x^(1/3)/dx = x^(-2/3)/3")
same(diff(x * y * z, y), x * z, "d (x y z)/dy = x z")
same(diff(x / y, y), -x / y ^ 2, "d (x/y)/dy = -x/y^2")
same(diff(y ^ 2, x), expr.zero, "another symbol is constant")
same(diff(expr.pi * x, x), expr.pi, "pi is constant")
same(diff(call("abs", x), x), call("side", x), "d |x|/dx = sign x")
same(diff(call("side", x), x), expr.zero, "which is constant on both sides")
same(diff((x + y) ^ 7, x), 7 * (x + y) ^ 6, "chain rule: d (x + y)^7/dx")
same(diff(call("sin", x ^ 2), x), 2 * x * call("cos", x ^ 2), "chain rule: d sin(x^2)/dx")
tap.ok(diff(x, x) == expr.one and diff(expr.lift(3), x) == expr.zero, "dx/dx = 1 and d3/dx = 0")

-- Product and quotient rule, and equality of mixed derivatives, as identities of random rational functions.
do
  recipe.seed(21)
  local broken = {}
  for n = 1, 25 do
    local f, g = recipe.build(recipe.random(4, {})), recipe.build(recipe.random(4, {}))
    local q = 1 + g ^ 2
    local faults = {
      product = diff(f * g, x) - diff(f, x) * g - f * diff(g, x),
      quotient = diff(f / q, x) - (diff(f, x) * q - f * diff(q, x)) / q ^ 2,
      mixed = diff(diff(f / q, x), y) - diff(diff(f / q, y), x),
    }
    for _, rule in ipairs { "product", "quotient", "mixed" } do
      if not ratio.iszero(faults[rule]) then broken[#broken + 1] = rule .. " " .. n end
    end
  end
  tap.is(table.concat(broken, ", "), "", "product rule, quotient rule and f_xy = f_yx hold for 25 pairs")
end

-- ---- against differences ----

-- (f(x + h) - f(x - h))/(2h) with h = 2^-80 and 500 bits: truncation h^2 f'''/6 is below 2^-140 for f''' < 2^20,
-- rounding 2^-500/2^-80; so 120 bits must agree.
local BITS, STEP, CLOSE = 500, R.new(2) ^ -80, 120

local function difference(e, at, name)
  local left, right = {}, {}
  for k, v in pairs(at) do left[k], right[k] = v, v end
  left[name], right[name] = at[name] - STEP, at[name] + STEP
  return (evaluate.precise(e, right, BITS) - evaluate.precise(e, left, BITS)) / (STEP + STEP)
end

local function matches(e, at, name)
  local d = evaluate.precise(diff(e, expr.sym(name)), at, BITS)
  return recipe.close(d, difference(e, at, name), CLOSE)
end

for _, fn in ipairs { "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh", "abs" } do
  -- arguments in (0, 1), the domain that all of them share
  local good = matches(call(fn, x), { x = R.new(2, 7) }, "x")
    and matches(call(fn, x ^ 2 / 3), { x = R.new(4, 5) }, "x")
  tap.ok(good, "d " .. fn .. "/dx is the limit of its differences")
end
for _, fn in ipairs { "sin", "cos", "atan", "exp", "sinh", "cosh", "tanh", "abs" } do
  tap.ok(matches(call(fn, x), { x = R.new(-9, 7) }, "x"), "d " .. fn .. "/dx at a negative argument")
end
same(diff(call("sign", x), x), expr.zero, "of sign too")
for _, fn in ipairs { "min", "max" } do
  local e, good = call(fn, x ^ 2, 3 * y), true
  for _, at in ipairs { { x = R.new(1, 5), y = R.new(3, 7) }, { x = R.new(-9, 2), y = R.new(1, 7) } } do
    good = good and matches(e, at, "x") and matches(e, at, "y")
  end
  tap.ok(good, "d " .. fn .. "(x^2, 3 y) by either argument, on both sides")
end
do
  local e = call("atan2", y, x)
  local good = true
  for _, p in ipairs { { 3, 4 }, { -3, 4 }, { 3, -4 }, { -3, -4 } } do
    local at = { x = R.new(p[1], 5), y = R.new(p[2], 7) }
    good = good and matches(e, at, "x") and matches(e, at, "y")
  end
  tap.ok(good, "d atan2(y, x) by either argument, in all four quadrants")
end

for _, family in ipairs { { "rational functions", {} }, { "roots and functions", { roots = true, calls = true } } } do
  recipe.seed(22)
  local wrong = {}
  for n = 1, 60 do
    local e = recipe.build(recipe.random(5, family[2]))
    local at = recipe.point()
    -- where the expression is wild (high powers of large arguments) the difference says less: scale h^2 f''' counts
    for _, s in ipairs(expr.symbols(e)) do
      local d = evaluate.precise(diff(e, s), at, BITS)
      local f = difference(e, at, s.name)
      local size = R.abs(evaluate.precise(diff(diff(diff(e, s), s), s), at, BITS)) + R.new(1)
      if R.abs(d - f) > size * STEP * STEP + (R.abs(f) + R.new(1)) * R.new(2) ^ -300 then
        wrong[#wrong + 1] = n .. " by " .. s.name .. ": " .. text.of(e)
      end
    end
  end
  tap.is(table.concat(wrong, "\n"), "", "60 " .. family[1] .. ": derivative = difference within h^2 f'''")
end

-- `known`: symbols that stand for functions of x.
do
  local f = expr.sym "f"
  local d = diff(x * f ^ 2, x, { [f] = y })
  same(d, f ^ 2 + 2 * x * f * y, "a symbol whose derivative is known takes part in the chain rule")
end

-- ---- substitution ----

same(calculus.substitute(x ^ 2 + y, { [x] = y }), y ^ 2 + y, "substitute puts an expression for a symbol")
same(calculus.substitute(x - 2 * y, { [x] = y, [y] = x }), y - 2 * x,
  "substitution is simultaneous: x and y trade places")
same(calculus.substitute(call("sin", x + y), { [x] = -y }), expr.zero, "what comes together simplifies")
same(calculus.substitute((x + y) ^ 2, { [x + y] = z }), z ^ 2, "any node can be replaced, not only symbols")
local e = x ^ 2 / (1 + y ^ 2)
tap.ok(calculus.substitute(e, { [z] = x }) == e, "where nothing is replaced the node is the same")
do
  recipe.seed(23)
  local wrong = {}
  for n = 1, 60 do
    local outer, inner = recipe.build(recipe.random(6, {})), recipe.build(recipe.random(4, {}))
    local at = recipe.point()
    local env = recipe.point()
    for k, v in pairs(at) do env[k] = v end
    env.x = evaluate.exact(inner, at)
    if evaluate.exact(calculus.substitute(outer, { [x] = inner }), at) ~= evaluate.exact(outer, env) then
      wrong[#wrong + 1] = n .. ": " .. text.of(outer) .. " with x = " .. text.of(inner)
    end
  end
  tap.is(table.concat(wrong, "\n"), "", "60 compositions have the value of the outer at the inner's value, exactly")
end

-- A graph with 2^200 paths is walked once.
do
  local deep = x
  for _ = 1, 200 do deep = call("sin", deep + deep ^ 2) end
  local start = os.clock()
  diff(deep, x)
  calculus.substitute(deep, { [x] = y })
  tap.ok(os.clock() - start < 5, "shared parts are derived and replaced once: 200 levels of sharing take no time")
end

tap.done()
