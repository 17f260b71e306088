-- shown.lua - runs what a page of the documents shows, and compares.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     shown.prepare(dir)           the program by its name, for commands that run in the folder
--     shown.run(page, dir, least)  a test for every command of the page, of which there are `least` (3) or more
--     shown.lines(text) -> its lines
--     shown.compare(shown, output) -> do the lines follow each other in the output as shown?  Else the first that does
--                                  not
--     shown.save(page, dir) -> how many files of the page were saved; `run` does it, too
-- A block of code is saved as the file that its first line names (-- a.lua, /* a.c - ... */, # Makefile), and ```lua as
-- NAME.lua by its name = "...".  A line "$ ..." of an indented block is run; what follows is compared, "..." standing
-- for any lines.  pkg-config finds the library that was built.

local program = require "tests.cli.program"
local tap = require "tests.tap"

local shown = {}

local root = io.popen("pwd"):read "l"

function shown.prepare(dir)
  local binary = os.getenv "POLHODE" or "build/polhode"
  if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
  program.shell(string.format("mkdir %s/bin && ln -s %s %s/bin/polhode", dir, binary, dir))
  program.write(dir .. "/bin/polhode.pc", string.format("Name: polhode\nDescription: as built\nVersion: 0\n" ..
    "Requires: gsl\nCflags: -I%s/src/runtime\nLibs: -L%s/build -lpolhode -lm\n", root, root))
end

function shown.lines(text)
  local list = {}
  for line in (text .. "\n"):gmatch "(.-)\n" do list[#list + 1] = line end
  if list[#list] == "" then list[#list] = nil end
  return list
end

function shown.save(page, dir)
  local count = 0
  for language, block in program.read(page):gmatch "\n```(%l+)\n(.-)```" do
    local first = block:match "^[^\n]*"
    local name = first:match "^[-/#*]+ (%w+%.%l+)%f[^%w]" or first:match "^# (Makefile)$"
    if language == "lua" and not name then name = block:match 'name%s*=%s*"(%w+)"' .. ".lua" end
    if name then
      program.write(dir .. "/" .. name, block)
      count = count + 1
    end
  end
  return count
end

-- The commands of the page with what is shown of their output.
local function commands(text)
  local list, now = {}, nil
  for line in text:gmatch "([^\n]*)\n" do
    local command, line_shown = line:match "^    %$ (.*)", line:match "^    (.*)"
    if command then
      now = { command = command, shown = {} }
      list[#list + 1] = now
    elseif line_shown and now then
      table.insert(now.shown, line_shown)
    else
      now = nil
    end
  end
  return list
end

function shown.compare(lines, output)
  local at, free = 1, false
  for _, line in ipairs(lines) do
    if line == "..." then
      free = true
    else
      while free and output[at] and output[at] ~= line do at = at + 1 end
      if output[at] ~= line then return false, line end
      at, free = at + 1, false
    end
  end
  return free or at > #output, "and no more, but there is: " .. tostring(output[at])
end

function shown.run(page, dir, least)
  local text = program.read(page)
  shown.save(page, dir)
  local list = commands(text)
  tap.ok(#list >= (least or 3), page .. ": it shows commands")
  for _, c in ipairs(list) do
    program.shell(string.format(
      "cd %s && PATH=%s/bin:$PATH PKG_CONFIG_PATH=%s/bin POLHODE_BODIES=%s/bodies timeout 60 sh -c '%s' >out 2>&1",
      dir, dir, dir, root, (c.command:gsub("'", "'\\''"))))
    local same, line = shown.compare(c.shown, shown.lines(program.read(dir .. "/out")))
    tap.ok(same, page .. ": $ " .. c.command,
      same or "shown: " .. line .. "\n" .. program.read(dir .. "/out"):sub(1, 2000))
  end
end

return shown
