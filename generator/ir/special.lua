-- special.lua: the functions that libm lacks, as the emitted C computes them, operation for operation.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line: `rounded` rounds to `real` after every operation, so the values equal those of templates/special.c,
-- where the derivation stands, to the bit.  A pair {hi, lo} carries twice the precision.  An entry of special.list is
-- an opcode; adding one takes an entry here, its C in templates/special.c and its value to any number of bits in
-- R.apply.

local special = {}

-- What depends on `real`: steps after the ratio is 2 (each gains 6 bits, from 5 at the start), the least ratio of axes
-- (whose parts of a pair still have some bits), and Dekker's factor.
special.constants = {
  double = { steps = 9, least = 0x1p-1000, split = 0x1p27 + 1 },
  float = { steps = 4, least = 0x1p-120, split = 0x1p12 + 1 },
}

-- Arithmetic of pairs with that rounding, which tells the real type by what it does to 1 + 2^-30.
local function arithmetic(f)
  local A = special.constants[f(1 + 0x1p-30) == 1 and "float" or "double"]
  local P = { constants = A }

  local function sum(a, b) -- Knuth's two-sum
    local hi = f(a + b)
    local bb = f(hi - a)
    return { hi, f(f(a - f(hi - bb)) + f(b - bb)) }
  end

  local function halves(a)
    local c = f(A.split * a)
    local high = f(c - f(c - a))
    return high, f(a - high)
  end

  function P.product(a, b) -- Dekker's
    local ah, al = halves(a)
    local bh, bl = halves(b)
    local hi = f(a * b)
    return { hi, f(f(f(f(f(ah * bh) - hi) + f(ah * bl)) + f(al * bh)) + f(al * bl)) }
  end

  function P.add(a, b)
    local s = sum(a[1], b[1])
    return sum(s[1], f(s[2] + f(a[2] + b[2])))
  end

  function P.multiply(a, b)
    local p = P.product(a[1], b[1])
    return sum(p[1], f(p[2] + f(f(a[1] * b[2]) + f(a[2] * b[1]))))
  end

  function P.quotient(a, b)
    local q = f(a[1] / b[1])
    local p = P.product(q, b[1])
    return sum(q, f(f(f(f(a[1] - p[1]) - p[2]) + f(a[2] - f(q * b[2]))) / b[1]))
  end

  function P.root(a)
    local r = f(math.sqrt(a[1]))
    local p = P.product(r, r)
    return sum(r, f(f(f(f(a[1] - p[1]) - p[2]) + a[2]) / f(2 * r)))
  end

  function P.scaled(a, power) return { f(a[1] * power), f(a[2] * power) } end

  return P
end

local next_of, after = { 2, 3, 1 }, { 3, 1, 2 }

-- Sorted axes, the shares of the three in that order, their sum.
local function parts(f, a, b, c)
  local P = arithmetic(f)
  local axis = { a, b, c }
  table.sort(axis, function(x, y) return x > y end)
  local r, s, x, e = {}, {}, {}, {}
  for i = 1, 3 do
    local ratio = f(axis[3] / axis[i])
    if ratio < P.constants.least then ratio = P.constants.least end
    r[i], s[i] = { ratio, 0.0 }, { ratio, 0.0 }
    x[i], e[i] = P.product(ratio, ratio), { 0.0, 0.0 }
  end
  local left, scale = P.constants.steps, 1.0
  while left > 0 do
    if x[3][1] <= f(2 * x[1][1]) then left = left - 1 end
    local sum = {}
    for i = 1, 3 do sum[i] = P.add(s[next_of[i]], s[after[i]]) end
    for i = 1, 3 do
      x[i] = P.multiply(sum[next_of[i]], sum[after[i]])
      local t = P.multiply(P.quotient(r[i], s[i]), P.quotient(r[i], x[i]))
      e[i] = P.add(e[i], P.scaled(t, scale))
      x[i] = P.scaled(x[i], 0.25)
      s[i] = P.root(x[i])
    end
    scale = f(scale * 0.25)
  end
  for i = 1, 3 do
    local mean = f(f(f(f(3 * x[i][1]) + x[next_of[i]][1]) + x[after[i]][1]) / 5)
    local t = f(f(scale * f(r[i][1] / f(math.sqrt(mean)))) * f(r[i][1] / f(3 * mean)))
    e[i] = P.add(e[i], { t, 0.0 })
  end
  local h = {}
  for i = 1, 3 do
    local t = P.scaled(P.add(e[next_of[i]], e[after[i]]), 0.5)
    h[i] = P.multiply(r[i], P.multiply(r[i], t))
  end
  return axis, h, P.add(P.add(h[1], h[2]), h[3])
end

local function valid(a, b, c) return a > 0 and b > 0 and c > 0 and a + b + c < math.huge end

-- name, number of operands, value.  Outside the domain the value is NaN.
special.list = {
  { "ellipsoid_area", 3, function(rounded, a, b, c)
    if not valid(a, b, c) then return 0.0 / 0.0 end
    local axis, _, sum = parts(rounded, a, b, c)
    return axis[1] * rounded(axis[2] * sum[1])
  end },
  { "ellipsoid_normal", 3, function(rounded, a, b, c)
    if not valid(a, b, c) then return 0.0 / 0.0 end
    local _, h, sum = parts(rounded, a, b, c)
    return h[1 + (b > a and 1 or 0) + (c > a and 1 or 0)][1] / sum[1]
  end },
}

special.arity, special.value = {}, {}
for _, row in ipairs(special.list) do special.arity[row[1]], special.value[row[1]] = row[2], row[3] end

return special
