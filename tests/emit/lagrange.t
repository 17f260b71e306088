#!/usr/bin/env lua5.4
-- lagrange.t - the emitted closed form of the heavy symmetric top: the reference table, hard motions against a Taylor
-- series of many digits, random states against the integrals and the equations of motion.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One scene, its moments, weight and arm parameters; lagrange.c measures, motion.lua runs it.  Expected states:
-- tests/reference/forced_top.h (32 digits; tests/reference/README.md) and tests/oracle/heavy_top.c.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local motion = require "tests.emit.motion"

-- 18 units of 2^-52, as for the free top: phases reduced in pairs and rounded once, three sines and cosines, series of
-- four terms, some dozen operations on numbers below 2; the set-up's 2^-100 is not seen.  |q| = 1 after a Newton step.
local BAR, NORM = 4e-15, 4e-16
-- At random states rates are over the largest of |w| at t = 0 and sqrt(m g l/A), twice which the motion may reach: its
-- square counts four times in the energy.  L along the vertical is a product of rates and attitude.
local ENERGY, MOMENTUM = 4 * BAR, 2 * BAR
-- A central difference over 2 h, h = 2^-16 of that unit of time: h^2/6 = 4e-11 of third derivatives, which are cubes
-- of rates of up to 4 units, and 2^16 roundings.
local DERIVATIVE = 4.0 ^ 3 * 2.0 ^ -32 / 6 + 2.0 ^ 16 * BAR
-- float: the same count of units of 2^-23
local FLOAT_BAR = 4e-6

local text = [[
local A, C = param("A", 1, "kg m^2"), param("C", 0.5, "kg m^2")
local g, l = param("g", 10, "m/s^2"), param("l", 0.1, "m")
return scene {
  name = "%s",
  body = tensor { mass = 1, com = {0, 0, l}, about = "origin", xx = A, yy = A, zz = C, xy = 0, xz = 0, yz = 0 },
  origin = {0, 0, 0}, effects = { effect.gravity { g = g } },
}
]]

local test = { source = "lagrange.c", bar = BAR, norm = NORM, rows = 20, derivative = DERIVATIVE,
  energy = { ENERGY, "T + V is constant" }, momentum = { MOMENTUM, "L along the vertical is constant" },
  -- C = 2 A (1 - u) may break the triangle inequality by the rounding of what the parameters stand for
  refused = 1e-3, float_refused = 0, float_bar = FLOAT_BAR }

motion.run(test, text, "lagrange", 100000, function()
  -- in 192 bits: a separatrix followed for 60 time constants loses 90 of them
  motion.cases(test, "cases", "-b 192", 150)
  motion.cases(test, "long", "-b 192 -p", 25) -- 1.2 million nutations
end)
