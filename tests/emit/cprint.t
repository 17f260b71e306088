#!/usr/bin/env lua5.4
-- cprint.t: the C text of programs: order, parentheses, literals, temporaries, line lengths.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- That the text computes what the ir computes is shown on random programs in tests/ir/oracle.t.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local expr = require "generator.algebra.expr"
local lower = require "generator.ir.lower.lower"
local passes = require "generator.ir.passes.passes"
local cprint = require "generator.emit.cprint"

local S = expr.sym

local function inputs(names)
  local list = {}
  for name in string.gmatch(names, "%S+") do
    list[#list + 1] = { sym = name, c = "x[" .. string.upper(name) .. "]" }
  end
  return list
end

-- ---- hand-made irs: parentheses -----------------------------------------------------------------------------

-- The C text of a nest of instructions: a string is an input, a rational a constant, { op, ... } the rest.
local function text(nest, real)
  local ir = { name = "f", n = 0, inputs = {}, consts = {}, groups = { { code = {} } } }
  local code, known = ir.groups[1].code, {}
  local function value(x)
    if type(x) ~= "table" and known[x] then return known[x] end
    ir.n = ir.n + 1
    local v = ir.n
    if type(x) == "string" then
      table.insert(ir.inputs, { op = "input", dst = v, sym = x, c = x })
    elseif R.is(x) then
      table.insert(ir.consts, { op = "const", dst = v, value = x })
    else
      local a = value(x[2])
      local b = x[3] and value(x[3])
      code[#code + 1] = { op = x[1], dst = v, src1 = a, src2 = b }
    end
    if type(x) ~= "table" then known[x] = v end
    return v
  end
  local v = value(nest)
  code[#code + 1] = { op = "store", src1 = v, c = "y", assign = "=" }
  local lines = cprint.statements(ir, real or "double").groups[1].lines
  return (string.gsub(table.concat(lines, "\n"), "^y = (.*);$", "%1"))
end

local half, third, minus = R.new(1, 2), R.new(1, 3), R.new(-4, 5)
for _, row in ipairs {
  { { "sub", "a", { "sub", "b", "c" } }, "a - (b - c)" },
  { { "sub", { "sub", "a", "b" }, "c" }, "a - b - c" },
  { { "add", "a", { "add", "b", "c" } }, "a + (b + c)" },
  { { "mul", "a", { "mul", "b", "c" } }, "a*(b*c)" },
  { { "mul", { "mul", "a", "b" }, "c" }, "a*b*c" },
  { { "div", { "mul", "a", "b" }, "c" }, "a*b/c" },
  { { "mul", "a", { "div", "b", "c" } }, "a*(b/c)" },
  { { "div", "a", { "mul", "b", "c" } }, "a/(b*c)" },
  { { "div", { "div", "a", "b" }, "c" }, "a/b/c" },
  { { "mul", { "add", "a", "b" }, "c" }, "(a + b)*c" },
  { { "add", { "mul", "a", "b" }, { "div", "c", "d" } }, "a*b + c/d" },
  { { "neg", "a" }, "-a" },
  { { "neg", { "mul", "a", "b" } }, "-(a*b)" },
  { { "mul", { "neg", "a" }, "b" }, "-a*b" },
  { { "mul", "a", { "neg", "b" } }, "a*(-b)" },
  { { "sub", "a", { "neg", "b" } }, "a - (-b)" },
  { { "add", "a", { "mul", { "neg", "b" }, "c" } }, "a + (-b*c)" },
  { { "neg", { "neg", "a" } }, "-(-a)" },
  { { "mul", third, "a" }, "(1.0/3.0)*a" },
  { { "add", "a", third }, "a + 1.0/3.0" },
  { { "div", "a", third }, "a/(1.0/3.0)" },
  { { "mul", minus, "a" }, "-0.8*a" },
  { { "mul", "a", minus }, "a*(-0.8)" },
  { { "sub", "a", minus }, "a - (-0.8)" },
  { { "mul", R.new(-1, 3), "a" }, "(-1.0/3.0)*a" },
  { { "neg", third }, "-(1.0/3.0)" },
  { { "sqrt", { "add", "a", half } }, "sqrt(a + 0.5)" },
  { { "atan2", "a", { "neg", "b" } }, "atan2(a, -b)" },
  { { "mul", { "sin", "a" }, { "fabs", "b" } }, "sin(a)*fabs(b)" },
} do
  tap.is(text(row[1]), row[2], "order is kept by " .. row[2])
end
tap.is(text({ "mul", third, { "sqrt", { "fabs", "a" } } }, "float"), "(1.0F/3.0F)*sqrtf(fabsf(a))",
  "float: literals end in F, functions in f")
tap.throws(function() text { "frob", "a" } end, "unknown opcode 'frob'", "an unknown opcode is loud")

-- ---- programs -------------------------------------------------------------------------------------------------

local function printed(program, real, opts)
  local c = cprint.statements(passes.run(lower.run(program)), real or "double", opts)
  local lines = {}
  for _, group in ipairs(c.groups) do
    for _, line in ipairs(group.lines) do lines[#lines + 1] = line end
  end
  return lines, c
end

local qw, qx, qy, qz = S "qw", S "qx", S "qy", S "qz"
local wx, wy, wz, h = S "wx", S "wy", S "wz", S "h"
local brick = {
  name = "brick_rhs",
  inputs = inputs "qw qx qy qz wx wy wz",
  groups = {
    { why = "attitude: q' = q (0, w) / 2", outs = {
      { c = "dx[QW]", expr = expr.num(R.new(-1, 2)) * (qx * wx + qy * wy + qz * wz) },
      { c = "dx[QX]", expr = expr.num(half) * (qw * wx + qy * wz - qz * wy) } } },
    { why = "Euler: I w' = -w x I w", where = "brick.lua:5", outs = {
      { c = "dx[WX]", expr = expr.num(R.new(5, 13)) * wy * wz },
      { c = "dx[WY]", expr = expr.num(minus) * wz * wx } } },
    { why = "nothing is needed here", defs = { { name = "unused", expr = wx * wz } } },
  },
}
table.insert(brick.inputs, { sym = "h", c = "h" })
local lines, c = printed(brick, "double", { type = "brick_real" })
tap.is(table.concat(c.loads, "\n"), [[
const brick_real qw = x[QW], qx = x[QX], qy = x[QY], qz = x[QZ];
const brick_real wx = x[WX], wy = x[WY], wz = x[WZ];]], "loads stand evenly, two to four on a line")
tap.is(table.concat(lines, "\n"), [[
dx[QW] = -0.5*(qx*wx + qy*wy + qz*wz);
dx[QX] = 0.5*(qw*wx + qy*wz - qz*wy);
dx[WX] = (5.0/13.0)*wy*wz;
dx[WY] = -0.8*wx*wz;]], "a rigid body's equations read as in a book")
tap.is(c.groups[2].why .. "|" .. c.groups[2].where, "Euler: I w' = -w x I w|brick.lua:5", "why and where pass through")
tap.is(#c.groups, 2, "a group that computes nothing is left out")

local program = {
  name = "g",
  inputs = { { sym = "h", c = "h" }, { sym = "t1", c = "p[T1]" }, { sym = "a", c = "m->a" },
    { sym = "b", c = "m->b" } },
  groups = { { why = "shared", defs = { { name = "s", expr = S "a" + S "b" }, { name = "alias", expr = S "s" } },
    outs = {
      { c = "y[0]", expr = h * S "t1" * expr.call("sin", S "alias") },
      { c = "y[1]", expr = S "s" * expr.call("sin", S "s"), op = "+=" },
      { c = "y[2]", expr = expr.num(3) } } } },
}
lines, c = printed(program)
tap.is(table.concat(c.loads, "\n"), "const double t1 = p[T1];\nconst double a = m->a, b = m->b;",
  "arguments are not loaded, arrays are not mixed on a line")
tap.is(table.concat(lines, "\n"), [[
const double s = a + b;
const double t2 = sin(s);
y[0] = h*t1*t2;
y[1] += s*t2;
y[2] = 3.0;]], "names stay, an alias goes, temporaries avoid names that are taken")

-- ---- length and nesting -----------------------------------------------------------------------------------------

local long = { name = "long", inputs = {}, groups = { { why = "long", outs = {} } } }
local terms, nest = {}, S "angular_velocity_1"
for k = 1, 24 do
  local sym = "angular_velocity_" .. k
  long.inputs[k] = { sym = sym, c = "state[LONG_NAME_OF_A_BODY_ANGULAR_VELOCITY_" .. k .. "]" }
  terms[k] = expr.num(R.new(k, 7)) * S(sym) * S("angular_velocity_" .. k % 24 + 1)
  nest = 1 / (S(sym) + expr.call("sin", nest))
end
long.groups[1].outs[1] = { c = "derivative[LONG_NAME_OF_A_BODY_RESULT_1]", expr = expr.add(terms) }
long.groups[1].outs[2] = { c = "derivative[LONG_NAME_OF_A_BODY_RESULT_2]", expr = nest }
for _, real in ipairs { "double", "float" } do
  lines, c = printed(long, real, { type = "long_name_of_a_body_real" })
  local widest, deepest = 0, 0
  for _, list in ipairs { lines, c.loads } do
    for _, line in ipairs(list) do
      widest = math.max(widest, #line + 2)
      local depth = 0
      for p in string.gmatch(line, "[()]") do
        depth = depth + (p == "(" and 1 or -1)
        deepest = math.max(deepest, depth)
      end
    end
  end
  tap.ok(widest <= 100, real .. ": no line passes 100 columns", "widest " .. widest)
  tap.ok(deepest <= 4, real .. ": no more than 4 parentheses are open at once", "deepest " .. deepest)
  local body = table.concat(lines, "\n")
  local count = 0
  for name in string.gmatch(body, "const %S+ t(%d+) =") do
    count = count + 1
    if tonumber(name) ~= count then count = -1000 end
  end
  tap.ok(count > 3, real .. ": temporaries are numbered in order of appearance")
end
tap.ok(not string.find(table.concat(lines, "\n"), "%d%.%d+[^%dF]"), "float: not one literal is a double")

tap.is(table.concat(printed(long), "\n"), table.concat(printed(long), "\n"), "the same program prints the same bytes")

tap.done()
