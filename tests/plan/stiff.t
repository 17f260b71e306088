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

-- {rate, decays, method, error, truth = {the last state}, text} of a plan; real: double if nil.
local function planned(path, accuracy, methods, real)
  local out, err = lua([[
local driver, planner = require "generator.driver", require "generator.commands.planner"
local plan = require "generator.plan.plan"
local decision = require "generator.plan.decision"
local given = { args[1], accuracy = tonumber(args[2]), method = args[3] ~= "-" and { args[3] } or nil, real = args[4] }
local q = planner.question(driver.read(host, args[1], given), given)
assert(planner.prepare(host, q))
local r, instead = plan.find(q)
local stiff = q.stiff or { rate = 0, decays = 0 }
say(stiff.rate, stiff.decays, r and r.candidate.method or "none", r and r.error or 1)
say(table.unpack(r and r.expected or {}))
say(r and table.concat(decision.made(q, r).report, " ") or decision.refusal(q, instead).refused)
]], nil, path, tostring(accuracy), methods or "-", real or "double")
  local rate, decays, method, e, last, text = out:match "^(%S+)%s+(%S+)%s+(%S+)%s+(%S+)\n([^\n]*)\n(.*)$"
  local truth = {}
  for x in string.gmatch(last or "", "%S+") do truth[#truth + 1] = tonumber(x) end
  return { rate = tonumber(rate), decays = tonumber(decays), method = method, error = tonumber(e), truth = truth,
    text = text or err }
end

for _, c in ipairs { 200, 20000 } do
  local p = planned(sliding(c), 1e-5)
  local want = 3.5 * c * 9.80665
  tap.ok(p.rate and math.abs(p.rate / want - 1) < 0.01, "c = " .. c .. " s/m: the rate of the slip", p.rate)
  tap.is(p.method, "rosenbrock", "and the implicit method", p.text)
  tap.ok(p.error and p.error <= 1e-5, "that holds the accuracy", p.error)
  tap.like(p.text or "", "Stiff: something decays at", "and the header says so")
end
-- In float the truth is rosenbrock's in double, and the library is asked for the beginning only: 1000 decays.
-- The end is V = V0 - k v0, k = J/(J + m R^2) = 2/7, v0 = V0 - R W x n the slip at t = 0 (docs/plane.md).
do
  local p = planned(sliding(200), 1e-4, nil, "float")
  tap.is(p.method, "rosenbrock", "float: the implicit method", p.text)
  tap.ok(p.error and p.error <= 1e-4, "float: that holds the accuracy", p.error)
  tap.like(p.text, "the library confirms it up to 0%.%d+ s", "float: the library follows the beginning only", true)
  local n = #p.truth
  local off = n > 1 and math.max(math.abs(p.truth[n - 1] - (1 - 2 / 7)), math.abs(p.truth[n] - (0.5 - 2 / 7 * 0.8)))
  -- the truth's tolerance is 1e-6 of the accuracy, of some hundred steps
  tap.ok(off and off <= 1e-6, "float: the true motion ends where the closed form says", off)
end
-- What is left of the slip.  Down a slope a, cos a = 4/5, the plane's force is that of rolling, 2/7 m g sin a = N c v,
-- so v = 2/7 tan a/c, and the speed is 5/7 g sin a t: their ratio at t = 1/2 is 4/5/(c g cos a) = 5.0986e-4 for
-- 200 s/m.
do
  local p = planned(written("slope", "effect.plane { surface = contact.sphere { r = 0.03 }, law = 'sliding', " ..
    "friction = { viscous = 200 }, normal = { 0, -3, 4 } }", "omega = { 1e-3, 0, 0 }, " ..
    "velocity = { 0, 0, 0 }", 0.5), 1e-5)
  tap.like(p.text, "the slip is 0.00051 of the speed", "the difference to rolling is told")
  p = planned(sliding(200), 1e-5)
  tap.like(p.text, "the slip is below 1e%-%d+ of the speed", "and where nothing but the error is left, so", true)
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
-- A fast spin, 2400 radians, is no decay; the damping makes 0.08 of one.
do
  local p = planned(written("swings", "effect.damping { rate = 0.01 }, effect.torque { inertial = { 1e-9, 0, 0 } }",
    "omega = { 0.5, 0, 300 }", 8), 1e-3)
  tap.is(p.rate, 0, "a fast spin is not stiff", p.text)
  p = planned(written("swings", "effect.damping { rate = 200 }, effect.torque { inertial = { 1e-9, 0, 0 } }",
    "omega = { 0.5, 0, 300 }", 8), 1e-3)
  tap.ok(math.abs(p.rate / 200 - 1) < 1e-6, "with 1600 decays it is", p.rate)
end

-- polhode explain says so without a compiler, of the first state: the rate of above, decays within 1/2 s.
do
  local binary = os.getenv "POLHODE" or "build/polhode"
  local function explained(path, options)
    program.shell(string.format("%s explain %s %s >%s/out", binary, path, options, dir))
    return program.read(dir .. "/out")
  end
  tap.like(explained(sliding(200), ""), "stiff: at t = 0 something decays at 6.9e+03 1/s, 3.4e+03 times within the " ..
    "horizon of 0.5 s", "explain: the fastest decay beside the horizon")
  local json = explained(sliding(200), "--format json")
  local rate, decays, horizon = json:match '"stiff": {%s*"rate": ([^,]+),%s*"decays": ([^,]+),%s*"horizon": (%S+)%s*}'
  local want = 3.5 * 200 * 9.80665
  tap.ok(rate and math.abs(rate / want - 1) < 0.01 and math.abs(decays / (want / 2) - 1) < 0.01 and
    tonumber(horizon) == 0.5, "explain: as JSON", json:match '"stiff"[^}]*')
  -- 7/2 c g T = 1000 for c = 58.3 s/m
  tap.ok(explained(sliding(57), "--format json"):find('"stiff": null', 1, true) and
    not explained(sliding(57), ""):find("stiff:", 1, true), "explain: below 1000 decays nothing is said")
  tap.like(explained(sliding(60), ""), "stiff: at t = 0", "explain: above 1000 it is")
end

tap.done(program.finish())
