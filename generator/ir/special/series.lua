-- series.lua: means over arcs and catenaries, as the emitted C computes them, operation for operation.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line.  templates/numeric/series.c says what each function is and has the derivation.  Up to 3 the values
-- equal those of the C to the bit; beyond, the closed forms call sin, cos and exp, and are as good as libm's.
-- Why two branches: for small arguments the closed forms are differences of nearly equal numbers, 1 - sin(y)/y and the
-- like; a series in y^2 begins with what is left of them.  At 3 that is over, and the series still has few terms.

local pair = require "generator.ir.special.pair"

local series = {}

-- Terms enough at 3: what is left out of the slowest series, (12)^(2 n)/(96 (2 n)!) of 761, is below 2^-60 and 2^-30.
series.terms = { double = 28, float = 20 }

-- Is the series taken?  With the rounding f of the type, as the C compares.
local function short(f, x) return f(x * x) <= 9 end

-- P with the steps of a series, and its number of terms.  Terms are pairs: the series of an arc alternate, and the
-- moduli of their terms add up to less than 32 times the sum, which would cost a single number five bits.
-- term(t, x, n): t x/n, the next one before its weight; weights and n are whole numbers that every type has exactly.
local function arithmetic(f)
  local P = pair.arithmetic(f)
  function P.of(x) return { x * 1.0, 0.0 } end
  function P.minus(a) return { -a[1], -a[2] } end
  function P.term(t, x, n) return P.quotient(P.multiply(t, x), P.of(n)) end
  function P.times(t, weight) return P.multiply(t, P.of(weight)) end
  return P, series.terms[P.real]
end

-- Mean of sin(t)^2 over |t| <= h: (1 - sin(y)/y)/2 = (y^2/12) sum of (-y^2)^(n-1) 6/((2 n + 1)!), y = 2 h, n >= 1.
-- The first term is 1, so the factor y^2/12 carries the size and the sum is near 1 for a short arc.
local function arc_across(f, h)
  local y = f(2 * h)
  if not short(f, h) then return 0.5 * f(1 - f(f(math.sin(y)) / y)) end
  local P, terms = arithmetic(f)
  local x, t = P.product(y, y), P.of(1)
  local sum = t
  for n = 2, terms do
    t = P.minus(P.term(t, x, 2 * n * (2 * n + 1)))
    sum = P.add(sum, t)
  end
  return P.multiply(x, sum)[1] / 12
end

-- Variance of cos(t) over |t| <= h: (1 + sin(y)/y)/2 - (sin(h)/h)^2 = (y^4/720) sum of (n - 2) (-y^2)^(n-3) 720/(2 n)!,
-- n >= 3.  Of fourth order, for a short arc is nearly straight: the closed form would lose all digits below h = 1e-4.
local function arc_along(f, h)
  local y = f(2 * h)
  if not short(f, h) then
    local mean = f(f(math.sin(h)) / h)
    return f(0.5 * f(1 + f(f(math.sin(y)) / y))) - f(mean * mean)
  end
  local P, terms = arithmetic(f)
  local x, t = P.product(y, y), P.of(1)
  local sum = t
  for n = 4, terms do
    t = P.minus(P.term(t, x, (2 * n - 1) * (2 * n)))
    sum = P.add(sum, P.times(t, n - 2))
  end
  return P.multiply(x, P.multiply(x, sum))[1] / 720
end

-- Mean of t sin(t) over |t| <= h: sin(h)/h - cos(h) = (h^2/3) sum of n (-h^2)^(n-1) 6/((2 n + 1)!), n >= 1
local function arc_lever(f, h)
  if not short(f, h) then return f(f(math.sin(h)) / h) - f(math.cos(h)) end
  local P, terms = arithmetic(f)
  local x, t = P.product(h, h), P.of(1)
  local sum = t
  for n = 2, terms do
    t = P.minus(P.term(t, x, 2 * n * (2 * n + 1)))
    sum = P.add(sum, P.times(t, n))
  end
  return P.multiply(x, sum)[1] / 3
