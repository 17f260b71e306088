-- digits.lua -- how far a number may be off that was rounded to the digits that are written.
--
-- A literal 0.615 reaches us as a double; its shortest decimal that reads back has the digits that were written, but
-- for zeros at the end: of 1.770 it is 1.77.  Numbers that stand together were written alike, with as many decimals or
-- as many significant digits, so up to two zeros are put back; where it is not known which, the coarser is taken.
-- Strings keep their zeros.  A number with as many digits as a double nobody has written by hand: a program has
-- computed it, and then its error is not half a digit but that of the computation.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"

local digits = {}

-- {count = significant digits, last, lead = the powers of ten of the last one and of the first}; nil for what is no
-- decimal: exact.
function digits.of(x)
  local s = type(x) == "number" and diag.show(x) or x
  if type(s) ~= "string" or #s > 60 then return nil end
  local int, frac, power = string.match(s, "^%s*[+-]?(%d*)%.?(%d*)[eE]?([+-]?%d*)%s*$")
  power = math.tointeger(tonumber(power ~= "" and power or "0"))
  if not int or int .. frac == "" or not power or math.abs(power) > 400 then return nil end
  if type(x) == "number" then frac = string.gsub(frac, "0+$", "") end -- 1.0 is printed for 1
  local all, last = string.gsub(int .. frac, "^0+", ""), power - #frac
  local sure = frac == "" and string.gsub(all, "0+$", "") or all -- of 4500 nobody knows
  if sure == "" then return nil end
  return { count = #sure, last = last, lead = last + #all - 1 }
end

local most_zeros = 2 -- that are put back
-- Digits with which programs print doubles: 15 are always right, 17 tell two doubles apart, some print up to 21.
local of_doubles = { 15, 21 }

-- Half a unit of the last digit of each of n numbers that stand together.  list: what digits.of gave (factor: what the
-- number is multiplied by), or false, by place.  Nobody rounds a moment to two digits: such numbers, and 3 beside
-- 9.12345, are exact.
local function halves(list, n)
  -- most: significant digits of the number that has the most; finest: power of ten of the finest last digit
  local most, finest, out = 0, math.huge, {}
  for i = 1, n do
    if list[i] then most, finest = math.max(most, list[i].count), math.min(finest, list[i].last) end
  end
  for i = 1, n do
    local w = list[i]
    out[i] = R.zero
    if w and most >= 3 and (w.count >= most - most_zeros or w.last <= finest + most_zeros) then
      local last = math.min(w.last, math.max(finest, w.lead - most + 1))
      out[i] = R.new(10) ^ last / 2 * (w.factor or R.one)
    end
  end
  return out
end

-- Of n numbers that stand together: {halves = by how much each may be off that was rounded by hand, computed = were
-- they computed in doubles?}
function digits.written(list, n)
  local most = 0
  for i = 1, n do most = math.max(most, list[i] and list[i].count or 0) end
  return { halves = halves(list, n), computed = most >= of_doubles[1] and most <= of_doubles[2] }
end

return digits
