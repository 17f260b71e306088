#!/usr/bin/env lua5.4
-- tour.t - the tour of docs/design.md shows what the stages really hand on: each block is made anew and compared.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local tour = require "docs.tools.tour"

local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end

local page = program.read "docs/design.md"
local made = tour.blocks(binary, tour.block(page, "scene"))

-- The stages that a reader is promised, in the order of the page: none is left out and none stands twice.
local stages = { "scene", "record", "model", "equations", "closed", "description", "forms", "lower", "order",
  "statements", "files" }
local seen = {}
for name in page:gmatch "<!%-%- tour: (%w+) %-%->" do seen[#seen + 1] = name end
tap.is(table.concat(seen, " "), table.concat(stages, " "), "the tour visits every stage, in order")
for i = 2, #stages do
  tap.is(tour.block(page, stages[i]), made[stages[i]], stages[i] .. ": as the program has it (else: make docs)")
end
tap.is(tour.fill(page, made), page, "filling the page anew changes nothing")

tap.done()
