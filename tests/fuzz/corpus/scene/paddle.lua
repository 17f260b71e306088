-- A flat paddle spun in still air: quadratic drag takes the spin away like 1/t, never quite.
-- About a principal axis w' = -(c/I) w|w|, so w = w0/(1 + c w0 t/I).
-- SPDX-License-Identifier: GPL-3.0-or-later

local c = param("c", 2e-5, "N m s^2")

return scene {
  name = "paddle",
  body = plate.rectangle { x = 0.15, y = 0.16, mass = 0.12 },
  effects = { effect.drag { c = c } },
  initial = { omega = { 0.2, 0.1, 30 } },
  time = { horizon = 5, step = 0.001 },
}
