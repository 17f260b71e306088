#!/usr/bin/env lua5.4
-- sandbox.t - a scene cannot leave its sandbox, cannot run for ever, cannot eat the machine.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each attempt is one process: it must end by itself, in bounded time and memory, with its own status.  A
-- verdict is "ok|values" or "kind|line|message".  The environment is host.safe and, for the attempts that
-- need it, something a scene language could have: an object with metamethods, exact numbers, and, to prove the
-- last lock, functions that must never be given to a scene.

local tap = require "tests.tap"
local program = require "tests.cli.program"

local SECONDS = 15 -- a run of this test that takes longer has a hole; the slowest honest one takes 3

local HARNESS = [[
local R = require "polhode_rational"
local env = {}
for k, v in next, host.safe do env[k] = v end
env.R = { new = R.new, apply = R.apply }
local kind = { __add = function(a, b) return setmetatable({}, kind) end,
  __tostring = function() return "an object" end, __index = function() return 1 end,
  __len = function() return math.maxinteger end, __name = "object" }
env.object = setmetatable({}, kind)
env.unsafe = { pcall = pcall, find = string.find, rep = string.rep, coroutine = coroutine, setmetatable = setmetatable }
env.whereami = function()
  for level = 1, 9 do
    local info = debug.getinfo(level, "Sl")
    if info and info.source == "@scene.lua" then return info.currentline end
  end
end
if args[5] == "tree" then env.scene = function(t) local function walk(x) for k, v in next, x do
  if type(v) == "table" then walk(v) end end end walk(t) return "scene" end end
local limits = { bytes = tonumber(args[3]), steps = tonumber(args[4]), seconds = tonumber(args[2]) }
local r = table.pack(host.sandbox(host.read(args[1]), "@scene.lua", env, limits))
if r[1] then
  local out = {}
  for i = 2, r.n do out[#out + 1] = tostring(r[i]) end
  say("ok|" .. table.concat(out, " "))
else
  say(r[2].kind .. "|" .. tostring(r[2].line) .. "|" .. r[2].message)
end
-- the state is whole afterwards: the generator's own string functions work and nothing is left armed
assert(string.find("abc", "b") == 2 and (args[6] == "covered" or debug.gethook() == nil))
for i = 1, 3000000 do end
return 0
]]

local MiB = 1024 * 1024

-- No attempt may take 4 GB of address space. The address sanitizer maps terabytes for itself.
local ULIMIT = os.getenv("POLHODE_SANITIZED") and "" or "ulimit -v 4000000;"

-- `make coverage` has a hook of its own.
local COVERED = os.getenv "POLHODE_COVERAGE" and "covered" or ""

-- Verdict, standard error and exit status of one scene.
local function attempt(scene, limits)
  limits = limits or {}
  local path = program.directory() .. "/scene.lua"
  program.write(path, scene)
  local start = os.time()
  local status, out, err = program.run_with(ULIMIT, "", HARNESS, path,
    string.format("%g", limits.seconds or 5), string.format("%d", limits.bytes or 16 * MiB),
    string.format("%d", limits.steps or 20000000), "tree", COVERED)
  return out:gsub("\n$", ""), err, status, os.difftime(os.time(), start)
end

local function case(name, scene, want, limits)
  local got, err, status, seconds = attempt(scene, limits)
  local good = status == 0 and err == "" and seconds <= SECONDS and got:find(want, 1, true) == 1
  tap.ok(good, name, string.format("status %s after %g s\ngot  %s\nwant %s\n%s", status, seconds, got, want, err))
end

-- ---- what is not there ----

for _, name in ipairs { "io", "os", "require", "package", "load", "loadstring", "loadfile", "dofile", "debug", "pcall",
  "xpcall", "coroutine", "setmetatable", "getmetatable", "rawset", "rawget", "rawequal", "rawlen", "next",
  "collectgarbage", "print", "warn", "_G", "utf8", "host", "args", "polhode_rational" } do
  case("a scene has no " .. name, "return " .. name, "ok|nil")
end
case("_ENV is the scene's own table and leads nowhere", "return _ENV.io, _ENV._G, _ENV.load", "ok|nil nil nil")
for _, name in ipairs { "dump", "find", "match", "gmatch", "gsub", "pack", "unpack" } do
  case("string." .. name .. " is not there, by name or by method", "return string." .. name ..
    ", ('x')." .. name, "ok|nil nil")
end
case("string.dump is not reachable through a method call", "return (''):dump(function() end)",
  "runtime|1|attempt to call a nil value (method 'dump')")
case("math has no chance", "return math.random, math.randomseed", "ok|nil nil")
case("table has no move", "return table.move", "ok|nil")
case("the metatable of strings is not reachable", "return ('').__index, ('').__metatable", "ok|nil nil")
case("writing into string changes no method", [[string.rep = function() return "evil" end return ("x"):rep(2)]],
  "ok|xx")
case("a string cannot be written into", [[local s = "x" s.y = 1]], "runtime|1|attempt to index a string value")

-- ---- what is there works ----

case("honest scenes get their values back", [[
  local t = { 3, 1, 2 }
  table.sort(t)
  local sum = 0
  for _, v in ipairs(t) do sum = sum + v end
  return sum, math.sqrt(16), ("%5.2f|%s"):format(2 / 3, "x"), ("ab"):rep(2, "-"), table.concat(t, ","),
    select("#", table.unpack(t)), math.type(1), tostring(1.5), tonumber("0x10"), #"abc" ]],
  "ok|6 4.0  0.67|x ab-ab 1,2,3 3 integer 1.5 16 3")
case("pairs visits keys in one order: numbers, strings, booleans", [[
  local out = {}
  for k in pairs { z = 1, a = 1, [true] = 1, [2.5] = 1, 1, 1, [false] = 1, [-1] = 1, m = 1 } do
    out[#out + 1] = tostring(k)
  end
  return table.concat(out, " ")]], "ok|-1 1 2 2.5 a m z false true")
case("pairs survives removal of what is to come", [[
  local t, n = { a = 1, b = 2, c = 3 }, 0
  for k in pairs(t) do n = n + 1 t.b = nil t.c = nil end
  return n]], "ok|1")
case("pairs refuses keys that have no order", "for _ in pairs { [{}] = 1 } do end", "runtime|1|pairs: a key is a table")
case("tostring shows no address", "return tostring({}), tostring(function() end), tostring(ipairs)",
  "ok|table function function")
case("format %s shows no address", "return ('%s %s'):format({}, ipairs)", "ok|table function")
case("format %p is refused", "return ('%p'):format({})", "runtime|1|format: no addresses")
case("format %-20p is refused too", "return ('%%%-20p'):format({})", "runtime|1|format: no addresses")
case("format keeps %%p as text", "return ('100%%p %d'):format(3)", "ok|100%p 3")
case("an object's own text is used", "return tostring(object), ('%s'):format(object)", "ok|an object an object")

-- ---- wrong scenes, and their lines ----

case("a syntax error has its line", "local x = 1\nlocal = 2\n", "syntax|2|<name> expected near '='")
case("a runtime error has its line", "local x = 1\n\nreturn x.y", "runtime|3|attempt to index a number value")
case("error() has the caller's line", "local function f()\n  error('bad')\nend\nf()", "runtime|2|bad")
case("error(..., 2) blames the caller", "local function f()\n  error('bad', 2)\nend\nf()", "runtime|4|bad")
case("assert's message has the line of the call", "\nassert(false, 'wrong size')", "runtime|2|wrong size")
case("bytecode is refused", "\27Lua\84\0\25\147\r\n\26\n\4\8\8", "syntax|nil|attempt to load a binary chunk")
case("an error object that is a table", "error({ code = 1 })", "runtime|1|error object is a table value")
case("an error object that is nil", "error(nil)", "runtime|1|error object is a nil value")
case("an error object that is a number", "error(42)", "runtime|1|42")
case("an error object that is a boolean", "error(true)", "runtime|1|error object is a boolean value")
case("an error object with a __tostring is not asked", "error(object)", "runtime|1|error object is a table value")
case("an error message with a zero byte ends there", "error('a\\0b', 0)", "runtime|1|a")
case("a message that fakes a place keeps its text", "error('other.lua:7: x', 0)", "runtime|1|other.lua:7: x")

case("the line of a tail call that fails inside is known", "\n\nreturn scene(nil)", "runtime|3|")
case("the language's own functions see the caller of a tail call", "\n\nreturn whereami()", "ok|3")

-- ---- time ----

local steps = "the scene ran longer than 20000000 instructions"
case("an endless loop", "\nwhile true do end", "steps|2|" .. steps)
case("an endless for", "for i = 1, math.huge do end", "steps|1|" .. steps)
case("an endless goto", "::a:: goto a", "steps|1|" .. steps)
case("mutual tail calls", "local f local function g() return f() end f = function() return g() end f()", "steps|1|")
case("an endless repeat inside a comparator", "table.sort({ 3, 2, 1 }, function() while true do end end)", "steps|1|")
case("a pcall loop cannot swallow the hook's error",
  "while true do unsafe.pcall(function() while true do end end) end", "steps|")
case("nor can a thousand nested ones", [[
  local function f(n) if n == 0 then while true do end end while true do unsafe.pcall(f, n - 1) end end
  f(100)]], "steps|")
case("a comparator without an order ends", [[
  local t = {}
  for i = 1, 1000 do t[i] = i end
  table.sort(t, function() return true end)]], "runtime|3|invalid order function for sorting")
case("a quadratic sort ends", [[
  local t = {}
  for i = 1, 100000 do t[i] = i % 7 end
  local n = 0
  while true do table.sort(t, function(a, b) return a < b end) end]], "steps|")
case("a bound on seconds, where steps are not the limit", "while true do end", "time|1|the scene ran longer than 0.5 s",
  { seconds = 0.5, steps = 1e14 })
case("the steps of instructions that each take long", [[
  local s = ("x"):rep(1000000)
  while true do local t = s .. s end]], "time|2|the scene ran longer than 0.5 s", { seconds = 0.5, steps = 1e14 })
case("exact numbers that each take long", [[
  local x = R.new(3) ^ 600000
  while true do local y = x / (x + 1) end]], "time|2|", { seconds = 0.5, steps = 1e14 })
case("exact functions that each take long", [[
  local x = R.new(1, 3)
  while true do x = R.apply("sin", 60000, x) end]], "time|2|", { seconds = 0.5, steps = 1e14 })

-- ---- C functions that loop without hooks ----

case("rep of nothing, very often", "return #(''):rep(1e18)", "ok|0")
case("rep beyond the bound", "return ('x'):rep(1e9)", "runtime|1|rep: the text would be longer than 1000000 bytes")
case("rep with a separator beyond the bound", "return ('').rep('', 1e18, 'ab')", "runtime|1|rep: the text")
case("rep with a count that wraps", "return ('abc'):rep(math.maxinteger)", "runtime|1|rep: the text")
case("rep with a count that is no integer", "return ('abc'):rep(0/0)",
  "runtime|1|rep: the count must be a whole number")
case("concat over a huge range", "return table.concat({}, '', 1, 1e15)", "runtime|1|concat: more than 1000000 values")
case("concat over a range that wraps", "return table.concat({}, '', math.mininteger, math.maxinteger)",
  "runtime|1|concat: more than 1000000 values")
case("concat with a long separator", "return #table.concat({ 1, 2, 3 }, ('x'):rep(900000))",
  "runtime|1|concat: the text would be longer than 1000000 bytes")
case("concat of an object that always answers", "return table.concat(object)",
  "runtime|1|concat: plain table expected, got an object")
case("unpack over a huge range", "return table.unpack({}, 1, 1e9)", "runtime|1|unpack: more than 10000 values")
case("unpack over a range that wraps", "return table.unpack({}, math.mininteger, math.maxinteger)",
  "runtime|1|unpack: more than 10000 values")
case("unpack of an object that says it is long", "return table.unpack(object)",
  "runtime|1|unpack: plain table expected, got an object")
case("a huge field width", "return #('%99999d'):format(1)", "runtime|1|invalid conversion")
case("a format longer than the bound", [[
  local f = ('%99d'):rep(900000 // 4)
  return #f:format(1)]], "runtime|2|bad argument #3 to 'format'")
case("a format with long arguments", [[
  local s = ('x'):rep(900000)
  return #('%s%s%s'):format(s, s, s)]], "runtime|2|format: the text would be longer than 1000000 bytes")
case("insert far away", "table.insert({}, 1e15, 1)", "runtime|1|bad argument #2 to 'insert' (position out of bounds)")
case("sort of an object that says it is long", "table.sort(object)",
  "runtime|1|sort: plain table expected, got an object")
case("insert into an object that says it is long", "table.insert(object, 1, 1)",
  "runtime|1|insert: plain table expected, got an object")
case("remove from an object", "table.remove(object)", "runtime|1|remove: plain table expected, got an object")
case("select with a huge index", "return select(1e15, 1)", "ok|")
case("byte of a long string in one go", "return select('#', ('x'):rep(1000000):byte(1, -1))",
  "runtime|1|stack overflow (string slice too long)")
case("char of everything", "return #string.char(table.unpack({}, 1, 3))", "runtime|1|bad argument #1 to 'char'")

-- ---- memory ----

local memory = "memory|nil|the scene needs more than 16 MiB of memory"
case("a growing table", "local t = {} while true do t[#t + 1] = {} end", memory)
case("a growing table of one array", "local t = {} for i = 1, 1e12 do t[i] = i end", memory)
case("a doubling string", "local s = 'x' while true do s = s .. s end", memory)
case("many strings", "local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(100000) .. i end", memory)
case("closures", "local t = {} while true do t[#t + 1] = function() return t end end", memory)
case("a number bomb of doublings", "local x = R.new(2) while true do x = x * x end", "runtime|1|number too large")
case("a number bomb of powers", "return R.new(10) ^ 1000000000000", "runtime|1|number too large")
case("many large numbers", "local t = {} for i = 1, 1e9 do t[i] = R.new(2) ^ 900000 + i end",
  "steps|1|" .. steps) -- their size is charged as work before it is memory
case("memory errors caught in a loop", [[
  while true do unsafe.pcall(function() local t = {} while true do t[#t + 1] = {} end end) end]],
  "memory|1|the scene needs more than 16 MiB of memory")

-- ---- recursion and nesting ----

case("deep recursion", "local function f() return 1 + f() end return f()",
  "runtime|1|stack overflow", { bytes = 256 * MiB })
case("deep recursion in little memory", "local function f() return 1 + f() end return f()", "", { bytes = 1 * MiB })
case("deep recursion through C", "local function f(a, b) table.sort({ 1, 2, 3 }, f) return a < b end f(1, 2)",
  "runtime|1|C stack overflow")
case("deeply nested parentheses", "return " .. string.rep("(", 100000) .. "1" .. string.rep(")", 100000),
  "syntax|nil|C stack overflow")
case("deeply nested tables", "return " .. string.rep("{", 100000) .. string.rep("}", 100000),
  "syntax|nil|C stack overflow")
case("deeply nested blocks", string.rep("do ", 100000) .. string.rep("end ", 100000), "syntax|nil|C stack overflow")
case("a chain of concatenations", "return " .. string.rep("'a'..", 100000) .. "'a'", "syntax|nil|C stack overflow")
case("too many locals", string.rep("local a\n", 300), "syntax|202|too many local variables")
case("a long chunk", string.rep("x = 1 ", 300000), "ok|")
case("a chunk beyond the memory", string.rep("x = {1,2,3} ", 340000), memory)
case("a table that contains itself is the language's to bound", "local t = {} t.t = t return scene(t)", "")

-- ---- the last lock: stuck inside one C function ----

local slowness = os.getenv "POLHODE_SANITIZED" and 10 or 1 -- as src/cli/sandbox/bounds.c has it
local function killed(name, scene)
  local got, err, status, seconds = attempt(scene, { seconds = 0.3, steps = 1e14, bytes = 512 * MiB })
  tap.ok(status == 1 and got == "" and err == "polhode: scene.lua: the scene ran longer than 0.3 s\n" and
    seconds <= 5 * slowness,
    name, string.format("status %s after %g s: %s%s", status, seconds, got, err))
end
killed("pattern backtracking is ended by the watchdog",
  "unsafe.find(('a'):rep(100), ('a?'):rep(100) .. ('a'):rep(100))")
killed("so is a rep that copies nothing for ever", "unsafe.rep('', 1 << 62, '')")

tap.done(program.finish())
