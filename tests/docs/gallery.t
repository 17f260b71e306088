#!/usr/bin/env lua5.4
-- gallery.t - every scene of bodies/ has its picture, small and up to date, and the page shows it.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local gallery = require "docs.tools.gallery"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local shown, count = {}, 0
for _, row in ipairs(gallery.list) do
  tap.ok(not shown[row[1]], row[1] .. " is shown once")
  shown[row[1]], count = true, count + 1
end
local pipe = assert(io.popen("ls bodies/*.lua"))
for line in pipe:lines() do
  local name = line:match "([%w_]+)%.lua$"
  tap.ok(shown[name], name .. " is in the gallery (docs/tools/gallery.lua)")
  local text = program.read("docs/gallery/" .. name .. ".svg")
  tap.ok(text and #text < 40000, name .. ": a picture of less than 40 kB (make gallery)", text and #text)
  count = count - 1
end
pipe:close()
tap.is(count, 0, "nothing else is in it")
tap.is(program.read "docs/gallery.md", gallery.page(), "docs/gallery.md is up to date (make gallery)")
tap.ok(not program.read "docs/gallery.md":find("SPDX", 1, true), "no caption has a scene's licence line")
tap.ok(program.read "README.md":find("docs/gallery/tennis_racket.svg", 1, true), "README shows one")

-- Numbers in tenths of a pixel may differ by one between machines, the words and the number of curves may not.
local function still(text) return (text:gsub('[dxyr]%d?="[^"]*"', ""):gsub('points="[^"]*"', "")) end
for i, row in ipairs(gallery.list) do
  if not tier.quick or i % 6 == 1 then
    local file = dir .. "/" .. row[1] .. ".svg"
    local drawn = gallery.draw(binary, row, file)
    local got, want = program.read(file), program.read("docs/gallery/" .. row[1] .. ".svg")
    tap.ok(drawn and got and want and still(got) == still(want), row[1] .. ": the picture is up to date (make gallery)")
  end
end

program.finish()
tap.done()
