#!/usr/bin/env lua5.4
-- sheet.t - gen and explain --target as a user meets them without the tools, or with a wrong name.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What is counted is tests/target/sheet.t's, which needs compilers and emulators.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(before, arguments)
  return program.output(string.format("%s %s %s", before, binary, arguments))
end

local BODY = "bodies/brick.lua"
local ALL = "cortex-m0, cortex-m3, cortex-m4f, cortex-m7, rv32imac, rv32imafc, avr"
for _, case in ipairs {
  { "--target m4", "--target must be all or some of " .. ALL .. ", got m4" },
  { "--target all,avr", "--target must be all or some of " .. ALL .. ", got all" },
  { "--target cortex-m0,cortex-m0", "--target: cortex-m0 stands there twice" },
  { "--target avr", "--target avr must have --real float: its compiler's double is a float" },
} do
  for _, command in ipairs { "gen", "explain" } do
    local where = command == "gen" and " -o " .. dir .. "/none" or ""
    local status, out, err = run("", command .. " " .. BODY .. " " .. case[1] .. where)
    tap.is(status, 2, command .. " " .. case[1] .. " is refused")
    tap.is(out, "", "nothing is printed")
    local want = "polhode " .. command .. ": " .. case[2] .. " (polhode help " .. command .. ")\n"
    tap.is(err, want, "the message is one line")
  end
end
do
  local status, _, err = run("", "explain " .. BODY .. " --target cortex-m4f --format urdf")
  tap.is(status, 2, "numbers for other programs have no costs")
  tap.like(err, "--format must be text, markdown, latex, html, typst or json, got urdf",
    "the message names the formats")
end

-- What a kind of project has no place for.
for _, case in ipairs {
  { "--real float --target cortex-m4f --project fmu -o " .. dir .. "/none",
    "--target: its README has no sheet of costs (explain --target prints one), got --project fmu" },
  { "--real float --target cortex-m4f --project firmware -o " .. dir .. "/none",
    "--target: its README has no sheet of costs (explain --target prints one), got --project firmware" },
  { "--with q31 --project fmu -o " .. dir .. "/none",
    "--with q31: its files come with --project make, got --project fmu" },
  { "--with q31 --project cmake -o " .. dir .. "/none",
    "--with q31: its files come with --project make, got --project cmake" },
  { "-o ''", "-o must not be empty, got nothing" },
} do
  local status, out, err = run("", "gen " .. BODY .. " " .. case[1])
  tap.is(status, 2, case[2])
  tap.is(out .. err, "polhode gen: " .. case[2] .. " (polhode help gen)\n", "the message is one line")
end

-- A PATH where nothing is: every tool is missing, and each package is named once.
for _, command in ipairs { "gen", "explain" } do
  local where = command == "gen" and " -o " .. dir .. "/none" or ""
  local status, out, err = run("PATH=/nonexistent CC=",
    command .. " " .. BODY .. " --real float --target cortex-m4f,cortex-m0,avr" .. where)
  tap.is(status, 2, command .. " --target without tools is refused")
  tap.is(out, "", "nothing is printed")
  tap.like(err, "needs arm-none-eabi-gcc, qemu-system-arm, ", "the message names what is missing")
  tap.like(err, "apt-get install --no-install-recommends gcc-arm-none-eabi qemu-system-arm libnewlib-arm-none-eabi " ..
    "gcc-avr avr-libc libsimavr-dev gcc libc6-dev\n", "and the packages, each once")
  tap.is(select(2, err:gsub("\n", "")), 1, "in one line")
end
tap.is(program.shell("test -e " .. dir .. "/none"), 1, "no file was written")

-- Without --target the README says that its cycles are estimates and how to count.
do
  tap.is(run("", "gen " .. BODY .. " --real float -o " .. dir .. "/b"), 0, "gen without --target")
  local text = program.read(dir .. "/b/README.md")
  tap.like(text, "**estimated**", "the README calls its cycles estimated")
  tap.like(text, "`polhode gen brick.lua --real float --target cortex-m4f`", "and has the command that counts")
end

program.finish()
tap.done()
