-- q31_axes.lua -- the principal axes of the step in whole numbers, each in a unit of its own.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- With the rates v_k = e_k.w about the principal axes, Euler's equations are v_k' = c_k v_j v_l + torque, (k, j, l)
-- cyclic.  In units y_k = g_k v_k and with k = h f/3 the product becomes
--     h/3 g_k c_k v_j v_l = (h/3 c_k g_k/(g_j g_l)) y_j y_l
-- and the factor is +-1 for all three if g_k = h/3 sqrt(|c_j c_l|), for then
--     g_k/(g_j g_l) = (h/3)^-1 sqrt(|c_j c_l|)/sqrt(|c_k c_l| |c_k c_j|) = 1/(h/3 |c_k|).
-- Of a body with two nearly equal moments one c is small, c_k = (I_j - I_l)/I_k; then two of these g are small too and
-- y would have few bits.  Where c_k < max/16 its axis keeps a factor, and the other two share a unit that makes theirs
-- +-1.  A sphere (all c zero) has no products at all.

local R = require "generator.algebra.rational"

local axes = {}

local BITS = 200 -- of roots: far below any word

local function root(x) return R.apply("sqrt", BITS, x) end

function axes.cyclic(k) return k % 3 + 1, (k + 1) % 3 + 1 end
local cyclic = axes.cyclic

-- g, and the factor that is left of each product (0 none at all, 1 or -1 only the sign): two lists.
function axes.scaling(r, h3)
  local c, least, most = {}, 1, 1
  for k = 1, 3 do
    c[k] = R.abs(r.c[k])
    least, most = c[k] < c[least] and k or least, c[k] > c[most] and k or most
  end
  if R.sign(c[most]) == 0 then return { h3, h3, h3 }, { R.zero, R.zero, R.zero } end
  local g, factor = {}, {}
  if c[least] * R.new(16) < c[most] then -- the others are nearly the same, one of either sign
    local j, l = cyclic(least)
    g[least] = h3 * root(c[j] * c[l])
    g[l], g[j] = g[least], g[least] * root(c[l] / c[j])
  else
    for k = 1, 3 do
      local j, l = cyclic(k)
      g[k] = h3 * root(c[j] * c[l])
    end
  end
  for k = 1, 3 do
    local j, l = cyclic(k)
    local f = h3 * r.c[k] * g[k] / (g[j] * g[l])
    local s = R.new(R.sign(f))
    factor[k] = R.abs(f - s) < R.new(2) ^ -60 and s or f
  end
  return g, factor
end

-- Rows E_k of the axes as they scale: to = g_k E_kj (from w to y) and from = E_kj/g_k (transposed, from y to w).
function axes.frames(r, g)
  local to, from = { {}, {}, {} }, { {}, {}, {} }
  for k = 1, 3 do
    for j = 1, 3 do
      local e = r.axes[k][j]
      if R.abs(e) < R.new(2) ^ -60 then e = R.zero end
      to[k][j], from[j][k] = g[k] * e, e / g[k]
    end
  end
  return to, from
end

-- The product of two matrices.
function axes.times(a, b)
  local out = { {}, {}, {} }
  for i = 1, 3 do
    for j = 1, 3 do out[i][j] = a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j] end
  end
  return out
end

return axes
