#!/usr/bin/env lua5.4
-- firmware.t - gen --project firmware on an emulated Cortex-M4F: 10^6 steps against the library, bits against this
-- machine's, the clock, what a processor fault reports, and how large it all is.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local cores = require "tests.target.cores"
local firmware = require "tests.emit.firmware"

local core = cores.by_name["cortex-m4f"]
local missing = cores.missing { core }
if #missing > 0 then
  tap.skip("firmware on an emulated Cortex-M4F", "install " .. table.concat(missing, " "))
  tap.done()
end

local dir = program.directory()
local QEMU = "qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none -chardev stdio,id=out "
  .. "-semihosting-config enable=on,target=native,chardev=out "

-- All lines but the stack's bytes, which only the target knows.
local function same_lines(text) return (text:gsub("(R %x+ %x+ %x+) %x+", "%1")) end

local function bytes(folder, elf) -- flash, RAM without the stack
  local text = firmware.run(folder, "arm-none-eabi-size " .. elf)
  local code, data, bss = text:match "(%d+)%s+(%d+)%s+(%d+)%s+%d+%s+%x+%s+%S+\n$"
  return tonumber(code) + tonumber(data), tonumber(data) + tonumber(bss)
end

-- ---- propagation alone, 10^6 steps ----

local N, EVERY, STEP = 1000000, 62500, 1 / 4096
local folder = assert(firmware.make(dir, firmware.probe, "--project firmware"))
local scene = dir .. "/probe.lua"
local long = string.format("CYCLES=%d EVERY=%d", N, EVERY)
local target, fine = firmware.run(folder, "make -s run-predict " .. long)
tap.ok(fine, "propagation alone builds without a warning and runs 10^6 steps", target:sub(1, 2000))
local host = firmware.run(folder, "make -s host-predict " .. long)
tap.is(same_lines(target), same_lines(host), "10^6 steps on the target: every line is this machine's, bit for bit")
local lines = firmware.read(target)
tap.ok(#lines.S == N // EVERY + 1 and lines.R[1][2] == 0, "and the watchdog has found nothing")

-- Against the library (long double inside).  The method's error is that of rk4 at w h = 3/4096: (w h)^4/120 of each
-- radian, 732 of them: 2e-12.  Moments of inertia are rounded (3 units of 2^-24 each in their quotient), so that
-- rates of the motion are off by at most 2e-7: 1.5e-4 rad.  Each step rounds each rate by at most 2^-23 (|w| < 4), a
-- standard deviation of 2^-22/sqrt(12) = 6.9e-8 rad/s if it falls as chance has it.  After N steps a rate is off by
-- 6.9e-8 sqrt(N), the angle by h 6.9e-8 sqrt(N^3/3); three axes, and four standard deviations for what is not chance.
local sigma = 2.0 ^ -22 / math.sqrt(12)
local times = {}
for i = 1, N // EVERY do times[i] = i * EVERY * STEP end
local truth = firmware.truth(scene, times)
local worst_angle, worst_rate, within = 0, 0, true
for i, x in ipairs(truth) do
  local got, n = lines.S[i + 1], i * EVERY
  local dot, rate = 0, 0
  for k = 1, 4 do dot = dot + x[k] * got[k + 1] end
  for k = 5, 7 do rate = math.max(rate, math.abs(x[k] - got[k + 1])) end
  local angle = 2 * math.sqrt(math.max(0, 2 - 2 * math.abs(dot))) -- of the rotation between; small
  local phase = 4 * math.sqrt(3) * STEP * sigma * math.sqrt(n ^ 3 / 3) + 1.5e-4 * n / N + 1e-5
  within = within and angle <= phase and rate <= 4 * math.sqrt(3) * sigma * math.sqrt(n) + 3 * phase
  worst_angle, worst_rate = math.max(worst_angle, angle), math.max(worst_rate, rate)
end
tap.ok(within, "and the states are the library's, to what 10^6 roundings of float may do")
tap.diag(string.format("10^6 steps, 732 rad: attitude off by at most %.2g rad, rates by %.2g rad/s", worst_angle,
  worst_rate))

-- ---- with gyro and filter ----

target, fine = firmware.run(folder, "make -s run")
tap.ok(fine, "the filter builds without a warning and runs on the target", target:sub(1, 2000))
host = firmware.run(folder, "make -s host")
tap.is(same_lines(target), same_lines(host), "state, variances and innovations are this machine's, bit for bit")

-- ---- the clock ----

-- 1 ns an instruction in QEMU's own time: a cycle of 1/4096 s is long, and while it waits that time jumps ahead.
local function paced(more, shift, cycles)
  return firmware.run(folder, string.format("rm -f build/firmware.elf; make -s build/firmware.elf "
    .. "DEFS='-DAPP_CYCLES=%d %s' && %s -icount shift=%d,sleep=off -kernel build/firmware.elf", cycles, more, QEMU,
    shift))
end
target, fine = paced("", 0, 256)
lines = firmware.read(target)
tap.ok(fine and #lines.S == 17 and #lines.E == 0 and lines.R[1][1] == 256, "paced by SysTick: 256 cycles, none is late",
  target:sub(1, 2000))
-- 1024 ns an instruction: the filter's thousands take milliseconds, a cycle has 0.24
target, fine = paced("", 10, 256)
lines = firmware.read(target)
tap.ok(not fine and #lines.E == 8 and lines.E[8][2] == 6 and lines.R[1][2] == 8,
  "on a processor that is too slow late cycles are reported, and after 8 it stops", target:sub(1, 2000))

-- ---- faults ----

local function injected(kind)
  return firmware.run(folder, "rm -f build/run-128-64.elf; make -s build/run-128-64.elf CYCLES=128 EVERY=64 "
    .. "DEFS=-DAPP_INJECT=" .. kind .. " && " .. QEMU .. "-kernel build/run-128-64.elf; echo status $?")
end
target = injected "4"
lines = firmware.read(target)
local list = firmware.run(folder, "arm-none-eabi-nm build/run-128-64.elf")
local at = tonumber(list:match "(%x+) T inject\n", 16)
local found = lines.F[1] or { 0, 0, 0, 0 }
tap.ok(found[1] >= at and found[1] < at + 64, "an undefined instruction: the report has where it was", target)
-- CFSR bit 16 UNDEFINSTR, HFSR bit 30 FORCED: ARMv7-M Architecture Reference Manual, B3.2.15 and B3.2.16
tap.ok(found[3] == 1 << 16 and found[4] == 1 << 30, "and what it was: UNDEFINSTR, escalated", target)
tap.like(target, "status 99", "and the exit status is 99")
target = injected "2"
lines = firmware.read(target)
tap.ok(#lines.E == 1 and lines.E[1][1] == 100 and lines.E[1][2] == 1, "a NaN on the target is reported in its cycle",
  target)

-- ---- how large ----

-- Instructions of whole cycles: between port_wait and port_wait all but the wait itself.
local function cycle_cost(elf)
  cores.must("cc -std=c11 -O2 -shared -fPIC templates/target/count.c -o %s/count.so", dir)
  local names = firmware.run(folder, "arm-none-eabi-nm " .. elf)
  firmware.run(folder, string.format("%s -plugin %s/count.so,begin=0x%s,end=0x%s -d plugin -D counts -kernel %s", QEMU,
    dir, names:match "(%x+) T estimator_predict\n", names:match "(%x+) T port_wait\n", elf))
  local common, of = nil, {}
  for line in io.lines(folder .. "/counts") do
    local n = tonumber(line:match "^%d+")
    of[n] = (of[n] or 0) + 1
    if not common or of[n] > of[common] then common = n end
  end
  return common
end

folder = assert(firmware.make(dir, firmware.probe, "--bake --project firmware"))
local function built(make, elf, what)
  local _, ok = firmware.run(folder, "rm -f " .. elf .. "; make -s " .. make)
  local text = ok and firmware.run(folder, QEMU .. "-kernel " .. elf) or ""
  local stack = firmware.read(text).R[1]
  local flash, ram = bytes(folder, elf)
  stack = stack and stack[4] or 1 << 20
  local cost = cycle_cost(elf)
  tap.diag(string.format("%s: flash %d, RAM %d and stack %d bytes, %d instructions a cycle", what, flash, ram, stack,
    cost))
  return flash, ram, stack, cost
end
local flash, _, stack, cost = built("build/predict-64-64.elf CYCLES=64 EVERY=64 DEFS=-DAPP_WATCHDOG=0",
  "build/predict-64-64.elf", "stepper, start-up and loop, -Os")
tap.ok(flash <= 1800, "stepper, start-up and loop: at most 1800 bytes of flash", flash)
tap.ok(stack <= 300 and cost <= 520, "at most 300 bytes of stack and 520 instructions a cycle", stack .. " " .. cost)
built("build/predict-64-64.elf CYCLES=64 EVERY=64", "build/predict-64-64.elf", "with the watchdog, -Os")
flash, _, stack = built("build/run-64-64.elf CYCLES=64 EVERY=64", "build/run-64-64.elf", "with gyro and filter, -Os")
tap.ok(flash < 16384 and stack < 1024, "all of it: less than 16 kB of flash and 1 kB of stack")
local symbols = firmware.run(folder, "arm-none-eabi-nm build/run-64-64.elf")
tap.ok(not symbols:find "malloc" and not symbols:find "__aeabi_d" and not symbols:find "printf" and
  not symbols:find "_sbrk", "no heap, no printf, no arithmetic of doubles is linked", symbols)

program.finish()
tap.done()
