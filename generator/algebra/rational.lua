-- rational.lua -- exact rational numbers: the generator's only numbers above the line.
--
-- The arithmetic is GMP's, through the small C module `polhode_rational`; this file gives it the two
-- readings a scene needs: a Lua number means the decimal its author typed (0.1 is 1/10, not
-- 3602879701896397/2^55), and a string such as "1/3" means the quotient.  There is no rounding and no
-- overflow here; a result that would grow past a million bits is an error that says so.
-- Not here: printing as C (emit/number.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "polhode_rational"

local rational = {}
for name, fn in pairs(R) do rational[name] = fn end

rational.zero = R.new(0)
rational.one = R.new(1)
rational.half = R.new(1, 2)

-- What R.parse refuses, as a rule of the kind "must ...".
local rules = {
  ["malformed number"] = "must be a number such as \"0.1\", \"1e-3\" or \"1/3\"",
  ["division by zero"] = "must not divide by zero",
  ["number too large"] = "must have at most 300000 digits",
}

-- The exact meaning of x: a rational as it is, an integer, a finite double as its shortest decimal, or a
-- string "p/q" or decimal.  Returns nil and a phrase if x denotes no number.
function rational.lift(x)
  if R.is(x) then return x end
  if math.type(x) == "integer" then return R.new(x) end
  if math.type(x) == "float" then
    if x ~= x or x == math.huge or x == -math.huge then return nil, "must be finite" end
    return R.decimal(x)
  end
  if type(x) == "string" then
    local q, why = R.parse(x)
    return q, why and (rules[why] or why)
  end
  return nil, "must be a number"
end

-- The n with 10^n <= |q| < 10^(n + 1); of 0 it is 0.
function rational.decade(q)
  if R.sign(q) == 0 then return 0 end
  local bits = R.log2(q)
  if bits >= 0 and bits < 3 then return 0 end
  local n = bits * 30103 // 100000 - 1
  while R.new(10) ^ (n + 1) <= R.abs(q) do n = n + 1 end
  return n
end

-- Digits before or after the point from which on a coefficient is long: a whole number that stands for a decimal, for
-- algebra, which is exact, clears the denominators of a sum.  In a type of numbers with an end such scales must not
-- pile up in powers and products; who lays out a sum gives them back to it (ir/lower/size.lua, methods/series.lua).
rational.LONG = 3

-- That power of ten as text with q's sign: what is said of a number that no double holds.
function rational.magnitude(q) return (R.sign(q) < 0 and "-1e" or "1e") .. rational.decade(q) end

return rational
