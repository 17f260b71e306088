-- sign.lua -- what is known of an expression's sign from its form alone.
--
-- ABOVE the line.  "Yes" is a proof, "no" means that the form does not show it: x^2 - 2*x*y + y^2 is not seen to be a
-- square.  The rules: an even power, a root, |x|, exp, cosh and the means of exact.lua are not negative whatever is in
-- them; a sum, a product or the smaller or larger of what is not negative is not negative; a symbol is what was
-- declared of it.  The answer is kept for each node, so a question costs one visit of each node once.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local sign = {}

local positive = { abs = true, exp = true, cosh = true, pi = true, ellipsoid_area = true, ellipsoid_normal = true,
  arc_across = true, arc_along = true, catenary_width = true, catenary_height = true }

local known = setmetatable({}, { __mode = "k" })

-- By the rules of the head; sign.nonnegative keeps the answer.
local function found(e)
  if e.kind == "num" then return R.sign(e.value) >= 0 end
  if e.kind == "sym" then return e.positive end
  if e.fn == "max" and sign.nonnegative(e[1]) then return true end
  if e.kind == "call" and e.fn ~= "min" and e.fn ~= "max" then return positive[e.fn] or false end
  if e.kind == "pow" then
    if sign.nonnegative(e.base) then return true end
    return R.isint(e.exp / R.new(2)) or R.den(e.exp) == R.new(2)
  end
  for i = 1, #e do
    if not sign.nonnegative(e[i]) then return false end
  end
  return true
end

-- Is e >= 0 for every real value of its symbols (positive ones positive)?
function sign.nonnegative(e)
  if known[e] == nil then known[e] = found(e) end
  return known[e]
end

return sign
