#!/usr/bin/env lua5.4
-- lagrange.t - the emitted closed form of the heavy symmetric top: the reference table, hard motions against a Taylor
-- series of many digits, random states against the integrals and the equations of motion.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One scene, its moments, weight and arm parameters, compiled once as double and once as float; lagrange.c measures.
-- Expected states: tests/reference/forced_top.h (32 digits; tests/reference/README.md) and tests/oracle/heavy_top.c.
-- POLHODE_STATES: how many random states; POLHODE_HEAVY_ORACLE: another program than the one `make tests` builds.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local dir = program.directory()
local oracle = os.getenv "POLHODE_HEAVY_ORACLE" or "build/oracle/heavy_top"

-- 18 units of 2^-52, as for the free top: phases reduced in pairs and rounded once, three sines and cosines, series of
-- four terms, some dozen operations on numbers below 2; the set-up's 2^-100 is not seen.  |q| = 1 after a Newton step.
local BAR, NORM = 4e-15, 4e-16
-- At random states rates are over the largest of |w| at t = 0 and sqrt(m g l/A), twice which the motion may reach: its
-- square counts four times in the energy.  L along the vertical is a product of rates and attitude.
local START, ENERGY, MOMENTUM = BAR, 4 * BAR, 2 * BAR
-- A central difference over 2 h, h = 2^-16 of that unit of time: h^2/6 = 4e-11 of third derivatives, which are cubes
-- of rates of up to 4 units, and 2^16 roundings.
local DERIVATIVE = 4.0 ^ 3 * 2.0 ^ -32 / 6 + 2.0 ^ 16 * BAR
-- float: the same count of units of 2^-23
local FLOAT_BAR = 4e-6

local text = [[
local A, C = param("A", 1, "kg m^2"), param("C", 0.5, "kg m^2")
local g, l = param("g", 10, "m/s^2"), param("l", 0.1, "m")
return scene {
  name = "%s",
  body = tensor { mass = 1, com = {0, 0, l}, about = "origin", xx = A, yy = A, zz = C, xy = 0, xz = 0, yz = 0 },
  origin = {0, 0, 0}, effects = { effect.gravity { g = g } },
}
]]

for _, s in ipairs { { "top", "double" }, { "small", "float" } } do
  local name = s[1]
  local job = assert(scene.read(string.format(text, name)))
  scene.plan(job, { real = s[2] })
  tap.is(job.closed.kind, "lagrange", name .. ": a heavy symmetric top")
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
  tap.ok(n >= 20, string.format("%d samples of the table: rates to %.2g of the largest, attitude to %.2g", n,
    worst[1], worst[2]))
end

-- The hard motions, each at three times, against the series in 192 bits: a separatrix followed for 60 time constants
-- loses 90 of them.
local function cases(which, option, least)
  local names, norms, input = {}, {}, {}
  for _, line in ipairs(lines(which)) do
    local name, norm, numbers = string.match(line, "^(.-); (%S+); (.+)$")
    if not name then tap.ok(false, line) end
    names[#names + 1], norms[#norms + 1], input[#input + 1] = name, tonumber(norm), numbers
  end
  program.write(dir .. "/lines", table.concat(input, "\n") .. "\n")
  tap.is(program.shell(string.format("%s -b 192 %s -e <%s/lines >%s/errors", oracle, option, dir,
    dir)), 0, "the oracle runs")
  local n, worst = 0, { 0, 0 }
  for line in string.gmatch(program.read(dir .. "/errors"), "[^\n]+") do
    n = n + 1
    local l = words(line)
    local rates, angle = tonumber(l[1]) or math.huge, 2 * (tonumber(l[2]) or math.huge)
    if not (rates <= BAR and angle <= BAR and norms[n] <= NORM) then tap.ok(false, names[n] .. ": " .. line) end
    worst[1], worst[2] = math.max(worst[1], rates), math.max(worst[2], angle)
  end
  tap.ok(n == #names and n >= least, string.format("%d samples of hard motions, %s: rates to %.2g, attitude to %.2g", n,
    which, worst[1], worst[2]))
end

local function random(command, states)
  local l = words(lines("random " .. states)[1])
  local who = string.format("%s: %s random states: ", command, l[2])
  local function below(k, bar, what) tap.ok(tonumber(l[k]) <= bar, who .. what, l[k]) end
  -- C = 2 A (1 - u) may break the triangle inequality by the rounding of what the parameters stand for
  below(3, 1e-3 * states, "hardly one is refused")
  tap.is(l[4], "0", who .. "every number is finite")
  below(5, START, "at t = 0 the initial state")
  below(6, NORM, "|q| = 1")
  below(7, ENERGY, "T + V is constant")
  below(8, MOMENTUM, "L along the vertical is constant")
  -- compiled as other loops and vectors, the same sums may be fused otherwise
  below(9, BAR, "many at once, rates alone, attitude alone: the same")
  below(11, 2 * BAR, "in ticks, of either sign: the same")
  below(10, DERIVATIVE, "the motion obeys the equations of motion")
end

local states = tonumber(os.getenv "POLHODE_STATES" or "20000")
for i, command in ipairs { "gcc -std=c11 -O2 -ffp-contract=off", "gcc -std=c11 -O3 -march=native -ffp-contract=fast",
  "clang -std=c11 -O1" } do
  local code = program.shell(string.format("(cd %s && %s -c top.c small.c) >%s/log 2>&1 && gcc -std=c11 -O1 " ..
    "-D_DEFAULT_SOURCE -Itests/reference -I%s -o %s/measure tests/emit/lagrange.c %s/top.o %s/small.o -lm " ..
    ">>%s/log 2>&1", dir, command, dir, dir, dir, dir, dir, dir))
  if tap.ok(code == 0, command .. ": compiles", program.read(dir .. "/log")) then
    rows()
    if i == 1 then
      cases("cases", "", 150)
      cases("long", "-p", 25) -- 1.2 million nutations
    end
    random(command, i == 1 and math.max(states, 100000) or states)
    local l = words(lines("float " .. states)[1])
    tap.ok(tonumber(l[3]) <= FLOAT_BAR and tonumber(l[4]) <= FLOAT_BAR, string.format(
      "%s: float against double, %s states: rates to %s, attitude to %s", command, l[2], l[3], l[4]))
  end
end

program.finish()
tap.done()
