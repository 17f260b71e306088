-- naive.lua -- textbook formulas as one writes them first, in doubles: what the hard cases show beside ours.
-- SPDX-License-Identifier: GPL-3.0-or-later

local naive = {}

-- ---- Jacobi's functions by the AGM (Abramowitz and Stegun 16.4, 17.6), from k^2 ----

local function means(k2)
  local a, g, c = { 1.0 }, math.sqrt(1 - k2), { math.sqrt(k2) }
  for n = 1, 30 do
    if math.abs(c[n]) < 1e-16 or g ~= g then break end
    a[n + 1], c[n + 1], g = (a[n] + g) / 2, (a[n] - g) / 2, math.sqrt(a[n] * g)
  end
  return a, c
end

function naive.sncndn(u, k2)
  local a, c = means(k2)
  local phi = 2.0 ^ (#a - 1) * a[#a] * u
  for n = #a, 2, -1 do phi = (phi + math.asin(c[n] / a[n] * math.sin(phi))) / 2 end
  return math.sin(phi), math.cos(phi), math.sqrt(1 - k2 * math.sin(phi) ^ 2)
end

-- F(phi, k), phi of any size
function naive.first(phi, k2)
  local a, b = 1.0, math.sqrt(1 - k2)
  local scale = 1.0
  for _ = 1, 30 do
    if math.abs(a - b) < 1e-16 * a or b ~= b then break end
    local turns = math.floor(phi / math.pi + 0.5)
    phi = phi + math.atan(b / a * math.tan(phi)) + turns * math.pi
    a, b, scale = (a + b) / 2, math.sqrt(a * b), scale * 2
  end
  return phi / (scale * a)
end

-- K by its power series in k^2, 1000 terms
function naive.quarter(k2)
  local sum, term = 1.0, 1.0
  for n = 1, 1000 do
    term = term * ((2 * n - 1) / (2 * n)) ^ 2 * k2
    sum = sum + term
  end
  return sum * math.pi / 2
end

-- ---- the free top (Landau and Lifshitz, Mechanics, 37), from T and L^2 ----

-- {k2 =, lambda =, b1, b2, b3}, the moments in the order that the formulas take them, and the order.
function naive.constants(p, w)
  local T2, L2 = 0.0, 0.0
  for i = 1, 3 do T2, L2 = T2 + p[i] * w[i] ^ 2, L2 + (p[i] * w[i]) ^ 2 end
  local order = { 1, 2, 3 }
  table.sort(order, function(a, b) return p[a] < p[b] end)
  if L2 < T2 * p[order[2]] then order[1], order[3] = order[3], order[1] end
  local A, B, C = p[order[1]], p[order[2]], p[order[3]]
  local c = { order = order, k2 = (B - A) * (T2 * C - L2) / ((C - B) * (L2 - T2 * A)),
    lambda = math.sqrt((C - B) * (L2 - T2 * A) / (A * B * C)) }
  c[1] = math.sqrt((T2 * C - L2) / (A * (C - A)))
  c[2] = math.sqrt((T2 * C - L2) / (B * (C - B)))
  c[3] = math.sqrt((L2 - T2 * A) / (C * (C - A)))
  return c
end

-- The rates after t.
function naive.rates(p, w, t)
  local c = naive.constants(p, w)
  local o = c.order
  -- Euler's equations say which way the first two go round
  local i, j = o[1], o[2]
  local way = ((j - i) % 3 == 1 and 1 or -1) * (w[o[3]] < 0 and -1 or 1) * (p[o[3]] > p[i] and 1 or -1)
  local phi = math.atan(way * w[j] / c[2], w[i] / c[1])
  local sn, cn, dn = naive.sncndn(naive.first(phi, c.k2) + c.lambda * t, c.k2)
  local out = {}
  out[i], out[j], out[o[3]] = c[1] * cn, way * c[2] * sn, c[3] * dn * (w[o[3]] < 0 and -1 or 1)
  return out
end

-- The largest error of those rates over the largest of the true state.
function naive.rates_error(p, x0, t, want)
  local w, most, size = naive.rates(p, { x0[5], x0[6], x0[7] }, t), 0.0, 0.0
  for i = 1, 3 do
    local e = math.abs(w[i] - want[4 + i])
    if e ~= e then return math.huge end
    most, size = math.max(most, e), math.max(size, math.abs(want[4 + i]))
  end
  return size > 0 and most / size or most
end

-- ---- Euler's angles z-x-z, with 1/sin(theta) ----

local function angle_rates(I, mgl, y)
  local phi, theta, psi, a, b, c = table.unpack(y)
  local s, k = math.sin(psi), math.cos(psi)
  local precession = (a * s + b * k) / math.sin(theta)
  local up = mgl * math.sin(theta)
  return { precession, a * k - b * s, c - precession * math.cos(theta),
    ((I[2] - I[3]) * b * c + up * k) / I[1], ((I[3] - I[1]) * c * a - up * s) / I[2], (I[1] - I[2]) * a * b / I[3],
      phi }
end

-- A state by Runge and Kutta's steps of h in Euler's angles, weight mgl at the end of axis 3; NaN where theta is 0.
function naive.euler(I, mgl, x0, t, h)
  local x, y, z = x0[2], x0[3], x0[4]
  local sum, difference = 2 * math.atan(z, x0[1]), 2 * math.atan(y, x)
  local s = { (sum + difference) / 2, math.acos(1 - 2 * (x * x + y * y)), (sum - difference) / 2, x0[5], x0[6], x0[7] }
  local n = math.ceil(math.abs(t) / h)
  local step = t / n
  local function moved(k, by)
    local out = {}
    for i = 1, 6 do out[i] = s[i] + by * k[i] end
    return out
  end
  for _ = 1, n do
    local a = angle_rates(I, mgl, s)
    local b = angle_rates(I, mgl, moved(a, step / 2))
    local c = angle_rates(I, mgl, moved(b, step / 2))
    local d = angle_rates(I, mgl, moved(c, step))
    for i = 1, 6 do s[i] = s[i] + step * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) / 6 end
  end
  local plus, minus = (s[1] + s[3]) / 2, (s[1] - s[3]) / 2
  local k, l = math.cos(s[2] / 2), math.sin(s[2] / 2)
  return { k * math.cos(plus), l * math.cos(minus), l * math.sin(minus), k * math.sin(plus), s[4], s[5], s[6] }
