-- A boiled egg that was spun lying on a table: friction raises it until it stands on its end.
-- Moffatt, Shimomura, Branicki, Proc. R. Soc. A 460 (2004) 3643, study it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local a, c = param("a", 0.021, "m"), param("c", 0.029, "m")

return scene {
  name = "egg",
  body = solid.ellipsoid { a = a, b = a, c = c, mass = quantity(60, "g") },
  effects = { effect.plane { surface = contact.ellipsoid { a = a, b = a, c = c }, law = "sliding",
    friction = { coulomb = 0.3, smoothing = 0.02 } } },
  initial = { omega = { 0, 60, 0 }, attitude = { axis = "x", angle = quantity(85, "deg") } },
  time = { horizon = 4, step = 0.0005 },
}
