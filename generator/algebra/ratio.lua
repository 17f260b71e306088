-- ratio.lua -- rational functions: decisive zero test, cancelled and factored form.
--
-- ABOVE the line.  tidy(e) writes e as  c * monomial * numerator / denominator  with the greatest common divisor
-- cancelled: (M*(a^2+c^2)/12 - M*(a^2+b^2)/12) / (M*(b^2+c^2)/12) becomes (c^2 - b^2)/(b^2 + c^2), in which
-- near-equal moments no longer cancel large terms.  Numerator and denominator stand as products of the factors that
-- are found (factor.lua).  Work is bounded: what would expand beyond `budget` products of terms is left as it is,
-- which is always correct, and the zero test then rests on values at random points (see iszero).
--
-- A fraction is a pair of polynomials of one ring (poly.lua); sums are taken over the least common denominator, which
-- the gcd gives: a/b + c/d = (a d' + c b')/(b d'), b = g b', d = g d'.  Else each sum would multiply the denominators.
-- What is cancelled may be zero for some parameters: the result equals e wherever e has a value, and may have one where
-- e has none.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local factor = require "generator.algebra.factor"
local gcd = require("generator.algebra.gcd").of
local poly = require "generator.algebra.poly"
local evaluate = require "generator.algebra.evaluate"

local ratio = {}

local budget = 60000 -- products of terms; about 0.1 s

-- f(...) within the grant: its result, or nil when that is used up.  Nested calls share the outermost grant.
local function bounded(grant, f, ...)
  if poly.budget then return f(...) end
  poly.budget = grant
  local ok, result = pcall(f, ...)
  poly.budget = nil
  if ok then return result end
  if result == poly.exhausted or string.find(tostring(result), "number too large", 1, true) then return nil end
  error(result, 0)
end

---- fractions -------------------------------------------------------------------------------------

-- e as numerator and denominator polynomials of the ring.
-- Numerator and denominator may have common factors; a sum's denominator alone is kept least.  A power p/q is the p-th
-- power of the generator base^(1/q). memo: node -> {numerator, denominator}.
local function fraction(ring, e, memo)
  local f = memo[e]
  if f then return f end
  local one = poly.constant(ring, R.one)
  if ring.index[e] or e.kind == "num" then
    f = { poly.from(ring, e), one }
  elseif e.kind == "pow" then
    local n = R.toint(R.num(e.exp))
    local base
    if R.isint(e.exp) then
      base = fraction(ring, e.base, memo)
    else
      base = { poly.from(ring, expr.pow(e.base, R.one / R.den(e.exp))), one }
    end
    f = { poly.power(base[n > 0 and 1 or 2], math.abs(n)), poly.power(base[n > 0 and 2 or 1], math.abs(n)) }
  elseif e.kind == "mul" then
    f = { one, one }
    for i = 1, #e do
      local g = fraction(ring, e[i], memo)
      f = { poly.mul(f[1], g[1]), poly.mul(f[2], g[2]) }
    end
  elseif e.kind == "add" then
    f = { poly.constant(ring, R.zero), one }
    for i = 1, #e do
      local g = fraction(ring, e[i], memo)
      local common = gcd(f[2], g[2])
      local df, dg = poly.divide(f[2], common), poly.divide(g[2], common)
      if not df or not dg then df, dg = f[2], g[2] end
      f = { poly.add(poly.mul(f[1], dg), poly.mul(g[1], df)), poly.mul(f[2], dg) }
    end
  else
    error("not a rational function: " .. e.kind)
  end
  memo[e] = f
  return f
end

-- The value of e at the n-th of a fixed sequence of random points, to so many bits; nil where it has none.
local function sample(e, n, bits)
  local env, state = {}, 1 + 7919 * n
  for _, s in ipairs(expr.symbols(e)) do
    state = state * 48271 % 2147483647 -- Lehmer's generator (Park, Miller, 1988)
    env[s.name] = R.new(2147483647 + state, 2147483647) -- in (1, 2): positive, as masses and lengths are
  end
  local ok, value = pcall(evaluate.precise, e, env, bits)
  return ok and value or nil
end

-- Is e zero at the n-th point?  A value that is there stays the same with twice the bits; one that is only rounding
-- shrinks with them, whatever the scale of the terms.  nil where e has no value.
local function vanishes(e, n)
  local rough, fine = sample(e, n, 400), sample(e, n, 800)
  if not rough or not fine then return nil end
  if R.sign(fine) == 0 then return true end
  local change = rough - fine
  return R.sign(change) ~= 0 and R.log2(change) > R.log2(fine) - 64
end

-- Is e identically zero?  A value at one point settles "no"; "yes" is proved by the normal form, decisive for rational
-- functions of the generators (poly.lua).  Where that would be too large, or generators are opaque, so that it does not
-- see what they have to do with each other, it rests on three random points (Schwartz 1980: a polynomial of degree d
-- vanishes at such a point with probability below d/2^31).
function ratio.iszero(e)
  if e.kind == "num" then return R.sign(e.value) == 0 end
  if vanishes(e, 0) == false then return false end
  local proved = bounded(budget, function()
    local ring = poly.ring { e }
    return poly.iszero(fraction(ring, e, {})[1]) and "zero" or not ring.opaque and "other" or nil
  end)
  if proved then return proved == "zero" end
  for n = 1, 3 do
    if not vanishes(e, n) then return false end
  end
  return true
end

function ratio.equal(a, b) return a == b or ratio.iszero(a - b) end

-- Node -> its tidy form, or false where that was too large.  A tidy form is its own: tidy(tidy(e)) is tidy(e).
local tidied = setmetatable({}, { __mode = "k" })

-- Roots of sums double the terms of whatever they are multiplied with; with many of them nothing cancels anyway.
local most_roots = 3

local function ring_of(list)
  local ring, roots = poly.ring(list), 0
  for _, g in ipairs(ring.gens) do
    if g.kind == "pow" and g.base.kind ~= "num" then roots = roots + 1 end
  end
  if roots > most_roots then error(poly.exhausted, 0) end
  return ring
end

-- The quotient of two polynomials as an expression.
-- In lowest terms; if the gcd was only a divisor, in lower ones.
local function lowest(a, b, hints)
  if poly.iszero(a) then return expr.zero end
  local common = gcd(a, b)
  local n, d = poly.divide(a, common), poly.divide(b, common)
  if not n or not d then n, d = a, b end
  return factor.product(n, hints) / factor.product(d, hints)
end

-- Raises poly.exhausted.
local function cancelled(e)
  local ring = ring_of { e }
  local f = fraction(ring, e, {})
  return lowest(f[1], f[2], factor.hints(ring, e))
end

-- a / d for each a of the list, tidied together: what they share is expanded and factored once.  nil if that is too
-- large.
function ratio.over(list, d)
  return bounded(budget, function()
    local ring, memo, out = ring_of { d, table.unpack(list) }, {}, {}
    local hints, below = factor.hints(ring, d), fraction(ring, d, memo)
    for i, a in ipairs(list) do
      local f = fraction(ring, a, memo)
      out[i] = lowest(poly.mul(f[1], below[2]), poly.mul(f[2], below[1]), hints)
    end
    return out
  end)
end

-- e cancelled and factored: equal to e wherever e is defined.  Second result: false if it was too large and is left
-- as it was.  limit: products of terms that may be spent on it, when less than usual.
function ratio.tidy(e, limit)
  if e.kind == "num" or e.kind == "sym" then return e, true end
  local known = tidied[e]
  if known == nil then
    known = bounded(limit or budget, cancelled, e) or false
    tidied[e] = known
    if known then tidied[known] = known end
  end
  return known or e, known ~= false
end

return ratio