end

-- ---- steps as one writes them ----

-- Euler's rates by n steps of Runge and Kutta, the attitude by q + h q (0, w)/2 without a norm; a rotor's momentum
-- about axis 3, if there is one.
function naive.march(p, x0, h, n, rotor)
  local r = rotor or 0.0
  local q, w = { table.unpack(x0, 1, 4) }, { table.unpack(x0, 5, 7) }
  local function f(v)
    return { ((p[2] - p[3]) * v[3] - r) * v[2] / p[1], ((p[3] - p[1]) * v[3] + r) * v[1] / p[2],
      (p[1] - p[2]) / p[3] * v[1] * v[2] }
  end
  local function moved(k, by) return { w[1] + by * k[1], w[2] + by * k[2], w[3] + by * k[3] } end
  for _ = 1, n do
    local a = f(w)
    local b = f(moved(a, h / 2))
    local c = f(moved(b, h / 2))
    local d = f(moved(c, h))
    local s, x, y, z = table.unpack(q)
    local u = { h / 2 * w[1], h / 2 * w[2], h / 2 * w[3] }
    q = { s - x * u[1] - y * u[2] - z * u[3], x + s * u[1] + y * u[3] - z * u[2], y + s * u[2] + z * u[1] - x * u[3],
      z + s * u[3] + x * u[2] - y * u[1] }
    for i = 1, 3 do w[i] = w[i] + h * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) / 6 end
  end
  return { q[1], q[2], q[3], q[4], w[1], w[2], w[3] }
end

return naive
