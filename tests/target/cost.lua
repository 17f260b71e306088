-- cost.lua -- what the closed form of the free top costs on a Cortex-M4F, in float: bytes and instructions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/target/cost.lua PROGRAM DIRECTORY
--
-- Emits bodies/brick_centroid.lua, compiles it for a Cortex-M4F, and prints two tables: bytes of the
-- object and of what a linker keeps of it (--gc-sections), and instructions a call under QEMU's board mps2-an386,
-- counted by a plugin (count.c), the call itself included.  Instructions, not cycles; the same numbers each time.  Says
-- which package is missing and does nothing if a tool is.

package.path = "./?.lua;" .. package.path

local cores = require "tests.target.cores"
local core, must = cores.by_name["cortex-m4f"], cores.must
local program, dir = arg[1], arg[2]

local missing = cores.missing { core }
if #missing > 0 then
  print("target-cost: skipped; missing: apt-get install --no-install-recommends " .. table.concat(missing, " "))
  os.exit(0)
end

local gcc = core.prefix .. "gcc " .. core.flags .. " -O2 -ffp-contract=off -fno-math-errno -ffunction-sections " ..
  "-fdata-sections"
local link = gcc .. " -nostartfiles --specs=nosys.specs -Wl,--gc-sections"
local name = "brick_centroid"

must("mkdir -p %s && %s gen bodies/%s.lua --layout single --with orbit --real float -o %s", dir, program, name, dir)
must("%s -std=c99 -c %s/%s.c -o %s/%s.o", gcc, dir, name, dir, name)

-- ---- bytes ----

-- Code and constants of a file.
local function bytes(file)
  return tonumber(string.match(must("arm-none-eabi-size %s", file), "\n%s*(%d+)"))
end

-- What is kept for some functions, of the object alone, and with what it needs of the C library.
local function kept(...)
  local roots = {}
  for i, f in ipairs { ... } do roots[i] = "-u " .. name .. "_" .. f end
  local first = name .. "_" .. (...)
  local list = table.concat(roots, " ")
  must("arm-none-eabi-ld -r --gc-sections -e %s %s %s/%s.o -o %s/kept.o", first, list, dir, name, dir)
  must("%s -Wl,-e,%s %s %s/%s.o -lm -o %s/kept.elf", link, first, (string.gsub(list, "-u ", "-Wl,-u,")), dir, name, dir)
  return bytes(dir .. "/kept.o"), bytes(dir .. "/kept.elf")
end

print "| what a linker keeps | bytes | with the C library |"
print "|---|---|---|"
print(string.format("| everything that was emitted | %d | |", bytes(dir .. "/" .. name .. ".o")))
for _, f in ipairs { { "solve", "at" }, { "at" }, { "at_rates" }, { "at_attitude" }, { "solve", "set_tick", "at_tick" },
  { "at_tick" }, { "step" } } do
  local own, all = kept(table.unpack(f))
  print(string.format("| `%s` | %d | %d |", table.concat(f, "`, `"), own, all))
end

-- ---- instructions ----

cores.build(core, dir, "cost.elf", string.format("-I tests/target tests/target/cost.c %s/%s.o", dir, name))
local counts = cores.counts(core, dir, "cost.elf")
assert(#counts == 11, "the firmware has not run to its end")

print ""
print "| call | instructions | near the separatrix |"
print "|---|---|---|"
local near = { solve = 9, at = 10, at_tick = 11 }
for i, f in ipairs { "solve", "set_tick", "at", "at_rates", "at_attitude", "at_tick", "step" } do
  local second = near[f] and counts[near[f]] - counts[1] or ""
  print(string.format("| `%s` | %d | %s |", f, counts[i + 1] - counts[1], second))
end
