#!/usr/bin/env lua5.4
-- handout.t - the printed explanation: symbols, names that clash, numbers, sections, and every effect.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local effects = require "generator.effects.effects"
local formulas = require "generator.report.handout.effects"
local linear = require "generator.formula.linear"
local read = require "generator.formula.read"
local setting = require "generator.formula.setting"
local tree = require "generator.formula.tree"

local program = os.getenv "POLHODE" or "build/polhode"

local function run(command)
  local pipe = assert(io.popen(program .. " " .. command .. " 2>&1"))
  local text = pipe:read "a"
  return text, select(3, pipe:close())
end

local scene = os.tmpname()
local function of(text, options)
  local file = assert(io.open(scene, "w"))
  file:write(text)
  file:close()
  return run("explain " .. scene .. " --format latex " .. (options or ""))
end
local function has(text, part, name) tap.ok(string.find(text, part, 1, true), name .. ": " .. part) end
local function lacks(text, part, name) tap.ok(not string.find(text, part, 1, true), name .. ": no " .. part) end

-- ---- notation ----

local styles = {}
for _, format in ipairs { "latex", "html", "typst", "markdown" } do
  styles[format] = require("generator.report.handout." .. format).style
end
local function set(format, text) return setting.of(styles[format], read.of(text)) end
tap.is(set("latex", "~L = I ~omega'"), "\\vct{L} = I \\dot{\\vct{\\omega}}", "LaTeX: vectors and dots")
tap.is(set("markdown", "~L"), "\\boldsymbol{L}", "Markdown knows no macro of ours")
tap.is(set("typst", "{1|2} omega_1^2"), "frac(1, 2) omega_(1)^(2)", "Typst: quotients, indices, powers")
tap.is(set("html", "a x b"), "<mrow><mi>a</mi><mo>×</mo><mi>b</mi></mrow>", "MathML: the vector product")
tap.is(set("latex", "sqrt({a|b} + c^2)"), "\\sqrt{\\frac{a}{b} + c^{2}}", "a root of a quotient and a square")
tap.is(set("latex", "{2 sqrt(a b)|c}"), "\\frac{2 \\sqrt{a b}}{c}", "a quotient with a root")
tap.is(set("typst", "sqrt(a b)"), "sqrt(a b)", "Typst: roots")
for _, case in ipairs { { "{2 pi||a|}", "2 pi/|a|" }, { "- c |~a| ~a", "-c |a| a" }, { "{a - b|c} d", "(a - b) d/c" },
  { "a ( b x ( c x d ) ) . e", "a (b x (c x d)).e" }, { "sin^2(a) + cn(u)", "sin(a)^2 + cn(u)" }, { "a(0)", "a(0)" },
  { "h x", "h x" }, { "a^{1/2} b/c", "a^(1/2) b/c" }, { "~L' = ~N \"or\" x", "L' = N  or  x" } } do
  tap.is(setting.of(linear.ascii, read.of(case[1])), case[2], "in a line: " .. case[1])
end
for _, wrong in ipairs { "phi'_fast", "x_1_2", "%", "{a|b", "( a", "a )", "+", "", "a = + ", "|a" } do
  tap.is(select(2, pcall(read.of, wrong)), "no formula: " .. wrong, wrong .. " is not set as it stands")
end
tap.is(setting.of(styles.latex, tree.number(-9.654980288e-5, 5, "kg m^2")),
  "- 9.655 \\times 10^{- 5} \\, \\mathrm{kg\\,m^{2}}", "numbers: five digits, a power of ten, thin spaces")

-- ---- names ----

local clash = of [[
local M, I1 = param("M", 2, "kg"), param("I1", 0.1, "m")
return scene { name = "three", body = solid.box { x = I1, y = 2*I1, z = 3*I1, mass = 3*M } }]]
has(clash, "\nm & = 3 M = 6", "a parameter M and another mass: the mass is m")
lacks(clash, "M & = 3 M", "and never its own multiple")
has(clash, "The scene calls a quantity $M$; the mass is therefore written $m$.", "it is said")
has(clash, "The scene calls a quantity $I_{1}$; a principal moment is therefore written $A$.", "and of the moments")
has(clash, "A_{1} \\dot{\\omega}_{1}", "Euler's equations in the letter that is left")
lacks(clash, "I_{1} \\dot", "and not in that of the parameter")

local brick = run "explain bodies/brick.lua --format latex"
has(brick, "I & = M \\begin{pmatrix} \\frac{b^{2} + c^{2}}{3} & - \\frac{a b}{4} & - \\frac{a c}{4} \\\\",
  "the tensor is one matrix, the common factor before it")
has(brick, "T & = \\frac{1}{2} \\left( \\vct{\\omega} \\cdot I \\vct{\\omega} \\right)", "kinetic energy")
lacks(brick, "Ixx", "no name of the code")
lacks(brick, "\\mathit{wx}", "no state of the code")
lacks(brick, "calls", "nothing of processors")

