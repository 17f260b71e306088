#!/usr/bin/env lua5.4
-- symmetric.t - the emitted closed forms of the free sphere and symmetric top: every sample of the reference table that
-- is one, about each axis in turn, and hard random states.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Four structures (axis x, y, z; sphere), each compiled once as double and once as float; symmetric.c measures.
-- Expected states: 32 digits, computed otherwise (tests/reference/README.md).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local dir = program.directory()

-- The requirement: 18 units of 2^-52 (two phases in turns, rounded once, two sines and cosines, a dozen operations on
-- numbers below 2; what is left of the set-up is 2^-100), |q| = 1 to two units, float the same count of 2^-23.
local BAR, NORM = 4e-15, 4e-16
local FLOAT_BAR, FLOAT_NORM = 4e-6, 4e-16 * 2.0 ^ 29
-- a quotient or two of numbers that are right to the last place: four units
local PERIOD = 4 * 2.0 ^ -52

local kinds = {
  { "x", 0, "xx = C, yy = A, zz = A", "symmetric" }, { "y", 1, "xx = A, yy = C, zz = A", "symmetric" },
  { "z", 2, "xx = A, yy = A, zz = C", "symmetric" }, { "sphere", 3, "xx = A, yy = A, zz = A", "sphere" },
}

for _, kind in ipairs(kinds) do
  local folder = dir .. "/" .. kind[1]
  program.shell("mkdir -p " .. folder)
  for _, s in ipairs { { "top", "double" }, { "small", "float" } } do
    local text = 'local A = param("A", 2, "kg m^2")\n' .. (kind[1] ~= "sphere" and
      'local C = param("C", 1, "kg m^2")\n' or "") .. 'return scene { name = "' .. s[1] ..
      '", body = tensor { mass = 1, ' .. kind[3] .. " } }\n"
    local job = assert(scene.read(text))
    job = scene.plan(job, { real = s[2] })
    tap.is(job.closed.kind, kind[4], kind[1] .. ": the closed form is that of the " .. kind[4])
    local files = scene.files(job)
    program.write(folder .. "/" .. s[1] .. ".h", files[s[1] .. ".h"])
    program.write(folder .. "/" .. s[1] .. ".c", files[s[1] .. ".c"])
  end
end

local function judge(kind, command, states)
  local folder, what = dir .. "/" .. kind[1], kind[1] .. ", " .. command
  local code = program.shell(string.format("(cd %s && %s -c top.c small.c) >%s/log 2>&1 && gcc -std=c11 -O1 " ..
    "-DAXIS=%d -Itests/reference -I%s -o %s/measure tests/emit/symmetric.c %s/top.o %s/small.o -lm >>%s/log 2>&1",
    folder, command, folder, kind[2], folder, folder, folder, folder, folder))
  if not tap.ok(code == 0, what .. ": compiles", program.read(folder .. "/log")) then return end
  tap.is(program.shell(string.format("timeout 300 %s/measure %d >%s/out", folder, states, folder)), 0, what .. ": runs")
  local bars = { row = BAR, tick = BAR, same = BAR, period = PERIOD, float = FLOAT_BAR }
  local worst, count = {}, {}
  for line in string.gmatch(program.read(folder .. "/out"), "[^\n]+") do
    local l = {}
    for word in string.gmatch(line, "%S+") do l[#l + 1] = word end
    if l[1] == "random" then
      tap.is(l[3], "0", what .. ": none of the random states is refused")
      for k, name in ipairs { "at t = 0 the initial state", "|q| = 1", "L in inertial axes is constant",
        "T is constant" } do
        local bar = k == 2 and NORM or k == 4 and 2 * BAR or BAR -- T counts each rate twice
        tap.ok(tonumber(l[3 + k]) <= bar, what .. ": " .. l[2] .. " random states: " .. name, l[3 + k])
      end
    else
      local rates, angle, norm = tonumber(l[4]), tonumber(l[5]), tonumber(l[6])
      if not (rates and rates <= bars[l[1]] and angle <= bars[l[1]] and
          norm <= (l[1] == "float" and FLOAT_NORM or NORM)) then
        tap.ok(false, what .. ": " .. line)
      end
      count[l[1]] = (count[l[1]] or 0) + 1
      worst[l[1]] = math.max(worst[l[1]] or 0, rates or 0, angle or 0)
    end
  end
  for _, name in ipairs { "row", "tick", "same", "period", "float" } do
    tap.ok((count[name] or 0) >= 5, string.format("%s: %d samples, %s: to %.2g", what,
      count[name] or 0, name, worst[name] or 0))
  end
end

for _, kind in ipairs(kinds) do
  judge(kind, "gcc -std=c11 -O2 -ffp-contract=off", 100000)
  judge(kind, "gcc -std=c11 -O3 -march=native -ffp-contract=fast", 20000)
  judge(kind, "clang -std=c11 -O1", 20000)
end
program.finish()
tap.done()
