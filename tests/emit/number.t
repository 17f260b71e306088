#!/usr/bin/env lua5.4
-- number.t: what number.text prints reads back as the number meant, in Lua's strtod and in a C compiler.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "polhode_rational"
local number = require "generator.emit.number"
local random = require "tests.ir.random"
local compiled = require "tests.ir.compiled"

-- ---- the form -------------------------------------------------------------------------------------------

for _, row in ipairs {
  { "0", "0.0", "0.0F" },
  { "1", "1.0", "1.0F" },
  { "-2", "-2.0", "-2.0F" },
  { "1/2", "0.5", "0.5F" },
  { "-4/5", "-0.8", "-0.8F" },
  { "5/13", "5.0/13.0", "5.0F/13.0F" },
  { "-1/3", "-1.0/3.0", "-1.0F/3.0F" },
  { "13/500", "0.026", "0.026F" },
  { "980665/100000", "9.80665", "9.80665F" },
  { "100", "100.0", "100.0F" },
  { "100000", "100000.0", "100000.0F" },
  { "1000000", "1e6", "1e6F" },
  { "398600441800000", "3.986004418e14", "3.9860045e14F" },
  { "1/10000", "0.0001", "0.0001F" },
  { "1/100000", "1e-5", "1e-5F" },
  { "16777217/3", "16777217.0/3.0", "5592405.5F" },
  { "9007199254740993/7", "1286742750677284.8", "1.2867428e15F" },
} do
  local q = R.parse(row[1])
  tap.is(number.text(q, "double"), row[2], row[1] .. " in double is " .. row[2])
  tap.is(number.text(q, "float"), row[3], row[1] .. " in float is " .. row[3])
end

tap.is(number.text(R.apply("pi", 256), "double"), "3.141592653589793", "256 bits of pi print as the shortest digits")
tap.is(number.text(R.new(2) ^ -1074, "double"), "5e-324", "the smallest subnormal double is 5e-324")
tap.is(number.text(R.new(2) ^ -149, "float"), "1e-45F", "the smallest subnormal float is 1e-45F")
tap.is(number.text(R.new(2) ^ -30, "double"), "9.313225746154785e-10",
  "a decimal that ends late is cut where it reads back")

tap.throws(function() number.text(R.new(10) ^ 400, "double") end, "beyond the range of binary64", "1e400 is no double")
tap.throws(function() number.text(R.new(10) ^ 39, "float") end, "beyond the range of binary32", "1e39 is no float")
tap.throws(function() number.text(R.new(10) ^ -400, "double") end, "vanishes in binary64", "1e-400 does not become 0")
tap.throws(function() number.text(R.new(10) ^ -50, "float") end, "vanishes in binary32", "1e-50 does not become 0.0F")
tap.throws(function() number.constant(R.new(2) ^ -127, "float") end,
  "near 2^-127 is below the normal numbers of binary32", "a constant of an instruction has all digits of its type")
tap.is(number.constant(R.new(2) ^ -126, "float"), number.text(R.new(2) ^ -126, "float"),
  "the least normal float is one")
tap.throws(function() number.constant(R.new(2) ^ -1023, "double") end, "below the normal numbers of binary64",
  "in double, too")
tap.throws(function() number.text(R.new(1), "half") end, "no real 'half'", "there is no third real")

-- ---- reading back -----------------------------------------------------------------------------------------

random.seed(2024)
local function bits(n) -- n <= 30 random bits; the generator's low bits are its weakest
  return (random.int(0x7ffffffe) >> (30 - n)) & ((1 << n) - 1)
end

-- Any finite double by its bit pattern; every fourth is subnormal.
local function any_double(k)
  local exponent = k % 4 == 0 and 0 or bits(11)
  local pattern = bits(1) << 63 | exponent << 52 | bits(26) << 26 | bits(26)
  local x = string.unpack("<d", string.pack("<i8", pattern))
  return (x - x ~= 0 or x == 0) and any_double(k + 1) or x
end

local function any_float(k)
  local exponent = k % 4 == 0 and 0 or bits(8)
  local x = string.unpack("<f", string.pack("<I4", bits(1) << 31 | exponent << 23 | bits(23)))
  return (x - x ~= 0 or x == 0) and any_float(k + 1) or x
