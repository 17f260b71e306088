#!/usr/bin/env lua5.4
-- counted.t - the counted cost sheet as text: what is not known is said, and what is not counted.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The sheets are made up; that real ones are right is tests/target/sheet.t's.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local read = require("tests.json").read
local counted = require "generator.report.counted"
local json = require "generator.report.json"

local function target(more)
  local t = { name = "core", compiler = "gcc 1.2.3", flags = "-mcpu=core", emulator = "qemu 7, board", cycles = false,
    bound = true, model = 40, state = 28, flash = 999, ram = 0, library = 0,
    functions = { { name = "step", count = 123, flash = 456, stack = 64 } } }
  for k, v in pairs(more) do t[k] = v end
  return t
end

local function sheet(...)
  return { real = "float", when = "6.18", step = "0.001", options = "-O2", targets = { ... } }
end

local function markdown(...) return table.concat(counted.markdown(sheet(...)), "\n") end

local plain = markdown(target {})
tap.like(plain, "| function | instructions | flash | stack |\n|---|---|---|---|\n| step | 123 | 456 | 64 |\n",
  "a table")
tap.like(plain, "Compiled by gcc 1.2.3 -mcpu=core -O2.", "the compiler and its options")
tap.like(plain, "Instructions, not cycles, of one call with its arguments, counted under qemu 7, board.",
  "what is counted")
tap.like(plain, "RAM: model 40 bytes, state 28; static: 0.\n", "RAM without an orbit")
tap.ok(not plain:find("+:", 1, true), "no plus is explained where there is none")

local odd = markdown(target { orbit = 99, library = 7,
  functions = { { name = "step", flash = 4, stack = 64, least = true } } })
tap.like(odd, "| step | - | 4 | 64 + |", "what was not called and what is not known")
tap.like(odd, "+: at least", "the plus is explained")
tap.like(odd, "orbit 99; static: 0, and of the C library 7.", "RAM with an orbit, and the library's")

local avr = markdown(target { cycles = true, bound = false, copies = true, ram = 55 })
tap.like(avr, "| function | cycles | flash | stack |", "cycles are called so")
tap.like(avr, "Cycles, not instructions", "and said to be no instructions")
tap.like(avr, "Stack: bytes used in this run", "a stack that is no bound")
tap.like(avr, "static: 55, the C library's and the constants included.", "constants in RAM")

local two = sheet(target {}, { name = "small", failed = "it has 5 bytes of RAM" })
tap.like(table.concat(counted.markdown(two), "\n"), "**small**, float.\nNot counted: it has 5 bytes of RAM.\n",
  "a core that was not counted")
local sections = counted.text(two)
tap.is(#sections, 2, "text: a section a core")
tap.is(sections[1].lines[#sections[1].lines], "step                              123      456       64", "text: a row")
tap.is(sections[2].lines[1], "Not counted: it has 5 bytes of RAM.", "text: why not")
local back = read(json.text(counted.json(two, json.object, json.null)))
tap.is(back.targets[1].functions[1].instructions, 123, "json: the count")
tap.is(back.targets[1].functions[1].stack_is_bound, true, "json: a bound")
tap.is(back.targets[2].failed, "it has 5 bytes of RAM", "json: why not")

tap.done()
