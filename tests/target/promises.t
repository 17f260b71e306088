#!/usr/bin/env lua5.4
-- promises.t - on Cortex-M4F and M0: what emitted objects call, and how deep their stack goes, computed and painted.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Objects as the emitted Makefile compiles them (-O2 -ffp-contract=off), with -fno-math-errno.  With its own
-- mathematical functions an object calls nothing but the compiler's arithmetic where the processor has none, and in
-- float none of double.  The bound is generator/cost/stack.lua's, from gcc's graph of calls and a disassembly.  Under
-- QEMU every public function is called on the scene's own state: what it used must be within its bound, and a step,
-- which has no rare branch, must reach it.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local calls = require "tests.promises.calls"
local cores = require "tests.target.cores"
local judge = require "tests.promises.judge"
local program = require "tests.cli.program"
local projects = require "tests.promises.projects"
local stack = require "generator.cost.stack"

local m4, m0 = cores.by_name["cortex-m4f"], cores.by_name["cortex-m0"]
local missing = cores.missing { m4, m0 }
if #missing > 0 then
  tap.skip("promises on small processors", "apt-get install " .. table.concat(missing, " "))
  tap.done()
end

local DEPTH = 32768 -- what is painted
-- The M0's own board has 16 kB for all; its code runs on an M3 just as well, and takes the same stack.
m0 = setmetatable({ run = cores.by_name["cortex-m3"].run, link = cores.by_name["cortex-m3"].link }, { __index = m0 })

local dir = program.directory()

-- What a step may stay below its bound: a slot at the frame's end that only aligns, and in software the deepest of the
-- functions of arithmetic, a comparison's, where the numbers did not lead there.
local SLACK = 24

-- {core, scene, real, options}
local rows = {
  { m4, "brick", "float", "" }, { m4, "heavy_top", "float", "" }, { m4, "dropped_stone", "float", "" },
  { m4, "gyrostat", "float", "--method rk4,exact,adaptive,taylor,midpoint,semi,split4" },
  { m4, "dual_spin", "float", "--bake --with jacobians" }, { m4, "wheels", "float", "" },
  { m4, "brick", "double", "--libm own" }, { m4, "heavy_top", "double", "--libm system" },
  { m0, "coin", "float", "" }, { m0, "paddle", "double", "--libm own" },
}

-- The compiler's arithmetic: conversions and integers of 64 bits everywhere; float and double where there is no unit.
local function arithmetic(name, core, real)
  local word = string.match(name, "^__aeabi_(%w+)$")
  if not word then return string.find(name, "^__gnu_thumb1_case_") or name == "__clzsi2" or name == "__clzdi2" end
  local double = string.find(word, "^c?d") or string.find(word, "2d$")
  if string.find(word, "^u?idiv") or string.find(word, "^u?ldiv") or string.find(word, "^l%a+$") then return true end
  if double then return real == "double" end
  return core == m0 or string.find(word, "u?l2f") or string.find(word, "f2u?lz")
end

