-- bombs.lua - attempts to stay: memory, time, patterns, recursion, in plain Lua.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Rows as in words.lua.

local memory = "the scene needs more than 24 MiB of memory"
local steps = "the scene ran longer than 50000000 instructions"

return {
  about = "time and memory",
  { "rep", "return ('x'):rep(1e10)", "rep: the text would be longer" },
  { "rep with a count that wraps", "return ('abc'):rep(math.maxinteger)", "rep: the text would be longer" },
  { "a growing table", "local t = {} while true do t[#t + 1] = {} end", memory },
  { "a growing array", "local t = {} for i = 1, 1e12 do t[i] = i end", memory },
  { "a growing hash", "local t = {} for i = 1, 1e12 do t['k' .. i] = i end", memory },
  { "concatenations that double", "local s = 'x' while true do s = s .. s end", memory },
  { "long concatenations, thrown away", "local s = ('x'):rep(1000000) while true do local t = s .. s end",
    "the scene ran longer than" },
  { "closures", "local t = {} while true do t[#t + 1] = function() return t end end", memory },
  { "format with a wide field", "return ('%99999d'):format(1)", "invalid conversion" },
  { "format with long texts", "local s = ('x'):rep(900000) return ('%s%s'):format(s, s)",
    "format: the text would be longer" },
  { "format over and over", "local s = ('x'):rep(400000) while true do local t = ('%s%s'):format(s, s) end",
    "the scene ran longer than" },
  { "gsub", "return ('x'):gsub('', 'x')", "method 'gsub'" },
  { "table.concat of a giant range", "return table.concat({}, ',', 1, 1e15)", "concat: more than 1000000 values" },
  { "table.unpack of a giant range", "return table.unpack({}, 1, 1e8)", "unpack: more than 10000 values" },
  { "table.move of a giant range", "table.move({}, 1, 1e15, 2)", 'table: has no "move"' },
  { "string.pack", "string.pack('!16 s8', 'x')", 'string: has no "pack"' },
  { "string.byte of everything", "return ('x'):rep(1000000):byte(1, -1)", "string slice too long" },
  { "a pattern that backtracks", "('a'):rep(100):find(('a?'):rep(100) .. ('a'):rep(100))", "method 'find'" },
  { "gmatch", "for _ in ('x'):rep(1e6):gmatch('.-b') do end", "method 'gmatch'" },
  { "a loop", "while true do end", steps },
  { "a loop over goto", "::a:: goto a", steps },
  { "tail calls", "local function f() return f() end f()", steps },
  { "a for that never arrives", "for i = 1, math.huge do end", steps },
  { "a comparator without end", "table.sort({ 2, 1 }, function() while true do end end)", steps },
  { "a comparator without an order", "local t = {} for i = 1, 1000 do t[i] = i end " ..
    "table.sort(t, function() return true end)", "invalid order function" },
  { "recursion", "local function f() return 1 + f() end f()", memory },
  { "recursion through sort", "local function f(a, b) table.sort({ 1, 2, 3 }, f) return a < b end f(1, 2)",
    "C stack overflow" },
  { "recursion through a constructor", "local f f = function() return effect.custom { torque = f } end f()",
    "stack overflow" },
  { "parentheses", "return " .. ("("):rep(100000) .. "1" .. (")"):rep(100000), "C stack overflow" },
  { "tables in tables", "return " .. ("{"):rep(100000) .. ("}"):rep(100000), "C stack overflow" },
  { "functions in functions", ("return function() "):rep(1000) .. (" end"):rep(1000), "C stack overflow" },
  { "operators", "return " .. ("not "):rep(100000) .. "1", "C stack overflow" },
  { "a chain of concatenations", "return 'a'" .. ("..'a'"):rep(100000), "C stack overflow" },
  { "locals", ("local a\n"):rep(300), "too many local variables" },
  { "a long line", "x = '" .. ("x"):rep(3000000) .. "' BOX", "" },
  { "a million unknown names", "for i = 1, 1e6 do local a = _ENV['n' .. i] end", 'unknown name "n1"' },
  { "a name of a million letters", "return " .. ("x"):rep(1000000) .. ".y", 'script: unknown name "xxx' },
  { "a chunk beyond the memory", ("x = {1,2,3} "):rep(345000), "the script must" },
  { "a table that contains itself", "local t = {} t.t = t return scene { name = 's', body = t, effects = t }",
    "body must be a shape" },
  { "a table nested deeply", "local t = {} for i = 1, 1e5 do t = { t } end return scene { name = 's', body = t " ..
    "}", "body must be a shape" },
  { "an empty file of zeros", ("\0"):rep(1000000), "syntax: " },
}
