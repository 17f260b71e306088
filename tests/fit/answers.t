#!/usr/bin/env lua5.4
-- answers.t - polhode fit: what is wrong with a log, a scene or a command line is said once, with file and line.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The logs are made here: a top that spins about z at a constant rate, wz = 2, so that the answers are known.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local SCENE = [[
local w3, b = param("w3", 1.9, "rad/s"), param("b", 0.1, "rad/s")
local I3 = param("I3", 3, "kg m^2")
return scene { name = "top", body = tensor { mass = 1, xx = 2, yy = 2, zz = I3 },
  initial = { omega = { 0, 0, w3 } }, measure = { MEASURE } }
]]

local function rows(n, f)
  local list = {}
  for i = 0, n - 1 do list[#list + 1] = f(i) end
  return table.concat(list, "\n") .. "\n"
end
local good = "t,wz\n" .. rows(100, function(i)
  return string.format("%.2f,%.3f", i * 0.1, 2 + (i % 2) * 0.02 - 0.01)
end)

-- Status, standard output, standard error of a fit of w3 to the log.
local function fit(log, more, measure)
  program.write(dir .. "/log.csv", log)
  program.write(dir .. "/top.lua", (SCENE:gsub("MEASURE", measure or "wz = wz, sigma = 0.01")))
  local code = program.shell(string.format("cd %s && %s fit top.lua --data log.csv %s > out 2> err", dir,
    binary:sub(1, 1) == "/" and binary or os.getenv "PWD" .. "/" .. binary, more or "--free w3"))
  return code, program.read(dir .. "/out"), program.read(dir .. "/err")
end

local function refused(name, status, message, ...)
  local code, out, err = fit(...)
  tap.is(code, status, name .. ": exit status")
  tap.ok(err:find(message, 1, true) ~= nil, name .. ": says so", err)
  tap.is(out, "", name .. ": nothing else is printed")
end

-- ---- logs ----

refused("a word in a cell", 2, 'log.csv:3: must be a number, got "two"', "t,wz\n0,2\n1,two\n")
refused("an infinity", 2, 'log.csv:3: must be a number, got "inf"', "t,wz\n0,2\n1,inf\n")
refused("a number that is too large", 2, 'log.csv:2: must be a number, got "1e999"', "t,wz\n0,1e999\n1,2\n")
refused("a row that is too short", 2, "log.csv:3: 2 cells expected, got 1", "t,wz\n0,2\n1\n")
refused("a row that is too long", 2, "log.csv:2: 2 cells expected, got 3", "t,wz\n0,2,3\n1,2\n")
refused("a time twice", 2, "log.csv:4: times must ascend, got 1 s after 1 s", "t,wz\n0,2\n1,2\n1,2\n")
refused("a time that goes back", 2, "log.csv:4: times must ascend", "t,wz\n0,2\n1,2\n0.5,2\n")
refused("a time before the motion", 2, "log.csv:2: times must not be negative", "t,wz\n-1,2\n1,2\n")
refused("a time that is missing", 2, "log.csv:3: the time is missing", "t,wz\n0,2\n,2\n")
refused("a column that is missing", 2, "log.csv:1: has no column wz, which the scene measures (it has t, wy)",
  "t,wy\n0,2\n1,2\n")
refused("no time", 2, "log.csv:1: has no column t, the time", "time,wz\n0,2\n1,2\n")
refused("a column twice", 2, "log.csv:1: two columns are called wz", "t,wz,wz\n0,2,2\n1,2,2\n")
refused("a wrong unit", 2, "log.csv:1: column wz must be in 1/s, got [m]", "t,wz [m]\n0,2\n1,2\n")
refused("a unit that is none", 2, "log.csv:1: column wz: ", "t,wz [blob]\n0,2\n1,2\n")
refused("too few units", 2, "log.csv:2: 2 names, but 1 units above them", "# units: s\nt,wz\n0,2\n1,2\n")
refused("a sigma of 0", 2, "sigma of column wz must be a positive number", "# sigma: ,0\nt,wz\n0,2\n1,2\n")
refused("a column without values", 2, "log.csv: column wz has no value", "t,wz\n0,\n1,nan\n")
refused("one row", 2, "log.csv: must have two rows or more, got 1", "t,wz\n0,2\n")
refused("times of day", 2, "log.csv: the rows are 0.5 s apart and go from t = 1763890000 s to 1763890001 s, too many",
  "t,wz\n1763890000,2\n1763890000.5,2\n1763890001,2\n")
refused("an empty file", 2, "log.csv: has no line that names its columns", "")
refused("too few values", 2, "too few values: 2 for 2 unknowns", "t,wz\n0,2\n1,2\n", "--free w3,b",
  "wz = wz + b, sigma = 0.01")

-- ---- command line and scene ----

refused("no parameter of that name", 2, "--free must be some of initial, w3, b, I3, got w4; did you mean w3?", good,
  "--free w4")
refused("nothing free", 2, "--free NAME,... is missing", good, "--loss huber")
refused("a parameter twice", 2, "--free: w3 stands there twice", good, "--free w3,w3")
refused("-o with initial", 2, "-o: the initial state is no parameter", good, "--free initial -o x.lua")
refused("a log that is not there", 2, "cannot read none.csv", good, "--data none.csv --free w3")
refused("a sigma that is free", 2, "--free: b is in the sigma of wz, which must be known", good, "--free w3,b",
  "wz = wz, sigma = b")
refused("a state that the scene has not", 1, "measure: h: the scene has no state rz", good, nil, "h = rz, sigma = 1")
refused("an output without motion", 1, "measure: wz must depend on t or on states", good, nil, "wz = 3")
refused("a sigma that is negative", 1, "measure: sigma of wz must be positive", good, nil, "wz = wz, sigma = -1")
refused("a sigma for some", 1, "sigma must be given for all outputs or for none", good, nil,
  "wz = wz, wx = wx, sigma = { wz = 1 }")
refused("an output of no kind", 1, "measure: wz must be a number", good, nil, "wz = true")
refused("a column twice", 1, "measure: two outputs have the column wz", good, nil,
  "wz = wz, w = wz, columns = { w = 'wz' }")

-- ---- answers that are known ----

local ROUNDED = "sums of a hundred numbers, each rounded"

-- The mean of values that are 2 - 0.01 and 2 + 0.01 in turn: 2, standard error 0.01/sqrt(100), chi-square 100.
local code, out = fit(good, "--free w3 --format json")
local got = code == 0 and json.read(out) or { estimates = { {} } }
tap.is(code, 0, "a constant rate is fitted")
tap.near(got.estimates[1].estimate or 0, 2, 1e-12, 0, "its estimate is the mean", ROUNDED)
tap.near(got.estimates[1].sigma or 0, 0.001, 1e-12, 0, "its standard error is sigma over the root of n", ROUNDED)
tap.near(got.chi2 or 0, 100, 1e-9, 0, "chi-square counts every value once", ROUNDED)
tap.ok(got.residuals and got.residuals[1].whiteness_tail < 1e-12, "values that alternate are not white")

-- The same in degrees, with rows that are missing and a remark: the unit changes nothing.
local degrees = "# units: s, deg/s; by hand\n# sigma: -, 0.5729577951308232\n\nt,wz\n" .. rows(100, function(i)
  return string.format("%.2f,%.15g", i * 0.1, math.deg(2 + (i % 2) * 0.02 - 0.01)) .. (i == 50 and "\n5.05,nan" or "")
end)
code, out = fit(degrees, "--free w3 --format json", "wz = wz")
got = code == 0 and json.read(out) or { estimates = { {} } }
tap.near(got.estimates[1].estimate or 0, 2, 1e-12, 0, "units of columns are taken", ROUNDED)
tap.near(got.estimates[1].sigma or 0, 0.001, 1e-12, 0, "and a sigma that stands in the file", ROUNDED)
tap.is(got.n, 100, "a missing value is none")

-- A spin about a principal axis says nothing of its moment, and a bias cannot be told from the rate.
code, out = fit(good, "--free w3,I3,b", "wz = wz + b, sigma = 0.01")
tap.is(code, 0, "what is not determined is no failure")
tap.ok(out:find("I3 +not determined") and out:find("I3: nothing that is measured depends on it", 1, true),
  "a moment that has no effect is named", out)
tap.ok(out:find("w3 +not determined") and out:find("b +not determined") and out:find("w3, b: they can change", 1, true),
  "and two that can be exchanged", out)

-- Without a torque the scale of the moments has no effect on a motion (tests/reference/fit/01_free_ratios).
do
  program.write(dir .. "/body.lua", [[
local I1, I2, I3 = param("I1", 1, "kg m^2"), param("I2", 1.44, "kg m^2"), param("I3", 1.8, "kg m^2")
return scene { name = "body", body = tensor { mass = 1, xx = I1, yy = I2, zz = I3 },
  initial = { omega = { 0.9, 1.1, -0.4 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.004 } }
]])
  local body = (os.getenv "POLHODE" or "build/polhode") .. " fit " .. dir .. "/body.lua --data " ..
    "tests/reference/fit/01_free_ratios/log.csv --free I1,I2,I3,initial > " .. dir .. "/out"
  tap.is(program.shell(body), 0, "three moments of a free body: no failure")
  local text = program.read(dir .. "/out")
  tap.ok(text:find("I1, I2, I3: only their ratios are determined", 1, true), "their scale is named", text)
  tap.ok(text:find "wx%(0%) +0%.899998 +%+%- 6%.7e%-05", "and the rates are told as if one moment were held", text)
end

-- A model that does not fit: the rate grows.
code, out = fit("t,wz\n" .. rows(100, function(i) return i * 0.1 .. "," .. 2 + i * 0.01 end))
tap.is(code, 3, "a model that does not fit has exit status 3")
tap.ok(out:find("WRONG: the model does not fit", 1, true) ~= nil, "and says so")

-- The scene with the estimate; comments and all else stay.
code = fit(good, "--free w3 -o fitted.lua")
local text = program.read(dir .. "/fitted.lua") or ""
local value = tonumber(text:match 'param%("w3", ([%d.]+), "rad/s"%)' or 0)
tap.is(code, 0, "-o writes a scene")
tap.near(value, 2, 1e-12, 0, "with the estimate", ROUNDED)
tap.is((text:gsub('("w3", )[%d.]+', "%11.9")), program.read(dir .. "/top.lua"), "and all else as it was")

program.finish()
tap.done()
