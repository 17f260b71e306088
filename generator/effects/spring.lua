-- spring.lua -- a torsion spring at the pivot, about an axis or in all directions.
--
-- p = rest* q = (p0, u) is the turn from the rest attitude, u = n sin(angle/2).  The potential is
--     V = 2 (k1 u1^2 + k2 u2^2 + k3 u3^2)          three stiffnesses, or one for all directions
--     V = 2 k (a.u)^2                              about the unit vector a
-- a polynomial of the attitude and the same for q and -q, so it is regular for every attitude, which the angle itself
-- is not (at half a turn its direction is undetermined).  With K u for (k1 u1, ..) or k a (a.u):
--     N = -2 (p0 K u + (K u) x u)
-- A turn by the angle about a principal direction of K has V = k (1 - cos angle) and N = -k sin(angle): -k angle and
-- k angle^2/2 to first order, the largest torque k at a quarter turn, and V comes back to 0 after a whole one.
-- u has the same components in body and rest axes, so `axis` is at once fixed in the body and at rest.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local spring = {
  name = "effect.spring",
  about = "torsion spring at the pivot: stiffness with axis and rest angle, or {kx, ky, kz} with a rest attitude",
  takes = { { "stiffness", "kg m^2/s^2", nil, "a number, or three without axis" },
    { "axis", "1", nil, "for one axis: of any length" },
    { "rest", "rad or 1", "0 or {1, 0, 0, 0}", "with axis the angle of rest, else the attitude of rest" } },
  reader = "spring", keeps = "T+V",
  idle = { { "stiffness", stiffness = "k" } },
  formula = "V = 2 u.K u, N = -2 (p0 K u + (K u) x u) with (p0, u) = rest* q, |u| = sin(angle/2)",
  signs = "for small angles N = -K angle, V = K angle^2/2; about an axis N = -k sin(angle), V = k (1 - cos(angle))",
  source = "derived here; as quaternion feedback: Wie, Weiss, Arapostathis, J. Guidance 12 (1989) 375",
  example = "torsion_pendulum",
}

local comp = { "x", "y", "z" }

function spring.check(a)
  if a.axis then return { { vec.dot(a.axis, a.axis), "axis must not be zero" } } end
  local n = expr.zero
  for i = 1, 4 do n = n + a.rest[i] ^ 2 end
  return { { n, "rest must not be zero" } }
end

-- The rest attitude as a unit quaternion, and the unit axis or nil.
local function rest(a)
  if a.axis then
    local n = expr.sqrt(vec.dot(a.axis, a.axis))
    local axis = vec.map(a.axis, function(x) return ratio.tidy(x / n) end)
    local s = expr.call("sin", a.angle / 2)
    return { expr.call("cos", a.angle / 2), s * axis[1], s * axis[2], s * axis[3] }, axis
  end
  local n = expr.zero
  for i = 1, 4 do n = n + a.rest[i] ^ 2 end
  return vec.map(a.rest, function(x) return ratio.tidy(x / expr.sqrt(n)) end)
end

-- p0, u and K u.
local function turn(a, c)
  local q0, axis = rest(a)
  q0 = vec.map(q0, function(x, i)
    return c.constant("rest" .. string.sub("wxyz", i, i), x, "rest attitude of the spring")
  end)
  local p = vec.qmul({ q0[1], -q0[2], -q0[3], -q0[4] }, c.q)
  local u = { p[2], p[3], p[4] }
  if not axis then
    return p[1], u, vec.map(u, function(x, i)
      return c.constant("spring" .. (a.k[1] == a.k[2] and a.k[2] == a.k[3] and "" or comp[i]), a.k[i],
        "stiffness, N m") * x
    end)
  end
  local k = c.constant("spring", a.k / vec.dot(a.axis, a.axis), "stiffness over the axis squared, N m")
  axis = vec.map(a.axis, function(x, i) return c.constant("s" .. comp[i], x, "axis of the spring") end)
  return p[1], u, vec.scale(k * vec.dot(axis, u), axis)
end

function spring.torque(a, c)
  local p0, u, Ku = turn(a, c)
  local twist = vec.cross(Ku, u)
  return vec.map(Ku, function(x, i) return -2 * (p0 * x + twist[i]) end)
end

function spring.potential(a, c)
  local _, u, Ku = turn(a, c)
  return 2 * vec.dot(u, Ku)
end

function spring.conserves() return { "T+V" } end

function spring.numeric(a, num)
  local q0, axis = rest(a)
  return { kind = "spring", rest = vec.map(q0, num), axis = axis and vec.map(axis, num),
    stiffness = axis and { num(a.k), 0.0, 0.0 } or vec.map(a.k, num) }
end

return spring
