-- A tippe top: spun fast on its round bottom it turns over and stands on its stem's side, lifted by friction.
-- Numbers: Leine, Glocker, Eur. J. Mech. A/Solids 22 (2003) 193; here without the stem.
-- SPDX-License-Identifier: GPL-3.0-or-later

local r = param("r", 0.015, "m")
local low = param("low", 0.003, "m") -- the centre of mass is so far below the sphere's centre
local c = param("c", 1, "s/m")

return scene {
  name = "tippe_top",
  body = tensor { mass = 0.006, xx = 8e-7, yy = 8e-7, zz = 7e-7 },
  effects = { effect.plane { surface = contact.sphere { r = r, at = { 0, 0, low } }, law = "sliding",
    friction = { viscous = c } } },
  initial = { omega = { 0, 0, 180 }, attitude = { axis = "x", angle = 0.1 } },
  time = { horizon = 3, step = 0.0005 },
}
