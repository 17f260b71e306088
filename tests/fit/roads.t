#!/usr/bin/env lua5.4
-- roads.t - a fit's answer does not depend on the road to it: starts, order and units of columns, units and names of
-- parameters, a log in two files, gaps, axes, signs of quaternions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each scene is fitted once as it stands and once by each road that it has; what a road changes (names, units, axes) is
-- undone before the two are compared.  Tolerances: the fit's own, 1e-6 standard errors, which are ten times what it
-- leaves; and 1e-6 of covariances, chi-square and the correlations of regions.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local fitting = require "tests.fit.fitting"
local oracle = require "tests.fit.oracle"
local program = require "tests.cli.program"
local tier = require "tests.tier"
local worlds = require "tests.fit.worlds"

local SAME = 1e-6

local dir = program.directory()
local binary = program.quick()

-- ---- scenes ----

-- A free body's gyro alone; its rates at the begin are parameters.
local GYRO = [[
local I2, I3 = param("I2", 1.4, "kg m^2"), param("I3", 1.75, "kg m^2")
local w1, w2, w3 = param("w1", 0.75, "rad/s"), param("w2", 0.95, "rad/s"), param("w3", -0.4, "rad/s")
return scene { name = "gyro", body = tensor { mass = 1, xx = 1, yy = I2, zz = I3 },
  initial = { omega = { w1, w2, w3 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.03 } }
]]

-- {name, text, head, rows (the first cell of each is the time), free, loss}
local function of_world(title, name, rows, share, loss)
  local world = worlds[name]
  local truth = world.truth()
  local log = world.noisy(truth, rows, share)
  local start = worlds.away(truth, 0.02, 0.1, 0.05)
  local case = { name = title, world = world, start = start, text = world.scene(start), head = {}, rows = {},
    free = world.free, loss = loss }
  for word in log.head:gmatch "[^,]+" do case.head[#case.head + 1] = word end
  for i, row in ipairs(log.rows) do case.rows[i] = { log.t[i], table.unpack(row) } end
  return case
end

math.randomseed(20261127)
local function gyro()
  local case = of_world("a gyro, cauchy", "body", 30, 0.1, "cauchy")
  case.world, case.text, case.free = nil, GYRO, "I2,I3,w1,w2,w3"
  case.head = { "t", "wx", "wy", "wz" }
  local times = {}
  for i, row in ipairs(case.rows) do times[i] = row[1] end
  local states = oracle.states(oracle.body { 1, 1.48, 1.83 }, { 1, 0, 0, 0, 0.8, 1, -0.45 }, times, 0.0125)
  for i, row in ipairs(case.rows) do
    local x, k = states[i], i % 7 == 3 and 12 or 1 -- gross errors in each seventh row
    case.rows[i] = { row[1] }
    for j = 1, 3 do case.rows[i][1 + j] = x[4 + j] + 0.03 * k * math.sin(37 * i + 11 * j * j) end
  end
  return case
end

local function wrapped()
  local case = of_world("an angle without its turns", "swing", 60, 0, "squares")
  case.text = case.world.scene { Izz = 1.02, c = 0.05, th0 = 0.5, om0 = 3.05 }
  local log = case.world.noisy({ Izz = 1, c = 0.052, th0 = 0.52, om0 = 3 }, 60, 0)
  for i, row in ipairs(log.rows) do
    case.rows[i] = { log.t[i], row[1] - 2 * math.pi * math.floor(row[1] / (2 * math.pi) + 0.5) }
  end
  return case
end

local SCENES = {
  of_world("a body, squares", "body", 25, 0, "squares"), of_world("a body, huber", "body", 25, 0.1, "huber"),
  of_world("a top", "top", 30, 0, "squares"), of_world("a pendulum, huber", "swing", 35, 0.1, "huber"), wrapped(),
  gyro(),
}

-- ---- roads: each returns a changed case, or nil where a scene has no such road ----

local function with(case, changes) return setmetatable(changes, { __index = case }) end

local function mapped(case, f)
  local rows = {}
  for i, row in ipairs(case.rows) do rows[i] = f(row, i) end
  return rows
end

local function place(case, name)
  for i, word in ipairs(case.head) do
    if word == name then return i end
  end
  return nil
end

-- The numbers of the scene's parameters and their units.
local function params(text, f)
  return (text:gsub('param%("(%w+)", ([%w%.%+%-]+), "([^"]+)"%)', function(name, value, unit)
    return string.format('param("%s", %.17g, "%s")', f(name, tonumber(value), unit))
  end))
end

local ROADS = {}
local function road(name, f) ROADS[#ROADS + 1] = { name, f } end

for i, part in ipairs { 0.01, -0.015, 0.03 } do
  road("another start, " .. i, function(case)
    local world = case.world
    local text = case.world and case.start.q and world.scene(worlds.away(case.start, part, 0.4 * i, 0.1)) or
      params(case.text, function(name, x, unit) return name, x * (1 + part), unit end)
    return with(case, { text = text })
  end)
end

road("columns the other way round", function(case)
  local function turned(row)
    local out = {}
    for i = #row, 1, -1 do out[#out + 1] = row[i] end
    return out
  end
  return with(case, { head = turned(case.head), rows = mapped(case, turned) })
end)

road("columns in ms, degrees and degrees a second", function(case)
  local factor, head = {}, {}
  for i, name in ipairs(case.head) do
    local unit = name == "t" and "ms" or name == "angle" and "deg" or name:find "^w" and "deg/s"
    factor[i] = unit == "ms" and 1e3 or unit and 180 / math.pi or 1
    head[i] = unit and name .. " [" .. unit .. "]" or name
  end
  return with(case, { head = head, rows = mapped(case, function(row)
    local out = {}
    for i, x in ipairs(row) do out[i] = x * factor[i] end
    return out
  end) })
end)

road("parameters in other units", function(case)
  local factor, units = {}, { ["kg m^2"] = { "g m^2", 1e3 }, ["N m"] = { "mN m", 1e3 }, ["N m s"] = { "mN m s", 1e3 },
    ["rad/s"] = { "deg/s", 180 / math.pi }, rad = { "deg", 180 / math.pi } }
  return with(case, { factor = factor, text = params(case.text, function(name, x, unit)
    local to = units[unit]
    factor[name] = to[2]
    return name, x * to[2], to[1]
  end) })
end)

road("parameters of other names, freed in another order", function(case)
  local names, words = {}, {}
  local text = params(case.text, function(name, x, unit)
    names[name] = "p" .. string.char(122 - #words) .. name
    words[#words + 1] = names[name]
    return names[name], x, unit
  end)
  local list = { case.free:find "initial" and "initial" or nil }
  for i = #words, 1, -1 do list[#list + 1] = words[i] end
  return with(case, { text = text, names = names, free = table.concat(list, ",") })
end)

road("the same log as two files", function(case)
  if case.free:find "initial" then return nil end -- each file would have a state of its own
  local half = #case.rows // 2
  return with(case, { parts = { { 1, half }, { half + 1, #case.rows } } })
end)

road("every other row in another file", function(case)
  if case.free:find "initial" then return nil end
  return with(case, { parts = { { 1, #case.rows, 2 }, { 2, #case.rows, 2 } } })
end)

road("rows without a value between the others", function(case)
  local rows = {}
  for i, row in ipairs(case.rows) do
    rows[#rows + 1] = row
    local between = {}
    for k in ipairs(row) do between[k] = "" end
    local at = place(case, "t")
    between[at] = i < #case.rows and (row[at] + case.rows[i + 1][at]) / 2 or nil
    if i < #case.rows then rows[#rows + 1] = between end
  end
  return with(case, { rows = rows })
end)

road("quaternions of the other sign", function(case)
  local first = place(case, "qw")
  return first and with(case, { rows = mapped(case, function(row, i)
    local out = table.move(row, 1, #row, 1, {})
    for k = first, first + 3 do out[k] = (i % 3 == 0 and 1 or -1) * row[k] end
    return out
  end) })
end)

-- The body's axes in turn: (x, y, z) -> (y, z, x), a third of a turn about (1, 1, 1).
road("the body's axes in turn", function(case)
  local from, count = case.text:gsub("xx = 1, yy = I2, zz = I3", "xx = I2, yy = I3, zz = 1")
  if count == 0 or case.name:find "top" then return nil end
  local third, text = { 0.5, 0.5, 0.5, 0.5 }
  if case.world then
    local p = setmetatable({ q = oracle.product(case.start.q, third), w = { case.start.w[2], case.start.w[3],
      case.start.w[1] } }, { __index = case.start })
    text = case.world.scene(p):gsub("xx = 1, yy = I2, zz = I3", "xx = I2, yy = I3, zz = 1")
  else
    text = from:gsub("omega = { w1, w2, w3 }", "omega = { w2, w3, w1 }")
  end
  local q, w = place(case, "qw"), place(case, "wx")
  local names = { ["wx(0)"] = "wz(0)", ["wy(0)"] = "wx(0)", ["wz(0)"] = "wy(0)", turn_x = "turn_z", turn_y = "turn_x",
    turn_z = "turn_y" }
  return with(case, { text = text, names = names, rows = mapped(case, function(row)
    local out = table.move(row, 1, #row, 1, {})
    if q then
      for k, x in ipairs(oracle.product({ table.unpack(row, q, q + 3) }, third)) do out[q - 1 + k] = x end
    end
    out[w], out[w + 1], out[w + 2] = row[w + 1], row[w + 2], row[w]
    return out
  end) })
end)

road("the world turned about the vertical", function(case)
  local first = place(case, "qw")
  if not first then return nil end
  local turn = { math.cos(0.7), 0, 0, math.sin(0.7) }
  local p = setmetatable({ q = oracle.product(turn, case.start.q) }, { __index = case.start })
  p.w = case.start.w
  return with(case, { text = case.world.scene(p), rows = mapped(case, function(row)
    local out = table.move(row, 1, #row, 1, {})
    for k, x in ipairs(oracle.product(turn, { table.unpack(row, first, first + 3) })) do out[first - 1 + k] = x end
    return out
  end) })
end)

-- ---- the comparison ----

local function fit(case)
  local words = { "--free", case.free, "--loss", case.loss }
  for i, part in ipairs(case.parts or { { 1, #case.rows } }) do
    local lines = { table.concat(case.head, ",") }
    for k = part[1], part[2], part[3] or 1 do
      local cells = {}
      for j, x in ipairs(case.rows[k]) do cells[j] = x == "" and x or string.format("%.17g", x) end
      lines[#lines + 1] = table.concat(cells, ",")
    end
    program.write(dir .. "/log" .. i .. ".csv", table.concat(lines, "\n") .. "\n")
    words[#words + 1] = "--data " .. dir .. "/log" .. i .. ".csv"
  end
  local code, got, err = fitting.run(binary, case.text, table.concat(words, " "))
  return code, got or { wrong = { err } }
end

-- The largest differences of estimates (in standard errors) and of covariances, what the road changed undone.
local function apart(first, got, case)
  local at, worst, other = {}, 0, 0
  for i, e in ipairs(got.estimates) do at[e.name] = i end
  local function there(e) return at[case.names and case.names[e.name] or e.name] end
  local function factor(e) return case.factor and case.factor[e.name] or 1 end
  for i, e in ipairs(first.estimates) do
    local a = there(e)
    if not a then return math.huge, math.huge end
    worst = math.max(worst, math.abs(got.estimates[a].estimate / factor(e) - e.estimate) / e.sigma)
    for k, f in ipairs(first.estimates) do
      local c = got.covariance[a][there(f)] / factor(e) / factor(f)
      other = math.max(other, math.abs(c - first.covariance[i][k]) / (e.sigma * f.sigma))
    end
  end
  return worst, other
end

for _, case in ipairs(tier.every(3, SCENES)) do
  local code, first = fit(case)
  if tap.is(code, 0, case.name .. ": it fits") then
    for _, way in ipairs(ROADS) do
      local changed, label = way[2](case), case.name .. ", " .. way[1]
      if changed then
        local status, got = fit(changed)
        if tap.is(status, 0, label .. ": it fits") then
          local worst, other = apart(first, got, changed)
          tap.ok(worst < SAME, label .. ": the same estimates", worst)
          tap.ok(other < SAME, label .. ": the same covariance, so the same regions", other)
          tap.ok(math.abs(got.chi2 / first.chi2 - 1) < SAME and got.n == first.n, label .. ": the same residuals",
            got.chi2 .. " for " .. first.chi2)
        else
          tap.diag(table.concat(got.wrong, "; "))
        end
      end
    end
  else
    tap.diag(table.concat(first.wrong, "; "))
  end
end

program.finish()
tap.done()
