-- A pirouette: the arms come in and go out again, and the turn about z goes faster and slower.
-- What the arms add to the tensor is given over time; L in inertial axes stays, the energy is the arms' work.
-- SPDX-License-Identifier: GPL-3.0-or-later

local arms = param("arms", 0.5, "kg m^2")
local rate = param("rate", 1, "rad/s")

return scene {
  name = "skater",
  body = tensor { mass = 60, com = { 0, 0, 0 }, xx = 11, yy = 11, zz = 1.2 },
  effects = { effect.inertia_rate { zz = arms * (1 + cos(rate * t)), xx = arms * (1 + cos(rate * t)) / 2,
    yy = arms * (1 + cos(rate * t)) / 2 } },
  initial = { omega = { 0.05, 0, 3 } },
  time = { horizon = 10, step = 0.005 },
}
