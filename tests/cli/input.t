#!/usr/bin/env lua5.4
-- input.t - `run --input`: inputs over time, held and on lines, by both engines, against motions that are known.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A torque about a principal axis: I w' = u(t), the angle is the integral of w, and both are polynomials between rows.
-- Tolerances: general adaptive, 16 units of rounding; fixed steps, the truncation of the method, named there.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

-- Izz = 2; `motor` limited, in mN m; `push` without limits.
local SCENE = [[
local motor = input("motor", "mN m", { min = -1000, max = 1000 })
local push = input("push", "N m")
return scene { name = "s", body = tensor { mass = 1, xx = 1.5, yy = 1.75, zz = 2 },
  effects = { effect.torque { body = { 0, 0, motor + push } } },
  initial = { omega = { 0, 0, 0.25 } }, time = { horizon = 4, step = 0.01 } }
]]
program.write(dir .. "/s.lua", SCENE)
program.write(dir .. "/c.lua", (SCENE:gsub("effects = .- },\n", "effects = { effect.control {} },\n")
  :gsub('local push.-\n', ""):gsub("local motor.-\n", "")))
program.write(dir .. "/free.lua", (SCENE:gsub("effects = .- },\n", "effects = {},\n"):gsub("local push.-\n", "")
  :gsub("local motor.-\n", "")))

local function run(words)
  local status = program.shell(string.format("cd %s && %s run %s >out 2>err", dir, binary:gsub("^([^/])",
    os.getenv "PWD" .. "/%1"), words))
  return status, program.read(dir .. "/out"), program.read(dir .. "/err")
end

