-- coordinate.lua -- polynomials in the coordinates x, y, z whose coefficients are expressions.
--
-- ABOVE the line.  The coordinates are three symbols that no parameter can be named like.  A polynomial is a list of
-- terms {c = expression without coordinates, [1..3] = exponents of x, y, z}, in the order of first appearance; no two
-- terms have the same exponents, and no coefficient is the number 0 (one that is zero but does not look it may stay).
-- They are what is integrated over a region and what a density is, not what is cancelled: for that there is poly.lua,
-- whose coefficients are numbers.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local coordinate = {}

coordinate.symbols = { expr.sym("@x", 3), expr.sym("@y", 3), expr.sym("@z", 3) }
coordinate.names = { "x", "y", "z" }
local number = {}
for i, s in ipairs(coordinate.symbols) do number[s] = i end

-- 1, 2 or 3 when e is a coordinate.
function coordinate.index(e) return number[e] end

local most_products, most_degree = 20000, 40 -- terms that one product may form; far above what a body needs

-- Raised by a product that would have too many terms; what catches it says so to the user.
coordinate.too_large = setmetatable({}, { __tostring = function() return "too many terms in a polynomial" end })

-- Terms of equal exponents as one, in the place of the first.
local function collect(terms)
  local out, at = {}, {}
  for _, t in ipairs(terms) do
    local key = t[1] .. "," .. t[2] .. "," .. t[3]
    local i = at[key]
    if i then
      out[i] = { c = out[i].c + t.c, t[1], t[2], t[3] }
    else
      out[#out + 1] = t
      at[key] = #out
    end
  end
  local nonzero = {}
  for _, t in ipairs(out) do
    if t.c ~= expr.zero then nonzero[#nonzero + 1] = t end
  end
  return nonzero
end

-- The polynomial of degree 0; that of zero has no terms.
function coordinate.constant(c) return c == expr.zero and {} or { { c = c, 0, 0, 0 } } end

-- x^i y^j z^k
function coordinate.monomial(i, j, k) return { { c = expr.one, i, j, k } } end

function coordinate.add(a, b)
  local list = { table.unpack(a) }
  for _, t in ipairs(b) do list[#list + 1] = t end
  return collect(list)
end

-- Raises too_large before it forms more than most_products terms.
function coordinate.mul(a, b)
  if #a * #b > most_products then error(coordinate.too_large, 0) end
  local list = {}
  for _, s in ipairs(a) do
    for _, t in ipairs(b) do list[#list + 1] = { c = s.c * t.c, s[1] + t[1], s[2] + t[2], s[3] + t[3] } end
  end
  return collect(list)
end

function coordinate.power(a, n)
  local out = coordinate.constant(expr.one)
  for _ = 1, n do out = coordinate.mul(out, a) end
  return out
end

function coordinate.scale(k, a)
  local out = {}
  for i, t in ipairs(a) do out[i] = { c = k * t.c, t[1], t[2], t[3] } end
  return out
end

-- Does e depend on a coordinate?
function coordinate.inside(e)
  for _, s in ipairs(expr.symbols(e)) do
    if number[s] then return true end
  end
  return false
end

-- e as a polynomial in the coordinates; nil when it is none (or of a degree above 40).
function coordinate.of(e)
  if not coordinate.inside(e) then return coordinate.constant(e) end
  if number[e] then
    local t = { c = expr.one, 0, 0, 0 }
    t[number[e]] = 1
    return { t }
  end
  if e.kind == "pow" then
    local n = R.isint(e.exp) and R.toint(e.exp)
    local base = n and n > 0 and n <= most_degree and coordinate.of(e.base)
    return base and coordinate.power(base, n) or nil
  end
  if e.kind ~= "add" and e.kind ~= "mul" then return nil end
  local sum = e.kind == "add"
  local out = coordinate.constant(sum and expr.zero or expr.one)
  for i = 1, #e do
    local p = coordinate.of(e[i])
    if not p then return nil end
    out = sum and coordinate.add(out, p) or coordinate.mul(out, p)
    for _, t in ipairs(out) do
      if t[1] + t[2] + t[3] > most_degree then return nil end
    end
  end
  return out
end

-- The integral of p over coordinate v from lo to hi, which are polynomials in the others: term by term,
-- v^n ==> (hi^(n+1) - lo^(n+1))/(n + 1), the powers of the limits formed once.
-- The result has no v: an iterated integral over a region takes the innermost coordinate first.
function coordinate.integrate(p, v, lo, hi)
  local powers = { [0] = { coordinate.constant(expr.one), coordinate.constant(expr.one) } }
  local function power(n)
    if not powers[n] then
      local below = power(n - 1)
      powers[n] = { coordinate.mul(below[1], lo), coordinate.mul(below[2], hi) }
    end
    return powers[n]
  end
  local out = {}
  for _, t in ipairs(p) do
    local n = t[v] + 1
    local rest = { c = t.c / n, t[1], t[2], t[3] }
    rest[v] = 0
    local at = power(n)
    local difference = coordinate.add(at[2], coordinate.scale(-expr.one, at[1]))
    out = coordinate.add(out, coordinate.mul({ rest }, difference))
  end
  return out
end

return coordinate
