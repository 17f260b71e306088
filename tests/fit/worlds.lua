-- worlds.lua - small scenes with logs for tests of the fit: a free body, a heavy top, a damped pendulum.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each is {free = for --free, truth() -> p, noisy(p, rows, share) -> log, scene(p) -> text, model(log) -> for
-- tests/fit/oracle.lua, csv(log) -> text, of(json) -> p}.  p has the parameters by name and q, w (initial attitude and
-- rates) where the scene has them.  share: of values that are gross errors.

local oracle = require "tests.fit.oracle"

local worlds = {}

local SIGMA_Q, SIGMA_W, SIGMA_A = 0.05, 0.03, 0.02
local STEP = 0.0125 -- of the oracle's motions: for w = 2 rad/s their error is of 1e-9 rad a second; half of it
-- for a pendulum, which may stop near its top

local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

function worlds.turn() -- a direction
  local x, y, z = normal(), normal(), normal()
  local n = math.sqrt(x * x + y * y + z * z)
  return x / n, y / n, z / n
end

-- Noise of sigma; a share of it 4 to 20 times as large.
local function noise(sigma, share)
  local gross = math.random() < share and (4 + 16 * math.random()) * (math.random() < 0.5 and -1 or 1) or 0
  return sigma * (normal() + gross)
end

local function times(rows, spacing)
  local list = {}
  for i = 1, rows do list[i] = (i - 1) * spacing end
  return list
end

