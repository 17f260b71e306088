#!/usr/bin/env lua5.4
-- eval.t: single operations of the ir evaluator against the C compiler, and expressions against known values.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local instr = require "generator.ir.core.instr"
local eval = require "tests.ir.eval"
local build = require "tests.ir.build"
local compiled = require "tests.ir.compiled"

-- ---- every opcode against C -------------------------------------------------------------------------------------

local values = { 0.0, -0.0, 1.0, -1.0, 0.3, -0.7, 2.5, -17.0, 1e-5, 3e5, math.huge, -math.huge, 0.0 / 0.0,
  2.0 ^ -140, -2.0 ^ -149, 1e38, 0.999, 88.0, -104.0 }
for k, x in ipairs(values) do values[k] = eval.float(x) end

local function literal(x)
  if x ~= x then return "NAN" end
  if math.abs(x) == math.huge then return x > 0 and "INFINITY" or "-INFINITY" end
  return string.format("%a", x)
end

-- All values, and for two operands all pairs, through one operation in C.
local function in_c(op, real)
  local entry = instr.of(op)
  local call
  if entry.c == "infix" then
    call = "x" .. entry.symbol .. "y"
  elseif entry.c == "prefix" then
    call = "-x"
  else
    call = entry.stem .. (real == "float" and "f" or "") .. (#entry.srcs == 2 and "(x, y)" or "(x)")
  end
  local list = {}
  for k, x in ipairs(values) do list[k] = "(real)" .. literal(x) end
  local n = #values
  return compiled.numbers(string.format([[
#include <math.h>
#include <stdio.h>
typedef %s real;
int main(void)
{
  volatile real v[] = {%s};
  int i, j;
  for (i = 0; i < %d; i++)
    for (j = 0; j < %d; j++) {
      const real x = v[i], y = v[j];
      (void)x; (void)y;
      printf("%%a\n", (double)(%s));
    }
  return 0;
}
]], real, table.concat(list, ", "), n, #entry.srcs == 2 and n or 1, call))
end

local function differing(op, real, close)
  local entry = instr.of(op)
  local two = #entry.srcs == 2
  local ir = build.one { op, "x", two and "y" or nil }
  local want, k, wrong = in_c(op, real), 0, {}
  for _, x in ipairs(values) do
    for j = 1, two and #values or 1 do
      k = k + 1
      local got = eval.run(ir, { x = x, y = values[j] }, real).y
      if not build.same(got, want[k]) and not close(got, want[k]) then
        wrong[#wrong + 1] = string.format("%s(%g, %g) = %.17g, not %.17g", op, x, values[j], want[k], got)
      end
    end
  end
  return wrong[1]
end

local function never() return false end
for _, real in ipairs { "double", "float" } do
  for _, op in ipairs { "add", "sub", "mul", "div", "neg", "sqrt", "fabs" } do
    tap.is(differing(op, real, never), nil, real .. " " .. op .. ": the ir and C agree to the bit, special values too")
  end
end
for _, op in ipairs { "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "pow" } do
  tap.is(differing(op, "double", never), nil, "double " .. op .. ": Lua's and C's libm are the same")
end

-- glibc documents errors up to 2 ulp for these (4 for the float versions of pow on some machines).
local function within(ulps, unit)
  return function(a, b) return math.abs(a - b) <= ulps * unit * math.abs(b) + 2.0 ^ -149 * (unit > 1e-10 and 1 or 0) end
end
for _, op in ipairs { "sinh", "cosh", "tanh", "cbrt" } do
  tap.is(differing(op, "double", within(4, 2.0 ^ -52)), nil, "double " .. op .. ": correctly rounded here, 2 ulp in C")
end
for _, op in ipairs { "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "pow", "sinh", "cosh", "tanh",
  "cbrt" } do
  tap.is(differing(op, "float", within(4, 2.0 ^ -23)), nil, "float " .. op .. ": the ir is within 4 ulp of C")
end

-- ---- what libm lacks: comparisons -----------------------------------------------------------------------

for _, case in ipairs { { "sign", -3.5, 0, -1 }, { "sign", 0.0, 0, 0 }, { "sign", -0.0, 0, 0 },
  { "sign", 2.0 ^ -149, 0, 1 },
  { "min", 2.5, -1, -1 }, { "min", -1, 2.5, -1 }, { "max", 2.5, -1, 2.5 }, { "max", -1, 2.5, 2.5 } } do
  local op, x, y, want = table.unpack(case)
  local got = eval.run(build.one { op, "x", op ~= "sign" and "y" or nil }, { x = x, y = y }, "double").y
  tap.is(got, want * 1.0, string.format("%s(%g, %g)", op, x, y))
end

-- ---- stores ------------------------------------------------------------------------------------------------------

do
  local ir = build.ir { { { "a", "x" }, { "a", "y", assign = "+=" },
    { "b", { "neg", "x", name = "m" }, assign = "+=" } } }
  local out, names = eval.run(ir, { x = 2, y = 3, b = 10 })
  tap.is(out.a, 5.0, "+= adds to what was stored")
  tap.is(out.b, 8.0, "+= adds to what the caller has")
  tap.is(names.m, -2.0, "named intermediates come back by name")
  tap.throws(function() eval.run(ir, { x = 2, y = 3 }) end, "no value for 'b'", "+= of nothing is loud")
  tap.throws(function() eval.run(ir, { x = 2, b = 3 }) end, "no value for input 'y'", "a missing input is loud")
  tap.throws(function() eval.run(ir, {}, "half") end, "no real 'half'", "there is no third real")
end

-- ---- expressions: evaluate -----------------------------------------------------------------------------------------

local x, y = expr.sym "x", expr.sym "y"
local q = R.parse

tap.is(tostring(evaluate.exact((x ^ 2 - y) / (x + y) ^ 3, { x = q "1/2", y = q "1/3" })), "-18/125",
  "exact: (1/4 - 1/3)/(5/6)^3 is -18/125")
tap.is(tostring(evaluate.exact(expr.sqrt(x), { x = q "4/9" })), "2/3", "exact: a root that is rational")
tap.throws(function() evaluate.exact(expr.sqrt(x), { x = q "2" }) end, "not rational", "exact: sqrt 2 is refused")
tap.throws(function() evaluate.exact(expr.call("sin", x), { x = q "1" }) end, "no exact value",
  "exact: sin 1 is refused")
tap.throws(function() evaluate.exact(1 / x, { x = q "0" }) end, "division by zero", "exact: 1/0 is refused")
tap.throws(function() evaluate.exact(x, {}) end, "no value for symbol 'x'", "a missing symbol is loud")

-- To 40 digits, from tables: pi; sqrt 2; sin 1; Gamma-free identities would be circular.
local function digits(value) return R.parse(value) end
local function close(got, want, name)
  local off = R.abs(got - want)
  tap.ok(R.sign(off) == 0 or R.log2(off) < -130, name) -- 40 decimals are 132 bits
end
close(evaluate.precise(expr.pi * x, { x = q "1" }, 200), digits "3.1415926535897932384626433832795028841972",
  "precise: pi (Abramowitz and Stegun, table 1.1)")
close(evaluate.precise(expr.sqrt(x), { x = q "2" }, 200), digits "1.4142135623730950488016887242096980785697",
  "precise: sqrt 2 (Abramowitz and Stegun, table 1.1)")
close(evaluate.precise(expr.call("exp", x), { x = q "1" }, 200), digits "2.7182818284590452353602874713526624977572",
  "precise: e (Abramowitz and Stegun, table 1.1)")
close(evaluate.precise(expr.call("sin", x) ^ 2 + expr.call("cos", x) ^ 2, { x = q "7/3" }, 200), q "1",
  "precise: sin^2 + cos^2 is 1")
close(evaluate.precise(expr.pow(x, R.new(2, 3)), { x = q "27" }, 200), q "9", "precise: 27^(2/3) is 9")
tap.throws(function() evaluate.precise(expr.call("log", x), { x = q "-1" }, 100) end, "log(-1) is not a real number",
  "precise: log -1 is refused")

-- half an ulp for each of 4 operations
tap.near(evaluate.double(expr.sqrt(x ^ 2 + y ^ 2) * expr.call("abs", y), { x = 3, y = -4.0 }), 20.0, 5e-16, 0,
  "double: sqrt(9 + 16)*4 is 20",
      "three roundings")
tap.near(evaluate.double(expr.call("cosh", x) - expr.call("sinh", x), { x = q "1" }), math.exp(-1), 2e-15, 0,
  "double: cosh 1 - sinh 1 is 1/e",
      "two functions and a difference that cancels to a tenth")

-- The domain: each semi-axis positive, the sum finite (DLMF 19.33 asks for no less).
do
  local value = require("generator.ir.special.special").value
  local function same(v) return v end
  for _, name in ipairs { "ellipsoid_area", "ellipsoid_normal" } do
    for _, axes in ipairs { { 0.0, 1.0, 1.0 }, { 1.0, 0.0, 1.0 }, { 1.0, 1.0, 0.0 }, { -1.0, 1.0, 1.0 },
      { 1.0, 1.0, math.huge } } do
      local got = value[name](same, table.unpack(axes))
      tap.ok(got ~= got, name .. " of " .. table.concat(axes, ", ") .. " is no number", got)
    end
  end
end

tap.done()
