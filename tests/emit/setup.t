#!/usr/bin/env lua5.4
-- setup.t -- the emitted free top's set-up against the oracle of many digits: where its two series meet, phases after
-- 2^62 ticks, periods, and oblique axes near the separatrix.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- setup.c computes; expected numbers are those of tests/oracle/free_top.c, which knows neither theta functions nor
-- pairs.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local oracle = os.getenv "POLHODE_ORACLE" or "build/oracle/free_top"
local dir = program.directory()

-- 18 units of 2^-52, as tests/emit/top.t says, and what the phases lose: rates of phases are pairs of 106 bits, made
-- with some dozen operations and series that end below 2^-102; 2 pi of it is an angle.
local BAR, PHASE = 4e-15, 2.0 ^ -98
-- 2 period/rate; a sum of three products, times pi: half a unit each
local PERIOD, PRECESSION = 4 * 2.0 ^ -53, 8 * 2.0 ^ -53

local job = assert(scene.read [[
local function entry(name, value) return param(name, value, "kg m^2") end
return scene {
  name = "top",
  body = tensor { mass = 1, xx = entry("xx", 1), yy = entry("yy", 2), zz = entry("zz", 2.5), xy = entry("xy", 0.1),
    xz = entry("xz", 0), yz = entry("yz", 0) },
}
]])
job = scene.plan(job, { real = "double" })
local files = scene.files(job)
program.write(dir .. "/top.h", files["top.h"])
program.write(dir .. "/top.c", files["top.c"])
local code = program.shell(string.format("(gcc -std=c99 -O2 -ffp-contract=off -c -o %s/top.o %s/top.c && gcc " ..
  "-std=c11 -O1 -D_DEFAULT_SOURCE -I%s -o %s/measure tests/emit/setup.c %s/top.o -lm && %s/measure) >%s/out 2>&1",
  dir, dir, dir, dir, dir, dir, dir))
tap.is(code, 0, "compiles and runs")

-- {kind, scale, numbers ...}; the numbers stay text
local lines, refused = {}, 0
for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do
  local words = {}
  for word in string.gmatch(line, "%S+") do words[#words + 1] = word end
  if #words > 1 then lines[#lines + 1] = words else refused = refused + 1 end
end
tap.is(refused, 0, "no state is refused")

-- The oracle's answers to the lines of some kinds, as lists of numbers
local function ask(option, list, edit)
  local text, answers = {}, {}
  for i, l in ipairs(list) do text[i] = table.concat(edit({ table.unpack(l, 3) }), " ") end
  program.write(dir .. "/in", table.concat(text, "\n") .. "\n")
  local status = program.shell(string.format("%s %s <%s/in >%s/answers", oracle, option, dir, dir))
  tap.is(status, 0, "the oracle answers")
  for line in string.gmatch(program.read(dir .. "/answers"), "[^\n]+") do
    local numbers = {}
    for word in string.gmatch(line, "%S+") do numbers[#numbers + 1] = tonumber(word) or math.huge end
    answers[#answers + 1] = numbers
  end
  return answers
end
local function same(words) return words end
local function other_sign(words) -- of the quaternion
  for i = #words - 3, #words do words[i] = string.format("%a", -tonumber(words[i])) end
  return words
end

local function of(kind)
  local list = {}
  for _, l in ipairs(lines) do
    if l[1] == kind then list[#list + 1] = l end
  end
  return list
end

-- The errors of the rates and of the attitude in the lines of one kind, in units of what bar(line) allows
local function worst(kind, bar, least)
  local list, rates, attitude = of(kind), 0, 0
  local plus, minus = ask("-e", list, same), ask("-e", list, other_sign)
  for i, l in ipairs(list) do
    local allowed = bar(l)
    rates = math.max(rates, plus[i][1] / allowed)
    attitude = math.max(attitude, 2 * math.min(plus[i][2], minus[i][2]) / allowed)
  end
  tap.ok(#list >= least and #plus == #list and rates <= 1 and attitude <= 1 and rates > 0, string.format(
    "%s: %d states, rates to %.2g of what is allowed, attitude to %.2g", kind, #list, rates, attitude))
end

local function phases(l) return BAR + PHASE * tonumber(l[2]) end
worst("between", phases, 180)
worst("tick", phases, 300)

-- Principal moments of an oblique tensor are pairs, good to 2^-100 or so of the largest, and so is G^2 - 2 T I2, which
-- vanishes on the separatrix.  A unit of the last place of one input, 2^-52 of it, moves that by some 2^-53: the error
-- is at most 2^-45 of what the unit does, and states so near the separatrix that it shows are moved far by the unit.
do
  local function moved(words) -- w0[0]
    words[7] = string.format("%a", tonumber(words[7]) * (1 + 2.0 ^ -52))
    return words
  end
  local list = of "oblique"
  local here, there, effect, most = ask("", list, same), ask("", list, moved), {}, 0
  for i, l in ipairs(list) do
    local distance, rates = 0, math.max(math.abs(here[i][1]), math.abs(here[i][2]), math.abs(here[i][3]))
    for k = 1, 7 do
      distance = math.max(distance, math.abs(here[i][k] - there[i][k]) / (k < 4 and rates or 1))
    end
    effect[l], most = distance, math.max(most, distance)
  end
  tap.ok(most > 0.1, "oblique: some states are so near the separatrix that a unit of the last place moves them far",
    most)
  worst("oblique", function(l) return phases(l) + 2.0 ^ -45 * effect[l] end, 150)
end

local list = of "rates"
local expected, period, precession = ask("-p", list, same), 0, 0
for i, l in ipairs(list) do
  period = math.max(period, math.abs(tonumber(l[17]) - expected[i][1]) / expected[i][1])
  precession = math.max(precession, math.abs(tonumber(l[18]) - expected[i][2]) / tonumber(l[2]))
end
tap.ok(#list >= 380 and period <= PERIOD, string.format("polhode_period: %d states, to %.2g", #list, period))
tap.ok(precession <= PRECESSION, string.format("precession_rate: to %.2g of |w|", precession))

program.finish()
tap.done()
