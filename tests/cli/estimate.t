#!/usr/bin/env lua5.4
-- estimate.t - every kind of run says how wrong it is, and is right about it within a factor.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle: the general library in long double near rounding, in the measure of docs/methods.md, "How wrong is a run",
-- written again here.  What is promised: a tenth to ten times the error where it is above what --warn asks for; no
-- warning where it is a tenth of that or less.  The library's own runs, which are the oracle, are judged where a closed
-- form or the size of the motion tells.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local binary = program.quick()
local dir = program.directory()

local function run(scene, more)
  local code, out, log = program.output(string.format("POLHODE_SOURCE=. timeout 100 %s run %s --columns t,states %s",
    binary, scene, more))
  local rows, names = {}, {}
  local text = string.match(out .. "\n\n", "^(.-)\n\n")
  for line in string.gmatch(text, "[^\n]+") do
    local row = {}
    for cell in string.gmatch(line, "[^,]+") do row[#row + 1] = tonumber(cell) or cell end
    if #names == 0 then names = row else rows[#rows + 1] = row end
  end
  return code, rows, log, names
end

local groups = { { "^q[wxyz]$" }, { "^w[xyz]$" }, { "^r[xyz]$" }, { "^v[xyz]$" } }

-- The error of rows against true ones: the largest of all groups and times.
local function off(rows, truth, names)
  local list, used, worst = {}, {}, 0.0
  for _, g in ipairs(groups) do
    local columns = {}
    for i, name in ipairs(names) do
      if string.find(name, g[1]) then columns[#columns + 1], used[i] = i, true end
    end
    list[#list + 1] = #columns > 0 and columns or nil
  end
  for i = 2, #names do
    if not used[i] then list[#list + 1] = { i } end
  end
  for _, columns in ipairs(list) do
    local attitude, size, most = names[columns[1]] == "qw", 0.0, 0.0
    for k, want in ipairs(truth) do
      local square, plus, minus = 0.0, 0.0, 0.0
      for _, i in ipairs(columns) do
        square = square + want[i] ^ 2
        plus, minus = plus + (rows[k][i] - want[i]) ^ 2, minus + (rows[k][i] + want[i]) ^ 2
      end
      size = math.max(size, math.sqrt(square))
      most = math.max(most, math.sqrt(attitude and math.min(plus, minus) or plus))
    end
    -- 1e-12: rates of rounding, of which no digit is right
    if attitude then worst = math.max(worst, most) elseif size > 1e-12 then worst = math.max(worst, most / size) end
  end
  return worst
end

local function estimate(log)
  if string.find(log, "no digit is known", 1, true) then return "lost" end
  local e = string.match(log, "its error is estimated at (%S+)")
  return e == "more" and 10.0 or e == "not" and math.huge or tonumber(e) or nil
end

-- Does what is said of rows that are wrong by `e` keep the promise?
local function kept(said, e, warn)
  if said == "lost" then return e > 0.02 end
  if said then return e > warn / 10 and e > said / 10 and e < said * 10 end
  return e <= 2 * warn
end

local function judged(scene, times, truth, how, warn)
  local code, rows, log, names = run(scene, times .. " " .. how .. " --warn " .. warn)
  if code ~= 0 then return nil end -- not for this scene
  if #rows ~= #truth then return tap.ok(false, scene .. " " .. how, log) end
  local e, said = off(rows, truth, names), estimate(log)
  tap.ok(kept(said, e, tonumber(warn)), string.format("%s %s: an error of %.2g, said %s", scene, how, e,
    said and tostring(said) or "nothing"), log)
  return said
end

-- ---- the bodies, each by some of the kinds ----

-- In float an error of some roundings is as large as that of its estimate: from 1e-6 on.
local kinds = {
  { "--engine generated --method rk4", "1e-9" }, { "--engine generated --method adaptive --tolerance 1e-5", "1e-8" },
  { "--engine generated --method taylor --real float", "1e-6" }, { "--method rkf45 --tolerance 1e-6", "1e-9" },
  { "--engine generated --method split2", "1e-9" }, { "--engine generated --method taylor --tolerance 1e-6", "1e-9" },
  { "--engine generated --method rosenbrock --tolerance 1e-5", "1e-8" }, { "--method rk4", "1e-9" },
  { "--engine generated --method midpoint", "1e-7" }, { "--engine generated --method rk4 --real float", "1e-6" },
  { "--engine generated --method semi", "1e-3" },
  { "--engine generated --method adaptive --tolerance 1e-4 --real float", "1e-6" },
  { "--method rk8pd --tolerance 1e-9", "1e-12" }, { "--engine generated --method split4 --real float", "1e-6" },
}

local bodies = {}
for path in string.gmatch(io.popen("ls bodies/*.lua"):read "a", "[^\n]+") do bodies[#bodies + 1] = path end
local any = {} -- kinds that had something to say
for i, body in ipairs(tier.every(8, bodies)) do
  local times = "--until 1 --every 0.0625"
  local code, truth = run(body, times)
  for k = 0, code == 0 and 1 or -1 do
    local n = (2 * i + k) % #kinds + 1
    local kind = kinds[n]
    any[n] = judged(body, times, truth, kind[1], kind[2]) and true or any[n]
  end
end
for n, kind in ipairs(tier.quick and {} or kinds) do tap.ok(any[n], kind[1] .. " has an estimate") end

-- ---- made by hand ----

local function written(name, text)
  program.write(dir .. "/" .. name .. ".lua", text)
  return dir .. "/" .. name .. ".lua"
end

-- A free top for long in float: the error is of rounding, and double helps, not a shorter step.
local long = written("slab", "return scene { name = 'slab', body = solid.box { x = 1.2, y = 0.7, z = 0.25, " ..
  "mass = 3 }, initial = { omega = { 0.4, 0.5, 12 } }, time = { horizon = 4000, step = 1/60 } }")
local code, truth, _
code, truth = run(long, "--method exact --at 2000,4000")
-- (Not by adaptive: 48000 radians of its own tolerance leave no digit, which is another answer.)
for _, how in ipairs { "--method taylor", "--method exact", "--method split6" } do
  local all = "--engine generated --real float " .. how
  local said = judged(long, "--at 2000,4000", truth, all, "1e-6")
  tap.ok(code == 0 and said and said ~= "lost", how .. " in float: a number")
  local _, _, log = run(long, "--at 2000,4000 --warn 1e-6 " .. all)
  local steps, rounding = string.match(log, "of the steps (%S+), of rounding (%S+)%)")
  tap.ok(tonumber(rounding) and tonumber(rounding) > tonumber(steps) and
    string.find(log, "what helps: --real double", 1, true), how .. " in float: it is rounding, double helps", log)
end

-- A pendulum at its turning points, where its rates are small: in parts of the motion's, not of the rows'.
local turning = written("pendulum", "return scene { name = 'pendulum', body = points { { 1, 0, 0, -1 } }, " ..
  "origin = { 0, 0, 0 }, effects = { effect.gravity { g = 9.81 } }, initial = { attitude = { axis = 'x', " ..
  "angle = quantity(10, 'deg') } }, time = { horizon = 60, step = 0.01 } }")
local rows, log
code, rows, log = run(turning, "--engine generated --method rk4 --step 0.05 " ..
  "--at 0,2.00989262729860068,4.01978525459720136")
tap.ok(code == 0 and #rows == 3 and log == "", "rows at which the motion stands still: no false alarm", log)

-- Chaos.  Errors grow by e in 0.6 s or so: after 60 s the library knows no digit, whatever its tolerance, and says so.
local chaos = written("chaos", "return scene { name = 'chaos', body = solid.box { x = .1, y = .2, z = .3, mass = 1 }" ..
  ":at { 0, .05, .1 }, origin = { 0, 0, 0 }, effects = { effect.gravity {} }, initial = { attitude = { axis = " ..
  "{ 1, .3, 0 }, angle = 1.7 }, omega = { 0, 1, 2 } }, time = { horizon = 10, step = 1e-3 } }")
for _, how in ipairs { "", "--engine generated --method taylor", "--method rk4", "--engine generated --method rk4",
  "--engine generated --method taylor --real float" } do
  code, rows, log = run(chaos, "--at 60 " .. how)
  local last = rows[1]
  local _, others = run(chaos, "--at 60 --tolerance 1e-16")
  local apart = 0.0
  for i = 2, 5 do apart = apart + (last[i] - others[1][i]) ^ 2 end
  tap.ok(code == 0 and apart > 0.01 and estimate(log) == "lost", "chaos, " .. how .. ": no digit is known", log)
end
_, truth = run(chaos, "--at 10,20")
_, rows = run(chaos, "--at 10,20 --tolerance 1e-16")
tap.ok(off(rows, truth, { "t", "qw", "qx", "qy", "qz", "wx", "wy", "wz" }) < 1e-5, "20 s of it the library knows")
judged(chaos, "--at 10,20", truth, "--engine generated --method taylor", "1e-5")

program.finish()
tap.done()
