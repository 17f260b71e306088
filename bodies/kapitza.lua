-- A pendulum that stands upside down because its support is shaken up and down (Kapitza 1951).
-- It stands while amplitude^2 rate^2 > 2 g l, with l = I/(m r) = 2/3 of the rod: here 16.0 against 3.9 m^2/s^2.
-- SPDX-License-Identifier: GPL-3.0-or-later

local amplitude = param("amplitude", 0.02, "m")
local rate = param("rate", 200, "rad/s")

return scene {
  name = "kapitza",
  body = solid.box { x = 0.01, y = 0.02, z = 0.3, mass = 0.1 },
  origin = { 0, 0, -0.15 },
  effects = { effect.gravity {}, effect.pivot { amplitude = amplitude, rate = rate } },
  initial = { attitude = { axis = { 0, 1, 0 }, angle = 0.2 } },
  time = { horizon = 3, step = 0.0005 },
}
