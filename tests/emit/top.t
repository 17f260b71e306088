#!/usr/bin/env lua5.4
-- top.t - the emitted closed form of the free top: every sample of the reference table, and hard random states.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One scene, a tensor whose six entries are parameters, compiled once as double and once as float; top.c measures.
-- Expected states: 32 digits, computed otherwise (tests/reference/README.md).  POLHODE_STATES: how many random states.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local dir = program.directory()

-- The requirement: 18 units of 2^-52.  Two phases, each reduced in pairs and rounded once, two sines and cosines, some
-- dozen operations on numbers below 2; what is left of the set-up is 2^-100.  |q| = 1 after a Newton step: two units.
local BAR, NORM = 4e-15, 4e-16
-- float: the same count of units of 2^-23, as required
local FLOAT_BAR, FLOAT_NORM = 4e-6, 4e-16 * 2.0 ^ 29
-- the state at t = 0, the inertial L and T at random states: the same roundings, T counts each rate twice
-- "tick": the same times in ticks; "same": ticks back and none, rates alone and attitude alone against the whole
local START, MOMENTUM, ENERGY = BAR, BAR, 2 * BAR

-- Compilers that fuse products into sums choose them anew in each loop: two evaluations, each within half of the bar.
local MANY, FLOAT_MANY = BAR, FLOAT_BAR

local text = [[
local function entry(name, value) return param(name, value, "kg m^2") end
return scene {
  name = "%s",
  body = tensor { mass = 1, xx = entry("xx", 1), yy = entry("yy", 2), zz = entry("zz", 2.5), xy = entry("xy", 0.1),
    xz = entry("xz", 0), yz = entry("yz", 0) },
}
]]

for _, s in ipairs { { "top", "double" }, { "small", "float" } } do
  local name = s[1]
  local job = assert(scene.read(string.format(text, name)))
  job = scene.plan(job, { real = s[2] })
  tap.is(job.closed.kind, "asymmetric", name .. ": a tensor of parameters has the closed form of the asymmetric top")
  local files = scene.files(job)
  program.write(dir .. "/" .. name .. ".h", files[name .. ".h"])
  program.write(dir .. "/" .. name .. ".c", files[name .. ".c"])
end

-- The program's lines for one compiler and its options, as lists of words.  What measures is compiled without these:
-- gcc 12 at -O3 for AVX-512 leaves its inputs unrounded, (double)(float)x = x.
local function measured(command, states)
  local code = program.shell(string.format("(cd %s && %s -c top.c small.c) >%s/log 2>&1 && gcc -std=c11 -O1 " ..
    "-D_DEFAULT_SOURCE -Itests/reference -I%s -o %s/measure tests/emit/top.c %s/top.o %s/small.o -lm >>%s/log 2>&1",
    dir, command, dir, dir, dir, dir, dir, dir))
  if not tap.ok(code == 0, command .. ": compiles", program.read(dir .. "/log")) then return {} end
  code = program.shell(string.format("timeout 300 %s/measure %d >%s/out", dir, states, dir))
  tap.is(code, 0, command .. ": runs")
  local lines = {}
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do
    local words = {}
    for word in string.gmatch(line, "%S+") do words[#words + 1] = word end
    lines[#lines + 1] = words
  end
  return lines
end

-- NAME_at_many: the same bits as NAME_at, but where the compiler fuses; kinds 0, 1 and 2 of formulas are all met
local function judge_many(command, lines)
  local fused = string.find(command, "contract=fast", 1, true)
  local kinds, count, wrong = {}, 0, {}
  for _, l in ipairs(lines) do
    local scene_name, differ, far = l[2], tonumber(l[6]), tonumber(l[7])
    local bar = scene_name == "top" and MANY or FLOAT_MANY
    kinds[scene_name .. tostring(l[4])] = true
    count = count + 1
    if not (differ and (differ == 0 or fused and far <= bar)) then wrong[#wrong + 1] = table.concat(l, " ") end
  end
  tap.is(count, 2 * 6 * 68, command .. ": NAME_at_many: six states, n = 0 to 67, double and float")
  tap.ok(kinds.top0 and kinds.top1 and kinds.top2 and kinds.small0 and kinds.small1 and kinds.small2,
    command .. ": of all kinds")
  tap.is(table.concat(wrong, "; "), "", command .. ": NAME_at_many agrees with NAME_at" ..
    (fused and "" or " in every bit"))
end

local function judge(command, states)
  local many = {}
  local worst = { row = { 0, 0, 0 }, tick = { 0, 0, 0 }, same = { 0, 0, 0 }, float = { 0, 0, 0 } }
  for _, l in ipairs(measured(command, states)) do
    local kind = l[1]
    if kind == "many" then
      many[#many + 1] = l
    elseif kind == "random" then
      local start, norm, momentum, energy = tonumber(l[4]), tonumber(l[5]), tonumber(l[6]), tonumber(l[7])
      local bars = l[2] .. " random states"
      tap.is(l[3], "0", command .. ": none of " .. bars .. " is refused")
      tap.ok(start <= START, command .. ": " .. bars .. ": at t = 0 the initial state", l[4])
      tap.ok(norm <= NORM, command .. ": " .. bars .. ": |q| = 1", l[5])
      tap.ok(momentum <= MOMENTUM, command .. ": " .. bars .. ": L in inertial axes is constant", l[6])
      tap.ok(energy <= ENERGY, command .. ": " .. bars .. ": T is constant", l[7])
    else
      local bar, norm_bar = BAR, NORM
      if kind == "float" then bar, norm_bar = FLOAT_BAR, FLOAT_NORM end
      local rates, angle, norm = tonumber(l[4]), tonumber(l[5]), tonumber(l[6])
      if not (l[3] ~= "refused" and rates <= bar and angle <= bar and norm <= norm_bar) then
        tap.ok(false, command .. ": " .. table.concat(l, " "))
      end
      local w = worst[kind]
      w[1], w[2], w[3] = w[1] + 1, math.max(w[2], rates or 0), math.max(w[3], angle or 0)
    end
  end
  judge_many(command, many)
  for _, kind in ipairs { "row", "tick", "same", "float" } do
    local w = worst[kind]
    tap.ok(w[1] >= (kind == "float" and 100 or 275) and w[2] > 0, string.format(
      "%s: %d samples, %s: rates to %.2g of the largest, attitude to %.2g", command, w[1], kind, w[2], w[3]))
  end
end

local states = tonumber(os.getenv "POLHODE_STATES" or "20000")
judge("gcc -std=c11 -O2 -ffp-contract=off", math.max(states, 100000))
judge("gcc -std=c11 -O3 -march=native -fno-math-errno -ffp-contract=fast", states)
judge("gcc -std=c11 -O3 -march=native -fno-math-errno -ffp-contract=off", states)
judge("clang -std=c11 -O1", states)

program.finish()
tap.done()
