-- precise.lua -- the free sphere and symmetric top with many bits, for expected values; it is not what is emitted.
--
--     R(t) = exp([L]x t/I1) R(0) exp([k]x (1 - I3/I1) (k.w) t),   w(t) = w turned about k by -(1 - I3/I1)(k.w) t
-- (Landau, Lifshitz, Mechanics, sections 33 and 36).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"

-- The state at time t after the state x0 (rationals, q any length but 0), with `bits` bits; all rationals.
-- alpha, axial, k: moments across and along the axis k (k nil: sphere).
local function precise(alpha, axial, k, x0, t, bits)
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

return precise