local function csv(log)
  local lines = { log.head }
  for i, row in ipairs(log.rows) do
    local cells = { string.format("%.17g", log.t[i]) }
    for k, x in ipairs(row) do cells[k + 1] = string.format("%.17g", x) end
    lines[#lines + 1] = table.concat(cells, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

local function copied(p)
  local out = {}
  for k, x in pairs(p) do out[k] = x end -- in any order
  return out
end

-- Of the fit's JSON: parameters, and the initial state where it has one.
local function of(got)
  local p, w = {}, {}
  for _, e in ipairs(got.estimates) do p[e.name] = e.estimate end
  for i, name in ipairs { "wx(0)", "wy(0)", "wz(0)" } do w[i] = p[name] end
  p.q, p.w = got.initial_attitudes[1], w
  return p
end

-- What the two bodies share: first the parameters `names`, then turns and rates; rate(p) of the motion.
local function body(names, free, gyro, rate, truth, scene)
  local all = table.move(names, 1, #names, 1, {})
  for _, word in ipairs { "turn_x", "turn_y", "turn_z", "wx(0)", "wy(0)", "wz(0)" } do all[#all + 1] = word end
  local function states(p, t)
    return oracle.states(rate(p), { p.q[1], p.q[2], p.q[3], p.q[4], p.w[1], p.w[2], p.w[3] }, t, STEP)
  end
  local world = { free = free, truth = truth, scene = scene, csv = csv, of = of }
  function world.noisy(p, rows, share)
    local log = { head = "t,qw,qx,qy,qz" .. (gyro and ",wx,wy,wz" or ""), t = times(rows, 0.2), rows = {} }
    for i, x in ipairs(states(p, log.t)) do
      local q = oracle.turned(x, noise(SIGMA_Q, share), noise(SIGMA_Q, share), noise(SIGMA_Q, share))
      local sign = math.random() < 0.5 and -1 or 1
      local row = { sign * q[1], sign * q[2], sign * q[3], sign * q[4] }
      for k = 1, gyro and 3 or 0 do row[4 + k] = x[4 + k] + noise(SIGMA_W, share) end
      log.rows[i] = row
    end
    return log
  end
  function world.moved(p, d)
    local out = copied(p)
    for i, name in ipairs(names) do out[name] = p[name] + d[i] end
    local n = #names
    out.q = oracle.turned(p.q, d[n + 1], d[n + 2], d[n + 3])
    out.w = { p.w[1] + d[n + 4], p.w[2] + d[n + 5], p.w[3] + d[n + 6] }
    return out
  end
  function world.model(log)
    return { names = all, moved = world.moved, residuals = function(p)
      local z = {}
      for i, x in ipairs(states(p, log.t)) do
        local row = log.rows[i]
        for _, r in ipairs(oracle.between(x, row)) do z[#z + 1] = r / SIGMA_Q end
        for k = 1, gyro and 3 or 0 do z[#z + 1] = (row[4 + k] - x[4 + k]) / SIGMA_W end
      end
      return z
    end }
  end
  return world
end

local function numbers(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = string.format("%.17g", x) end
  return table.concat(out, ", ")
end

worlds.body = body({ "I2", "I3" }, "I2,I3,initial", true, function(p) return oracle.body { 1, p.I2, p.I3 } end,
  function()
    return { I2 = 1.2 + 0.3 * math.random(), I3 = 1.55 + 0.3 * math.random(), q = oracle.turned({ 1, 0, 0, 0 },
      normal(), normal(), normal()), w = { 0.5 + math.random(), 0.5 + math.random(), -math.random() } }
  end,
  function(p)
    return string.format([[
local I2, I3 = param("I2", %.17g, "kg m^2"), param("I3", %.17g, "kg m^2")
return scene { name = "body", body = tensor { mass = 1, xx = 1, yy = I2, zz = I3 },
  initial = { omega = { %s }, attitude = { %s } },
  measure = { attitude = "q", gyro = { wx, wy, wz }, columns = { gyro = { "wx", "wy", "wz" } },
    sigma = { attitude = %g, gyro = %g } } }
]], p.I2, p.I3, numbers(p.w), numbers(p.q), SIGMA_Q, SIGMA_W)
  end)

worlds.top = body({ "I3", "M" }, "I3,M,initial", false, function(p)
  return oracle.body({ 1, 1, p.I3 }, function(q)
    return { 2 * p.M * (q[3] * q[4] + q[1] * q[2]), -2 * p.M * (q[2] * q[4] - q[1] * q[3]), 0 }
  end)
end, function()
  return { I3 = 0.5 + 0.2 * math.random(), M = 0.4 + 0.4 * math.random(), q = oracle.turned({ 1, 0, 0, 0 }, 0.6, 0.4 *
    math.random(), math.random()), w = { 0.2 * normal(), 0.2 * normal(), 1.5 + 0.5 * math.random() } }
end, function(p)
  return string.format([[
local I3, M = param("I3", %.17g, "kg m^2"), param("M", %.17g, "N m")
return scene { name = "top", body = tensor { mass = 1, xx = 1, yy = 1, zz = I3 },
  effects = { effect.custom { torque = function(m)
    local q = m.q
    return { 2*M*(q[3]*q[4] + q[1]*q[2]), -2*M*(q[2]*q[4] - q[1]*q[3]), 0 }
  end } },
  initial = { omega = { %s }, attitude = { %s } }, measure = { attitude = "q", sigma = %g } }
]], p.I3, p.M, numbers(p.w), numbers(p.q), SIGMA_Q)
end)

-- An angle about z: I th'' = -sin th - c th'.
local SWING = { "Izz", "c", "th0", "om0" }
worlds.swing = {
  free = table.concat(SWING, ","), csv = csv, of = of,
  truth = function()
    return { Izz = 0.8 + 0.4 * math.random(), c = 0.1 * math.random(), th0 = 2 * normal(), om0 = normal() }
  end,
  scene = function(p)
    return string.format([[
local I, c = param("Izz", %.17g, "kg m^2"), param("c", %.17g, "N m s")
local th0, om0 = param("th0", %.17g, "rad"), param("om0", %.17g, "rad/s")
return scene { name = "swing", body = tensor { mass = 1, xx = I, yy = I, zz = I },
  effects = { effect.custom {
    torque = function(m) return { 0, 0, -quantity("1", "N m")*sin(m.angle) - c*m.w[3] } end,
    states = { angle = { initial = th0, rate = function(m) return m.w[3] end } } } },
  initial = { omega = { 0, 0, om0 } }, measure = { angle = "angle", sigma = %g } }
]], p.Izz, p.c, p.th0, p.om0, SIGMA_A)
  end,
  moved = function(p, d)
    local out = {}
    for i, name in ipairs(SWING) do out[name] = p[name] + d[i] end
    return out
  end,
}

local function swung(p, t)
  return oracle.states(function(x) return { x[2], (-math.sin(x[1]) - p.c * x[2]) / p.Izz } end, { p.th0, p.om0 }, t,
    STEP / 2)
end

function worlds.swing.noisy(p, rows, share)
  local log = { head = "t,angle", t = times(rows, 0.2), rows = {} }
  for i, x in ipairs(swung(p, log.t)) do log.rows[i] = { x[1] + noise(SIGMA_A, share) } end
  return log
end

function worlds.swing.model(log)
  return { names = SWING, moved = worlds.swing.moved, residuals = function(p)
    local z = {}
    for i, x in ipairs(swung(p, log.t)) do z[i] = (log.rows[i][1] - x[1]) / SIGMA_A end
    return z
  end }
end

-- A start: parameters off by up to `part`, a turn of `angle` and rates off by up to `rate`.
function worlds.away(p, part, angle, rate)
  local out = {}
  for name, x in pairs(p) do -- in any order
    out[name] = type(x) == "number" and x * (1 + part) or x
  end
  if p.q then
    local x, y, z = worlds.turn()
    out.q = oracle.turned(p.q, angle * x, angle * y, angle * z)
    x, y, z = worlds.turn()
    out.w = { p.w[1] + rate * x, p.w[2] + rate * y, p.w[3] + rate * z }
  end
  return out
end

return worlds
