-- order.lua -- the canonical order of expressions, and so of the terms and factors people read.
--
-- A total order on nodes that does not depend on when they were made, so the same input gives the same bytes:
-- constants first, then factor by factor, symbols by rank and name, higher powers first; the rational coefficient
-- decides last.  Terms that differ in their coefficient alone are neighbours in a sorted sum.  Names and ranks are
-- all that is looked at of a symbol: two of one name and rank differ in being positive.  A comparison visits both
-- expressions at most once, and most end at the first factor.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local order = {}

local kind_rank = { num = 1, sym = 2, call = 3, pow = 4, mul = 5, add = 6 }
local compare

-- Entry by entry; where one list begins the other, the shorter comes first.
local function compare_lists(a, b)
  for i = 1, math.min(#a, #b) do
    local c = compare(a[i], b[i])
    if c ~= 0 then return c end
  end
  return #a - #b
end

-- Bases of powers: numbers, symbols, calls, and then what is in parentheses.
local function compare_base(a, b)
  if a == b then return 0 end
  if a.kind ~= b.kind then return kind_rank[a.kind] - kind_rank[b.kind] end
  if a.kind == "num" then return a.value < b.value and -1 or 1 end
  if a.kind == "sym" then
    if a.rank ~= b.rank then return a.rank < b.rank and -1 or 1 end
    if a.name ~= b.name then return a.name < b.name and -1 or 1 end
    return a.positive and -1 or 1
  end
  if a.kind == "call" and a.fn ~= b.fn then return a.fn < b.fn and -1 or 1 end
  return compare_lists(a, b)
end

-- e = base^exponent
local function factor(e)
  if e.kind == "pow" then return e.base, e.exp end
  return e, R.one
end

-- A total order that reads well: constants first, then by factors, higher powers first; the rational
-- coefficient decides last.  Independent of creation order, so the same input gives the same bytes.
function compare(a, b)
  if a == b then return 0 end
  local fa, fb = a.kind == "mul" and a or { a }, b.kind == "mul" and b or { b }
  local i, j = 1, 1
  if fa[1].kind == "num" then i = 2 end
  if fb[1].kind == "num" then j = 2 end
  while fa[i] and fb[j] do
    local xa, ea = factor(fa[i])
    local xb, eb = factor(fb[j])
    local c = compare_base(xa, xb)
    if c ~= 0 then return c end
    if ea ~= eb then return ea < eb and 1 or -1 end
    i, j = i + 1, j + 1
  end
  if fa[i] or fb[j] then return fa[i] and 1 or -1 end
  local ca = fa[1].kind == "num" and fa[1].value or R.one
  local cb = fb[1].kind == "num" and fb[1].value or R.one
  if ca == cb then return 0 end
  return ca < cb and -1 or 1
end

order.compare, order.factor = compare, factor

return order
