-- expression.lua -- expressions of the algebra as formulas: the one walk over them, for every style and document.
--
--     expression.tree(e, o) -> node              expression.sum(e, sign, o), ... are parts of it
-- o.names(name) -> node        how a symbol is written; left out: its name as it stands
-- o.named[e] -> node           expressions that are written as names
-- o.rational(q) -> node | nil  a positive coefficient that is not written as a quotient of whole numbers
-- Signs stand where algebra/signed.lua puts them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local signed = require "generator.algebra.signed"
local tree = require "generator.formula.tree"

local expression = {}

local nothing = {}

-- A function's name for readers: where x is 0 is seen in no formula.
function expression.called(fn) return fn == "side" and "sign" or fn end

local written

-- (sign base)^n, n > 0, as a factor
local function power(base, n, sign, o)
  if n == R.half then return tree.sqrt(written(base, 1, o)) end
  local b = written(base, sign, o)
  if n == R.one then return b end
  if R.isint(n) then return tree.pow(b, tree.num(tostring(n))) end
  return tree.pow(b, { kind = "ratio", tree.num(tostring(R.num(n))), tree.num(tostring(R.den(n))) })
end

-- A product of signed.lua without the minus sign before it.
local function product(p, o)
  local top, bottom = {}, {}
  local c = o.rational and o.rational(p.c)
  if c then
    top[1] = c
  else
    if R.num(p.c) ~= R.one then top[1] = tree.num(tostring(R.num(p.c))) end
    if R.den(p.c) ~= R.one then bottom[1] = tree.num(tostring(R.den(p.c))) end
  end
  for _, f in ipairs(p.above) do top[#top + 1] = power(f.base, f.exp, f.sign, o) end
  for _, f in ipairs(p.below) do bottom[#bottom + 1] = power(f.base, f.exp, f.sign, o) end
  if #bottom == 0 then return tree.product(top) end
  return tree.frac(tree.product(top), tree.product(bottom))
end

-- sign e
function written(e, sign, o)
  local named = o.named or nothing
  if named[e] then return named[e] end
  if e.kind == "sym" then return o.names and o.names(e.name) or tree.sym(e.name) end
  if e.kind == "call" then
    if e.fn == "pi" then return tree.sym "pi" end
    if e.fn == "opaque" then return written(e[1], 1, o) end
    local n = tree.call(expression.called(e.fn))
    for i = 1, #e do n[i] = written(e[i], 1, o) end
    return n
  end
  local function name(u) return named[u] end
  if e.kind == "add" then
    local sum = { kind = "sum" }
    for i, p in ipairs(signed.terms(e, sign, name)) do sum[i] = { minus = p.minus, node = product(p, o) } end
    return sum
  end
  local p = signed.product(e, sign, name)
  local node = product(p, o)
  return p.minus and tree.minus(node) or node
end

function expression.tree(e, o) return written(e, 1, o or nothing) end

-- Terms and factors that e has when it is written out, counted to a little beyond `most`.
function expression.size(e, most)
  local n = 0
  local function count(u)
    n = n + 1
    if n > most then return end
    for _, c in ipairs(expr.children(u)) do count(c) end
  end
  count(e)
  return n
end

return expression
