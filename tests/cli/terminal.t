#!/usr/bin/env lua5.4
-- terminal.t - what a terminal sees and a file does not: colours of messages, the progress of long commands.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A terminal is made by script(1), of Debian's base system.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local colours = require "generator.commands.colours"
local progress = require "generator.commands.progress"

local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local dir = program.directory()

-- ---- what is coloured ----

local red, yellow, bold, plain = "\27[1;31m", "\27[1;33m", "\27[1m", "\27[0m"
tap.is(colours.of "warning: a.lua:3: x: does nothing\n    x\n",
  yellow .. "warning: " .. plain .. bold .. "a.lua:3: " .. plain .. "x: does nothing\n    x\n",
  "a warning and its line")
tap.is(colours.of "polhode gen: --real must be\n", red .. "polhode gen: " .. plain .. "--real must be\n", "an error")
tap.is(colours.of "a.lua:3: x\nb.lua:4: y\n", bold .. "a.lua:3: " .. plain .. "x\n" .. bold .. "b.lua:4: " .. plain ..
  "y\n", "lines of a scene")
tap.is(colours.of "\r[###...] compiling \r", "\r[###...] compiling \r", "progress stays as it is")

-- ---- what is foretold ----

tap.is(progress.left(10, 0.5), "10 s left", "half of the work behind: as long again")
tap.is(progress.left(30, 0.25), "1 min 30 s left", "a quarter behind: three times as long")
tap.is(progress.left(3600, 0.5), "1 h 0 min left", "an hour")
do -- a motion tells where it is, four times a second at most, and not in its first second
  local now, out = 0, {}
  local terminal = { isatty = function() return true end, clock = function() return now end,
    err = function(text) out[#out + 1] = text end }
  local seen, done = progress.along(terminal, 2, function(t) return "at " .. t end)
  for i = 0, 200 do
    now = i / 100
    seen(now)
  end
  tap.is(#out, 4, "from 1.25 s to 2 s every quarter of a second")
  tap.like(out[1], "at 1.25", "in the motion's own time")
  done()
  tap.is(#out, 5, "and clears the line")
  terminal.isatty = function() return false end
  tap.is(progress.along(terminal, 2), nil, "without a terminal nobody asks")
end
tap.is(progress.left(10, 0.01) .. progress.left(0.5, 0.5) .. progress.left(10, 1), "",
  "no guess at the beginning or end")

do
  local said, now = {}, 0
  local bar = progress.of { isatty = function() return true end, clock = function() return now end,
    err = function(text) said[#said + 1] = text end }
  bar.clear()
  tap.is(#said, 0, "nothing is cleared that was not shown")
  bar.show("first", 0)
  now = 20
  bar.show("second", 0.25)
  bar.clear()
  tap.ok(said[1]:find "first" and said[2]:find "second" and said[2]:find "1 min 0 s left" and #said[1] == #said[2],
    "each line covers the one before", said[2])
  tap.ok(said[3]:find "^\r +\r$" and #said[3] >= #said[1], "and is cleared")
end

do -- without a terminal: a line every ten seconds of a command that takes minutes, nothing of others
  local said, now = {}, 0
  local pipe = { isatty = function() return false end, clock = function() return now end,
    err = function(text) said[#said + 1] = text end }
  local bar, silent = progress.of(pipe, "bench"), progress.of(pipe)
  for i = 0, 100 do
    now = i / 4
    bar.show("rk4", i / 200)
    silent.show("rk4", i / 200)
  end
  bar.clear()
  tap.is(table.concat(said), "polhode bench: 20 % done, 40 s left; rk4\npolhode bench: 40 % done, 30 s left; rk4\n",
    "bench tells where it is when its messages go into a file")
end

-- ---- the program ----

program.write(dir .. "/bad.lua", 'return scene { name = "b", body = solid.box { x = 1, y = 1, z = 1, mass = -1 } }\n')
program.write(dir .. "/top.lua",
  'return scene { name = "b", body = solid.box { x = 1, y = 2, z = 3, mass = 1 }, initial = { omega = {1, 2, 3} } }\n')

-- Output and error of the program on a terminal; before: its environment.
local function terminal(arguments, before)
  program.shell(string.format(
    "cd %s && env -u NO_COLOR %s timeout 100 script -qec '%s %s' /dev/null </dev/null >out 2>&1", dir, before, binary,
    arguments))
  return program.read(dir .. "/out")
end

if program.shell "command -v script >/dev/null" ~= 0 then
  tap.skip("colours on a terminal", "no script(1) here")
else
  local error_line = "bad.lua:1: "
  tap.ok(terminal("explain bad.lua", "TERM=xterm"):find(bold .. error_line .. plain, 1, true), "colours on a terminal")
  for _, before in ipairs { "TERM=xterm NO_COLOR=1", "TERM=dumb", "-u TERM" } do
    local text = terminal("explain bad.lua", before)
    tap.ok(text:find(error_line, 1, true) and not text:find "\27", "none with " .. before, text)
  end
  tap.ok(terminal("explain bad.lua", "TERM=xterm NO_COLOR="):find(bold, 1, true), "an empty NO_COLOR is none")
  local result = terminal("explain top.lua", "TERM=xterm")
  tap.ok(result:find "Ixx" and not result:find "\27", "results have no colours")
  tap.ok(not terminal("explain bad.lua 2>&1 | cat", "TERM=xterm"):find "\27", "no colours into a pipe")
  tap.ok(terminal("check top.lua --real double --states 2", "TERM=xterm " .. program.quick_compiler())
    :find("\r[", 1, true), "check shows on a terminal how far it is")
end
program.shell(string.format("cd %s && env TERM=xterm %s %s check top.lua --real double --states 2 >out 2>err", dir,
  program.quick_compiler(), binary))
tap.is(program.read(dir .. "/err"), "", "and writes nothing of it into a file")

tap.done(program.finish())
