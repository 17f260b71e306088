-- special.lua: the functions that libm lacks, as the emitted C computes them, operation for operation.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line: `rounded` rounds to `real` after every operation, so the values equal those of
-- templates/numeric/special.c, where the derivation stands, to the bit; series.lua has those of
-- templates/numeric/series.c.  A pair {hi, lo} carries twice the precision (pair.lua).  An entry of special.list is an
-- opcode; adding one takes an entry here, its C in a template and its value to any number of bits in R.apply.

local pair = require "generator.ir.special.pair"
local series = require "generator.ir.special.series"

local special = {}

-- What depends on `real`: steps after the ratio is 2 (each gains 6 bits, from 5 at the start), the least ratio of axes
-- (whose parts of a pair still have some bits).
special.constants = {
  double = { steps = 9, least = 0x1p-1000 },
  float = { steps = 4, least = 0x1p-120 },
}

local next_of, after = { 2, 3, 1 }, { 3, 1, 2 }

-- Sorted axes, the shares of the three in that order, their sum.
local function parts(f, a, b, c)
  local P = pair.arithmetic(f)
  local constants = special.constants[P.real]
  local axis = { a, b, c }
  table.sort(axis, function(x, y) return x > y end)
  local r, s, x, e = {}, {}, {}, {}
  for i = 1, 3 do
    local ratio = f(axis[3] / axis[i])
    if ratio < constants.least then ratio = constants.least end
    r[i], s[i] = { ratio, 0.0 }, { ratio, 0.0 }
    x[i], e[i] = P.product(ratio, ratio), { 0.0, 0.0 }
  end
  local left, scale = constants.steps, 1.0
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
  { "clamp", 3, function(_, x, low, high)
    local number = x == x and x or 0.0 -- NaN counts as 0
    return number > low and (number < high and number or high) or low
  end },
  { "sign", 1, function(_, x) return x < 0 and -1.0 or x > 0 and 1.0 or 0.0 end },
  { "min", 2, function(_, x, y) return y < x and y or x end },
  { "max", 2, function(_, x, y) return x < y and y or x end },
}

table.move(series.list, 1, #series.list, #special.list + 1, special.list)

special.arity, special.value = {}, {}
for _, row in ipairs(special.list) do special.arity[row[1]], special.value[row[1]] = row[2], row[3] end

return special
