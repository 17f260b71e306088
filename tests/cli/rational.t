#!/usr/bin/env lua5.4
-- rational.t - exact rational numbers: arithmetic, text, correct rounding, limits.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: Lua's 64-bit integers on small operands, published digits, the C library's strtod (through
-- tonumber) and its conversion to float (through string.pack), algebraic identities on large random numbers.

package.cpath = "build/lua/?.so"
local tap = require "tests.tap"
local R = require "polhode_rational"

math.randomseed(1749)

local function str(x) return tostring(x) end
local function p(s) return assert(R.parse(s)) end

-- How often `check` holds in n trials; the first counterexample is shown.
local function always(n, name, check)
  for _ = 1, n do
    local good, why = check()
    if not good then
      tap.diag(why or "no counterexample given")
      return tap.ok(false, name)
    end
  end
  return tap.ok(true, name)
end

local function small() return math.random(-1000000, 1000000) end
local function large()
  local digits = {}
  for i = 1, math.random(1, 60) do digits[i] = math.random(0, 9) end
  local sign = math.random(2) == 1 and "-" or ""
  return p(sign .. table.concat(digits)) / R.new(math.random(1, math.maxinteger))
end

-- ---- arithmetic ----

local function gcd(a, b)
  while b ~= 0 do a, b = b, a % b end
  return a < 0 and -a or a
end

local function fraction(n, d)
  if d < 0 then n, d = -n, -d end
  local g = gcd(n, d)
  n, d = n // g, d // g
  return d == 1 and string.format("%d", n) or string.format("%d/%d", n, d)
end

always(2000, "+ - * / on small fractions agree with integer arithmetic", function()
  local a, b, c, d = small(), math.random(1, 1000), small(), math.random(1, 1000)
  local x, y = R.new(a, b), R.new(c, d)
  local good = str(x + y) == fraction(a * d + c * b, b * d) and str(x - y) == fraction(a * d - c * b, b * d)
    and str(x * y) == fraction(a * c, b * d) and (c == 0 or str(x / y) == fraction(a * d, b * c))
    and str(-x) == fraction(-a, b)
  return good, str(x) .. " and " .. str(y)
end)

always(2000, "order and equality agree with cross multiplication", function()
  local a, b, c, d = math.random(-20, 20), math.random(1, 9), math.random(-20, 20), math.random(1, 9)
  local x, y = R.new(a, b), R.new(c, d)
  local s, t = a * d, c * b
  return (x < y) == (s < t) and (x <= y) == (s <= t) and (x == y) == (s == t) and (x > y) == (s > t),
    str(x) .. " and " .. str(y)
end)

always(300, "ring identities hold for numbers of hundreds of bits", function()
  local a, b, c = large(), large(), large()
  return (a + b) * (a - b) == a * a - b * b and a * (b + c) == a * b + a * c and (a + b) + c == a + (b + c)
    and (a == R.new(0) or (b / a) * a == b) and a - a == R.new(0), str(a) .. ", " .. str(b)
end)

always(300, "num and den rebuild a number and are coprime", function()
  local a = large()
  return R.num(a) / R.den(a) == a and R.gcd(R.num(a), R.den(a)) == R.new(1) and R.den(a) > 0, str(a)
end)

always(300, "powers multiply, and a negative exponent is the reciprocal", function()
  local a, m, n = large(), math.random(0, 12), math.random(0, 12)
  return a ^ (m + n) == a ^ m * a ^ n and (a == R.new(0) or a ^ -n * a ^ n == R.new(1)), str(a)
end)

tap.is(str(R.new(2) ^ 100), "1267650600228229401496703205376", "2^100 has its published digits")
local factorial = R.new(1)
for i = 2, 30 do factorial = factorial * i end
tap.is(str(factorial), "265252859812191058636308480000000", "30! has its published digits")
tap.is(str(R.new(math.mininteger)), "-9223372036854775808", "the least Lua integer is lifted whole")
tap.is(str(-R.new(math.mininteger)), "9223372036854775808", "its negative does not wrap")
tap.is(R.toint(R.new(math.mininteger)), math.mininteger, "toint gives the least Lua integer back")
tap.is(R.toint(-R.new(math.mininteger)), nil, "toint of 2^63 is nil, not a wrapped number")
tap.is(R.toint(R.new(math.maxinteger)), math.maxinteger, "toint gives the greatest Lua integer back")
tap.is(R.toint(R.new(1, 2)), nil, "toint of 1/2 is nil")
tap.ok(R.floor(R.new(7, 2)) == R.new(3) and R.floor(R.new(-7, 2)) == R.new(-4) and R.floor(R.new(-4)) == R.new(-4) and
  R.floor(R.new(10) ^ 30 + R.new(1, 3)) == R.new(10) ^ 30, "floor is the integer at or below, of any size")
