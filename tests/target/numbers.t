#!/usr/bin/env lua5.4
-- numbers.t -- what calls take on small processors, against bars: instructions, stack, flash memory.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/target/numbers.t | grep '^# |'       the table of docs/targets.md
--
-- The free body with three moments (bodies/brick_centroid.lua) in float, -O2, own libm: a step of rk4 is that of a
-- free body's q and w.  Instructions are counted by QEMU's plugin and are the same each time; stack is what the
-- compiler says of the function (-fstack-usage) and what a call has overwritten of painted memory (stack.c).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local cores = require "tests.target.cores"
local machines = require "tests.target.machines"
local scenes = require "tests.target.scenes"
local jobs = require "tests.target.jobs"

local m4, m0 = machines.by_name["cortex-m4f"], machines.by_name["cortex-m0"]
local missing = machines.missing { m4, m0 }
if #missing > 0 then
  tap.skip("numbers of small processors", "missing: apt-get install --no-install-recommends " ..
    table.concat(missing, " "))
  tap.done()
end

local NAME = "brick_centroid"
local source = scenes.source(NAME, "float", "rk4,semi,midpoint,taylor,split4,exact", " --libm own")
local dir = string.match(source, "^(.*)/")
local names = string.format("-I %s -DSCENE=%s -DSCENE_H='\"%s.h\"'", dir, NAME, NAME)

-- Options of the linker that leave tests/target/console.c out.
local function bare(m)
  return { link = string.gsub(m.link, "%-Wl,%-%-wrap=main", ""), compile = m.compile, name = m.name,
    start = { "templates/target/startup.c" }, run = m.run }
end

local function object(m, level, file, flags, tag)
  return scenes.object(m, "gcc", level, file, "-I templates/target " .. names .. " " .. (flags or ""), { source }, tag)
end

local files, counted = {}, {}
for _, m in ipairs { m4, m0 } do
  local elf = dir .. "/" .. m.name .. ".steps.elf"
  scenes.program(bare(m), elf, { object(m, "-O2", source, "-fstack-usage"),
    object(m, "-O2", "tests/target/steps.c", "-std=gnu11") })
  files[#files + 1] = elf
  counted[m.name] = elf
end
local painted = scenes.output(m4, scenes.program(m4, dir .. "/stack.elf", { object(m4, "-O2", source, "-fstack-usage"),
  object(m4, "-O2", "tests/target/stack.c", "-std=gnu11") }))
files[#files + 1] = painted
-- Firmware with the scene's parameters as constants (--bake), and with NAME_init and its checks.
local loops = {}
for _, kind in ipairs { { level = "-Os", more = " --bake" }, { level = "-O2", more = " --bake" },
  { level = "-Os", more = "", about = " with NAME_init" } } do
  local plain = scenes.source(NAME, "float", "rk4", " --libm own" .. kind.more)
  local own = string.match(plain, "^(.*)/")
  local elf = scenes.program(bare(m4), own .. "/loop" .. kind.level .. ".elf", {
    scenes.object(m4, "gcc", kind.level, plain),
    scenes.object(m4, "gcc", kind.level, "tests/target/loop.c", "-std=gnu11 " ..
      string.gsub(names, "%-I %S*", "-I " .. own), { plain }, kind.more ~= "" and ".bake" or "") })
  kind.elf, kind.out = elf, scenes.output(m4, elf)
  loops[#loops + 1] = kind
  files[#files + 1] = kind.out
end
jobs.run(scenes.dir, "numbers", files)

local CALLS = { "step", "semi_step", "midpoint_step", "taylor_step", "split4_step", "solve", "set_tick", "at",
  "at_tick" }
local n = {}
for _, m in ipairs { m4, m0 } do
  local counts = cores.counts(m.core, dir, m.name .. ".steps.elf")
  if not tap.is(#counts, #CALLS + 1, m.name .. ": the firmware has run to its end") then
    tap.diag(jobs.slurp(counted[m.name] .. ".log") or "")
    tap.done()
  end
  n[m.name] = {}
  for i, f in ipairs(CALLS) do n[m.name][f] = counts[i + 1] - counts[1] end
end

tap.diag "| number | measured | limit |"
tap.diag "|---|---|---|"
local function bar(got, most, what)
  tap.diag(string.format("| %s | %d | %d |", what, got, most))
  tap.ok(got <= most, what .. ": at most " .. most, "got " .. got)
end

bar(n["cortex-m4f"].step, 520, "Cortex-M4F: a step of rk4, instructions")
bar(n["cortex-m4f"].at, 500, "Cortex-M4F: `NAME_at`, instructions")
bar(n["cortex-m0"].step, 20000, "Cortex-M0: a step of rk4, instructions")

local said = jobs.slurp((string.gsub(object(m4, "-O2", source, "-fstack-usage"), "o$", "su"))) or ""
bar(tonumber(string.match(said, NAME .. "_step\t(%d+)\tstatic")) or math.huge, 250,
  "Cortex-M4F: stack of a step of rk4 by the compiler, bytes")
local text = jobs.slurp(painted) or ""
bar(tonumber(string.match(text, "step (%d+)\n")) or math.huge, 250,
  "Cortex-M4F: stack of a step of rk4, painted, bytes")
tap.diag("painted: " .. string.gsub(text, "\n", ", "))

for _, loop in ipairs(loops) do
  local about = string.format("firmware of %s%s%s", loop.level, loop.more, loop.about or "")
  tap.like(jobs.slurp(loop.out) or "", "status 0\n", about .. " runs: |q| = 1 after 1000 steps")
  local code, data = string.match(cores.must("arm-none-eabi-size %s", loop.elf), "\n%s*(%d+)%s+(%d+)%s")
  about = "Cortex-M4F: " .. about .. ", start-up, loop and step, bytes of flash"
  bar(code + data, 1800, about)
end

-- a count that cannot be exceeded would be no test: the same step without its floating point unit is beyond the bar
tap.ok(n["cortex-m0"].step > 520, "the count tells processors apart")
tap.done()
