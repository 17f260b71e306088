#!/usr/bin/env lua5.4
-- estimator.t - what the estimator of the tensor of inertia costs on a Cortex-M4F is what docs/fit.md says, and code in
-- several files is counted.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The page has the instructions that gcc 12 makes; another release of it may differ by a tenth.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local code = program.shell(string.format("%s gen bodies/tennis_racket.lua --with estimator --real float " ..
  "--target cortex-m4f -o %s/out >%s/said 2>&1", binary, dir, dir))
tap.is(code, 0, "a scene in several files is counted")
if code ~= 0 then tap.diag(program.read(dir .. "/said")) end

local sheet, counted = program.read(dir .. "/out/README.md") or "", {}
for name, count, stack in sheet:gmatch "| (estimator_%w+) | (%d+) | %d+ | (%d+) |" do
  counted[name] = { tonumber(count), tonumber(stack) }
end
local page = {}
for calls, numbers in program.read "docs/fit.md":gmatch "| (`NAME_estimator_[^|]*) |[^|]*| ([%d, ]+) |" do
  local list = {}
  for n in numbers:gmatch "%d+" do list[#list + 1] = tonumber(n) end
  for name in calls:gmatch "`[NAME]*_?([%w_]+)`" do
    page[name:find "^estimator" and name or "estimator_" .. name] = table.remove(list, 1)
  end
end
for _, name in ipairs { "open", "add", "solve", "inertia", "covariance", "ratios" } do
  local key = "estimator_" .. name
  local got, want = counted[key] or { 0, 0 }, page[key] or 1
  tap.ok(math.abs(got[1] / want - 1) <= 0.1, key .. ": as many instructions as the page says",
    got[1] .. " for " .. want)
  tap.ok(got[2] > 0 and got[2] <= 440, key .. ": and its stack", got[2])
end

program.finish()
tap.done()
