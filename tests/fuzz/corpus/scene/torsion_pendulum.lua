-- A bar that hangs on a wire and turns about it, as in Cavendish's balance.
-- The spring's torque about the wire is -k sin(angle - rest): for small angles the period is 2 pi sqrt(I/k).
-- SPDX-License-Identifier: GPL-3.0-or-later

local k = param("k", 4e-4, "N m")

return scene {
  name = "torsion_pendulum",
  body = solid.box { x = 0.4, y = 0.02, z = 0.02, mass = 0.5 },
  effects = { effect.spring { stiffness = k, axis = { 0, 0, 1 }, rest = 0.3 } },
  initial = { omega = { 0, 0, 0.05 } },
  time = { horizon = 60, step = 0.01 },
}
