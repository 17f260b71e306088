-- A square sail behind its centre of mass: like a weathercock it swings about the sun's direction.
-- The bright side mirrors, the back is black.  The sun stands in inertial x, the bright side looks along body x.
-- SPDX-License-Identifier: GPL-3.0-or-later

local side = param("side", 20, "m")
local lever = param("lever", 1.5, "m")

return scene {
  name = "solar_sail",
  body = tensor { mass = 40, com = { 0, 0, 0 }, xx = 1600, yy = 900, zz = 850 },
  origin = "centroid",
  effects = { effect.solar_pressure { sun = { 1, 0, 0 }, plates = {
    { area = side^2, normal = { 1, 0, 0 }, centre = { -lever, 0, 0 }, reflectivity = 0.85 },
    { area = side^2, normal = { -1, 0, 0 }, centre = { -lever, 0, 0 } } } } },
  initial = { attitude = { 0.97, 0, 0.2, 0.1 } },
  time = { horizon = 2000, step = 0.5 },
}
