#!/usr/bin/env lua5.4
-- segments.t - polhode fit --segments: a chaotic log in pieces, and a regular one that is whole in the end.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The driven pendulum th'' = -sin th - c th' + F cos(2 t/3), c = 0.5, F = 1.15, forgets how it began (Baker, Gollub:
-- Chaotic Dynamics, 2nd ed., chapter 3).  Its log is made here by RK4 with a twentieth of the emitted step.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local dir, root = program.directory(), "tests/reference/fit/"
local binary = os.getenv "POLHODE" or "build/polhode"
local SIGMA = 0.01

local function fit(log, free, options)
  local code, out, err = program.output(string.format("%s fit %s/scene.lua --data %s --free %s --format json %s",
    binary, dir, log, free, options or ""))
  return code, out ~= "" and json.read(out) or { estimates = { {}, {} }, wrong = {}, notes = {} }, err
end

local function has(list, text)
  for _, s in ipairs(list) do
    if s:find(text, 1, true) then return true end
  end
  return false
end

-- ---- chaos ----

math.randomseed(20261123)
local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

do
  local function rate(t, x, v) return v, -math.sin(x) - 0.5 * v + 1.15 * math.cos(2 * t / 3) end
  local rows, x, v, h = { "t,angle" }, 0.2, 0.1, 0.005
  for i = 0, 2000 do
    rows[#rows + 1] = string.format("%.1f,%.6f", i * 0.1, x + SIGMA * normal())
    for k = 0, 19 do
      local t = i * 0.1 + k * h
      local a1, b1 = rate(t, x, v)
      local a2, b2 = rate(t + h / 2, x + h / 2 * a1, v + h / 2 * b1)
      local a3, b3 = rate(t + h / 2, x + h / 2 * a2, v + h / 2 * b2)
      local a4, b4 = rate(t + h, x + h * a3, v + h * b3)
      x, v = x + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), v + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
    end
  end
  program.write(dir .. "/chaos.csv", table.concat(rows, "\n") .. "\n")
end

program.write(dir .. "/scene.lua", [[
local c, F = param("c", 0.45, "N m s"), param("F", 1.2, "N m")
local one = quantity("1", "N m")
return scene { name = "driven", body = tensor { mass = 1, xx = 1, yy = 1, zz = 1 },
  effects = { effect.custom {
    torque = function(m) return { 0, 0, -one*sin(m.angle) - c*m.w[3] + F*cos(quantity("2/3", "1/s")*m.t) } end,
    states = { angle = { initial = 0.1, rate = function(m) return m.w[3] end } } } },
  initial = { omega = { 0, 0, 0 } }, measure = { angle = "angle", sigma = 0.01 } }
]])

do
  local log = dir .. "/chaos.csv"
  local code, got = fit(log, "c,F,initial")
  tap.is(code, 3, "a chaotic log at once: it has no smooth optimum")
  tap.ok(has(got.wrong, "has no smooth optimum; try --segments"), "which is said, with what helps",
    table.concat(got.wrong, "\n"))
  code, got = fit(log, "c,F,initial", "--segments 20")
  tap.is(code, 0, "in twenty segments it is fitted")
  tap.is(got.segments, 20, "and told so")
  tap.ok(has(got.notes, "nothing ties the segments together"), "with what that means")
  for i, truth in ipairs { 0.5, 1.15 } do
    local e = got.estimates[i]
    -- a right estimate is farther off once in 1e4 logs; this log is always the same
    tap.ok(e.sigma and math.abs(e.estimate - truth) < 3.9 * e.sigma and e.sigma < 1e-3 * truth, e.name ..
      ": the truth, within its error", e.estimate)
  end
  local _, _, err = fit(log, "c,F", "--segments 20")
  tap.ok(err:find("--segments: --free must have initial", 1, true) ~= nil, "--segments without initial is refused", err)
  _, _, err = fit(log, "c,F,initial", "--segments 100")
  tap.ok(err:find("--segments 100: 202 unknowns, and at most 192 are possible: at most 95 segments", 1, true) ~= nil,
    "too many unknowns are refused", err)
  _, _, err = fit(log, "c,F,initial", "--segments 1.5")
  tap.ok(err:find("--segments must be a whole number from 2 on", 1, true) ~= nil, "half a segment is refused", err)
end

-- ---- a regular motion, from a guess that a whole log does not take ----

do
  local want = json.read(program.read(root .. "01_free_ratios/case.json")).fits[1]
  program.write(dir .. "/scene.lua", [[
local I2, I3 = param("I2", 1.2, "kg m^2"), param("I3", 1.5, "kg m^2")
return scene { name = "tumbling", body = tensor { mass = 1, xx = 1, yy = I2, zz = I3 },
  initial = { omega = { 1, 1, 1 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.004 } }
]])
  local code, got = fit(root .. "01_free_ratios/log.csv", "I2,I3,initial", "--segments 20")
  tap.is(code, 0, "a regular log in segments")
  tap.is(got.segments, 1, "ends with the whole log from one state")
  for i, name in ipairs { "I2", "I3" } do
    local e = got.estimates[i]
    tap.ok(e.estimate and math.abs(e.estimate - want.estimate[name]) < 1e-6 * want.sigma[name] and
      math.abs(e.sigma / want.sigma[name] - 1) < 1e-4, name .. ": estimate and error are the reference's", e.estimate)
  end
end

program.finish()
tap.done()
