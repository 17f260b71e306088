#!/usr/bin/env lua5.4
-- handout_formula.t - the hand-out's formulas, as LaTeX and as MathML, read back to the values of their expressions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/algebra/reader.lua computes with rationals from the text; coefficients of many digits are constants c_n there.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local reader = require "tests.algebra.reader"
local recipe = require "tests.algebra.recipe"
local evaluate = require "generator.algebra.evaluate"
local formula = require "generator.report.handout.formula"
local latex = require "generator.formula.latex"
local mathml = require "generator.formula.mathml"
local setting = require "generator.formula.setting"
local symbols = require "generator.formula.symbols"

local A = reader.exact(recipe.bits)
recipe.seed(55)
for _, family in ipairs {
  { name = "rational functions", make = function() return recipe.random(6, {}) end },
  { name = "sums in sums of either sign", make = function() return recipe.signs(3) end },
} do
  local wrong, fine = {}, 0
  for n = 1, 200 do
    local e = recipe.build(family.make())
    local at, w = recipe.point(), formula.new(symbols.new(recipe.names))
    local node, want = w:of(e), evaluate.exact(e, at)
    for i, c in ipairs(w.constants) do at["c_" .. i] = c.value end
    for _, t in ipairs { { "latex", latex }, { "mathml", mathml } } do
      local text = setting.of(t[2], node)
      local ok, got = pcall(reader.value, text, at, A, t[1])
      local same = ok and got == want
      fine = same and fine + 1 or fine
      if not same then wrong[#wrong + 1] = n .. ": " .. text .. " (" .. tostring(got) .. ")" end
    end
  end
  tap.ok(fine == 400, "200 " .. family.name .. ": their values, exactly, in both forms", wrong[1])
end

tap.done()