end

local function significant(text)
  local digits = string.gsub(string.match(text, "^[^eF]*"), "[-.]", "")
  return #string.match(digits, "^0*(.-)0*$")
end

local COUNT = 2000
local sample = { double = {}, float = {} }
local failures = { read = {}, long = {}, decimal = {} }
for k = 1, COUNT do
  local x = any_double(k)
  local text = number.text(R.fromdouble(x), "double")
  if tonumber(text) ~= x then table.insert(failures.read, text) end
  local fewer = significant(text) - 1
  if fewer > 0 and tonumber(string.format("%." .. fewer - 1 .. "e", x)) == x then table.insert(failures.long, text) end
  if number.text(R.decimal(x), "double") ~= text then table.insert(failures.decimal, text) end
  if k <= 300 then sample.double[k] = { text, x } end
end
tap.is(table.concat(failures.read, " "), "", "2000 random doubles read back to the bit")
tap.is(table.concat(failures.long, " "), "", "none of them could be printed with a digit less")
tap.is(table.concat(failures.decimal, " "), "", "a double and its shortest decimal print alike")

failures = { read = {}, long = {}, suffix = {} }
for k = 1, COUNT do
  local x = any_float(k)
  local text = number.text(R.fromdouble(x), "float")
  local value = string.match(text, "^(.*)F$")
  if not value then
    table.insert(failures.suffix, text)
  else
    if R.tofloat(R.parse(value)) ~= x then table.insert(failures.read, text) end
    local fewer = significant(text) - 1
    local shorter = fewer > 0 and R.parse(string.format("%." .. fewer - 1 .. "e", x))
    if shorter and R.tofloat(shorter) == x then table.insert(failures.long, text) end
  end
  if k <= 300 then sample.float[k] = { text, x } end
end
tap.is(table.concat(failures.suffix, " "), "", "2000 random floats all carry the suffix F")
tap.is(table.concat(failures.read, " "), "", "they read back to the bit when rounded once")
tap.is(table.concat(failures.long, " "), "", "none of them could be printed with a digit less, in float")

-- ---- quotients ----------------------------------------------------------------------------------------------

for _, real in ipairs { "double", "float" } do
  local round = real == "double" and R.todouble or R.tofloat
  local width = real == "double" and 26 or 23
  local quotients, wrong = 0, {}
  for k = 1, 500 do
    local q = R.new(bits(width) + 1, bits(k % width + 1) + 1)
    local text = number.text(q, real)
    local n, d = string.match(text, "^([%d.e]+)F?/([%d.e]+)F?$")
    if n then
      quotients = quotients + 1
      if R.parse(n) / R.parse(d) ~= q then table.insert(wrong, text) end
      if round(R.parse(n)) ~= tonumber(n) or round(R.parse(d)) ~= tonumber(d) then table.insert(wrong, text) end
    end
    sample[real][300 + k] = { text, round(q) }
  end
  tap.ok(quotients > 300, real .. ": most random fractions print as quotients")
  tap.is(table.concat(wrong, " "), "", real .. ": their terms are exact")
end

-- ---- the C compiler's opinion -------------------------------------------------------------------------------

for _, real in ipairs { "double", "float" } do
  local lines = { "#include <stdio.h>", "static const " .. real .. " value[] = {" }
  for _, row in ipairs(sample[real]) do lines[#lines + 1] = "  " .. row[1] .. "," end
  lines[#lines + 1] = "};"
  lines[#lines + 1] = string.format(
    "int main(void) { int i; for (i = 0; i < %d; i++) printf(\"%%a\\n\", (double)value[i]); return 0; }", #sample[real])
  local values = compiled.numbers(table.concat(lines, "\n") .. "\n")
  local wrong = {}
  for k, row in ipairs(sample[real]) do
    if values[k] ~= row[2] then wrong[#wrong + 1] = row[1] end
  end
  tap.is(#values, #sample[real], real .. ": 800 literals compile without a warning")
  tap.is(table.concat(wrong, " "), "", real .. ": the compiler reads each as the correctly rounded value")
end

tap.done()
