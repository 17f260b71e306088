-- A satellite with a permanent magnet in a field that turns about z, as along a polar orbit.
-- The moment m turns towards the field; drag on the turning keeps it from swinging for ever.
-- SPDX-License-Identifier: GPL-3.0-or-later

local m = param("m", 0.6, "A m^2")

return scene {
  name = "compass",
  body = solid.box { x = 0.1, y = 0.1, z = 0.3, mass = 4 },
  effects = {
    effect.magnetic { moment = { 0, 0, m }, rotating = { 3e-5, 0, 1e-5 }, rate = 0.0022 },
    effect.damping { c = 1e-5 },
  },
  initial = { omega = { 0.01, -0.02, 0.03 }, attitude = { axis = { 1, 1, 0 }, angle = 0.8 } },
  time = { horizon = 3000, step = 0.5 },
}
