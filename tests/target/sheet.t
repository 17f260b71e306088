#!/usr/bin/env lua5.4
-- sheet.t - the counted cost sheet (gen --target, explain --target) against other ways to the same numbers.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Instructions: RV32 counts its own (minstret), without the plugin; on the M4F the firmware of cost.lua is another
-- program under it.  Stack: paint.  Bytes: size(1).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local json = require "tests.json"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local cores = require "tests.target.cores"
local driver = require "generator.driver"
local calls = require "generator.emit.calls"

local NAMES = { "cortex-m4f", "rv32imac", "avr" }
local binary = os.getenv "POLHODE" or "build/polhode"

local list = {}
for i, name in ipairs(NAMES) do list[i] = cores.by_name[name] end
local missing = cores.missing(list)
if #missing > 0 then
  tap.skip("the counted cost sheet", "apt-get install --no-install-recommends " .. table.concat(missing, " "))
  tap.done()
end

local dir = program.directory()
local function polhode(format, ...)
  local status = program.shell(string.format("%s " .. format .. " > %s/out 2> %s/err", binary, ...))
  return status, program.read(dir .. "/out"), program.read(dir .. "/err")
end

-- rows[core][function] = {count, flash, stack}
local SCENE, targets, rows = "brick_centroid", {}, {}
do
  local status, out, err = polhode("explain bodies/%s.lua --real float --target %s --format json", SCENE,
    table.concat(NAMES, ","), dir, dir)
  if not tap.is(status, 0, "explain --target counts on three cores") then
    tap.diag(err)
    tap.done()
  end
  for _, t in ipairs(json.read(out).counted.targets) do
    targets[t.name], rows[t.name] = t, {}
    for _, f in ipairs(t.functions) do
      rows[t.name][f["function"]] = { count = f.instructions or f.cycles, flash = f.flash, stack = f.stack,
        bound = f.stack_is_bound }
    end
  end
end

-- The emitted code, and the sheet's own program with other marks.
local job = scene.plan(scene.file("bodies/" .. SCENE .. ".lua"), { real = "float" })
job.templates["templates/target/calls.c"] = program.read "templates/target/calls.c"
local made = driver.code(job).code
local plan = calls.of(job, { made })
program.shell("mkdir -p " .. dir .. "/own " .. dir .. "/other")
program.write(dir .. "/own/" .. SCENE .. ".h", made.header)
program.write(dir .. "/own/" .. SCENE .. ".c", made.source)
program.write(dir .. "/other/calls.c", plan.program)
program.write(dir .. "/other/marks.h", program.read "tests/target/sheet_marks.h")

-- ---- the processor's own count, and paint ----

