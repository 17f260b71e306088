-- text.lua -- expressions as text for people: plain, Unicode or LaTeX.
--
-- Numbers are exact quotients.  Those with an irrational number in them have 240 bits, and are written as doubles.
-- Products read M a b/4, a rational coefficient goes to a denominator as it is written by hand: M (b² + c²)/12.  The
-- plain style is what JSON and comments carry ("M*(b^2 + c^2)/12") and reads back in any computer algebra system.
-- C text is emit/cprint.lua's business, not ours.  text.nodes is for programs: it tells every two expressions apart,
-- which what is written for people does not.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local double = require "generator.algebra.double"
local expr = require "generator.algebra.expr"
local signed = require "generator.algebra.signed"

local text = {}

local superscript = { ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³", ["4"] = "⁴", ["5"] = "⁵", ["6"] = "⁶",
  ["7"] = "⁷", ["8"] = "⁸", ["9"] = "⁹", ["-"] = "⁻" }

-- How a style writes sums of factors (times), roots, b^n and n/d; all of them get and give text.
local styles = {
  plain = { times = "*", pi = "pi", sqrt = function(s) return "sqrt(" .. s .. ")" end,
    power = function(b, n) return b .. "^" .. n end,
    quotient = function(n, d) return n .. "/" .. d end,
    open = "(", close = ")" },
  unicode = { times = " ", pi = "π", sqrt = function(s) return "√(" .. s .. ")" end,
    power = function(b, n)
      if string.find(n, "[^%d%-]") then return b .. "^" .. n end
      return b .. string.gsub(n, ".", superscript)
    end,
    quotient = function(n, d) return n .. "/" .. d end,
    open = "(", close = ")" },
  latex = { times = " ", pi = "\\pi", sqrt = function(s) return "\\sqrt{" .. s .. "}" end,
    power = function(b, n) return b .. "^{" .. n .. "}" end,
    quotient = function(n, d) return "\\frac{" .. n .. "}{" .. d .. "}" end,
    open = "\\left(", close = "\\right)" },
}

local greek = { omega = "\\omega", alpha = "\\alpha", beta = "\\beta", gamma = "\\gamma", theta = "\\theta",
  phi = "\\phi", rho = "\\rho", lambda = "\\lambda", mu = "\\mu" }

local latex_name = { asin = "\\arcsin", acos = "\\arccos", atan = "\\arctan", atan2 = "\\operatorname{atan2}",
  sign = "\\operatorname{sign}", clamp = "\\operatorname{clamp}" }

-- A function's name for readers: where x is 0 is seen in no formula.
function text.called(fn) return fn == "side" and "sign" or fn end

local function latex_call(fn)
  if latex_name[fn] then return latex_name[fn] end
  if not string.find(fn, "_", 1, true) then return "\\" .. fn end
  return "\\operatorname{" .. string.gsub(fn, "_", "\\_") .. "}"
end

local render

-- (sign base)^n, n > 0, as a factor
local function powered(base, n, sign, style)
  if n == R.half then return style.sqrt(render(base, 1, style)) end
  local b = render(base, sign, style)
  if n == R.one then
    if base.kind == "add" then b = style.open .. b .. style.close end
    return b
  end
  if base.kind ~= "sym" and base.kind ~= "num" and base.fn ~= "pi" then b = style.open .. b .. style.close end
  local p = tostring(n)
  if not R.isint(n) and style ~= styles.latex then p = "(" .. p .. ")" end
  return style.power(b, p)
end

-- Is a number rounded, or too long to be read as a quotient?  Within the range of a double.
local function long(c)
  local size = R.log2(c)
  return math.max(R.log2(R.num(c)), R.log2(R.den(c))) > 128 and size < 1000 and size > -1000
end

local function decimal(c, style)
  local s = double.shortest(R.todouble(c), 15)
  if style ~= styles.latex then return s end
  return (string.gsub(s, "e([+-]?)0*(%d+)$", function(sign, n)
    return "\\cdot 10^{" .. (sign == "-" and "-" or "") .. n .. "}"
  end))
end

