#!/usr/bin/env lua5.4
-- docs.t - the examples of docs/interchange.md print what the page says.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A block ```lua NAME is written to the file NAME; a block ```console has a line "$ polhode ..." and below it what the
-- command prints on both outputs.  POLHODE_DOCS=refresh writes the outputs into the page.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local run = require "tests.interchange.program"

local page = "docs/interchange.md"
local here = assert(io.popen "pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = here .. "/" .. binary end

program.shell(string.format("ln -s %s/bodies %s/bodies && cp tests/interchange/arm.* %s", here, run.dir, run.dir))

local function output(command)
  program.shell(string.format("cd %s && timeout 60 %s%s >shown 2>&1", run.dir, binary, command:match "^polhode(.*)$"))
  return program.read(run.dir .. "/shown")
end

local text = program.read(page)
local examples = 0
local fresh = text:gsub("```(%l+) ?([%w.]*)\n(.-)```", function(kind, name, content)
  if kind == "lua" then
    run.write(name, content)
    return nil
  end
  local command, want = content:match "^%$ ([^\n]+)\n(.*)$"
  local got = output(command)
  examples = examples + 1
  tap.is(got, os.getenv "POLHODE_DOCS" == "refresh" and got or want, command)
  return "```console\n$ " .. command .. "\n" .. got .. "```"
end)
tap.is(examples, 4, "all examples were found")
if os.getenv "POLHODE_DOCS" == "refresh" then program.write(page, fresh) end

-- ---- what is read of each format: the readers' own lists ----

local function tags(list)
  local out = {}
  for i, name in ipairs(list) do out[i] = "`<" .. name .. ">`" end
  return table.concat(out, ", ")
end

local rows = 0
for _, format in ipairs { "urdf", "sdf", "mjcf" } do
  format = require("generator.interchange." .. format)
  for name, r in pairs(format.reads) do
    local parts = {}
    if r.at then parts[#parts + 1] = "the attributes `" .. table.concat(r.at, "`, `") .. "`" end
    if r.has then parts[#parts + 1] = tags(r.has) end
    if r.text then parts[#parts + 1] = "its text" end
    local shown = name:find "^i[xyz][xyz]$" and "`<ixx>` .. `<iyz>`" or "`<" .. name .. ">`"
    local row = string.format("| %s | %s | %s |", format.name, shown, table.concat(parts, "; "))
    rows = rows + 1
    if not text:find(row, 1, true) then tap.ok(false, "the page has the row " .. row) end
  end
end
local _, shown = text:gsub("\n| %u+ | `<", "")
tap.is(shown, rows - 5, "the page says what is read of each element, and no more") -- six entries of SDF are one row

run.finish()
tap.done()
