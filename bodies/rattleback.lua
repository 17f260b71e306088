-- The rattleback of Kane and Levinson: spun the wrong way it begins to rock, stops, and turns back.
-- Numbers: Kane, Levinson, Int. J. Non-Linear Mechanics 17 (1982) 175; here z points up.
-- SPDX-License-Identifier: GPL-3.0-or-later

local height = param("height", 0.01, "m") -- of the centre of mass below the ellipsoid's centre

return scene {
  name = "rattleback",
  body = tensor { mass = 1, xx = 0.0002, yy = 0.0016, zz = 0.0017, xy = -0.00002 },
  effects = { effect.plane { surface = contact.ellipsoid { a = 0.2, b = 0.03, c = 0.02, at = { 0, 0, height } },
    gravity = 9.81 } },
  initial = { omega = { 0, 0, -5 }, attitude = { axis = "x", angle = 0.01 } },
  time = { horizon = 10, step = 0.0005 },
}
