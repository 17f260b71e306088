#!/usr/bin/env lua5.4
-- rounding.t: the bound that headers state on the error of rates, energy and momentum holds, and is not idle.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The instructions of each function run in double or float arithmetic, in exact rationals, and in sums of absolute
-- values; inputs spread over 2^-20 to 2^20, so that terms of all sizes cancel.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local build = require "tests.ir.build"
local eval = require "tests.ir.eval"
local random = require "tests.ir.random"
local scene = require "tests.scene"
local instr = require "generator.ir.core.instr"
local rounding = require "generator.ir.core.rounding"
local source = require "generator.emit.source"

local EPSILON = { double = R.new(2) ^ -52, float = R.new(2) ^ -23 }

-- ---- the law's cases, counted by hand ----

local function k_of(nest, real) return rounding.run(build.one(nest), real or "double") end
local CASES = {
  { 0, "a", "a number" }, { 0, { "neg", "a" }, "a sign is free" },
  { 1, { "add", "a", "b" }, "a + b" }, { 2, { "mul", "a", { "add", "b", "c" } }, "a (b + c)" },
  { 3, { "mul", { "add", "a", "b" }, { "sub", "b", "c" } }, "(a + b) (b - c): one factor from each" },
  { 2, { "add", { "mul", "a", "b" }, "c" }, "a b + c" },
  { 2, { "div", { "add", "a", "b" }, "c" }, "(a + b)/c" },
}
for _, case in ipairs(CASES) do tap.is(k_of(case[2]), case[1], case[3]) end
tap.is(k_of { "div", "a", { "add", "b", "c" } }, nil, "a/(b + c): none, for the sum may cancel")
tap.is(k_of { "sin", "a" }, nil, "sin: none")

-- ---- the functions of scenes ----

-- Exact values and sums of absolute values of what is stored; nil where a quotient has no value.
local function exact(ir, env)
  local value, size, stored = {}, {}, {}
  local function keep(i, x, a) value[i.dst], size[i.dst] = x, a end
  instr.each(ir, function(i)
    local x, y, a, b = value[i.src1], value[i.src2], size[i.src1], size[i.src2]
    if i.op == "input" then
      keep(i, R.fromdouble(env[i.sym]), R.fromdouble(math.abs(env[i.sym])))
    elseif i.op == "const" then
      keep(i, i.value, i.value < R.new(0) and -i.value or i.value)
    elseif i.op == "neg" then
      keep(i, -x, a)
    elseif i.op == "add" then
      keep(i, x + y, a + b)
    elseif i.op == "sub" then
      keep(i, x - y, a + b)
    elseif i.op == "mul" then
      keep(i, x * y, a * b)
    elseif i.op == "div" then
      keep(i, x / y, a / b)
    elseif i.op == "store" then
      stored[#stored + 1] = { to = i.c, value = x, size = a }
    else
      error("no exact value of " .. i.op)
    end
  end)
  return stored
end

-- A number of either sign, its exponent within 20 of 0, that is one of the type.
local function number(real)
  local x = (random.int(2^24 - 1) + 0.0) * 2.0 ^ (random.int(40) - 44)
  if random.int(2) == 1 then x = -x end
  return real == "float" and eval.float(x) or x
end

random.seed(20261123)
for _, body in ipairs { "brick_centroid", "cube_corner", "gyrostat", "wheels", "heavy_top" } do
  for _, real in ipairs { "double", "float" } do
    local plan = scene.plan(scene.file("bodies/" .. body .. ".lua"), { real = real })
    local ctx, worst, held, seen = source.context(plan), 0, true, 0
    for _, f in ipairs(plan.functions) do
      if f.name == "rhs" or f.name == "energy" or f.name == "momentum" then
        local ir = source.make(ctx, f).ir
        local k = rounding.run(ir, real)
        seen = seen + (k and 1 or 0)
        for _ = 1, k and 200 or 0 do
          local env = {}
          for _, i in ipairs(ir.inputs) do env[i.sym] = number(real) end
          local got = eval.run(ir, env, real)
          for _, o in ipairs(exact(ir, env)) do
            local error = R.fromdouble(got[o.to]) - o.value
            if error < R.new(0) then error = -error end
            local bound = R.new(k, 2) * EPSILON[real] * o.size
            -- k u/(1 - k u) is k u to a part in 10^6 in float
            held = held and error <= bound * R.new(1000001, 1000000)
            if bound > R.new(0) then worst = math.max(worst, R.todouble(error / bound)) end
          end
        end
      end
    end
    tap.ok(held and seen >= 2, string.format("%s, %s: within the bound of %d functions", body, real, seen))
    tap.ok(worst > 0.05, "which errors come near", worst)
  end
end

tap.done()
