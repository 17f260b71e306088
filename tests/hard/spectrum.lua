-- spectrum.lua -- principal moments and axes of the exact tensor whose entries are given doubles.
--
-- The number of eigenvalues above x is the number of sign changes in the characteristic polynomial of A - x 1 (all its
-- roots are real: Descartes' rule is exact), so each moment is found in exact rationals to any precision, however close
-- they are.  An axis of a simple moment is the largest column of the adjugate of A - moment 1.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local spectrum = {}

local BITS = 700 -- below the largest entry
local two, half = R.new(2), R.new(1, 2)

local function above(A, x)
  local a, b, c, f, g, h = A[1] - x, A[2] - x, A[3] - x, A[4], A[5], A[6]
  local list = { -(a + b + c), a * b + a * c + b * c - f * f - g * g - h * h,
    -(a * b * c + two * f * g * h - a * h * h - b * g * g - c * f * f) }
  local last, n = 1, 0
  for _, y in ipairs(list) do
    local s = R.sign(y)
    if s ~= 0 and s ~= last then last, n = s, n + 1 end
  end
  return n
end

local function adjugate(A)
  local a, b, c, f, g, h = table.unpack(A)
  return { { b * c - h * h, g * h - f * c, f * h - b * g }, { g * h - f * c, a * c - g * g, f * g - a * h },
    { f * h - b * g, f * g - a * h, a * b - f * f } }
end

-- The k-th eigenvalue: bisection until it is alone in an interval, then Newton's method on the characteristic
-- polynomial, which the count proves; else bisection to the end (equal moments).
local function root(A, k, size)
  local trace, minors, det = A[1] + A[2] + A[3], R.zero, adjugate(A)
  for i = 1, 3 do minors = minors + det[i][i] end
  det = A[1] * det[1][1] + A[4] * det[1][2] + A[5] * det[1][3]
  local low, high, last = -two * size, two * size, size * two ^ (2 - BITS)
  local function halve(times) -- the k-th is where fewer than 4 - k are above
    for _ = 1, times do
      local middle = (low + high) * half
      if above(A, middle) >= 4 - k then low = middle else high = middle end
    end
  end
  for _, times in ipairs { 60, 60, 190 } do
    halve(times)
    if above(A, low) - above(A, high) == 1 then
      local x = (low + high) * half
      for _ = 1, 12 do
        local slope = (two + R.one) * x ^ 2 - two * trace * x + minors
        if R.sign(slope) == 0 then break end
        x = x - (((x - trace) * x + minors) * x - det) / slope
        x = R.floor(x / last) * last
      end
      if above(A, x - last) >= 4 - k and above(A, x + last) < 4 - k then return x end
    end
  end
  return high
end

-- I: six doubles.  {moment = {3 rationals, ascending}, axis = {3 unit vectors, or false where another moment is nearer
-- than 2^-300 of the largest entry}}
function spectrum.of(I)
  local A, size = {}, R.zero
  for n = 1, 6 do
    A[n] = R.fromdouble(I[n])
    size = size + R.abs(A[n])
  end
  local out = { moment = {}, axis = {} }
  if R.sign(size) == 0 then return { moment = { R.zero, R.zero, R.zero }, axis = { false, false, false } } end
  size = two ^ (R.log2(size) + 1)
  for k = 1, 3 do out.moment[k] = root(A, k, size) end
  for k = 1, 3 do
    local apart = true
    for j = 1, 3 do
      apart = apart and (j == k or R.abs(out.moment[j] - out.moment[k]) > size * two ^ -300)
    end
    out.axis[k] = false
    if apart then
      local m = out.moment[k]
      local best, most
      for _, column in ipairs(adjugate { A[1] - m, A[2] - m, A[3] - m, A[4], A[5], A[6] }) do
        local n = column[1] ^ 2 + column[2] ^ 2 + column[3] ^ 2
        if not most or n > most then best, most = column, n end
      end
      local length = R.apply("sqrt", 400, most)
      out.axis[k] = { best[1] / length, best[2] / length, best[3] / length }
    end
  end
  return out
end

-- How moments (3 doubles) and vectors (9) fit it, each in units of its own bound, the worst of all:
--     moment        u of the largest (graded: u of itself), once rounded; the library's `slack` times as much
--     axis          each component: u and 16 (largest moment/gap) 2^-bits
--     products      of the axes, from 0 and 1: 2 u (unit vectors rounded once)
--     I a - m a     2 u of the largest
--     1 if they are not right-handed or do not ascend.
-- o: {u =, bits = of the method, slack =, graded =}
function spectrum.judge(I, moments, vectors, o)
  local s, worst = spectrum.of(I), 0.0
  local most = R.abs(s.moment[1]) > R.abs(s.moment[3]) and R.abs(s.moment[1]) or R.abs(s.moment[3])
  local u, slack = R.fromdouble(o.u), R.fromdouble(1 + 2.0 ^ -8)
  local tiny = two ^ -1075 -- half a spacing of subnormal numbers; float's
  if o.u > 2.0 ^ -30 then tiny = two ^ -150 end
  local function see(error, bound)
    local ratio = R.todouble(error / (bound * slack + tiny))
    if ratio > worst then worst = ratio end
  end
  local m, x = {}, {}
  for k = 1, 3 do
    if moments[k] - moments[k] ~= 0 then return math.huge end
    m[k], x[k] = R.fromdouble(moments[k]), {}
    for n = 1, 3 do
      local c = vectors[3 * k - 3 + n]
      if c - c ~= 0 then return math.huge end
      x[k][n] = R.fromdouble(c)
    end
  end
  local rows = { { I[1], I[4], I[5] }, { I[4], I[2], I[6] }, { I[5], I[6], I[3] } }
  local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
  for k = 1, 3 do
    see(R.abs(m[k] - s.moment[k]), (o.graded and R.abs(s.moment[k]) or most) * u * R.fromdouble(o.slack or 1))
    for j = 1, 3 do see(R.abs(dot(x[j], x[k]) - R.new(j == k and 1 or 0)), two * u) end
    for n = 1, 3 do
      local row = { R.fromdouble(rows[n][1]), R.fromdouble(rows[n][2]), R.fromdouble(rows[n][3]) }
      see(R.abs(dot(row, x[k]) - m[k] * x[k][n]), two * u * most * R.fromdouble(o.slack or 1))
    end
    if s.axis[k] then
      local gap
      for j = 1, 3 do
        local d = R.abs(s.moment[j] - s.moment[k])
        if j ~= k and (not gap or d < gap) then gap = d end
      end
      local sign = R.new(R.sign(dot(s.axis[k], x[k])))
      for n = 1, 3 do
        see(R.abs(x[k][n] - sign * s.axis[k][n]), u + R.new(16) * most / gap * two ^ -o.bits)
      end
    end
  end
  local cross = { x[1][2] * x[2][3] - x[1][3] * x[2][2], x[1][3] * x[2][1] - x[1][1] * x[2][3],
    x[1][1] * x[2][2] - x[1][2] * x[2][1] }
  if R.sign(dot(cross, x[3])) <= 0 or moments[1] > moments[2] or moments[2] > moments[3] then return math.huge end
  return worst
end

-- The textbook: eigenvalues by Smith's trigonometric formula (1961), axes as cross products of rows of A - m 1; in
-- double.  moments, vectors
function spectrum.naive(I)
  local a, b, c, f, g, h = table.unpack(I)
  local mean = (a + b + c) / 3
  local p = math.sqrt(((a - mean) ^ 2 + (b - mean) ^ 2 + (c - mean) ^ 2 + 2 * (f * f + g * g + h * h)) / 6)
  local A, B, C, F, G, H = (a - mean) / p, (b - mean) / p, (c - mean) / p, f / p, g / p, h / p
  local r = (A * B * C + 2 * F * G * H - A * H * H - B * G * G - C * F * F) / 2
  local angle = math.acos(math.max(-1, math.min(1, r))) / 3
  local m = { mean + 2 * p * math.cos(angle + 2 * math.pi / 3), 0.0, mean + 2 * p * math.cos(angle) }
  m[2] = 3 * mean - m[1] - m[3]
  local vectors = {}
  for k = 1, 3 do
    local u, v = { a - m[k], f, g }, { f, b - m[k], h }
    local x = { u[2] * v[3] - u[3] * v[2], u[3] * v[1] - u[1] * v[3], u[1] * v[2] - u[2] * v[1] }
    local n = math.sqrt(x[1] ^ 2 + x[2] ^ 2 + x[3] ^ 2)
    for i = 1, 3 do vectors[3 * k - 3 + i] = x[i] / n end
  end
  if vectors[1] * (vectors[5] * vectors[9] - vectors[6] * vectors[8]) + vectors[2] * (vectors[6] * vectors[7] -
    vectors[4] *
    vectors[9]) + vectors[3] * (vectors[4] * vectors[8] - vectors[5] * vectors[7]) < 0 then
    for i = 7, 9 do vectors[i] = -vectors[i] end
  end
  return m, vectors
end

return spectrum
