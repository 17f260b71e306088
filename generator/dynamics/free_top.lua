-- free_top.lua -- the free top with many digits: what its closed form is made of, and its state at any time.
--
-- Principal axes are labelled 1, 2, 3 so that 2 is that of the middle moment and 3 the one about which L circulates,
-- signed so that w1 >= 0, w3 > 0; s = sign(I3 - I1).  Then with u = lambda t + u0
--     w = (b1 cn u, s b2 sn u, b3 dn u),    z = pi u/(2 K),
--     w + i z = e^(i phi) theta4(z - i s eta; q^2)/N,    x + i y = s e^(i phi) theta1(z - i s eta; q^2)/N
-- for the quaternion from these axes to a frame whose third axis is along L, phi = 2 pi turn t (Jacobi 1849; Whittaker,
-- Analytical Dynamics, section 69); near the separatrix the imaginary transformation (DLMF 20.7.30-33).
--
-- What decides is decided exactly, on rationals: whether w x L = 0, and on which side of the separatrix a state is.
-- With h = G^2/2T its distance is 2T (h - I2), and det(h 1 - I) = (h - I1)(h - I2)(h - I3) is a rational number,
-- whatever the axes are; the other two factors are sums of positive terms.  So k'^2 has all its bits however near the
-- separatrix is.
-- What the emitted code stores of it: emit/orbit.lua.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local elliptic = require "generator.algebra.elliptic"
local vec = require "generator.algebra.vec"
local jacobi = require "generator.mass.jacobi"

local free_top = {}
free_top.__index = free_top

local two, four = R.new(2), R.new(4)

local function times(I, w)
  return { I[1] * w[1] + I[4] * w[2] + I[5] * w[3], I[4] * w[1] + I[2] * w[2] + I[6] * w[3],
    I[5] * w[1] + I[6] * w[2] + I[3] * w[3] }
end

local function determinant(I)
  return I[1] * (I[2] * I[3] - I[6] * I[6]) - I[4] * (I[4] * I[3] - I[6] * I[5]) + I[5] * (I[4] * I[6] - I[2] * I[5])
end

-- a quotient's root
local function root(a, b, bits) return elliptic.root(R.round(a / b, bits), bits) end

-- Moments ascending, their axes, and whether those are right-handed in this order.  A difference of moments that loses
-- more than the guard bits: again with as many more.
local function principal(I, bits)
  local d, v
  if R.sign(I[4]) == 0 and R.sign(I[5]) == 0 and R.sign(I[6]) == 0 then
    d, v = jacobi.precise(I, 1)
  else
    local work = bits + 64
    repeat
      d, v = jacobi.precise(I, work)
      local lost = 0
      for i = 1, 3 do
        local difference = R.abs(d[i] - d[i % 3 + 1])
        local n = R.sign(difference) ~= 0 and R.log2(R.abs(d[i]) + R.abs(d[i % 3 + 1])) - R.log2(difference) or 0
        if n < work - 16 and n > lost then lost = n end
      end
      local enough = lost + bits <= work
      work = bits + 64 + lost
    until enough
  end
  local order = { 1, 2, 3 }
  table.sort(order, function(i, j) return d[i] < d[j] or (d[i] == d[j] and i < j) end)
  return { d[order[1]], d[order[2]], d[order[3]] }, { v[order[1]], v[order[2]], v[order[3]] },
    order[2] == order[1] % 3 + 1
end

local function rounded(v, bits) return vec.map(v, function(x) return R.round(x, bits) end) end

