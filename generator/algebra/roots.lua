-- roots.lua -- the real roots of a polynomial in one variable, in doubles.
--
-- Between two neighbouring stationary points a polynomial is monotone, so it has a root there exactly if its sign
-- differs at the ends, and bisection finds it to the last bit.  The stationary points are the roots of the derivative:
-- recursion down to degree 1.  A double root is found where its value is rounded to zero or changes sign; what is
-- asked for here (where a verdict changes) are the roots of odd order.
--
-- For degree n that is at most n(n+1)/2 bisections, each of some 54 halvings and the logarithm of the interval over the
-- root (at most 2100, for a root at 0).  The value is Horner's sum, whose error is below 2 n u sum |c_k x^k|
-- (Higham, Accuracy and Stability, 2nd ed., 5.1): within that of zero the sign is rounding's, so a root is as good as
-- the error divided by the slope there, and two roots closer than that may be taken for none.
-- SPDX-License-Identifier: GPL-3.0-or-later

local roots = {}

-- c[1] + c[2] x + c[3] x^2 + ...
local function value(c, x)
  local y = 0.0
  for k = #c, 1, -1 do y = y * x + c[k] end
  return y
end
roots.value = value

-- The place between a and b where f changes sign, to the last bit; f(a) and f(b) have different signs.
function roots.bisect(f, a, b)
  local positive = f(a) > 0
  while true do
    local x = a + (b - a) / 2
    if x <= a or x >= b then return x end
    local y = f(x)
    if y == 0 then return x end
    if (y > 0) == positive then a = x else b = x end
  end
end

-- The roots of odd order in the open interval (lo, hi), ascending.
function roots.between(c, lo, hi)
  local n = #c
  while n > 0 and c[n] == 0 do n = n - 1 end
  if n < 2 then return {} end
  local slope = {}
  for k = 2, n do slope[k - 1] = (k - 1) * c[k] end
  local ends = roots.between(slope, lo, hi)
  table.insert(ends, 1, lo)
  ends[#ends + 1] = hi
  local list = {}
  local a, ya = lo, value(c, lo)
  for i = 2, #ends do
    local b, yb = ends[i], value(c, ends[i])
    if ya ~= 0 and yb ~= 0 and (ya > 0) ~= (yb > 0) then
      list[#list + 1] = roots.bisect(function(x) return value(c, x) end, a, b)
    elseif yb == 0 and b < hi then -- a root at a stationary point: does the sign change beyond it?
      local beyond = ends[i + 1] and value(c, b + (ends[i + 1] - b) / 2) or 0
      if ya ~= 0 and beyond ~= 0 and (ya > 0) ~= (beyond > 0) then list[#list + 1] = b end
    end
    a, ya = b, yb
    if ya == 0 and i < #ends then ya = value(c, b + (ends[i + 1] - b) / 2) end
  end
  return list
end

return roots
