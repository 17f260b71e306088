-- number.lua: exact rationals as C literals; the only place where a number becomes C text.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Whatever is printed reads back, in C, as the correctly rounded value of the rational:
--   a decimal that ends      the shortest digits that read back (0.1, 0.0260), often the exact number
--   one that does not        a quotient of two exact integers, 5.0/13.0: C rounds it correctly and a
--                            human can check it
--   terms too large for that shortest digits that read back
-- A literal has a point or an exponent, so it is never an int, and F in float, so it is never a double.
-- A leading minus is plain; parentheses are the caller's, who knows what stands around.
-- A constant that would read back as infinity, or as zero although it is not, is an error; so is one of an instruction
-- below the normal numbers: it has fewer digits than the type, and is zero where processors flush such to zero.

local R = require "generator.algebra.rational"

local number = {}

-- digits: as many always read back; safe: as many are never ambiguous (DBL_DIG, FLT_DIG); integers: up to it all whole
-- numbers are of the type; normal: the exponent of two of its least normal number.
local formats = {
  double = { name = "binary64", round = R.todouble, digits = 17, safe = 15, suffix = "",
    integers = R.new(1 << 53), smallest_safe = 1e-290, normal = -1022 },
  float = { name = "binary32", round = R.tofloat, digits = 9, safe = 6, suffix = "F",
    integers = R.new(1 << 24), smallest_safe = 1e-30, normal = -126 },
}

local function format_of(real)
  return formats[real] or error("number: no real '" .. tostring(real) .. "'", 3)
end

-- Does the decimal expansion of a fraction end?  den: its denominator, at most 2^53.
local function ends(den)
  local n = math.tointeger(R.todouble(den))
  while n & 1 == 0 do n = n >> 1 end
  while n % 5 == 0 do n = n // 5 end
  return n == 1
end

-- The fewest significant digits of x > 0 that read back: "d.ddd" without its point, and the
-- exponent of the first digit.  In the normal range no more than `safe` digits are ever ambiguous, so
-- the search starts there; trailing zeros then give the shorter ones.
local function shortest(x, f)
  for n = x < f.smallest_safe and 1 or f.safe, f.digits do
    local text = string.format("%." .. n - 1 .. "e", x)
    if f.round(R.parse(text)) == x then
      local first, rest, exponent = string.match(text, "^(%d)%.?(%d*)e([+-]%d+)$")
      local digits = string.match(first .. rest, "^(.-)0*$")
      return digits, math.tointeger(tonumber(exponent))
    end
  end
  error("number: no digits read back") -- 17 (9) digits always do
end

-- Plain while short: 0.0001, 100.0, 9.80665; else one digit before the point and an exponent.
local function layout(digits, exponent)
  if exponent >= 0 and exponent < math.max(#digits, 6) then
    digits = digits .. string.rep("0", exponent + 1 - #digits)
    local whole, part = string.sub(digits, 1, exponent + 1), string.sub(digits, exponent + 2)
    return whole .. "." .. (part == "" and "0" or part)
  elseif exponent < 0 and exponent >= -4 then
    return "0." .. string.rep("0", -exponent - 1) .. digits
  end
  local part = string.sub(digits, 2)
  return string.sub(digits, 1, 1) .. (part == "" and "" or "." .. part) .. "e" .. exponent
end

local function decimal(x, f)
  if x == 0 then return "0.0" .. f.suffix end
  return layout(shortest(x, f)) .. f.suffix
end

-- What number.text raises for a constant that the real type cannot hold: {message =}.  A scene's fault, not a bug.
number.out_of_range = { __tostring = function(e) return e.message end }

local function refuse(q, f, what)
  error(setmetatable({ message = "a constant near 2^" .. R.log2(q) .. " " .. what .. " " .. f.name },
    number.out_of_range), 0)
end

-- The C text of the rational q in `real` ("double" or "float").
function number.text(q, real)
  local f = format_of(real)
  local x = f.round(q)
  if x == math.huge or x == -math.huge then
    refuse(q, f, "is beyond the range of")
  elseif x == 0 and R.sign(q) ~= 0 then
    refuse(q, f, "vanishes in")
  end
  local sign = x < 0 and "-" or ""
  local n, d = R.abs(R.num(q)), R.den(q)
  if d ~= R.one and n <= f.integers and d <= f.integers and not ends(d) then
    return sign .. decimal(f.round(n), f) .. "/" .. decimal(f.round(d), f)
  end
  return sign .. decimal(math.abs(x), f)
end

-- The same of a constant that code computes with.
function number.constant(q, real)
  local f = format_of(real)
  if R.sign(q) ~= 0 and R.log2(q) < f.normal then refuse(q, f, "is below the normal numbers of") end
  return number.text(q, real)
end

-- The rational q as one decimal that reads back to its nearest double (float: with as many digits as that needs): for
-- formats without quotients.
function number.decimal(q, real)
  local f = format_of(real)
  local x = f.round(q)
  return (x < 0 and "-" or "") .. decimal(math.abs(x), { safe = f.safe, digits = f.digits, round = f.round,
    smallest_safe = f.smallest_safe, suffix = "" })
end

return number
