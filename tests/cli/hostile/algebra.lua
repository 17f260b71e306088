-- algebra.lua - attempts to make the algebra explode: numbers, expressions, lists.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Rows as in words.lua; each scene is short and what follows from it is not.

local steps, long = "the scene ran longer than 50000000 instructions", "MiB of terms"
local LUMP = "local b = solid.box { x = 1, y = 1, z = 1, mass = 1 } local s = b "
local WITH = "return scene { name = 's', body = solid.box { x = 1, y = 2, z = 3, mass = 1 }, effects = "

return {
  about = "algebra",
  { "3^100000 and on", "local x = exact '3' for i = 1, 40 do x = x ^ 64 end BOX", "power: number too large" },
  { "an exponent of a hundred thousand", "return exact '3' ^ 100000", "the exponent must be a plain number" },
  { "300000 digits", "local m = exact(('9'):rep(290000)) return scene { name = 's', body = solid.box { x = m, y " ..
    "= 1, z = 1, " ..
    "mass = 1 } }", "grows a number beyond 1000000 bits" },
  { "more digits than that", "return exact(('9'):rep(900000))", "must have at most 300000 digits" },
  { "1e999999999", "return exact '1e999999999'", "must have at most 300000 digits" },
  { "1e308 to the sixty-fourth", "local x = exact '1e308' ^ 64 return scene { name = 's', body = solid.box { x = " ..
    "x, y = 1, " ..
    "z = 1, mass = 1 } }", "must be within the range of double" },
  { "a literal of a million digits", "return " .. ("9"):rep(1000000), "the script must" },
  { "a hexadecimal literal of as many", "return 0x" .. ("f"):rep(1000000), "the script must" },
  { "products of large numbers", "local x = exact '3' ^ 64 x = x ^ 64 x = x ^ 20 while true do local y = x * (x " ..
    "+ 1) end", steps },
  { "many large numbers", "local x, t = exact '3' ^ 64, {} x = x ^ 64 x = x ^ 20 for i = 1, 1e9 do t[i] = x + i " ..
    "end", "ran longer" },
  { "the sine of a huge number", "local a = 2 + sin(exact '1e250000') return scene { name = 's', body = " ..
    "solid.box { x = a, y = 1, z = 1, " ..
    "mass = 1 } }", steps },
  { "towers of exponentials", "return scene { name = 's', body = solid.box { x = exp(exp(exp(exp(2)))), y = 1, z " ..
    "= 1, mass = 1 } }",
    "must be a real number" },
  { "exponentials on end", "local x = exact '1/3' while true do x = exp(x / 2) end", "ran longer" },
  { "two thousand roots, nested", "local x = param('a', 1) for i = 1, 2000 do x = sqrt(x + 1) end " ..
    "return scene { name = 's', body = solid.box { x = x, y = 1, z = 1, mass = 1 } }", long },
  { "a continued fraction", "local a, b = param('a', 1), param('b', 2) local x = a for i = 1, 2000 do x = 1 / (x " ..
    "+ b) + a end " ..
    "return scene { name = 's', body = solid.box { x = x, y = 1, z = 1, mass = 1 } }", "" },
  { "a sum of 300 parameters", "local s = 0 for i = 1, 300 do s = s + param('p' .. i, 1, 'm') end " ..
    "return scene { name = 's', body = solid.box { x = s, y = 1, z = 1, mass = 1 } }", "the scene" },
  { "functions of functions", "local x = t for i = 1, 120 do x = sin(x) * cos(x) + x end " .. WITH ..
    "{ effect.torque { body = { x, 0, 0 } } } }", long },
  { "a hundred thousand functions", "local x = t for i = 1, 100000 do x = sin(x) end BOX", "" },
  { "2000 parts", LUMP .. "for i = 1, 2000 do s = s + b:at { i, 0, 0 } end return scene { name = 's', body = s }",
    "a body must have at most 1000 parts" },
  { "60 parts with parameters, turned", "local s for i = 1, 60 do local a = param('a' .. i, 1, 'm') local b = " ..
    "solid.box { x = a, " ..
    "y = 1, z = 1, mass = 1 }:turned { axis = { 1, i, 3 }, angle = i } s = s and s + b:at { i * a, a, 0 } or b end " ..
    "return scene { name = 's', body = s }", long },
  { "a part in a part in a part", LUMP .. "for i = 1, 1e6 do s = s:at { 1, 0, 0 } end return scene { name = 's', " ..
    "body = s }", "" },
  { "five hundred effects", "local e = {} for i = 1, 500 do e[i] = effect.damping { c = i } end " .. WITH ..
    "e }", long },
  { "sixty wheels across", "local e = {} for i = 1, 60 do e[i] = effect.wheel { axis = { i, 1, 0 }, inertia = " ..
    "0.001, speed = 1, " ..
    "included = true } end " .. WITH .. "e }", long },
  { "a table of a million rows", "local r = {} for i = 1, 100000 do r[i] = { i, 1 } end " .. WITH ..
    "{ effect.torque { body = { r, 0, 0 } } } }", "a table of 2 to 100 rows" },
  { "a polygon of 1000 corners", "local p = {} for i = 1, 1000 do p[i] = { i, i * i } end return scene { name = " ..
    "'s', " ..
    "body = plate.polygon { profile = p, mass = 1 } }", "" },
  { "a polygon of 40 parameters", "local p = {} for i = 1, 20 do p[i] = { param('a' .. i, i, 'm'), param('b' .. " ..
    "i, i * i, 'm') } " ..
    "end return scene { name = 's', body = plate.polygon { profile = p, mass = 1 } }", "" },
  { "a region of high degree", "return scene { name = 's', body = solid.region { { x, 0, 1 }, { y, 0, x ^ 60 }, " ..
    "{ z, 0, (x + y) ^ 60 }, density = 1 } }", "" },
  { "a rate of 1e300", "return scene { name = 's', body = solid.box { x = 1, y = 2, z = 3, mass = 1 }, " ..
    "initial = { omega = { 1e300, 1e300, 1 } } }", "every constant must be within its range" },
  { "times of 1e200 in steps of 1e-200", "return scene { name = 's', body = solid.box { x = 1, y = 2, z = 3, " ..
    "mass = 1 }, " ..
    "time = { horizon = exact '1e200', step = exact '1e-200' } }", true },
}
