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

local write = string.format("timeout 300 lua5.4 docs/tools/pages.lua %s/docs >%s/out 2>%s/err", dir, dir, dir)
tap.is(program.shell(write), 0, "the pages of shapes, effects and commands are written")
local list = io.popen(string.format("cd %s/docs && find . -type f", dir))
local stale, count = {}, 0
for path in list:lines() do
  count = count + 1
  if program.read("docs/" .. path) ~= program.read(dir .. "/docs/" .. path) then stale[#stale + 1] = path end
end
list:close()
tap.ok(count > 40 and #stale == 0, "what is in docs is what the tools make (else: make docs)",
  table.concat(stale, " "))

tap.is(made("chart bodies/book.lua --linearised -o " .. dir .. "/linearised.svg"), 0, "small oscillations are drawn")
tap.ok(program.read(dir .. "/linearised.svg") == program.read "docs/linearised.svg", "as in docs")

local disc = require "docs.tools.disc"
tap.ok(disc.text() == program.read "docs/disc.svg", "docs/disc.svg is what docs/tools/disc.lua makes")

program.finish()
tap.done()
