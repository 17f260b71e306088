-- harddamped.lua -- a sphere that is damped stiffly, for make hard-peers.
-- SPDX-License-Identifier: GPL-3.0-or-later
-- luacheck: read globals param scene tensor effect
local A = param("A", 1, "kg m^2")
return scene {
  name    = "harddamped",
  body    = tensor { mass = 1, com = {0, 0, 0}, xx = A, yy = A, zz = A, xy = 0, xz = 0, yz = 0 },
  effects = { effect.damping { c = 1000000 } },
  initial = { omega = {0, 0, 1000000}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 1 },
}
