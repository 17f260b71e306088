-- section.lua -- an expression as a polynomial in one or two of its symbols, the others being numbers.
--
-- The numbers are put in exactly, the coefficients of the result are doubles: for root finding and charts.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local poly = require "generator.algebra.poly"

local section = {}

-- of constants such as sqrt(2), before they are rounded to a double
local bits = 240

-- e with every symbol but those named replaced by its value (name -> rational).
function section.fixed(e, values, names)
  local free, map = {}, {}
  for _, n in ipairs(names) do free[n] = true end
  for _, s in ipairs(expr.symbols(e)) do
    if not free[s.name] then map[s] = expr.num(values[s.name]) end
  end
  return calculus.substitute(e, map)
end

-- The terms {c, n1, n2 ..} of e in the named symbols: c a double, n1 the exponent of the first; nil where e is no
-- polynomial in them.
function section.terms(e, values, names)
  e = section.fixed(e, values, names)
  local ring, p = poly.modest(e)
  if not p then return nil end
  local place = {}
  for i, n in ipairs(names) do place[n] = i end
  local list = {}
  for k, t in ipairs(poly.sorted(p)) do
    local term, c = {}, t.c
    for i = 1, #names do term[i + 1] = 0 end
    for i, x in ipairs(t.e) do
      local g = ring.gens[i]
      if x ~= 0 and g.kind == "sym" then
        term[place[g.name] + 1] = x
      elseif x ~= 0 then
        if not expr.constant(g) then return nil end
        c = c * evaluate.precise(expr.pow(g, x), {}, bits)
      end
    end
    term[1] = R.todouble(c)
    list[k] = term
  end
  return list
end

-- The coefficients c[1] + c[2] y + ... of terms in (x, y) at x; of terms in one symbol with no x.
function section.coefficients(terms, x)
  local c = {}
  for _, t in ipairs(terms) do
    local n = x and t[3] or t[2]
    while #c <= n do c[#c + 1] = 0.0 end
    c[n + 1] = c[n + 1] + t[1] * (x and x ^ t[2] or 1)
  end
  return c
end

return section
