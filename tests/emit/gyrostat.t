#!/usr/bin/env lua5.4
-- gyrostat.t - the emitted closed form of the asymmetric gyrostat: the reference table, hard and random motions against
-- a Taylor series of many digits, random states against the integrals and the equations of motion.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One scene, its moments and the rotor's momentum parameters; gyrostat.c measures, motion.lua runs it.  Expected:
-- tests/reference/forced_top.h (32 digits) and tests/oracle/heavy_top.c with a rotor.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local motion = require "tests.emit.motion"

-- 18 units of 2^-52, as for the free and the heavy top: phases reduced in pairs and rounded once, three sines and
-- cosines, series of five terms, some dozen operations on numbers below 2; the set-up's 2^-100 is not seen.
local BAR, NORM = 4e-15, 4e-16
-- Rates are over the pace, the largest of |w| and |M|/I with the smallest I.  2T is a sum of three squares, over the
-- largest moment: twice three errors of rates.  M has those of rates and attitude.
local ENERGY, MOMENTUM = 6 * BAR, 3 * BAR
-- A central difference over 2 h, h = 2^-16 of the pace: h^2/6 = 4e-11 of third derivatives, which are cubes of rates of
-- up to 2 paces, and 2^16 roundings.
local DERIVATIVE = 2.0 ^ 3 * 2.0 ^ -32 / 6 + 2.0 ^ 16 * BAR
-- float: the same count of units of 2^-23
local FLOAT_BAR = 4e-6

local text = [[
local A, B, C = param("A", 1, "kg m^2"), param("B", 2, "kg m^2"), param("C", 2.5, "kg m^2")
local H = param("H", 20, "kg m^2/s")
return scene {
  name = "%s", body = tensor { mass = 1, xx = A, yy = B, zz = C },
  effects = { effect.rotor { axis = {0, 0, 1}, momentum = H } },
}
]]

local test = { source = "gyrostat.c", bar = BAR, norm = NORM, rows = 5, derivative = DERIVATIVE,
  energy = { ENERGY, "w.I w is constant" }, momentum = { MOMENTUM, "I w + h is constant in inertial axes" },
  -- two moments that were made equal may break the triangle inequality: 3 of 17 kinds, 7 of 100 of these; of the six
  -- kinds that float sees two, with a margin for float's own rounding of the moments
  refused = 0.02, float_refused = 0.04, float_bar = FLOAT_BAR }

motion.run(test, text, "asymmetric gyrostat", 50000, function()
  -- of every kind, in 160 bits: near separatrices 60 paces lose up to 50 of 128
  local sides = {}
  for _, name in ipairs(motion.cases(test, "cases 510", "-b 160 -r", 485)) do
    sides[string.match(name, ", (%d),")] = true
  end
  tap.ok(sides["0"] and sides["1"] and sides["2"],
    "far from separatrices and near, on the side of two bands and of one")
end)
