-- gravity_gradient.lua -- the torque of a central body's field on a body in orbit, about its centre of mass.
--
--     N = 3 mu/r^3 o x I o,    o = R(q)^T (cos f, sin f, 0)     from the Earth's centre to the body
-- The orbit lies in the inertial x-y plane.  A circular one starts on x: f = n t, n = sqrt(mu/r^3), and needs no state.
-- On an elliptic one, with the perigee on x, the true anomaly f is a state: with p = a (1 - e^2)
--     r = p/(1 + e cos f),   f' = sqrt(mu/p^3) (1 + e cos f)^2,   f(0) = anomaly.
-- The attitude does not act on the orbit (terms of order (size of the body/r)^2 are left out there, and those of the
-- next order in the torque).  NAME_energy is T: the potential 3/2 mu/r^3 o.I o depends on time.  On a circular orbit
-- that is a turn about z, and NAME_jacobi_integral is T + 3/2 n^2 o.I o - n L_z (Hughes, section 9.1).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local gradient = {
  name = "effect.gravity_gradient",
  about = "torque of a central field, mu, on a circular orbit {radius} or an elliptic one {a, e, anomaly}",
  single = true, central = true, keeps = "w3, T+V-n.L on a circular orbit",
  takes = { { "mu", "m^3/s^2", nil, "gravitational parameter of the central body" },
    { "orbit.radius", "m", nil, "of a circular orbit, which starts on x" },
    { "orbit.a", "m", nil, "half the longer axis of an elliptic orbit" },
    { "orbit.e", "1", nil, "its eccentricity, 0 <= e < 1" },
    { "orbit.anomaly", "rad", "0", "true anomaly at t = 0, from the perigee on x" } },
  idle = { { "mu" }, "the three moments of inertia are equal" },
  formula = "N = 3 mu/r^3 o x I o, o = R(q)^T (cos f, sin f, 0); circular: f = sqrt(mu/r^3) t; elliptic: " ..
    "f' = sqrt(mu/p^3) (1 + e cos f)^2, r = p/(1 + e cos f), p = a (1 - e^2)",
  signs = "o points from the central body to the satellite; the orbit turns from inertial x to y; the axis of the " ..
    "least moment is drawn to the vertical. On a circular orbit NAME_jacobi_integral = T + 3/2 n^2 o.I o - n L_z, " ..
    "n = sqrt(mu/r^3)",
  source = "Hughes, Spacecraft Attitude Dynamics, section 8.1; Wertz, Spacecraft Attitude Determination and " ..
    "Control, 17.2",
  example = "gravity_gradient",
}

local comp = { "x", "y", "z" }

function gradient.read(ctx, line, what, given, args)
  local a, ok = args.read(ctx, line, what, { { name = "mu", sign = "nonnegative", dim = "gravitation" } }, given,
    { "orbit" })
  local orbit, at = given.orbit, ctx.diag:locate(line, "orbit")
  if not args.plain(orbit) then
    ctx.diag:error(at, what, "orbit must be a table {radius =} or {a =, e =, anomaly =}",
      orbit ~= nil and tostring(orbit) or nil)
    return nil
  end
  local specs = { { name = "radius", dim = "length", sign = "positive" } }
  if orbit.radius == nil then
    specs = { { name = "a", dim = "length", sign = "positive" }, { name = "e", sign = "nonnegative" },
      { name = "anomaly", default = 0 } }
  end
  local o, good = args.read(ctx, at, what .. ", orbit", specs, orbit)
  if not ok or not good then return nil end
  local rule = "e must be less than 1"
  if o.e and not args.condition(ctx, at, what .. ", orbit", rule, 1 - o.e, tostring(orbit.e)) then return nil end
  a.radius, a.a, a.e, a.anomaly = o.radius, o.a, o.e, o.anomaly
  return a
end

-- mu/p^3, p the radius or the parameter of the ellipse.
local function strength(a)
  local p = a.radius or a.a * (1 - a.e ^ 2)
  return a.mu / p ^ 3
end

