-- cosine.lua -- cosines brought back: A - A sin(a)^2 ==> A cos(a)^2.
--
-- ABOVE the line.  The normal form of polynomials (poly.lua) knows sin^2 + cos^2 = 1 and keeps the sine, so that a
-- turned moment A cos^2 + B sin^2 comes out of it as A - A sin^2 + B sin^2, which cancels where the cosine is small
-- and is longer to read.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

-- The squared sines among the factors of a term.
local function sines(term)
  local list = {}
  for _, f in ipairs(term.kind == "mul" and term or { term }) do
    local g = f.kind == "pow" and f.base
    if g and g.kind == "call" and g.fn == "sin" and f.exp >= R.new(2) then
      list[#list + 1] = g
    end
  end
  return list
end

local memo = setmetatable({}, { __mode = "k" })

-- A term t = -A sin(a)^2 looks for its partner A = -t/sin(a)^2 by identity, so A must stand in the sum as one term.  A
-- pair becomes one term in the place of t; false marks what is used up. Again until no pair is left, for A cos(a)^2 may
-- be the partner of another term.
local function restored(e)
  if memo[e] then return memo[e] end
  local out = expr.map(e, restored)
  if out.kind == "add" then
    local at, terms, changed = {}, {}, false
    for i, t in ipairs(out) do
      terms[i], at[t] = t, i
    end
    for i, t in ipairs(out) do
      for _, g in ipairs(terms[i] == t and sines(t) or {}) do -- else it has become another in its pair
        local whole = -(t / g ^ 2)
        local k = at[whole]
        if terms[i] and k and terms[k] == whole then
          terms[i], terms[k], changed = false, whole * expr.call("cos", g[1]) ^ 2, true
          at[whole] = nil
        end
      end
    end
    if changed then
      local kept = {}
      for i = 1, #terms do
        if terms[i] then kept[#kept + 1] = terms[i] end
      end
      out = restored(expr.add(kept))
    end
  end
  memo[e] = out
  return out
end

return restored
