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

refused("a word in a cell", 2, 'log.csv:3: column wz must be a number, got "two"', "t,wz\n0,2\n1,two\n")
refused("an infinity", 2, 'log.csv:3: column wz must be a number, got "inf"', "t,wz\n0,2\n1,inf\n")
refused("a number that is too large", 2, 'log.csv:2: column wz must be a number, got "1e999"', "t,wz\n0,1e999\n1,2\n")
refused("a row that is too short", 2, "log.csv:3: 2 cells expected, got 1", "t,wz\n0,2\n1\n")
refused("a row that is too long", 2, "log.csv:2: 2 cells expected, got 3", "t,wz\n0,2,3\n1,2\n")
refused("a time twice", 2, "log.csv:4: times must ascend, got 1 s after 1 s", "t,wz\n0,2\n1,2\n1,2\n")
refused("a time that goes back", 2, "log.csv:4: times must ascend", "t,wz\n0,2\n1,2\n0.5,2\n")
refused("a time before the motion", 2, "log.csv:2: times must not be negative", "t,wz\n-1,2\n1,2\n")
refused("a time that is missing", 2, 'log.csv:3: column t must be a number, got ""', "t,wz\n0,2\n,2\n")
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
refused("a quaternion of 0", 2, "log.csv:3: q is 0, 0, 0, 0, which is no attitude", "t,qw,qx,qy,qz\n0,1,0,0,0\n" ..
  "1,0,0,0,0\n2,1,0,0,0\n", "--free w3", "q = 'q', sigma = 0.01")
