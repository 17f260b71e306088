#!/usr/bin/env lua5.4
-- known.t - effects against motions that are known in closed form, by the library and by the emitted code.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The rows are in tests/effects/rows.lua.  Both roads integrate to 1e-12 a step; over 2 s, some tens of steps of
-- motions that do not part from each other, 1e-10 of the largest value is kept.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local rows = require "tests.effects.rows"

local dir = program.directory()
local quick = program.quick_compiler()
local binary = os.getenv "POLHODE" or "build/polhode"
local TOLERANCE = 1e-10

-- The row at time t: { column = number }, or nil and the messages.
local function run(engine, text, t)
  program.write(dir .. "/s.lua", text)
  local status = program.shell(string.format("%s timeout 100 %s run %s/s.lua --engine %s --method adaptive " ..
    "--tolerance 1e-12 --at %.17g >%s/out 2>%s/err", quick, binary, dir, engine, t, dir, dir))
  local head, last = program.read(dir .. "/out"):match "^([^\n]*)\n.-([^\n]*)\n$"
  if status ~= 0 or not last then return nil, status .. "\n" .. program.read(dir .. "/err") end
  local numbers, out = {}, {}
  for number in last:gmatch "[^,]+" do numbers[#numbers + 1] = tonumber(number) end
  for name in head:gmatch "[^,]+" do out[name] = table.remove(numbers, 1) end
  return out
end

for _, row in ipairs(rows.known) do
  for _, engine in ipairs { "general", "generated" } do
    local got, why = run(engine, row.scene, row.t)
    local worst, largest = 0, 0
    for name, x in pairs(row.want) do -- any order
      largest = math.max(largest, math.abs(x))
      worst = math.max(worst, got and math.abs(got[name] - x) or math.huge)
    end
    tap.ok(worst <= TOLERANCE * largest, row.about .. ", " .. engine, why or string.format("off by %.3g", worst))
  end
end
tap.ok(#rows.known > 0, "something is known")

tap.done(program.finish())