local function symbols(p, core, nm)
  local faults = judge.symbols(string.gsub(nm, " +U [^\n]+\n", ""), p, "-O2")
  for name in string.gmatch(nm, "U ([^\n]+)") do
    local base = p.real == "float" and string.match(name, "^(.*)f$") or p.real == "double" and name
    local known = arithmetic(name, core, p.real)
      or not p.own and judge.math[base]
      -- gcc 12 makes these of structures of doubles, which are too large for its registers
      or p.real == "double" and (name == "memcpy" or name == "memset")
      or core == m0 and judge.instructions[base] -- the root
      or p.real == "double" and base == "sqrt" -- of which the M4F has one in float only
    if not known then faults[#faults + 1] = "undefined symbol " .. name end
  end
  return faults
end

local table_rows = {}

for n, row in ipairs(rows) do
  local core, where = row[1], dir .. "/" .. n
  local p = projects.one(where, "bodies/" .. row[2] .. ".lua", row[3], row[4])
  local title = core.name .. ", " .. p.title
  local text, names = calls.of(p.name, p.header, DEPTH)
  program.write(p.where .. "/calls.h", text)
  local options = core.flags .. " -O2 -ffp-contract=off -fno-math-errno -fcallgraph-info=su -ffunction-sections"
  cores.must("cd %s && %sgcc -std=c99 %s -c %s.c", p.where, core.prefix, options, p.name)
  cores.must("%sgcc -std=gnu11 %s -I%s -c tests/promises/paint.c -o %s/paint.o", core.prefix, options, p.where, p.where)
  cores.must("cd %s && %sgcc %s -Wl,--gc-sections -L $OLDPWD/templates/target %s -o all.elf " ..
    "$OLDPWD/templates/target/startup.c paint.o %s.o -lm", p.where, core.prefix, core.flags,
    string.gsub(core.link, "%-L %S+ ", ""), p.name)
  local base = p.where .. "/" .. p.name
  local faults = symbols(p, core, cores.must("%snm %s.o", core.prefix, base))
  for _, list in ipairs { judge.sections(cores.must("%sobjdump -h %s.o", core.prefix, base)),
    judge.calls(program.read(base .. ".ci")) } do
    for _, f in ipairs(list) do faults[#faults + 1] = f end
  end
  tap.ok(#faults == 0, title .. ": calls only what the compiler's arithmetic needs, no data, no recursion",
    table.concat(faults, "\n"))

  -- ---- the bound ----

  local graph = stack.read(program.read(base .. ".ci"))
  stack.read(program.read(p.where .. "/paint.ci"), graph)
  stack.disassembly(cores.must("%sobjdump -d %s/all.elf", core.prefix, p.where),
    cores.must("%snm %s/all.elf", core.prefix, p.where), graph)
  local bounds, unbounded = {}, {}
  for _, f in ipairs(stack.worst(graph)) do
    bounds[f.name] = bounds[f.name] or f
    if f.public and f.name ~= "main" and (#f.missing > 0 or f.cycle or f.dynamic or f.indirect) then
      unbounded[#unbounded + 1] = f.name .. ": " .. table.concat(f.missing, " ")
    end
  end
  tap.ok(#unbounded == 0, title .. ": every public function has a bound", table.concat(unbounded, "\n"))

  -- ---- what is used ----

  local said = cores.must("timeout 60 %s -nographic -monitor none -serial none -kernel %s/all.elf", core.run, p.where)
  local beyond, painted = {}, {}
  for k, bytes in string.gmatch(said, "(%d+) (%d+)\n") do
    local f = names[tonumber(k) + 1]
    local bound = bounds["call_" .. k].bytes -- with the frame of who calls it
    painted[#painted + 1] = f
    painted[f] = tonumber(bytes) - (bound - bounds[f].bytes)
    if tonumber(bytes) > bound then beyond[#beyond + 1] = string.format("%s: %s of %d", f, bytes, bound) end
  end
  tap.ok(#painted == #names and #names > 5, title .. ": all " .. #names .. " functions are called", said)
  tap.ok(#beyond == 0, title .. ": none goes deeper than its bound", table.concat(beyond, "\n"))
  local step = p.name .. "_step"
  tap.ok(painted[step] and painted[step] >= bounds[step].bytes - SLACK, title .. ": the bound of a step is reached",
    string.format("%s of %d bytes", painted[step], bounds[step].bytes))
  for _, f in ipairs { "step", "at", "at_tick", "solve" } do
    local name = p.name .. "_" .. f
    if painted[name] then
      table_rows[#table_rows + 1] = string.format("%-10s %-6s %-28s painted %5d  bound %5d", core.name, p.real, name,
        painted[name], bounds[name].bytes)
    end
  end
end

-- ---- and that it can fail: a literal of double in a float project ----

do
  local p = projects.one(dir .. "/control", "bodies/dropped_stone.lua", "float")
  program.write(p.where .. "/dropped_stone.c", p.source ..
    "\nfloat dropped_stone_tenth(float x)\n{\n  return (float)(0.1*x);\n}\n")
  cores.must("cd %s && %sgcc -std=c99 %s -O2 -c dropped_stone.c", p.where, m4.prefix, m4.flags)
  local faults = symbols(p, m4, cores.must("%snm %s/dropped_stone.o", m4.prefix, p.where))
  tap.like(table.concat(faults, "\n"), "undefined symbol __aeabi_dmul", "arithmetic of double in float is seen")
end

-- ---- nine inputs: what clears 36 bytes is no call of memset; `make promises` shows it if it is ----

do
  local file = dir .. "/nine.lua"
  program.write(file, [[
local list = {}
for k = 1, 9 do list[k] = effect.torque { body = { input("u" .. k, "N m"), 0, 0 } } end
return scene { name = "nine", body = solid.box { x = param("a", 1, "m"), y = 2, z = 3, mass = 4 }, effects = list,
  initial = { omega = { 1, 2, 3 } } }
]])
  local p = projects.one(dir .. "/nine", file, "float")
  local promises = "cd " .. p.where .. " && make promises CC=" .. m4.prefix .. "gcc NM=" .. m4.prefix ..
    "nm CFLAGS='" .. m4.flags .. " -O2' >log 2>&1"
  tap.is(program.shell(promises), 0, "nine inputs: make promises finds no call", program.read(p.where .. "/log"))
  local text, n = string.gsub(p.source, "static (const %w+ u%[NINE_NU%] = )", "%1")
  program.write(p.where .. "/nine.c", text)
  tap.ok(n == 1 and program.shell(promises) ~= 0, "without the static array it fails")
  tap.like(program.read(p.where .. "/log"), "none:\n%s+U memset\n", "on a call of memset", true)
end

for _, line in ipairs(table_rows) do tap.diag(line) end
program.finish()
tap.done()
