-- factor.lua -- polynomials as products, the way a person writes them.
--
-- ABOVE the line.  No complete factorisation, but the factors that matter to an eye and to rounding: monomials,
-- contents in each variable, repeated factors (Yun: gcd(p, p')), x - y of x^n - y^n, and the sums that stood in the
-- expression before it was multiplied out (`hints`: the r_out - r_in of a tube), so that a thin wall is a factor and
-- not a difference of powers.
--
-- The laws.  A factor that does not depend on v divides every coefficient of powers of v: their gcd is the content.  If
-- p = q^2 r then p' = q (2 q' r + q r'), so q divides gcd(p, p').  x^n - y^n = (x - y)(x^(n-1) + .. + y^(n-1)).  Each
-- divisor that is found is divided out, and both parts are looked at again, so the recursion ends with parts in which
-- nothing was found.  A part is only ever written otherwise, never rounded: any answer is correct, more factors are
-- better.  The work is bounded by ratio's budget; what was found for a polynomial of a ring is kept in the ring.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local gcd = require "generator.algebra.gcd"
local poly = require "generator.algebra.poly"

local factor = {}

-- Hints that are tried, and terms of the longest sum that is one: each is divided into every part once.
local most_hints, most_terms = 8, 3
local readable = 16 -- terms: a longer sum is not made readable by a factor, and looking for one is work

-- The short sums inside e as primitive polynomials.
function factor.hints(ring, e)
  local list, seen = {}, {}
  local function walk(u)
    if seen[u] or #list >= most_hints then return end
    seen[u] = true
    if u.kind == "add" and #u <= most_terms and u ~= e then
      local p = poly.from(ring, u)
      if p and p.n > 1 then list[#list + 1] = (gcd.primitive(p)) end
    end
    for _, c in ipairs(expr.children(u)) do walk(c) end
  end
  walk(e)
  list.classes = factor.classes(ring, e)
  return list
end

-- Generators between which e takes differences (sums of them whose coefficients add up to 0), as a partition of these:
-- lists of places in the ring, each beginning with the generator that most of its class have one with.
function factor.classes(ring, e)
  local class, count, seen, order = {}, {}, {}, {}
  local function join(i, j)
    local one, other = class[i] or { i }, class[j] or { j }
    class[i], class[j] = one, other
    count[i], count[j] = (count[i] or 0) + 1, (count[j] or 0) + 1
    if one == other then return end
    for _, k in ipairs(other) do
      one[#one + 1] = k
      class[k] = one
    end
  end
  local function walk(u)
    if seen[u] then return end
    seen[u] = true
    if u.kind == "add" then
      local places, sum = {}, R.zero
      for k, term in ipairs(u) do
        local c, one = expr.split(term)
        places[k], sum = ring.index[one], sum + c
      end
      for k = 2, #places == #u and R.sign(sum) == 0 and #u or 0 do join(places[1], places[k]) end
    end
    for _, c in ipairs(expr.children(u)) do walk(c) end
  end
  walk(e)
  for i = 1, #ring.gens do
    local list = class[i]
    if list and not seen[list] then
      seen[list] = true
      table.sort(list, function(a, b)
        if count[a] ~= count[b] then return count[a] > count[b] end
        return a < b
      end)
      order[#order + 1] = list
    end
  end
  return order
end

-- Derivative with respect to generator v.
-- Formal: the generators count as independent, so a sine is not differentiated through its cosine.
local function derivative(p, v)
  local sum = poly.constant(p.ring, R.zero)
  for _, t in ipairs(poly.sorted(p)) do
    if t.e[v] > 0 then
      local q = poly.constant(p.ring, t.c * R.new(t.e[v]))
      for i, n in ipairs(t.e) do
        local power = i == v and n - 1 or n
        if power > 0 then q = poly.mul(q, poly.generator(p.ring, i, power)) end
      end
      sum = poly.add(sum, q)
    end
  end
  return sum
end

---- may p have a factor of a kind?  Numbers are put in for all generators but one (gcd.lua) ----------

-- One that it has twice and that depends on v?  Then it is in p and in p' with numbers in it, too.
local function repeated(p, v)
  local a, b = gcd.specialised(p, v), {}
  for d = 1, #a - 1 do b[d] = a[d + 1] * R.new(d) end
  return gcd.common(a, b)
end

-- One that does not depend on v?  Then it is the same for two values of v, and common to p at both.
local function without(p, v)
  for w = 1, #p.ring.gens do
    if w ~= v and gcd.degree(p, w) > 0 and gcd.common(gcd.specialised(p, w, v, 2), gcd.specialised(p, w, v, 100)) then
      return true
    end
  end
  return false
end

-- The x - y in x^n - y^n, n > 2, or nil: what is left of a body when a hole of the same kind nearly fills it.
-- x^4 - y^4 ==> (x^3 + x^2 y + x y^2 + y^3) (x - y). x^2 - y^2 stays: the code's forms open it (ir/lower/sums.lua).
local function root_of_binomial(p)
  if p.n ~= 2 then return nil end
  local one, two = table.unpack(poly.sorted(p))
  local v, n = nil, nil
  for i, k in ipairs(one.e) do
    if k > 0 then
      if v or two.e[i] > 0 then return nil end
      v, n = i, k
    end
  end
  if not v or n < 3 or one.c ~= -two.c then return nil end
  for i, k in ipairs(two.e) do
    if k == n then return poly.sub(poly.generator(p.ring, v, 1), poly.generator(p.ring, i, 1)) end
  end
end

-- A proper divisor of p with more than one term, or nil.
-- What stood in the scene comes first, for that is what its author expects to see; the gcds, which cost the most, last.
local function divisor(p, hints)
  for _, h in ipairs(hints) do
    if h.n <= p.n and not poly.iszero(poly.sub(h, p)) and poly.divide(p, h) then return h end
  end
  local root = root_of_binomial(p)
  if root and poly.divide(p, root) then return root end
  for v = 1, p.n <= readable and #p.ring.gens or 0 do
    if gcd.degree(p, v) > 0 then
      local c = without(p, v) and gcd.content_in(p, v)
      if c and c.n > 1 then return c end
      if p.ring.relation[v] == nil and repeated(p, v) then
        local twice = gcd.of(p, derivative(p, v))
        if twice.n > 1 then return twice end
      end
    end
  end
end

-- p as an expression, in differences x - x1 where it is the same for all x of a class moved together (the places of a
-- body's points), which is so if and only if the sum of its derivatives by them is zero: then all may be moved by -x1,
-- so that x1 is at 0 and the others are differences.  Multiplied out, such a sum loses all digits far from the origin.
-- x1^2 - 2 x1 x2 + x2^2 ==> (x2 - x1)^2: the terms without x1 are kept, and each other x becomes x - x1.
local function in_differences(p, classes)
  local map = {}
  for _, class in ipairs(p.n > 1 and classes or {}) do
    local moved = poly.constant(p.ring, R.zero)
    for _, v in ipairs(class) do moved = poly.add(moved, derivative(p, v)) end
    if gcd.degree(p, class[1]) > 0 and poly.iszero(moved) then
      local rest = poly.constant(p.ring, R.zero)
      for _, t in ipairs(poly.sorted(p)) do
        if t.e[class[1]] == 0 then rest = poly.add(rest, poly.term(p.ring, t)) end
      end
      p = rest
      for k = 2, #class do map[p.ring.gens[class[k]]] = p.ring.gens[class[k]] - p.ring.gens[class[1]] end
    end
  end
  return calculus.substitute(poly.expr(p), map)
end

-- The polynomial as an expression, a product of what is found.  What was found for a ring is kept in it.
function factor.product(p, hints)
  local ring, list = p.ring, {}
  ring.factored = ring.factored or {}
  local function take(q)
    local c, low = poly.content(q)
    q = poly.shift(q, c, low)
    list[#list + 1] = expr.num(c)
    for i, n in ipairs(low) do
      if n ~= 0 then list[#list + 1] = expr.pow(ring.gens[i], n) end
    end
    local e = poly.expr(q)
    local known = ring.factored[e]
    if known == nil then
      known = q.n > 1 and divisor(q, hints) or false
      ring.factored[e] = known
    end
    local rest = known and poly.divide(q, known)
    if rest then
      take(known)
      take(rest)
    else
      list[#list + 1] = in_differences(q, hints.classes or {})
    end
  end
  take(p)
  return expr.mul(list)
end

return factor
