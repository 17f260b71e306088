#!/usr/bin/env lua5.4
-- reference.t - the true motion of a scene from any state and parameters, with an error of its own.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle: the textbook's free symmetric body (Landau, Lifshitz, Mechanics, section 33): in body axes the rates turn
-- about the axis with (1 - I3/I1) w3; in space the axis turns about L with |L|/I1.  A ball in a fluid:
-- w = w0 exp(-t c/I).
-- Bounds: the formula here is rounded in double, its phases of up to 60 rad carry 2^-53 each: 60*2^-53*4 = 3e-14.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local lua = require "tests.plan.tree"
local program = require "tests.cli.program"

local dir = program.directory()
program.write(dir .. "/coin.lua", [[
local I1, I3 = param("I1", 3, "kg m^2"), param("I3", 2, "kg m^2")
return scene { name = "coin", body = tensor { mass = 1, xx = I1, yy = I1, zz = I3 }, initial = { omega = {1, 0, 5} },
  time = { horizon = 10 } }
]])
program.write(dir .. "/ball.lua", [[
local c = param("c", 0.1, "N m s")
return scene { name = "ball", body = solid.sphere { r = 1, mass = 1 }, effects = { effect.damping { c = c } },
  initial = { omega = {0, 0, 2} }, time = { horizon = 4 } }
]])

local head = [[
local driver, R = require "generator.driver", require "generator.algebra.rational"
local reference, err = require "generator.plan.reference", require "generator.plan.error"
local job = driver.read(host, args[1], {})
local truth = reference.new(host, job)
local function show(x)
  for i, y in ipairs(x) do x[i] = string.format("%.17g", y) end
  say(table.concat(x, " "))
end
]]

local function numbers(text, file)
  local out, failure = lua(head .. text, nil, dir .. "/" .. file)
  local list = {}
  for x in out:gmatch "%S+" do list[#list + 1] = tonumber(x) end
  if failure ~= "" then tap.diag(failure) end
  return list
end

-- The free symmetric body at t from attitude 1 and rates (a, 0, b): q = exp(L t/I1) exp(-k Omega t), Omega of the body.
local function coin(I1, I3, a, b, t)
  local L = { I1 * a, 0, I3 * b }
  local size = math.sqrt(L[1] ^ 2 + L[3] ^ 2)
  local f, g = size / I1 * t / 2, (1 - I3 / I1) * b * t / 2
  local s = math.sin(f) / size
  local p = { math.cos(f), s * L[1], 0, s * L[3] }
  local r, k = math.cos(g), math.sin(g) -- (r, 0, 0, k)
  local turn = (1 - I3 / I1) * b * t
  return { p[1] * r - p[4] * k, p[2] * r + p[3] * k, p[3] * r - p[2] * k, p[4] * r + p[1] * k,
    a * math.cos(turn), -a * math.sin(turn), b }
end

local function near(got, want, bound, name)
  local worst = 0.0
  for i = 1, #want do worst = math.max(worst, math.abs((got[i] or math.huge) - want[i])) end
  tap.is(#got >= #want and worst <= bound, true, name .. string.format(": %.2g", worst))
end

local got = numbers([[show(truth:motion({ 1, 0, 0, 0, 1, 0, 5 }, { 4, 10 })[2])]], "coin.lua")
near(got, coin(3, 2, 1, 5, 10), 3e-14, "the scene's own parameters, a state, the last of the times")

got = numbers([[show(truth:motion({ 1, 0, 0, 0, 0.5, 0, 3 }, { 10 },
  { I1 = R.lift(5), I3 = R.lift "7/2" })[1])]], "coin.lua")
near(got, coin(5, 3.5, 0.5, 3, 10), 3e-14, "other parameters, another state")

got = numbers([[local _, own = truth:motion({ 1, 0, 0, 0, 1, 0, 5 }, err.times(10)) show { own }]],
  "coin.lua")
tap.is(#got == 1 and got[1] >= 2 ^ -53 and got[1] < 1e-14, true, "its own error: at least a rounding, and small")

got = numbers([[local rows, own = truth:motion({ 1, 0, 0, 0, 0, 0, 2 }, { 4 }) rows[1][8] = own
  show(rows[1])]], "ball.lua")
near({ got[7] }, { 2 * math.exp(-0.1 / 0.4 * 4) }, 3e-14, "with an effect: the damped ball")
tap.is(got[8] >= 2 ^ -53 and got[8] < 1e-14, true, "and the error of that, by a second tolerance")

got = numbers([[local rows, own = truth:motion({ 1, 0, 0, 0, 0, 0, 2 }, { 4 }, nil, true)
  show { #rows, own and 1 or 0 }]], "ball.lua")
tap.is(got[1] == 1 and got[2] == 0, true, "quick: rows without an error")

program.finish()
tap.done()
