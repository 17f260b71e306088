#!/usr/bin/env lua5.4
-- selftest.t -- the emitted self-tests, unchanged, on every machine: each line ok, the plan complete, status 0.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local machines = require "tests.target.machines"
local scenes = require "tests.target.scenes"
local jobs = require "tests.target.jobs"

-- One of each kind of emitted code; method: the stepper that becomes NAME_step and is tested as such.
local CASES = {
  { scene = "brick_centroid" }, -- free, three moments: theta functions
  { scene = "symmetric_top" }, -- free, two equal moments: sines
  { scene = "heavy_top" }, -- gravity about a fixed point: Lagrange's top
  { scene = "gyrostat" }, -- a rotor inside
  { scene = "thruster" }, -- parameters, a table, a function of time
  { scene = "foucault" }, -- position, a turning frame, an own closed form
  { scene = "kapitza", method = "semi" }, -- a shaken pivot
  { scene = "brick_centroid", method = "taylor" },
  { scene = "heavy_top", method = "midpoint" },
  { scene = "symmetric_top", method = "split4" },
}

local missing = machines.missing(machines.list)
if #missing > 0 then
  tap.skip("self-tests on other machines", "missing: apt-get install --no-install-recommends " ..
    table.concat(missing, " "))
  tap.done()
end

-- Double where the machine has it in hardware, or where it is another one altogether.
local DOUBLE = { ["cortex-m7"] = true, aarch64 = true, mips = true, rv32imac = true }

local runs, files = {}, {}
for _, case in ipairs(CASES) do
  for _, real in ipairs { "float", "double" } do
    for _, m in ipairs(machines.list) do
      if m.name ~= "host" and (real == "float" or DOUBLE[m.name]) then
        local source = scenes.source(case.scene, real, case.method)
        local test = string.gsub(source, "%.c$", "_test.c")
        jobs.rule(test, { source }, "touch " .. test)
        local objects = { scenes.object(m, "gcc", "-O1", source), scenes.object(m, "gcc", "-O1", test) }
        local elf = scenes.program(m, string.gsub(objects[2], "%.o$", ".elf"), objects)
        local out = scenes.output(m, elf)
        files[#files + 1] = out
        runs[#runs + 1] = { m = m, case = case, real = real, out = out, elf = elf }
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

tap.ok(defect "TAP version 13\nok 1 - a\nnot ok 2 - b\n1..2\nstatus 1\n", "a failed line is noticed")

for _, run in ipairs(runs) do
  local text = jobs.slurp(run.out)
  local why, n, stack = "not built or not run: " .. (jobs.slurp(run.elf .. ".log") or ""), nil, nil
  if text then why, n, stack = defect(text) end
  local title = string.format("%s, %s, %s%s", run.m.name, run.case.scene, run.real,
    run.case.method and ", " .. run.case.method or "")
  if why then
    tap.ok(false, title, why .. "\n" .. (text or ""))
  else
    tap.ok(true, string.format("%s: %d tests%s", title, n, stack and ", stack " .. stack .. " bytes" or ""))
  end
end

tap.done()
