#!/usr/bin/env lua5.4
-- zip.t - archives of stored files, and the numbers and units of modelDescription.xml.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- That other programs read the archives is seen in tests/target/fmu.t; here are the numbers that are known.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local units = require "generator.emit.packages.fmu_units"
local variables = require "generator.emit.packages.fmu_variables"
local zip = require "generator.emit.packages.zip"

-- ---- archives ----

tap.is(zip.crc32 "123456789", 0xCBF43926, "CRC-32: the check value of its definition")
tap.is(zip.crc32 "", 0, "CRC-32 of nothing is 0")
tap.is(zip.crc32(string.rep("\0", 32)), 0x190A55AD, "CRC-32 of 32 zero bytes")

do
  local text = zip.archive { { name = "a", text = "hello" }, { name = "d/b", text = "" } }
  tap.is(#text, (30 + 1 + 5) + (30 + 3) + (46 + 1) + (46 + 3) + 22, "an archive has headers, files and directory only")
  tap.is(text:sub(1, 36), "PK\3\4\20\0\0\8\0\0\0\0\33\0\x86\xA6\x10\x36\5\0\0\0\5\0\0\0\1\0\0\0ahello",
    "a file begins with its local header: stored, 1 January 1980")
  local count, size, place = string.unpack("<I2I4I4", text, #text - 11)
  tap.ok(text:sub(-22, -19) == "PK\5\6" and count == 2 and size == 96 and place == 69 and
    text:sub(place + 1, place + 4) == "PK\1\2", "the end of the directory says where it is")
  tap.is(#zip.archive {}, 22, "an archive without files")
end

-- ---- numbers, text ----

tap.is(number.decimal(R.parse "5/13", "double"), "0.38461538461538464", "a quotient becomes a decimal that reads back")
tap.is(number.decimal(R.parse "-1/10", "float"), "-0.1", "in float without a suffix")
tap.is(number.decimal(R.zero, "double"), "0.0", "nothing")
tap.is(variables.escaped "a<b & \"c\" 'd'\n>\1", "a&lt;b &amp; &quot;c&quot; &apos;d&apos; &gt; ", "text for XML")
tap.is(variables.escaped "I\xCE\xB1", "I\xCE\xB1", "UTF-8 stays")
tap.is(variables.escaped "a\xFFb", "a?b", "what is no UTF-8 does not")

-- ---- units ----

for text, want in pairs { -- any order
  ["kg m^2/s"] = { "kg.m2/s", ' kg="1" m="2" s="-1"' }, ["N m"] = { "N.m", ' kg="1" m="2" s="-2"' },
  ["1"] = { "1", "" }, ["1/s"] = { "1/s", ' s="-1"' }, ["rad/s"] = { "rad/s", ' s="-1" rad="1"' },
  ["rad/s/s"] = { "rad/(s.s)", ' s="-2" rad="1"' }, ["m^3/s^2"] = { "m3/s2", ' m="3" s="-2"' },
  ["1/m^2/kg"] = { "1/(m2.kg)", ' kg="-1" m="-2"' }, J = { "J", ' kg="1" m="2" s="-2"' },
  ["kg/s^2/A"] = { "kg/(s2.A)", ' kg="1" s="-2" A="-1"' } } do
  tap.is(units.name(text), want[1], text .. ": its name")
  tap.is(units.exponents(text), want[2], text .. ": its exponents")
end
tap.is(units.exponents "m^1/2", nil, "a root of a unit has no whole exponents")
tap.is(units.exponents "furlong", nil, "nor has one that is not known")

tap.done()
