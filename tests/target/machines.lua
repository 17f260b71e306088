-- machines.lua -- every machine that emitted code is tested on: how gcc and clang compile for it, and what runs it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local machines = require "tests.target.machines"
--     machine.name, .board, .doubles           doubles: the type is of 64 bits there (not on AVR) and worth the time
--     machine.compile[compiler]                command and options, to which -O, -c and files are added
--     machine.link, machine.start              command that links, with its options; C files linked to every program
--     machine.large                            {link =, run =}: with more memory than the part has, where there is need
--     machine.run                              what stands before the program's path on a command line
--     machines.missing(list)                   packages to install, a list
--
-- The small processors are those of cores.lua; console.c leads what they print out.  What clang compiles is linked by
-- gcc, with gcc's C library: clang brings none.  aarch64 and the big-endian mips run under QEMU's user mode.

local cores = require "tests.target.cores"

local machines = { list = {}, by_name = {} }

local PICOLIBC = "/usr/lib/picolibc/riscv64-unknown-elf/include"
local CLANG = {
  arm = function(core)
    return "clang --target=arm-none-eabi " .. core.flags .. " -isystem /usr/lib/arm-none-eabi/include"
  end,
  riscv = function(core)
    return "clang --target=riscv32-unknown-elf -isystem " .. PICOLIBC .. " " ..
      string.gsub(core.flags, "%-%-specs=%S+", "")
  end,
}
local QEMU = " -nographic -monitor none -serial %s -kernel"
local RUN = { arm = string.format(QEMU, "none"), riscv = string.format(QEMU, "stdio") }

local function small(core)
  local kind = core.arm and "arm" or core.start and "riscv" or "avr"
  local m = { name = core.name, board = core.machine, core = core, compile = { gcc = core.prefix .. "gcc " ..
    core.flags }, start = { "tests/target/console.c" }, doubles = kind ~= "avr" }
  m.link = m.compile.gcc .. " -Wl,--gc-sections -Wl,--wrap=main " .. core.link
  if kind == "avr" then
    m.compile.gcc = m.compile.gcc .. " -Werror=overflow" -- an int has 16 bits
    m.link = m.link .. " -Wl,-u,vfprintf -lprintf_flt" -- printf with %g
    m.large = { link = "-Wl,--defsym=__stack=0xffff" } -- the external memory interface filled with RAM: 64 kB in all
    -- no clang: version 14's AVR code, which is called experimental, is wrong beyond rounding (principal axes)
    m.run, m.runner = "timeout 120 ", "simavr.c"
  else
    m.start[2] = "templates/target/" .. core.start
    m.compile.clang = CLANG[kind](core)
    m.run = "timeout 120 " .. core.run .. RUN[kind]
    if core.name == "cortex-m0" then -- its code on the board of the M3, whose instructions contain its own
      m.large = { link = "-Wl,--defsym=ram_size=4M",
        run = "timeout 120 " .. string.gsub(core.run, core.machine, "mps2-an385") .. RUN[kind] }
    end
  end
  return m
end

local function hosted(name, board, prefix, run, packages, clang)
  return { name = name, board = board, compile = { gcc = prefix .. "gcc", clang = clang },
    link = prefix .. "gcc -static", start = {}, run = run, packages = packages, doubles = true }
end

for _, core in ipairs(cores.list) do machines.list[#machines.list + 1] = small(core) end
machines.list[#machines.list + 1] = hosted("aarch64", "qemu-user", "aarch64-linux-gnu-", "timeout 120 qemu-aarch64",
  { { "aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu" }, { "qemu-aarch64", "qemu-user" } },
  "clang --target=aarch64-linux-gnu")
machines.list[#machines.list + 1] = hosted("mips", "qemu-user, big-endian", "mips-linux-gnu-", "timeout 120 qemu-mips",
  { { "mips-linux-gnu-gcc", "gcc-mips-linux-gnu" }, { "qemu-mips", "qemu-user" } },
  "clang --target=mips-linux-gnu")
machines.list[#machines.list + 1] = hosted("host", "this machine", "", "timeout 120", { { "gcc", "gcc" } }, "clang")
for _, m in ipairs(machines.list) do machines.by_name[m.name] = m end

function machines.missing(list)
  local missing, seen, small_ones = {}, {}, {}
  local function put(package)
    if not seen[package] then missing[#missing + 1] = package end
    seen[package] = true
  end
  for _, m in ipairs(list) do
    if m.core then small_ones[#small_ones + 1] = m.core end
    for _, p in ipairs(m.packages or {}) do
      if not cores.run("command -v %s", p[1]) then put(p[2]) end
    end
  end
  for _, package in ipairs(cores.missing(small_ones)) do put(package) end
  if not cores.run("command -v clang") then put "clang" end
  table.sort(missing)
  return missing
end

return machines
