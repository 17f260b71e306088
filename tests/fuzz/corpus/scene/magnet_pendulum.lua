-- Effects of the scene's own: a pendulum over a magnet, and the heat of its bearing as a state.
-- The magnet's pull falls off with the height.
-- The potential is written, the torque follows from it; the bearing's torque is a second effect with a state.
-- SPDX-License-Identifier: GPL-3.0-or-later

local pull = param("pull", 0.3, "N m")
local rub = param("rub", 0.002, "N m s")

return scene {
  name = "magnet_pendulum",
  body = solid.sphere { r = 0.05, mass = 0.4 }:at { 0, 0, -0.5 },
  origin = { 0, 0, 0 },
  effects = {
    effect.gravity {},
    effect.custom { -- the height of the bob is -(qw^2 - qx^2 - qy^2 + qz^2)/2
      params = { pull = pull },
      potential = function(s)
        local down = s.q[1] ^ 2 - s.q[2] ^ 2 - s.q[3] ^ 2 + s.q[4] ^ 2
        return -s.pull / (3 - 2 * down)
      end,
    },
    effect.custom {
      params = { rub = rub },
      torque = function(s) return { -s.rub * s.w[1], -s.rub * s.w[2], -s.rub * s.w[3] } end,
      states = { heat = { unit = "J", rate = function(s) return s.rub * (s.w[1] ^ 2 + s.w[2] ^ 2 + s.w[3] ^ 2) end } },
    },
  },
  initial = { omega = { 0.5, 0.1, 3 }, attitude = { axis = "x", angle = 0.7 } },
  time = { horizon = 5, step = 0.001 },
}
