-- signed.lua -- where signs stand when an expression is written: formula/expression.lua asks it.
--
--     signed.product(e, sign, name) -> {minus, c, above, below}    sign e as +-c above/below, c a positive rational
--     signed.terms(e, sign, name)   -> the products of sign e, e a sum, in the order in which they are written
-- above, below: lists of {base, exp, sign}: the factor (sign base)^exp, exp > 0.  -(b^2 - c^2) reads better as
-- c^2 - b^2, so a minus goes into the first sum whose terms have both signs: that sum's sign is -1, all others are 1,
-- and whoever writes it writes signed.terms with that sign.  The sign comes down with the call and goes nowhere else.
-- name(e), or nil: is e written as a name?  Then it is neither opened nor turned round.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local signed = {}

local function never() return false end

-- The first term of a sum whose coefficient is negative, if there is one.
local function negative(e)
  for i = 1, #e do
    if R.sign((expr.split(e[i]))) < 0 then return i end
  end
  return nil
end

function signed.product(e, sign, name)
  name = name or never
  local c, rest = R.one, e
  if not name(e) then c, rest = expr.split(e) end
  local out = { minus = sign * R.sign(c) < 0, c = R.abs(c), above = {}, below = {} }
  for _, f in ipairs(rest == expr.one and {} or rest.kind == "mul" and not name(rest) and rest or { rest }) do
    local opened = f.kind == "pow" and not name(f)
    local part = { base = opened and f.base or f, exp = opened and R.abs(f.exp) or R.one, sign = 1 }
    if out.minus and f.kind == "add" and not name(f) and negative(f) then out.minus, part.sign = false, -1 end
    table.insert(opened and R.sign(f.exp) < 0 and out.below or out.above, part)
  end
  return out
end

-- A sum's own first term is positive; turned round it begins with one that has become so.
function signed.terms(e, sign, name)
  local first, list = sign < 0 and negative(e) or 1, {}
  for i = 1, #e do list[i] = signed.product(e[(first + i - 2) % #e + 1], sign, name) end
  return list
end

return signed
