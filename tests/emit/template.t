#!/usr/bin/env lua5.4
-- template.t - the laws of the template engine.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A template line is a line of a Lua chunk of the template's name, so a mistake in a template is reported where it is;
-- an unknown name and a value that is no string are errors, never "nil" or a number in the output.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local template = require "generator.emit.template"

local function render(source, values) return template.render("templates/x.c", source, values or {}) end

-- ---- text ----

tap.is(render "", "", "an empty template gives an empty text")
tap.is(render "plain\n\n  lines\n", "plain\n\n  lines\n", "text stays as it is, blanks and empty lines too")
tap.is(render("a ${x} b ${y}${x}\n", { x = "1", y = "2" }), "a 1 b 21\n", "names are replaced, several on a line")
tap.is(render("${x}\n", { x = "two\nlines" }), "two\nlines\n", "a value may have several lines")
tap.is(render("%% for _, x in ipairs(list) do\n  ${x}\n%% end\n  ${list[2]};\n", { list = { "a", "", "b" } }),
  "  a\n\n  b\n  ;\n", "a line of one value is empty where the value is, without blanks")
tap.is(render("${x}\n", { x = "${y} %% \\n \"" }), "${y} %% \\n \"\n", "a value is not looked at again")
tap.is(render('printf("%d\\n", "\\"", 100%);\n'), 'printf("%d\\n", "\\"", 100%);\n',
  "C text with quotes and backslashes")
tap.is(render("a % b\nx %% y\n"), "a % b\nx %% y\n", "%% is logic only where a line begins with it")
tap.is(render("$x $(y) {z} $ {\n"), "$x $(y) {z} $ {\n", "only ${ } is a name: make's variables are text")

-- ---- logic ----

tap.is(render("%% for _, f in ipairs(list) do\n- ${f.name}\n%% end\nend\n",
  { list = { { name = "a" }, { name = "b" } } }),
  "- a\n- b\nend\n", "for over a prepared list; fields by name; no line is left where logic stood")
tap.is(render("  %% if yes then\nin\n  %% else\nout\n  %% end\n", { yes = false }), "out\n",
  "if and else; false is a value, not an unknown name; logic may be indented")
tap.is(render("%% for i, x in ipairs(list) do\n%%   if x == \"\" then\n\n%%   else\n${x}\n%%   end\n%% end\n",
  { list = { "a", "", "b" } }), "a\n\nb\n", "nested logic")
tap.is(render("%% for _, x in ipairs(list) do\n${x}\n%% end\n", { list = {} }), "",
  "a loop over nothing leaves nothing")

-- ---- errors ----

-- Raises a message with this part.
local function fails(source, values, part, name)
  local fine, why = pcall(render, source, values)
  return tap.ok(not fine and tostring(why):find(part, 1, true) ~= nil, name,
    fine and "no error" or "got " .. tostring(why) .. "\nwant " .. part)
end

fails("a\nb ${nothing}\n", {}, "templates/x.c:2: unknown name 'nothing'",
  "an unknown name is an error with file and line")
fails("${f.x}\n", { f = {} }, "templates/x.c:1: ${f.x} is nil, not a string", "an unknown field is an error")
fails("\n\n${n}\n", { n = 12 }, "templates/x.c:3: ${n} is number, not a string",
  "a number is no text: number.lua prints them")
fails("${n}\n", { n = 0.1 }, "is number, not a string", "nor is a float")
fails("${b}\n", { b = true }, "is boolean, not a string", "nor a truth value")
fails("${t}\n", { t = {} }, "is table, not a string", "nor a table")
fails("x\n%% if oops then\n%% end\n", {}, "templates/x.c:2: unknown name 'oops'",
  "an unknown name in logic is an error")
fails("x\ny\n%% for x in\n", {}, "templates/x.c:", "broken logic is an error that names the template")
fails("a\n%% if true then\nb\n", {}, "templates/x.c:", "a missing end is an error")
fails("a\n%% zero = 1\n", {}, "templates/x.c:2: a template must not assign 'zero'", "assignments are refused")
fails("%% local t = string.rep(\"x\", 3)\n", {}, "unknown name 'string'", "the library of Lua is not there")
fails("%% os.exit()\n", {}, "unknown name 'os'", "nor the system")
fails("${tostring(1)}\n", {}, "unknown name 'tostring'", "nor conversions")
fails("${x\n", { x = "1" }, "templates/x.c:1", "an unclosed name is an error, not text")
fails("no newline at the end", {}, "templates/x.c:1", "a last line without a newline is an error, not lost")

-- ---- every template of the project ----

do
  local scene = require "tests.scene"
  local names = {}
  local pipe = assert(io.popen "find templates -type f | LC_ALL=C sort")
  for name in pipe:lines() do names[#names + 1] = name end
  pipe:close()
  for _, name in ipairs(names) do
    local text = scene.slurp(name)
    tap.ok(text:find "\n$" and not text:find "\r" and not text:find "\t%S*%%%%", name .. ": ends in a newline, no \\r")
    for logic in text:gmatch "\n%s*%%%%%s*([^\n]*)" do
      if not (logic:find "^for [%w_, ]+ in ipairs%([%w_.]+%) do$" or logic:find "^if .+ then$" or logic == "else"
        or logic:find "^%-%- " or logic:find "^elseif .+ then$" or logic == "end") then
        tap.ok(false, name .. ": logic is for over a list, if, else and end", logic)
      end
    end
  end
  tap.ok(#names > 5, "templates were read")
end

tap.done()
