#!/usr/bin/env lua5.4
-- condition.t - a scene's condition numbers, against those of motions whose formula is known.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle: a ball spinning about z in a fluid, w = w0 exp(-k t), k = c/I, turned by phi = (w0/k)(1 - exp(-k t)).  In the
-- measure of errors (rates by the largest of the 40, attitude by |dq| = |dphi|/2) the derivatives by w0 and by c follow
-- by hand.  And a ball without a fluid: phi = w0 t, whose number at T is twice that at T/2.
-- Bound 1e-6: the quotient's step is 2^-30, its second-order part 2^-31 times numbers of some tens, its rounding 2^-22.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local lua = require "tests.plan.tree"
local program = require "tests.cli.program"

local dir = program.directory()
program.write(dir .. "/ball.lua", [[
local c = param("c", 0.1, "N m s")
return scene { name = "ball", body = solid.sphere { r = 1, mass = 1 }, effects = { effect.damping { c = c } },
  initial = { omega = {0, 0, 20} }, time = { horizon = 4 } }
]])
program.write(dir .. "/free.lua", [[
return scene { name = "free", body = solid.sphere { r = 1, mass = 1 }, initial = { omega = {0, 0, 20} },
  time = { horizon = 4 } }
]])

local function numbers(file)
  local out, failure = lua([[
local driver, condition = require "generator.driver", require "generator.plan.condition"
local numeric, reference = require "generator.dynamics.numeric", require "generator.plan.reference"
local job = driver.read(host, args[1], {})
local c = condition.of(reference.new(host, job), numeric.initial(job), 4)
say("number", string.format("%.17g", c.number))
say("growth", string.format("%.17g", c.growth))
say("state", string.format("%.17g", c.state))
say("worst", c.input)
for _, k in ipairs(c) do say(k.name, string.format("%.17g", k.number)) end
]], nil, dir .. "/" .. file)
  if failure ~= "" then tap.diag(failure) end
  local list = {}
  for name, value in out:gmatch "([^\n]-) ([^ \n]+)\n" do list[name] = tonumber(value) or value end
  return list
end

local T = 4
local times = {}
for k = 1, 40 do times[k] = T * (0.9 + 0.1 * k / 40) end

-- The largest over the times of |dw| / (largest w) and |dphi|/2.
local function largest(w, dw, dphi)
  local scale, most = 0, 0
  for _, t in ipairs(times) do scale = math.max(scale, math.abs(w(t))) end
  for _, t in ipairs(times) do most = math.max(most, math.abs(dw(t)) / scale, math.abs(dphi(t)) / 2) end
  return most
end

do
  local k, w0 = 0.1 / (2 / 5), 20
  local function w(t) return w0 * math.exp(-k * t) end
  local got = numbers "ball.lua"
  local by_w0 = largest(w, w, function(t) return w0 / k * (1 - math.exp(-k * t)) end)
  -- d/d ln k of phi: -(w0/k)(1 - e) + w0 t e
  local by_c = largest(w, function(t) return -k * t * w(t) end,
    function(t) return -w0 / k * (1 - math.exp(-k * t)) + w0 * t * math.exp(-k * t) end)
  tap.near(got.wz, by_w0, 1e-6, 0, "the number of the spin at the start",
      "central differences of 2^-30 of doubles' motions")
  tap.near(got["parameter c"], by_c, 1e-6, 0, "the number of a parameter",
      "central differences of 2^-30 of doubles' motions")
  tap.near(got.number, math.max(by_w0, by_c), 1e-6, 0, "the scene's is the largest",
      "central differences of 2^-30 of doubles' motions")
  tap.is(got.worst, "wz", "and its input is named")
  tap.ok(got.wx == nil and got.qx == nil, "inputs that are zero have no relative change")
  tap.near(got.state, by_w0, 1e-6, 0, "changes of the size of the state: those of the spin move the end most",
      "central differences of 2^-30 of doubles' motions")
end

do
  local got = numbers "free.lua"
  tap.near(got.number, 20 * T / 2, 1e-6, 0, "a ball that turns freely: half the angle",
      "central differences of 2^-30 of doubles' motions")
  tap.near(got.growth, 2, 1e-6, 0, "which grows with time",
      "central differences of 2^-30 of doubles' motions")
end

program.finish()
tap.done()