end

-- Mean height of the catenary cosh(x), |x| <= u, over its vertex, divided by its half length s = sinh(u):
-- ((u/s + cosh(u))/2 - 1)/s.  With y = 2 u: y/3 times sum of 6 y^(2 n - 2) (1/2 - 4^-n)/(2 n + 1)! over sum of
-- 2 y^(2 n - 2)/(2 n)!, n >= 1.  All terms are positive.  Beyond 3 by w = exp(-u), which stays in the range where
-- cosh(u) leaves it.
local function catenary_rise(f, u)
  local y = f(2 * u)
  if not short(f, u) then
    local w = f(math.exp(-u))
    local d = f(1 - f(w * w))
    return 0.5 - f(f(w * f(f(2 - f(f(y * w) / d)) - w)) / d)
  end
  local P, terms = arithmetic(f)
  local x, t, sum, power = P.product(y, y), P.of(1), P.of(0.25), 0.25
  local square, odd = t, t
  for n = 2, terms do
    power = 0.25 * power
    t = P.term(t, x, (2 * n - 1) * (2 * n))
    odd = P.term(odd, x, 2 * n * (2 * n + 1))
    square = P.add(square, t)
    sum = P.add(sum, P.times(odd, f(0.5 - power)))
  end
  return f(y * P.quotient(sum, square)[1]) / 3
end

-- Variance of that height over s^2: 1/12 + (3/4 - u coth(u)/2)/s^2 - u^2/(4 s^4) = sum of y^(2 n) (4^n - 24 n + 32)/
-- (96 (2 n)!)/s^4, n >= 3, where y^2/4 of s^2 is taken out.  All terms are positive.
local function catenary_height(f, u)
  local y = f(2 * u)
  if not short(f, u) then
    local w = f(math.exp(-u))
    local i = f(f(2 * w) / f(1 - f(w * w)))
    local ui = f(u * i)
    local bracket = f(f(f(f(0.5 * u) * f(1 + f(w * i))) - 0.75) + f(f(0.25 * ui) * ui))
    return f(1 / 12) - f(f(i * i) * bracket)
  end
  local P, terms = arithmetic(f)
  local one = P.of(1)
  local x, t, even, sum, power = P.product(y, y), one, one, P.of(24), 64.0
  for n = 4, terms do
    power = 4 * power
    t = P.term(t, x, (2 * n - 1) * (2 * n))
    even = P.add(even, t)
    sum = P.add(sum, P.times(t, f(power - (24 * n - 32))))
  end
  local square = P.add(one, P.term(P.add(one, P.term(even, x, 30)), x, 12))
  sum = P.quotient(sum, P.multiply(square, square))
  return P.multiply(x, sum)[1] / 4320
end

-- Variance of x over u^2: 1 - 2 coth(u)/u + 2/u^2 = (1 + q)/(3 + q), from Lambert's fraction u coth(u) =
-- 1 + u^2/(3 + q), q = u^2/(5 + ..)
local function catenary_width(f, u)
  if not short(f, u) then
    local w = f(math.exp(-u))
    local ww = f(w * w)
    return 1 - f(f(2 / u) * f(f(f(u - 1) / u) + f(f(2 * ww) / f(1 - ww))))
  end
  local q = 0.0
  for n = series.terms[pair.arithmetic(f).real], 2, -1 do q = f(f(u * u) / f((2 * n + 1) + q)) end
  return f(1 + q) / f(3 + q)
end

-- name, number of operands, value
series.list = {
  { "arc_across", 1, arc_across }, { "arc_along", 1, arc_along }, { "arc_lever", 1, arc_lever },
  { "catenary_rise", 1, catenary_rise }, { "catenary_height", 1, catenary_height },
  { "catenary_width", 1, catenary_width },
}

return series
