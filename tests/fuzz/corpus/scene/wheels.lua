-- A satellite with two driven reaction wheels across each other and a free one on a slanted axis.
-- The locked wheels are in the tensor (included = true), so only their own moments J are taken out of what the rates
-- carry.  The motors' torques are inner ones: the angular momentum in inertial axes stays, whatever they do.
-- SPDX-License-Identifier: GPL-3.0-or-later

local J = param("J", 0.16, "kg m^2")
local u = param("u", 0.2, "N m")

return scene {
  name = "wheels",
  body = tensor { mass = 750, com = { 0, 0, 0 }, xx = 900, yy = 800, zz = 600 },
  effects = {
    effect.wheel { axis = { 1, 0, 0 }, inertia = J, speed = quantity(500, "rpm"), torque = u, included = true },
    effect.wheel { axis = { 0, 1, 0 }, inertia = J, speed = quantity(200, "rpm"), included = true,
      torque = { { 0, 0 }, { 2, u }, { 8, u }, { 10, 0 } } },
    effect.wheel { axis = { 1, 0, 1 }, inertia = J, speed = quantity(-150, "rpm"), included = true },
  },
  initial = { omega = { 0.08, 0.01, 0 } },
  time = { horizon = 20, step = 0.01 },
}
