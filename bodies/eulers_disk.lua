-- Euler's disk: a heavy disc that was spun on its edge and settles, rolling without loss, nearly flat.
-- The flatter it lies, the faster its contact point runs round: as one over the root of the angle.
-- SPDX-License-Identifier: GPL-3.0-or-later

local r = param("r", 0.0375, "m")
local edge = param("edge", 0.003, "m") -- radius of its rounded edge
local tilt = param("tilt", 0.15, "rad")

return scene {
  name = "eulers_disk",
  body = solid.cylinder { r = r, h = 2 * edge, mass = quantity(440, "g") },
  effects = { effect.plane { surface = contact.disc { r = r - edge, edge = edge } } },
  -- the spin about the vertical of a steady roll without spin about the axis: Omega^2 = 4 g/(r tilt) of a thin disc
  initial = { omega = { 0, 12.6, 0 }, attitude = { axis = "x", angle = tilt } },
  time = { horizon = 2, step = 0.0005 },
}
