-- own.lua - the text of all the emitted code's own mathematical functions, as tests/emit/libm.t has it: for the hunt.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/hunt/own.lua REAL > own.h

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local R = require "generator.algebra.rational"
local libm = require "generator.emit.libm"
local number = require "generator.emit.number"

local real = arg[1]
local ALL = { "huge", "fabs", "copysign", "sqrt", "cbrt", "floor", "frexp", "ldexp", "sin", "cos", "tan", "asin",
  "acos", "atan", "atan2", "exp", "sinh", "cosh", "tanh", "log", "pow" }

local templates = {}
local pipe = assert(io.popen "ls templates/numeric/libm_*.c")
for path in pipe:lines() do
  local file = assert(io.open(path, "rb"))
  templates[path] = file:read "a"
  file:close()
end
pipe:close()

local bits = real == "float" and 24 or 53
local function n(x) return number.text(R.lift(x), real) end
local v = { name = "own", zero = n(0), one = n(1), two = n(2), half = n "1/2", quarter = n "1/4", arm_fma = "0",
  split = n(R.new(2) ^ ((bits + 1) // 2) + R.one) }
local calls = {}
for i, f in ipairs(ALL) do calls[i] = "own_" .. f .. "(" end
io.write(libm.source(v, { name = "own", real = real }, templates, table.concat(calls, " ")))
