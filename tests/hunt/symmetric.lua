-- symmetric.lua -- a free symmetric body whose two moments are parameters: for the hunt.
-- SPDX-License-Identifier: GPL-3.0-or-later
-- luacheck: read globals param scene tensor
local A, C = param("A", 2, "kg m^2"), param("C", 1, "kg m^2")
return scene {
  name    = "symmetric",
  body    = tensor { mass = 1, xx = A, yy = A, zz = C },
  effects = {},
  initial = { omega = {0.1, 6, 0.2}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 10 },
}