-- A product of signed.lua as a quotient of texts, without the minus sign before it.
-- top, bottom: the texts above and below the bar; a sum that stands `alone` needs no parentheses
local function product(p, style)
  local top, bottom = {}, {}
  if R.sign(p.c) ~= 0 and long(p.c) then
    top[1] = decimal(p.c, style)
  else
    if R.num(p.c) ~= R.one then top[1] = tostring(R.num(p.c)) end
    if R.den(p.c) ~= R.one then bottom[1] = tostring(R.den(p.c)) end
  end
  local alone = p.c == R.one and #p.above == 1 and #p.below == 0 and not p.minus
  for _, f in ipairs(p.above) do
    top[#top + 1] = alone and f.exp == R.one and render(f.base, f.sign, style) or powered(f.base, f.exp, f.sign, style)
  end
  for _, f in ipairs(p.below) do bottom[#bottom + 1] = powered(f.base, f.exp, f.sign, style) end
  if #top == 0 then top[1] = "1" end
  local n = table.concat(top, style.times)
  if #bottom == 0 then return n end
  local d = table.concat(bottom, style.times)
  if #bottom > 1 and style ~= styles.latex then d = "(" .. d .. ")" end
  return style.quotient(n, d)
end

-- sign e.  In a sum each term's sign stands before it as an operator; a product's is the sign of its coefficient.
function render(e, sign, style)
  if e.kind == "sym" then
    if style == styles.latex then
      local stem, tail = string.match(e.name, "^(%a+)_?(%w*)$")
      if not stem then return "\\mathrm{" .. string.gsub(e.name, "_", "\\_") .. "}" end
      stem = greek[stem] or (#stem > 1 and "\\mathrm{" .. stem .. "}" or stem)
      return tail ~= "" and stem .. "_{" .. tail .. "}" or stem
    end
    return e.name
  end
  if e.kind == "call" then
    if e.fn == "pi" then return style.pi end
    local args = {}
    for i = 1, #e do args[i] = render(e[i], 1, style) end
    if style == styles.latex and e.fn == "abs" then return "\\left|" .. args[1] .. "\\right|" end
    if e.fn == "opaque" then return style.open .. args[1] .. style.close end
    local fn = text.called(e.fn)
    fn = style == styles.latex and latex_call(fn) or fn
    return fn .. style.open .. table.concat(args, ", ") .. style.close
  end
  local list = {}
  for i, p in ipairs(e.kind == "add" and signed.terms(e, sign) or { signed.product(e, sign) }) do
    list[#list + 1] = i == 1 and (p.minus and "-" or "") or (p.minus and " - " or " + ")
    list[#list + 1] = product(p, style)
  end
  return table.concat(list)
end

-- Terms and factors that e has when it is written out; shared parts count each time, so this can be astronomical.
local function written(e)
  local memo = {}
  local function size(u)
    if memo[u] then return memo[u] end
    local n = 1.0
    for _, c in ipairs(expr.children(u)) do n = n + size(c) end
    memo[u] = n
    return n
  end
  return size(e)
end

local longest = 3000 -- parts; more is no text for people

-- e in the style "plain", "unicode" or "latex"; "..." where it would be too long to read.
function text.of(e, style)
  if written(e) > longest then return "..." end
  return render(e, 1, styles[style or "plain"] or error("unknown style " .. style))
end

-- A function that writes expressions so that every two are told apart, whatever their length: put(e) gives the number
-- of e's node, and put() all nodes so far, each one line by the numbers of its parts.  Shared nodes are written once,
-- so the work is linear in them.
function text.nodes()
  local number, lines = {}, {}
  local function put(e)
    if not e then return table.concat(lines, "\n") end
    if number[e] then return number[e] end
    local parts = { e.kind, e.name or e.fn or tostring(e.value or e.exp or "") }
    for _, c in ipairs(expr.children(e)) do parts[#parts + 1] = put(c) end
    lines[#lines + 1] = table.concat(parts, " ")
    number[e] = string.format("%d", #lines)
    return number[e]
  end
  return put
end

return text
