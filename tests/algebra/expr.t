#!/usr/bin/env lua5.4
-- expr.t: the constructors simplify by laws of real algebra, and by nothing that only looks like one.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Equal canonical forms are the same table, so `==` is the comparison everywhere.  Laws are tried with the cases they
-- hold for and with the neighbours they do not; then random expressions, whose value without any simplifier is known,
-- are built in several orders and must be one node of that value.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local recipe = require "tests.algebra.recipe"
local text = require "generator.formula.text"

local x, y, z = expr.sym "x", expr.sym "y", expr.sym "z"
local a, m = expr.sym("a", 2, true), expr.sym("m", 1, true) -- positive
local sqrt, pi = expr.sqrt, expr.pi
local function call(fn, ...) return expr.call(fn, ...) end
local function num(s) return expr.lift(s) end

-- got and want are nodes; the text of got is shown when they differ.
local function same(got, want, name)
  return tap.ok(got == want, name, "got  " .. text.of(got) .. "\nwant " .. text.of(want))
end
local function differ(p, q, name) return tap.ok(p ~= q, name, "both are " .. text.of(p)) end

-- ---- one table a form ----

tap.ok(expr.sym "x" == x, "a symbol is made once")
differ(expr.sym("x", 2), expr.sym("x", 3), "symbols of one name and two ranks differ")
differ(expr.sym("a", 2, true), expr.sym("a", 2), "a positive symbol is not the unsigned one of its name")
same(x + y + z, z + (y + x), "sums are one node in any order and grouping")
same(x * y * z, z * (y * x), "products are one node in any order and grouping")
same(num(0.5), num "1/2", "0.5 and 1/2 are one number")
same(R.half * x, x / 2, "a half of x and x/2 are one node")
tap.ok(call("sin", x + y) == call("sin", y + x), "calls with equal arguments are one node")

-- ---- sums ----

same(x - x, expr.zero, "x - x ==> 0")
same(x + x, 2 * x, "x + x ==> 2 x")
same(x + 0, x, "x + 0 ==> x")
same(x / 3 + x / 6, x / 2, "x/3 + x/6 ==> x/2")
same(2 * x + 4 * y, 2 * (x + 2 * y), "2x + 4y ==> 2 (x + 2y): the content is outside")
same(y - x, -(x - y), "y - x ==> -(x - y): one node with x - y inside")
tap.ok((x - y) / (y - x) == num(-1), "(x - y)/(y - x) ==> -1")
same(3 * (x + y) - 3 * x, 3 * y, "3 (x + y) - 3 x ==> 3 y: sums open into sums")
same((x + y) * 2 + (x - y) * 2, 4 * x, "2 (x + y) + 2 (x - y) ==> 4 x")
differ(x * (x + y), x ^ 2 + x * y, "x (x + y) is not multiplied out")
differ((x + y) ^ 2, x ^ 2 + 2 * x * y + y ^ 2, "(x + y)^2 is not multiplied out")
differ(x + y, x - y, "x + y is not x - y")

-- ---- products and powers ----

same(0 * x, expr.zero, "0 x ==> 0")
same(x * 1, x, "1 x ==> x")
same(x / x, expr.one, "x/x ==> 1")
same(x ^ 2 * x ^ 3, x ^ 5, "x^2 x^3 ==> x^5")
same(x ^ 2 * x ^ -2, expr.one, "x^2 x^-2 ==> 1")
same((x * y) ^ 3, x ^ 3 * y ^ 3, "(x y)^3 ==> x^3 y^3")
same((x / y) ^ -2, y ^ 2 / x ^ 2, "(x/y)^-2 ==> y^2/x^2")
same((x ^ 2) ^ 3, x ^ 6, "(x^2)^3 ==> x^6")
same((-x) ^ 2, x ^ 2, "(-x)^2 ==> x^2")
same((-x) ^ 3, -(x ^ 3), "(-x)^3 ==> -x^3")
same((2 * x + 2 * y) ^ 2, 4 * (x + y) ^ 2, "(2x + 2y)^2 ==> 4 (x + y)^2")
same((x - y) * (y - x), -(x - y) ^ 2, "(x - y)(y - x) ==> -(x - y)^2")
same(x ^ 0, expr.one, "x^0 ==> 1")
same(x ^ 1, x, "x^1 ==> x")
same(num(0) ^ 5, expr.zero, "0^5 ==> 0")
differ(x ^ 2 * y ^ 2, x ^ 2 * y ^ 3, "x^2 y^2 is not x^2 y^3")

-- ---- roots ----