local function painted(core, options)
  local own = dir .. "/other"
  cores.build(core, own, core.name .. ".elf", own .. "/calls.c " .. dir .. "/own/" .. SCENE .. ".c",
    "-I" .. dir .. "/own")
  program.shell(string.format("timeout 60 %s -nographic -monitor none %s -kernel %s/%s.elf > %s/%s.text 2>&1", core.run,
    options, own, core.name, own, core.name))
  local found = {}
  for n, deep in string.gmatch(program.read(own .. "/" .. core.name .. ".text"), "(%x+) (%x+)\n") do
    found[#found + 1] = { tonumber(n, 16), tonumber(deep, 16) }
  end
  return found
end

for _, case in ipairs { { "rv32imac", "-serial stdio -icount shift=0,sleep=off" }, { "cortex-m4f", "-serial none" } } do
  local name, found = case[1], painted(cores.by_name[case[1]], case[2])
  local half = #found // 2 -- as calls.c does, all twice; the first of each half is no call
  tap.is(half, #plan.list + 1, name .. ": the program with other marks has run to its end")
  local different, shallow, off, idle = {}, {}, 0, 0
  for i, f in ipairs(plan.list) do
    local row, own = rows[name][f.name], found[half + 1 + i]
    local count = own[1] - found[half + 1][1]
    if count ~= row.count then different[#different + 1] = f.name .. " " .. count .. " " .. row.count end
    if not row.bound or row.stack < own[2] then shallow[#shallow + 1] = f.name .. " " .. own[2] .. " " .. row.stack end
    if own[2] > 0 then off, idle = off + 1, idle + (row.stack <= 1.5 * own[2] + 64 and 0 or 1) end
  end
  if name == "rv32imac" then
    tap.is(table.concat(different, ", "), "", "rv32imac: of every function what the core retired was counted")
  end
  tap.is(table.concat(shallow, ", "), "", name .. ": the stack's bound holds for what was painted")
  -- a bound that is always twice too large would be none; branches not taken explain a few
  tap.ok(idle <= off // 4, name .. ": of most functions the run comes near the bound", idle .. " of " .. off ..
    " do not")
end

-- ---- another program ----

do
  local ORDER = { "solve", "set_tick", "at", "at_rates", "at_attitude", "at_tick", "step" }
  -- Not quite the same call: another time, arguments in other places.  On the way that these numbers take nothing
  -- branches by them, so some instructions apart is all.
  local core, own = cores.by_name["cortex-m4f"], dir .. "/own"
  cores.build(core, own, "cost.elf", "-I tests/target tests/target/cost.c " .. own .. "/" .. SCENE .. ".c")
  local counts = cores.counts(core, own, "cost.elf")
  for i, f in ipairs(ORDER) do
    tap.near(rows[core.name][f].count, counts[i + 1] - counts[1], 0, 12,
      core.name .. ": " .. f .. " takes what cost.c counts", "moves of arguments, a branch by the sign of a time")
  end
end

-- ---- bytes ----

for _, core in ipairs(list) do
  local own, script = dir .. "/own/", core.script and "-L templates/target -T " .. core.script or ""
  local wrong = {}
  cores.must("%sgcc %s -O2 -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -std=c99 -w " ..
    "-c %s%s.c -o %sx.o", core.prefix, core.flags, own, SCENE, own)
  for _, f in ipairs { "step", "solve", "at_tick", "principal", "linearised" } do
    cores.must("%sgcc %s -nostartfiles %s %s -Wl,--gc-sections,-e,%s_%s -Wl,-u,%s_%s %sx.o -lm -o %sx.elf", core.prefix,
      core.flags, core.arm and "--specs=nosys.specs" or "", script, SCENE, f, SCENE, f, own, own)
    local code, data = string.match(cores.must("%ssize %sx.elf", core.prefix, own), "\n%s*(%d+)%s+(%d+)")
    -- tables are aligned to 8 bytes at most, and the linker fills what is left before them by the order of the files
    if math.abs(code + data - rows[core.name][f].flash) >= 8 then
      wrong[#wrong + 1] = f .. " " .. code + data .. " " .. rows[core.name][f].flash
    end
  end
  tap.is(table.concat(wrong, ", "), "", core.name .. ": bytes of flash are those that size(1) tells")
  -- an array of a negative size does not compile
  local t = targets[core.name]
  program.write(own .. "sizes.c", string.format('#include "%s.h"\nchar model[sizeof(%s_model) == %d ? 1 : -1], ' ..
    "orbit[sizeof(%s_orbit) == %d ? 1 : -1], state[4*7 == %d ? 1 : -1];\n", SCENE, SCENE, t.model, SCENE, t.orbit,
    t.state))
  tap.ok(cores.run("%sgcc %s -std=c99 -c %ssizes.c -o %ssizes.o", core.prefix, core.flags, own, own),
    core.name .. ": model, orbit and state have the bytes that the compiler knows")
  -- avr-gcc keeps constants among the variables
  tap.ok(core.name == "avr" or targets[core.name].ram == 0, core.name .. ": the emitted code has no variables")
end

-- ---- the README ----

do
  local same = {}
  for i = 1, 2 do
    tap.is(polhode("gen bodies/dropped_stone.lua --target cortex-m4f -o %s/g%d", dir, i, dir, dir), 0,
      "gen --target writes files")
    same[i] = program.read(dir .. "/g" .. i .. "/README.md")
  end
  tap.is(same[1], same[2], "the README is the same twice")
  tap.like(same[1], "| step | ", "it has the step")
  tap.like(same[1], "polhode gen dropped_stone.lua --target cortex-m4f", "it has the command that makes it again")
  local counted = string.match(same[1], "Counted:.*")
  tap.like(counted or "", "arm%-none%-eabi%-gcc %d+%.%d+%.%d+ %-mcpu=cortex%-m4", "it says which compiler", true)
  tap.like(counted or "", "Instructions, not cycles", "it says that instructions are no cycles")
  for name in string.gmatch(program.read(dir .. "/g1/dropped_stone.h"), "%f[%w_]dropped_stone_([%w_]+)%([^()]*%);") do
    if not string.find(counted or "", "\n| " .. name .. " | %d+ | %d+ | %d+ |") then
      tap.ok(false, "the README has a whole row for " .. name)
    end
  end
end

program.finish()
tap.done()
