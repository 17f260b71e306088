-- A coin that spins on a point below its rim, with dry friction there and gravity.
-- Well above the smoothing rate the torque has the constant size `rub`; see docs of effect.friction for what happens
-- near rest.
-- SPDX-License-Identifier: GPL-3.0-or-later

local r = param("r", 0.012, "m")
local rub = param("rub", 2e-6, "N m")

return scene {
  name = "spun_coin",
  body = solid.cylinder { r = r, h = 0.0018, mass = 0.0057 },
  origin = { r, 0, 0 },
  effects = {
    effect.gravity {},
    effect.friction { torque = rub, smoothing = 0.5 },
  },
  initial = { omega = { 60, 0, 1 }, attitude = { axis = "y", angle = 1.2 } },
  time = { horizon = 0.3, step = 0.0001 },
}