same(sqrt(x) ^ 2, x, "sqrt(x)^2 ==> x: a root that is real has x >= 0")
same(sqrt(x) * sqrt(x), x, "sqrt(x) sqrt(x) ==> x")
same(sqrt(x ^ 2), call("abs", x), "sqrt(x^2) ==> |x| for an unsigned symbol")
differ(sqrt(x ^ 2), x, "sqrt(x^2) is not x for an unsigned symbol")
same(sqrt(a ^ 2), a, "sqrt(a^2) ==> a for a positive symbol")
same(sqrt(a ^ 2 * m ^ 2), a * m, "sqrt(a^2 m^2) ==> a m for positive symbols")
same(sqrt(x ^ 2 * a ^ 2), a * call("abs", x), "sqrt(x^2 a^2) ==> a |x|")
same(sqrt(x ^ 6), call("abs", x) ^ 3, "sqrt(x^6) ==> |x|^3")
differ(sqrt(x ^ 6), x ^ 3, "sqrt(x^6) is not x^3")
same(sqrt(x ^ 4), x ^ 2, "sqrt(x^4) ==> x^2, which has no sign to lose")
differ(sqrt(x * y), sqrt(x) * sqrt(y), "sqrt(x y) is not sqrt(x) sqrt(y) for unsigned symbols")
same(sqrt(a * m), sqrt(a) * sqrt(m), "sqrt(a m) ==> sqrt(a) sqrt(m) for positive symbols")
same(sqrt(a * x), sqrt(a) * sqrt(x), "sqrt(a x) ==> sqrt(a) sqrt(x) when one factor is positive")
same(sqrt(x * y) ^ 2, x * y, "sqrt(x y)^2 ==> x y")
same(sqrt(4 * x), 2 * sqrt(x), "sqrt(4 x) ==> 2 sqrt(x)")
differ(sqrt(-4 * x), 2 * sqrt(x), "sqrt(-4 x) is not 2 sqrt(x)")
same(sqrt(-4 * x) ^ 2, -4 * x, "sqrt(-4 x)^2 ==> -4 x")
same(sqrt(x - 5) ^ 2, x - 5, "sqrt(x - 5)^2 ==> x - 5, although the sum is kept as -(5 - x)")
differ(sqrt(x - 5), sqrt(5 - x), "sqrt(x - 5) is not sqrt(5 - x)")
same(sqrt((x + y) ^ 2), call("abs", x + y), "sqrt((x + y)^2) ==> |x + y|")
same(sqrt((a + m) ^ 2), a + m, "sqrt((a + m)^2) ==> a + m for positive symbols")
same(sqrt((a - m) ^ 2), call("abs", a - m), "sqrt((a - m)^2) ==> |a - m|: a difference has no sign")
same(sqrt(1 + x ^ 2) ^ 4, (1 + x ^ 2) ^ 2, "sqrt(1 + x^2)^4 ==> (1 + x^2)^2")
same(expr.pow(a, "1/3") * expr.pow(a, "1/6"), sqrt(a), "a^(1/3) a^(1/6) ==> sqrt(a)")
same(a / sqrt(a), sqrt(a), "a/sqrt(a) ==> sqrt(a)")
differ(expr.pow(x ^ 3, "1/3"), x, "(x^3)^(1/3) is not x: a negative base has no such power")
same(sqrt(8), 2 * sqrt(2), "sqrt(8) ==> 2 sqrt(2)")
same(sqrt "1/2", sqrt(2) / 2, "sqrt(1/2) ==> sqrt(2)/2")
same(sqrt "9/4", num "3/2", "sqrt(9/4) ==> 3/2")
same(sqrt(2) * sqrt(3), sqrt(6), "sqrt(2) sqrt(3) ==> sqrt(6), both 2^(1/2) 3^(1/2)")
same(sqrt(2) * sqrt(2), num(2), "sqrt(2) sqrt(2) ==> 2")
same(expr.pow(8, "1/3"), num(2), "8^(1/3) ==> 2")
same(expr.pow(2, "3/2"), 2 * sqrt(2), "2^(3/2) ==> 2 sqrt(2)")
same(1 / sqrt(2), sqrt(2) / 2, "1/sqrt(2) ==> sqrt(2)/2")
same(sqrt(num(R.new(10007) ^ 2)), num(10007), "the root of a large prime's square opens")
same((1 + sqrt(2)) * (1 + sqrt(2)), (1 + sqrt(2)) ^ 2, "a sum with a root is squared as a sum")
tap.throws(function() return sqrt(-1) end, "root of the negative number -1", "the root of -1 is an error")
tap.throws(function() return num(0) ^ -1 end, "division by zero", "0^-1 is an error")
tap.throws(function() return x / 0 end, "division by zero", "x/0 is an error")
tap.throws(function() return x ^ y end, "an exponent must be a number", "x^y is an error")

