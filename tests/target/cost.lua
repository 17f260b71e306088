-- cost.lua -- what the closed form of the free top costs on a Cortex-M4F, in float: bytes and instructions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/target/cost.lua PROGRAM DIRECTORY
--
-- Emits bodies/brick_centroid.lua, compiles it for a Cortex-M4F, and prints two tables: bytes of the
-- object and of what a linker keeps of it (--gc-sections), and instructions a call under QEMU's board mps2-an386,
-- counted by a plugin (count.c), the call itself included.  Instructions, not cycles; the same numbers each time.  Says
-- which package is missing and does nothing if a tool is.

local program, dir = arg[1], arg[2]

local function run(format, ...)
  local pipe = assert(io.popen(string.format(format, ...) .. " 2>&1"))
  local text = pipe:read "a"
  local ok = pipe:close()
  return ok, text
end

local function must(format, ...)
  local ok, text = run(format, ...)
  if not ok then
    io.stderr:write(string.format(format, ...), "\n", text)
    os.exit(1)
  end
  return text
end

local missing = {}
for _, tool in ipairs { { "arm-none-eabi-gcc", "gcc-arm-none-eabi" }, { "qemu-system-arm", "qemu-system-arm" } } do
  if not run("command -v %s", tool[1]) then missing[#missing + 1] = tool[2] end
end
if #missing == 0 and not run("echo '#include <math.h>' | arm-none-eabi-gcc -E -x c -") then
  missing[1] = "libnewlib-arm-none-eabi"
end
if #missing > 0 then
  print("target-cost: skipped; missing: apt-get install --no-install-recommends " .. table.concat(missing, " "))
  os.exit(0)
end

local gcc = "arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -O2 -ffp-contract=off " ..
  "-fno-math-errno -ffunction-sections -fdata-sections"
local link = gcc .. " -nostartfiles --specs=nosys.specs -Wl,--gc-sections"
local name = "brick_centroid"

must("mkdir -p %s && %s gen bodies/%s.lua --real float -o %s", dir, program, name, dir)
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

must("cc -std=c11 -O2 -shared -fPIC tests/target/count.c -o %s/count.so", dir)
must("%s -std=c11 -I%s -T tests/target/m4.ld tests/target/startup.c tests/target/cost.c %s/%s.o -lm -o %s/cost.elf",
  link, dir, dir, name, dir)

local function address(symbol)
  local text = must("arm-none-eabi-nm %s/cost.elf", dir)
  return string.match(text, "(%x+) T " .. symbol .. "\n")
end

must("timeout 60 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none -semihosting-config " ..
  "enable=on,target=native -plugin %s/count.so,begin=0x%s,end=0x%s -d plugin -D %s/counts -kernel %s/cost.elf", dir,
  address "begin", address "end", dir, dir)

local counts = {}
for line in io.lines(dir .. "/counts") do counts[#counts + 1] = tonumber(line) end
assert(#counts == 11, "the firmware has not run to its end")

print ""
print "| call | instructions | near the separatrix |"
print "|---|---|---|"
local near = { solve = 9, at = 10, at_tick = 11 }
for i, f in ipairs { "solve", "set_tick", "at", "at_rates", "at_attitude", "at_tick", "step" } do
  local second = near[f] and counts[near[f]] - counts[1] or ""
  print(string.format("| `%s` | %d | %s |", f, counts[i + 1] - counts[1], second))
end