-- Labels: which axis is which, signs, and the differences of moments.  D = G^2 - 2 T I2.
local function label(top, I, axis, right, w)
  local bits = top.bits
  local sorted = {}
  for i = 1, 3 do sorted[i] = R.round(vec.dot(axis[i], w), bits + 64) end
  local rod = R.sign(I[1]) <= 0
  if rod then I = { R.zero, (I[2] + I[3]) / 2, (I[2] + I[3]) / 2 } end
  local L = times(top.tensor, w)
  local G2, T2 = vec.dot(L, L), vec.dot(L, w)
  -- G^2 - 2 T I1 and 2 T I3 - G^2; the product of D with both is -det(h 1 - I) (2 T)^3
  local above_small = I[2] * (I[2] - I[1]) * sorted[2] * sorted[2] + I[3] * (I[3] - I[1]) * sorted[3] * sorted[3]
  local below_large = I[1] * (I[3] - I[1]) * sorted[1] * sorted[1] + I[2] * (I[3] - I[2]) * sorted[2] * sorted[2]
  local D = R.zero
  if not rod then
    local h, t = G2 / T2, top.tensor
    local p = determinant { h - t[1], h - t[2], h - t[3], -t[4], -t[5], -t[6] }
    if R.sign(p) ~= 0 then D = R.round(-p * T2 * T2 * T2 / (above_small * below_large), bits) end
  end
  local reverse = rod or R.sign(D) < 0
  local own = reverse and { 3, 2, 1 } or { 1, 2, 3 }
  local sign = { R.sign(sorted[own[1]]) < 0 and -1 or 1, 1, R.sign(sorted[own[3]]) < 0 and -1 or 1 }
  sign[2] = sign[1] * sign[3] * (right == reverse and -1 or 1)
  top.I, top.w, top.axis, top.s = {}, {}, {}, reverse and -1 or 1
  for i = 1, 3 do
    top.I[i] = R.round(I[own[i]], bits)
    top.w[i] = sign[i] * sorted[own[i]]
    top.axis[i] = rounded(vec.scale(R.new(sign[i]), axis[own[i]]), bits)
  end
  local low, high = I[2] - I[1], I[3] - I[2]
  local d = { d21 = reverse and high or low, d32 = reverse and low or high, d31 = I[3] - I[1] }
  d.rho = rod and R.zero or d.d21 / top.I[3]
  d.distance = rod and d.d32 * top.w[3] * top.w[3] or R.abs(D) / top.I[3] -- |G^2 - 2 T I2|/I3
  for _, k in ipairs { "d21", "d32", "d31", "rho", "distance" } do d[k] = R.round(d[k], bits) end
  top.G = elliptic.root(rod and I[2] * I[2] * (sorted[2] * sorted[2] + sorted[3] * sorted[3]) or G2, bits)
  return d
end

-- Amplitudes of the rates, modulus, periods, nomes.
-- lambda^2 = (I3 - I2) (G^2 - 2 T I1)/(I1 I2 I3), k^2 = (I2 - I1) (2 T I3 - G^2)/((I3 - I2) (G^2 - 2 T I1)) up to
-- common signs, and k'^2 = 1 - k^2 from |G^2 - 2 T I2|.  I3 is taken out of both sides of each quotient, for a rod's is
-- 0.
local function invariants(top, d)
  local bits, I, w = top.bits, top.I, top.w
  local function round(x) return R.round(x, bits) end
  local Lambda1 = round(d.rho * I[2] * w[2] * w[2] + d.d31 * w[3] * w[3]) -- |G^2 - 2 T I1|/I3
  local Delta3 = round(I[1] * d.d31 * w[1] * w[1] + I[2] * d.d32 * w[2] * w[2])
  top.b = { root(Delta3, I[1] * d.d31, bits), root(Delta3, I[2] * d.d32, bits), root(Lambda1, d.d31, bits) }
  top.lambda = root(d.d32 * Lambda1, I[1] * I[2], bits)
  top.k = root(d.rho * Delta3, d.d32 * Lambda1, bits)
  top.kc = root(d.distance * d.d31, d.d32 * Lambda1, bits)
  top.K, top.Kc = elliptic.complete(top.kc, bits), elliptic.complete(top.k, bits)
  local pi = top.pi
  top.q = not top.K and R.one or top.Kc and elliptic.exp(-pi * top.Kc / top.K, bits) or R.zero
  top.log_qc = top.K and top.Kc and round(-pi * top.K / top.Kc) -- nil: minus infinity (K) or 0 (Kc)
  top.qc = not top.K and R.zero or top.Kc and elliptic.exp(top.log_qc, bits) or R.one
  top.hyperbolic = not top.K or (top.log_qc ~= nil and top.log_qc < -2 * pi)
  top.separatrix = not top.K
  top.u0 = elliptic.first(round(w[1] / top.b[1]), round(top.s * w[2] / top.b[2]), top.kc, bits)
end