-- ---- functions ----

for _, fn in ipairs { "sin", "tan", "asin", "atan", "sinh", "tanh" } do
  same(call(fn, -x), -call(fn, x), fn .. "(-x) ==> -" .. fn .. "(x)")
  same(call(fn, y - x), -call(fn, x - y), fn .. "(y - x) ==> -" .. fn .. "(x - y)")
  same(call(fn, 0), expr.zero, fn .. "(0) ==> 0")
end
for _, fn in ipairs { "cos", "cosh", "abs" } do
  same(call(fn, -x), call(fn, x), fn .. "(-x) ==> " .. fn .. "(x)")
  same(call(fn, y - x), call(fn, x - y), fn .. "(y - x) ==> " .. fn .. "(x - y)")
end
for _, fn in ipairs { "acos", "exp", "log" } do
  differ(call(fn, -x), call(fn, x), fn .. " is not even")
  differ(call(fn, -x), -call(fn, x), fn .. " is not odd")
end
same(call("exp", 0), expr.one, "exp(0) ==> 1")
same(call("cosh", 0), expr.one, "cosh(0) ==> 1")
same(call("log", 1), expr.zero, "log(1) ==> 0")
same(call("exp", call("log", x)), x, "exp(log x) ==> x")
differ(call("asin", call("sin", x)), x, "asin(sin x) is not x")
differ(call("log", x ^ 2), 2 * call("log", x), "log(x^2) is not 2 log x")
same(call("abs", a), a, "|a| ==> a for a positive symbol")
differ(call("abs", x), x, "|x| is not x for an unsigned symbol")
same(call("abs", x ^ 2), x ^ 2, "|x^2| ==> x^2")
same(call("abs", num(-3)), num(3), "|-3| ==> 3")
same(call("sign", num(0)), num(0), "sign(0) is 0")
same(call("side", num(0)), num(1), "0 is on the upper side")
same(call("sign", -3 * x), -call("sign", x), "sign(-3 x) ==> -sign(x)")
same(call("min", y, x), call("min", x, y), "min(y, x) is min(x, y)")
same(call("max", x, x + 2), x + 2, "the larger of x and x + 2")
same(call("min", a + m, m), m, "the smaller of a + m and m for positive a")
same(call("max", num(-3), num("1/2")), num("1/2"), "the larger of two numbers")
differ(call("abs", a - m), a - m, "|a - m| stays: a difference has no sign")

