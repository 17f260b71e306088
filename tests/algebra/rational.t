#!/usr/bin/env lua5.4
-- rational.t: what a number in a scene means: the decimal that was typed, exactly.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Arithmetic and text of rationals are tests/cli/rational.t's; here is lift(), and that rationals stand on either side
-- of an operator whose other side is an expression.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local rational = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local function lifts(x, want, name) tap.is(tostring(rational.lift(x)), want, name) end

lifts(0.1, "1/10", "0.1 is 1/10, not the double next to it")
lifts(0.1 + 0.2, tostring(rational.parse "0.30000000000000004"),
  "a sum that the scene computed in doubles is the shortest decimal of its result")
lifts(1e-3, "1/1000", "1e-3 is 1/1000")
lifts(9.80665, "196133/20000", "9.80665 is its decimal")
lifts(1e22, "10000000000000000000000", "1e22 is a whole number")
lifts(2.0, "2", "2.0 is 2")
lifts(-0.0, "0", "-0.0 is 0")
lifts(5e-324, tostring(rational.parse "5e-324"), "the smallest double is its decimal 5e-324")
lifts(math.maxinteger, "9223372036854775807", "the largest integer is itself")
lifts(math.mininteger, "-9223372036854775808", "the smallest integer is itself")
lifts("1/3", "1/3", "the text 1/3 is a third")
lifts("-0.25", "-1/4", "the text -0.25 is -1/4")
lifts("1e400", "1" .. string.rep("0", 400), "the text 1e400 has no upper bound of a double")
lifts(rational.new(3, 7), "3/7", "a rational is itself")

for _, case in ipairs {
  { 0 / 0, "must be finite", "nan" }, { 1 / 0, "must be finite", "infinity" },
  { -1 / 0, "must be finite", "-infinity" },
  { "x", "must be a number such as \"0.1\", \"1e-3\" or \"1/3\"", "a word" },
  { "", "must be a number such as \"0.1\", \"1e-3\" or \"1/3\"", "an empty text" },
  { "0x10", "must be a number such as \"0.1\", \"1e-3\" or \"1/3\"", "a hexadecimal text" },
  { "inf", "must be a number such as \"0.1\", \"1e-3\" or \"1/3\"", "the text inf" },
  { " 1", "must be a number such as \"0.1\", \"1e-3\" or \"1/3\"", "a text with a blank" },
  { "1/0", "must not divide by zero", "the text 1/0" },
  { "1e999999999", "must have at most 300000 digits", "an exponent beyond the bound" },
  { nil, "must be a number", "nil" }, { true, "must be a number", "a boolean" }, { {}, "must be a number", "a table" },
} do
  local q, why = rational.lift(case[1])
  tap.ok(q == nil and why == case[2], case[3] .. " is no number: " .. case[2], tostring(why))
end

for _, case in ipairs { { "1e400", "1e400" }, { "9.99e-401", "1e-401" }, { "-1e-101", "-1e-101" }, { "1", "1e0" },
  { "-12345", "-1e4" }, { "1e-300", "1e-300" } } do
  tap.is(rational.magnitude(rational.parse(case[1])), case[2], case[1] .. " is about " .. case[2])
end

local x, q = expr.sym "x", rational.new(2, 3)
tap.ok(q + x == x + q, "a rational can be the left operand of a sum with an expression")
tap.ok(q - x == -(x - q), "a rational can be the left operand of a difference")
tap.ok(q * x == x * q, "a rational can be the left operand of a product")
tap.ok(q / x == (x / q) ^ -1, "a rational can be the left operand of a quotient")
tap.is(tostring(expr.lift(rational.new(9, 4) ^ expr.num(rational.half)).value), "3/2",
  "a rational to the power of an expression that is a number is an expression")
tap.throws(function() return q * {} end, "rational or integer expected",
  "a rational times a table that knows no product is an error")
tap.throws(function() return q * "3" end, "rational or integer expected", "a rational times a text is an error")
tap.throws(function() return q + 0.5 end, "rational or integer expected", "a rational plus a float is an error")

tap.done()
