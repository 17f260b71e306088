-- closed.lua -- which closed form of the motion a scene has, and why the others are refused.
--
-- Decided from the effects and the structure of the tensor, never from numbers.  Known here: the free sphere
-- (uniform rotation) and the free symmetric top (Poinsot's regular precession),
--     R(t) = exp([L]x t/I1) R(0) exp([k]x (1 - I3/I1) (k.w) t),   w(t) = w turned about k by -(1 - I3/I1)(k.w) t
-- (Landau, Lifshitz, Mechanics, sections 33 and 36: precession |L|/I1 about L, and the rest about the axis), and the
-- asymmetric top (templates/top.c).  `precise` evaluates the first two with many bits for expected values; it is not
-- what is emitted.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"

local closed = {}

-- {kind, theorem, text} or {refused = reason}
function closed.detect(m, eq)
  local s = m.structure
  if not m.has.attitude then
    return { refused = "the closed forms known to this version carry the attitude, and the scene has none" }
  end
  if not eq.free then
    return { refused = "an effect acts on the body (" .. #m.record.effects .. " in all); the closed forms known to " ..
      "this version are those of torque-free motion" }
  end
  if s.kind == "sphere" then
    return { kind = "sphere", theorem = "free spherical top, uniform rotation",
      text = { "All moments are equal, so L = I1 w and w are constant in both frames:",
        "q(t) = q(0) (cos |w|t/2, w/|w| sin |w|t/2).  Landau, Lifshitz, Mechanics, section 33." } }
  end
  if s.kind == "symmetric" then
    return { kind = "symmetric", theorem = s.rod and "free rod, rotation in a plane" or
      "free symmetric top, regular precession",
      text = { "Two moments are equal (I1), the third is I3 about the axis k.  Seen from the inertial frame the axis",
        "goes round L at |L|/I1; in the body w goes round k at Omega = (I3 - I1)/I1 k.w; hence",
        "q(t) = (cos, L/|L| sin)(|L|t/2 I1) q(0) (cos, k/|k| sin)((1 - I3/I1) k.w t/2).",
        "Landau, Lifshitz, Mechanics, sections 33 and 36." } }
  end
  return { kind = "asymmetric", theorem = "free asymmetric top, theta functions",
    text = { "With u linear in time L = (B1 cn u, B2 sn u, B3 dn u) along the principal axes, Jacobi's functions; the",
      "attitude is exp(i mu t) times theta4 and theta1 of pi u/(2 K) - i eta, a complex pair (Jacobi 1849; Whittaker,",
      "Analytical Dynamics, section 69).  Set up in twice the working precision; any moments and any state: symmetric,",
      "spherical, a rod, spin about an axis and the separatrix are limits that the same formulas pass through." } }
end

-- The state at time t after the state x0 (rationals, q any length but 0), with `bits` bits; all rationals.
-- alpha, axial, k: moments across and along the axis k (k nil: sphere).
function closed.precise(alpha, axial, k, x0, t, bits)
  local function round(v) return vec.map(v, function(x) return R.round(x, bits) end) end
  local function sqrt(x) return R.sign(x) == 0 and x or R.apply("sqrt", bits, x) end
  local function turn(axis, n, angle) -- (cos, axis/n sin) with axis/n = 0 where n = 0
    if R.sign(n) == 0 then return { R.one, R.zero, R.zero, R.zero } end
    local s, c = R.apply("sin", bits, angle), R.apply("cos", bits, angle)
    return round { c, s * axis[1] / n, s * axis[2] / n, s * axis[3] / n }
  end
  local q, w = { table.unpack(x0, 1, 4) }, { table.unpack(x0, 5, 7) }
  local n = sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3] + q[4] * q[4])
  q = vec.map(q, function(x) return R.round(x / n, bits) end)
  local half = R.half
  local v, spin = w, R.zero
  if k then
    spin = vec.dot(k, w) / vec.dot(k, k)
    v = vec.add(w, vec.scale((axial / alpha - R.one) * spin, k))
  end
  local rate = sqrt(R.round(vec.dot(v, v), bits))
  q = round(vec.qmul(q, turn(v, rate, rate * half * t)))
  if not k then return { q[1], q[2], q[3], q[4], w[1], w[2], w[3] } end
  local length = sqrt(vec.dot(k, k))
  local chi = (R.one - axial / alpha) * spin * length
  q = round(vec.qmul(q, turn(k, length, chi * half * t)))
  local along = vec.scale(spin, k)
  local across = vec.sub(w, along)
  local s, c = R.apply("sin", bits, -chi * t), R.apply("cos", bits, -chi * t)
  local side = vec.map(vec.cross(k, across), function(x) return x / length end)
  local wt = round(vec.add(along, vec.add(vec.scale(c, across), vec.scale(s, side))))
  return { q[1], q[2], q[3], q[4], wt[1], wt[2], wt[3] }
end

return closed
