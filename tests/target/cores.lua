-- cores.lua -- the small processors that tests/target knows: how to compile for them, run them, count instructions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local cores = require "tests.target.cores"
--     cores.missing(list)                     packages to install for these cores, a list
--     cores.build(core, dir, elf, sources, flags)
--     cores.counts(core, dir, elf)            what was executed between each begin() and end(), a list; and cycles
--
-- Cortex-M and RV32 run under QEMU, which counts instructions by a plugin, of Cortex-M also cycles by Arm's tables
-- (count.c); the AVR runs in simavr, which knows its cycles (avr.c).  The same numbers each time.

local cores = {}

local OPTIONS = "-O2 -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -Wl,--gc-sections "

local function arm(name, cpu, board, flags, memory)
  return { name = name, arm = true, prefix = "arm-none-eabi-", start = "startup.c",
    flags = "-mcpu=" .. cpu .. " -mthumb " .. flags,
    link = "-nostartfiles --specs=nosys.specs -T tests/target/m4.ld" .. (memory or ""),
    run = "qemu-system-arm -M " .. board .. " -semihosting-config enable=on,target=native",
    packages = { ["arm-none-eabi-gcc"] = "gcc-arm-none-eabi", ["qemu-system-arm"] = "qemu-system-arm" },
    library = "libnewlib-arm-none-eabi" }
end

local function riscv(name, isa, abi)
  return { name = name, prefix = "riscv64-unknown-elf-", start = "riscv.c",
    flags = "-march=" .. isa .. " -mabi=" .. abi .. " --specs=picolibc.specs",
    link = "-nostartfiles -T tests/target/riscv.ld", run = "qemu-system-riscv32 -M virt -bios none",
    packages = { ["riscv64-unknown-elf-gcc"] = "gcc-riscv64-unknown-elf",
      ["qemu-system-riscv32"] = "qemu-system-misc" },
    library = "picolibc-riscv64-unknown-elf" }
end

cores.list = {
  arm("cortex-m0", "cortex-m0", "microbit", "-mfloat-abi=soft", " -Wl,--defsym=ram_size=16K"),
  arm("cortex-m3", "cortex-m3", "mps2-an385", "-mfloat-abi=soft"),
  arm("cortex-m4f", "cortex-m4", "mps2-an386", "-mfloat-abi=hard -mfpu=fpv4-sp-d16"),
  arm("cortex-m7", "cortex-m7", "mps2-an500", "-mfloat-abi=hard -mfpu=fpv5-d16"),
  riscv("rv32imac", "rv32imac", "ilp32"),
  riscv("rv32imafc", "rv32imafc", "ilp32f"),
  { name = "avr", prefix = "avr-", flags = "-mmcu=atmega2560 '-DHUGE_VALF=__builtin_inff()'", link = "",
    packages = { ["avr-gcc"] = "gcc-avr", simavr = "simavr" }, library = "avr-libc", header = "simavr/sim_avr.h" },
}
cores.by_name = {}
for _, core in ipairs(cores.list) do cores.by_name[core.name] = core end

function cores.run(format, ...)
  local pipe = assert(io.popen(string.format(format, ...) .. " 2>&1"))
  local text = pipe:read "a"
  return pipe:close(), text
end

function cores.must(format, ...)
  local ok, text = cores.run(format, ...)
  if not ok then
    io.stderr:write(string.format(format, ...), "\n", text)
    os.exit(1)
  end
  return text
end

function cores.missing(list)
  local missing, seen = {}, {}
  local function put(package)
    if not seen[package] then missing[#missing + 1] = package end
    seen[package] = true
  end
  for _, core in ipairs(list) do
    for tool, package in pairs(core.packages) do -- sorted below: order is lost
      if not cores.run("command -v %s", tool) then put(package) end
    end
    local tool = core.prefix .. "gcc"
    if cores.run("command -v %s", tool) and
        not cores.run("echo '#include <math.h>' | %s %s -E -x c -", tool, core.flags) then put(core.library) end
    if core.header and not cores.run("echo '#include <%s>' | cc -E -x c -", core.header) then put "libsimavr-dev" end
  end
  table.sort(missing)
  return missing
end

-- sources: C files; flags: more options of the compiler
function cores.build(core, dir, elf, sources, flags)
  cores.must("%sgcc %s %s -std=gnu11 -I%s %s %s %s %s -lm -o %s/%s", core.prefix, core.flags, OPTIONS, dir, flags or "",
    core.link, core.start and "tests/target/" .. core.start or "", sources, dir, elf)
end

local function address(core, path, symbol)
  return (string.match(cores.must("%snm %s", core.prefix, path), "(%x+) T " .. symbol .. "\n"))
end

function cores.counts(core, dir, elf)
  local path = dir .. "/" .. elf
  local from, to = address(core, path, "begin"), address(core, path, "end")
  if core.name == "avr" then
    cores.must("cc -std=gnu11 -O2 tests/target/avr.c -o %s/avr -lsimavr -l:libelf.so.1", dir)
    cores.must("timeout 60 %s/avr %s 0x%s 0x%s 0x%s > %s.counts", dir, path, from, to, address(core, path, "finish"),
      path)
  else
    cores.must("cc -std=c11 -O2 -shared -fPIC tests/target/count.c -o %s/count.so", dir)
    cores.must("timeout 60 %s -nographic -monitor none -serial none -plugin %s/count.so,begin=0x%s,end=0x%s%s " ..
      "-d plugin -D %s.counts -kernel %s", core.run, dir, from, to, core.name == "cortex-m3" and ",product=3" or "",
      path, path)
  end
  local counts, cycles = {}, {}
  for line in io.lines(path .. ".counts") do
    local n, c = string.match(line, "^(%d+) ?(%d*)$") -- simavr also says what it has loaded
    if n then counts[#counts + 1], cycles[#cycles + 1] = tonumber(n), tonumber(c) or 0 end
  end
  return counts, cycles
end

return cores
