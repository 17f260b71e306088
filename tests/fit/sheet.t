#!/usr/bin/env lua5.4
-- sheet.t - polhode fit --sheet: the picture of data, model, residuals and ellipses.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The picture is read back: what is drawn is compared with the answer's numbers, not with a stored picture.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local fitting = require "tests.fit.fitting"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local CASE = "tests/reference/fit/07_heavy_top/log.csv"

local function fit(scene, log, free, options)
  return fitting.run(binary, scene, "--data " .. log .. " --free " .. free .. " " .. options)
end

local function count(text, pattern) return select(2, text:gsub(pattern, "")) end

-- ---- a rate and a bias: 2000 rows, of which every second is drawn ----

do
  local rows = { "t,wz,wx" }
  for i = 0, 1999 do
    rows[i + 2] = string.format("%.2f,%.4f,%s", i * 0.01, 2 + (i % 2) * 0.02 - 0.01 + 0.01 * math.sin(i), i % 3 == 0 and
      string.format("%.4f", 0.5 + 0.01 * math.cos(i)) or "")
  end
  program.write(dir .. "/log.csv", table.concat(rows, "\n") .. "\n")
  local scene = [[
local w3, b = param("w3", 1.9, "rad/s"), param("b", 0.1, "rad/s")
return scene { name = "rotor", body = tensor { mass = 1, xx = 2, yy = 2, zz = 2 },
  initial = { omega = { 0, 0, w3 } }, measure = { wz = wz, wx = wx + b + 0*w3, sigma = 0.0123 } }
]]
  local code = fit(scene, dir .. "/log.csv", "w3,b", "--sheet " .. dir .. "/sheet.svg")
  tap.is(code, 0, "a sheet is drawn beside the answer")
  local text = program.read(dir .. "/sheet.svg") or ""
  tap.ok(text:find("^<svg ") and text:find "</svg>\n$" and not text:find "nan" and not text:find "inf", "it is an SVG")
  tap.is(count(text, 'class="frame"'), 5, "two panels a column, and an ellipse of the two parameters")
  -- rows with an even number: 1000 of wz, those divisible by 6 of wx: 334; in two panels each
  tap.is(count(text, "<circle"), 2 * (1000 + 334), "a dot for each row that is drawn, and none for missing values")
  tap.is(count(text, "<polygon"), 1, "an ellipse")
  tap.is(count(text, "chi%-square [%d.]+ times its expectation, 2665 degrees of freedom, more has a probability of"), 1,
    "chi-square")
  tap.is(count(text, "log.csv: w[xz], root mean square [%d.]+"), 2, "of each column what its residuals are")
  tap.is(count(text, ", white with probability"), 1, "and whether they are white, where pairs of rows are there")
  -- w3 and b have nothing to do with each other, so it is a circle: of 2.4477 standard errors in a cell of 96/6 each
  local low, high = math.huge, -math.huge
  for x in (text:match '<polygon[^>]*points="([^"]*)"' or ""):gmatch "([%d.]+),[%d.]+" do
    low, high = math.min(low, tonumber(x)), math.max(high, tonumber(x))
  end
  tap.near(high - low, 2 * 2.44775 * 96 / 6, 1e-3, 0, "the ellipse has its size", "two decimals of a picture")
  local code2 = fit(scene, dir .. "/log.csv", "w3,b", "--sheet " .. dir .. "/again.svg")
  tap.ok(code2 == 0 and program.read(dir .. "/again.svg") == text, "the same fit gives the same bytes")
  local code3, _, err = fit(scene, dir .. "/log.csv", "w3,b", "--sheet " .. dir .. "/log.csv/sheet.svg")
  tap.ok(code3 ~= 0 and err:find("log.csv/sheet.svg", 1, true) ~= nil, "where it cannot be written that is said", err)
end

-- ---- an attitude: three residuals, no data panel ----

do
  local code = fit([[
local I1, I3, M = param("I1", 1, "kg m^2"), param("I3", 0.5, "kg m^2"), param("M", 1, "N m")
return scene { name = "top", body = tensor { mass = 1, xx = I1, yy = I1, zz = I3 },
  initial = { omega = { 0.28, -0.19, 39.97 }, attitude = { axis = "x", angle = 0.6 } },
  measure = { attitude = "q", sigma = 0.008 } }
]], CASE, "I3,initial", "--sheet " .. dir .. "/top.svg")
  local text = program.read(dir .. "/top.svg") or ""
  tap.is(code, 3, "a fit that fails is drawn, too: there the picture helps")
  tap.ok(count(text, 'class="frame"') >= 3 and text:find("attitude_z", 1, true) ~= nil, "three residuals of it")
end

program.finish()
tap.done()
