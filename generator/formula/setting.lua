-- setting.lua -- one walk over a formula; each style says how its pieces look.
--
--     setting.of(style, node) -> text              setting.terms(style, sum, from, to) -> some terms of a sum
--
-- A style has a function per kind of node that gets the texts of the parts (latex.lua is one), `par` for parentheses
-- where they are needed, and `linear`: has it no bars, so that a quotient is n/d in a line?
-- SPDX-License-Identifier: GPL-3.0-or-later

local tree = require "generator.formula.tree"

local setting = {}

-- How tightly a node holds together, as it is set: a part looser than its place asks gets parentheses.
local SUM, VECTORS, PRODUCT, POWER, ATOM = 1, 2, 3, 4, 5

local function level(style, n)
  local kind = n.kind
  if kind == "sum" or kind == "row" then return SUM end
  if kind == "cross" or kind == "dot" then return VECTORS end
  if kind == "product" or kind == "integral" or kind == "diff" or kind == "quantity" or kind == "frac" or
    kind == "ratio" then
    return PRODUCT
  end
  if kind == "num" then
    if string.find(n[1], "^%-") then return SUM end
    return not style.linear and string.find(n[1], "e", 1, true) and PRODUCT or ATOM
  end
  if kind == "pow" then return POWER end
  if kind == "sqrt" then return style.linear and ATOM or POWER end
  return ATOM
end

local function inside(style, n, least)
  local s = setting.of(style, n)
  return level(style, n) < least and style.par(s) or s
end

local function texts(style, list, least)
  local out = {}
  for i, part in ipairs(list) do out[i] = inside(style, part, least or SUM) end
  return out
end

local kinds = {}

-- In a line the quotients of a product are one: (a/b) c is a c/b.
local function gathered(n)
  local above, below = {}, {}
  local function put(to, part)
    if part.kind == "product" then
      for _, p in ipairs(part) do put(to, p) end
    elseif part.kind ~= "num" or part[1] ~= "1" then
      to[#to + 1] = part
    end
  end
  for _, part in ipairs(n) do
    put(above, part.kind == "frac" and part[1] or part)
    if part.kind == "frac" then put(below, part[2]) end
  end
  return above, below
end

function kinds.num(style, n)
  local minus, mantissa, exponent = string.match(n[1], "^(%-?)(.-)e([+-]?%d+)$")
  if mantissa and not style.linear then
    local power = style.pow(style.num "10", setting.of(style, tree.num(string.format("%d", tonumber(exponent)))))
    local s = mantissa == "1" and power or style.row { style.num(mantissa), style.op "times", power }
    return minus == "-" and style.minus(s) or s
  end
  local digits = string.match(n[1], "^%-(.*)$")
  return digits and style.minus(style.num(digits)) or style.num(n[1])
end
function kinds.sym(style, n) return style.sym(n[1], n.sub, n.vector, n.dot) end
function kinds.op(style, n) return style.op(n[1]) end
function kinds.word(style, n) return style.word(n[1]) end
function kinds.unit(style, n) return style.unit(n[1]) end
function kinds.quantity(style, n) return style.quantity(setting.of(style, n[1]), setting.of(style, n[2])) end
function kinds.row(style, n) return style.row(texts(style, n)) end
function kinds.product(style, n)
  if style.linear then
    local above, below = gathered(n)
    if #below > 0 then return kinds.frac(style, { tree.product(above), tree.product(below) }) end
  end
  return style.product(texts(style, n, PRODUCT))
end
function kinds.frac(style, n)
  if not style.linear then return style.frac(setting.of(style, n[1]), setting.of(style, n[2])) end
  return style.frac(inside(style, n[1], VECTORS), inside(style, n[2], POWER))
end
function kinds.ratio(style, n) return inside(style, n[1], POWER) .. style.slash .. inside(style, n[2], POWER) end
function kinds.cross(style, n) return style.cross(inside(style, n[1], PRODUCT), inside(style, n[2], PRODUCT)) end
function kinds.dot(style, n) return style.dot(inside(style, n[1], PRODUCT), inside(style, n[2], PRODUCT)) end
function kinds.sqrt(style, n) return style.sqrt(setting.of(style, n[1])) end
function kinds.pow(style, n)
  local exponent = setting.of(style, n[2])
  if n[1].kind == "call" and n[1].name ~= "abs" then
    return style.call(n[1].name, texts(style, n[1]), exponent)
  end
  return style.pow(inside(style, n[1], ATOM), exponent, n[2].kind == "ratio")
end
function kinds.abs(style, n) return style.abs(setting.of(style, n[1])) end
function kinds.call(style, n)
  if n.name == "abs" and not style.linear then return style.abs(setting.of(style, n[1])) end
  if n.name == "mean" and style.mean then return style.mean(setting.of(style, n[1])) end
  return style.call(n.name, texts(style, n))
end
function kinds.at(style, n) return style.at(setting.of(style, n[1]), setting.of(style, n[2])) end
function kinds.matrix(style, n)
  local rows = {}
  for i, r in ipairs(n.rows) do rows[i] = texts(style, r) end
  return style.matrix(rows)
end
function kinds.live(style, n) return style.live(n[1]) end
function kinds.tuple(style, n) return style.tuple(texts(style, n)) end
function kinds.integral(style, n)
  return style.integral(n.low and setting.of(style, n.low), n.high and setting.of(style, n.high))
end
function kinds.diff(style, n) return style.diff(setting.of(style, n[1])) end

-- The terms of a sum with their signs, from one to another.
function setting.terms(style, n, from, to)
  local list = {}
  for i = from, to do
    local t = n[i]
    list[#list + 1] = { sign = (t.minus and "-") or i > 1 and "+" or nil, text = inside(style, t.node, VECTORS) }
  end
  return style.sum(list, from == 1)
end
function kinds.sum(style, n) return setting.terms(style, n, 1, #n) end

function setting.of(style, n) return kinds[n.kind](style, n) end

return setting
