-- names.lua - attempts to write C: names, units and texts that reach the emitted code and its comments.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Rows as in words.lua.  A row with `scene =` gives the scene's own name, one with `param =` a parameter's.

local identifier = "must be a C identifier"
local word = "must not be a word of C or C++"

local list = { about = "names" }
local function put(what, text, rule)
  list[#list + 1] = { "a scene called " .. what, scene = text, rule }
  list[#list + 1] = { "a parameter called " .. what, param = text, rule }
end
put("while", "while", word)
put("co_await", "co_await", word)
put("INFINITY", "INFINITY", word)
put("M_1_PI", "M_1_PI", word)
put("FLT_MAX", "FLT_MAX", word)
put("linux", "linux", word)
put("__attribute__", "__attribute__", identifier)
put("a__b", "a__b", "must not contain __")
put("_Bool", "_Bool", identifier)
put("a quote", 'a"b', identifier)
put("a line's end", "a\nINJECTED(b)", identifier)
put("a comment's end", "a*/INJECTED/*", identifier)
put("a comment of C++", "a//b", identifier)
put("a backslash and a line's end", "a\\\nb", identifier)
put("a trigraph", "a??/b", identifier)
put("a template's value", "a${x}", identifier)
put("a template's line", "%% INJECTED", identifier)
put("a conversion of printf", "a%s%n", identifier)
put("letters of Greece", "\206\177", identifier)
put("a zero byte", "a\0b", identifier)
put("a path", "../../INJECTED", identifier)
put("2000 letters", ("a"):rep(2000), "must have at most 31 characters")
list[#list + 1] = { "a scene called math", scene = "math", "a header of C" }
list[#list + 1] = { "a scene called con", scene = "con", "a device" }
list[#list + 1] = { "a scene called Makefile", scene = "Makefile", "must not be named like a file of the project" }
list[#list + 1] = { "a parameter called qw", param = "qw", "is taken by the emitted code" }
list[#list + 1] = { "parameters that differ in capitals", "param('a', 1) param('A', 1) BOX",
  "differs only in capitals" }

-- Accepted, and must compile: names that the emitted code has inside.
for _, name in ipairs { "x", "h", "I1", "sin" } do
  list[#list + 1] = { "a parameter called " .. name, param = name, true }
end
list[#list + 1] = { "a scene called test", scene = "test", true }

local box = "return scene { name = 's', body = solid.box { x = param('a', 1, %q), y = 2, z = 3, mass = 1 } }"
for _, unit in ipairs { "m*/ INJECTED(); /*", "m\nINJECTED", "m \\", "m ??/", "m //", "m${x}", "m%n", "m" ..
  (" "):rep(100000),
  "m^999999999999", "m\0", '"', "\195\169" } do
  list[#list + 1] = { "the unit " .. string.gsub(string.format("%q", unit:sub(1, 30)), "\n", "n"),
    box:format(unit), "unit" }
end
list[#list + 1] = { "an output called a comment's end", "return scene { name = 's', body = solid.box { x = 1, y " ..
  "= 2, z = 3, " ..
  "mass = 1 }, outputs = { '*/ INJECTED' } }", "outputs" }
list[#list + 1] = { "an event called a comment's end", "return scene { name = 's', body = solid.box { x = 1, y = " ..
  "2, z = 3, " ..
  "mass = 1 }, events = { { name = '*/ INJECTED', when = wx } } }", identifier }
list[#list + 1] = { "a state called a comment's end", "return scene { name = 's', body = solid.box { x = 1, y = " ..
  "2, z = 3, " ..
  "mass = 1 }, effects = { effect.custom { states = { ['*/ INJECTED'] = { initial = 0, rate = function(s) return " ..
    "1 end } } } } }",
  "three or more small letters" }
list[#list + 1] = { "a custom parameter called while", "return scene { name = 's', body = solid.box { x = 1, y = " ..
  "2, z = 3, " ..
  "mass = 1 }, effects = { effect.custom { params = { ['while'] = 1 }, torque = function(s) return { s['while'], " ..
    "0, 0 } end } } }",
  word }
return list
