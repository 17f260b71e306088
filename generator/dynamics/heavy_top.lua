-- heavy_top.lua -- the heavy symmetric top with many digits: the roots of its cubic, nutation, mean precession.
--
--     heavy_top.of { I1 =, I3 =, weight =, arm =, up =, w = } -> {l, s, tilt, period, precession}
-- All rationals; weight: m g l > 0; arm (to the centre of mass) and up of any length; w: rates; in axes of the body.
-- With c = m g l/I1, s = I3 w3/I1, l = Lz/I1 the cosine u of the tilt obeys (Goldstein, section 5.7; Whittaker, 71)
--     u'^2 = P(u) = 2 c (u - u1)(u - u2)(u - u3) = 2 (1 - u^2)(h - c u) - (l - s u)^2,    u1 <= u <= u2 <= 1 <= u3
-- These are the laws of templates/orbit/lagrange.c.  The emitted code keeps a double's digits by its way of computing;
-- here they are kept by 512 bits, and zeros by exact numbers: what tells that an axis is upright, passes through the
-- vertical, or rests, is a sum of products of rationals.
-- tilt: {least, greatest}, rad.  period: of the nutation, s; nil if the axis rests or never comes back.  precession:
-- the mean rate about the vertical, rad/s, a passage through which counts for nothing; nil where there is no period.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"

local heavy_top = {}

local bits = 512
local zero, one, two, four = R.zero, R.one, R.new(2), R.new(4)

local function round(x) return R.round(x, bits) end
local function positive(x) return R.sign(x) > 0 end
local function root(x) return positive(x) and R.apply("sqrt", bits, x) or zero end

-- The state by sums of products: what vanishes is exactly 0.
-- above, below: 1 + u, 1 - u; m = l - s u; W: |w|^2 across the axis; rise: u'
local function start(top)
  local r, up, w = top.arm, top.up, top.w
  local rr, uu, ru, rw = vec.dot(r, r), vec.dot(up, up), vec.dot(r, up), vec.dot(r, w)
  local wr = vec.cross(w, r)
  local R_, U = root(rr), root(uu)
  local cross = vec.cross(r, up)
  local N = R_ * U
  local least = vec.dot(cross, cross) / (N * (N + R.abs(ru))) -- 1 - |u|
  local most = one + R.abs(ru) / N
  local rising = R.sign(ru) >= 0
  return { c = round(top.weight / top.I1), s = round(top.I3 * rw / (R_ * top.I1)), u = round(ru / N),
    above = round(rising and most or least), below = round(rising and least or most),
    m = round((vec.dot(up, w) * rr - ru * rw) / (U * rr)), W = round(vec.dot(wr, wr) / rr),
    rise = round(vec.dot(up, wr) / N) }
end

-- n = u0 - u1: the one positive root of p0 - p1 n + p2 n^2 - 2 c n^3, else 0.
-- p0 > 0: Newton's method from above, which is monotone, as all roots are real; p0 = 0: a quadratic is left.
local function descent(p0, p1, p2, c)
  if not positive(p0) then
    if positive(p1) then return zero end
    local wide = root(p2 * p2 - R.new(8) * c * p1)
    if positive(p2) then return round((p2 + wide) / (four * c)) end
    return R.sign(p1) == 0 and zero or round(-two * p1 / (wide - p2))
  end
  local n = two
  for _ = 1, 4000 do -- some thousand where n is 1e-150
    local slope = ((two * p2 - R.new(6) * c * n) * n) - p1
    local following = round(n - (((p2 - two * c * n) * n - p1) * n + p0) / slope)
    if following >= n then break end
    n = following
  end
  return n
end