tap.is(str(R.new(0) ^ 0), "1", "0^0 is 1, as for an empty product")
tap.is(str(R.new(-1) ^ math.mininteger), "1", "(-1) to the least integer is 1 at once")
tap.is(str(3 - R.new(1, 3)), "8/3", "a Lua integer on the left is lifted")
tap.is(str(R.new(1, 3) * 3), "1", "a Lua integer on the right is lifted")
tap.ok(R.new(1, 2) < 1 and 1 > R.new(1, 2) and R.new(5, 2) > 2, "Lua integers compare with rationals")
tap.ok(R.new(4, 2) == R.new(2) and R.new(1, 2) ~= R.new(1, 3), "equal values are ==, different ones are not")
tap.is(R.sign(R.new(-3, 7)), -1, "sign of a negative number is -1")
tap.is(R.sign(R.new(0)), 0, "sign of zero is 0")
tap.ok(R.isint(R.new(4, 2)) and not R.isint(R.new(1, 2)), "isint looks at the denominator in lowest terms")
tap.is(str(R.abs(R.new(-2, 3))), "2/3", "abs drops the sign")
tap.ok(R.is(R.new(1)) and not R.is(1) and not R.is("1") and not R.is(nil), "is knows its own")
tap.throws(function() return R.new(1) / 0 end, "division by zero", "a quotient by 0 raises")
tap.throws(function() return R.new(1, 0) end, "division by zero", "new with denominator 0 raises")
tap.throws(function() return R.new(0) ^ -1 end, "division by zero", "0^-1 raises")
tap.throws(function() return R.new(1) + 0.5 end, "number", "a float is refused by +")
tap.throws(function() return R.new(0.5) end, "integer", "a float is refused by new")
tap.throws(function() return R.new(2) ^ R.new(2) end, "integer", "an exponent must be a Lua integer")
tap.throws(function() return R.new(1) < "2" end, "", "a string is refused by <")

-- ---- gcd and roots ----

tap.is(str(R.gcd(R.new(1, 6), R.new(1, 4))), "1/12", "gcd of fractions: gcd of numerators over lcm of denominators")
tap.is(str(R.gcd(R.new(0), R.new(-3, 2))), "3/2", "gcd with 0 is the other's size")
tap.is(str(R.gcd(R.new(0), R.new(0))), "0", "gcd of zeros is 0")
always(300, "both arguments are whole multiples of the gcd, with coprime multiples", function()
  local a, b = large(), large()
  local g = R.gcd(a, b)
  if g == R.new(0) then return true end
  return R.isint(a / g) and R.isint(b / g) and R.gcd(a / g, b / g) == R.new(1), str(a) .. " " .. str(b)
end)
always(300, "root undoes a power", function()
  local a, n = R.abs(large()), math.random(2, 7)
  return R.root(a ^ n, n) == a, str(a)
end)
tap.is(str(R.root(R.new(-8, 27), 3)), "-2/3", "an odd root of a negative number is negative")
tap.is(R.root(R.new(-4), 2), nil, "an even root of a negative number is nil")
tap.is(R.root(R.new(2), 2), nil, "the root of 2 is not rational")
tap.is(R.root(R.new(4, 3), 2), nil, "a root that only the numerator has is nil")
tap.is(str(R.root(R.new(0), 5)), "0", "the root of 0 is 0")
tap.is(R.root(R.new(2) ^ 1000 + 1, 1000), nil, "2^1000 + 1 has no 1000th root")

-- ---- text ----

for _, row in ipairs {
  { "3/7", "3/7" }, { "-12", "-12" }, { "+4/6", "2/3" }, { "0.1", "1/10" }, { "1.5e-3", "3/2000" }, { ".5", "1/2" },
  { "5.", "5" }, { "-0", "0" }, { "0e999999999999999999999", "0" }, { "1E2", "100" }, { "1e+2", "100" },
  { "007", "7" }, { "0.10", "1/10" }, { "-2.50e1", "-25" },
} do
  tap.is(str(R.parse(row[1])), row[2], "parse " .. row[1] .. " is " .. row[2])
