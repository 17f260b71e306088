#!/usr/bin/env lua5.4
-- selftest.t -- the emitted self-tests, unchanged, on every machine: each line ok, the plan complete, status 0.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The scenes and levels are those of bits.lua, and the objects too: each is compiled once.  A Cortex-M0 has the 16 kB
-- of RAM and 256 kB of flash of its board, the AVR (atmega2560) 8 kB and 256 kB.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local cores = require "tests.target.cores"
local machines = require "tests.target.machines"
local scenes = require "tests.target.scenes"
local bits = require "tests.target.bits"
local jobs = require "tests.target.jobs"

local mode = os.getenv "POLHODE_BITS" -- all: every scene on each machine, in both types
local missing = machines.missing(machines.list)
if #missing > 0 then
  tap.skip("self-tests on other machines", "missing: apt-get install --no-install-recommends " ..
    table.concat(missing, " "))
  tap.done()
end

local runs, files = {}, {}
for k, m in ipairs(machines.list) do
  for i, s in ipairs(bits.scenes) do
    for _, real in ipairs { "float", "double" } do
      local chosen = bits.chosen(m, k, i, real, "gcc") or mode == "all" and (m.doubles or real == "float")
      if m.name ~= "host" and chosen then
        local source = bits.source(s, real)
        local test = string.gsub(source, "%.c$", "_test.c")
        local level = bits.level[m.name].gcc
        local objects = { scenes.object(m, "gcc", level, source), scenes.object(m, "gcc", level, test) }
        local elf = scenes.program(m, (string.gsub(objects[2], "%.o$", ".elf")), objects)
        local out = scenes.output(m, elf)
        files[#files + 1] = out
        runs[#runs + 1] = { m = m, s = s, real = real, out = out, elf = elf }
      end
    end
  end
end
jobs.run(scenes.dir, "selftest", files)

-- The defect of a TAP text, or nil; the number of its tests and what it says of its stack.
local function defect(text)
  local n = 0
  for line in string.gmatch(text, "[^\n]+") do
    local k = tonumber(string.match(line, "^ok (%d+) %- "))
    if k then
      n = n + 1
      if k ~= n then return "line " .. n .. " has the number " .. k end
    elseif not string.find(line, "^#") and line ~= "TAP version 13" and line ~= "1.." .. n and
        not string.find(line, "^status ") then
      return "unexpected: " .. line
    end
  end
  if not string.find(text, "^TAP version 13\n") then return "no head line" end
  if not string.find(text, "\n1.." .. n .. "\n", 1, true) or n < 5 then return "no plan of " .. n .. " tests" end
  if not string.find(text, "\nstatus 0\n$") then return "not status 0" end
  return nil, n, tonumber(string.match(text, "\n# stack: (%d+) bytes"))
end

local whole = "TAP version 13\n" .. string.gsub("ok 1 - a\nok 2 - b\nok 3 - c\nok 4 - d\nok 5 - e\n", "", "")
tap.is(defect(whole .. "1..5\nstatus 0\n"), nil, "a whole self-test is accepted")
tap.ok(defect(string.gsub(whole, "\nok 3", "\nnot ok 3") .. "1..5\nstatus 0\n"), "a failed line is noticed")
tap.ok(defect(whole .. "status 0\n"), "so is a missing plan")
tap.ok(defect(whole .. "1..6\nstatus 0\n"), "and a wrong one")
tap.ok(defect(whole .. "1..5\nstatus 1\n"), "and a status")

local of = {}
for _, run in ipairs(runs) do
  local text = jobs.slurp(run.out)
  local why, n, stack = "not built or not run: " .. (jobs.slurp(run.elf .. ".log") or ""), nil, nil
  if text then why, n, stack = defect(text) end
  local title = string.format("%s, %s, %s, %s", run.m.name, run.s.scene, run.real, string.match(run.s.methods, "%w+"))
  if why then
    tap.ok(false, title, why .. "\n" .. (text or ""))
  else
    tap.ok(true, string.format("%s: %d tests%s", title, n, stack and ", stack " .. stack .. " bytes" or ""))
  end
  if run.m.name == "cortex-m0" and text then
    local code, data = string.match(cores.must("arm-none-eabi-size %s", run.elf), "\n%s*(%d+)%s+(%d+)")
    of[#of + 1] = code + data
  end
end
tap.ok(#of > 0 and math.max(table.unpack(of)) <= 256 * 1024, "on the Cortex-M0 each fits in 256 kB of flash",
  table.concat(of, " "))

tap.done()
