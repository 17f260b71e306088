-- A satellite whose boom the gravity gradient holds near the vertical of an eccentric orbit.
-- The uneven motion on the orbit makes it librate.
-- Pitch about z swings with the period 2 pi/(n sqrt(3 (Iy - Ix)/Iz)); rates are in body axes, the orbit in x-y.
-- SPDX-License-Identifier: GPL-3.0-or-later

local a = param("a", 7000, "km")
local boom = param("boom", 6, "m")

return scene {
  name = "gravity_gradient",
  body = solid.box { x = 0.4, y = 0.3, z = 0.3, mass = 50 } +
    solid.sphere { r = 0.05, mass = 2 }:at { boom, 0, 0 } + solid.sphere { r = 0.05, mass = 2 }:at { -boom, 0, 0 },
  origin = "centroid",
  effects = { effect.gravity_gradient { mu = quantity(3.986004418e14, "m^3/s^2"), orbit = { a = a, e = 0.02 } } },
  initial = { omega = { 1e-5, 0, 1.1e-3 } },
  time = { horizon = 6000, step = 1 },
}
