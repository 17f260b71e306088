-- friction.lua -- dry friction at the pivot: a torque of constant size against the rates, smoothed near rest.
--
--     N = -T w/sqrt(w.w + s^2)
-- Coulomb's law N = -T w/|w| has every |N| <= T at rest and no derivative there.  Here the torque is linear, -(T/s) w,
-- for |w| well below s and within 1 - (s/|w|)^2/2 of its size above, and zero at rest: nothing sticks.  Where Coulomb's
-- body would stand under a steady torque N0 < T, this one creeps at |w| = s N0/sqrt(T^2 - N0^2).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local custom = require "generator.effects.custom"

local friction = {
  name = "effect.friction",
  about = "dry friction at the pivot: torque -T w/sqrt(w^2 + s^2), smoothing s a rate",
  args = { { name = "torque", dim = "torque", sign = "nonnegative", motion = true },
    { name = "smoothing", dim = "rate", sign = "positive" } },
  conserves = {},
  idle = { { "torque" } },
  formula = "N = -T w/sqrt(w.w + s^2)",
  signs = "T >= 0 takes energy out; at rest N = 0, so that nothing sticks: a steady torque N0 < T makes the body " ..
    "creep at s N0/sqrt(T^2 - N0^2)",
  source = "Coulomb's law made smooth; Armstrong-Helouvry, Dupont, Canudas de Wit, Automatica 30 (1994) 1083",
  example = "spun_coin",
}

-- s^2 is the constant, so that it need not be formed at each call.
function friction.torque(a, c)
  local T = c.lift(a.torque, "friction", "dry friction, N m")
  -- positive: rounded to 0, friction at rest would be 0/0
  local s2 = c.constant("smooth", a.smoothing ^ 2, "its smoothing rate squared, rad^2/s^2", true)
  local size = expr.sqrt(vec.dot(c.w, c.w) + s2)
  return vec.map(c.w, function(x) return -T * x / size end)
end

function friction.numeric(a, num, _, code, c)
  if not motion.free(a.torque) then return custom.told(friction.torque(a, c), nil, code) end
  return { kind = "friction", torque = num(a.torque), smoothing = num(a.smoothing) }
end

return friction
