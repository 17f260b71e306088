-- lagrange.lua -- a heavy symmetric top whose moments and weight are parameters: for the hunt.
-- SPDX-License-Identifier: GPL-3.0-or-later
-- luacheck: read globals param scene tensor effect
-- the arm is so short that m l^2 never spoils A: m g l is g 2^-100
local A, C = param("A", 1, "kg m^2"), param("C", 0.5, "kg m^2")
local g, l = param("g", 10, "m/s^2"), param("l", 0.1, "m")
return scene {
  name    = "lagrange",
  body    = tensor { mass = 1, com = {0, 0, l}, about = "origin", xx = A, yy = A, zz = C, xy = 0, xz = 0, yz = 0 },
  origin  = {0, 0, 0},
  effects = { effect.gravity { g = g } },
  initial = { omega = {0.1, 6, 0.2}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 10 },
}
