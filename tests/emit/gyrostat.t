#!/usr/bin/env lua5.4
-- gyrostat.t - the emitted closed form of the asymmetric gyrostat: the reference table, hard and random motions against
-- a Taylor series of many digits, random states against the integrals and the equations of motion.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One scene, its moments and the rotor's momentum parameters, compiled once as double and once as float; gyrostat.c
-- measures.  Expected states: tests/reference/forced_top.h (32 digits) and tests/oracle/heavy_top.c with a rotor.
-- POLHODE_STATES: how many random states; POLHODE_HEAVY_ORACLE: another program than the one `make tests` builds.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local dir = program.directory()
local oracle = os.getenv "POLHODE_HEAVY_ORACLE" or "build/oracle/heavy_top"

-- 18 units of 2^-52, as for the free and the heavy top: phases reduced in pairs and rounded once, three sines and
-- cosines, series of five terms, some dozen operations on numbers below 2; the set-up's 2^-100 is not seen.
local BAR, NORM = 4e-15, 4e-16
-- Rates are over the pace, the largest of |w| and |M|/I with the smallest I.  2T is a sum of three squares, over the
-- largest moment: twice three errors of rates.  M has those of rates and attitude.
local ENERGY, MOMENTUM = 6 * BAR, 3 * BAR
-- A central difference over 2 h, h = 2^-16 of the pace: h^2/6 = 4e-11 of third derivatives, which are cubes of rates of
-- up to 2 paces, and 2^16 roundings.
local DERIVATIVE = 2.0 ^ 3 * 2.0 ^ -32 / 6 + 2.0 ^ 16 * BAR
-- float: the same count of units of 2^-23
local FLOAT_BAR = 4e-6

local text = [[
local A, B, C = param("A", 1, "kg m^2"), param("B", 2, "kg m^2"), param("C", 2.5, "kg m^2")
local H = param("H", 20, "kg m^2/s")
return scene {
  name = "%s", body = tensor { mass = 1, xx = A, yy = B, zz = C },
  effects = { effect.rotor { axis = {0, 0, 1}, momentum = H } },
}
]]

for _, s in ipairs { { "dual", "double" }, { "small", "float" } } do
  local name = s[1]
  local job = assert(scene.read(string.format(text, name)))
  scene.plan(job, { real = s[2] })
  tap.is(job.closed.kind, "asymmetric gyrostat", name .. ": an asymmetric gyrostat")
  local files = scene.files(job)
  program.write(dir .. "/" .. name .. ".h", files[name .. ".h"])
  program.write(dir .. "/" .. name .. ".c", files[name .. ".c"])
end

local function lines(arguments)
  local code = program.shell(string.format("timeout 300 %s/measure %s >%s/out", dir, arguments, dir))
  tap.is(code, 0, "measure " .. arguments .. " runs")
  local list = {}
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do list[#list + 1] = line end
  return list
end

local function words(line)
  local list = {}
  for word in string.gmatch(line, "%S+") do list[#list + 1] = word end
  return list
end

local function rows()
  local n, worst = 0, { 0, 0 }
  for _, line in ipairs(lines "rows") do
    local l = words(line)
    local rates, angle, norm = tonumber(l[4]), tonumber(l[5]), tonumber(l[6])
    if not (rates and rates <= BAR and angle <= BAR and norm <= NORM) then tap.ok(false, line) end
    n, worst[1], worst[2] = n + 1, math.max(worst[1], rates or 0), math.max(worst[2], angle or 0)
  end
  tap.ok(n >= 5, string.format("%d samples of the table: rates to %.2g of the largest, attitude to %.2g", n,
    worst[1], worst[2]))
end

-- Motions of every kind against the series: near separatrices 60 paces lose up to 50 of 128 bits.
local function cases(count)
  local names, norms, paces, input = {}, {}, {}, {}
  for _, line in ipairs(lines("cases " .. count)) do
    local name, norm, pace, numbers = string.match(line, "^(.-); (%S+) (%S+); (.+)$")
    if not name then tap.ok(false, line) end
    names[#names + 1], norms[#norms + 1], input[#input + 1] = name, tonumber(norm), numbers
    paces[#paces + 1] = tonumber(pace)
  end
  program.write(dir .. "/lines", table.concat(input, "\n") .. "\n")
  tap.is(program.shell(string.format("%s -b 160 -r -e <%s/lines >%s/errors", oracle, dir, dir)), 0, "the oracle runs")
  local n, worst, sides = 0, { 0, 0 }, {}
  for line in string.gmatch(program.read(dir .. "/errors"), "[^\n]+") do
    n = n + 1
    local l = words(line)
    local rates, angle = (tonumber(l[1]) or math.huge) / paces[n], 2 * (tonumber(l[2]) or math.huge)
    if not (rates <= BAR and angle <= BAR and norms[n] <= NORM) then tap.ok(false, names[n] .. ": " .. line) end
    worst[1], worst[2] = math.max(worst[1], rates), math.max(worst[2], angle)
    local side = string.match(names[n], ", (%d),")
    sides[side] = (sides[side] or 0) + 1
  end
  tap.ok(n == #names and n >= count * 0.95, string.format("%d motions: rates to %.2g, attitude to %.2g", n, worst[1],
    worst[2]))
  tap.ok(sides["0"] and sides["1"] and sides["2"],
    "far from separatrices and near, on the side of two bands and of one")
end

local function random(command, states)
  local l = words(lines("random " .. states)[1])
  local who = string.format("%s: %s random states: ", command, l[2])
  local function below(k, bar, what) tap.ok(tonumber(l[k]) <= bar, who .. what, l[k]) end
  -- two moments that were made equal may break the triangle inequality: 3 of 17 kinds, 7 of 100 of these
  below(3, 0.02 * states, "hardly one is refused")
  tap.is(l[4], "0", who .. "every number is finite")
  below(5, BAR, "at t = 0 the initial state")
  below(6, NORM, "|q| = 1")
  below(7, ENERGY, "w.I w is constant")
  below(8, MOMENTUM, "I w + h is constant in inertial axes")
  -- compiled as other loops and vectors, the same sums may be fused otherwise
  below(9, BAR, "many at once, rates alone, attitude alone: the same")
  below(11, 2 * BAR, "in ticks, of either sign: the same")
  below(10, DERIVATIVE, "the motion obeys the equations of motion")
end

local states = tonumber(os.getenv "POLHODE_STATES" or "20000")
for i, command in ipairs { "gcc -std=c11 -O2 -ffp-contract=off", "gcc -std=c11 -O3 -march=native -ffp-contract=fast",
  "clang -std=c11 -O1" } do
  local code = program.shell(string.format("(cd %s && %s -c dual.c small.c) >%s/log 2>&1 && gcc -std=c11 -O1 " ..
    "-D_DEFAULT_SOURCE -Itests/reference -I%s -o %s/measure tests/emit/gyrostat.c %s/dual.o %s/small.o -lm " ..
    ">>%s/log 2>&1", dir, command, dir, dir, dir, dir, dir, dir))
  if tap.ok(code == 0, command .. ": compiles", program.read(dir .. "/log")) then
    rows()
    if i == 1 then cases(510) end
    random(command, i == 1 and math.max(states, 50000) or states)
    local l = words(lines("float " .. states)[1])
    tap.ok(tonumber(l[3]) <= FLOAT_BAR and tonumber(l[4]) <= FLOAT_BAR, string.format(
      "%s: float against double, %s states: rates to %s, attitude to %s", command, l[2], l[3], l[4]))
  end
end

program.finish()
tap.done()
