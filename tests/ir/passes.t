#!/usr/bin/env lua5.4
-- passes.t: the instruction table, power, cse, dce, order, the pass list, show and count.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- fold has its own test; that no pass moves a bit on random programs is shown in oracle.t.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local instr = require "generator.ir.core.instr"
local power = require "generator.ir.passes.power"
local cse = require "generator.ir.passes.cse"
local dce = require "generator.ir.passes.dce"
local order = require "generator.ir.passes.order"
local passes = require "generator.ir.passes.passes"
local count = require "generator.ir.core.count"
local show = require "generator.ir.core.show"
local eval = require "tests.ir.eval"
local build = require "tests.ir.build"

-- ---- the table --------------------------------------------------------------------------------------------------

tap.is(table.concat(instr.of("sub").srcs, " "), "src1 src2", "operands follow from the field names")
tap.is(table.concat(instr.of("powi").immediates, " "), "n", "what is neither src nor dst is an immediate")
tap.is(table.concat(instr.of("store").srcs, " "), "src1", "a store reads one value and defines none")
local bad = build.one { "add", "x", "y" }
bad.groups[1].code[1].op = "fma"
local has = {}
for _, pass in ipairs(passes.list) do has[pass.name] = true end
for _, name in ipairs { "power", "fold", "cse", "dce", "order", "show", "count", "eval" } do
  local room = name == "eval" and "tests.ir." or has[name] and "generator.ir.passes." or "generator.ir.core."
  local run = require(room .. name).run
  tap.throws(function() run(bad, name == "eval" and { x = 1, y = 2 } or nil) end, "unknown opcode 'fma'",
    name .. ": an unknown opcode is loud")
end

-- ---- power --------------------------------------------------------------------------------------------------------

local function muls(ir) return count.run(passes.run(ir)).mul end

for n, want in ipairs { 0, 1, 2, 2, 3, 3, 4, 3, 4, 4, 5, 4, 5, 5, 6, 4 } do
  if n > 1 then
    local ir = build.one { "powi", "x", n = n }
    tap.is(muls(ir), want, "x^" .. n .. " takes " .. want .. " multiplications")
    tap.is(count.run(ir).mul, want, "and is counted so before the power pass: x^" .. n)
  end
end
tap.is(muls(build.ir { { { "a", { "powi", "x", n = 2 } }, { "b", { "powi", "x", n = 3 } },
  { "c", { "powi", "x", n = 4 } }, { "d", { "powi", "x", n = 6 } } } }), 4, "x^2, x^3, x^4, x^6 take one each")
tap.is(muls(build.ir { { { "d", { "powi", "x", n = 6 } }, { "a", { "powi", "x", n = 3 } } } }), 3,
  "a power that was a step of a higher one is not computed again")