end
for _, text in ipairs { "", "-", "+", ".", "e5", "1e", "1e+", "1/", "/2", "1/-2", "1//2", "1.5/2", "0x10", "1 ", " 1",
  "1e5.5", "inf", "nan", "1_000", "--1", "1.2.3", "1\0002" } do
  local value, why = R.parse(text)
  tap.ok(value == nil and why == "malformed number", string.format("parse %q is malformed", text), str(value))
end
tap.is(select(2, R.parse("1/0")), "division by zero", "parse 1/0 says why")
tap.is(select(2, R.parse("1e400000")), "number too large", "an exponent beyond the bound is refused at once")
tap.is(select(2, R.parse("1e-400000")), "number too large", "a tiny number beyond the bound too")
tap.is(select(2, R.parse("1e99999999999999999999")), "number too large", "an exponent of 20 digits does not wrap")
tap.is(select(2, R.parse(string.rep("9", 2000000))), "number too large", "two million digits are refused")
tap.is(str(R.parse("1e300000")), "1" .. string.rep("0", 300000), "1e300000 has all its digits")
tap.throws(function() return R.parse(12) end, "string", "parse wants text, not a number")
always(300, "text reads back to the same number", function()
  local a = large()
  return p(str(a)) == a, str(a)
end)

-- ---- limits ----

tap.throws(function() return R.new(2) ^ 1000001 end, "number too large", "2^1000001 is refused")
tap.throws(function() return R.new(10) ^ math.maxinteger end, "number too large", "10^maxinteger is refused at once")
tap.throws(function() return R.new(10) ^ math.mininteger end, "number too large", "so is 10^mininteger")
tap.throws(function()
  local x = R.new(3)
  for _ = 1, 30 do x = x * x end
end, "number too large", "repeated squaring ends in an error")
tap.ok(R.new(2) ^ 999999 > 0, "2^999999 is within the bound")
tap.throws(function() return R.new(2) ^ 999999 * 4 end, "number too large", "four times that is not")

-- ---- binary ----

-- IEEE bits of a double as a Lua integer, and back.
local function bits(x) return (string.unpack("<i8", string.pack("<d", x))) end
local function from_bits(n) return (string.unpack("<d", string.pack("<i8", n))) end
local function finite()
  while true do
    local x = from_bits(math.random(0))
    if x == x and x ~= math.huge and x ~= -math.huge then return x end
  end
end
-- every class: normal, near 1, subnormal, powers of two
local function any_double()
  local kind = math.random(4)
  if kind == 1 then return finite() end
  if kind == 2 then return (math.random() - 0.5) * 8 end
  if kind == 3 then return from_bits(math.random(0, 0xfffffffffffff)) end
  return 2.0 ^ math.random(-1074, 1023)
end

always(3000, "todouble undoes fromdouble for doubles of every class", function()
  local x = any_double()
  return R.todouble(R.fromdouble(x)) == x, string.format("%a", x)
end)

always(3000, "todouble of a random decimal is what strtod reads", function()
  local digits = {}
  for i = 1, math.random(1, 40) do digits[i] = math.random(0, 9) end
  local text = table.concat(digits, "") .. "e" .. math.random(-360, 300)
  return bits(R.todouble(p(text))) == bits(tonumber(text) + 0.0), text
end)

always(1000, "a point half way between two doubles goes to the even one, a hair beside it to the nearer", function()
  local x = math.abs(any_double())
  if x >= 1.7e308 then return true end
  local y = from_bits(bits(x) + 1)
  local middle = (R.fromdouble(x) + R.fromdouble(y)) / 2
  local hair = (R.fromdouble(y) - R.fromdouble(x)) / R.new(2) ^ 200
  local even = bits(x) % 2 == 0 and x or y
  return R.todouble(middle) == even and R.todouble(middle + hair) == y and R.todouble(middle - hair) == x
    and R.todouble(-middle) == -even, string.format("%a", x)
end)

local least = R.new(2) ^ -1074
tap.is(R.todouble(least), 0x1p-1074, "the least subnormal survives")
tap.is(R.todouble(least / 2), 0.0, "half the least subnormal ties to zero")
tap.is(R.todouble(least / 2 + least / 1000), 0x1p-1074, "more than half of it rounds up")
tap.is(R.todouble(R.new(2) ^ -5000), 0.0, "far below is zero")
tap.is(1 / R.todouble(-(R.new(2) ^ -5000)), -math.huge, "and keeps its sign")
local most = R.fromdouble(0x1.fffffffffffffp1023)
tap.is(R.todouble(most), 0x1.fffffffffffffp1023, "the greatest double survives")
tap.is(R.todouble(most + R.new(2) ^ 970 - 1), 0x1.fffffffffffffp1023, "just below the tie to infinity it is kept")
tap.is(R.todouble(most + R.new(2) ^ 970), math.huge, "the tie overflows, as IEEE 754 says")
tap.is(R.todouble(-(R.new(10) ^ 400)), -math.huge, "-10^400 is -infinity")

