#!/usr/bin/env lua5.4
-- passed.t - the planner answers whatever accuracy is asked, and passes over nothing that it measured to be cheaper.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle: the search's own log of operations and errors; no time is measured.  Of what was run from all states of the
-- ranges and held the accuracy with its margin, nothing costs less than 1/1.3 of the plan.  A tighter accuracy's plan
-- holds a looser one, too, so costs rise with the digits: within 1.3, for the search stops within 1.1 of the best at
-- few states and 1.02 of the least number of steps.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local lua = require "tests.plan.tree"

local dir = program.directory()

-- The plans of a scene for all accuracies: lines "accuracy name cost cheapest", name "none" where there is none.
local function plans(path, methods, accuracies)
  local out, err = lua([[
local driver, planner = require "generator.driver", require "generator.commands.planner"
local plan = require "generator.plan.plan"
local decision = require "generator.plan.decision"
local methods
for m in string.gmatch(args[2], "%w+") do
  methods = methods or {}
  methods[#methods + 1] = m
end
for a in string.gmatch(args[3], "%S+") do
  local given = { args[1], accuracy = tonumber(a), method = methods }
  local q = planner.question(driver.read(host, args[1], given), given)
  assert(planner.prepare(host, q))
  local r, instead = plan.find(q)
  local least, fails = math.huge, {}
  local function key(m) return m.candidate.name .. tostring(m.setting) end
  for _, m in ipairs(r and r.log or {}) do fails[key(m)] = fails[key(m)] or m.error > r.limit end
  for _, m in ipairs(r and r.log or {}) do
    if m.all and not fails[key(m)] then least = math.min(least, m.cost) end
  end
  if r then decision.made(q, r) else decision.refusal(q, instead) end
  say(a, r and string.gsub(r.candidate.name, " ", "_") or "none", r and r.cost or 0, r and least or 0)
end
]], nil, path, methods or "", table.concat(accuracies, " "))
  return out, err
end

local steppers = "rk4 adaptive taylor midpoint semi split2 split4 split6"
local scenes = { -- file or text, methods, accuracies
  { "bodies/gravity_gradient.lua" }, { "bodies/nodding_top.lua", steppers }, { "bodies/damped_brick.lua", steppers },
  { "bodies/compass.lua" }, { "bodies/kapitza.lua" }, { "bodies/tennis_racket.lua", steppers },
  { "dry", "return scene { name = 'dry', body = solid.box { x = .1, y = .2, z = .3, mass = 1 }:at { 0, 0, -.15 }, " ..
    "origin = { 0, 0, 0 }, effects = { effect.gravity {}, effect.friction { torque = .05, smoothing = 1e-4 } }, " ..
    "initial = { attitude = { axis = { 1, .3, 0 }, angle = .7 }, omega = { 0, 1, 2 } }, time = { horizon = 2, " ..
    "step = 1e-3 } }" },
  { "slide", "return scene { name = 'slide', body = solid.sphere { r = 0.03, mass = 0.17 }, effects = { " ..
    "effect.plane { surface = contact.sphere { r = 0.03 }, law = 'sliding', friction = { viscous = 100 } } }, " ..
    "initial = { omega = { 10, 0, 5 }, velocity = { 1, 0.5, 0 } }, time = { horizon = 0.5 } }" },
}
local accuracies = { "1e-3", "1e-7", "1e-10", "1e-13" }

for _, s in ipairs(tier.every(8, scenes, 2)) do
  local path, methods = s[1], s[2]
  if not string.find(path, "/", 1, true) then
    path, methods = dir .. "/" .. s[1] .. ".lua", nil
    program.write(path, s[2])
  end
  local out, err = plans(path, methods, accuracies)
  local before, answered, refused = 0.0, 0, false
  for a, name, cost, least in string.gmatch(out or "", "(%S+)%s+(%S+)%s+(%S+)%s+(%S+)\n") do
    cost, least, answered = tonumber(cost), tonumber(least), answered + 1
    if name ~= "none" then
      tap.ok(least * 1.3 > cost, string.format("%s %s: %s, and nothing measured is much cheaper", s[1], a, name), cost,
        least)
      tap.ok(cost * 1.3 > before and not refused, s[1] .. " " .. a .. ": no cheaper than fewer digits", cost, before)
      before = math.max(before, cost)
    end
    refused = refused or name == "none"
  end
  tap.is(answered, #accuracies, s[1] .. ": a plan, or why there is none, for every accuracy", err)
end

program.finish()
tap.done()
