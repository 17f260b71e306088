#!/usr/bin/env lua5.4
-- q31.t - the fixed-point step on small processors: the same words, and what a step takes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Instructions, not cycles (of the AVR: cycles), as cores.lua counts them: the same numbers each time, so the bound of
-- 2500 on a Cortex-M0, for a free body and for one with a limited torque about its principal axes, is a comparison of
-- whole numbers.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local cores = require "tests.target.cores"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local list = {}
for _, name in ipairs { "cortex-m0", "cortex-m3", "cortex-m4f", "rv32imac", "avr" } do
  list[#list + 1] = cores.by_name[name]
end
local missing = cores.missing(list)
if #missing > 0 then
  tap.skip("the fixed-point step on small processors", "missing: apt-get install --no-install-recommends " ..
    table.concat(missing, " "))
  tap.done()
end

local dir = program.directory()
local box = "solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 2.4 }"
local tensor = "tensor { mass = 400, xx = 150, yy = 210, zz = 260, xy = 10, xz = -5, yz = 3 }"
local scenes = { -- the most instructions on a Cortex-M0
  { "free", box, "ranges = { omega = 8 }", 2500 },
  { "control", box, "effects = { effect.control { max = 0.01 } }, ranges = { omega = 8 }", 2500 },
  { "oblique", tensor, "ranges = { omega = 8 }", 2500 },
  -- a rotor and damping about other axes are nine products more in each of the four stages
  { "everything", tensor, "effects = { effect.control { max = 2 }, " ..
    "effect.rotor { axis = { 1, 0, 1 }, momentum = 60 }, effect.damping { c = 2 } }, ranges = { omega = 8 }", 4500 },
}

for _, s in ipairs(scenes) do
  local at = dir .. "/" .. s[1]
  program.write(at .. ".lua", string.format("return scene { name = \"b\", body = %s, initial = { omega = { 0.1, 6, " ..
    "0.2 } }, %s }", s[2], s[3]))
  cores.must("%s gen %s.lua --with q31 -o %s", binary, at, at)
  for _, core in ipairs(list) do
    cores.build(core, at, "t.elf", "tests/target/q31.c " .. at .. "/b_q31.c", "")
    local n = cores.counts(core, at, "t.elf")
    local step, beyond, energy = (n[2] or 0) - n[1], (n[3] or 0) - n[1], (n[4] or 0) - n[1]
    tap.is(#n, 5, s[1] .. ", " .. core.name .. ": the self-test passes, word for word")
    cores.must("%sgcc %s -O2 -c -fstack-usage %s/b_q31.c -o %s/b_q31.o", core.prefix, core.flags, at, at)
    local stack = { 0, 0 } -- of the step, and the most of what it calls
    for line in string.gmatch(program.read(at .. "/b_q31.su"), "[^\n]+") do
      local name, bytes = string.match(line, "([%w_]+)\t(%d+)\t")
      local i = name == "b_q31_step" and 1 or 2
      stack[i] = math.max(stack[i], tonumber(bytes))
    end
    tap.diag(string.format("%s, %s: a step %d, beyond a limit %d, energy %d; stack %d bytes", s[1], core.name, step,
      beyond, energy, stack[1] + stack[2]))
    tap.ok(step > 300 and stack[1] + stack[2] <= 250, s[1] .. ", " .. core.name .. ": at most 250 bytes of stack")
    if core.name == "cortex-m0" then
      tap.ok(step <= s[4], s[1] .. ", cortex-m0: a step takes at most " .. s[4] .. " instructions", tostring(step))
    end
  end
end

program.finish()
tap.done()