do
  local wrong = {}
  for n = 2, 40 do
    local ir = build.one { "powi", "x", n = n }
    for _, real in ipairs { "double", "float" } do
      for _, x in ipairs { 1.1, -0.7, 0.0, -0.0, math.huge, 1e30, 3.0 } do
        local env = { x = x }
        local before, after = eval.run(ir, env, real).y, eval.run(power.run(ir), env, real).y
        if not build.same(before, after) then wrong[#wrong + 1] = n .. " " .. x .. " " .. real end
      end
    end
    -- 3^n is exact up to 3^33: the chain computes a power, not something else
    if n <= 33 and eval.run(ir, { x = 3.0 }).y ~= 3.0 ^ n then wrong[#wrong + 1] = "3^" .. n end
  end
  tap.is(table.concat(wrong, ", "), "", "x^2 to x^40 keep their bits when unrolled")
end
tap.throws(function() power.run(build.one { "powi", "x", n = -1 }) end, "below 2", "a negative power is refused")

-- ---- cse ------------------------------------------------------------------------------------------------------------

local function after(pass, ir)
  local text = show.run(pass(ir))
  return (string.gsub(string.gsub(text, "^[^\n]*\n", ""), "real ", ""))
end

tap.is(count.run(cse.run(build.ir { { { "a", { "mul", "x", "y" } }, { "b", { "mul", "y", "x" } } } })).mul, 1,
  "cse: x*y is y*x")
tap.is(count.run(cse.run(build.ir { { { "a", { "sub", "x", "y" } }, { "b", { "sub", "y", "x" } } } })).add, 2,
  "cse: x - y is not y - x")
tap.is(count.run(cse.run(build.ir { { { "a", { "add", { "add", "x", "y" }, "z" } },
  { "b", { "add", "x", { "add", "y", "z" } } } } })).add, 4, "cse: (x + y) + z is not x + (y + z)")
tap.is(count.run(cse.run(build.ir { { { "a", { "sin", { "add", "x", "y" } } },
  { "b", { "sin", { "add", "y", "x" } } } } })).call, 1, "cse: equal operands make equal calls")
do
  local text = after(cse.run, build.ir {
    { { "a", { "mul", "x", "y" } } },
    { { "b", { "mul", "y", "x", name = "P" } }, { "c", { "neg", { "mul", "x", "y", name = "Q" } } } } })
  tap.like(text, "P = mul x, y", "cse: the survivor takes over a name")
  tap.ok(not string.find(text, "Q"), "cse: of two names the first stays")
end
do
  local ir = build.one { "mul", "x", R.new(2) }
  table.insert(ir.consts, { op = "const", dst = instr.fresh(ir), value = R.new(4, 2) })
  tap.is(#cse.run(ir).consts, 1, "cse: equal constants are one")
end

-- ---- dce ------------------------------------------------------------------------------------------------------------

do
  local ir = build.ir { { { nil, { "mul", { "sin", "u" }, R.new(3), name = "unused" } },
    { "a", { "add", "x", "y" } } } }
  local clean = dce.run(ir)
  tap.is(after(function(i) return i end, clean), [[
  x = input x
  y = input y

  -- group 1
  v7 = add x, y
  store a = v7
]], "dce: what no store needs goes, its inputs and constants with it")
  tap.is(#ir.inputs, 3, "dce: the old ir is as it was")
end

-- ---- order ----------------------------------------------------------------------------------------------------------

do
  local shared = { "mul", "x", "y" }
  local late = { "add", "x", "z" }
  local ir = build.ir { { { nil, late }, { nil, shared }, { "a", { "neg", "x" } }, { "b", { "neg", shared } } },
    { { "c", { "mul", late, { "sub", shared, { "sin", "z", name = "S" } } } } } }
  tap.is((string.gsub(after(order.run, ir), "^.-\n\n", "")), [[
  -- group 1
  v6 = neg x
  store a = v6
  v5 = mul x, y
  v7 = neg v5
  store b = v7

  -- group 2
  S = sin z
  v3 = add x, z
  v9 = sub v5, S
  v10 = mul v3, v9
  store c = v10
]], "order: just before the first need, in the first group that needs it; names and stores stay put")
  local once = show.run(order.run(ir))
  tap.is(show.run(order.run(order.run(ir))), once, "order: a second run changes nothing")
  table.remove(ir.groups[1].code, 2)
  tap.throws(function() order.run(ir) end, "never defined", "order: a value without definition is loud")
end

-- ---- the list -------------------------------------------------------------------------------------------------------

do
  local ir = build.one { "mul", { "powi", "x", n = 3 }, R.new(1) }
  tap.is(passes.run(ir, "lower"), ir, "passes: stopping after lower is no pass at all")
  tap.is(count.run(passes.run(ir, "power")).mul, 3, "passes: stop after power")
  tap.is(count.run(passes.run(ir, "fold")).mul, 2, "passes: stop after fold")
  tap.throws(function() passes.run(ir, "inline") end, "no pass 'inline'", "passes: an unknown pass is loud")
  local names = {}
  for _, pass in ipairs(passes.list) do names[#names + 1] = pass.name end
  tap.is(table.concat(names, " "), "power fold cse dce order", "passes: the order is this list")
end

-- ---- show and count --------------------------------------------------------------------------------------

tap.is(show.run(build.ir { { why = "Euler", where = "brick.lua:5",
  { "dx[0]", { "mul", R.new(5, 13), { "mul", "wy", "wz" } } },
  { "e", { "powi", { "add", "wy", R.apply("pi", 256), name = "s" }, n = 3 }, assign = "+=" } } }, "float"), [[
ir f: float, 8 values
  float wy = input wy
  float wz = input wz

  -- Euler    [brick.lua:5]
  float v4 = mul wy, wz
  float v5 = mul 5/13, v4
  store dx[0] = v5
  float s = add wy, ~3.1415926535897931
  float v8 = powi s, 3
  store e += v8
]], "show: one instruction a line, typed, under the comment of its group")
do
  local t = count.run(build.one { "add", { "sub", "x", { "neg", "y" } },
    { "div", { "sqrt", "x" }, { "mul", { "fabs", "y" }, { "sin", "x" } } } })
  tap.is(string.format("%d %d %d %d %d", t.add, t.mul, t.div, t.sqrt, t.call), "2 1 1 1 1",
    "count: a subtraction is an add, neg and fabs are free")
end

tap.done()
