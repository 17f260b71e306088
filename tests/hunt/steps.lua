-- steps.lua -- a free body of three principal moments, with steppers: for the hunt.
-- SPDX-License-Identifier: GPL-3.0-or-later
-- luacheck: read globals param scene tensor
local A, B, C = param("A", 1, "kg m^2"), param("B", 2, "kg m^2"), param("C", 2.5, "kg m^2")
return scene {
  name    = "steps",
  body    = tensor { mass = 1, com = {0, 0, 0}, xx = A, yy = B, zz = C, xy = 0, xz = 0, yz = 0 },
  effects = {},
  initial = { omega = {0.1, 6, 0.2}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 10 },
}
