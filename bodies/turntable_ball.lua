-- A ball that rolls on a turntable: its centre goes round a circle at 2/7 of the table's rate.
-- SPDX-License-Identifier: GPL-3.0-or-later

local r = param("r", 0.02, "m")

return scene {
  name = "turntable_ball",
  body = solid.sphere { r = r, mass = quantity(260, "g") },
  effects = { effect.plane { surface = contact.sphere { r = r }, turntable = quantity(33, "rpm") } },
  initial = { omega = { 0, 5, 0 }, position = { 0.1, 0, 0 } },
  time = { horizon = 10, step = 0.002 },
}
