#!/usr/bin/env lua5.4
-- lower.t: which form of evaluation lower chooses, what it shares, what it refuses.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Forms are looked at as C text, the shortest notation for them; that they have the value of the
-- expression is shown on random programs in oracle.t.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local form = require "generator.ir.lower.form"
local lower = require "generator.ir.lower.lower"
local share = require "generator.ir.lower.share"
local passes = require "generator.ir.passes.passes"
local count = require "generator.ir.core.count"
local eval = require "tests.ir.eval"
local cprint = require "generator.emit.cprint"
local random = require "tests.ir.random"

local function lines_of(program)
  local c = cprint.statements(passes.run(lower.run(program)), "double", { type = "real" })
  local lines = {}
  for _, group in ipairs(c.groups) do
    for _, line in ipairs(group.lines) do lines[#lines + 1] = line end
  end
  return table.concat(lines, "\n")
end

-- Run as `lower.t text`, print random programs: called below, in processes of their own.
if arg[1] == "text" then
  random.seed(99)
  for k = 1, 10 do print(lines_of((random.program("p" .. k, 9, { roots = true, calls = true })))) end
  os.exit(0)
end

local decade = require("generator.algebra.rational").decade

local names = { "a", "b", "c", "d", "m", "x", "y", "z", "Ix", "Iy", "Iz", "wx", "wy", "wz" }
local s, inputs = {}, {}
for k, name in ipairs(names) do
  s[name] = expr.sym(name)
  inputs[k] = { sym = name, c = name }
end
local a, b, c, d, m, x, y, z = s.a, s.b, s.c, s.d, s.m, s.x, s.y, s.z
local q = function(text) return expr.num(R.parse(text)) end

local function program(...)
  local group = { why = "test", outs = {} }
  for k, e in ipairs { ... } do group.outs[k] = { c = "r" .. k, expr = e } end
  return { name = "f", inputs = inputs, groups = { group } }
end

-- ---- one expression ------------------------------------------------------------------------------------------------

for _, row in ipairs {
  -- sums and signs
  { -a * d + b * c, "b*c - a*d", "a sum begins with a positive term" },
  { a - b, "a - b", "a difference stays as it is" },
  { b - a, "b - a", "and does not become -(a - b)" },
  { -a - b, "-(a + b)", "two minus signs are one" },
  { x * (b - a), "x*(b - a)", "a factor may turn round" },
  { -x * (a - b) / d, "x*(b - a)/d", "to save the minus of its product" },
  { -x * y, "-x*y", "a minus goes to the first factor" },
  { -1 / x, "-1.0/x", "or into the constant" },
  { a - q "4/5" * b, "a - 0.8*b", "a negative coefficient is a subtraction" },
  -- coefficients
  { q "5/13" * a * b, "(5.0/13.0)*a*b", "a rational coefficient is one multiplication, first" },
  { x / 8, "0.125*x", "so is a division by 8" },
  { q "1/2" * a + q "1/2" * b, "0.5*(a + b)", "a common coefficient is applied once" },
  { 1 - 2 * x ^ 2 - 2 * y ^ 2, "1.0 - 2.0*(x*x + y*y)", "also in a part of a sum" },
  { a / 2 + b / 3, "0.5*a + (1.0/3.0)*b", "but not 1/6 times a sum with coefficients" },
  { 2 * expr.pi * x, "6.283185307179586*x", "2 pi is one constant, correctly rounded" },
  { expr.sqrt(2) * x, "1.4142135623730951*x", "and so is the root of 2" },
  { expr.call("exp", expr.num(1)) * x, "2.718281828459045*x", "and exp 1" },
  -- products and quotients
  { (s.Iy - s.Iz) * s.wy * s.wz / s.Ix, "wy*wz*(Iy - Iz)/Ix", "one division, at the end" },
  { a / (b * c ^ 2), "a/(b*(c*c))", "by the product of the denominators" },
  { 3 / (4 * x), "0.75/x", "a coefficient is a numerator" },
  { a * x / m + b * y / m, "(a*x + b*y)/m", "a common denominator divides once" },
  { s.Iy * s.wy * s.wz - s.Iz * s.wy * s.wz, "(Iy - Iz)*wy*wz", "a factor common to all terms is taken out" },
  { x ^ 3 + x ^ 2 * y, "(x + y)*(x*x)", "as often as all have it" },
  -- differences of squares
  { x ^ 2 - y ^ 2, "(x - y)*(x + y)", "x^2 - y^2 is regular near x = y" },
  { y ^ 2 - x ^ 2, "(y - x)*(x + y)", "either way round" },
  { 1 - x ^ 2, "(1.0 - x)*(1.0 + x)", "1 - x^2 too" },
  { m * x ^ 2 - m * y ^ 2, "(x - y)*(x + y)*m", "and with a common factor" },
  { 3 * x ^ 2 - 3 * y ^ 2, "3.0*(x - y)*(x + y)", "and with a common coefficient" },
  { x ^ 2 - 2 * y ^ 2, "x*x - 2.0*(y*y)", "2 is no square of a rational" },
  { x ^ 2 + y ^ 2, "x*x + y*y", "a sum of squares stays" },
  { x ^ 3 - y ^ 3, "x*x*x - y*y*y", "and so do cubes" },
  -- powers
  { expr.sqrt(x), "sqrt(x)", "x^(1/2)" },
  { 1 / expr.sqrt(x), "1.0/sqrt(x)", "x^(-1/2)" },
  { expr.pow(x, R.new(3, 2)), "x*sqrt(x)", "x^(3/2)" },
  { a * expr.pow(x, R.new(-3, 2)), "a/(x*sqrt(x))", "x^(-3/2)" },
  { expr.pow(x, R.new(1, 4)), "sqrt(sqrt(x))", "x^(1/4) needs no pow" },
  { expr.pow(x, R.new(1, 3)), "cbrt(x)", "x^(1/3)" },
  { expr.pow(x, R.new(1, 5)), "pow(x, 0.2)", "x^(1/5)" },
  { expr.pow(x, R.new(-7, 5)), "pow(x, -1.4)", "x^(-7/5)" },
  { expr.call("abs", x - y), "fabs(x - y)", "|x - y|" },
  { expr.call("atan2", -y, x), "atan2(-y, x)", "a minus in an argument" },
} do
  tap.is(lines_of(program(row[1])), "r1 = " .. row[2] .. ";", row[3] .. ": " .. row[2])
end

tap.is(lines_of(program(x ^ 2 - 4 * y ^ 2)), "const real t1 = 2.0*y;\nr1 = (x - t1)*(x + t1);",
  "x^2 - 4*y^2 is a difference of squares as well")

do -- at x = 1 + 2^-30 the difference of squares keeps all its digits
  local e, near = x ^ 2 - y ^ 2, { x = 1 + 2.0 ^ -30, y = 1 - 2.0 ^ -31 }
  local exact = evaluate.exact(e, { x = R.fromdouble(near.x), y = R.fromdouble(near.y) })
  for _, name in ipairs(names) do near[name] = near[name] or 0.0 end
  local got = eval.run(passes.run(lower.run(program(e))), near).r1
  tap.near(got, R.todouble(exact), 3 * 2.0 ^ -53, 0, "x^2 - y^2 near x = y is right to 3 roundings",
    "x - y is exact here, x + y and the product round once each")
end

-- ---- sharing --------------------------------------------------------------------------------------------------------

local function cost(...)
  local t = count.run(passes.run(lower.run(program(...))))
  return string.format("%d add %d mul %d div", t.add, t.mul, t.div)
end

tap.is(lines_of(program(a * s.wy * s.wz, b * s.wz * s.wy * x)),
  "const real t1 = wy*wz;\nr1 = a*t1;\nr2 = b*t1*x;", "a product common to two terms is computed once")
tap.is(cost(q "5/13" * x * y, q "3/7" * x * y), "0 add 3 mul 0 div", "also under different coefficients")
tap.is(cost(x * y * z, x * y * a, x * y * b * c), "0 add 5 mul 0 div", "x*y in three products is one multiplication")
tap.is(cost(a / (x * y), b / (x * y * z)), "0 add 2 mul 2 div", "denominators share too")
tap.is(cost(x + y + a, x + y + b), "3 add 0 mul 0 div", "a sum common to two sums is computed once")
tap.is(cost(x - y + a, y - x + b), "3 add 0 mul 0 div", "up to sign")
tap.is(cost(2 * x - 6 * y + a, 3 * y - x + b), "3 add 2 mul 0 div", "and up to a factor")
tap.is(lines_of(program(x - y, y - x)), "const real t1 = x - y;\nr1 = t1;\nr2 = -t1;",
  "y - x is -(x - y) where both occur")
tap.is(cost(expr.call("sin", x - y), expr.call("sin", y - x)), "1 add 0 mul 0 div", "in arguments as well")
tap.is(cost(x ^ 2 * a, x ^ 4 * b, x ^ 8 * c), "0 add 6 mul 0 div", "powers of one base share their steps")

-- ---- intermediates ---------------------------------------------------------------------------------------

local function with(defs, outs)
  local group = { why = "test", defs = {}, outs = {} }
  for k, def in ipairs(defs) do group.defs[k] = { name = def[1], expr = def[2] } end
  for k, e in ipairs(outs) do group.outs[k] = { c = "r" .. k, expr = e } end
  return { name = "f", inputs = inputs, groups = { group } }
end
local L, k = expr.sym "L", expr.sym "k"

tap.is(lines_of(with({ { "L", s.Ix * s.wx } }, { L * s.wy })), "const real L = Ix*wx;\nr1 = L*wy;",
  "a def keeps its name, used once or not")
tap.is(lines_of(with({ { "L", s.Ix * s.wx } }, { s.Ix * s.wx * s.wy + L })), "const real L = Ix*wx;\nr1 = L*wy + L;",
  "what equals a def uses it")
tap.is(lines_of(with({ { "L", x }, { "k", q "3/2" } }, { 2 * k * L })), "r1 = 3.0*x;",
  "an input or a constant under another name is replaced")
tap.is(lines_of(with({ { "L", x * y }, { "k", L } }, { k + a })), "const real L = x*y;\nr1 = a + L;",
  "and so is a def of a def")
tap.is(lines_of(with({ { "L", x * y }, { "k", L * z } }, { a })), "r1 = a;",
  "defs that nothing needs vanish, chains of them too")
tap.is(lines_of(with({ { "L", y - x } }, { L * a, x - y })), "const real L = y - x;\nr1 = L*a;\nr2 = -L;",
  "a def is not turned round")

-- ---- shared sums -------------------------------------------------------------------------------------------

-- A sum may come to stand twice in another (S + .. + x + y with S = x + y), and then a pair of its items is noted twice
-- for one sum.  Forms as lower has them after such steps, random coefficients: the exact values stay.
local function twice()
  local B, list, value, wrong = form.builder(), {}, {}, 0
  local function sum(items, length)
    local terms = {}
    for n = 1, length do
      local sign = random.int(2) == 1 and -1 or 1
      terms[n] = { c = R.new(sign * random.int(3)), f = items and items[random.int(#items)] or list[n] }
    end
    return B:sum_form(terms)
  end
  for n, name in ipairs { "a", "b", "c", "d" } do
    list[n] = B:leaf(name)
    value[list[n]] = R.new(n * n + 1, n + 1)
  end
  local function of(f)
    if value[f] then return value[f] end
    local v = R.new(0)
    for _, t in ipairs(f.terms) do v = v + t.c * of(t.f) end
    return v
  end
  local forms = {}
  forms[1] = sum(nil, 2)
  list[5] = forms[1]
  for n = 2, 5 do forms[n] = sum(list, 8) end
  local before = {}
  for n, f in ipairs(forms) do before[n] = of(f) end
  share.sums(forms, B)
  for n, f in ipairs(forms) do wrong = wrong + (of(f) == before[n] and 0 or 1) end
  return wrong
end
random.seed(1758)
local wrong = 0
for _ = 1, 200 do wrong = wrong + twice() end
tap.is(wrong, 0, "sums that hold a sum twice keep their values when parts are shared")

-- ---- scales under roots -------------------------------------------------------------------------------------

-- a/sqrt(S) with S of whole numbers that stand for decimals: 1e16 S below the root is 1e8 outside it, so no number that
-- is printed is far from those that people would write.
for _, row in ipairs { { "sqrt", R.new(1, 2) }, { "cbrt", R.new(1, 3) } } do
  local inside = q "0.0123456789012345" * x ^ 2 + q "0.0271828182845904" * y ^ 2 + q "0.0314159265358979" * x * y
  local e = a / expr.pow(inside, row[2]) + q "0.123456789" * b - q "0.987654321" * c
  local made, far = lower.run(program(e)), 0
  for _, i in ipairs(made.consts) do
    if math.abs(decade(i.value)) > 3 then far = far + 1 end
  end
  tap.is(far, 0, row[1] .. ": the scale of a sum goes through the root")
  local env = { a = 1.5, b = 0.75, c = 0.5, x = 1.25, y = 2.0 }
  for _, name in ipairs(names) do env[name] = env[name] or 1.0 end
  tap.near(eval.run(made, env).r1, evaluate.double(e, env), 1e-14, 0, row[1] .. ": and the value stays",
    "some twenty roundings of numbers of the result's size")
end

-- ---- refusals --------------------------------------------------------------------------------------------

tap.throws(function() lower.run(program(expr.sym "nowhere" * x)) end, "'nowhere' is neither an input nor defined above",
  "an unknown symbol is loud")
tap.throws(function() lower.run(with({ { "x", a } }, { x })) end, "'x' is defined twice", "a name has one definition")
tap.throws(function() lower.run(with({ { "L", k }, { "k", a } }, { L })) end, "'k' is neither",
  "a def must stand above its use")
tap.throws(function() lower.run(program(expr.call("log", expr.num(-1)))) end, "log of -1 is no number",
  "log -1 is no constant")
tap.throws(function() lower.run(program { kind = "tensor" }) end, "unknown node kind 'tensor'",
  "an unknown node is loud")

-- ---- same input, same bytes; time in proportion ----------------------------------------------------------

local function run()
  local pipe = io.popen("lua5.4 tests/ir/lower.t text")
  local text = pipe:read("a")
  pipe:close()
  return text
end
local first = run()
tap.ok(#first > 1000, "random programs print")
tap.is(run(), first, "in a second process the same bytes")
tap.is(run(), first, "and in a third: nothing follows hash order")

-- Lua instructions executed, a clock that does not depend on the machine.
local function steps(f)
  local n = 0
  debug.sethook(function() n = n + 1 end, "", 1000)
  f()
  debug.sethook()
  return n * 1000
end

-- Coefficients of the power series of w' = w x J w up to an order: sums of products, much in common.
local function series(order)
  local p = { name = "series", inputs = {}, groups = {} }
  local function w(i, n) return expr.sym("w" .. i % 3 .. "_" .. n) end
  for i = 0, 2 do p.inputs[#p.inputs + 1] = { sym = "w" .. i .. "_0", c = "x[" .. i .. "]" } end
  for n = 0, order - 1 do
    local defs = {}
    for i = 0, 2 do
      local terms = {}
      for j = 0, n do terms[#terms + 1] = w(i + 1, j) * w(i + 2, n - j) end
      local factor = expr.num(R.new(i + 1, 7 * (n + 1)))
      defs[#defs + 1] = { name = "w" .. i .. "_" .. n + 1, expr = factor * expr.add(terms) }
    end
    p.groups[n + 1] = { why = "order " .. n + 1, defs = defs }
  end
  p.groups[order].outs = { { c = "y", expr = w(0, order) * w(1, order) * w(2, order) } }
  return p
end
local small, large = series(20), series(40)
local n_small, n_large = lower.run(small).n, lower.run(large).n
local t_small, t_large = steps(function() lower.run(small) end), steps(function() lower.run(large) end)
tap.ok(t_large / t_small < 1.3 * n_large / n_small, "lower takes time in proportion to the values it makes",
  string.format("%d values in %d steps, %d in %d", n_small, t_small, n_large, t_large))
tap.ok(t_large < 1000 * n_large, "and less than 1000 Lua instructions for each", t_large / n_large)

tap.done()