-- Phase z/pi = start + rate t, and mu: sums of terms of the size of the rates (the derivative of log theta2 at i eta).
local function circular(top)
  local bits, s, pi = top.bits, R.new(top.s), top.pi
  local function round(x) return R.round(x, bits) end
  top.rate, top.start, top.period = round(top.lambda / (2 * top.K)), round(top.u0 / (2 * top.K)), R.one
  -- q^(1/2) e^eta = E = exp(-pi (K' - v)/(2 K)), tan of the angle of K' - v is B3/B1; r = e^(-2 eta)
  local F = elliptic.first(round(top.I[1] * top.b[1]), round(top.I[3] * top.b[3]), top.k, bits)
  top.E = elliptic.exp(-pi * F / (2 * top.K), bits)
  top.r = round(top.q / (top.E * top.E))
  local E2 = top.E * top.E
  local function series(weight, minus)
    local power, odd, step, square = R.one, top.r, round(top.q * E2), top.q * top.q
    return elliptic.sum(function(n)
      local term = round(power * (R.one + minus * odd) * (weight and 2 * n + 1 or 1))
      power, odd, step = round(power * step), round(odd * top.r * top.r), round(step * square)
      return term, power * (4 * n + 8)
    end, bits)
  end
  local up, down = series(true, -R.one), series(false, R.one)
  top.turn = round((top.G / (pi * top.I[2]) - s * top.rate * up / down) / 4)
  top.jump = R.zero
end

-- Phase V = pi u/(4 K') = start + rate t, period -log(q')/2, none on the separatrix; h = pi v/(4 K'), v the integral
-- whose angle has the tangent sqrt(I1 (I3 - I2)/(I3 (I2 - I1))).  Each period takes 2 s h off the phase about L.
local function hyperbolic(top, d)
  local bits, s, pi = top.bits, R.new(top.s), top.pi
  local function round(x) return R.round(x, bits) end
  local scale = round(pi / (4 * top.Kc))
  top.rate, top.start = round(top.lambda * scale), round(top.u0 * scale)
  top.period = top.log_qc and -top.log_qc / 2
  local x, y = elliptic.root(round(top.I[3] * d.d21), bits), elliptic.root(round(top.I[1] * d.d32), bits)
  top.h = round(scale * elliptic.first(x, y, top.k, bits))
  local c1, s1 = R.apply("cos", bits, four * top.h), R.apply("sin", bits, four * top.h)
  local function series(with) -- of theta4(2h; q') - 1, or of its derivative
    local c, sn, power, odd = R.one, R.zero, R.one, top.qc
    local sign = R.one
    return elliptic.sum(function(n)
      c, sn = round(c * c1 - sn * s1), round(sn * c1 + c * s1)
      power, odd, sign = round(power * odd), round(odd * top.qc * top.qc), -sign
      return round(two * sign * power * (with and -2 * (n + 1) * sn or c)), power * 8 * (n + 2)
    end, bits)
  end
  local up = top.rate * series(true) / (R.one + series(false))
  top.turn = round((top.G / (two * top.I[2]) - s * up) / (2 * pi))
  top.jump = round(s * top.h / pi)
end

-- The motion through x0 = {q, w} at t = 0 of the body with the tensor {xx, yy, zz, xy, xz, yz}; rationals, exact.  nil
-- if q is 0 or the body none: a negative moment, or none about an axis across which two differ, by more than `slack` of
-- the largest (what rounding of the entries leaves of a rod is less).
function free_top.new(tensor, x0, bits, slack)
  local top = setmetatable({ tensor = tensor, bits = bits + 32, wanted = bits }, free_top)
  local w, q = { x0[5], x0[6], x0[7] }, { x0[1], x0[2], x0[3], x0[4] }
  local norm = q[1] * q[1] + q[2] * q[2] + q[3] * q[3] + q[4] * q[4]
  if R.sign(norm) == 0 then return nil end
  bits = top.bits
  top.pi = elliptic.pi(bits + 64)
  norm = elliptic.root(norm, bits)
  top.q0 = vec.map(q, function(x) return R.round(x / norm, bits) end)
  top.w0 = w
  local moments, axis, right = principal(tensor, bits)
  slack = (slack or R.zero) * moments[3]
  if moments[1] < -slack or R.sign(moments[3]) == 0 then return nil end
  if R.sign(moments[1]) <= 0 and moments[3] - moments[2] > slack then return nil end
  local across = vec.cross(w, times(tensor, w))
  if R.sign(vec.dot(across, across)) == 0 then
    top.constant, top.hyperbolic, top.s = true, false, 1
    local length = elliptic.root(vec.dot(w, w), bits)
    local unit = R.sign(length) == 0 and { R.zero, R.zero, R.zero } or
      vec.map(w, function(x) return R.round(x / length, bits) end)
    local none = { R.zero, R.zero, R.zero }
    top.axis, top.b = { none, none, unit }, { R.zero, R.zero, length }
    top.rate, top.start, top.period, top.jump = R.zero, R.zero, R.one, R.zero
    top.q, top.qc, top.E, top.r = R.zero, R.one, R.zero, R.zero
    top.turn = R.round(length / (4 * top.pi), bits)
  else
    local d = label(top, moments, axis, right, w)
    invariants(top, d)
    if top.hyperbolic then hyperbolic(top, d) else circular(top) end
  end
  top.y0, top.f0 = top:pair(top:phases(R.zero))
  return top
end

-- Phase of the rates less n periods, turns about L less whole ones, and n, at the time t.
function free_top:phases(t)
  local phase, n = self.start + self.rate * t, R.zero
  if self.period then n = R.floor(phase / self.period + R.half) end
  local turn = self.turn * t - n * self.jump
  turn = turn - R.floor(turn + R.half)
  local period = self.period and n * self.period or R.zero
  return R.round(phase - period, self.bits), R.round(turn, self.bits), R.toint(n - two * R.floor(n / two)) == 1
end

-- x^n, each power rounded once from two smaller ones
local function powers(x, bits)
  local known = { [0] = R.one, x }
  local function power(n)
    known[n] = known[n] or R.round(power(n // 2) * power(n - n // 2), bits)
    return known[n]
  end
  return power
end

-- (-1)^n, or 1
local function alternating(on, n) return on and n % 2 == 1 and -R.one or R.one end

-- Real and imaginary parts of theta4 and s theta1 of z - i s eta, nome q^2, the second without 2 q^(1/2); and cn, s sn,
-- dn by theta functions of z, nome q, the first two without 2 q^(1/4).
local function circular_series(top, r)
  local bits, s = top.bits, R.new(top.s)
  top.powers = top.powers or { powers(top.q, bits), powers(top.E, bits), powers(R.round(top.E * top.r, bits), bits) }
  local q, E, g = table.unpack(top.powers)
  local z = R.round(top.pi * r, bits)
  local cosine, sine = { [0] = R.one, R.apply("cos", bits, z) }, { [0] = R.zero, R.apply("sin", bits, z) }
  local function angle(n)
    for k = #cosine + 1, n do
      cosine[k] = R.round(cosine[k - 1] * cosine[1] - sine[k - 1] * sine[1], bits)
      sine[k] = R.round(sine[k - 1] * cosine[1] + cosine[k - 1] * sine[1], bits)
    end
    return cosine[n], sine[n]
  end
  -- first = 0: theta4 = 1 - q (E^2 + g^2) cos 2z + .., g = q/E = q^(1/2) e^-eta; 1: theta1 = (E + g) sin z - ..
  local function shifted(first, imaginary)
    return elliptic.sum(function(n)
      if n == 0 and first == 0 then return imaginary and R.zero or R.one, R.one end
      local k = 2 * n + first
      local co, si = angle(k)
      if imaginary == (first == 1) then si = co end
      local size = imaginary and E(k) - g(k) or E(k) + g(k)
      return alternating(true, n) * q(n * (2 * n + 2 * first - 1)) * size * si, 4 * q(n * (2 * n + 1))
    end, bits)
  end
  local function theta(kind, z_or_0)
    local odd, alternates = kind < 3, kind == 1 or kind == 4
    return elliptic.sum(function(n)
      local co, si = R.one, R.one
      if z_or_0 then co, si = angle(odd and 2 * n + 1 or 2 * n) end
      local value = alternating(alternates, n) * q(odd and n * (n + 1) or n * n) * (kind == 1 and si or co)
      return (odd or n == 0) and value or two * value, 4 * q(n * n)
    end, bits)
  end
  top.zero = top.zero or { nil, theta(2), theta(3), theta(4) }
  local zero, here = top.zero, { theta(1, true), theta(2, true), theta(3, true), theta(4, true) }
  return { shifted(0, false), s * shifted(0, true), s * shifted(1, false), -shifted(1, true) },
    { zero[4] * here[2] / (zero[2] * here[4]), s * zero[3] * here[1] / (zero[2] * here[4]),
      zero[4] * here[3] / (zero[3] * here[4]) }
end

-- The same at |V| = r: theta2 and -i s theta1 of s h + i V, nome P = q'^(1/2), without 2 P^(1/4), and Jacobi's
-- imaginary transformation of sn, cn, dn with the nome q', x = 2 r; all times e = e^(-2r), or its root, so that nothing
-- overflows.  The powers of e^(2r) go with those of P: g = P e^(2r) <= 1.
local function hyperbolic_series(top, r)
  local bits, s = top.bits, R.new(top.s)
  local once = elliptic.exp(-two * r, bits)
  top.nome = top.nome or elliptic.root(top.qc, bits)
  top.powers, top.trig = top.powers or powers(top.nome, bits), top.trig or { cos = {}, sin = {} }
  local nome, e, P = top.nome, powers(once, bits), top.powers
  local g = powers(R.sign(nome) == 0 and nome or R.round(nome / once, bits), bits)
  local function shifted(trig, alternates, sign)
    return elliptic.sum(function(n)
      local size, known = R.one + sign * e(2 * n + 1), top.trig[trig]
      known[n] = known[n] or R.apply(trig, bits, (2 * n + 1) * top.h)
      local value = P(n * n) * g(n) * size * known[n]
      return alternating(alternates, n) * value, 4 * P(n * n)
    end, bits)
  end
  local function theta(kind, at)
    local odd, alternates = kind < 3, kind == 1 or kind == 4
    return elliptic.sum(function(n)
      local value
      if not at then
        value = P(odd and 2 * n * (n + 1) or 2 * n * n) * ((odd or n > 0) and two or R.one)
      elseif odd then -- e^-x 2 cosh (2n + 1) x
        local up, down = P(2 * n * n) * g(2 * n), P(2 * n * (n + 1)) * e(2 * n + 2)
        value = kind == 1 and up - down or up + down
      else
        value = n == 0 and once or P(2 * n * n - 2 * n) * g(2 * n) * once + P(2 * n * n) * e(2 * n + 1)
      end
      return alternating(alternates, n) * value, 8 * P(n * n)
    end, bits)
  end
  top.zero = top.zero or { nil, theta(2), theta(3), theta(4) }
  local zero, here = top.zero, { theta(1, true), theta(2, true), theta(3, true), theta(4, true) }
  return { shifted("cos", false, R.one), -s * shifted("sin", false, -R.one), s * shifted("cos", true, -R.one),
    -shifted("sin", true, R.one) },
    { zero[2] * here[4] / (zero[4] * here[2]), s * zero[3] * here[1] / (zero[4] * here[2]),
      zero[2] * here[3] / (zero[3] * here[2]) }
end

-- The unit quaternion {w, x, y, z} from principal axes to those of L, and {cn, s sn, dn}, at a phase; also N^2, in
-- terms of the series as they are above.
function free_top:pair(r, turn, odd)
  local bits = self.bits
  if self.constant then
    return self:turned({ R.one, R.zero, R.zero, R.zero }, turn), { R.zero, R.zero, R.one }, R.one
  end
  local y, f
  if self.hyperbolic then
    y, f = hyperbolic_series(self, R.abs(r))
    if R.sign(r) < 0 then y[2], y[3], f[2] = -y[2], -y[3], -f[2] end
  else
    y, f = circular_series(self, r)
  end
  if odd then y[3], y[4], f[1], f[2] = -y[3], -y[4], -f[1], -f[2] end
  local unit, n = self:turned(y, turn)
  return unit, rounded(f, bits), n
end

-- alpha = w + i z and beta = x + i y, {re, im, re, im}, times e^(2 pi i turn), as a unit quaternion;
-- second result: |alpha|^2 + |beta|^2.
function free_top:turned(p, turn)
  local bits = self.bits
  local angle = two * self.pi * turn
  local co, si = R.apply("cos", bits, angle), R.apply("sin", bits, angle)
  local n = R.round(p[1] * p[1] + p[2] * p[2] + p[3] * p[3] + p[4] * p[4], bits)
  local norm = elliptic.root(n, bits)
  return vec.map({ co * p[1] - si * p[2], co * p[3] - si * p[4], si * p[3] + co * p[4], si * p[1] + co * p[2] },
    function(x) return R.round(x / norm, bits) end), n
end

-- conj(y0) y, the turn since t = 0, its vector part in body axes; y0: as this motion counts turns, unless given
function free_top:from_principal(y, y0)
  y0 = y0 or self.y0
  local p = vec.qmul({ y0[1], -y0[2], -y0[3], -y0[4] }, y)
  local turned = { R.zero, R.zero, R.zero }
  for i = 1, 3 do turned = vec.add(turned, vec.scale(p[i + 1], self.axis[i])) end
  return rounded({ p[1], turned[1], turned[2], turned[3] }, self.bits)
end

-- The state {q, w} at the time t, a rational.
function free_top:at(t)
  local y, f = self.y0, self.f0
  if R.sign(t) ~= 0 then y, f = self:pair(self:phases(t)) end
  local w = { R.zero, R.zero, R.zero }
  for i = 1, 3 do w = vec.add(w, vec.scale(f[i] * self.b[i], self.axis[i])) end
  local q = vec.qmul(self.q0, self:from_principal(y))
  local x = { q[1], q[2], q[3], q[4], w[1], w[2], w[3] }
  return rounded(x, self.wanted)
end

-- The state at time t after x0, with `bits` bits.
function free_top.precise(tensor, x0, t, bits)
  return free_top.new(tensor, x0, bits):at(t)
end

return free_top
