#!/usr/bin/env lua5.4
-- effects.t - docs/effects.md is what docs/tools makes; every effect is there, with everything that is said of one.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local effects = require "generator.effects.effects"

local page = require("docs.tools.effects").page(effects, program.read)
tap.ok(page == program.read "docs/effects.md", "what is in docs is what the tool makes (else: make docs)")

for _, e in ipairs(effects) do
  local missing = {}
  for _, field in ipairs { "about", "formula", "signs", "source", "example" } do
    if not e[field] or not page:find(e[field], 1, true) then missing[#missing + 1] = field end
  end
  tap.is(table.concat(missing, " "), "", e.name .. ": what it is, formula, signs, source and example")
  tap.ok(page:find("\n## " .. e.name .. "\n", 1, true) ~= nil, e.name .. ": has its section")
  tap.ok(program.read("bodies/" .. e.example .. ".lua"):find(e.name, 1, true) ~= nil,
    e.name .. ": is in the scene that is its example")
end

-- A bar in a cell of an effect's table would end it.
local broken = {}
for line in page:sub(page:find "\n## "):gmatch "[^\n]+" do
  if line:find "^|" then
    local bars = select(2, line:gsub("\\|", ""):gsub("|", ""))
    if bars ~= 5 then broken[#broken + 1] = line end
  end
end
tap.is(table.concat(broken, "\n"), "", "every row of a table has its four cells")

tap.done()
