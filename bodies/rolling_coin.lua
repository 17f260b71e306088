-- A coin that rolls on a table in a circle and leans inwards, and wobbles as it goes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local r = param("r", 0.0122, "m")
local thick = param("thick", 0.0019, "m")

return scene {
  name = "rolling_coin",
  body = solid.cylinder { r = r, h = thick, mass = quantity(6, "g") },
  effects = { effect.plane { surface = contact.disc { r = r - thick / 2, edge = thick / 2 } } },
  initial = { omega = { 0.5, 0, 30 }, attitude = { axis = "x", angle = quantity(75, "deg") } },
  time = { horizon = 2, step = 0.0005 },
}
