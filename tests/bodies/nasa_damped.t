#!/usr/bin/env lua5.4
-- nasa_damped.t - NASA's brick that falls and is damped by the air, check case 3, against five published simulations.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/reference/nesc_case3.lua: rates (inertial, deg/s) and yaw, pitch, roll (deg) every half second for 30 s, from
-- NASA/TM-2015-218675.  The simulations differ by up to 0.07 deg/s and 0.7 deg: two damp the rates relative to the
-- Earth, one has a step of its own.  The spread of a quantity is the largest distance between two of them in the 30 s.
-- Within the spread: at every time between the least and the greatest of the five, widened by a hundredth of the
-- spread on each side.  That margin stands for gravity and density, which the five have from models of their own (the
-- scene's gravity is good to 1e-5, so angles turned by some 300 deg to 0.003).
-- The motion itself is had three times, and the three agree much better than that.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local rows = require "tests.reference.nesc_case3"

local binary = program.quick()
local names = { "p", "q", "r", "yaw", "pitch", "roll" }
local MARGIN = 0.01

-- Rows of numbers {p, q, r, yaw, pitch, roll}, degrees; and the states with names, radians.
local function run(path, options)
  local out, states, columns = {}, {}, nil
  local pipe = assert(io.popen(string.format("%s run %s --until 30 --every 0.5 %s", binary, path, options)))
  for line in pipe:lines() do
    local cells, x = {}, {}
    for cell in line:gmatch "[^,]+" do cells[#cells + 1] = cell end
    for i, name in ipairs(columns or {}) do x[name] = tonumber(cells[i]) end
    if columns then
      local w, a, b, c = x.qw, x.qx, x.qy, x.qz
      out[#out + 1] = { math.deg(x.wx), math.deg(x.wy), math.deg(x.wz),
        math.deg(math.atan(2 * (a * b + w * c), w * w + a * a - b * b - c * c)),
        math.deg(math.asin(2 * (w * b - a * c))),
        math.deg(math.atan(2 * (b * c + w * a), w * w - a * a - b * b + c * c)) }
      states[#states + 1] = x
    end
    columns = columns or cells
  end
  assert(pipe:close())
  return out, states
end

-- How far the i-th number x is beyond the range of the row, and the width of that range; angles near that of simulator
-- 04, as they are cut at 180 deg.
local function beyond(row, i, x)
  local function near(y)
    if i <= 3 then return y end
    return y - 360 * math.floor((y - row[4][i]) / 360 + 0.5)
  end
  local low, high = math.huge, -math.huge
  for k = 2, 6 do low, high = math.min(low, near(row[k][i])), math.max(high, near(row[k][i])) end
  x = near(x)
  return math.max(low - x, x - high, 0.0), high - low
end

-- Largest distance beyond the ranges, in units of the spread, for each of the six.
local function outside(list)
  local worst, spread = { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }
  for n, row in ipairs(rows) do
    for i = 1, 6 do
      local far, width = beyond(row, i, list[n][i])
      if far ~= far then far = math.huge end
      worst[i], spread[i] = math.max(worst[i], far), math.max(spread[i], width)
    end
  end
  for i = 1, 6 do worst[i] = worst[i] / spread[i] end
  return worst
end

local scene = "bodies/nasa_brick_damped.lua"
local library, states = run(scene, "")
tap.is(#rows, 61, "a row for every half second")
tap.is(#library, #rows, "a state for every row")

for _, road in ipairs { { "library", "" }, { "emitted rk4", "--engine generated --method rk4 --step 0.01" },
  { "emitted Taylor", "--engine generated --method taylor --tolerance 1e-12" },
  { "emitted pair", "--engine generated --method adaptive --tolerance 1e-12" } } do
  local got, x = run(scene, road[2])
  local worst, apart = outside(got), 0.0
  for i, name in ipairs(names) do
    tap.ok(worst[i] <= MARGIN, road[1] .. ": " .. name .. " within the spread of the five simulators",
      string.format("%.3g of the spread outside", worst[i]))
  end
  for n, a in ipairs(states) do
    for _, k in ipairs { "qw", "qx", "qy", "qz", "wx", "wy", "wz", "rho" } do
      apart = math.max(apart, math.abs(x[n][k] - a[k]))
    end
  end
  -- rk4: (h w)^4 w t/2000 with w = 0.65, and (h/s)^4 of the torques' growth in time: 1e-11 of numbers below 1
  tap.ok(apart <= 1e-9, road[1] .. ": as the library to 1e-9", string.format("%.3g", apart))
end

-- The comparison can fail: without damping, and with air that is a fiftieth too dense.
tap.ok(math.max(table.unpack(outside((run("bodies/nasa_brick.lua", ""))))) > 10, "the free brick is outside")
do
  local dir = program.directory()
  local text, changed = program.read(scene):gsub("0%.45904", "0.46822")
  tap.is(changed, 2, "the density of the air stands in the scene")
  program.write(dir .. "/dense.lua", text)
  tap.ok(math.max(table.unpack(outside((run(dir .. "/dense.lua", ""))))) > 10 * MARGIN, "denser air is outside")
  program.finish()
end

tap.done()
