#!/usr/bin/env lua5.4
-- design.t - polhode design: the errors that it foretells are those that a fit of the log then has.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: covariances that others computed (tests/reference/fit, at the estimates, for logs without gaps), the
-- covariance that polhode fit states for a log of the same motion, and a rotor whose information is a sum in closed
-- form.  Covariances are compared in parts of the product of the standard errors.  The program halves its step until
-- they move by less than 1e-6 (SETTLED in src/cli/fit/design.c).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"
local cases = require "tests.fit.cases"

local dir, root = program.directory(), "tests/reference/fit/"
local binary = os.getenv "POLHODE" or "build/polhode"
local STEP = 1e-5 -- ten times what the step is settled to
local ROUNDED = "a power and a sum"
local WHY = "the integration's step is settled to a tenth of it"

local function run(command, text)
  if text then program.write(dir .. "/scene.lua", text) end
  return program.output(binary .. " " .. command)
end

local function design(more, text)
  local code, out, err = run("design " .. dir .. "/scene.lua --format json " .. more, text)
  return code, code ~= 1 and code ~= 2 and json.read(out) or { candidates = {} }, err
end

local function apart(a, b)
  local worst = 0
  for i = 1, #b do
    for k = 1, #b do
      local x = math.abs(a[i][k] - b[i][k]) / math.sqrt(b[i][i] * b[k][k])
      worst = x <= worst and worst or x
    end
  end
  return worst
end

-- ---- the reference's covariances ----

local REGULAR = { ["01_free_ratios"] = true, ["02_free_tensor"] = true, ["03_torque_pulses"] = true,
  ["04a_gyro_bias_common_scale"] = true, ["04b_gyro_bias_axis_scales"] = true, ["05a_spin_down_tumbling"] = true,
  ["05b_spin_down_rotor"] = true, ["06a_compound_pendulum"] = true, ["12a_near_symmetric_short_arc"] = true }

