#!/usr/bin/env lua5.4
-- text.t: the text of an expression reads back to its value, in each style; and examples of how it looks.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- reader.lua computes with rationals straight from the text.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local text = require "generator.formula.text"
local recipe = require "tests.algebra.recipe"
local reader = require "tests.algebra.reader"

local x, y, z = expr.sym "x", expr.sym "y", expr.sym "z"
local call, sqrt = expr.call, expr.sqrt

-- ---- the reader by itself ----

local A = reader.exact(recipe.bits)
local function read(s, env, style) return reader.value(s, env, A, style) end

tap.is(tostring(read("1 + 2*3^2/6 - 2 3", {})), "-2", "the reader knows precedence")
tap.is(tostring(read("-x^2/(2*x)", { x = R.new(3) })), "-3/2", "the reader takes ^ before the sign")
tap.is(tostring(read("x² y⁻¹ (x - 1)/3 y", { x = R.new(3), y = R.new(5) })), "6", "it reads raised digits")
tap.is(tostring(read("- \\frac{2 x_{1}}{3} \\left( x_{1} - \\frac{1}{2} \\right)^{2}", { x_1 = R.new(2) },
  "latex")), "-3", "it reads LaTeX")
for _, wrong in ipairs { "1 +", "1 - -1", "(1", "1)", "x", "sin 1", "" } do
  tap.ok(not pcall(read, wrong, {}), "it refuses: " .. wrong)
end

-- ---- every style ----

