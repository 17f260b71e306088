#!/usr/bin/env lua5.4
-- orders.t - what the planner runs: every stepper of its plugin, each order of the series too, with the scene's inputs.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle: the general library's motion under the same inputs.  In 64 steps of 1/128 s a method of order p errs by a
-- small multiple of (h |w|)^p, |w| being at most 1.3/s; roundings: an ulp or two of 1 a step.  A stepper that leaves
-- its inputs out errs by the torque over the moment times 0.5 s, 0.3/s.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local lua = require "tests.cli.whole"

program.write(program.directory() .. "/pushed.lua", [[
return scene { name = "pushed", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 1 },
  initial = { omega = { 1.0, 0.5, -0.7 } }, effects = { effect.control {} } }
]])

local text = lua [[
  local planner = require "generator.commands.planner"
  local job = read "pushed"
  local q = { job = job, accuracy = 1e-6, real = "double", target = "x86-64" }
  assert(planner.prepare(host, q))
  local u, x0, n = { 0.003, -0.002, 0.004 }, { 1.0, 0.0, 0.0, 0.0, 1.0, 0.5, -0.7 }, 64
  local want = host.run(numeric.scene(job), { times = { 0.5 }, u = u })[1]
  local function off(x)
    local most = 0.0
    for i = 1, 7 do most = math.max(most, math.abs(x[i] - want[1 + i])) end
    return string.format("%.3g", most)
  end
  for _, s in ipairs(q.plugin:info().steppers) do
    local rows = q.plugin:integrate(x0, u, 0.5 / n, { 0.5 }, 0, s.name)
    say(s.order, off { table.unpack(rows[1], 2) }, off(q.plugin:march(0, x0, u, 0.5 / n, n, s.name)), s.name)
  end
]]

local rounding <const>, step <const> = 64 * 2 * 2.0 ^ -52, 1.3 / 128
local orders, others = 0, 0
for order, by_steps, at_once, name in (text or ""):gmatch "(%d+) (%S+) (%S+) ([^\n]+)\n" do
  if name:find "^taylor %d+$" then orders = orders + 1 else others = others + 1 end
  local bound = step ^ tonumber(order) + rounding
  tap.ok(tonumber(by_steps) <= bound, name .. ", step by step with inputs, moves as the library does", by_steps)
  tap.ok(tonumber(at_once) <= bound, name .. ", all steps at once, too", at_once)
end
tap.ok(orders == 14 and others >= 5, "they are the series' 14 orders and the other methods", orders .. " " .. others)

program.finish()
tap.done()
