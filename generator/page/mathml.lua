-- mathml.lua -- expressions as MathML Core, which browsers draw by themselves.
--
--     mathml.of(e) -> text, or nil where it is too long to read
-- Rounded brackets do not stretch: Chromium leaves gaps else.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local signed = require "generator.algebra.signed"
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

-- (sign base)^n, n > 0, as a factor
local function powered(base, n, sign)
  if n == R.half then return "<msqrt>" .. render(base, 1) .. "</msqrt>" end
  local b = render(base, sign)
  if n == R.one then return row(base.kind == "add" and bracketed(b) or b) end
  local plain = base.kind == "sym" or base.kind == "num" or base.fn == "pi"
  return "<msup>" .. row(plain and b or bracketed(b)) .. "<mn>" .. tostring(n) .. "</mn></msup>"
end

-- A product of algebra/signed.lua without the minus sign before it.
local function product(p)
  local top, bottom = {}, {}
  if R.num(p.c) ~= R.one then top[1] = "<mn>" .. tostring(R.num(p.c)) .. "</mn>" end
  if R.den(p.c) ~= R.one then bottom[1] = "<mn>" .. tostring(R.den(p.c)) .. "</mn>" end
  local above, below = p.above, p.below
  local barred = #bottom + #below > 0
  if #above == 1 and #top == 0 and above[1].exp == R.one and (barred or not p.minus) then
    top[1] = render(above[1].base, above[1].sign) -- a sum that stands alone
  else
    for _, f in ipairs(above) do top[#top + 1] = powered(f.base, f.exp, f.sign) end
  end
  for _, f in ipairs(below) do bottom[#bottom + 1] = powered(f.base, f.exp, f.sign) end
  if #top == 0 then top[1] = "<mn>1</mn>" end
  local n = table.concat(top, TIMES)
  if not barred then return n end
  return "<mfrac>" .. row(n) .. row(table.concat(bottom, TIMES)) .. "</mfrac>"
end

local MINUS, PREFIX = "<mo>\u{2212}</mo>", '<mo form="prefix">\u{2212}</mo>'

-- sign e
function render(e, sign)
  if e.kind == "sym" then return mathml.name(e.name) end
  if e.kind == "call" and e.fn == "pi" then return "<mi>π</mi>" end
  if e.kind == "call" then
    local args = {}
    for i = 1, #e do args[i] = render(e[i], 1) end
    local name = e.fn == "opaque" and "" or "<mi>" .. escaped(text.called(e.fn)) .. "</mi>"
    return name .. bracketed(table.concat(args, "<mo>,</mo>"))
  end
  local list = {}
  for i, p in ipairs(e.kind == "add" and signed.terms(e, sign) or { signed.product(e, sign) }) do
    list[#list + 1] = i == 1 and (p.minus and PREFIX or "") or p.minus and MINUS or "<mo>+</mo>"
    list[#list + 1] = product(p)
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
  return row(render(e, 1))
end

-- How many parts e has; at most a few more than the longest formula.
function mathml.size(e) return written(e, 0) end

return mathml
