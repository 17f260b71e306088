#!/usr/bin/env lua5.4
-- fold.t: every rewrite keeps every bit, the wanted ones happen, the refused ones do not.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local fold = require "generator.ir.passes.fold"
local dce = require "generator.ir.passes.dce"
local eval = require "tests.ir.eval"
local show = require "generator.ir.core.show"
local build = require "tests.ir.build"

local inf, nan = math.huge, 0.0 / 0.0
local q = R.parse

-- What is left of one nest: the lines of its group.
local function folded(nest)
  local text = show.run(dce.run(fold.run(build.one(nest))))
  local lines = {}
  for line in string.gmatch(string.match(text, "%-%- group 1\n(.*)"), "[^\n]+") do
    lines[#lines + 1] = string.gsub(string.gsub(line, "^ +", ""), "^real ", "")
  end
  return string.gsub(table.concat(lines, "; "), "v%d+", "v")
end

-- ---- wanted --------------------------------------------------------------------------------------------------

for _, row in ipairs {
  { "x*1 ==> x", { "mul", "x", q "1" }, "store y = x" },
  { "1*x ==> x", { "mul", q "1", "x" }, "store y = x" },
  { "x*-1 ==> -x", { "mul", "x", q "-1" }, "v = neg x; store y = v" },
  { "x/1 ==> x", { "div", "x", q "1" }, "store y = x" },
  { "x/-1 ==> -x", { "div", "x", q "-1" }, "v = neg x; store y = v" },
  { "-(-x) ==> x", { "neg", { "neg", "x" } }, "store y = x" },
  { "x + (-z) ==> x - z", { "add", "x", { "neg", "z" } }, "v = sub x, z; store y = v" },
  { "(-x) + z ==> z - x", { "add", { "neg", "x" }, "z" }, "v = sub z, x; store y = v" },
  { "x - (-z) ==> x + z", { "sub", "x", { "neg", "z" } }, "v = add x, z; store y = v" },
  { "x + (-1/3) ==> x - 1/3", { "add", "x", q "-1/3" }, "v = sub x, 1/3; store y = v" },
  { "(-x)*(-z) ==> x*z", { "mul", { "neg", "x" }, { "neg", "z" } }, "v = mul x, z; store y = v" },
  { "1/3*(-x) ==> -1/3*x", { "mul", q "1/3", { "neg", "x" } }, "v = mul -1/3, x; store y = v" },
  { "x/8 ==> 1/8*x", { "div", "x", q "8" }, "v = mul 1/8, x; store y = v" },
  { "x/(1/4) ==> 4*x", { "div", "x", q "1/4" }, "v = mul 4, x; store y = v" },
  { "3*1/4 ==> 3/4", { "mul", q "3", q "1/4" }, "store y = 3/4" },
  { "1/3 of exact operands stays exact", { "div", q "1", q "3" }, "store y = 1/3" },
  { "3 - 3 ==> 0", { "sub", q "3", { "mul", q "1", q "3" } }, "store y = 0" },
  { "sqrt(9/4) ==> 3/2", { "sqrt", q "9/4" }, "store y = 3/2" },
  { "|-x| ==> |x|", { "fabs", { "neg", "x" } }, "v = fabs x; store y = v" },
} do
  tap.is(folded(row[2]), row[3], row[1])
end

-- ---- refused -------------------------------------------------------------------------------------------------

-- The law that would be broken, the nest, the point, what IEEE says there and what the rule would.
for _, row in ipairs {
  { "x + 0 ==> x", { "add", "x", q "0" }, { x = -0.0 }, 0.0, -0.0 },
  { "0 - x ==> -x", { "sub", q "0", "x" }, { x = 0.0 }, 0.0, -0.0 },
  { "x*0 ==> 0 (infinity)", { "mul", "x", q "0" }, { x = inf }, nan, 0.0 },
  { "x*0 ==> 0 (sign)", { "mul", "x", q "0" }, { x = -1.0 }, -0.0, 0.0 },
  { "x - x ==> 0", { "sub", "x", "x" }, { x = inf }, nan, 0.0 },
  { "x/x ==> 1", { "div", "x", "x" }, { x = 0.0 }, nan, 1.0 },
  { "-(a - b) ==> b - a", { "neg", { "sub", "a", "b" } }, { a = 1.0, b = 1.0 }, -0.0, 0.0 },
  { "(a + b) - b ==> a", { "sub", { "add", "a", "b" }, "b" }, { a = 1.0, b = 1e30 }, 0.0, 1.0 },
  { "(a*b)*c ==> a*(b*c)", { "mul", { "mul", "a", "b" }, "c" }, { a = 1e200, b = 1e200, c = 1e-200 }, inf, 1e200 },
  { "a*b + a*c ==> a*(b + c)", { "add", { "mul", "a", "b" }, { "mul", "a", "c" } }, { a = 3.0, b = 0.1, c = 0.3 },
    3.0 * 0.1 + 3.0 * 0.3, 3.0 * (0.1 + 0.3) },
  { "x/3 ==> x*(1/3)", { "div", "x", q "3" }, { x = 5.0 }, 5.0 / 3.0, 5.0 * (1.0 / 3.0) },
  { "1/3*3 ==> 1 (operands not exact)", { "mul", { "mul", "x", q "1/10" }, q "10" }, { x = 3.0 }, 3.0 * 0.1 * 10, 3.0 },
  { "x/2^140 ==> x*2^-140", { "div", "x", R.new(2) ^ 140 }, { x = 1.0 }, 2.0 ^ -140, nil },
} do
  local name, nest, env, ieee, otherwise = table.unpack(row, 1, 5)
  local got = eval.run(fold.run(build.one(nest)), env).y
  tap.ok(build.same(got, ieee), "refused: " .. name, "got " .. tostring(got) .. ", IEEE says " .. tostring(ieee))
  if otherwise then tap.ok(not build.same(ieee, otherwise), "and the counter-example is one: " .. name) end
end
tap.is(folded { "div", "x", R.new(2) ^ 140 }, "v = div x, ~1.3937965749081639e+42; store y = v",
  "a power of two beyond float stays a divisor")

-- ---- exhaustive ----------------------------------------------------------------------------------------------

-- All operations on all pairs of operands from lists rich in special cases, at all pairs of special values.
local operands = { "x", "z", { "neg", "x" }, { "neg", { "neg", "z" } }, { "fabs", { "neg", "z" } },
  q "0", q "1", q "-1", q "2", q "-1/2", q "3", q "1/3", q "-1/10", R.new(2) ^ 127, R.new(2) ^ -130, R.new(-10) ^ 31,
  R.new(2) ^ 130, R.new(3) * R.new(2) ^ -126 }
local values = { 0.0, -0.0, 1.0, -3.0, 0.1, inf, -inf, nan, 2.0 ^ -149, -3 * 2.0 ^ -1074, 1e38, 1.5e308 }
local wrong, irs, changed = {}, 0, 0
for _, op in ipairs { "add", "sub", "mul", "div" } do
  for _, a in ipairs(operands) do
    for _, b in ipairs(operands) do
      local ir = build.one { "neg", { op, a, b } }
      local after = fold.run(ir)
      irs = irs + 1
      local text = show.run(dce.run(after))
      if text ~= show.run(dce.run(ir)) then
        changed = changed + 1
        for _, x in ipairs(values) do
          for _, z in ipairs(values) do
            for _, real in ipairs { "double", "float" } do
              local env = { x = x, z = z }
              if not build.same(eval.run(ir, env, real).y, eval.run(after, env, real).y) then
                wrong[#wrong + 1] = string.format("%s at x=%a z=%a %s", text, x, z, real)
              end
            end
          end
        end
      end
    end
  end
end
tap.is(wrong[1], nil, string.format("%d of %d small irs fold, at no special value does a bit move", changed, irs))
tap.ok(changed > irs // 4, "and enough of them fold to matter")

tap.done()
