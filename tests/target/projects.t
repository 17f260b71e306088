#!/usr/bin/env lua5.4
-- projects.t - the emitted projects for another processor: CMake with an ordinary toolchain file, the plain Makefile
-- with another compiler, and its `make qemu`.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A program that calls init, initial and step is linked for a Cortex-M4F and run under QEMU; its state has this
-- machine's bits.  What it does not call must not be in it.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local cores = require "tests.target.cores"
local firmware = require "tests.emit.firmware"

local core = cores.by_name["cortex-m4f"]
local missing = cores.missing { core }
if program.shell "command -v cmake >/dev/null 2>&1" ~= 0 then missing[#missing + 1] = "cmake" end
if #missing > 0 then
  tap.skip("projects for a Cortex-M4F", "install " .. table.concat(missing, " "))
  tap.done()
end

local dir = program.directory()
local here = io.popen("pwd"):read "l"
local FPU = "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
local QEMU = "qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none -semihosting-config "
  .. "enable=on,target=native -kernel "

-- Two ordinary toolchain files: the compiler is tried with a library alone, or with newlib's empty system.
local toolchains = {
  { "a static library to try the compiler with", "set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)\n" },
  { "nosys.specs to try the compiler with", "set(CMAKE_EXE_LINKER_FLAGS_INIT --specs=nosys.specs)\n" },
}
local function toolchain(more)
  program.write(dir .. "/toolchain.cmake", "set(CMAKE_SYSTEM_NAME Generic)\nset(CMAKE_SYSTEM_PROCESSOR arm)\n"
    .. "set(CMAKE_C_COMPILER arm-none-eabi-gcc)\nset(CMAKE_C_FLAGS_INIT \"" .. FPU .. "\")\n" .. more)
end

-- What it prints on this machine is what it wants on the other.
local MAIN = [[
#include "probe.h"
#ifdef WANT
static const unsigned char want[] = { WANT };
#else
#include <stdio.h>
#endif
int main(void)
{
  probe_model m;
  probe_real x[PROBE_NX];
  const unsigned char *p = (const unsigned char *)x;
  unsigned i;
  if (probe_init(&m, 0) != 0) return 2;
  probe_initial(&m, x);
  for (i = 0; i < 100; i++) probe_step(&m, 0, x, 0, (probe_real)1/4096);
  for (i = 0; i < sizeof x; i++) {
#ifdef WANT
    if (p[i] != want[i]) return 1;
#else
    printf("%d,", p[i]);
#endif
  }
  return 0;
}
]]
local app = dir .. "/app"
program.shell("mkdir -p " .. app)
program.write(app .. "/main.c", MAIN)

-- bytes of text, data and bss
local function sizes(folder, elf)
  local text = firmware.run(folder, "arm-none-eabi-size " .. elf)
  local a, b, c = text:match "\n%s*(%d+)%s+(%d+)%s+(%d+)"
  return string.format("text %s, data %s, bss %s", a, b, c), tonumber(a) or math.huge
end

local reports = {}
for _, real in ipairs { "float", "double" } do
  local folder = assert(firmware.make(dir, firmware.probe, "--project cmake --real " .. real))
  local want, ok = firmware.run(app, string.format("gcc -std=c99 -O2 -ffp-contract=off -I%s/include -o host main.c "
    .. "%s/src/probe.c -lm && ./host", folder, folder))
  tap.ok(ok and #want > 20, real .. ": the program on this machine", want)
  program.write(app .. "/CMakeLists.txt", string.format([[
cmake_minimum_required(VERSION 3.13)
project(app LANGUAGES C)
add_subdirectory(%s probe)
add_executable(app main.c %s/templates/target/startup.c)
target_compile_definitions(app PRIVATE "WANT=%s")
target_link_libraries(app PRIVATE probe::probe)
target_link_options(app PRIVATE -nostartfiles -T %s/templates/target/cortex.ld)
]], folder, here, want, here))
  local single = real == "float" -- in double what is dear once more is left out
  for _, t in ipairs(single and toolchains or { toolchains[2] }) do
    toolchain(t[2])
    local text, built = firmware.run(folder, "rm -rf cross && cmake -B cross -DCMAKE_TOOLCHAIN_FILE=" .. dir
      .. "/toolchain.cmake -DCMAKE_BUILD_TYPE=MinSizeRel && cmake --build cross && ls cross")
    tap.ok(built and text:find "libprobe.a" and not text:find "probe_test", real
      .. ": the library with an ordinary toolchain file, " .. t[1] .. "; no self-test", text)
  end
  local text, built = firmware.run(app, "rm -rf build && cmake -B build -DCMAKE_TOOLCHAIN_FILE=" .. dir
    .. "/toolchain.cmake -DCMAKE_BUILD_TYPE=MinSizeRel && cmake --build build")
  tap.ok(built, real .. ": a program that takes it by add_subdirectory is linked", text)
  text, ok = firmware.run(app, QEMU .. "build/app")
  tap.ok(ok, real .. ": 100 steps have this machine's bits", text)
  local names = firmware.run(app, "arm-none-eabi-nm build/app")
  tap.ok(names:find "probe_step" and not names:find "probe_jacobian" and not names:find "probe_solve" and
    not names:find "probe_principal", real .. ": what it does not call is not there", names)
  local said, bytes = sizes(app, "build/app")
  reports[#reports + 1] = real .. ", MinSizeRel, init, initial, step and start-up: " .. said
  if single then
    firmware.run(app, "rm -rf build && cmake -B build -DCMAKE_TOOLCHAIN_FILE=" .. dir
      .. "/toolchain.cmake -DCMAKE_BUILD_TYPE=MinSizeRel -DPROBE_GC_SECTIONS=OFF && cmake --build build")
    -- the closed form is a file of its own, which no program takes along that does not call it
    tap.ok(select(2, sizes(app, "build/app")) > bytes, real .. ": without PROBE_GC_SECTIONS all of probe.c is there",
      (sizes(app, "build/app")))
  end

  -- ---- the plain Makefile ----

  folder = assert(firmware.make(dir, firmware.probe, "--project make --real " .. real))
  text, ok = firmware.run(folder, "make lib CC=arm-none-eabi-gcc AR=arm-none-eabi-ar CFLAGS='-Os " .. FPU .. "'"
    .. " && arm-none-eabi-gcc -Os " .. FPU .. " -I. '-DWANT=" .. want .. "' -o app " .. app .. "/main.c " .. here
    .. "/templates/target/startup.c -L. -lprobe -nostartfiles --specs=nosys.specs -Wl,--gc-sections -T " .. here
    .. "/templates/target/cortex.ld -lm && " .. QEMU .. "app")
  tap.ok(ok, real .. ": make lib with the cross compiler; the program has this machine's bits", text)
  reports[#reports + 1] = real .. ", make lib CFLAGS=-Os, the same: " .. (sizes(folder, "app"))
  if single then
    text, ok = firmware.run(folder, "make -s qemu")
    tap.ok(ok and text:find "\n1%.%.%d+\n" and not text:find "not ok" and not text:find "warning", real
      .. ": make qemu runs the self-test without a warning", text)
    _, ok = firmware.run(folder, "sed -i 's/return failures != 0/return failures == 0/' probe_test.c && make -s qemu")
    tap.ok(not ok, real .. ": a self-test that fails is make's failure")
  end
end
for _, line in ipairs(reports) do tap.diag(line) end

program.finish()
tap.done()
