#!/usr/bin/env lua5.4
-- controls.t - each check of judge.lua fails when its promise is broken: an emitted project, doctored.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- As it is emitted the project has no fault, with its own mathematical functions and with the system's; then one thing
-- is added to the source or taken from the header, and that very fault must be reported.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local judge = require "tests.promises.judge"
local projects = require "tests.promises.projects"

local dir = program.directory()

local function judged(p, level, where)
  local own = setmetatable({ where = where }, { __index = p })
  program.shell("mkdir -p " .. where)
  program.write(where .. "/" .. p.name .. ".h", p.header)
  program.write(where .. "/" .. p.name .. ".c", p.source)
  program.write(where .. "/" .. p.name .. "_test.c", program.read(p.where .. "/" .. p.name .. "_test.c"))
  program.shell(string.format("sh tests/promises/build.sh %s %s %s c11 'g++ -std=c++11'", where, p.name, level))
  return judge.all(own, level)
end

local stone = projects.one(dir, "bodies/dropped_stone.lua", "float", "--libm own")
local system = projects.one(dir .. "/system", "bodies/dropped_stone.lua", "float", "--libm system")
for i, p in ipairs { stone, system } do
  for _, level in ipairs { "-O0", "-O2" } do
    local faults = judged(p, level, dir .. "/clean" .. i .. level)
    tap.ok(#faults == 0, p.title .. ", " .. level .. ": as emitted no fault", table.concat(faults, "\n"))
  end
end

-- {what, text added to the source, fault, the next one ..}
local added = {
  { "a static counter", [[
int NAME_count(void)
{
  static int calls;

  return ++calls;
}]], "calls.%d+ is data that may change", "section .bss can be written" },
  { "a public variable", "int NAME_mode = 3;", "NAME_mode is data that may change", "section .data can be written" },
  { "recursion", "int NAME_down(int n)\n{\n  return n < 2 ? 1 : NAME_down(n - 1) + NAME_down(n - 2);\n}",
    "recursion: NAME_down" },
  { "recursion of two, in the tail", [[
int NAME_odd(int n)
{
  return n == 0 ? 0 : NAME_even(n - 1);
}
int NAME_even(int n)
{
  return n == 0 ? 1 : NAME_odd(n - 1);
}]], "recursion: NAME_odd NAME_even" },
  { "a call through a pointer", "int NAME_any(int (*f)(int))\n{\n  return f(1);\n}",
    "a call through a pointer: NAME_any" },
  { "an array of variable length", [[
int NAME_sum(int n)
{
  int a[n];

  a[n - 1] = n;
  return a[n - 1];
}]], "a frame that is not static: NAME_sum", "Wvla" },
  { "alloca", "char NAME_top(unsigned n)\n{\n  char *a = __builtin_alloca(n);\n\n  a[0] = 1;\n  return a[0];\n}",
    "a frame that is not static: NAME_top", "Walloca" },
  { "an initialiser that clears an array", [[
float NAME_none(int i)
{
  float u[9] = {0};

  u[8] = 1.0F;
  return u[i];
}]], "u%[%]: an initialiser that clears an array" },
  { "the heap", "#include <stdlib.h>\nvoid *NAME_new(void)\n{\n  return malloc(8);\n}", "undefined symbol malloc",
    "malloc: a word of the heap", "includes <stdlib.h>" },
  { "a literal of double", "float NAME_tenth(float x)\n{\n  return (float)(0.1 * (double)x);\n}",
    "0.1: a literal of double", "the word double" },
  { "a promotion that nobody sees", "int NAME_less(float x)\n{\n  return x < 0.1;\n}", "0.1: a literal of double",
    "Wdouble%-promotion" },
  { "a function of double", "float NAME_sine(float x)\n{\n  return (float)sin(x);\n}", "sin: a function of double",
    "undefined symbol sin" },
  { "a foreign function", "float NAME_sine(float x)\n{\n  return sinf(x);\n}", "undefined symbol sinf" },
  { "a name without the scene's", "int helper(void)\n{\n  return 1;\n}",
    "helper does not begin with the scene's name" },
  { "a warning", "int NAME_wider(long n)\n{\n  return n;\n}", "Wconversion" },
  { "what is no C++", "int NAME_class(int class)\n{\n  return class;\n}", "a compiler says" },
}

local prototypes = [[
int NAME_count(void);
int NAME_down(int n);
int NAME_odd(int n);
int NAME_even(int n);
int NAME_any(int (*f)(int));
]]

local function named(text) return (string.gsub(text, "NAME", stone.name)) end

local function control(what, p, ...)
  local faults = table.concat(judged(p, "-O0", dir .. "/doctored"), "\n")
  for _, pattern in ipairs { ... } do
    tap.like(faults, pattern, what .. ": found", true)
  end
end

for _, c in ipairs(added) do
  local p = setmetatable({ source = stone.source .. "\n" .. named(prototypes) .. named(c[2]) .. "\n" },
    { __index = stone })
  local patterns = {}
  for k = 3, #c do patterns[k - 2] = named(c[k]) end
  control(c[1], p, table.unpack(patterns))
end

local function header(what, pattern, by, ...)
  local text, n = string.gsub(stone.header, pattern, by)
  tap.ok(n > 0, what .. ": there is something to take away")
  control(what, setmetatable({ header = text }, { __index = stone }), ...)
end
header("a header without a guard", "#ifndef POLHODE[^\n]*\n#define[^\n]*\n(.*)#endif[^\n]*\n$", "%1",
  "no include guard", "re%w+ of")
header("a header that C++ cannot link", 'extern "C" {', "", 'no extern "C"', "a compiler says")

-- Nothing built is no fault found: it must not look like a promise kept.
tap.ok(#judge.symbols("", stone, "-O0") > 0 and #judge.sections "" > 0 and #judge.calls "" > 0,
  "an empty listing is a fault")

program.finish()
tap.done()