always(3000, "tofloat of a double is the processor's conversion", function()
  local x = (math.random() - 0.5) * 2.0 ^ math.random(-155, 130)
  return R.tofloat(R.fromdouble(x)) == string.unpack("<f", string.pack("<f", x)), string.format("%a", x)
end)
tap.is(R.tofloat(R.new(16777217)), 16777216.0, "2^24 + 1 ties to even in binary32")
tap.is(R.tofloat(R.new(16777217) + R.new(2) ^ -40), 16777218.0, "a hair more rounds up: no double rounding")
tap.is(R.tofloat(R.new(2) ^ -149), 0x1p-149, "the least float survives")
tap.is(R.tofloat(R.new(2) ^ -150), 0.0, "half of it ties to zero")
tap.is(R.tofloat(R.new(2) ^ 128 - R.new(2) ^ 103), math.huge, "the tie above the greatest float overflows")
tap.is(R.tofloat(R.new(2) ^ 128 - R.new(2) ^ 103 - 1), 0x1.fffffep127, "just below, it does not")
tap.throws(function() return R.fromdouble(0 / 0) end, "finite", "fromdouble refuses NaN")
tap.throws(function() return R.fromdouble(math.huge) end, "finite", "fromdouble refuses infinity")
tap.is(str(R.fromdouble(0.1)), "3602879701896397/36028797018963968", "fromdouble(0.1) is the double's own value")
tap.is(str(R.fromdouble(-0.0)), "0", "fromdouble(-0.0) is 0")

-- ---- decimal ----

tap.is(str(R.decimal(0.1)), "1/10", "decimal(0.1) is 1/10")
tap.is(str(R.decimal(1e23)), "1" .. string.rep("0", 23), "decimal(1e23) is the power of ten that was typed")
tap.is(str(R.decimal(-2.5)), "-5/2", "decimal(-2.5) is -5/2")
tap.is(str(R.decimal(9007199254740993)), "9007199254740993", "an integer beyond 2^53 stays exact")
tap.is(R.decimal(5e-324), p("5e-324"), "decimal of the least subnormal is 5e-324")
tap.is(R.decimal(2.0 ^ -44), p("5.684341886080802e-14"),
  "above a power of two the shortest decimal may be the farther one")
tap.is(str(R.decimal(0.0)), "0", "decimal(0.0) is 0")
always(2000, "a decimal of up to 15 digits is found again from the double it denotes", function()
  local text = string.format("%d.%0" .. math.random(1, 12) .. "d", math.random(1, 999), math.random(0, 9))
    .. "e" .. math.random(-290, 290)
  return R.decimal(tonumber(text)) == p(text), text
end)
always(2000, "decimal(x) reads back to x", function()
  local x = any_double()
  return R.todouble(R.decimal(x)) == x, string.format("%a", x)
end)

-- ---- log2 and round ----

always(500, "2^log2 brackets the number", function()
  local a = R.abs(large())
  if a == R.new(0) then return true end
  local k = R.log2(a)
  return R.new(2) ^ k <= a and a < R.new(2) ^ (k + 1), str(a)
end)
tap.is(R.log2(R.new(1)), 0, "log2 of 1 is 0")
tap.is(R.log2(R.new(-1, 8)), -3, "log2 takes the size")
tap.throws(function() return R.log2(R.new(0)) end, "zero", "log2 of 0 raises")
always(500, "round to 53 bits is todouble wherever nothing under- or overflows", function()
  local a = large()
  return R.round(a, 53) == R.fromdouble(R.todouble(a)), str(a)
end)
always(500, "round is within half a unit in its last place", function()
  local a, n = large(), math.random(1, 300)
  if a == R.new(0) then return true end
  return R.abs(R.round(a, n) - a) <= R.new(2) ^ (R.log2(a) - n), str(a)
end)
tap.is(str(R.round(R.new(5), 2)), "4", "round ties to even: 5 to two bits is 4")
tap.is(str(R.round(R.new(7), 2)), "8", "and 7 is 8")

-- ---- functions ----

