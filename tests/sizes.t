#!/usr/bin/env lua5.4
-- sizes.t - how long files and functions may be, what a file opens with, and which names tell nothing.
-- SPDX-License-Identifier: GPL-3.0-or-later

local sources = require "tests.sources"
local tap = require "tests.tap"

local MAX_LUA, MAX_C = 400, 500 -- lines of a file
local MAX_FUNCTION = 60

-- Words of a file's name that say nothing of what is in it; what `polhode list` runs is named as all commands are.
local EMPTY_WORDS = { "more", "misc", "util", "utils", "helper", "helpers", "common", "stuff", "other", "various",
  "list" }

-- One test: nothing in `faults` (a list of "file:line: what").
local function clean(name, faults) return tap.ok(#faults == 0, name, table.concat(faults, "\n")) end

local all = sources.files("generator", "src", "templates", "tests", "bodies", "docs/tools")
tap.ok(#all > 100, "there are files to look at: the test runs in the project's root")

local function is_lua(path) return path:find "%.lua$" or path:find "%.t$" end

-- ---- files ----

do
  local long, heads, names = {}, {}, {}
  for _, path in ipairs(all) do
    local lua, c = is_lua(path), path:find "%.[ch]$"
    local list = (lua or c) and sources.lines(path) or {}
    local made = path:find "^tests/golden/"
    if (lua and #list > MAX_LUA or c and #list > MAX_C) and not path:find "^tests/.*reference/" and not made then
      long[#long + 1] = string.format("%s: %d lines", path, #list)
    end
    if (lua or c) and not path:find "^bodies/" and not made then
      local head = table.concat(list, "\n", 1, math.min(#list, 30))
      local licence = path:find "^templates/" and (head:find "MIT%-0" or head:find("${license}", 1, true))
        or head:find("SPDX-License-Identifier: GPL-3.0-or-later", 1, true)
      if not licence then heads[#heads + 1] = path .. ": no licence in its head" end
      if not (head:find "^%-%- " or head:find "^/%* " or head:find "^#![^\n]*\n%-%- " or head:find "^%%%% %-%- ") then
        heads[#heads + 1] = path .. ": does not open with what it is for"
      end
    end
    local own = path:find "^generator/" or path:find "^src/" or path:find "^docs/tools/"
    for word in own and path:match("([^/]*)%.%a+$"):gmatch "%a+" or function() end do
      for _, empty in ipairs(EMPTY_WORDS) do
        if word == empty and path ~= "generator/commands/list.lua" then
          names[#names + 1] = path .. ": '" .. word .. "' does not tell what is in it"
        end
      end
    end
  end
  clean("no file is longer than " .. MAX_LUA .. " lines of Lua or " .. MAX_C .. " of C", long)
  clean("every file opens with its purpose and its licence", heads)
  clean("every file's name tells what is in it", names)
end

-- ---- functions ----

do
  -- the reader of functions sees what it should
  local lua, c = os.tmpname() .. ".lua", os.tmpname() .. ".c"
  local function written(path, text)
    local file = assert(io.open(path, "w"))
    file:write(text)
    file:close()
    local list = {}
    for i, f in ipairs(sources.functions(path)) do list[i] = f.name .. " " .. f.from .. " " .. f.lines end
    os.remove(path)
    os.remove((path:gsub("%.%a+$", "")))
    return table.concat(list, ", ")
  end
  tap.is(written(lua, "local function a(x)\n  if x then\n    return\n  end\nend\n\nfunction b.c() return 1 end\n" ..
    "t.d = function()\n  local function e()\n    return 2\n  end\n  return e\nend\n"), "a 1 5, t.d 8 6, e 9 3",
    "functions of Lua, inner ones too, but no one-liners")
  tap.is(written(c, "static int a(int x,\n             int y) {\n  return x;\n}\n\nstruct s {\n  int x;\n};\n" ..
    "static const int t[] = {\n  1,\n};\nint b(void);\nint c(void) {\n  return 1;\n}\n"), "a 1 4, c 13 3",
    "functions of C, no types, no tables and no prototypes")

  local long = {}
  for _, path in ipairs(all) do
    if (path:find "^generator/" or path:find "^src/" or path:find "^docs/tools/") and path:find "%.[lch]u?a?$" then
      for _, f in ipairs(sources.functions(path)) do
        if f.lines > MAX_FUNCTION then
          long[#long + 1] = string.format("%s:%d: %s has %d lines", path, f.from, f.name, f.lines)
        end
      end
    end
  end
  clean("no function is longer than " .. MAX_FUNCTION .. " lines", long)
end

tap.done()
