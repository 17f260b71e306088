#!/usr/bin/env lua5.4
-- starts.t - polhode fit from bad starts: a free body by its momentum, a log piece by piece, Sobol's points.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Estimates are those of the reference cases (tests/reference/fit), to 1e-6 of a standard error as in reference.t, or
-- of logs whose law is known.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"
local fitting = require "tests.fit.fitting"

local dir, root = program.directory(), "tests/reference/fit/"
local binary = os.getenv "POLHODE" or "build/polhode"

local function fit(scene, log, free, options)
  local code, got, err = fitting.run(binary, scene, "--data " .. log .. " --free " .. free .. " " .. (options or ""))
  return code, got or { estimates = {} }, err
end

local function reference(folder)
  return json.read(program.read(root .. folder .. "/case.json")).fits[1]
end

-- Does the fit end at the reference's estimates of these names?
local function arrives(name, code, got, want, names, way)
  local worst = code == 0 and 0 or math.huge
  for i, word in ipairs(names) do
    local e = got.estimates[i]
    worst = math.max(worst, e and math.abs(e.estimate - want.estimate[word]) / want.sigma[word] or math.huge)
  end
  tap.ok(worst <= 1e-6, name .. ": it arrives", worst .. " standard errors apart")
  if way then tap.is(got.way, way, name .. ": by the way that is told") end
end

-- ---- a free body ----

do
  local want, names = reference "01_free_ratios", { "I2", "I3", "w1", "w2", "w3" }
  local SCENE = [[
local I2, I3 = param("I2", GUESS2, "kg m^2"), param("I3", GUESS3, "kg m^2")
local w1, w2, w3 = param("w1", 1, "rad/s"), param("w2", 1, "rad/s"), param("w3", 1, "rad/s")
return scene { name = "tumbling", body = tensor { mass = 1, xx = 1, yy = I2, zz = I3 },
  initial = { omega = RATES }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.004 } }
]]
  local function scene(a, b, rates)
    return (SCENE:gsub("GUESS2", a):gsub("GUESS3", b):gsub("RATES", rates or "{ w1, w2, w3 }"))
  end
  local log = root .. "01_free_ratios/log.csv"
  for _, g in ipairs { { "1.2", "1.5" }, { "2.5", "3" }, { "1.2", "0.5" }, { "30", "30.2" }, { "0.05", "1.01" } } do
    local name = "moments " .. g[1] .. ", " .. g[2]
    local code, got = fit(scene(g[1], g[2]), log, "I2,I3,w1,w2,w3")
    arrives(name, code, got, want, names)
    code, got = fit(scene(g[1], g[2], "{ 1, 1, 1 }"), log, "I2,I3,initial")
    arrives(name .. ", with initial", code, got, want, names, g[1] ~= "1.2" and "linear" or nil)
  end
end

do -- six entries, of which no motion knows the scale: xx is held
  local want = reference "02_free_tensor"
  local code, got = fit([[
local yy, zz = param("yy", 3, "kg m^2"), param("zz", 3, "kg m^2")
local xy, xz, yz = param("xy", 0, "kg m^2"), param("xz", 0, "kg m^2"), param("yz", 0, "kg m^2")
local s = param("s", 2, "1")
return scene { name = "tumbling", body = tensor { mass = 1, xx = 1, yy = yy, zz = zz, xy = xy, xz = xz, yz = yz },
  initial = { omega = { 1, 1, 1 } },
  measure = { wx = wx, wy = wy, wz = s*wz/2, sigma = { wx = 0.004, wy = 0.005, wz = 0.006 } } }
]], root .. "02_free_tensor/log.csv", "yy,zz,xy,xz,yz,initial")
  arrives("a whole tensor", code, got, want, { "yy", "zz", "xy", "xz", "yz" })
end

-- ---- a pendulum near its top, whose period is wrong ----

do
  local want = reference "06a_compound_pendulum"
  local text = [[
local c, om0, th0 = param("c", 0.001, "N m s"), param("om0", 0, "rad/s"), param("th0", 2, "rad")
local I = param("Izz", GUESS, "kg m^2")
return scene { name = "rotor", body = tensor { mass = 1, xx = I, yy = I, zz = I },
  effects = { effect.custom {
    torque = function(m)
      return { 0, 0, -quantity("2.780185275", "N m")*sin(m.angle) - c*m.w[3] }
    end,
    states = { angle = { initial = th0, rate = function(m) return m.w[3] end } } } },
  initial = { omega = { 0, 0, om0 } }, measure = { angle = "angle", sigma = 0.003 },
  ranges = { om0 = {-3, 3}, th0 = {-3, 3} } }
]]
  want.estimate.Izz, want.sigma.Izz = want.estimate.I, want.sigma.I
  for guess, way in pairs { ["0.02"] = "lengthened", ["0.0475"] = false, ["0.2"] = "lengthened" } do -- in any order
    local code, got = fit(text:gsub("GUESS", guess), root .. "06a_compound_pendulum/log.csv", "Izz,c,th0,om0")
    arrives("a pendulum's moment from " .. guess, code, got, want, { "Izz", "c", "th0", "om0" }, way)
  end
end

-- ---- a frequency: one valley of many ----

local function wave(more)
  return [[
local f, a = param("f", 2.6, "rad/s"), param("a", 0.5, "1")
return scene { name = "wave", body = tensor { mass = 1, xx = 1, yy = 1, zz = 1 }, initial = { omega = { 0, 0, 1 } },
  measure = { y = a*sin(f*t), sigma = 0.01 }, ]] .. (more or "") .. " }\n"
end

do -- the log begins late, so no piece of it is short
  local rows = { "t,y" }
  for i = 0, 400 do
    local t = 50 + i * 0.05
    rows[#rows + 1] = string.format("%.2f,%.17g", t, 0.8 * math.sin(2 * t) + (i % 2 - 0.5) * 0.02)
  end
  program.write(dir .. "/wave.csv", table.concat(rows, "\n") .. "\n")
  local code = fit(wave(), dir .. "/wave.csv", "f,a")
  tap.is(code, 3, "a wrong valley is not taken for the answer")
  local got
  code, got = fit(wave "ranges = { f = { 1, 4 } }", dir .. "/wave.csv", "f,a", "--starts 64")
  tap.is(code, 0, "--starts: the valley is found")
  tap.is(got.way, "starts", "by one of the starts")
  -- noise of 0.01 in turn up and down moves both by less than three standard errors
  tap.ok(got.estimates[1] and math.abs(got.estimates[1].estimate - 2) < 3 * got.estimates[1].sigma, "the frequency")
  tap.ok(got.starts == 64 and got.starts_alike >= 1 and got.starts_alike < 64, "how many of them led there is told",
    got.starts_alike)
end

-- ---- what --starts needs ----

local function refused(name, message, scene, options)
  local code, _, err = fit(scene, dir .. "/wave.csv", "f,a", options)
  tap.is(code, 2, name .. ": exit status")
  tap.ok(err:find(message, 1, true) ~= nil, name .. ": says so", err)
end
refused("a value of 0 without a range", "--starts: a is 0, so its range must be given", wave():gsub("0.5, \"1\"",
  "0, \"1\""), "--starts 5")
refused("half a start", "--starts must be a whole number from 0 to 1000, got 1.5", wave(), "--starts 1.5")
refused("too many starts", "--starts must be a whole number from 0 to 1000, got 1001", wave(), "--starts 1001")

program.finish()
tap.done()
