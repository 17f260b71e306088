-- gcd.lua -- greatest common divisor of polynomials.
--
-- ABOVE the line.  The primitive polynomial remainder sequence (Knuth, TAOCP 2, 4.6.1, algorithm C), in one variable
-- after the other.  What would be too large has the greatest common monomial as its divisor: a divisor is always
-- returned, not always the greatest.
--
-- In a variable v, p = content(p) pp(p), the content being the gcd of the coefficients, which do not contain v; and by
-- Gauss' lemma gcd(a, b) = gcd(content(a), content(b)) gcd(pp(a), pp(b)).  The contents have one variable less, so the
-- recursion ends; the primitive parts go through Euclid's algorithm with pseudo-remainders, lead(b)^k a = q b + r, in
-- which nothing is divided.  r is made primitive again after each step: without that its coefficients would grow
-- exponentially, with it they are as small as they can be.
--
-- Most pairs have nothing in common, and that is found out cheaply first: a common factor that contains w is still one
-- when numbers are put in for the other variables, unless the numbers happen to make it a constant; then it is missed,
-- and what is returned is a divisor all the same.  A false alarm costs time alone.
-- Results are up to a rational factor and a sign.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local poly = require "generator.algebra.poly"

local gcd

-- The degree in generator v; -1 of the polynomial 0.
local function degree(p, v)
  local d = -1
  for _, t in pairs(p.terms) do d = math.max(d, t.e[v]) end
  return d
end

-- The coefficient of generator v to the power d.
-- A polynomial without v.
local function coefficient(p, v, d)
  local power, chosen = {}, { ring = p.ring, terms = {}, n = 0 }
  for i = 1, #p.ring.gens do power[i] = i == v and d or 0 end
  for k, t in pairs(p.terms) do -- into a table: order is lost anyway
    if t.e[v] == d then
      chosen.terms[k] = t
      chosen.n = chosen.n + 1
    end
  end
  return poly.shift(chosen, R.one, power)
end

local function degree_sum(p) -- of a single term
  local _, t = next(p.terms)
  local sum = 0
  for _, n in ipairs(t.e) do sum = sum + n end
  return sum
end

-- The greatest common divisor of the coefficients of p as a polynomial in generator v.
-- Of 0 there is none: nil.
local function content_in(p, v)
  local g
  for d = 0, degree(p, v) do
    local c = coefficient(p, v, d)
    if not poly.iszero(c) then g = g and gcd(g, c) or c end
    if g and g.n == 1 and degree_sum(g) == 0 then return g end
  end
  return g
end

-- p without its rational content and without monomial factors; and those, as exponents.
local function primitive(p)
  local c, low = poly.content(p)
  return poly.shift(p, c, low), low
end

-- lead(b)^k a modulo b, in generator v: each round takes away the highest power of v.
local function pseudo_remainder(a, b, v)
  local db = degree(b, v)
  local lead = coefficient(b, v, db)
  while not poly.iszero(a) and degree(a, v) >= db do
    local da = degree(a, v)
    local top = coefficient(a, v, da)
    a = poly.sub(poly.mul(lead, a), poly.mul(poly.mul(top, poly.generator(a.ring, v, da - db)), b))
  end
  return a
end

---- numbers put in for all generators but one: a factor stays a factor ------------------------------

-- Small, so that values stay short; different for neighbours, so that x - y does not vanish.
local primes = { 3, 5, 7, 11, 13, 17, 19, 23 }

-- Coefficients of p in generator v, from degree 0; `other` is added to the number for generator u.
local function specialised(p, v, u, other)
  local c = {}
  for d = 0, degree(p, v) do c[d + 1] = R.zero end
  for _, t in ipairs(poly.sorted(p)) do
    local x = t.c
    for i, n in ipairs(t.e) do
      if i ~= v and n > 0 then x = x * R.new(primes[(i - 1) % #primes + 1] + (i == u and other or 0)) ^ n end
    end
    c[t.e[v] + 1] = c[t.e[v] + 1] + x
  end
  return c
end

-- The list of coefficients without leading zeros; {} is the polynomial 0.
local function trimmed(c)
  while #c > 0 and R.sign(c[#c]) == 0 do c[#c] = nil end
  return c
end

-- Have the two a common factor?  Euclid; both are used up.
local function common(a, b)
  a, b = trimmed(a), trimmed(b)
  if #a < #b then a, b = b, a end
  while #b > 1 do
    while #a >= #b do
      local k, shift = a[#a] / b[#b], #a - #b
      for d = 1, #b do a[d + shift] = a[d + shift] - k * b[d] end
      a[#a] = nil
      trimmed(a)
    end
    a, b = b, a
  end
  return #b == 0
end

-- May a and b have a common factor that is more than a monomial?  A factor in w stays one with numbers for the others.
local function perhaps(a, b)
  for w = 1, #a.ring.gens do
    if degree(a, w) > 0 and degree(b, w) > 0 and common(specialised(a, w), specialised(b, w)) then return true end
  end
  return false
end

-- gcd up to a rational factor; monomial content included.
-- Beyond 4000 products of terms in the first round of Euclid's algorithm the common monomial has to do.
function gcd(a, b)
  local ring = a.ring
  local pa, la = primitive(a)
  local pb, lb = primitive(b)
  local mono = poly.constant(ring, R.one)
  for i = 1, #ring.gens do
    local low = math.min(la[i], lb[i])
    if low > 0 then mono = poly.mul(mono, poly.generator(ring, i, low)) end
  end
  if pa.n == 1 or pb.n == 1 or pa.n * pb.n > 4000 or not perhaps(pa, pb) then return mono end
  local v -- the first generator that both depend on
  for i = #ring.gens, 1, -1 do
    if degree(pa, i) > 0 and degree(pb, i) > 0 then v = i end
  end
  if not v then return mono end
  local ca, cb = content_in(pa, v), content_in(pb, v)
  local c = gcd(ca, cb)
  local x, y = poly.divide(pa, ca), poly.divide(pb, cb)
  if not x or not y then return mono end
  while true do
    local r = pseudo_remainder(x, y, v)
    if poly.iszero(r) then break end
    if degree(r, v) == 0 then
      y = poly.constant(ring, R.one)
      break
    end
    local cr = content_in(r, v)
    r = cr and poly.divide(r, cr) or r
    x, y = y, r
  end
  return poly.mul(mono, poly.mul(c, (primitive(y))))
end

return { of = gcd, degree = degree, content_in = content_in, primitive = primitive, specialised = specialised,
  common = common }