-- Differences of the roots, each by what does not cancel.
-- below: 1 - u1, 1 - u2; above: 1 + u1, 1 + u2; span = u2 - u1; gap, whole = 2 c (u3 - u2), 2 c (u3 - u1)
local function roots(p)
  local c2 = two * p.c
  local d, up_d = round(p.m - p.s * p.below), round(p.m + p.s * p.above) -- l - s, l + s
  local p0, p1 = p.rise * p.rise, two * (p.s * p.m - p.u * p.W - p.c * p.above * p.below)
  local n = descent(p0, round(p1), round(two * c2 * p.u - p.W - p.s * p.s), p.c)
  local x1 = p.below + n
  if not positive(x1) then return nil, d, up_d end -- upright and at rest
  local q = round(d * d / x1)
  local r = round((q - two * (p.W - c2 * p.below - d * p.s)) / x1)
  local wide = root(r * r + R.new(8) * p.c * q)
  local x2, far -- 1 - u2, 2 c (u3 - 1)
  if positive(r) then
    x2 = round((wide + r) / (two * c2))
    far = round(q / x2)
  else
    far = round((wide - r) / two)
    x2 = positive(far) and round(q / far) or zero
  end
  local y3 = far + c2 * p.below -- 2 c (u3 - u0)
  local product = positive(y3) and round(p0 / y3) or zero
  local sum = positive(y3) and round((p1 + c2 * product) / y3) or zero
  local y2 = (R.sign(sum) >= 0 or not positive(n)) and sum + n or round(product / n)
  if not positive(y2) then y2 = zero end
  local z2 = p.above + y2
  local z1 = positive(z2) and round(up_d * up_d / (z2 * (far + two * c2))) or zero
  return { below = { x1, x2 }, above = { z1, z2 }, span = n + y2, gap = round(far + c2 * x2),
    whole = round(far + c2 * x1) }, d, up_d
end

-- Arithmetic-geometric mean of 1 and b: its limit, and the sum of Q_n of DLMF 19.8.7 for each characteristic 1 - p^2.
local function means(b, characteristics)
  local a, g, sums, Q = one, b, {}, {}
  local p = vec.map(characteristics, root)
  for i = 1, #p do sums[i], Q[i] = zero, one end
  for _ = 1, 40 do
    local product = round(a * g)
    for i = 1, #p do
      local square = round(p[i] * p[i])
      sums[i] = sums[i] + Q[i]
      Q[i] = round(Q[i] * (square - product) / (square + product) / two)
      p[i] = round((square + product) / (two * p[i]))
    end
    a, g = round((a + g) / two), root(product)
  end
  return a, sums
end

-- The mean of (l - s u)/(1 - u^2) over a nutation, by partial fractions: d/2 of 1/(1 - u), up_d/2 of 1/(1 + u), each
-- a complete integral Pi/K = 1 + alpha^2/(2 (1 - alpha^2)) sum Q_n.  One of a passage through the vertical is left out.
local function precession(t, d, up_d, b)
  local terms, squares = {}, {}
  local function put(numerator, near, far, span)
    if R.sign(numerator) == 0 or not (positive(near) and positive(far)) then return end
    terms[#terms + 1] = { numerator / (two * near), span / (two * far) }
    squares[#squares + 1] = round(far / near)
  end
  put(d, t.below[1], t.below[2], t.span)
  put(up_d, t.above[1], t.above[2], -t.span)
  local limit, sums = means(b, squares)
  local rate = zero
  for i, f in ipairs(terms) do rate = rate + f[1] * (one + f[2] * sums[i]) end
  return limit, round(rate)
end

-- The angle with 1 - cos, 1 + cos = x, y.
local function angle(x, y) return two * R.apply("atan2", bits, root(x), root(y)) end

function heavy_top.of(top)
  local p = start(top)
  local t, d, up_d = roots(p)
  local out = { s = p.s, l = round(p.m + p.s * p.u) }
  local rests = not positive(p.W) and not (positive(p.above) and positive(p.below))
  if rests or not t then
    out.tilt = { angle(p.below, p.above), angle(p.below, p.above) }
    return out
  end
  out.tilt = { angle(t.below[2], t.above[2]), angle(t.below[1], t.above[1]) }
  if not positive(t.gap) then return out end -- on the separatrix
  local limit, rate = precession(t, d, up_d, root(t.gap / t.whole))
  out.period = round(two * R.apply("pi", bits) / (limit * root(t.whole)))
  out.precession = rate
  return out
end

return heavy_top
