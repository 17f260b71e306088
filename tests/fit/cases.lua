-- cases.lua - scenes for the reference cases of tests/reference/fit, as a user would write them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A list of {folder, fit = number of the fit in case.json, free = for --free (its order is that of case.json), scene,
-- data = logs, sigma = comment lines by log (where logs differ), loss,
-- input = file of inputs, on straight lines}.  GUESS in a scene's param is the case's guess.

local cases = {}

local FREE = [[
local I1, I2, I3 = param("I1", 1, "kg m^2"), param("I2", GUESS, "kg m^2"), param("I3", GUESS, "kg m^2")
local w1, w2, w3 = param("w1", GUESS, "rad/s"), param("w2", GUESS, "rad/s"), param("w3", GUESS, "rad/s")
return scene { name = "tumbling", body = tensor { mass = 1, xx = I1, yy = I2, zz = I3 },
  initial = { omega = { w1, w2, w3 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = SIGMA } }
]]

local TENSOR = [[
local xx, yy, zz = param("xx", GUESS, "kg m^2"), param("yy", GUESS, "kg m^2"), param("zz", GUESS, "kg m^2")
local xy, xz, yz = param("xy", GUESS, "kg m^2"), param("xz", GUESS, "kg m^2"), param("yz", GUESS, "kg m^2")
local w1, w2, w3 = param("w1", GUESS, "rad/s"), param("w2", GUESS, "rad/s"), param("w3", GUESS, "rad/s")
return scene { name = "tumbling", body = tensor { mass = 1, xx = xx, yy = yy, zz = zz, xy = xy, xz = xz, yz = yz },
  initial = { omega = { w1, w2, w3 } }, EFFECTS
  measure = { gyro = { wx, wy, wz }, columns = { gyro = { "wx", "wy", "wz" } }, sigma = { gyro = SIGMA } } }
]]

local GYRO = [[
local I1, I2, I3 = param("I1", GUESS, "kg m^2"), param("I2", GUESS, "kg m^2"), param("I3", GUESS, "kg m^2")
local w1, w2, w3 = param("w1", GUESS, "rad/s"), param("w2", GUESS, "rad/s"), param("w3", GUESS, "rad/s")
local b1, b2, b3 = param("b1", GUESS, "rad/s"), param("b2", GUESS, "rad/s"), param("b3", GUESS, "rad/s")
local s, s1, s2, s3 = param("s", GUESS, "1"), param("s1", GUESS, "1"), param("s2", GUESS, "1"), param("s3", GUESS, "1")
return scene { name = "tumbling", body = tensor { mass = 1, xx = I1, yy = I2, zz = I3 },
  initial = { omega = { w1, w2, w3 } },
  measure = { wx = (1 + s + s1)*wx + b1, wy = (1 + s + s2)*wy + b2, wz = (1 + s + s3)*wz + b3, sigma = SIGMA } }
]]

local FRICTION = [[
local I1, I2, I3 = param("I1", GUESS, "kg m^2"), param("I2", GUESS, "kg m^2"), param("I3", GUESS, "kg m^2")
local c, T = param("c", GUESS, "N m s"), param("T", GUESS, "N m")
local w1, w2, w3 = param("w1", GUESS, "rad/s"), param("w2", GUESS, "rad/s"), param("w3", GUESS, "rad/s")
local slow = quantity("0.05", "rad/s")
return scene { name = "tumbling", body = tensor { mass = 1, xx = I1, yy = I2, zz = I3 },
  effects = { effect.custom { torque = function(m)
    local w = m.w
    local k = c + T/sqrt(w[1]*w[1] + w[2]*w[2] + w[3]*w[3] + slow*slow)
    return { -k*w[1], -k*w[2], -k*w[3] }
  end } },
  initial = { omega = { w1, w2, w3 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = SIGMA } }
]]

-- About an axis that is fixed by symmetry: the angle is a state of its own, and counts the turns.
local AXIS = [[
local c, om0, th0 = param("c", GUESS, "N m s"), param("om0", GUESS, "rad/s"), param("th0", GUESS, "rad")
local I = param("Izz", GUESS, "kg m^2")
PARAMS
return scene { name = "rotor", body = tensor { mass = 1, xx = I, yy = I, zz = I },
  effects = { effect.custom {
    torque = function(m) local th, w = m.angle, m.w[3]; return { 0, 0, TORQUE } end,
    states = { angle = { initial = th0, rate = function(m) return m.w[3] end } },
  } },
  initial = { omega = { 0, 0, om0 } }, measure = { angle = "angle", sigma = SIGMA } }
]]

local TOP = [[
local I1, I3 = param("I1", 1, "kg m^2"), param("I3", GUESS, "kg m^2")
local M = param("M", GUESS, "N m")
return scene { name = "top", body = tensor { mass = 1, xx = I1, yy = I1, zz = I3 },
  effects = { effect.custom { torque = function(m)
    local q = m.q
    return { 2*M*(q[3]*q[4] + q[1]*q[2]), -2*M*(q[2]*q[4] - q[1]*q[3]), 0 }
  end } },
  initial = { omega = { 0.28, -0.19, 39.97 },
    attitude = { 0.9539866442804695, 0.28599599608408205, 0.0899987400264594, 0.0039999440011759735 } },
  measure = { attitude = "q", sigma = SIGMA } }
]]

-- Wheels at known speeds: J (S' + w x S) pushes the body the other way; S on lines, S' their slope.
local WHEELS = TENSOR:gsub("return scene", [[
local J, s, a = quantity("0.005", "kg m^2"), {}, {}
for i = 1, 3 do s[i], a[i] = input("speed" .. i, "rad/s"), input("speed" .. i .. "_rate", "rad/s^2") end
return scene]]):gsub("EFFECTS", [[
  effects = { effect.custom { torque = function(m)
    local w = m.w
    return { J*(s[2]*w[3] - s[3]*w[2] - a[1]), J*(s[3]*w[1] - s[1]*w[3] - a[2]), J*(s[1]*w[2] - s[2]*w[1] - a[3]) }
  end } },]])

-- A platform on three filaments: the angle and its rate are states of the scene's own, beside a body that rests.
local TRIFILAR = [[
local I, c = param("Izz", GUESS, "kg m^2"), param("c", GUESS, "N m s")
local th0, om0 = param("th0", GUESS, "rad"), param("om0", GUESS, "rad/s")
local mass, R, r, S = quantity("4.2", "kg"), quantity("0.12", "m"), quantity("0.1", "m"), quantity("0.9", "m")
local g = quantity("9.80665", "m/s^2")
local function rate(m)
  local h = sqrt(S*S - R*R - r*r + 2*R*r*cos(m.theta)) -- depth below the ceiling, and its derivatives by the angle
  local h1 = -R*r*sin(m.theta)/h
  local h2 = -(R*r*cos(m.theta) + h1*h1)/h
  return (mass*g*h1 - mass*h1*h2*m.spin*m.spin - c*m.spin)/(I + mass*h1*h1)
end
return scene { name = "trifilar", body = tensor { mass = 1, xx = 1, yy = 1, zz = 1 },
  effects = { effect.custom { states = {
    theta = { initial = th0, unit = "rad", rate = function(m) return m.spin end },
    spin = { initial = om0, unit = "rad/s", rate = rate } } } },
  measure = { angle = "theta", sigma = SIGMA } }
]]

local function put(folder, free, scene, more)
  more.folder, more.free, more.scene = folder, free, scene
  more.fit, more.data = more.fit or 1, more.data or { "log.csv" }
  cases[#cases + 1] = more
end

local function pulses(rows)
  local out = { {}, {}, {} }
  for line in rows:gmatch "[^\n]+" do
    local t, x, y, z = line:match "^([%d.]+),([-%d.]+),([-%d.]+),([-%d.]+)$"
    for i, v in ipairs { t and x, y, z } do
      if t then out[i][#out[i] + 1] = "{" .. t .. ", " .. v .. "}" end
    end
  end
  for i = 1, 3 do out[i] = "{" .. table.concat(out[i], ", ") .. "}" end
  return "effects = { effect.torque { body = {" .. table.concat(out, ", ") .. "} } },"
end

local function axis(params, torque)
  local map = { PARAMS = params, TORQUE = torque }
  return (AXIS:gsub("%f[%w]%u%u%u%u%u%u%f[^%w]", map))
end

cases.pulses = pulses
put("01_free_ratios", "I2,I3,w1,w2,w3", FREE, { sigma_text = "0.004" })
put("02_free_tensor", "yy,zz,xy,xz,yz,w1,w2,w3", TENSOR:gsub("EFFECTS", ""), { sigma_text = "{0.004, 0.005, 0.006}" })
put("03_torque_pulses", "xx,yy,zz,xy,xz,yz,w1,w2,w3", TENSOR, { sigma_text = "0.002", table_file = "torque.csv" })
put("04a_gyro_bias_common_scale", "I2,I3,w1,w2,w3,b1,b2,b3,s", GYRO, { sigma_text = "0.003" })
put("04b_gyro_bias_axis_scales", "w1,w2,w3,b1,b2,b3,s1,s2,s3", GYRO, { sigma_text = "0.003" })
put("05a_spin_down_tumbling", "c,T,w1,w2,w3", FRICTION, { sigma_text = "0.01" })
put("05a_spin_down_tumbling", "I2,I3,c,T,w1,w2,w3", FRICTION, { sigma_text = "0.01", fit = 2 })
put("05b_spin_down_rotor", "c,T,th0,om0", axis('local T = param("T", GUESS, "N m")', "-c*w - T"),
  { sigma_text = "0.01" })
put("06a_compound_pendulum", "Izz,c,th0,om0", axis('local m0, l = param("m", GUESS, "kg"), param("l", GUESS, "m")',
  '-m0*quantity("9.80665", "m/s^2")*l*sin(th) - c*w'), { sigma_text = "0.003" })
put("07_heavy_top", "I3,M,initial", TOP, { sigma_text = "0.008" })
put("08_outliers", "I2,I3,w1,w2,w3", FREE, { sigma_text = "0.004", loss = "huber" })
put("08_outliers", "I2,I3,w1,w2,w3", FREE, { sigma_text = "0.004", fit = 2 })
put("09_two_logs_gaps", "I2,I3,initial", (FREE:gsub("local w1.-\n", ""):gsub("{ w1, w2, w3 }", "{ 0.5, 1.3, 0.4 }")),
  { sigma_text = "1", data = { "a.csv" }, fit = 2, sigma = { "# sigma: , 0.005, 0.005, 0.008\n" } })
put("09_two_logs_gaps", "I2,I3,initial", (FREE:gsub("local w1.-\n", ""):gsub("{ w1, w2, w3 }", "{ 0.5, 1.3, 0.4 }")),
  { sigma_text = "1", data = { "a.csv", "b.csv" },
    sigma = { "# sigma: , 0.005, 0.005, 0.008\n", "# sigma: , 0.01, 0.004, 0.004\n" } })
put("06b_trifilar", "Izz,c,th0,om0", TRIFILAR, { sigma_text = "0.004" })
put("11_wheel_driven", "xx,yy,zz,xy,xz,yz,w1,w2,w3", WHEELS, { sigma_text = "0.0002", input = "wheels.csv" })
put("12a_near_symmetric_short_arc", "I2,I3,w1,w2,w3", FREE, { sigma_text = "0.0004" })
put("12a_near_symmetric_short_arc", "I3,w1,w2,w3", FREE, { sigma_text = "0.0004", fit = 2 })
put("12b_pure_spin", "w1,w2,w3", FREE, { sigma_text = "0.004" })

return cases
