#!/usr/bin/env lua5.4
-- arduino.t - gen --project arduino: the library and its example compiled with avr-g++ and run in simavr.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The core is a shim of the test's own (arduino/Arduino.h).  What the sketch prints on the AVR must be what it prints
-- on this machine, digit by digit, and its numbers those of the general library.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local cores = require "tests.target.cores"
local firmware = require "tests.emit.firmware"

local avr = cores.by_name.avr
local missing = cores.missing { avr }
if #missing > 0 or not cores.run "command -v avr-g++" then
  tap.skip("the Arduino library on an AVR", "install " .. table.concat(missing, " ") .. " gcc-avr")
  tap.done()
end

local dir = program.directory()
local SHIM = "tests/target/arduino"
local WARN = "-Wall -Wextra -Wshadow -Werror"

-- 200 steps of 1/4096 s: 21 rows, 10 steps between
local scene = (firmware.probe:gsub("horizon = 32", "horizon = exact(\"200/4096\")"))
local folder, why = firmware.make(dir, scene, "--project arduino")
if not tap.ok(folder, "gen --project arduino", why) then tap.done() end

local sketch = folder .. "/examples/probe_motion/probe_motion.ino"
local function build(prefix, flags, out)
  -- as the IDE does it: the library's C as gnu11, the sketch as gnu++11 with Arduino.h before it
  local words = string.format("%s -Os -ffunction-sections -fdata-sections %s -I%s/src", flags, WARN, folder)
  return cores.run("%sgcc %s -std=gnu11 -c %s/src/probe.c -o %s/probe.o && %sg++ %s -std=gnu++11 -DSHIM_LOOPS=25 -I%s "
    .. "-include Arduino.h -x c++ %s %s/shim.cpp -x none %s/probe.o -Wl,--gc-sections -o %s/%s", prefix, words,
    folder, dir, prefix, words, SHIM, sketch, SHIM, dir, dir, out)
end

local ok, text = build("", "-ffp-contract=off", "native")
tap.ok(ok, "library and example compile for this machine without a warning", text:sub(1, 2000))
local _, native = cores.run("%s/native", dir)
ok, text = build(avr.prefix, "-mmcu=atmega2560", "avr.elf")
tap.ok(ok, "and for the ATmega2560", text:sub(1, 2000))
local _, raw = cores.run("timeout -s KILL 60 simavr -m atmega2560 -f 16000000 %s/avr.elf", dir)

-- simavr colours each line of the UART and shows its end as a point
local lines = {}
for line in raw:gsub("\27%[%d*m", ""):gmatch "[^\n]+" do
  local row = line:match "^([%d.,%-]+)%.$" or line:match "^(t,[%w,]+)%.$"
  if row then lines[#lines + 1] = row end
end
local got = table.concat(lines, "\n") .. "\n"
tap.is(got, native, "the AVR prints what this machine prints, digit by digit")

local rows, times = {}, {}
for line in native:gmatch "[^\n]+" do
  local row = {}
  for word in line:gmatch "[^,]+" do row[#row + 1] = tonumber(word) end
  if row[1] then rows[#rows + 1] = row end
end
for i = 1, #rows do times[i] = (i - 1) * 10 / 4096 end
tap.is(#rows, 21, "21 rows: it stops at the end of its time")
-- 200 steps round each number by 2^-24 of at most 4, twice; the method's error is far less; six digits were cut
local truth, worst = firmware.truth(dir .. "/probe.lua", times), 0
for i, row in ipairs(rows) do
  for k = 1, 7 do worst = math.max(worst, math.abs(row[k + 1] - truth[i][k])) end
end
tap.ok(worst < 400 * 4 * 2.0 ^ -24 + 1e-6, "the numbers are the library's", worst)
local _, size = cores.run("avr-size %s/avr.elf", dir)
tap.diag("flash and RAM of the example on the AVR: " .. size:match "\n%s*(%d+)" .. " bytes, " ..
  tonumber(size:match "\n%s*%d+%s+(%d+)") + tonumber(size:match "\n%s*%d+%s+%d+%s+(%d+)") .. " bytes")

program.finish()
tap.done()
