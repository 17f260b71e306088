#!/usr/bin/env lua5.4
-- embed.t - templates become C arrays byte for byte, scripts compiled ones; in one order, written only when changed.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local root = io.popen("pwd"):read("l")

local function shell(command)
  return program.shell("cd " .. dir .. " && " .. command)
end

local function embed()
  return shell("lua5.4 " .. root .. "/src/cli/embed.lua out.c tree")
end

local every = {}
for byte = 0, 255 do
  every[#every + 1] = string.char(byte)
end
local binary = table.concat(every)

shell("mkdir -p tree/b tree/.hidden")
local script = "local x = ...\nreturn 1\n-- no newline at the end"
program.write(dir .. "/tree/z.lua", script)
program.write(dir .. "/tree/b/a.c", binary)
program.write(dir .. "/tree/empty.c", "")
program.write(dir .. "/tree/z.lua~", "an editor's copy")
program.write(dir .. "/tree/.hidden/x", "hidden")
tap.is(embed(), 0, "embedding a tree succeeds")

-- a program that prints what was embedded: name, size, text
program.write(dir .. "/main.c", [[
#include <stdio.h>
#include "host/script.h"
int main(void) {
  for (const struct script *s = script_embedded; s->name; s++) {
    printf("[%s %u ", s->name, (unsigned)s->size);
    fwrite(s->text, 1, s->size, stdout);
    printf("]%d\n", s->text[s->size]);
  }
  return 0;
}
]])
tap.is(shell("cc -std=c11 -Wall -Wextra -Werror $(pkg-config --cflags lua5.4) -I" .. root ..
  "/src/cli -o show main.c out.c"),
  0, "the result compiles without a warning")
shell("./show > shown")
local compiled = string.dump(assert(load(script, "@tree/z.lua", "t"))) -- with the names of lines and locals
tap.is(program.read(dir .. "/shown"),
  "[tree/b/a.c 256 " .. binary .. "]0\n[tree/empty.c 0 ]0\n[tree/z.lua " .. #compiled .. " " .. compiled .. "]0\n",
  "names are sorted, every byte is there, a zero follows, hidden files and copies are not")
program.write(dir .. "/tree/wrong.lua", "return return\n")
tap.ok(embed() ~= 0, "a script that is no Lua is refused")
shell("rm tree/wrong.lua")

local first = program.read(dir .. "/out.c")
shell("touch -d 2001-01-01 out.c")
embed()
tap.is(shell("test out.c -ot main.c"), 0, "the same tree does not touch the file")
program.write(dir .. "/tree/z.lua", "return 2\n")
embed()
tap.ok(shell("test out.c -ot main.c") ~= 0 and program.read(dir .. "/out.c") ~= first, "a change does")
shell("rm tree/z.lua")
embed()
tap.ok(not program.read(dir .. "/out.c"):find("z.lua", 1, true), "so does a file that is gone")

tap.done(program.finish())
