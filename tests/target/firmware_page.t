#!/usr/bin/env lua5.4
-- firmware_page.t - docs/firmware.md: its files compile and its commands print what it shows, the filter is better than
-- its sensors and knows by how much, and the counted instructions are those of the page.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The truth that the filter is judged by is the general library's.  The page has the instructions that gcc 12 makes;
-- another release of it may differ by a tenth.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local shown = require "tests.shown"

local dir, page = program.directory(), program.read "docs/firmware.md"
shown.prepare(dir)
tap.is(shown.save("docs/firmware.md", dir), 4, "the page has a scene and three files of C")
shown.run("docs/firmware.md", dir, 7)

local flags = "-std=c99 -O1 -g -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -ffp-contract=off " ..
  "-fsanitize=address,undefined -fno-sanitize-recover"
program.shell(string.format("cd %s && cc %s -Wno-double-promotion -Isat -c try.c >made 2>&1 && " ..
  "cc %s -Isat try.o ekf.c sat/sat.c -lm -o checked >>made 2>&1 && ./checked <truth.csv >said 2>>made",
  dir, flags, flags))
local gyro, rates, expected = (program.read(dir .. "/said") or ""):match "gyro ([%d.]+), filter ([%d.]+).-([%d.]+)\n"
local star, attitude = (program.read(dir .. "/said") or ""):match "tracker ([%d.]+), filter ([%d.]+)"
tap.ok(gyro ~= nil and star ~= nil, "the page's C has no warning and no fault", program.read(dir .. "/made"))
gyro, rates, expected = tonumber(gyro) or 0, tonumber(rates) or 1, tonumber(expected) or 0
star, attitude = tonumber(star) or 0, tonumber(attitude) or 1

-- The noise: 0.01 in each of 3 rates, 0.002 in each of 4 numbers.  Of 600 readings of the gyro the mean square has a
-- standard error of sqrt(2/1800), of 30 of the star tracker sqrt(2/120): 4 of them.
tap.ok(math.abs(gyro ^ 2 / 3e-4 - 1) < 4 * math.sqrt(2 / 1800), "the gyro's noise is that of the page", gyro)
tap.ok(math.abs(star ^ 2 / 1.6e-5 - 1) < 4 * math.sqrt(2 / 120), "the star tracker's noise, too", star)
tap.ok(rates < gyro / 10 and attitude < star / 2, "the filter is better than its sensors", rates .. " " .. attitude)
-- An error may be less than expected, as Q allows for torques that are not there; more than twice would be a wrong F.
tap.ok(rates < 2 * expected and rates > expected / 10, "and knows how good it is", rates .. " for " .. expected)

local sheet, rows = (program.read(dir .. "/sheet/README.md") or ""):match "\nCounted:(.*)" or "", 0
for name, wanted in page:gmatch "\n| ([%l_]+) | (%d+) | %d+ | %d+ |" do
  local got = sheet:match("\n| " .. name .. " | (%d+) | %d+ | %d+ |") or 0
  tap.ok(math.abs(got / wanted - 1) <= 0.1, name .. ": as many instructions as the page says", got .. " for " .. wanted)
  rows = rows + 1
end
tap.is(rows, 4, "four functions are counted")

program.finish()
tap.done()
