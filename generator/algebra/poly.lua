-- poly.lua -- multivariate polynomials with rational coefficients over chosen generators.
--
-- ABOVE the line.  A polynomial belongs to a ring {gens = list of expr nodes}: its generators are symbols,
-- function calls and simple roots x^(1/q).  It is a map from the exponent key to {c = coefficient,
-- e = exponents}.  Three relations keep the form normal:  cos(a)^2 ==> 1 - sin(a)^2,  |a|^2 ==> a^2  and
-- (x^(1/q))^q ==> x.  Zero testing is therefore decisive for rational functions of symbols, roots of
-- symbols, and sines and cosines.  Not here: fractions and factored display (ratio.lua).
--
-- Why the form is normal.  Order the generators so that cos(a) is above sin(a), |a| and a root above what is in them
-- (no generator is inside itself, so there is such an order).  Then each relation's leading term is a power of one
-- generator, and no two are powers of the same; leading terms without a common factor make a Groebner basis
-- (Buchberger's first criterion), so the remainder does not depend on the order of the rewriting, and equal elements
-- of the ring have equal polynomials.  What the relations do not say, sin(2 a) = 2 sin(a) cos(a) or sqrt(x) sqrt(y) =
-- sqrt(x y), is not known here: the constructors of expr see to the second, and a scene rarely has the first.
--
-- Invariants.  No term has the coefficient 0; n is the number of terms; exponents are whole numbers >= 0, and in what
-- mul and from give below the degree of the generator's relation.  Terms are never changed, so polynomials share them.
-- With n and m terms and g generators: a sum costs n + m, a product n m g, before rewriting.  Terms are in a hash
-- table: where an order matters, `sorted` gives the lexicographic one, in which lead(a b) = lead(a) lead(b).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local poly = {}

---- rings -----------------------------------------------------------------------------------------

-- The generators that the expressions need, as a list in canonical order; with cos(a) always sin(a), with |a| what a
-- needs, for their relations.  Of several roots of one base the common one is taken: x^(1/2) and x^(1/3) are powers of
-- x^(1/6).
local function generators(list)
  local seen, gens = {}, {}
  local bases, degree = {}, {}
  local function put(g)
    if not seen[g] then
      seen[g] = true
      gens[#gens + 1] = g
    end
  end
  local visited = {}
  local function walk(e)
    if visited[e] then return end
    visited[e] = true
    if e.kind == "sym" then
      put(e)
    elseif e.kind == "call" then
      put(e)
      if e.fn == "cos" then put(expr.call("sin", e[1])) end
      if e.fn == "abs" then walk(e[1]) end
    elseif e.kind == "pow" then
      if not R.isint(e.exp) then
        if not degree[e.base] then bases[#bases + 1] = e.base end
        local d, old = R.den(e.exp), degree[e.base] or R.one
        degree[e.base] = d * old / R.gcd(d, old)
      end
      if e.base.kind ~= "num" then walk(e.base) end
    else
      for i = 1, #e do walk(e[i]) end
    end
  end
  for _, e in ipairs(list) do walk(e) end
  for _, base in ipairs(bases) do put(expr.pow(base, R.one / degree[base])) end
  table.sort(gens, function(a, b) return expr.compare(a, b) < 0 end)
  return gens
end

-- A ring for the expressions in the list, with the rewriting relation of each generator that has one.  opaque: may its
-- generators have relations that are not known?
function poly.ring(list)
  local ring = { gens = generators(list), index = {}, relation = {}, root = {} }
  for i, g in ipairs(ring.gens) do
    ring.index[g] = i
    if g.kind == "pow" then ring.root[g.base] = i end
  end
  for i, g in ipairs(ring.gens) do
    if g.kind == "call" and g.fn == "cos" then
      local s = poly.generator(ring, ring.index[expr.call("sin", g[1])])
      ring.relation[i] = { degree = 2, value = poly.sub(poly.constant(ring, R.one), poly.mul(s, s)) }
    elseif g.kind == "call" and g.fn == "abs" then
      local inside = poly.from(ring, g[1])
      if inside then ring.relation[i] = { degree = 2, value = poly.mul(inside, inside) } end
    elseif g.kind == "pow" then
      local value = poly.from(ring, g.base)
      if value then ring.relation[i] = { degree = R.toint(R.den(g.exp)), value = value } end
    end
    ring.opaque = ring.opaque or g.fn == "opaque"
  end
  return ring
end

-- Exponents are whole and not negative, and each code says its own length: no two lists have the same bytes.
local function key(e) return utf8.char(table.unpack(e)) end

local function new(ring) return { ring = ring, terms = {}, n = 0 } end

-- Adds the term c g^e to p, which is still being made.  k: the key of e, where it is known
local function put(p, e, c, k)
  k = k or key(e)
  local t = p.terms[k]
  if t then
    c = t.c + c
    if R.sign(c) == 0 then
      p.terms[k] = nil
      p.n = p.n - 1
      return
    end
    p.terms[k] = { c = c, e = e }
  elseif R.sign(c) ~= 0 then
    p.terms[k] = { c = c, e = e }
    p.n = p.n + 1
  end
end

-- The polynomial c; that of 0 has no term.
function poly.constant(ring, c)
  local p, e = new(ring), {}
  for i = 1, #ring.gens do e[i] = 0 end
  put(p, e, c)
  return p
end

-- Generator i to the power (1 if nil).  Not rewritten, even where its relation would: gcd.lua divides by such powers.
function poly.generator(ring, i, power)
  local p, e = new(ring), {}
  for j = 1, #ring.gens do e[j] = j == i and (power or 1) or 0 end
  put(p, e, R.one)
  return p
end

-- One term of another polynomial of the ring.
function poly.term(ring, t)
  local p = new(ring)
  put(p, t.e, t.c)
  return p
end

function poly.iszero(p) return p.n == 0 end

-- Terms as a list, leading one first (lexicographic in the ring's order).
function poly.sorted(p)
  local list = {}
  for _, t in pairs(p.terms) do list[#list + 1] = t end
  table.sort(list, function(a, b)
    for i = 1, #a.e do
      if a.e[i] ~= b.e[i] then return a.e[i] > b.e[i] end
    end
    return false
  end)
  return list
end

---- arithmetic ------------------------------------------------------------------------------------

-- Of two in normal form the result is, too; keys are the same in both, so b's need not be made again.
local function combine(a, b, negative)
  local p = new(a.ring)
  for k, t in pairs(a.terms) do p.terms[k] = t end
  p.n = a.n
  for k, t in pairs(b.terms) do put(p, t.e, negative and -t.c or t.c, k) end
  return p
end

function poly.add(a, b) return combine(a, b, false) end
function poly.sub(a, b) return combine(a, b, true) end

-- c a for a rational c
function poly.scale(a, c)
  local p = new(a.ring)
  for k, t in pairs(a.terms) do put(p, t.e, c * t.c, k) end
  return p
end

-- Rewrites powers of generators that have a relation until none is left.  It ends: each round lowers the degree in
-- generator i of all that is too high by the relation's degree, and what the value brings in stands lower in the order.
local function reduce(p)
  local ring = p.ring
  for i = 1, #ring.gens do
    local rel = ring.relation[i]
    local todo = rel ~= nil
    while todo do
      local kept, high = new(ring), {}
      for k, t in pairs(p.terms) do -- sums of exact terms: order is lost anyway
        if t.e[i] >= rel.degree then
          high[#high + 1] = t
        else
          kept.terms[k] = t
          kept.n = kept.n + 1
        end
      end
      todo = #high > 0
      if todo then
        local lowered = new(ring)
        for _, t in ipairs(high) do
          local e = { table.unpack(t.e) }
          e[i] = e[i] - rel.degree
          put(lowered, e, t.c)
        end
        p = poly.add(kept, poly.mul(lowered, rel.value))
      end
    end
  end
  return p
end

-- How many products of terms the caller still grants; nil: any number.  Expansions can grow without bound, and what
-- they are for (cancelling, zero tests) has a cheaper second best.
poly.budget = nil
poly.exhausted = setmetatable({}, { __tostring = function() return "polynomial too large" end })

-- Costs a.n b.n of the grant before anything is multiplied; raises poly.exhausted where that is more than is left.
function poly.mul(a, b)
  local p = new(a.ring)
  if poly.budget then
    poly.budget = poly.budget - a.n * b.n
    if poly.budget < 0 then error(poly.exhausted, 0) end
  end
  local n = #a.ring.gens
  for _, s in pairs(a.terms) do
    local f, c = s.e, s.c
    for _, t in pairs(b.terms) do
      local e, g = {}, t.e
      for i = 1, n do e[i] = f[i] + g[i] end
      put(p, e, c * t.c)
    end
  end
  if next(a.ring.relation) then return reduce(p) end
  return p
end

-- a^n, n >= 0
function poly.power(a, n)
  local p = poly.constant(a.ring, R.one)
  for _ = 1, n do p = poly.mul(p, a) end
  return p
end

---- conversion ------------------------------------------------------------------------------------

-- The polynomial of e in the ring, or nil if e is none (a generator missing or in a denominator).
function poly.from(ring, e)
  local i = ring.index[e]
  if i then return poly.generator(ring, i) end
  if e.kind == "num" then return poly.constant(ring, e.value) end
  if e.kind == "add" or e.kind == "mul" then
    local p = poly.constant(ring, e.kind == "add" and R.zero or R.one)
    for k = 1, #e do
      local q = poly.from(ring, e[k])
      if not q then return nil end
      p = e.kind == "add" and poly.add(p, q) or poly.mul(p, q)
    end
    return p
  end
  if e.kind == "pow" and R.sign(e.exp) > 0 then
    local n = R.toint(R.num(e.exp))
    if R.isint(e.exp) then
      local base = poly.from(ring, e.base)
      return base and poly.power(base, n)
    end
    i = ring.root[e.base]
    local times = i and e.exp / ring.gens[i].exp -- power of the generator
    return i and R.isint(times) and reduce(poly.generator(ring, i, R.toint(times))) or nil
  end
  return nil
end

-- The polynomial as a sum of products of its generators.
function poly.expr(p)
  local list = {}
  for _, t in ipairs(poly.sorted(p)) do
    local factors = { expr.lift(t.c) }
    for i, x in ipairs(t.e) do
      if x ~= 0 then factors[#factors + 1] = expr.pow(p.ring.gens[i], x) end
    end
    list[#list + 1] = expr.mul(factors)
  end
  return expr.add(list)
end

local modest = 4000 -- products of terms that poly.modest grants

-- The ring of e and its polynomial there; nil where e is none or would take too long to multiply out.
-- A grant that runs already takes the place of its own; what is spent of it here is given back.
function poly.modest(e)
  local seen = {}
  local function whole(u) -- no denominators: said before anything is multiplied out
    if seen[u] then return true end
    seen[u] = true
    if u.kind == "pow" and R.sign(u.exp) < 0 then return false end
    if u.kind == "call" then return true end
    for _, c in ipairs(expr.children(u)) do
      if not whole(c) then return false end
    end
    return true
  end
  if not whole(e) then return nil end
  local before = poly.budget
  poly.budget = before or modest
  local ok, ring, p = pcall(function()
    local r = poly.ring { e }
    return r, poly.from(r, e)
  end)
  poly.budget = before
  if not ok and ring ~= poly.exhausted then error(ring, 0) end
  if ok and p then return ring, p end
  return nil
end

---- divisibility ----------------------------------------------------------------------------------

-- Rational content (sign of the leading term) and the lowest power of each generator.
-- -4 x^3 - 6 x: c = -2 and low = {1}, so that what shift leaves, 2 x^2 + 3, has a positive leading term and no common
-- factor that is a number or a monomial.  Of the polynomial 0, c is 0 and low says nothing.
function poly.content(p)
  local c, low = R.zero, {}
  for i = 1, #p.ring.gens do low[i] = math.maxinteger end
  local list = poly.sorted(p)
  for _, t in ipairs(list) do
    c = R.gcd(c, t.c)
    for i, x in ipairs(t.e) do low[i] = math.min(low[i], x) end
  end
  if list[1] and R.sign(list[1].c) < 0 then c = -c end
  return c, low
end

-- p divided by the monomial c * prod g^low.
-- No entry of low may be above a term's exponent.
function poly.shift(p, c, low)
  local q = new(p.ring)
  for _, t in pairs(p.terms) do
    local e = {}
    for i, x in ipairs(t.e) do e[i] = x - low[i] end
    put(q, e, t.c / c)
  end
  return q
end

-- The lexicographically leading term.
local function leading(p)
  local best
  for _, t in pairs(p.terms) do -- the largest of all: order is lost anyway
    local larger = not best
    for i = 1, #t.e do
      if larger or t.e[i] ~= best.e[i] then
        larger = larger or t.e[i] > best.e[i]
        break
      end
    end
    if larger then best = t end
  end
  return best
end

-- a / b if b divides a exactly, else nil.  Lexicographic leading-term division: if a = q b then lead(a) = lead(q)
-- lead(b), so the first term of q is known, and the rest of q is (a - lead(q) b)/b, whose leading term is smaller.
-- As many rounds as the quotient has terms; the first leading term that lead(b) does not divide says no.  Where
-- relations rewrite, the law of leading terms may fail, and then so may the division: that is a "no", never a wrong
-- quotient.
function poly.divide(a, b)
  local lead = leading(b)
  local q = new(a.ring)
  while a.n > 0 do
    local top, e = leading(a), {}
    for i = 1, #lead.e do
      e[i] = top.e[i] - lead.e[i]
      if e[i] < 0 then return nil end
    end
    if poly.budget then poly.budget = poly.budget - a.n end -- looking for the leading term, and the difference
    local m = new(a.ring)
    put(m, e, top.c / lead.c)
    put(q, e, top.c / lead.c)
    local rest = poly.sub(a, poly.mul(m, b))
    if rest.terms[key(top.e)] then return nil end -- a relation brought the leading term back
    a = rest
  end
  return q
end

return poly
