-- elliptic.lua -- elliptic integrals of the first kind and theta series, to any number of bits, in rationals.
--
-- Integrals by the arithmetic-geometric mean (DLMF 19.8; Abramowitz, Stegun, 17.6).  Moduli come as the complement
-- k' = sqrt(1 - k^2), so that k near 1 is as good as any; k' = 0 is allowed wherever the value is finite.
-- For expected values and for constants computed when the code is made; the emitted code has Carlson's duplication.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local elliptic = {}

-- x to `bits` bits; root of x >= 0
local function root(x, bits) return R.sign(x) == 0 and x or R.apply("sqrt", bits, x) end
elliptic.root = root

-- exp(x), 0 where that is below 2^-500000
function elliptic.exp(x, bits) return R.apply("exp", bits, x) or R.zero end

function elliptic.pi(bits) return R.apply("pi", bits) end

-- K(k) = pi/(2 agm(1, k')); nil (infinite) for k' = 0.
function elliptic.complete(kc, bits)
  if R.sign(kc) == 0 then return nil end
  return R.round(elliptic.pi(bits) / (2 * R.apply("agm", bits, R.one, kc)), bits)
end

-- F(phi, k), |phi| <= pi/2 the angle of the vector (x, y), x >= 0: tan(phi_(n+1) - phi_n) = b_n/a_n tan phi_n,
-- F = lim phi_n/(2^n a_n).  Angles are kept as vectors, each component with all its bits: next to pi/2, where F
-- grows as 1/k', none is lost.  k' = 0: the inverse Gudermannian, finite for x > 0.
function elliptic.first(x, y, kc, bits)
  if R.sign(kc) == 0 then return R.sign(y) == 0 and y or R.apply("asinh", bits, y / x) end
  local function round(v) return R.round(v, bits) end
  local a, b, power = R.one, kc, 0
  -- The same angle in doubles: it counts the whole turns, which the vector (x, y) does not know.
  local about = math.atan(R.todouble(R.round(y / (R.abs(x) + R.abs(y)), 53)), R.todouble(x / (R.abs(x) + R.abs(y))))
  while R.sign(a - b) ~= 0 and R.log2(a - b) > R.log2(a) - bits + 2 do
    local u, v = a * x, b * y
    local size = R.abs(u) + R.abs(v)
    -- the angle of (u, v) is in the quadrant of phi: that of (x, y) and its half-turns
    local here, own = math.atan(R.todouble(v / size), R.todouble(u / size)), R.abs(x) + R.abs(y)
    local turns = (about - math.atan(R.todouble(y / own), R.todouble(x / own))) / (2 * math.pi)
    about = about + here + 2 * math.pi * math.floor(turns + 0.5)
    x, y = round((u * x - v * y) / (own * size)), round((v * x + u * y) / (own * size))
    a, b = round((a + b) / 2), root(a * b, bits)
    power = power + 1
  end
  if R.sign(y) == 0 and R.sign(x) > 0 and math.abs(about) < 1 then return R.zero end
  -- all bits from the vector, the turns from `about`
  local angle = R.apply("atan2", bits, y, x)
  local turns = math.floor((about - R.todouble(angle)) / (2 * math.pi) + 0.5)
  angle = angle + 2 * R.new(turns) * elliptic.pi(bits + 64)
  return round(angle / (a * R.new(2) ^ power))
end

-- The sum of term(n), n >= 0: term returns a value and a bound of what follows it.
function elliptic.sum(term, bits)
  local sum, least = R.zero, R.new(2) ^ -bits
  for n = 0, bits do -- theta series end much earlier
    local value, bound = term(n)
    sum = R.round(sum + value, bits + 16)
    if bound < least then break end
  end
  return R.round(sum, bits)
end

return elliptic
