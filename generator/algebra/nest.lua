-- nest.lua -- polynomials nested as Horner would: 5 b^3 + 20 a b^2 + 45 a^2 b ==> 5 b (b (b + 4 a) + 9 a^2).
--
-- ABOVE the line.  In every sum the factor that the most terms have in common is taken out of them, again and again.
-- That costs fewer multiplications, and for terms of one sign it rounds no worse; but it is not how a person reads a
-- formula, so it is for code and not for reports.
--
-- Law: a x + b x = (a + b) x.  A factor of k terms that is taken out saves k - 1 multiplications.  Greedy, and so not
-- always the least; it ends because each step divides terms by a factor.  Sums of two terms are left: expr and lower
-- see what they have in common.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

-- The bases of positive integer powers in a term.
local function bases(term)
  local list = {}
  for _, f in ipairs(term.kind == "mul" and term or { term }) do
    if f.kind == "sym" then
      list[#list + 1] = f
    elseif f.kind == "pow" and f.base.kind == "sym" and R.isint(f.exp) and R.sign(f.exp) > 0 then
      list[#list + 1] = f.base
    end
  end
  return list
end

local function nest(e, last, memo)
  local known = memo[e]
  if known then return known end
  local out = expr.map(e, function(c) return nest(c, last, memo) end)
  if out.kind == "add" and #out > 2 then
    local count, order = {}, {}
    for _, t in ipairs(out) do
      for _, b in ipairs(bases(t)) do
        if not count[b] then order[#order + 1] = b end
        count[b] = (count[b] or 0) + 1
      end
    end
    local best
    for _, b in ipairs(order) do
      -- in two terms at least, and in more than the best so far; with `last` as many will do
      local n = best and count[best] + (last and 0 or 1) or 2
      if count[b] >= n then best = b end
    end
    if best then
      local with, rest = {}, {}
      for _, t in ipairs(out) do
        local has = false
        for _, b in ipairs(bases(t)) do has = has or b == best end
        if has then with[#with + 1] = t / best else rest[#rest + 1] = t end
      end
      out = expr.add { best * nest(expr.add(with), last, memo), nest(expr.add(rest), last, memo) }
    end
  end
  memo[e] = out
  return out
end

-- last: among factors that are equally common the last one is taken, not the first.
local nests = { [false] = setmetatable({}, { __mode = "k" }), [true] = setmetatable({}, { __mode = "k" }) }

return function(e, last) return nest(e, last or false, nests[last or false]) end
