-- Chaplygin's ball: its centre of mass is in the middle, its moments differ.  It rolls along a winding path.
-- SPDX-License-Identifier: GPL-3.0-or-later

return scene {
  name = "chaplygin_ball",
  body = tensor { mass = 1.5, xx = 0.0012, yy = 0.0018, zz = 0.0024 },
  effects = { effect.plane { surface = contact.sphere { r = 0.06 } } },
  initial = { omega = { 4, -3, 9 } },
  time = { horizon = 5, step = 0.001 },
}