for _, family in ipairs {
  { name = "rational functions", make = function() return recipe.random(6, {}) end, seed = 51, exact = true },
  { name = "roots and functions", make = function() return recipe.random(6, { roots = true, calls = true }) end,
    seed = 52 },
  { name = "sums in sums of either sign", make = function() return recipe.signs(3) end, seed = 54, exact = true },
} do
  recipe.seed(family.seed)
  local wrong, fine = {}, 0
  for n = 1, 200 do
    local e = recipe.build(family.make())
    local at = recipe.point()
    local want = family.exact and evaluate.exact(e, at) or evaluate.precise(e, at, recipe.bits)
    local texts = { { text.of(e, "plain"), "text" }, { text.of(e, "unicode"), "text" },
      { text.of(e, "latex"), "latex" }, { text.of(e, "mathml"), "mathml" } }
    for _, t in ipairs(texts) do
      local s = t[1]
      local ok, got = pcall(read, s, at, t[2])
      -- both roads keep 300 bits; 200 is below what a few hundred operations can lose
      if ok and (family.exact and got == want or not family.exact and recipe.close(got, want, 200)) then
        fine = fine + 1
      else
        wrong[#wrong + 1] = n .. ": " .. s .. " (" .. tostring(got) .. ")"
      end
    end
  end
  tap.is(table.concat(wrong, "\n"), "", "200 " .. family.name .. ": the text has the value" ..
    (family.exact and ", exactly" or " to 200 bits"))
  tap.is(fine, 800, "all were read, in four styles")
end

local m, a, b, c = expr.sym("M", 1), expr.sym("a", 2), expr.sym("b", 2), expr.sym("c", 2)
local samples = {
  { m * (b ^ 2 + c ^ 2) / 12, "M*(b^2 + c^2)/12", "M (b² + c²)/12", "\\frac{M \\left( b^{2} + c^{2} \\right)}{12}" },
  { -m * a * b / 4, "-M*a*b/4", "-M a b/4", "- \\frac{M a b}{4}" },
  { (c ^ 2 - b ^ 2) / (b ^ 2 + c ^ 2), "(c^2 - b^2)/(b^2 + c^2)", "(c² - b²)/(b² + c²)",
    "\\frac{c^{2} - b^{2}}{b^{2} + c^{2}}" },
  { x / (y * z), "x/(y*z)", "x/(y z)", "\\frac{x}{y z}" },
  { 2 * x / 3, "2*x/3", "2 x/3", "\\frac{2 x}{3}" },
  { 1 / x, "1/x", "1/x", "\\frac{1}{x}" },
  { x ^ -2, "1/x^2", "1/x²", "\\frac{1}{x^{2}}" },
  { expr.lift "-3/7", "-3/7", "-3/7", "- \\frac{3}{7}" },
  { expr.zero, "0", "0", "0" },
  { sqrt(2) / 2, "sqrt(2)/2", "√(2)/2", "\\frac{\\sqrt{2}}{2}" },
  { sqrt(x + y), "sqrt(x + y)", "√(x + y)", "\\sqrt{x + y}" },
  { 1 / sqrt(x), "1/sqrt(x)", "1/√(x)", "\\frac{1}{\\sqrt{x}}" },
  { expr.pow(x, "1/3"), "x^(1/3)", "x^(1/3)", "x^{1/3}" },
  { (x + y) ^ 3, "(x + y)^3", "(x + y)³", "\\left( x + y \\right)^{3}" },
  { expr.pi * x ^ 12 / 2, "x^12*pi/2", "x¹² π/2", "\\frac{x^{12} \\pi}{2}" },
  { call("sin", 2 * x) * y, "y*sin(2*x)", "y sin(2 x)", "y \\sin\\left( 2 x \\right)" },
  { call("atan2", y, x), "atan2(y, x)", "atan2(y, x)", "\\operatorname{atan2}\\left( y, x \\right)" },
  { call("asin", x), "asin(x)", "asin(x)", "\\arcsin\\left( x \\right)" },
  { call("sign", x - y), "sign(x - y)", "sign(x - y)", "\\operatorname{sign}\\left( x - y \\right)" },
  { call("side", x), "sign(x)", "sign(x)", "\\operatorname{sign}\\left( x \\right)" },
  { call("min", y, x), "min(x, y)", "min(x, y)", "\\min\\left( x, y \\right)" },
  { call("abs", x - y), "abs(x - y)", "abs(x - y)", "\\left| x - y \\right|" },
  { x - y, "x - y", "x - y", "x - y" }, { -x - y, "-(x + y)", "-(x + y)", "- \\left( x + y \\right)" },
  { y - x, "y - x", "y - x", "y - x" },
  { z * (1 - x) - y, "z*(1 - x) - y" }, { y - z * (1 - x), "y + z*(x - 1)" },
  { -2 * x * (y - z * (1 - x)), "2*x*(z*(1 - x) - y)" },
  { expr.sym "omega_1", "omega_1", "omega_1", "\\omega_{1}" }, { expr.sym "head", "head", "head", "\\mathit{head}" },
  { expr.sym "a_b_c", "a_b_c", "a_b_c", "a_{b,c}" }, { expr.sym "m1", "m1", "m1", "m_{1}" },
  { expr.sym "rho", "rho", "rho", "\\rho" },
}
for _, s in ipairs(samples) do
  for i, style in ipairs { "plain", "unicode", "latex" } do
    if s[i + 1] then
      local got = text.of(s[1], style)
      tap.ok(got == s[i + 1], style .. ": " .. s[i + 1], got)
    end
  end
end
tap.ok(text.of(x) == text.of(x, "plain"), "plain is the style without a name")
tap.throws(function() return text.of(x, "roman") end, "unknown style roman", "another style is an error")

-- LaTeX is balanced and names only commands that there are.
do
  recipe.seed(53)
  local wrong = {}
  local known = { frac = true, left = true, right = true, sqrt = true, pi = true, sin = true, cos = true, arctan = true,
    tanh = true }
  for n = 1, 100 do
    local s = text.of(recipe.build(recipe.random(6, { roots = true, calls = true })), "latex")
    local braces, brackets, command = 0, 0, true
    for ch in s:gmatch "[{}]" do braces = braces + (ch == "{" and 1 or -1) end
    for word in s:gmatch "\\(%a+)" do
      brackets = brackets + (word == "left" and 1 or word == "right" and -1 or 0)
      command = command and known[word]
    end
    if braces ~= 0 or brackets ~= 0 or not command then wrong[#wrong + 1] = n .. ": " .. s end
  end
  tap.is(table.concat(wrong, "\n"), "", "100 expressions in LaTeX have balanced braces and only known commands")
end

-- Numbers of more than 128 bits are doubles; what a double has not stays a quotient.
do
  local root = R.apply("sqrt", 240, R.lift(14))
  for _, row in ipairs { { root, "3.7416573867739413 x" }, { -root, "-3.7416573867739413 x" },
    { R.lift(10) ^ 40, "1e+40 x" }, { R.one / R.lift(10) ^ 40, "1e-40 x" }, { R.new(1, 3), "x/3" },
    { R.new(2) ^ 100, "1267650600228229401496703205376 x" } } do
    tap.is(text.of(expr.lift(row[1]) * x, "unicode"), row[2], "a factor: " .. row[2])
  end
  tap.is(text.of(expr.lift(R.lift(10) ^ 40) * x, "latex"), "10^{40} x", "in LaTeX")
  tap.is(text.of(expr.lift(R.one / R.lift(10) ^ 40) * x, "latex"), "10^{- 40} x", "and a small one")
  tap.is(#text.of(expr.lift(R.lift(10) ^ 400) * x), 401 + 2, "10^400 is exact")
end

-- A shared graph can be astronomically long as text.
do
  local deep = x
  for _ = 1, 100 do deep = call("sin", deep + deep ^ 2) end
  local start = os.clock()
  tap.is(text.of(deep), "...", "what would be 2^100 characters is shown as dots")
  tap.ok(os.clock() - start < 1, "at once")

  -- The chain again with another number at its bottom: both are "..." for people.
  local function nodes(bottom)
    local e, put = bottom, text.nodes()
    for _ = 1, 100 do e = call("sin", e + e ^ 2) end
    return put(e) .. "\n" .. put()
  end
  start = os.clock()
  tap.is(nodes(x), nodes(x), "as nodes the same expression is the same text")
  tap.ok(nodes(2 * x) ~= nodes(3 * x) and nodes(x) ~= nodes(y) and nodes(x ^ 2) ~= nodes(x ^ 3),
    "and different ones differ, however long they are")
  local third = expr.lift(R.new(1, 3) + R.one / R.lift(10) ^ 60) * x
  tap.ok(text.of(third) == text.of(expr.lift(R.new(1, 3) + R.new(2) / R.lift(10) ^ 60) * x) and
    nodes(third) ~= nodes(expr.lift(R.new(1, 3) + R.new(2) / R.lift(10) ^ 60) * x),
    "so do numbers that people read as the same decimal")
  tap.ok(os.clock() - start < 1, "in time by the number of nodes")
end

tap.done()