-- The rows {t, angle about z, wz}.
local function rows_of(text)
  local list, at = {}, nil
  for line in text:gmatch "[^\n]+" do
    local cells = {}
    for cell in line:gmatch "[^,]+" do cells[#cells + 1] = tonumber(cell) or cell end
    if at then
      list[#list + 1] = { cells[1], 2 * math.atan(cells[at.qz], cells[at.qw]), cells[at.wz] }
    else
      at = {}
      for i, name in ipairs(cells) do at[name] = i end
    end
  end
  return list
end

-- u as a list of pieces {from, to, value at the start, slope}: angle and rate at t, from 0 at the rate w0.
local function known(pieces, I, w0, t)
  local angle, w = 0.0, w0
  for _, p in ipairs(pieces) do
    local d = math.max(0, math.min(t, p[2]) - p[1])
    angle = angle + w * d + (p[3] * d ^ 2 / 2 + p[4] * d ^ 3 / 6) / I
    w = w + (p[3] * d + p[4] * d ^ 2 / 2) / I
  end
  return angle, w
end

local function holds(what, words, pieces, tolerance)
  local status, out, err = run(words)
  local worst, count = 0.0, 0
  for _, row in ipairs(rows_of(out)) do
    local angle, w = known(pieces, 2, 0.25, row[1])
    worst = math.max(worst, math.abs(row[2] - angle), math.abs(row[3] - w))
    count = count + 1
  end
  tap.ok(status == 0 and count == 9 and worst <= tolerance, string.format("%s (%.2g of %.2g)", what, worst, tolerance),
    string.format("status %s, %d rows, %s", status, count, err))
end

program.write(dir .. "/u.csv", "# motor and push\nt,push,motor [N m]\n0.5,0.5,0.25\n1,-0.25,0.5\n\n3,0,-0.5\n")
program.write(dir .. "/ramp.csv", "t,motor,push\n0,0,0\n2,4,0\n3,-2,0.5\n")
program.write(dir .. "/c.csv", "uz [N mm],t,uy,ux\n750,0.5,0,0\n250,1,0,0\n-500,3,0,0\n")

local HELD = { { 0, 1, 0.75, 0 }, { 1, 3, 0.25, 0 }, { 3, 9, -0.5, 0 } }
-- motor: up to its limit 1 at t = 0.5, down through 1 at t = 2.5 and 0 at 2 + 2/3 to -1 at t = 2 + 5/6, held after 3
local RAMP = { { 0, 0.5, 0, 2 }, { 0.5, 2, 1, 0 }, { 2, 2.5, 1, 0.5 }, { 2.5, 2 + 5 / 6, 1.25, -5.5 },
  { 2 + 5 / 6, 3, -1 + 5 / 12, 0.5 }, { 3, 9, -0.5, 0 } }
local AT = " --until 4 --every 0.5"
local FEW = 16 * 2.0 ^ -52
-- rk4 takes the exponential of half an angle f = h w/2 for its first five terms: f^5/120 is missing in the half angle
-- of each of the 400 steps; rounding, half a unit for each step
local function rk4(largest) return 400 * 2 * (0.01 * largest / 2) ^ 5 / 120 + 400 * 2.0 ^ -53 end
local RK4 = rk4(0.875)

holds("held, general", "s.lua --input u.csv" .. AT, HELD, FEW)
holds("held, general, rk4", "s.lua --input u.csv --method rk4" .. AT, HELD, RK4)
holds("held, emitted, rk4", "s.lua --input u.csv --engine generated" .. AT, HELD, RK4)
holds("held, emitted, taylor", "s.lua --input u.csv --engine generated --method taylor" .. AT, HELD, 1e-12)
holds("held, effect.control, general", "c.lua --input c.csv" .. AT, HELD, FEW)
holds("held, effect.control, emitted", "c.lua --input c.csv --engine generated" .. AT, HELD, RK4)
holds("on lines with corners at the limits, general", "s.lua --input ramp.csv --between linear" .. AT, RAMP, FEW)
-- the step's middle value: of the angle a step loses slope h^3/(12 I), of the rate nothing
holds("on lines, emitted, rk4", "s.lua --input ramp.csv --between linear --engine generated" .. AT, RAMP,
  6 * 0.01 ^ 2 / (12 * 2) * 3 + RK4)
do -- control on a line
  program.write(dir .. "/line.csv", "t,ux,uy,uz\n0,0,0,0\n2,0,0,1\n")
  holds("effect.control on a line, general", "c.lua --input line.csv --between linear" .. AT,
    { { 0, 2, 0, 0.5 }, { 2, 9, 1, 0 } }, FEW)
end

do -- the slope of an input on lines, by its name
  program.write(dir .. "/r.lua", (SCENE:gsub("local motor.-\n", 'local rate = input("push_rate", "N m/s")\n')
    :gsub("motor %+ push", 'rate*quantity("1", "s")')))
  program.write(dir .. "/slope.csv", "t,push\n0,0\n1,\n2,4\n3,1\n")
  local pieces = { { 0, 2, 2, 0 }, { 2, 3, -3, 0 }, { 3, 9, 0, 0 } }
  holds("a slope, general", "r.lua --input slope.csv --between linear" .. AT, pieces, FEW)
  holds("a slope, emitted", "r.lua --input slope.csv --between linear --engine generated" .. AT, pieces, rk4(2.25))
end

---- what is wrong with a file --------------------------------------------------------------------------

local function refused(what, words, file, message, status)
  if file then program.write(dir .. "/w.csv", file) end
  local got, out, err = run(words)
  tap.ok(got == (status or 2) and out == "" and err:find(message, 1, true), what, got .. ": " .. err)
end

local WITH = "s.lua --input w.csv"
refused("an unknown input", WITH, "t,moter\n0,1\n",
  "w.csv:1: the scene has no input \"moter\" (it has motor, push); did you mean motor?")
refused("no time", WITH, "motor\n1\n", "w.csv:1: has no column t, the time (it has motor)")
refused("a column twice", WITH, "t,push,push\n0,1,1\n", "w.csv:1: two columns are called push")
refused("another unit", WITH, "t,push [kg]\n0,1\n", "w.csv:1: column push must be in N m, got [kg]")
refused("an unknown unit", WITH, "t,push [furlong]\n0,1\n", "w.csv:1: column push: unknown unit")
refused("too few numbers", WITH, "t,push,motor\n0,1\n", "w.csv:2: 3 cells expected, got 2")
refused("no number", WITH, "t,push\n0,1\n1,x\n", "w.csv:3: column push must be a number, got \"x\"")
refused("not finite", WITH, "t,push\n0,1e999\n", "w.csv:2: column push must be a number")
refused("times that descend", WITH, "t,push\n0,1\n0,2\n", "w.csv:3: times must ascend, got 0 s after 0 s")
refused("an empty file", WITH, "", "w.csv: has no line that names its columns")
refused("no rows", WITH, "t,push\n", "w.csv: must have a row or more, got 0")
refused("no such file", "s.lua --input none.csv", nil, "none.csv")
refused("no inputs", "free.lua --input u.csv", nil, "--input: the scene has no inputs")
refused("--between without a file", "s.lua --between linear", nil, "--between")
refused("a word for --between", "s.lua --input u.csv --between cubic", nil, "--between must be held or linear")
refused("lines in steps that the emitted method chooses", "s.lua --input ramp.csv " ..
  "--between linear --engine generated --method adaptive", nil,
  "--between linear: the emitted adaptive holds its inputs for steps of its own choice")
do
  program.write(dir .. "/w.csv", "t,push\n0,0.5\n")
  local status, _, err = run(WITH .. AT)
  tap.ok(status == 0 and err:find("no column for the input motor, which stays 0", 1, true), "a missing column", err)
end

program.finish()
tap.done()
