-- rounding.lua: how often what an ir computes has been rounded.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line; reads only.  Each operation multiplies its exact result by 1 + d, |d| <= u, with u
-- half of epsilon (N. Higham, Accuracy and Stability of Numerical Algorithms, 2002, sections 2.2 and
-- 3.1).  A value that consists of sums and products is, multiplied out, a sum of terms, and each term
-- has been multiplied by at most k such factors:
--     k(x + y) = max(k(x), k(y)) + 1        k(x y) = k(x) + k(y) + 1
-- so that its error is at most k u/(1 - k u) times the sum of the terms' absolute values, however
-- much of it cancels.  A quotient by one product keeps the law, and so does its square root; by a sum
-- it does not, for the sum may cancel: then there is no k, and neither for functions of libm.  Where
-- a result leaves the type's normal range the law says nothing.

local R = require "polhode_rational"

local rounding = {}

-- By opcode: k of the result and whether it is one product, from the operands {k, single}; nil: none.
local rule = {
  neg = function(x) return x.k, x.single end,
  add = function(x, y) return math.max(x.k, y.k) + 1, false end,
  mul = function(x, y) return x.k + y.k + 1, x.single and y.single end,
  div = function(x, y)
    if y.single then return x.k + y.k + 1, x.single end
  end,
  sqrt = function(x) -- of a product of k factors: k/2 factors and one more
    if x.single then return (x.k + 1) // 2 + 1, true end
  end,
  powi = function(x, _, i) return i.n * x.k + i.n - 1, x.single end,
}
rule.sub = rule.add

-- Is the rational a number of the type as it stands?
local function exact(q, real)
  local near = R.todouble(q)
  if real == "float" then near = string.unpack("f", string.pack("f", near)) end
  return R.fromdouble(near) == q
end

-- The largest k of what the ir stores, for its real type "double" or "float", and whether everything that it stores is
-- one product; nil if one of its values has none.
function rounding.run(ir, real)
  local of, most, single = {}, 0, true
  for _, i in ipairs(ir.inputs) do of[i.dst] = { k = 0, single = true } end
  for _, i in ipairs(ir.consts) do of[i.dst] = { k = exact(i.value, real) and 0 or 1, single = true } end
  for _, group in ipairs(ir.groups) do
    for _, i in ipairs(group.code) do
      local x, y = of[i.src1], i.src2 and of[i.src2]
      if i.op == "store" then
        if not x then return nil end
        most, single = math.max(most, x.k), single and x.single
      elseif rule[i.op] and x and (y or not i.src2) then
        local k, one = rule[i.op](x, y, i)
        of[i.dst] = k and { k = k, single = one }
      end
    end
  end
  return most, single
end

return rounding