-- A circular orbit needs none: f = n t.
function gradient.states(a)
  if a.radius or a.mu == expr.zero then return {} end
  return { { name = "anomaly", initial = a.anomaly, unit = "rad", about = "true anomaly of the orbit" } }
end

-- Half of the angle f on the orbit, as a cosine and a sine.
local function half(a, c)
  local f = c.own.anomaly
  if not a.radius then return f / 2 end
  return c.constant("nu_2", expr.sqrt(strength(a)) / 2, "half the mean motion of the orbit, rad/s") * c.t
end

-- 1 + e cos f
local function opening(a, c)
  local ecc = c.constant("ecc", a.e, "eccentricity of the orbit")
  return 1 + ecc * (1 - 2 * expr.call("sin", half(a, c)) ^ 2)
end

function gradient.derivative(a, c)
  return { anomaly = c.constant("nu", expr.sqrt(strength(a)), "sqrt(mu/p^3), rad/s") * opening(a, c) ^ 2 }
end

-- o = (1 - 2 b, 2 a2, 2 a3), the first row of R(p), p = (cos f/2 - k sin f/2) q the attitude from the body to the
-- axes of the orbit: b, a2, a3.
local function vertical(a, c)
  local C, S, q = expr.call("cos", half(a, c)), expr.call("sin", half(a, c)), c.q
  local w, x, y, z = C * q[1] + S * q[4], C * q[2] + S * q[3], C * q[3] - S * q[2], C * q[4] - S * q[1]
  return y * y + z * z, x * y - w * z, x * z + w * y
end

local function factor(a, c) return a.radius and expr.one or opening(a, c) ^ 3 end

-- Of three principal moments the torque is (I3 - I2) K o2 o3 and cyclic, K = 3 mu/r^3: in Euler's equations w2 w3 less
-- K o2 o3.
function gradient.products(a, c)
  if a.mu == expr.zero then return nil end
  local b, a2, a3 = vertical(a, c)
  local k = c.constant("gg", 12 * strength(a), "12 mu/p^3, 1/s^2") * factor(a, c)
  local k_2 = c.constant("gg_2", 6 * strength(a), "half of it") * factor(a, c)
  return { -(k * a2) * a3, (k * b - k_2) * a3, (k * b - k_2) * a2 }
end

-- With a diagonal tensor by differences of moments, which do not cancel.
function gradient.torque(a, c)
  if a.mu == expr.zero then return { expr.zero, expr.zero, expr.zero } end
  local k, b, a2, a3 = 3 * strength(a), vertical(a, c)
  local o, I = { 1 - 2 * b, 2 * a2, 2 * a3 }, c.tensor()
  if c.diagonal then
    local out = {}
    for i = 1, 3 do
      local j, l = i % 3 + 1, (i + 1) % 3 + 1
      local difference = c.constant("gg" .. comp[i], k * (c.inertia[l] - c.inertia[j]),
        "3 mu/p^3 times the difference of moments, N m")
      out[i] = difference * factor(a, c) * o[j] * o[l]
    end
    return out
  end
  return vec.scale(c.constant("gg", k, "3 mu/p^3, 1/s^2") * factor(a, c), vec.cross(o, vec.apply(I, o)))
end

-- A circular orbit turns the field about z.
function gradient.turning(a, c)
  if not a.radius or a.mu == expr.zero then return nil end
  local b, a2, a3 = vertical(a, c)
  local o = { 1 - 2 * b, 2 * a2, 2 * a3 }
  local k = c.constant("kV", expr.lift "3/2" * strength(a), "3/2 mu/p^3, 1/s^2")
  return { rate = expr.sqrt(strength(a)), potential = k * vec.dot(o, vec.apply(c.tensor(), o)) }
end

function gradient.conserves() return { "w3" } end -- of a body symmetric about z, whose torque along z vanishes

function gradient.numeric(a, num)
  return { kind = "gravity_gradient", mu = num(a.mu), radius = num(a.radius or a.a), e = a.e and num(a.e) or 0.0,
    elliptic = a.radius == nil }
end

return gradient