refused("too few values", 2, "log.csv: too few values: 2 for 2 unknowns", "t,wz\n0,2\n1,2\n", "--free w3,b",
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

-- ---- inputs from columns ----

-- A rotor of moment 2 that a motor turns: w(t) = w(0) + integral of u/2.
local DRIVEN = [[
local w3, k = param("w3", 0.3, "rad/s"), param("k", 0.9, "1")
local push = input("push", "N m" LIMITS)
MORE
return scene { name = "rotor", body = tensor { mass = 1, xx = 2, yy = 2, zz = 2 },
  effects = { effect.torque { body = { 0, 0, TORQUE } } },
  initial = { omega = { 0, 0, w3 } }, measure = { wz = wz, sigma = 0.01 } }
]]

local function drive(name, log, options, change, file)
  local text = DRIVEN
  for word, default in pairs { LIMITS = "", MORE = "", TORQUE = "k*push" } do -- each once, in any order
    text = text:gsub(word, (change or {})[word] or default)
  end
  program.write(dir .. "/rotor.lua", text)
  program.write(dir .. "/rotor.csv", log)
  program.write(dir .. "/push.csv", file or "")
  local code = program.shell(string.format("cd %s && %s fit rotor.lua --data rotor.csv --free w3,k --format json %s " ..
    "> out 2> err", dir, binary:sub(1, 1) == "/" and binary or os.getenv "PWD" .. "/" .. binary, options))
  local out, err = program.read(dir .. "/out"), program.read(dir .. "/err")
  local made = code == 0 and json.read(out)
  if name then
    tap.is(code, 0, name .. ": exit status")
    tap.near(made and made.estimates[1].estimate or 0, 0.25, 1e-10, 0, name .. ": the first rate", "RK4 is exact")
    tap.near(made and made.estimates[2].estimate or 0, 1.5, 1e-10, 0, name .. ": the motor's factor", "RK4 is exact")
  end
  return code, out, err
end

-- A log of the rate f(t), with the input's own value in some rows.
local function driven_log(f, u)
  return "t,wz" .. (u and ",push [mN m]" or "") .. "\n" .. rows(81, function(i)
    return string.format("%.2f,%.17g%s", i * 0.05, f(i * 0.05), u and "," .. u(i) or "")
  end)
end

-- u = 0, 0.4, 0.4, 0 at t = 0, 1, 2, 4: held, and on lines; the integrals by hand.
local function held(t) return 0.25 + 0.75 * 0.4 * math.max(0, math.min(t, 4) - 1) end
local function lines(t)
  local s = t < 1 and 0.2 * t * t or t < 2 and 0.2 + 0.4 * (t - 1) or 0.6 + 0.4 * (t - 2) - 0.1 * (t - 2) ^ 2
  return 0.25 + 0.75 * s
end
local PUSH = "t,push\n0,0\n1,0.4\n2,0.4\n4,0\n"
drive("an input from a file, held", driven_log(held), "--input push.csv", nil, PUSH)
drive("an input from a file, on lines", driven_log(lines), "--input push.csv --between linear", nil, PUSH)
drive("an input from a column with gaps and a unit", driven_log(lines, function(i)
  return ({ [0] = "0", [20] = "400", [40] = "400", [80] = "0" })[i] or ""
end), "--between linear")
-- Beyond 0.2 N m nothing more: the line crosses at t = 0.5 and 3, between the rows of the file.
drive("an input with a limit", driven_log(function(t)
  local s = t < 0.5 and 0.2 * t * t or t < 3 and 0.05 + 0.2 * (t - 0.5) or 0.55 + 0.2 * (t - 3) - 0.1 * (t - 3) ^ 2
  return 0.25 + 0.75 * s
end), "--input push.csv --between linear", { LIMITS = ", { min = -0.2, max = 0.2 }" }, PUSH)
-- The slope of an input: 0.4, 0, -0.2 in N m/s.
local SLOPE = { MORE = 'local r = input("push_rate", "N m/s")', TORQUE = 'k*r*quantity("1", "s") + 0*push' }
drive("the slope of an input", driven_log(function(t)
  return 0.25 + 0.75 * (0.4 * math.min(t, 1) - 0.2 * math.max(0, math.min(t, 4) - 2))
end), "--input push.csv --between linear", SLOPE, PUSH)

local function undriven(name, status, message, ...)
  local code, out, err = drive(nil, ...)
  tap.is(code, status, name .. ": exit status")
  tap.ok(err:find(message, 1, true) ~= nil and out == "", name .. ": says so, and nothing else", err)
end
undriven("an input without data", 2, "rotor.csv: has no column push, an input of the scene; a file beside it may have",
  driven_log(held), "")
undriven("a file without an input", 2, 'push.csv:1: the scene has no input "pull" (it has push)', driven_log(held),
  "--input push.csv", nil, "t,pull\n0,1\n1,2\n")
undriven("an input in a wrong unit", 2, "push.csv:1: column push must be in", driven_log(held), "--input push.csv", nil,
  "t,push [m]\n0,1\n1,2\n")
undriven("a slope of what is held", 2, "with --between linear it is the slope of push", driven_log(held),
  "--input push.csv", SLOPE, PUSH)
undriven("two files for one log", 2, "--input must be given once, or once for each --data", driven_log(held),
  "--input push.csv --input push.csv", nil, PUSH)
refused("--input without inputs", 2, "--input: the scene has no inputs", good, "--free w3 --input log.csv")

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
tap.ok(out:find "%(the farthest value: log.csv:%d+, wz is off by %-?[%d.]+ sigma%)" ~= nil, "with file and line", out)

-- Gross errors in a constant rate: the estimate is where the sum of psi(z) is 0, found here by halving; its variance is
-- sum psi^2/(sum psi')^2.
do
  local sigma, values, text = 0.01, {}, { "# made by hand", "t,wz" }
  for i = 0, 99 do
    local gross = i == 20 and 3 or i == 57 and -0.3 or i == 90 and 0.045 or 0
    values[i + 1] = tonumber(string.format("%.4f", 2 + 0.012 * math.sin(2.4 * i) + gross))
    text[#text + 1] = string.format("%.1f,%.4f", i * 0.1, values[i + 1])
  end
  local k = { huber = 1.345, cauchy = 2.385 }
  local psi = {
    huber = function(z) return math.max(-k.huber, math.min(k.huber, z)), math.abs(z) <= k.huber and 1 or 0 end,
    cauchy = function(z)
      local u2 = (z / k.cauchy) ^ 2
      return z / (1 + u2), (1 - u2) / (1 + u2) ^ 2
    end,
  }
  local function sums(loss, m)
    local sum, square, slope = 0, 0, 0
    for _, v in ipairs(values) do
      local p, d = psi[loss]((v - m) / sigma)
      sum, square, slope = sum + p, square + p * p, slope + d
    end
    return sum, math.sqrt(square) / slope * sigma
  end
  for _, loss in ipairs { "huber", "cauchy" } do
    local low, high = 1.98, 2.02
    for _ = 1, 60 do
      local middle = (low + high) / 2
      if sums(loss, middle) > 0 then low = middle else high = middle end
    end
    local _, error_of = sums(loss, low)
    code, out = fit(table.concat(text, "\n") .. "\n", "--free w3 --format json --loss " .. loss)
    got = code == 0 and json.read(out) or { estimates = { {} } }
    tap.is(code, 0, loss .. ": gross errors do not fail the fit")
    -- the search stops within 1e-7 standard errors
    tap.near(got.estimates[1].estimate or 0, low, 1e-9, 0, loss .. ": the estimate", "1e-7 of a standard error of 1e-3")
    tap.near(got.estimates[1].sigma or 0, error_of, 1e-6, 0, loss .. ": its standard error", "of the same place")
    tap.is(got.outlier_count, 3, loss .. ": the three are counted")
    local o = got.outliers and got.outliers[1] or {}
    tap.ok(o.line == 23 and o.name == "wz" and math.abs(o.off_by - 300) < 5, loss .. ": and named by line and column")
  end
  out = select(2, fit(table.concat(text, "\n") .. "\n", "--free w3 --loss cauchy"))
  tap.ok(out:find("log.csv:60: wz is off by %-%d+%.?%d* sigma at t = 5.7 s"), "in words, too", out)
end
refused("a loss without sigma", 2, "--loss huber: without a sigma nothing tells what is far", good,
  "--free w3 --loss huber", "wz = wz")

-- Columns that no sensor measures so: said with file and line.
local function odd(name, log, message, measure)
  local text = select(2, fit(log, "--free w3", measure))
  if message then
    tap.ok(text:find(message, 1, true) ~= nil, name .. ": is said", text)
  else
    tap.ok(not text:find "note: log.csv:", name .. ": nothing is odd", text)
  end
end
local function wave(f)
  return "t,wz\n" .. rows(200, function(i) return string.format("%.2f,%.3f", i * 0.05, f(i * 0.05, i)) end)
end
odd("a constant column", wave(function() return 2 end),
  "log.csv:2: column wz has the same value in all 200 rows, 2: is the sensor on?")
odd("a gyro at its limit", wave(function(t) return math.min(1.5, 2 * math.sin(t)) end),
  "log.csv:19: column wz stays at its extreme value 1.5 for 29 rows: a sensor at its limit")
odd("and at the lower one", wave(function(t) return math.max(-1.5, 2 * math.sin(t)) end),
  "column wz stays at its extreme value -1.5 for")
odd("the top of a slow wave", wave(function(t) return 0.1 * math.sin(t / 3) end))
odd("the top of a fast one", wave(function(t) return 2 * math.sin(t) end))
odd("a wrapped angle", wave(function(t) return (2 * t + math.pi) % (2 * math.pi) - math.pi end),
  "log.csv:34: column wz jumps by -6.183, a turn: the angle is wrapped", "wz = wz*quantity('1', 's'), sigma = 0.01")
odd("an angle that counts turns", wave(function(t) return 2 * t end), nil, "wz = wz*quantity('1', 's'), sigma = 0.01")

-- The scene with the estimate; comments and all else stay.
code = fit(good, "--free w3 -o fitted.lua")
local text = program.read(dir .. "/fitted.lua") or ""
local value = tonumber(text:match 'param%("w3", ([%d.]+), "rad/s"%)' or 0)
tap.is(code, 0, "-o writes a scene")
tap.near(value, 2, 1e-12, 0, "with the estimate", ROUNDED)
tap.is((text:gsub('("w3", )[%d.]+', "%11.9")), program.read(dir .. "/top.lua"), "and all else as it was")

program.finish()
tap.done()
