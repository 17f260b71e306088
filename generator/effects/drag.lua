-- drag.lua -- quadratic drag on the turning: a torque -c |w| w.
--
-- |w| is written sqrt(w.w + 2^-126 rad^2/s^2), so that its derivatives exist at rest; above 1e-11 rad/s the difference
-- is below rounding in double.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local custom = require "generator.effects.custom"

local drag = {
  name = "effect.drag",
  about = "quadratic drag on the turning: torque -c |w| w",
  args = { { name = "c", dim = "inertia", sign = "nonnegative", motion = true } }, -- N m s^2
  conserves = {},
  idle = { { "c" } },
  formula = "N = -c |w| w",
  signs = "c >= 0 in N m s^2 takes energy out: N.w = -c |w|^3",
  source = "Landau, Lifshitz, Fluid Mechanics, section 45: resistance at high Reynolds numbers, here isotropic",
  example = "paddle",
}

function drag.torque(a, c)
  local k = c.lift(a.c, "drag_c", "quadratic drag, N m s^2")
  local speed = expr.sqrt(vec.dot(c.w, c.w) + expr.num(R.new(2) ^ -126))
  return vec.map(c.w, function(x) return -k * speed * x end)
end

function drag.numeric(a, num, _, code, c)
  if not motion.free(a.c) then return custom.told(drag.torque(a, c), nil, code) end
  return { kind = "drag", c = num(a.c) }
end

return drag