-- Rate and end of a log; nil if its times are not those of a design.
local function times(path)
  local list = {}
  for line in program.read(path):gmatch "[^\n]+" do list[#list + 1] = tonumber(line:match "^([%d.e+-]+),") end
  local spacing = list[#list] / (#list - 1)
  for i, t in ipairs(list) do
    if math.abs(t - (i - 1) * spacing) > 1e-9 * list[#list] then return nil end
  end
  return 1 / spacing, list[#list], #list
end

for _, case in ipairs(cases) do
  if REGULAR[case.folder] then
    local data = json.read(program.read(root .. case.folder .. "/case.json"))
    local fit, text = data.fits[case.fit], case.scene
    if case.table_file then
      text = text:gsub("EFFECTS", cases.pulses(program.read(root .. case.folder .. "/" .. case.table_file)))
    end
    text = text:gsub("SIGMA", case.sigma_text):gsub('param%("(%w+)", GUESS', function(name)
      local word = name == "Izz" and "I" or name -- I is a macro of C
      local p = data.parameters[word]
      local value = fit.estimate[word] or fit.fixed[word] or p and p["true"] or 0
      return string.format('param("%s", "%.17g"', name, value)
    end)
    local rate, finish, rows = times(root .. case.folder .. "/log.csv")
    local name = case.folder .. ", " .. fit.name
    local code, got, err = design(string.format("--free %s --rate %.17g --until %.17g", case.free, rate or 1,
      finish or 1), text)
    if tap.is(code, 0, name .. ": exit status") then
      tap.is(got.rows, rows, name .. ": as many rows as the log has")
      local far = apart(got.candidates[1].covariance, fit.covariance)
      tap.ok(far < STEP, name .. ": the covariance is the reference's", far)
    else
      tap.diag(err)
    end
  end
end

-- ---- a rotor in closed form ----

-- w = w0 exp(-k t), k = c/I, each row with sigma: F over (c, w0) is the sum of (-t w0/I, 1)' (-t w0/I, 1) times
-- exp(-2 k t)/sigma^2.  D, A and E are those of the 2 x 2 matrix of relative errors.
local ROTOR = [[
local c, w0 = param("c", 0.3, "N m s"), param("w0", 4, "rad/s")
return scene { name = "rotor", body = tensor { mass = 1, xx = 2, yy = 2, zz = 2 },
  effects = { effect.damping { c = c } },
  initial = { omega = { 0, 0, w0 } }, measure = { wz = wz, sigma = 0.01 } }
]]
do
  local function closed(c, w0, rows, spacing)
    local a, b, d, s2, I = 0, 0, 0, 0.01 ^ 2, 2
    for i = 0, rows - 1 do
      local t = i * spacing
      local e = math.exp(-2 * c / I * t) / s2
      a, b, d = a + (t * w0 / I) ^ 2 * e, b - t * w0 / I * e, d + e
    end
    local det = a * d - b * b
    return { { d / det, -b / det }, { -b / det, a / det } }
  end
  local code, got = design("--free c,w0 --over w0=1:4:4 --rate 20 --until 15", ROTOR)
  tap.is(code, 0, "rotor: exit status")
  tap.is(#got.candidates, 4, "rotor: every candidate is there")
  for i, one in ipairs(got.candidates) do
    local C = closed(0.3, i, 301, 0.05)
    tap.ok(apart(one.covariance, C) < STEP, "rotor, w0 = " .. i .. ": Fisher's information in closed form")
    local a, b, d = C[1][1] / 0.3 ^ 2, C[1][2] / (0.3 * 4), C[2][2] / 4 ^ 2 -- relative to the scene's own values
    local half = math.sqrt((a - d) ^ 2 / 4 + b * b)
    tap.near(one.D, (a * d - b * b) ^ 0.25, 0, STEP, "rotor: D is the geometric mean", WHY)
    tap.near(one.A, math.sqrt((a + d) / 2), 0, STEP, "rotor: A is the root of the mean square", WHY)
    tap.near(one.E, math.sqrt((a + d) / 2 + half), 0, STEP, "rotor: E is the largest axis", WHY)
  end
  tap.is(got.best, 4, "rotor: the fastest tells most")
  code, got = design("--free c,w0 --of c --rate 20 --until 15")
  local C = closed(0.3, 4, 301, 0.05)
  local one = code == 0 and got.candidates[1] or { D = 0, E = 0 }
  tap.near(one.D, math.sqrt(C[1][1]) / 0.3, 0, STEP, "--of: one parameter counts, the other is not known either", WHY)
  tap.near(one.E, one.D, 0, STEP, "--of: of one number the three are the same", WHY)
end

-- ---- what polhode fit states ----

-- A heavy top with its attitude, whose log is printed by polhode run: the fit of it begins at the truth.
do
  local text = [[
local I3, M = param("I3", 0.6, "kg m^2"), param("M", 2, "N m")
return scene { name = "top", body = tensor { mass = 1, xx = 1, yy = 1, zz = I3 },
  effects = { effect.custom { torque = function(m)
    local q = m.q
    return { 2*M*(q[3]*q[4] + q[1]*q[2]), -2*M*(q[2]*q[4] - q[1]*q[3]), 0 }
  end } },
  initial = { omega = { 0.3, -0.2, 9 }, attitude = { 0.9, 0.3, 0.1, 0.2 } }, time = { step = 0.001, horizon = 4 },
  measure = { attitude = "q", gyro = { wx, wy, wz }, columns = { gyro = { "wx", "wy", "wz" } },
    sigma = { attitude = { 0.01, 0.02, 0.01 }, gyro = 0.05 } } }
]]
  local code = run("run " .. dir .. "/scene.lua --method rk4 --every 0.02 --until 4 --columns " ..
    "t,qw,qx,qy,qz,wx,wy,wz -o " .. dir .. "/top.csv", text)
  tap.is(code, 0, "top: a log")
  local got, out, found
  code, out = run("fit " .. dir .. "/scene.lua --data " .. dir .. "/top.csv --free I3,M,initial --format json")
  got = code == 0 and json.read(out) or {}
  code, found = design("--free I3,M,initial --rate 50")
  if tap.is(code, 0, "top: exit status") and tap.ok(got.covariance ~= nil, "top: its log is fitted") then
    local far = apart(found.candidates[1].covariance, got.covariance)
    tap.ok(far < STEP, "top: what is foretold is what the fit states", far)
  end
end

-- A body with motors: the torques of two files are two candidates.
do
  local text = [[
local xx, yy, zz = param("xx", 1.2, "kg m^2"), param("yy", 1.4, "kg m^2"), param("zz", 1.8, "kg m^2")
local mx, my = input("mx", "N m"), input("my", "N m")
return scene { name = "driven", body = tensor { mass = 1, xx = xx, yy = yy, zz = zz },
  initial = { omega = { 0.1, 0.2, -0.1 } }, effects = { effect.torque { body = { mx, my, 0 } } },
  time = { step = 0.001, horizon = 4 }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.004 } }
]]
  program.write(dir .. "/weak.csv", "t,mx,my\n0,0,0\n1,0.5,0\n2,0,0\n")
  program.write(dir .. "/strong.csv", "t,mx,my\n0,0,0\n1,0.5,0.5\n2,-0.5,0\n3,0,0\n")
  local code, found = design(string.format("--free xx,yy,zz,initial --rate 50 --between linear --input %s/weak.csv " ..
    "--input %s/strong.csv", dir, dir), text)
  tap.is(code, 0, "driven: exit status")
  tap.is(found.best, 2, "driven: the stronger torque tells more")
  for i, file in ipairs { "weak", "strong" } do
    code = run(string.format("run %s/scene.lua --method rk4 --every 0.02 --columns t,wx,wy,wz --input %s/%s.csv " ..
      "--between linear -o %s/driven.csv", dir, dir, file, dir))
    tap.is(code, 0, "driven, " .. file .. ": a log")
    local out
    code, out = run(string.format("fit %s/scene.lua --data %s/driven.csv --input %s/%s.csv --between linear " ..
      "--free xx,yy,zz,initial --format json", dir, dir, dir, file))
    local got, one = code == 0 and json.read(out) or {}, found.candidates[i]
    local far = got.covariance and one and apart(one.covariance, got.covariance) or 1
    tap.ok(far < STEP, "driven, " .. file .. ": what is foretold is what the fit states", far)
  end
end

-- ---- what cannot be known ----

local BODY = [[
local I1, I2, I3 = param("I1", 1, "kg m^2"), param("I2", 1.4, "kg m^2"), param("I3", 1.8, "kg m^2")
local A = param("A", 0, "N m")
return scene { name = "body", body = tensor { mass = 1, xx = I1, yy = I2, zz = I3 },
  effects = { effect.torque { body = { {{0, 0}, {0.5, A}, {1, 0}}, 0, 0 } } },
  initial = { omega = { 0.9, 1.1, -0.4 } }, time = { horizon = 5 },
  measure = { wx = wx, wy = wy, wz = wz, MORE sigma = 0.004 } }
]]
do
  local text = BODY:gsub("MORE", "")
  local code, got = design("--free I1,I2,I3,initial", text)
  tap.is(code, 3, "three moments without a torque: no candidate, exit status 3")
  tap.is(got.best, json.null, "and no best one")
  tap.ok((got.candidates[1].not_determined[1] or ""):find("I1, I2, I3: only their ratios are determined", 1, true),
    "their scale is named")
  code, got = design("--free I1,I2,I3,initial --over A=0:2:3")
  tap.is(code, 0, "with a pulse among the candidates there is one")
  tap.is(got.best, 3, "and the strongest pulse tells most")
  tap.is(got.candidates[1].D, json.null, "without the pulse it is not determined")
  code, got = design("--free I2,I3,initial --over wx=0:1:2,wy=0,wz=1")
  tap.is(code, 0, "a spin about a principal axis among the candidates")
  tap.is(got.candidates[1].D, json.null, "tells no ratio")
  local _, out = run("design " .. dir .. "/scene.lua --free I2,I3,initial --over wx=0:1:2,wy=0,wz=1")
  tap.ok(out:find("by 1 of 2: ", 1, true), "and the text counts who does not tell", out)
  code, got = design("--free I2,I3 --over I2=-1:1.4:2")
  tap.is(code, 0, "a candidate that is no body")
  tap.ok(got.candidates[1].refused, "is refused, and the others are not")
  code = design("--free I2,I3,initial --candidates 8 --vary 'wx=uniform(-2,2),wy=loguniform(0.1,2)'")
  tap.is(code, 0, "candidates in ranges")
  local _, first = design("--free I2,I3,initial --candidates 3 --vary 'wx=uniform(-2,2),wy=loguniform(0.1,10)'")
  tap.near(first.candidates[1].values.wx, 0, 1e-15, 0, "Halton's first point is the middle in base 2", ROUNDED)
  tap.near(first.candidates[1].values.wy, 0.1 * 100 ^ (1 / 3), 0, 1e-14, "and a third of the way in base 3", ROUNDED)
end

-- ---- mistakes ----

local function refused(name, status, message, more, text)
  local code, _, err = design(more, text)
  tap.is(code, status, name .. ": exit status")
  tap.ok(err:find(message, 1, true) ~= nil, name .. ": says so", err)
end
refused("nothing free", 2, "--free NAME,... is missing", "")
refused("no such parameter", 2, "--free must be some of", "--free I4")
refused("no such candidate", 2, "--over: v is no parameter and no state", "--free I2 --over v=1")
refused("a normal distribution", 2, "must be uniform(LOW,HIGH)", "--free I2 --candidates 2 --vary 'wx=normal(0,1)'")
refused("ranges without a number", 2, "--candidates N says how many", "--free I2 --vary 'wx=uniform(0,1)'")
refused("an attitude", 2, "turn_x: a design chooses parameters and rates", "--free I2 --over turn_x=0:1:2")
refused("a rate of 0", 2, "--rate must be positive", "--free I2 --rate 0")
refused("a log of one row", 2, "there must be two rows or more", "--free I2 --rate 1 --until 0.5")
refused("too many rows", 2, "are too many", "--free I2 --rate 1e9")
refused("what is not free", 2, "--of must be some of I2", "--free I2,initial --of I3")
refused("an input for a scene without one", 2, "--input: the scene has no inputs", "--free I2 --input x.csv",
  (BODY:gsub("MORE", "")))
refused("no measure", 1, "has no key measure", "--free I2", (BODY:gsub("measure = %b{}", "")))
refused("no sigma", 1, "sigma must be given", "--free I2", (BODY:gsub("MORE sigma = 0.004", "")))
refused("a state that nothing measures", 2, "rx: nothing that is measured depends on it", "--free c --over rx=1:2:2",
  (ROTOR:gsub("effects = { ", "effects = { effect.translation {}, ")))

program.finish()
tap.done()
