-- jacobi.lua -- principal moments and axes of a tensor, for reports.
--
-- Jacobi's method (Golub, Van Loan, Matrix Computations, 8.5) in rationals rounded to `bits` bits after each rotation,
-- so that no size over- or underflows and what is returned is rounded once.  Moments ascending, axes right-handed; in
-- the first two the first component within 1/16 of the largest is positive.  The planes xy, xz, yz in turn: with one
-- product of inertia zero a rotation multiplies the smaller of the other two by a sine of at most sqrt(1/2), so the
-- bound on the rotations suffices for any tensor.  The emitted code has its own (templates/analysis/principal.c), the
-- library another.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local jacobi = {}

-- Turn the axes p and q of the diagonal d, the products of inertia o (o[r] = I_pq) and the frame v so that o[r] becomes
-- zero but for the rounding of the tangent, of which nothing is neglected.
local function turn(d, o, v, r, bits)
  local function round(q) return R.round(q, bits) end
  local p, q = r % 3 + 1, (r + 1) % 3 + 1
  local ratio = (d[q] - d[p]) / (o[r] + o[r])
  local root = R.apply("sqrt", bits, R.one + ratio * ratio)
  local t = round(R.one / (R.sign(ratio) < 0 and ratio - root or ratio + root))
  local c = R.one / R.apply("sqrt", 2 * bits, R.one + t * t)
  local s = t * c
  -- t = tan of the angle solves t^2 + 2 ratio t - 1 = 0, the smaller root; `left` is what its rounding leaves of I_pq
  local left = ((R.one - t * t) * o[r] - t * (d[q] - d[p])) / (R.one + t * t)
  local shift = t * (o[r] + left)
  d[p], d[q], o[r] = round(d[p] - shift), round(d[q] + shift), round(left)
  o[q], o[p] = round(c * o[q] - s * o[p]), round(s * o[q] + c * o[p]) -- I_rp, I_rq
  for k = 1, 3 do v[p][k], v[q][k] = round(c * v[p][k] - s * v[q][k]), round(s * v[p][k] + c * v[q][k]) end
end

-- e: {xx, yy, zz, xy, xz, yz}, rationals.  The moments and their axes, in no order, the frame right-handed: rationals.
function jacobi.precise(e, bits)
  local d, o, v = { e[1], e[2], e[3] }, { e[6], e[5], e[4] }, {}
  local negligible = R.new(2) ^ (-2 * bits) -- of the product of the diagonal entries, for the square of an entry
  for k = 1, 3 do v[k] = { R.new(k == 1 and 1 or 0), R.new(k == 2 and 1 or 0), R.new(k == 3 and 1 or 0) } end
  local settled = 0
  -- settled: planes in a row without anything to do; three are all
  for n = 0, 2 * bits do
    local r = 3 - n % 3
    if o[r] * o[r] <= negligible * R.abs(d[r % 3 + 1] * d[(r + 1) % 3 + 1]) then
      settled, o[r] = settled + 1, R.zero
    else
      settled = 0
      turn(d, o, v, r, bits)
    end
    if settled == 3 then break end
  end
  return d, v
end

-- I: {xx, yy, zz, xy, xz, yz}, rationals or finite doubles.  Returns {m1, m2, m3} and {axis1, axis2, axis3}, doubles,
-- and the moments before they are rounded to doubles.
function jacobi.run(I)
  local e = {}
  for n = 1, 6 do e[n] = R.round(R.is(I[n]) and I[n] or R.fromdouble(I[n]), 128) end
  local d, v = jacobi.precise(e, 128)
  local moments, order, even = {}, { 1, 2, 3 }, true
  for k = 1, 3 do moments[k] = R.todouble(d[k]) end
  for i = 2, 3 do -- insertion sort: equal moments keep their order
    for j = i, 2, -1 do
      if moments[order[j]] < moments[order[j - 1]] then
        order[j], order[j - 1], even = order[j - 1], order[j], not even
      end
    end
  end
  local sorted, axes, precise = {}, {}, {}
  for n, i in ipairs(order) do
    local a = {}
    for k = 1, 3 do a[k] = R.todouble(v[i][k]) end
    local margin = math.max(math.abs(a[1]), math.abs(a[2]), math.abs(a[3])) * 15 / 16
    local first = 1
    while math.abs(a[first]) < margin do first = first + 1 end
    -- the rotations have determinant 1: two signs and the order settle the third
    local negative = not even
    if n < 3 then negative = a[first] < 0 end
    if negative then
      even = not even
      for k = 1, 3 do a[k] = 0.0 - a[k] end -- no negative zero
    end
    sorted[n], axes[n], precise[n] = moments[i], a, d[i]
  end
  return sorted, axes, precise
end

return jacobi
