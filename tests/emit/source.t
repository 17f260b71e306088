#!/usr/bin/env lua5.4
-- source.t - function descriptions as C: prototypes, loads, comments, results, guards.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local compiled = require "tests.ir.compiled"
local expr = require "generator.algebra.expr"
local state = require "generator.dynamics.state"
local source = require "generator.emit.source"

local function context(real, name)
  name = name or "toy"
  return { name = name, upper = name:upper(), real = real or "double", members = { { name = "I1" }, { name = "c" } },
    states = state.known, inputs = state.inputs }
end

local wx, wy = expr.sym("wx", 8), expr.sym("wy", 8)
local I1, ux, t, h = expr.sym("I1", 3), expr.sym("ux", 8), expr.sym("t", 8), expr.sym("h", 6)

local function description(outs, more)
  local f = { name = "f", args = { "m", "x", { name = "out", count = 2, out = true } }, doc = { "Doc." },
    groups = { { why = "a law", where = "toy.lua:3", defs = {}, outs = outs } } }
  for k, v in pairs(more or {}) do f[k] = v end
  return f
end

local function text(f, ctx)
  local made = source.make(ctx or context(), f)
  return made.head .. "\n{\n" .. table.concat(made.lines, "\n") .. "\n}", made
end

-- ---- arguments ----

do
  local code, made = text(description { { array = "out", index = 0, expr = I1 * wx } })
  tap.is(made.declaration, "void toy_f(const toy_model *m, const toy_real x[], toy_real out[2]);",
    "the prototype: model and state are const, results are not")
  tap.like(code, "/* a law [toy.lua:3] */", "a group's comment is its law and the scene's line")
  tap.like(code, "out[0] = ", "results go to their array")
  tap.ok(not code:find("m->c", 1, true) and not code:find("TOY_WY", 1, true), "what is not used is not loaded")
  tap.is(made.cost.mul, 1, "the cost counts the multiplication")

  code = text(description { { array = "out", index = 0, expr = expr.one } })
  tap.ok(code:find("(void)m;", 1, true) and code:find("(void)x;", 1, true), "arguments without use are voided")
  tap.ok(not code:find("(void)out;", 1, true), "and only those")

  code = text(description({ { result = true, expr = I1 * wx ^ 2 / 2 } }, { result = true, args = { "m", "x" } }))
  tap.like(code, "toy_real toy_f(const toy_model *m, const toy_real x[])", "a function with a result has the real type")
  tap.like(code, "return ", "and returns it")

  code = text(description({ { result = true, expr = I1 + t + h + ux } },
    { result = true, args = { "m", "t", "u", "h" } }))
  tap.ok(code:find("u[TOY_UX]", 1, true) and code:find("m->I1", 1, true),
    "inputs are read by their enumerator, constants from the model")
  tap.ok(not code:find "toy_real t = t" and not code:find "toy_real h = h", "scalars are used as they come")

  local _, long = text(description({ { array = "out", index = 0, expr = wx } }, { args = { "x",
    { name = "first", count = 3 }, { name = "second", count = 3 }, { name = "third", count = 3 },
    { name = "fourth", count = 3 }, { name = "out", count = 2, out = true } } }))
  local widest = 0
  for line in (long.declaration .. "\n"):gmatch "([^\n]*)\n" do widest = math.max(widest, #line) end
  tap.ok(widest <= 100 and long.declaration:find "\n           +const",
    "a long prototype goes on under its first argument", long.declaration)
end

-- ---- real types ----

do
  local e = expr.sqrt(1 + wx ^ 2) / 3 + expr.call("sin", wy) * expr.lift "0.1"
  local single = text(description { { array = "out", index = 0, expr = e } }, context "float")
  tap.ok(single:find "sqrtf%(" and single:find "sinf%(" and not single:find "sqrt%(" and not single:find "sin%(",
    "float calls the float functions")
  for literal in single:gmatch "%f[%w_.]%d+%.%d*[eE]?[-+]?%d*[%a]?" do
    tap.like(literal, "F$", "float literal " .. literal .. " has its suffix", true)
  end
  local double = text(description { { array = "out", index = 0, expr = e } })
  tap.ok(double:find "sqrt%(" and not double:find "%dF", "double has neither suffixes nor float functions")
end

-- ---- results may overlap arguments ----

do
  -- swap two rates in place: correct only if everything is read before the first result is written
  local f = { name = "swap", args = { "m", "x!" }, doc = { "Swap." }, groups = { { why = "swap", defs = {},
    outs = { { array = "x", state = "wx", expr = wy }, { array = "x", state = "wy", expr = wx } } },
    { why = "later group", defs = {}, outs = { { array = "x", state = "wz", expr = wx - wy } } } } }
  local made = source.make(context(), f)
  local numbers = compiled.numbers("#include <stdio.h>\ntypedef double toy_real;\n" ..
    "enum { TOY_QW, TOY_QX, TOY_QY, TOY_QZ, TOY_WX, TOY_WY, TOY_WZ };\ntypedef struct { double I1, c; } toy_model;\n" ..
    "static " .. made.declaration .. "\n" .. "static " .. made.head .. "\n{\n" .. table.concat(made.lines, "\n") ..
    "\n}\nint main(void)\n{\n  double x[7] = {0, 0, 0, 0, 3.5, 5.25, 0};\n  toy_model m = {1, 2};\n" ..
    "  toy_swap(&m, x);\n  printf(\"%.17e %.17e %.17e\\n\", x[4], x[5], x[6]);\n  return 0;\n}\n")
  tap.ok(numbers[1] == 5.25 and numbers[2] == 3.5 and numbers[3] == -1.75,
    "all inputs are read before the first result is written: a swap in place works")
end

-- ---- definitions, guards, comments ----

do
  local L = expr.sym("Lx", 7)
  local f = description { { array = "out", index = 0, expr = L * wy } }
  f.groups[1].defs = { { name = "Lx", expr = I1 * wx }, { name = "Ly", expr = I1 * wy } }
  local code = text(f)
  tap.like(code, "const toy_real Lx = ", "a definition becomes a const local with its name")
  tap.ok(not code:find("Ly", 1, true), "a definition without use vanishes")

  f = description({ { array = "out", index = 0, expr = wx / h } }, { args = { "x", "h",
    { name = "out", count = 2, out = true } }, guard = "h" })
  tap.like(text(f), "if (h > -2.2250738585072014e-308 && h < 2.2250738585072014e-308) return;",
    "a guard returns before the division, below the smallest normal number")
  tap.like(text(f, context "float"), "if (h > -1.1754944e-38F && h < 1.1754944e-38F) return;",
    "in float below the smallest normal float")

  local words = string.rep("word ", 40)
  local lines = source.comment(words)
  tap.ok(#lines > 1 and lines[1]:find "^/%*" and lines[#lines]:find "%*/$", "a long comment is broken into lines")
  local joined = table.concat(lines, " "):gsub("[%s/*]+", " ")
  tap.is(select(2, joined:gsub("word", "")), 40, "and keeps its words")
  for _, line in ipairs(lines) do
    if #line > 100 then tap.ok(false, "a comment's line has at most 100 columns", line) end
  end
  tap.throws(function() source.make(context(), description({}, { args = { "nonsense" } })) end,
    "unknown argument word nonsense", "an argument word that nobody knows is an error")
end

tap.done()
