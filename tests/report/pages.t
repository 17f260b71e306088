#!/usr/bin/env lua5.4
-- pages.t - the pages and diagrams that `make docs` writes are in docs/, byte for byte.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local function made(command)
  return program.shell(string.format("timeout 300 %s %s >%s/out 2>%s/err", binary, command, dir, dir))
end

local list = io.popen "ls -d docs/shapes.md docs/shapes/*.svg docs/effects.md"
local pages = {}
for path in list:lines() do pages[#pages + 1] = path end
list:close()

tap.is(made("list shapes --format markdown -o " .. dir .. "/docs"), 0, "the page of shapes is written")
tap.is(made("list effects --format markdown -o " .. dir .. "/docs"), 0, "that of effects, too")
local stale = {}
for _, path in ipairs(pages) do
  if program.read(path) ~= program.read(dir .. "/" .. path) then stale[#stale + 1] = path end
end
tap.ok(#pages > 40 and #stale == 0, "what is in docs is what the program makes (else: make docs)",
  table.concat(stale, " "))

tap.is(made("chart bodies/book.lua --linearised -o " .. dir .. "/linearised.svg"), 0, "small oscillations are drawn")
tap.ok(program.read(dir .. "/linearised.svg") == program.read "docs/linearised.svg", "as in docs")

program.finish()
tap.done()
