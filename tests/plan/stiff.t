#!/usr/bin/env lua5.4
-- stiff.t - what the planner says of motions in which something decays fast: a plan in bounded time, or why not.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle of the rate: a ball's slip decays at c g (1 + m R^2/J) = 7/2 c g (docs/plane.md, closed form of
-- tests/methods/rosenbrock.t).  Differences in double and 20 steps of a power iteration: 1 % is far above both.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local lua = require "tests.plan.tree"

local dir = program.directory()
local function written(name, effects, initial, horizon)
  local path = dir .. "/" .. name .. ".lua"
  program.write(path, string.format("return scene { name = 'ball', body = solid.sphere { r = 0.03, mass = 0.17 }, " ..
    "effects = { %s }, initial = { %s }, time = { horizon = %g } }", effects, initial, horizon))
  return path
end
local function sliding(c)
  return written("slides" .. c, "effect.plane { surface = contact.sphere { r = 0.03 }, law = 'sliding', friction = " ..
    "{ viscous = " .. c .. " } }", "omega = { 10, 0, 5 }, velocity = { 1, 0.5, 0 }", 0.5)
end

-- {rate, decays, method, error, steps}, or {why}, of a plan.
local function planned(path, accuracy, methods)
  local out, err = lua([[
local driver, planner = require "generator.driver", require "generator.commands.planner"
local plan = require "generator.plan.plan"
local decision = require "generator.plan.decision"
local given = { args[1], accuracy = tonumber(args[2]), method = args[3] ~= "-" and { args[3] } or nil }
local q = planner.question(driver.read(host, args[1], given), given)
assert(planner.prepare(host, q))
local r, instead = plan.find(q)
local stiff = q.stiff or { rate = 0, decays = 0 }
say(stiff.rate, stiff.decays, r and r.candidate.method or "none", r and r.error or 1)
say(r and table.concat(decision.made(q, r).report, " ") or decision.refusal(q, instead).refused)
]], nil, path, tostring(accuracy), methods or "-")
  local rate, decays, method, e, text = out:match "^(%S+)%s+(%S+)%s+(%S+)%s+(%S+)\n(.*)$"
  return { rate = tonumber(rate), decays = tonumber(decays), method = method, error = tonumber(e), text = text or err }
end

for _, c in ipairs { 200, 20000 } do
  local p = planned(sliding(c), 1e-5)
  local want = 3.5 * c * 9.80665
  tap.ok(p.rate and math.abs(p.rate / want - 1) < 0.01, "c = " .. c .. " s/m: the rate of the slip", p.rate)
  tap.is(p.method, "rosenbrock", "and the implicit method", p.text)
  tap.ok(p.error and p.error <= 1e-5, "that holds the accuracy", p.error)
  tap.like(p.text or "", "Stiff: something decays at", "and the header says so")
end
do
  local p = planned(sliding(20000), 1e-5, "rk4")
  local step = tonumber(string.match(p.text or "", "steps of (%S+) s") or 1)
  -- rk4 is stable for h rate <= 2.785
  tap.ok(step <= 2.79 / p.rate, "rk4 alone is planned with a step that is stable", p.text)
  p = planned(sliding("2e7"), 1e-5, "rk4")
  tap.is(p.method, "none", "of more than 10^8 steps it is refused, not run for minutes")
  tap.like(p.text or "", "stiff.-law = \"rolling\"", "with the reason and what helps", true)
end
-- A spring oscillates as fast as it likes: 2000 radians are no decay.
do
  local p = planned(written("swings", "effect.damping { rate = 0.01 }, effect.torque { inertial = { 1e-9, 0, 0 } }",
    "omega = { 0.5, 0, 300 }", 8), 1e-3)
  tap.is(p.rate, 0, "a fast spin is not stiff", p.text)
end

tap.done(program.finish())
