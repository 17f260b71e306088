-- A box-shaped satellite that two thrusters turn: a pulse about x, a dithered torque about z.
-- The table is linear between its rows and constant beyond them; rates in rad/s, times in s, torques in N m.
-- SPDX-License-Identifier: GPL-3.0-or-later

local push = param("push", 0.02, "N m")
local rate = param("rate", 1.5, "rad/s")

return scene {
  name = "thruster",
  body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 12 },
  effects = {
    effect.torque { body = { { { 1, 0 }, { 1.5, push }, { 3, push }, { 3.5, 0 } }, 0, push * sin(rate * t) } },
  },
  initial = { omega = { 0.01, 0.02, 0.03 } },
  time = { horizon = 6, step = 0.001 },
}
