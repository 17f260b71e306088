#!/usr/bin/env lua5.4
-- lecture.t - docs/lecture.md: what each step and each answer shows is what the program prints, and its pictures are
-- those of the page; the numbers in its sentences follow from the formulas beside them.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local shown = require "tests.shown"

local dir, page = program.directory(), program.read "docs/lecture.md"
shown.prepare(dir)
shown.run("docs/lecture.md", dir, 20)
for _, name in ipairs { "cones", "polhode" } do
  tap.ok(program.read(dir .. "/" .. name .. ".svg") == program.read("docs/lecture/" .. name .. ".svg"),
    name .. ".svg is what the command draws")
end

local steps, exercises = select(2, page:gsub("\n## %d+%. ", "")), select(2, page:gsub("\n%*%*Exercise%.%*%*", ""))
tap.is(steps, 10, "ten steps")
tap.is(exercises, steps, "each with an exercise")
tap.is(select(2, page:gsub("\n%*%*Answer%.%*%*", "")), exercises, "and its answer")

-- Textbook formulas by hand, to the digits that the page's sentences have.
local W = 7.292115e-5 * math.sqrt(0.5)
local function says(text, value, what)
  tap.ok(page:find(text, 1, true) ~= nil, what, text .. " for " .. value)
end
says(string.format("= %.2f mm", 1e3 * W * 9.81 * 4 ^ 3 / 3), W, "the eastward deviation")
says(string.format("%.0f mm to the *west*", 1e3 * 4 / 3 * W * 39.24 ^ 3 / 9.81 ^ 2), W, "the throw's deviation")
says(string.format("= %.4f J", 0.5 * (0.005 * 9 + 0.01 * 16)), 0, "the energy of the disc")
local growth = math.sqrt((0.15 ^ 2 + 0.3 ^ 2 - 0.3 ^ 2 - 0.02 ^ 2) * (0.3 ^ 2 - 0.15 ^ 2) /
  ((0.15 ^ 2 + 0.02 ^ 2) * (0.3 ^ 2 + 0.15 ^ 2))) -- sqrt((I3 - I2)(I2 - I1)/(I1 I3)), times 12/M each
says(string.format("%.3f * 10/s", growth), growth, "the growth rate")
says(string.format("= %.3f s", math.log(10) / (10 * growth)), growth, "and the delay")

program.finish()
tap.done()