-- ---- numbers ----

local long = of [[
return scene { name = "digits", body = solid.sphere { r = 0.123456789, mass = 1 },
  effects = { effect.rotor { axis = {1, 1, 0}, momentum = 0.5 } } }]]
for number in string.gmatch(long, "%d+") do
  if #string.gsub(number, "^0+", "") > 17 then
    tap.ok(false, "more than 17 digits: " .. number)
    break
  end
end
tap.ok(#long > 1000, "a body with long numbers is explained")

-- ---- terms of a turning frame ----

local frame = of [[
return scene { name = "frame", body = solid.sphere { r = 0.1, mass = 2 },
  effects = { effect.rotating_frame { rate = {0, 0, 3}, rate_dot = {0, 0, 0.5} } },
  initial = { position = {1, 0, 0} }, }]]
for _, line in ipairs { "F_{\\mathrm{Coriolis},x}", "F_{\\mathrm{centrifugal},x}", "F_{\\mathrm{Euler},x}" } do
  has(frame, line, "a term of its own")
end
has(frame, "centripetal acceleration $\\vct{\\Omega} \\times \\left( \\vct{\\Omega} \\times \\vct{r} \\right)$",
  "w x (w x r) is centripetal")

-- ---- sections ----

local some = of([[return scene { name = "s", body = solid.box { x = 1, y = 2, z = 3, mass = 1 } }]],
  "--sections tensor,euler")
has(some, "\\heading*{Mass and tensor of inertia}", "a section that was asked for")
has(some, "\\heading*{Equations of motion}", "and the other one")
lacks(some, "Stability", "not one that was not")
has(run "explain bodies/brick.lua --format html --sections costs", "Operations of the emitted functions",
  "costs on demand")
for _, case in ipairs {
  { "--format latex --sections tenser", "did you mean tensor?" },
  { "--sections tensor", "--format must be markdown, latex, html or typst, got text" },
  { "--format json --sections tensor", "got json" },
  { "--format latex --sections tensor,tensor", "tensor stands there twice" },
} do
  local said, status = run("explain bodies/brick.lua " .. case[1])
  has(said, case[2], case[1])
  tap.is(status, 2, case[1] .. ": status 2")
end

-- ---- title, author, date ----

for _, case in ipairs { { "latex", "\\section*{A \\& B}\n\\par C\\_D, 1. 2." },
  { "markdown", "# A & B\n\nC\\_D, 1. 2.\n" },
  { "typst", "= A & B\nC\\_D, 1. 2.\n" }, { "html", "<h1>A &amp; B</h1>\n<p>C_D, 1. 2.</p>" } } do
  has(run("explain bodies/brick.lua --title 'A & B' --author C_D --date '1. 2.' --format " .. case[1]), case[2],
    case[1])
end
has(run "explain bodies/brick.lua --date May --format latex", "\\section*{brick}\n\\par May\n", "a date alone")
for _, case in ipairs {
  { "bodies/brick.lua --title T", "--title: --format must be markdown, latex, html or typst, got text" },
  { "bodies/brick.lua --author T --format json", "--author: --format must be markdown, latex, html or typst, got" },
  { "bodies/brick.lua --date T --format urdf", "--date: --format must be markdown, latex, html or typst, got urdf" },
  { "bodies/brick.lua --title '' --format latex", "must not be empty" },
  { "--diff bodies/brick.lua bodies/coin.lua --title T", "--title: a difference is no hand-out" },
} do
  local said, status = run("explain " .. case[1])
  has(said, case[2], case[1])
  tap.is(status, 2, case[1] .. ": status 2")
end

-- ---- every effect, every body ----

for _, e in ipairs(effects) do
  tap.ok(formulas[e.name], e.name .. " has its formula in handout/effects.lua")
  for _, formula in ipairs(formulas[e.name] or {}) do
    tap.ok(pcall(read.of, formula), e.name .. " is set: " .. formula)
  end
end

local pipe = assert(io.popen "ls bodies/*.lua")
local bodies = {}
for path in pipe:lines() do bodies[#bodies + 1] = path end
pipe:close()
for _, path in ipairs(tier.every(13, bodies)) do
  local text, status = run("explain " .. path .. " --format html")
  local depth = 0
  for closing, name, own in string.gmatch(string.match(text, "<body>(.*)</body>") or "</x>", "<(/?)(%w+)[^>]-(/?)>") do
    if own == "" and name ~= "br" then depth = depth + (closing == "" and 1 or -1) end
  end
  tap.ok(status == 0 and depth == 0 and utf8.len(text), path .. ": HTML whose elements close")
  local typst = run("explain " .. path .. " --format typst")
  tap.is(select(2, string.gsub(typst, "%$", "")) % 2, 0, path .. ": Typst whose formulas close")
end
os.remove(scene)
tap.done()
