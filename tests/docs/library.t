#!/usr/bin/env lua5.4
-- library.t - docs/library.md: its programs compile without a warning as C99 and print what the page shows, and the
-- numbers are those of the formulas that the page has beside them.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local shown = require "tests.shown"

local dir, page = program.directory(), program.read "docs/library.md"
shown.prepare(dir)
tap.is(shown.save("docs/library.md", dir), 13, "ten programs, a header, a Makefile and a mesh")
shown.run("docs/library.md", dir, 21)

-- By hand, to the digits that the page shows: each line of the page below one command has the number.
local function says(command, text, ...)
  local output = page:match("\n    %$ " .. command:gsub("[.]", "%%.") .. "\n(.-)\n\n") or ""
  local wanted = string.format(text, ...)
  tap.ok(output:find(wanted, 1, true) ~= nil, command .. " shows what the formula gives: " .. wanted, output)
end
-- K(k) by the arithmetic-geometric mean, mc = 1 - k^2.
local function complete(mc)
  local a, b = 1, math.sqrt(mc)
  for _ = 1, 40 do a, b = (a + b) / 2, math.sqrt(a * b) end
  return math.pi / (2 * a)
end

local steiner = 0.2 * 0.8 / (0.2 + 0.8) * 0.16 ^ 2
says("./hammer", "centre at z = %.3f", 0.8 * 0.16)
local handle = 0.2 * (3 * 0.01 ^ 2 + 0.3 ^ 2) / 12
says("./hammer", "Ixx = %.6f, Iyy = %.6f, Izz = %.6f", handle + 0.8 * 2 * 0.03 ^ 2 / 12 + steiner,
  handle + 0.8 * (0.1 ^ 2 + 0.03 ^ 2) / 12 + steiner, 0.2 * 0.01 ^ 2 / 2 + 0.8 * (0.1 ^ 2 + 0.03 ^ 2) / 12)
local unit = 12 * 1 ^ 2 -- M a^2 of the cube
says("./corner", "corner: %.3f %.3f %.3f %.3f", 2 / 3 * unit, 2 / 3 * unit, 2 / 3 * unit, -unit / 4)
says("./corner", "moments: %.3f %.3f %.3f", unit / 6, 11 / 12 * unit, 11 / 12 * unit)
says("./corner", "smallest: %.4f", 1 / math.sqrt(3))
says("./corner", "centre: %.3f %.3f %.3f 0.000", unit / 6, unit / 6, unit / 6)
says("./attitude", "vector: %.4f", 2 * math.pi / 3 / math.sqrt(3))
says("./carousel", "Coriolis     0.00  %.2f", 2 * 0.5 * 1)
says("./carousel", "Euler        0.00  %.2f", 0.1 * 2)
says("./carousel", "centripetal %.2f", -0.5 ^ 2 * 2)
says("./carousel", "total       %.2f  %.2f", -0.5 ^ 2 * 2, 2 * 0.5 * 1 + 0.1 * 2)

local I1, I2, I3, w1, w2 = 0.005, 0.010, 0.013, 0.01, 10
local T2, L2 = I1 * w1 ^ 2 + I2 * w2 ^ 2, (I1 * w1) ^ 2 + (I2 * w2) ^ 2
local mc = (I3 - I1) * (T2 * I2 - L2) / ((I2 - I1) * (T2 * I3 - L2)) -- loses 6 digits, and keeps 9
says("./free", "flip at %.6f", complete(mc) / math.sqrt((I2 - I1) * (T2 * I3 - L2) / (I1 * I2 * I3)))
says("./free", "86400 s: T = %.9f J, Lx = %.7f, Ly = %.7f", T2 / 2, I1 * w1, I2 * w2)

local function rate(i, j, k) return 10 * math.sqrt(math.abs((k - i) * (k - j) / (i * j))) end
says("./spin", "axis 1: stable, rate %.4f", rate(I2, I3, I1))
says("./spin", "axis 2: unstable, rate %.4f", rate(I1, I3, I2))
says("./spin", "axis 3: stable, rate %.4f", rate(I1, I2, I3))
for _, t in ipairs { 0.5, 1, 2 } do
  local s = rate(I1, I3, I2) * t
  says("./spin", "t = %.1f s: wx = %8.4f linearised", t, 0.01 * (math.exp(s) + math.exp(-s)) / 2)
end
says("./pendulum", "formula: %.6f", 4 * complete(0.5) * math.sqrt(2 / (3 * 9.81)))
says("./pendulum", "1 quarters: |wx| = %.5f", math.sqrt(3 * 9.81))
says("./wheel", "body %.3f rad/s, wheel %.3f", -0.02 * 5 / 0.05, 0.02 * 5 / 0.001 + 0.02 * 5 / 0.05)
says("./drag", "Taylor, 1e-12        wz = %.12f", 20 / 21)
says("./mesh corner.obj", "mass %.3f kg\n    centre: %.3f %.3f %.3f m\n    Ixx about the centre: %.7f",
  1000 * 0.3 * 0.2 * 0.1 / 6, 0.3 / 4, 0.2 / 4, 0.1 / 4, 3 * 1 * (0.2 ^ 2 + 0.1 ^ 2) / 80)

program.finish()
tap.done()
