#!/usr/bin/env lua5.4
-- quotients.t: products over one denominator share one division, and keep their value.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Random groups of f p/D, f q/D, ... as the tensors of composite bodies are; every result lies within the running
-- error
-- bound of the exact value (running.lua), and the divisions are counted.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local count = require "generator.ir.core.count"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local lower = require "generator.ir.lower.lower"
local passes = require "generator.ir.passes.passes"
local random = require "tests.ir.random"
local running = require "tests.ir.running"

local names = { "M", "a", "b", "c", "d", "h", "x" }
local s, inputs = {}, {}
for k, name in ipairs(names) do
  s[name] = expr.sym(name)
  inputs[k] = { sym = name, c = name }
end
local M, a, b, c, d, h, x = s.M, s.a, s.b, s.c, s.d, s.h, s.x

local function program(list)
  local outs = {}
  for k, e in ipairs(list) do outs[k] = { c = "r" .. k, expr = e } end
  return { name = "f", inputs = inputs, groups = { { why = "test", outs = outs } } }
end

local function run(list) return passes.run(lower.run(program(list))) end

-- Is every result within its bound, at positive points?
local function holds(list, ir)
  for _ = 1, 4 do
    local point, env = {}, {}
    for _, name in ipairs(names) do
      point[name] = (1 + random.int(1000)) / 64
      env[name] = R.fromdouble(point[name])
    end
    local got, bound = running.run(ir, point)
    for k, e in ipairs(list) do
      local want = evaluate.precise(e, env, 200)
      if R.abs(R.fromdouble(got["r" .. k]) - want) > R.fromdouble(bound["r" .. k]) then return false end
    end
  end
  return true
end

random.seed(5)
for _, case in ipairs {
  { "one numerator factor", { M * a / (b + c), M * d / (b + c) }, 1 },
  { "three products", { M * a / (b + c), M * d / (b + c), M * h / (b + c) }, 1 },
  { "the quotient itself is there", { M / (b + c), M * d / (b + c) }, 1 },
  { "sums above", { M * (a ^ 2 + b ^ 2) / (b + c), M * (a ^ 2 + d ^ 2) / (b + c) }, 1 },
  { "a factor before it", { 3 * M * a / (4 * (b + c)), 5 * M * d / (7 * (b + c)) }, 1 },
  { "two denominators, two divisions", { M * a / (b + c), M * d / (b + c), M * a / (b + d), M * h / (b + d) }, 2 },
  { "products below", { M * a / (x * (b + c)), M * d / (x * (b + c)) }, 1 },
  { "nothing above but M: one division", { M / (b + c), 2 * M / (b + c) }, 1 },
} do
  local ir = run(case[2])
  tap.is(count.run(ir).div, case[3], case[1] .. ": divisions")
  tap.ok(holds(case[2], ir), case[1] .. ": values")
end
do -- nothing in common above: each has its own division, and the reciprocal is not formed for two
  local list = { a / (b + c), d / (b + c) }
  local ir = run(list)
  tap.ok(count.run(ir).div <= 2 and holds(list, ir), "different numerators: values")
end

do
  local wrong, divisions, products = {}, 0, 0
  for n = 1, 60 do
    local below = { b + c, b + d * n, x * (h + c) }
    local list = {}
    for k = 1, 2 + random.int(4) do
      local above = random.int(2) == 1 and M or a
      list[k] = above * s[names[random.int(7)]] * (s[names[random.int(7)]] + 1) / below[random.int(3)]
    end
    local ir = run(list)
    divisions, products = divisions + count.run(ir).div, products + #list
    if not holds(list, ir) then wrong[#wrong + 1] = n end
  end
  tap.is(table.concat(wrong, " "), "", "60 random groups keep their values")
  tap.ok(divisions < products, "and divide less often than they have quotients", divisions .. " for " .. products)
end

tap.done()