local PI = "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899"
local E = "2.71828182845904523536028747135266249775724709369995957496696762772407663035354759"
local ROOT2 = "1.41421356237309504880168872420969807856967187537694807317667973799073247846210703"
for _, row in ipairs {
  { "pi", PI }, { "exp", E, R.new(1) }, { "sqrt", ROOT2, R.new(2) },
  { "pow", ROOT2, R.new(2), R.new(1, 2) }, { "acos", PI, R.new(-1) },
} do
  tap.ok(R.abs(R.apply(row[1], 250, row[3], row[4]) - p(row[2])) < p("1e-74"),
    row[1] .. " has its first 74 published decimals")
end
always(300, "sqrt at 53 bits is the processor's", function()
  local x = math.random() * 2.0 ^ math.random(-100, 100)
  return R.todouble(R.apply("sqrt", 53, R.fromdouble(x))) == math.sqrt(x), string.format("%a", x)
end)
-- glibc's sin, cos, exp, log err by less than one unit in the last place, 2^-52 of the value
for _, name in ipairs { "sin", "cos", "tan", "exp", "log", "atan" } do
  always(200, name .. " at 53 bits is within a unit of the C library's", function()
    local x = math.random() * 10 + 0.01
    local want = math[name](x)
    local got = R.todouble(R.apply(name, 53, R.fromdouble(x)))
    return math.abs(got - want) <= 0x1p-52 * math.abs(want), string.format("%a", x)
  end)
end
always(100, "functions of a fraction are rounded once: 53 bits directly or by way of 300", function()
  local x = R.new(math.random(1, 999), math.random(1000, 1999))
  for _, name in ipairs { "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh", "cbrt" } do
    if R.apply(name, 53, x) ~= R.round(R.apply(name, 300, x), 53) then return false, name .. " " .. str(x) end
  end
  local y = R.new(math.random(-99, 99), 7)
  return R.apply("atan2", 53, y, x) == R.round(R.apply("atan2", 300, y, x), 53)
    and R.apply("pow", 53, x, y) == R.round(R.apply("pow", 300, x, y), 53), str(x) .. " " .. str(y)
end)
tap.is(str(R.apply("cbrt", 53, R.new(-27, 8))), "-3/2", "cbrt of -27/8 is exact")
tap.is(str(R.apply("sin", 53, R.new(0))), "0", "sin 0 is the rational 0")
tap.is(str(R.apply("pow", 1, R.new(1, 9), R.new(-1, 2))), "4", "an exact tie, (1/9)^(-1/2) = 3 to one bit, ends")
tap.is(R.apply("sin", 53, p("1e22")), R.fromdouble(-0.8522008497671888),
  "sin 1e22 is -0.8522008497671888: the argument is reduced in full")
for _, row in ipairs { { "sqrt", R.new(-1) }, { "log", R.new(0) }, { "asin", R.new(2) },
  { "exp", R.new(10) ^ 12 }, { "exp", -(R.new(10) ^ 12) }, { "pow", R.new(-2), R.new(1, 2) } } do
  tap.is(R.apply(row[1], 53, row[2], row[3]), nil, row[1] .. " of " .. str(row[2]) .. " is nil")
end
tap.throws(function() return R.apply("gamma", 53, R.new(1)) end, "unknown function", "an unknown function raises")
tap.throws(function() return R.apply("sin", 0, R.new(1)) end, "precision", "precision 0 raises")
tap.throws(function() return R.apply("sin", 10000000, R.new(1)) end, "precision", "ten million bits are refused")

-- ---- memory ----

collectgarbage()
local before = collectgarbage("count")
do
  local big = R.new(2) ^ 900000
  -- 900000 bits are 110 kB of limbs; a head and rounding to blocks come on top
  tap.near(collectgarbage("count") - before, 900000 / 8 / 1024, 0.02, 1, "Lua's collector counts the limbs",
    "2 % and 1 kB for heads")
  tap.ok(big > 0, "the number is alive meanwhile")
end
collectgarbage()
tap.ok(collectgarbage("count") - before < 20, "and gives them back")

-- Gauss's constant 1/agm(1, sqrt 2), OEIS A014549, and log(1 + sqrt 2), A091648
tap.is(string.format("%.15f", R.todouble(R.new(1) / R.apply("agm", 200, R.new(1), R.apply("sqrt", 200, R.new(2))))),
  "0.834626841674073", "agm")
tap.is(string.format("%.15f", R.todouble(R.apply("asinh", 60, R.new(1)))), "0.881373587019543", "asinh")
tap.done()
