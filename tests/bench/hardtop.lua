-- hardtop.lua -- a symmetric top of weight times lever 1 for make hard-peers.
-- SPDX-License-Identifier: GPL-3.0-or-later
-- luacheck: read globals param scene tensor effect
local A, C = param("A", 1, "kg m^2"), param("C", 0.5, "kg m^2")
return scene {
  name    = "hardtop",
  body    = tensor { mass = 0.01, com = {0, 0, 1}, xx = A, yy = A, zz = C, xy = 0, xz = 0, yz = 0, about = "origin" },
  origin  = {0, 0, 0},
  effects = { effect.gravity { g = 100, direction = {0, 0, -1} } },
  initial = { omega = {0, 0, 5}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 10 },
}
