-- flat.lua -- when a disc on a plane lies flat: it touches the plane in a line there, and no motion leads on.
--
-- In the surface's axes g is the plane's normal, s = |(g1, g2)| the sine of the tilt, w_t the rates across the axis,
-- c the surface's centre from the centre of mass, R the disc's radius.  Two laws:
--   settled   The disc cannot rise so far that its fall back would take more than one time.step.  With
--             J = I_t + m ((R + |c_t|)^2 + h^2), the most that w_t can turn about, and the pull
--             k = m G (R - |c_t|)/J,  G the gravity along the normal (rolling: less w_n^2 h, h the height of the
--             centre of mass, which the turning about the contact point takes off),
--             energy gives  top = s (R + |c_t|)/(R - |c_t|) + w_t^2/(2 k),  and the fall from there takes
--             sqrt(2 top/k) = sqrt(rise)/k.  A disc that only passes near to flat is above this one step later: it
--             must stay so for one.
--   fallen    (g1, g2) goes on with g' = g x w.  Where it would pass 0 at less than the root of a rounding, half of
--             the digits are gone that tell where the contact point is: the disc falls flat.  Its way to where it is
--             least takes toward/speed, and the square of the least is miss/speed.
-- `law` takes numbers, or expressions (ABOVE the line): `polhode run` and a sweep's members have the same law.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"

local flat = {}

-- The disc of a plane's effect as expressions of the parameters, or nil: {lever = R - |c_t| and reach = R + |c_t|, m;
-- high = h at most, m; mass, J, G and normal of above; least = the least that w_t can turn about}.
function flat.disc(m, plane)
  local a = plane.a
  local s = a.surface
  if not s.disc then return nil end
  local I, mass = m.inertia, m.mass
  local c = vec.sub(s.at, context.dry(m).origin)
  local beside = expr.sqrt(c[1] ^ 2 + c[2] ^ 2)
  local reach, lever, high = s.half[1] + beside, s.half[1] - beside, s.rim + expr.call("abs", c[3])
  -- the moments across the axis are mean + off and mean - off
  local mean, off = (I[1] + I[2]) / 2, expr.sqrt(((I[1] - I[2]) / 2) ^ 2 + I[4] ^ 2)
  return { lever = lever, reach = reach, high = high, mass = mass, normal = a.normal,
    J = mean + off + mass * (reach ^ 2 + high ^ 2), least = mean - off + mass * lever ^ 2,
    G = -vec.dot(a.normal, a.gravity), rolls = a.law == "rolling" }
end

-- Of a disc's numbers, the attitude and the rates: {pull = k, rise = 2 k top, square = s^2, and toward, speed, miss}.
function flat.law(d, q, w, sqrt)
  local g = vec.matvec(vec.transpose(vec.rotation(q)), d.normal)
  local rate, n = vec.cross(g, w), vec.dot(g, w)
  local G = d.rolls and d.G - n ^ 2 * d.high or d.G
  local pull, square = d.mass * G * d.lever / d.J, g[1] ^ 2 + g[2] ^ 2
  return { pull = pull, square = square, rise = 2 * pull * sqrt(square) * d.reach / d.lever + w[1] ^ 2 + w[2] ^ 2,
    toward = -(g[1] * rate[1] + g[2] * rate[2]), speed = rate[1] ^ 2 + rate[2] ^ 2,
    miss = (g[1] * rate[2] - g[2] * rate[1]) ^ 2 }
end

return flat
