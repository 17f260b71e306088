#!/usr/bin/env lua5.4
-- golden.t - the emitted files of one body, byte by byte: what a change of the generator does to the user's code.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/golden/brick holds what `polhode gen bodies/brick.lua` writes, but for what changes with every commit: the
-- commit in the version, and the hashes of the manifest.  A difference is shown as a unified diff, to be
-- read and, if it is meant, accepted with `make golden` (POLHODE_GOLDEN=refresh).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local GOLDEN = "tests/golden/brick"
local MOST = 60 -- lines of a diff that are shown

local binary = os.getenv "POLHODE" or "build/polhode"

local function names(dir)
  local list = {}
  local pipe = assert(io.popen("ls " .. dir .. " 2>/dev/null"))
  for name in pipe:lines() do list[#list + 1] = name end
  pipe:close()
  return list
end

-- A file of either side without what changes with every commit.
local function lasting(path)
  local text = program.read(path) or ""
  text = string.gsub(text, "(polhode %d+%.%d+%.%d+)%+[%w-]+", "%1")
  return (path:find "manifest$" and string.gsub(text, "%f[%x]" .. ("%x"):rep(64) .. "%f[%X]", ("0"):rep(64)) or text)
end

local dir = program.directory() .. "/brick"
tap.is(program.shell(binary .. " gen bodies/brick.lua -o " .. dir), 0, "brick: gen succeeds")

local emitted = names(dir)
if os.getenv "POLHODE_GOLDEN" == "refresh" then
  program.shell("mkdir -p " .. GOLDEN .. " && rm -f " .. GOLDEN .. "/*")
  for _, name in ipairs(emitted) do program.write(GOLDEN .. "/" .. name, lasting(dir .. "/" .. name)) end
end

tap.is(table.concat(emitted, " "), table.concat(names(GOLDEN), " "), "brick: the files are those of " .. GOLDEN)
for _, name in ipairs(names(GOLDEN)) do
  local golden, new = GOLDEN .. "/" .. name, dir .. "/" .. name
  program.write(new, lasting(new))
  local same = program.read(golden) == program.read(new)
  local shown = {}
  if not same then
    local pipe = assert(io.popen(string.format("diff -u --label %s --label emitted %s %s 2>&1", golden, golden, new)))
    for line in pipe:lines() do
      if #shown < MOST then shown[#shown + 1] = line end
    end
    pipe:close()
    shown[#shown + 1] = "if it is meant: make golden"
  end
  tap.ok(same, "brick: " .. name .. " is the golden one", table.concat(shown, "\n"))
end

program.finish()
tap.done()
