#!/usr/bin/env lua5.4
-- names.t: which names a scene may give, because they become names in C.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local names = require "generator.dsl.names"
local scene = require "tests.scene"
local scenes = require "tests.effects.scenes"

for _, s in ipairs { "a", "A", "x1", "rim_in", "a_", "b2_c3", "Mass", ("x"):rep(31) } do
  tap.ok(names.identifier(s) == nil, "'" .. s .. "' can be a name", names.identifier(s))
end

local letters = "must be a C identifier (a letter, then letters, digits, _)"
for _, case in ipairs {
  { "", letters }, { "1a", letters }, { "_a", letters }, { "a-b", letters }, { "a b", letters }, { "a.b", letters },
  { "a\n", letters }, { "a\"", letters }, { "a*/", letters }, { "a\\", letters }, { "a\0b", letters },
  { "\195\169", letters },
  { ("x"):rep(32), "must have at most 31 characters" }, { "a__b", "must not contain __ (reserved in C++)" },
  { 1, letters }, { true, letters }, { {}, letters },
} do
  tap.is(names.identifier(case[1]), case[2], string.format("%q is refused: %s", tostring(case[1]), case[2]))
end

-- Every keyword of either language, as the standards list them (C11 6.4.1, C++20 lex.key).
local words = [[auto break case char const continue default do double else enum extern float for goto if inline int
  long register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
  alignas alignof and and_eq asm bitand bitor bool catch char8_t char16_t char32_t class compl concept const_cast
  consteval constexpr constinit co_await co_return co_yield decltype delete dynamic_cast explicit export false friend
  mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast requires
  static_assert static_cast template this thread_local throw true try typeid typename using virtual wchar_t xor xor_eq]]
local missing = {}
for word in words:gmatch "%S+" do
  if names.identifier(word) ~= "must not be a word of C or C++" then missing[#missing + 1] = word end
end
tap.is(table.concat(missing, " "), "", "every keyword of C11 and C++20 is refused")
for _, word in ipairs { "main", "NULL", "errno", "INFINITY", "NAN", "I", "complex", "assert", "M_PI", "FP_NAN",
  "HUGE_VAL", "linux", "unix", "typeof", "FLT_MAX", "DBL_EPSILON", "INT_MAX", "UINT64_MAX", "INT_LEAST8_MIN", "EOF",
  "M_1_PI", "EDOM", "math_errhandling", "SIGINT", "SNAN" } do
  tap.is(names.identifier(word), "must not be a word of C or C++", "'" .. word .. "', a macro or more, is refused")
end

for _, word in ipairs { "qw", "QX", "qy", "qz", "wx", "Wy", "wz", "ux", "uy", "uz", "nx", "nu", "np" } do
  tap.is(names.parameter(word), "is taken by the emitted code", "parameter '" .. word ..
    "' would be the enumerator of a state")
  tap.ok(names.identifier(word) == nil, "a scene may be called '" .. word .. "'")
end
for _, word in ipairs { "math", "Math", "stdint", "time", "con", "NUL" } do
  tap.is(names.scene(word), "must not be that of a header of C or of a device", "no scene is called '" .. word .. "'")
end
tap.ok(names.scene "maths" == nil and names.parameter "time" == nil, "maths can be a scene, time a parameter")
tap.is(names.scene "while", "must not be a word of C or C++", "a scene's name is an identifier first")
for _, word in ipairs { "EI", "EA", "FL", "INT", "R_MAX", "SIG", "sigma", "LONG" } do
  tap.ok(names.identifier(word) == nil, "'" .. word .. "' is no macro")
end
tap.ok(names.identifier "M_p" == nil and names.identifier "M" == nil, "M_p and M are no macros")
tap.is(names.parameter "while", "must not be a word of C or C++", "a parameter's name is an identifier first")
tap.ok(names.parameter "a" == nil and names.parameter "M" == nil, "a and M can be parameters")

-- A state of the user's has three or more small letters or _, and in a step a number behind it: what the equations
-- define on their own must not look like that.  A _ at the end was put there to keep two names apart; what a plane
-- defines gets one where a state has its name (tests/effects/surfaces.t).
do
  local taken, read, defined = {}, 0, 0
  for _, v in ipairs(scenes.variants) do
    local job = v.where ~= "plane" and scene.read(scenes.text(scenes.new(7, 0.5), "s", "full", { v }))
    read = read + (job and 1 or 0)
    for _, group in ipairs(job and job.equations.groups or {}) do
      defined = defined + #group.defs
      for _, d in ipairs(group.defs) do
        if d.name:find "^[%l_][%l_][%l_]+$" and not d.name:find "_$" then taken[#taken + 1] = d.name end
      end
    end
  end
  tap.ok(read > #scenes.variants/2 and defined > 4*read, read .. " scenes with an effect define " .. defined)
  tap.is(table.concat(taken, " "), "", "no definition of theirs has a name that a state of the user's may have")
end

tap.done()
