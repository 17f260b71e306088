-- Explorer 1 in short: a spinning rod that loses energy inside ends in a flat spin.
-- Its whip antennas took the energy; the angular momentum in space stays as it was.
-- SPDX-License-Identifier: GPL-3.0-or-later

local k = param("k", 0.4, "1/N/m/s")

return scene {
  name = "energy_sink",
  body = solid.cylinder { r = 0.08, h = 2, mass = 14 },
  origin = "centroid",
  effects = { effect.dissipation { k = k } },
  initial = { omega = { 0.1, 0, 5 } },
  time = { horizon = 20, step = 0.005 },
}
