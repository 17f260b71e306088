-- formulas.lua -- the tensor of inertia and Euler's equations as MathML, beside the values that the page puts in.
--
--     formulas.html(inertia, o) -> text
-- inertia: xx yy zz xy xz yz, expressions of the parameters.  o: {plain = is the tensor of the equations this one, on
-- the body's axes and nowhere 0?, acts = list of {name, formula}: what turns the body, in words}.
-- An element with data-value="Ixx" takes that entry's number, "kx" the factor of wy wz in the equation of wx.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local mathml = require "generator.page.mathml"

local formulas = {}

local NAMES = { "xx", "yy", "zz", "xy", "xz", "yz" }
local PLACES = { 1, 4, 5, 4, 2, 6, 5, 6, 3 } -- of the rows of the matrix in the list of six
local SHORT = 14 -- parts of an entry that stands in the matrix itself

local OMEGA, DOT = "<mi>ω</mi>", '<mover accent="true"><mi>ω</mi><mo>˙</mo></mover>'
local BOLD, BOLD_DOT = "<mi>𝛚</mi>", '<mover accent="true"><mi>𝛚</mi><mo>˙</mo></mover>'
local TIMES, MINUS, PLUS, EQUAL = "<mo>\u{2062}</mo>", "<mo>\u{2212}</mo>", "<mo>+</mo>", "<mo>=</mo>"

local function sub(what, index) return "<msub>" .. what .. "<mi>" .. index .. "</mi></msub>" end
local function entry(i) return sub("<mi>I</mi>", NAMES[i]) end
local function value(name) return '<mn data-value="' .. name .. '">0</mn>' end
local function bracketed(s) return '<mo stretchy="false">(</mo>' .. s .. '<mo stretchy="false">)</mo>' end

local function math(content) return '<math display="block"><mrow>' .. content .. "</mrow></math>\n" end

local function matrix(cell)
  local out = {}
  for i, k in ipairs(PLACES) do
    out[i] = (i % 3 == 1 and "<mtr>" or "") .. "<mtd>" .. cell(k) .. "</mtd>" .. (i % 3 == 0 and "</mtr>" or "")
  end
  return "<mrow><mo>(</mo><mtable>" .. table.concat(out) .. "</mtable><mo>)</mo></mrow>"
end

local function tensor(inertia)
  local below = {}
  local function symbolic(k)
    if mathml.size(inertia[k]) <= SHORT then return mathml.of(inertia[k]) end
    below[k] = true
    return entry(k)
  end
  local function number(k) return inertia[k] == expr.zero and "<mn>0</mn>" or value("I" .. NAMES[k]) end
  local out = { math("<mi>𝐈</mi>" .. EQUAL .. matrix(symbolic)),
    math("<mi>𝐈</mi>" .. EQUAL .. matrix(number) .. "<mtext>\u{a0}kg m²</mtext>") }
  for k = 1, 6 do
    local long = below[k] and mathml.of(inertia[k])
    if long then out[#out + 1] = math(entry(k) .. EQUAL .. long) end
    if below[k] and not long then
      out[#out + 1] = "<p>I" .. NAMES[k] .. ": too long to read here; polhode explain has it in parts.</p>\n"
    end
  end
  return table.concat(out)
end

-- Three equations on the body's axes, and three with numbers.
local function components(acted)
  local out = {}
  for k, x in ipairs { "x", "y", "z" } do
    local y, z = k % 3 + 1, (k + 1) % 3 + 1
    local rates = sub(OMEGA, string.sub("xyz", y, y)) .. TIMES .. sub(OMEGA, string.sub("xyz", z, z))
    out[k] = math(entry(k) .. TIMES .. sub(DOT, x) .. EQUAL .. bracketed(entry(y) .. MINUS .. entry(z)) .. TIMES ..
      rates .. (acted and PLUS .. sub("<mi>N</mi>", x) or ""))
    out[3 + k] = math(sub(DOT, x) .. EQUAL .. value("k" .. x) .. TIMES .. rates .. (acted and PLUS .. "<mrow>" ..
      sub("<mi>N</mi>", x) .. "<mo>/</mo>" .. entry(k) .. "</mrow>" or ""))
  end
  return table.concat(out)
end

local function escaped(s) return (string.gsub(s, "[&<>]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;" })) end

function formulas.html(inertia, o)
  local acted, acts = #o.acts > 0, {}
  local cross = "<mrow>" .. BOLD .. "<mo>×</mo>" .. bracketed("<mi>𝐈</mi>" .. TIMES .. BOLD) .. "</mrow>"
  local euler = math("<mi>𝐈</mi>" .. TIMES .. BOLD_DOT .. PLUS .. cross .. EQUAL .. (acted and "<mi>𝐍</mi>" or
    "<mn>0</mn>"))
  for i, a in ipairs(o.acts) do
    acts[i] = "<li>" .. escaped(a.name) .. ": <code>" .. escaped(a.formula) .. "</code></li>"
  end
  return "<h2>Tensor of inertia</h2>\n" .. tensor(inertia) .. "<h2>Euler's equations</h2>\n" .. euler ..
    (o.plain and components(acted) or "") .. (acted and "<p>N is the sum of what acts:</p>\n<ul>" ..
    table.concat(acts) .. "</ul>\n" or "")
end

return formulas
