-- disc.lua -- the rolling disc in numbers: its two linear integrals, the least and greatest tilt, the period between.
--
-- A disc of revolution about its axis, centre of mass in its centre, centre circle R, edge rounded by rho, rolls on a
-- level plane at rest.  theta: the axis from the normal, s and c its sine and cosine; a = phi' s, phi the precession; w
-- the rate about the axis.  Per m R^2, with k1 = I1/(m R^2), k3 = I3/(m R^2), p = rho/R, gamma = G/R:
--     k3 dw/dtheta = (1 + p s) f,   k1 da/dtheta = k3 w - k1 a c/s - p c f,               (Appell, Korteweg 1899)
--     f = (a + p (k3/k1 - 1) c w)/(1 + (1 + p s)^2/k3 + p^2 c^2/k1)
--     J theta'^2/2 = W = E - gamma s - (k1 a^2 + k3 w^2 + v^2)/2,   J = k1 + 1 + 2 p s + p^2,   v = p c a - (1 + p s) w
-- (f: the force along the horizontal diameter over theta'; v: the velocity of the centre along it).  p = 0: Legendre's
-- equation (1/s) (s w')' = kappa w, nu (nu + 1) = -kappa = -k3/(k1 (1 + k3)).
-- All is a series in x = ln tan(theta/2), dtheta = s dx: no coefficient is singular, near flat a is e^-x.  Differences
-- of W are sums of its own series from the start on, so small swings and near separatrices keep their digits.  The
-- series of w, a, s, c converge for |dx| < pi/2, and for p > 0 up to dx = i acos(1/s), s the one root > 1 of 1 +
-- (1 + p s)^2/k3 + p^2 c^2/k1 = 0: at least for |dx| < pi/4, as I3 <= 2 I1 makes s >= sqrt 2.  DOUBLES, below the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local disc = {}

local last = 31 -- terms fall as 4^-k: the first that is left out is 2^-64
local ulp = 2.0 ^ -52
local least_sine = 1e-290 -- nearer to flat it is flat

-- The radius of convergence.
local function radius(k1, k3, p)
  local A, B, C = p * p * (1 / k1 - 1 / k3), p / k3, 1 + 1 / k3 + p * p / k1 -- A s^2 - 2 B s - C = 0
  if A <= 0 then return math.pi / 2 end
  return math.acos(A / (B + math.sqrt(B * B + A * C)))
end

-- {I1, I3, m, R, rho, G} as numbers -> the constants above.
function disc.of(I1, I3, mass, R, rho, G)
  local size = mass * R * R
  local k1, k3, p = I1 / size, I3 / size, rho / R
  return { k1 = k1, k3 = k3, p = p, gamma = G / R, mass = mass, R = R, G = G, reach = radius(k1, k3, p) / 4 }
end

local function product(x, y, k)
  local sum = 0.0
  for j = 0, k do sum = sum + x[j] * y[k - j] end
  return sum
end

-- Series of s, c, a, w about the node in direction * dx; ss, sw, ac: of products.
local function rates(d, z, direction)
  local k1, k3, p = d.k1, d.k3, d.p
  local s, c, a, w = { [0] = z.s }, { [0] = z.c }, { [0] = z.a }, { [0] = z.w }
  local ss, sc, sw, ac, cw, D, f, lever = {}, {}, {}, {}, {}, {}, {}, {}
  for k = 0, last - 1 do
    ss[k], sc[k], cw[k] = product(s, s, k), product(s, c, k), product(c, w, k)
    sw[k], ac[k] = product(s, w, k), product(a, c, k)
    D[k] = (k == 0 and 1 + 1 / k3 + p * p / k1 or 0.0) + 2 * p / k3 * s[k] + p * p * (1 / k3 - 1 / k1) * ss[k]
    local sum = a[k] + p * (k3 / k1 - 1) * cw[k]
    for j = 1, k do sum = sum - D[j] * f[k - j] end
    f[k], lever[k] = sum / D[0], s[k] + p * ss[k]
    local h = direction / (k + 1)
    s[k + 1], c[k + 1] = h * sc[k], -h * ss[k]
    w[k + 1] = h * product(lever, f, k) / k3
    a[k + 1] = h * (k3 / k1 * sw[k] - ac[k] - p / k1 * product(sc, f, k))
  end
  sw[last], ac[last] = product(s, w, last), product(a, c, last)
  return { s = s, c = c, a = a, w = w }, sw, ac
end

-- The same with W, whose value and slope are the node's; a node without them gets the slope of the formula.
local function expand(d, z, direction)
  local n, sw, ac = rates(d, z, direction)
  local v, W = {}, {}
  for k = 0, last do v[k] = d.p * (ac[k] - sw[k]) - n.w[k] end
  for k = 0, last do
    W[k] = -(d.gamma * n.s[k] + (d.k1 * product(n.a, n.a, k) + d.k3 * product(n.w, n.w, k) + product(v, v, k)) / 2)
  end
  W[0], W[1] = z.W or 0.0, z.slope and direction * z.slope or W[1]
  n.W, n.direction = W, direction
  return n
end

local function value(x, h)
  local sum = 0.0
  for k = last, 0, -1 do sum = sum * h + x[k] end
  return sum
end

local function slope(x, h)
  local sum = 0.0
  for k = last, 1, -1 do sum = sum * h + k * x[k] end
  return sum
end

local function node(n, h)
  return { s = value(n.s, h), c = value(n.c, h), a = value(n.a, h), w = value(n.w, h), W = value(n.W, h),
    slope = n.direction * slope(n.W, h) }
end

-- Below this, at most `limit`, the series x^first (q_first + ..) has no other root (Cauchy's bound): Newton's method
-- from above for q_first = sum |q_k| x^(k - first), its next place written as a quotient of positive sums.
local function clear(q, first, limit)
  local at = limit
  for _ = 1, 200 do
    local above, below = 0.0, 0.0
    for k = last, first + 1, -1 do
      local size = math.abs(q[k])
      above, below = above * at + (k - first - 1) * size, below * at + (k - first) * size
    end
    local further = (above * at + q[first]) / below
    if below == 0 or further >= at then break end
    at = further
  end
  return at
end

-- The first root of W from z on, and its distance; nil: it lies flat before.
local function turning(d, z, direction)
  local total, first = 0.0, z.W == 0 and 1 or 0
  while z.s > least_sine do
    local n = expand(d, z, direction)
    local h = clear(n.W, first, d.reach)
    if first == 1 then h = h / 2 end
    z, total = node(n, h), total + h
    if first == 0 and (z.W <= 0 or h <= ulp * total) then
      z.W = 0.0
      return z, total
    end
    first = 0
  end
  return nil
end

-- J, per m R^2.
function disc.inertia(d, s) return d.k1 + 1 + 2 * d.p * s + d.p ^ 2 end

-- The reaction at a place: m (G + R (c theta'' - s theta'^2)), J theta'' = W'/s - p c theta'^2.
function disc.reaction(d, z)
  -- not the slope of the chain: where W has become constant it is rounding
  local change, J = expand(d, { s = z.s, c = z.c, a = z.a, w = z.w }, 1).W[1], disc.inertia(d, z.s)
  local square = 2 * (z.W or 0.0) / J
  return d.mass * (d.G + d.R * (z.c * (change / z.s - d.p * z.c * square) / J - z.s * square))
end

-- Keeps in `least` = {N, arc, at, step} the least reaction of some places on an arc of length h.
local function watch(d, n, h, least)
  for k = 0, 4 do
    local N = disc.reaction(d, node(n, h * k / 4))
    if N < least.N then least.N, least.arc, least.at, least.step = N, n, h * k / 4, h / 4 end
  end
end

-- The least reaction, from the places about the least one by golden sections.
local function refined(d, least)
  local low, high, part = math.max(0.0, least.at - least.step), least.at + least.step, (math.sqrt(5) - 1) / 2
  for _ = 1, 60 do
    local x, y = high - part * (high - low), low + part * (high - low)
    local Nx, Ny = disc.reaction(d, node(least.arc, x)), disc.reaction(d, node(least.arc, y))
    least.N = math.min(least.N, Nx, Ny)
    if Nx < Ny then high = y else low = x end
  end
  return least.N
end

-- The integral of 1/theta' dtheta and of phi'/theta' dtheta over `length` from the root z of W; nil: W has a double
-- root there.  Series are in x/h, as those of a tiny h overflow.  least: see `watch`.
local function half(d, z, direction, length, least)
  local time, turn, done, first = 0.0, 0.0, 0.0, 1
  while done < length do
    local n = expand(d, z, direction)
    local q = {} -- theta'^2 = 2 W/J
    for k = 0, last do
      local sum = 2 * n.W[k]
      for j = 1, k do sum = sum - 2 * d.p * n.s[j] * q[k - j] end
      q[k] = sum / (d.k1 + 1 + 2 * d.p * n.s[0] + d.p ^ 2)
    end
    if q[first] <= 0 then return nil end
    local h = math.min(clear(q, first, 4 * d.reach) / 4, length - done)
    local s, a, r, g, top, power = {}, {}, {}, {}, last - first, 1.0
    for k = 0, top do
      s[k], a[k], g[k] = n.s[k] * power, n.a[k] * power, q[k + first] * power
      power = power * h
    end
    r[0] = 1 / math.sqrt(g[0]) -- r = g^(-1/2): g r' = -g' r/2
    for k = 1, top do
      local sum = 0.0
      for j = 1, k do sum = sum + (k - j / 2) * g[j] * r[k - j] end
      r[k] = -sum / (k * g[0])
    end
    local e, t, phi = first == 1 and 0.5 or 1.0, 0.0, 0.0
    for k = top, 0, -1 do t, phi = t + product(s, r, k) / (k + e), phi + product(a, r, k) / (k + e) end
    time, turn = time + t * h ^ e, turn + phi * h ^ e
    watch(d, n, h, least)
    z, done, first = node(n, h), done + h, 0
  end
  return time, turn
end

-- The square of the rate of a small nutation about a steady state {s, c, a, w}: -2 W_2/(J s^2).
function disc.nutation(d, z)
  return -2 * expand(d, z, 1).W[2] / (disc.inertia(d, z.s) * z.s ^ 2)
end

-- w and a of the solution where it is upright: the two linear integrals.
function disc.integrals(d, z)
  local left = math.log((1 + math.abs(z.c)) / z.s)
  local direction = z.c < 0 and -1 or 1
  while left > 0 do
    local h = math.min(left, d.reach)
    z, left = node(expand(d, z, direction), h), left - h
  end
  return z.w, z.a
end

-- The swing from {s, c, a, w} and theta': {least, greatest: states there; period, turn of phi in it; N: the least
-- reaction}.  A steady one has the limits of small swings; least nil: nothing turns it back before it falls flat;
-- period nil: it takes for ever.
function disc.swing(d, z, rate)
  local start = { s = z.s, c = z.c, a = z.a, w = z.w, W = disc.inertia(d, z.s) * rate ^ 2 / 2 }
  start.slope = expand(d, start, 1).W[1]
  local low, high, down, up = start, start, 0.0, 0.0
  if start.W == 0 and start.slope == 0 then
    local square = disc.nutation(d, z)
    local period = square > 0 and 2 * math.pi / math.sqrt(square) or nil
    return { least = start, greatest = start, period = period, turn = period and period * z.a / z.s,
      N = disc.reaction(d, start) }
  end
  if z.a == 0 and z.w == 0 then return {} end
  if start.W > 0 or start.slope < 0 then low, down = turning(d, start, -1) end
  if start.W > 0 or start.slope > 0 then high, up = turning(d, start, 1) end
  if not low or not high then return {} end
  local length = (down + up) / 2
  local N = { N = math.huge }
  local t1, phi1 = half(d, low, 1, length, N)
  local t2, phi2 = half(d, high, -1, length, N)
  local known = t1 and t2
  return { least = low, greatest = high, period = known and 2 * (t1 + t2), turn = known and 2 * (phi1 + phi2),
    N = known and refined(d, N) }
end

-- Between two greatest heights, for ever flatter falls, rad: near flat (k1 + p^2) a^2/2 is all of W but its constant.
function disc.flat_turn(d) return math.pi * math.sqrt(1 + 1 / (d.k1 + d.p ^ 2)) end

return disc
