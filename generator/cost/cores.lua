-- cores.lua -- the small processors that instructions are counted on: compilers, emulators, where they come from.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Pure data; commands/measure.lua and tests/target/cores.lua run the programs.  A core is a table
--     name, machine     what it is called here, and the processor or board that the emulator has
--     prefix, flags     of the compiler PREFIXgcc and of the tools beside it
--     start, script     startup code and linker script in templates/target; none: the compiler's own
--     link              further options for the linker
--     run               the emulator without its plugin and the program; none: simavr as a library (avr.c)
--     single            its double is a float
--     memory            bytes of RAM that the machine has, where a program may want more
--     copies            constants are copied to RAM before the program begins
--     packages          {command, Debian package} of what is run
--     header            {header, package}: what the compiler, and cc where host is set, must find
-- Cortex-M and RV32 run under QEMU, which counts instructions by a plugin (count.c), of Cortex-M also cycles by Arm's
-- tables; the AVR runs in simavr, which knows its cycles.  The same numbers each time.

local cores = { folder = "templates/target/" }

-- As the emitted Makefile compiles, one section a function, so that a linker keeps what is called.
cores.options = { "-O2", "-ffp-contract=off", "-fno-math-errno", "-ffunction-sections", "-fdata-sections" }

local function arm(name, cpu, board, float, memory)
  return { memory = memory, name = name, arm = true, machine = board, prefix = "arm-none-eabi-", start = "startup.c",
    script = "cortex.ld", flags = { "-mcpu=" .. cpu, "-mthumb", table.unpack(float) },
    link = { "-nostartfiles", "--specs=nosys.specs", memory and "-Wl,--defsym=ram_size=" .. memory },
    run = { "qemu-system-arm", "-M", board, "-semihosting-config", "enable=on,target=native" },
    packages = { { "arm-none-eabi-gcc", "gcc-arm-none-eabi" }, { "qemu-system-arm", "qemu-system-arm" } },
    header = { { "math.h", "libnewlib-arm-none-eabi" } } }
end

local function riscv(name, isa, abi)
  return { name = name, machine = "virt", prefix = "riscv64-unknown-elf-", start = "riscv.c", script = "riscv.ld",
    flags = { "-march=" .. isa, "-mabi=" .. abi, "--specs=picolibc.specs" }, link = { "-nostartfiles" },
    run = { "qemu-system-riscv32", "-M", "virt", "-bios", "none" },
    packages = { { "riscv64-unknown-elf-gcc", "gcc-riscv64-unknown-elf" },
      { "qemu-system-riscv32", "qemu-system-misc" } },
    header = { { "math.h", "picolibc-riscv64-unknown-elf" } } }
end

cores.list = {
  arm("cortex-m0", "cortex-m0", "microbit", { "-mfloat-abi=soft" }, 16384),
  arm("cortex-m3", "cortex-m3", "mps2-an385", { "-mfloat-abi=soft" }),
  arm("cortex-m4f", "cortex-m4", "mps2-an386", { "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16" }),
  arm("cortex-m7", "cortex-m7", "mps2-an500", { "-mfloat-abi=hard", "-mfpu=fpv5-d16" }),
  riscv("rv32imac", "rv32imac", "ilp32"),
  riscv("rv32imafc", "rv32imafc", "ilp32f"),
  { name = "avr", machine = "atmega2560", single = true, copies = true, memory = 8192, prefix = "avr-",
    flags = { "-mmcu=atmega2560" }, link = {},
    packages = { { "avr-gcc", "gcc-avr" } },
    header = { { "math.h", "avr-libc" }, { "simavr/sim_avr.h", "libsimavr-dev", host = true } } },
}

-- What QEMU's plugin for the core is told beside the addresses: cycles a long product takes more.
cores.plugin = { ["cortex-m3"] = ",product=3" }

return cores
