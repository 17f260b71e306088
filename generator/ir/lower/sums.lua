-- sums.lua: the sums among the forms of form.lua, and what is taken out of them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line.  A sum of terms becomes a form after four steps, each a law of algebra and each saving
-- operations or digits:
--     like terms        x + 2*x                 ==> 3*x
--     common factors    Iy*wy*wz - Iz*wy*wz     ==> (Iy - Iz)*wy*wz,   a/m + b/m ==> (a + b)/m
--     common size       a/2 - b/2               ==> (1/2)*(a - b),     1 - 2*x - 2*y ==> 1 - 2*(x + y)
--     squares           x^2 - y^2               ==> (x - y)*(x + y)
-- The last is not about speed.  With u the unit roundoff, x^2 - y^2 as written has an error up to u (x^2 + y^2), which
-- near x = y is all of it; (x - y)*(x + y) has three roundings, so at most about 3 u of its own size: the left side
-- loses all digits there, the right side none (for the x and y that are given).
--
-- The result is a term c*f with f a sum that begins with a positive term, or, after factors or squares, a product.
-- Where all coefficients are +-c they are +-1 in f; so a sum and any multiple of it are one form (form.lua).
--
-- It ends: each step hands on fewer terms, or terms with fewer factors, or the two terms x and y of half the degree.
-- Cost for n terms of at most p factors: n look-ups for like terms, n p for common factors; `grouped` makes a
-- text of every coefficient, so it is asked last and only where some coefficient is not +-1.

local R = require "generator.algebra.rational"

local sums = {}

local ONE, MINUS = R.one, -R.one

local function abs(c) return R.sign(c) < 0 and -c or c end

-- Do f and g have a base in common, on the same side of the quotient?  Only a quick no: bases inside a product that
-- stands in a power are not seen here, for powers of products have been opened (products.lua).
local function related(f, g)
  local ours, theirs = f.num or { f }, g.num or { g }
  for _, x in ipairs(ours) do
    x = x.base or x
    for _, y in ipairs(theirs) do
      if x == (y.base or y) then return true end
    end
  end
  for _, x in ipairs(f.den or {}) do
    x = x.base or x
    for _, y in ipairs(g.den or {}) do
      if x == (y.base or y) then return true end
    end
  end
  return false
end

-- What all terms have in common, as { term, exponent } pairs: of each base the exponent next to zero, if it is above
-- the line in all of them or below it in all.  A base on both sides, x*y + z/x, is not taken out: x*(y + z/x^2) is
-- dearer.
-- Roots are left where they are: an exponent that is no integer is not asked for.
local function common(B, terms)
  for _, t in ipairs(terms) do
    if t.f == B.one then return {} end
  end
  if not related(terms[1].f, terms[2].f) then return {} end
  local first = B:factors(terms[1].f)
  local shared = first.e
  for k = 2, #terms do
    local other = B:factors(terms[k].f).e
    local any = false
    for _, f in ipairs(first.list) do
      local a, b = shared[f], other[f]
      if not a or not b or (a > 0) ~= (b > 0) then
        shared[f] = nil
      else
        shared[f] = a > 0 and math.min(a, b) or math.max(a, b)
        any = true
      end
    end
    if not any then return {} end
  end
  local list = {}
  for _, f in ipairs(first.list) do
    if shared[f] then list[#list + 1] = { { c = ONE, f = f }, shared[f] } end
  end
  return list
end

-- The term whose square is t (t.c > 0), or nil.  Its coefficient must be the square of a rational and all exponents
-- even, so that nothing irrational and no |x| comes in: sqrt(x^2) is x here, and either sign would do, for
-- (x - y)*(x + y) is the same for x and -x.
local function square_root(B, t)
  local root = R.root(t.c, 2)
  if not root then return nil end
  local P = B:factors(t.f)
  if #P.roots > 0 then return nil end
  local halves = { { B.number(root), 1 } }
  for _, f in ipairs(P.list) do
    if P.e[f] % 2 ~= 0 then return nil end
    halves[#halves + 1] = { { c = ONE, f = f }, P.e[f] // 2 }
  end
  return B:product(halves)
end

-- The term (x - y)*(x + y) if the terms are x^2 and -y^2, else nil.
local function difference_of_squares(B, terms)
  if #terms ~= 2 or R.sign(terms[1].c) == R.sign(terms[2].c) then return nil end
  local x = square_root(B, { c = abs(terms[1].c), f = terms[1].f })
  local y = x and square_root(B, { c = abs(terms[2].c), f = terms[2].f })
  if not y then return nil end
  if R.sign(terms[1].c) < 0 then x, y = y, x end
  return B:product { { B:sum { x, { c = -y.c, f = y.f } }, 1 }, { B:sum { x, y }, 1 } }
end

-- Terms whose coefficients are +-m with the same m ~= 1 become m times one sum, in the place of the
-- first: 1 - 2*x - 2*y ==> 1 - 2*(x + y).
local function grouped(B, terms)
  local any = false
  for _, t in ipairs(terms) do any = any or t.c ~= ONE and t.c ~= MINUS end
  if not any then return terms end
  any = false
  local by_size, sizes = {}, {}
  for k, t in ipairs(terms) do
    sizes[k] = tostring(abs(t.c))
    local group = by_size[sizes[k]]
    if group then
      group[#group + 1] = t
      any = any or sizes[k] ~= "1"
    else
      by_size[sizes[k]] = { t }
    end
  end
  if not any then return terms end
  local result = {}
  for k, t in ipairs(terms) do
    local group = by_size[sizes[k]]
    if sizes[k] == "1" or #group == 1 then
      result[#result + 1] = t
    elseif group[1] == t then
      result[#result + 1] = B:sum(group)
    end
  end
  return result
end

-- Like terms as one, in the place of the first; those that cancel are left out.  The terms are copies.
local function collected(list)
  local terms, at, merged = {}, {}, false
  for k = 1, #list do
    local t = list[k]
    local old = at[t.f]
    if old then
      old.c = old.c + t.c
      merged = true
    else
      old = { c = t.c, f = t.f }
      at[t.f] = old
      terms[#terms + 1] = old
    end
    merged = merged or R.sign(t.c) == 0
  end
  if not merged then return terms end
  local rest = {}
  for _, t in ipairs(terms) do
    if R.sign(t.c) ~= 0 then rest[#rest + 1] = t end
  end
  return rest
end

-- The sum of a list of terms, as a term: like terms are collected, common factors and a common
-- size of the coefficients are taken out, and the sign that makes the first term positive.
function sums.sum(B, list)
  local terms = collected(list)
  if #terms == 0 then return B.number(R.zero) end
  if #terms == 1 then return terms[1] end

  local outside = common(B, terms)
  if #outside > 0 then
    local inside = {}
    for k, t in ipairs(terms) do
      local quotient = { { t, 1 } }
      for _, x in ipairs(outside) do quotient[#quotient + 1] = { x[1], -x[2] } end
      inside[k] = B:product(quotient)
    end
    table.insert(outside, 1, { B:sum(inside), 1 })
    return B:product(outside)
  end

  local c = abs(terms[1].c) -- the common size, or 1; with the sign of the first term
  local minus = -c
  for _, t in ipairs(terms) do
    if t.c ~= c and t.c ~= minus then c = ONE end
  end
  if R.sign(terms[1].c) < 0 then c = -c end
  if c ~= ONE then
    for _, t in ipairs(terms) do t.c = t.c / c end
  end

  local square = difference_of_squares(B, terms)
  if square then return { c = c * square.c, f = square.f } end

  return { c = c, f = B:sum_form(grouped(B, terms)) }
end

return sums
