-- pair.lua: arithmetic of twice the precision, operation for operation that of templates/numeric/pair.c.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line.  A pair {hi, lo} is the unevaluated sum of two numbers of `real`, |lo| <= ulp(hi)/2.
-- sum and product are exact as long as nothing over- or underflows: a + b = hi + lo in six operations (Knuth, TAOCP 2,
-- 4.2.2, theorem B), a b = hi + lo in seventeen (Dekker 1971, Numer. Math. 18, 224), in rounding to nearest without
-- contraction.  add, multiply, quotient and root keep about 2^-104 (in float 2^-46) of the result, or of the larger
-- operand where a sum cancels: some units of the last place of lo.

local pair = {}

local splits = { double = 0x1p27 + 1, float = 0x1p12 + 1 } -- Dekker's factor

-- Arithmetic of pairs with that rounding, which tells the real type by what it does to 1 + 2^-30.
function pair.arithmetic(f)
  local real = f(1 + 0x1p-30) == 1 and "float" or "double"
  local split = splits[real]
  local P = { real = real }

  local function sum(a, b) -- Knuth's two-sum
    local hi = f(a + b)
    local bb = f(hi - a)
    return { hi, f(f(a - f(hi - bb)) + f(b - bb)) }
  end

  -- a = high + low, each of half the bits, so that products of halves are exact
  local function halves(a)
    local c = f(split * a)
    local high = f(c - f(c - a))
    return high, f(a - high)
  end

  function P.product(a, b) -- Dekker's
    local ah, al = halves(a)
    local bh, bl = halves(b)
    local hi = f(a * b)
    return { hi, f(f(f(f(f(ah * bh) - hi) + f(ah * bl)) + f(al * bh)) + f(al * bl)) }
  end

  -- The low parts are added once, in the type: what that loses is relative to the larger operand.
  function P.add(a, b)
    local s = sum(a[1], b[1])
    return sum(s[1], f(s[2] + f(a[2] + b[2])))
  end

  function P.multiply(a, b)
    local p = P.product(a[1], b[1])
    return sum(p[1], f(p[2] + f(f(a[1] * b[2]) + f(a[2] * b[1]))))
  end

  -- q + (a - q b)/b from q = a/b, the difference exact but for q times b's low part
  function P.quotient(a, b)
    local q = f(a[1] / b[1])
    local p = P.product(q, b[1])
    return sum(q, f(f(f(f(a[1] - p[1]) - p[2]) + f(a[2] - f(q * b[2]))) / b[1]))
  end

  -- r + (a - r^2)/(2 r), one step of Newton
  function P.root(a)
    local r = f(math.sqrt(a[1]))
    local p = P.product(r, r)
    return sum(r, f(f(f(f(a[1] - p[1]) - p[2]) + a[2]) / f(2 * r)))
  end

  function P.scaled(a, power) return { f(a[1] * power), f(a[2] * power) } end

  return P
end

return pair
