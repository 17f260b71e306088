-- mathml.lua -- expressions as MathML Core, which browsers draw by themselves.
--
--     mathml.of(e) -> text, or nil where it is too long to read
-- Rounded brackets do not stretch: Chromium leaves gaps else.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local text = require "generator.algebra.text"

local mathml = {}

local longest = 160 -- parts of a formula that a person reads
local TIMES = '<mo>\u{2062}</mo><mspace width="0.15em"/>' -- invisible; names of several letters need the gap
local greek = { omega = "ω", alpha = "α", beta = "β", gamma = "γ", theta = "θ", phi = "φ", rho = "ρ", lambda = "λ",
  mu = "μ", pi = "π" }

local function row(s) return "<mrow>" .. s .. "</mrow>" end
local function escaped(s) return (string.gsub(s, "[&<>]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;" })) end
local function bracketed(s) return '<mo stretchy="false">(</mo>' .. s .. '<mo stretchy="false">)</mo>' end

-- A name; what stands after its first low line is an index.
function mathml.name(s)
  local stem, tail = string.match(s, "^([^_]+)_(.+)$")
  if not stem then return "<mi>" .. escaped(greek[s] or s) .. "</mi>" end
  return "<msub><mi>" .. escaped(greek[stem] or stem) .. "</mi><mi>" .. escaped(tail) .. "</mi></msub>"
end

local render

local function factor(e)
  local s = render(e)
  return row(e.kind == "add" and bracketed(s) or s)
end

local function powered(base, n)
  if n == R.half then return "<msqrt>" .. render(base) .. "</msqrt>" end
  if n == R.one then return factor(base) end
  local plain = base.kind == "sym" or base.kind == "num" or base.fn == "pi"
  return "<msup>" .. row(plain and render(base) or bracketed(render(base))) .. "<mn>" .. tostring(n) .. "</mn></msup>"
end

-- The value of a product without its sign, and whether a minus sign stands before it.
local function product(e)
  local c, rest = expr.split(e)
  local minus, top, bottom = R.sign(c) < 0, {}, {}
  c = R.abs(c)
  if R.num(c) ~= R.one then top[1] = "<mn>" .. tostring(R.num(c)) .. "</mn>" end
  if R.den(c) ~= R.one then bottom[1] = "<mn>" .. tostring(R.den(c)) .. "</mn>" end
  for _, f in ipairs(rest == expr.one and {} or rest.kind == "mul" and rest or { rest }) do
    if f.kind == "pow" and R.sign(f.exp) < 0 then
      bottom[#bottom + 1] = powered(f.base, -f.exp)
    else
      top[#top + 1] = f.kind == "pow" and powered(f.base, f.exp) or factor(f)
    end
  end
  if rest.kind == "add" and R.num(c) == R.one then top[1] = render(rest) end -- alone above a line
  if #top == 0 then top[1] = "<mn>1</mn>" end
  local n = table.concat(top, TIMES)
  if #bottom == 0 then return n, minus end
  return "<mfrac>" .. row(n) .. row(table.concat(bottom, TIMES)) .. "</mfrac>", minus
end

local MINUS, PREFIX = "<mo>\u{2212}</mo>", '<mo form="prefix">\u{2212}</mo>'

function render(e)
  if e.kind == "sym" then return mathml.name(e.name) end
  if e.kind == "call" and e.fn == "pi" then return "<mi>π</mi>" end
  if e.kind == "call" then
    local args = {}
    for i = 1, #e do args[i] = render(e[i]) end
    return "<mi>" .. escaped(text.called(e.fn)) .. "</mi>" .. bracketed(table.concat(args, "<mo>,</mo>"))
  end
  local list = {}
  for i, term in ipairs(e.kind == "add" and e or { e }) do
    local s, minus = product(term)
    list[#list + 1] = i == 1 and (minus and PREFIX or "") or minus and MINUS or "<mo>+</mo>"
    list[#list + 1] = s
  end
  return table.concat(list)
end

-- Parts that e has when it is written out; counting ends where it is too long anyway.
local function written(e, n)
  n = n + 1
  for _, c in ipairs(expr.children(e)) do
    if n > longest then break end
    n = written(c, n)
  end
  return n
end

function mathml.of(e)
  if written(e, 0) > longest then return nil end
  return row(render(e))
end

-- How many parts e has; at most a few more than the longest formula.
function mathml.size(e) return written(e, 0) end

return mathml
