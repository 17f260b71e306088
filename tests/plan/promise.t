#!/usr/bin/env lua5.4
-- promise.t - accuracy asked for is accuracy got, at a cost near the least.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A small part of what tests/bench/plan.lua measures for docs/planner.md: states that the planner did not see, judged
-- by the general library, and a sweep of all methods and settings for the least cost (tests/plan/promise.lua).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local lua = require "tests.plan.tree"

local text = program.read "tests/plan/promise.lua"
for _, c in ipairs { { "bodies/tennis_racket.lua", "double", "taylor,rk4,adaptive,split4", "1e-3", "1e-8" },
  { "bodies/damped_brick.lua", "double", "-", "1e-6" }, { "bodies/gravity_gradient.lua", "float", "-", "1e-3" } } do
  local out, err = lua(text, nil, c[1], c[2], c[3], "20", table.unpack(c, 4))
  tap.is(err, "", c[1] .. ": runs")
  local lines = 0
  for line in out:gmatch "[^\n]+" do
    lines = lines + 1
    local asked, got, _, ratio, tried, name = line:match "^(%S+) (%S+) (%S+) (%S+) (%S+) (.*)$"
    local what = string.format("%s, %s, %s: ", c[1], c[2], asked or line)
    tap.ok(asked and tonumber(got) <= tonumber(asked), what .. "met at 20 states that were not seen", line)
    tap.ok(asked and tonumber(ratio) <= 1.3 and tonumber(tried) > 1, what .. (name or "") ..
      " costs at most 1.3 times the least of a sweep", line)
  end
  tap.is(lines, #c - 3, "all accuracies have a plan")
end

program.finish()
tap.done()