-- sin and cos of k pi/12 against MPFR; everything else must stay a call or have the value.
do
  local bits, wrong, open = 200, {}, 0
  for k = -30, 30 do
    for _, fn in ipairs { "sin", "cos", "tan" } do
      if not (fn == "tan" and k % 12 == 6) then
        local e = call(fn, pi * k / 12)
        local argument = R.apply("pi", bits) * R.new(k, 12)
        local want = R.apply(fn, bits, argument)
        -- the argument is off by 2^-198 at most, tan' by 15: 2^-190 covers both, and zeros are absolute
        if not recipe.close(evaluate.precise(e, {}, bits), want, 190) then wrong[#wrong + 1] = fn .. " " .. k end
        if e.kind == "call" or e.kind == "mul" and e[#e].kind == "call" then open = open + 1 end
      end
    end
  end
  tap.is(table.concat(wrong, ", "), "", "sin, cos and tan of k pi/12, |k| <= 30, have the values of MPFR")
  tap.is(open, 0, "and all of them are exact numbers")
end
same(call("sin", pi / 6), num "1/2", "sin(pi/6) ==> 1/2")
same(call("cos", 2 * pi), expr.one, "cos(2 pi) ==> 1")
same(call("sin", pi / 4), sqrt(2) / 2, "sin(pi/4) ==> sqrt(2)/2")
same(call("sin", (num "1e30" + num "1/6") * pi), num "1/2", "sin((10^30 + 1/6) pi) ==> 1/2: a multiple of any size")
differ(call("sin", pi / 7), expr.zero, "sin(pi/7) stays")
differ(call("tan", pi / 2), expr.zero, "tan(pi/2) stays a call, without a value")

-- ---- signs ----

tap.ok(expr.nonnegative(a * m) and expr.nonnegative(x ^ 2) and expr.nonnegative(1 + x ^ 2)
  and expr.nonnegative(call("exp", x)) and expr.nonnegative(sqrt(x)),
  "products of positives, squares and roots are >= 0")
tap.ok(not expr.nonnegative(x) and not expr.nonnegative(a - m) and not expr.nonnegative(x ^ 3)
  and not expr.nonnegative(-a) and not expr.nonnegative(call("sin", a)),
  "x, a - m, x^3, -a and sin(a) are not known to be")

-- ---- nodes as such ----

tap.is(table.concat((function()
  local names = {}
  for _, s in ipairs(expr.symbols(call("sin", z) * y + m * x / a)) do names[#names + 1] = s.name end
  return names
end)(), " "), "m a x y z", "symbols() gives every symbol once, in canonical order")
tap.ok(expr.constant(pi + sqrt(2)) and not expr.constant(x), "constant() tells numbers from symbols")
tap.ok(expr.constant(x, { y = true }) and not expr.constant(x, { x = true }), "constant() can ask for given names")
same(expr.map(x + y, function(e) return e == x and z or e end), z + y, "map() replaces children")
tap.ok(expr.map(x * y, function(e) return e end) == x * y, "map() of the identity is the node itself")
tap.throws(function() return x + {} end, "not an expression", "a table is no expression")
tap.throws(function() return x + (0 / 0) end, "must be finite", "nan is no expression")
tap.is(expr.lift(0.1).value, R.new(1, 10), "a float becomes its decimal")

-- ---- random expressions ----

local KINDS = {
  { name = "rational functions", kinds = {}, exact = true, seed = 3 },
  { name = "roots", kinds = { roots = true }, seed = 4 },
  { name = "functions", kinds = { roots = true, calls = true }, seed = 5 },
}
local TRIALS, ORDERS, POINTS = 150, 4, 2
-- Values to 300 bits in both roads; a few hundred operations of condition below 2^40 leave 2^-250 with room.
local CLOSE = 200

for _, family in ipairs(KINDS) do
  recipe.seed(family.seed)
  local moved, wrong = {}, {}
  for n = 1, TRIALS do
    local r = recipe.random(7, family.kinds)
    local e = recipe.build(r)
    for _ = 2, ORDERS do
      local again = recipe.build(r)
      if again ~= e then moved[#moved + 1] = n .. ": " .. text.of(e) .. " | " .. text.of(again) end
    end
    for _ = 1, POINTS do
      local env = recipe.point()
      local want = recipe.value(r, env)
      local got = evaluate.precise(e, env, recipe.bits)
      if not recipe.close(got, want, CLOSE) then wrong[#wrong + 1] = n .. ": " .. text.of(e) end
      if family.exact and evaluate.exact(e, env) ~= want then wrong[#wrong + 1] = n .. " exactly: " .. text.of(e) end
    end
  end
  tap.is(table.concat(moved, "\n"), "", TRIALS .. " " .. family.name .. " are one node in " .. ORDERS .. " orders each")
  tap.is(table.concat(wrong, "\n"), "", TRIALS .. " " .. family.name .. " keep their value" ..
    (family.exact and ", exactly" or " to 200 bits"))
end

-- ---- no dependence on what was made before ----

-- The same expression in two fresh processes, of which one makes its parts, and others, in another order.
local SCRIPT = [[
package.path, package.cpath = "./?.lua;" .. package.path, "build/lua/?.so;" .. package.cpath
local expr, text = require "generator.algebra.expr", require "generator.formula.text"
local names = { "x", "y", "z", "a", "b" }
local first, last, step = 1, #names, 1
if PREPARE then
  first, last, step = last, first, -1
  for i = 9, 1, -1 do local s = expr.sym("x") * i + expr.sym("b") ^ i + expr.call("sin", expr.sym("z") + i) end
end
local s = {}
for i = first, last, step do s[names[i] ] = expr.sym(names[i]) end
local parts = { s.x + s.y, s.z * s.a, expr.sqrt(s.b + s.x), expr.call("cos", s.y - s.a), s.x ^ 3 / s.z, s.b - s.y }
local sum, product = expr.zero, expr.one
for i = PREPARE and #parts or 1, PREPARE and 1 or #parts, step do
  sum, product = sum + parts[i] * i, product * (parts[i] + i)
end
io.write(text.of(sum), "\n", text.of(product), "\n")]]
local function output(prepare)
  local pipe = assert(io.popen("lua5.4 - <<'END'\nPREPARE = " .. tostring(prepare) .. "\n" .. SCRIPT .. "\nEND\n"))
  local out = pipe:read "a"
  pipe:close()
  return out
end
local plain = output(false)
tap.ok(#plain > 40, "an expression prints in a process of its own", plain)
tap.is(output(true), plain, "the order of terms and factors does not depend on the order of creation")

tap.done()
