-- size.lua: sums whose coefficients are long whole numbers get back the size that their decimals had.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line.  Algebra over rationals clears denominators: 1.123456789 - 0.246913578*x is 1123456789 - 246913578*x
-- with 1e-9 outside, and the fifth power of it has 1e-45 outside, which float does not hold.  Here the scale goes back
-- into the sum, exactly, so that each number that is printed is of the size of what it stands for, and no product holds
-- a scale that another factor takes away again.
--
-- Laws: c (s f) = (c s) f;  (s f)^n = s^n f^n;  likewise for products and quotients;  root_q(s^q f) = s root_q(f).
-- The scale of a form is what its users are multiplied by: that of a sum is chosen, that of a product is the product
-- of its factors', that of a root the power of ten that leaves fewer than LONG digits below it; other calls, and sums,
-- take it into the coefficients of what they hold.
--
-- Which sums: with e the exponent of ten of the largest coefficient, those with |e| >= LONG where
--     the numbers outside come nearer to 1, over all users together (what else is scaled counted in);
--     or the whole numbers are not exact in float (EXACT digits);
--     or factors of one product together are beyond what float should spend on scales (SPENT digits).
-- The scale is 1/m where all users multiply by m, so that this multiplication is saved; else a power of ten, a common
-- one for sizes that differ by up to NEAR digits, so that components of a vector do not part.  A sum with a term
-- without a coefficient stays as it is for the sake of the numbers outside alone: the term would get one.  Where it
-- must be scaled, the largest coefficient goes instead.
-- Forms are changed in place: hash-consing is over at this point.  The work is three walks over the forms.

local R = require "generator.algebra.rational"
local orient = require "generator.ir.lower.orient"

local size = {}

local ONE, TEN = R.one, R.new(10)
local LONG, EXACT, SPENT, NEAR = R.LONG, 7, 18, 3
local decade = R.decade
local DEGREE = { sqrt = 2, cbrt = 3 }

-- What a root is of, c f with a coefficient that may stand in a form of its own: c, f; the degree, nil of other calls.
local function below_root(f)
  local t = f.args[1]
  local c, inside = t.c, t.f
  if inside.kind == "scale" then c, inside = c * inside.args[1].c, inside.args[1].f end
  return c, inside, DEGREE[f.op]
end

-- ---- what is long -------------------------------------------------------------------------------------------------

-- Exponents of ten that each form would lose if all that is long were scaled: form -> integer; the sums' own ones, and
-- of a product those above and below its line.
local function exponents(list)
  local of, above, below = {}, {}, {}
  local rules = {
    sum = function(f)
      local most = math.mininteger
      for _, t in ipairs(f.terms) do most = math.max(most, decade(t.c) + of[t.f]) end
      return math.abs(most) >= LONG and most or 0
    end,
    powi = function(f) return f.n * of[f.base] end,
    prod = function(f)
      local up, down = 0, 0
      for _, x in ipairs(f.num) do up = up + of[x] end
      for _, x in ipairs(f.den) do down = down + of[x] end
      above[f], below[f] = up, down
      return up - down
    end,
    call = function(f)
      local c, inside, degree = below_root(f)
      local e = degree and decade(c) + of[inside] or 0
      return math.abs(e) >= LONG and e // degree or 0
    end,
  }
  for _, f in ipairs(list) do
    local rule = rules[f.kind]
    of[f] = rule and rule(f) or 0
  end
  return of, above, below
end

-- ---- what is scaled -----------------------------------------------------------------------------------------------

-- Is |m| what every user multiplies by?  known: nil for no user yet, false for different ones.
local function agreed(known, m)
  if known == nil then return m end
  return known == m and m
end

-- The sums to be scaled: form -> { m = that of all users, or false where they differ, must = not only for what is
-- outside }.  Users before operands.
local function chosen(survey)
  local of, above, below = exponents(survey.list)
  local gain, spent, outside, holder, scaled, rooted = {}, {}, {}, {}, {}, {}

  local function hand_down(f, x, m)
    gain[x] = (gain[x] or 0) + gain[f]
    spent[x] = spent[x] or spent[f]
    outside[x] = agreed(outside[x], m)
  end
  local rules = {
    sum = function(f)
      local e = math.abs(of[f])
      local must = e >= EXACT or spent[f] or false
      if e >= LONG and (must or gain[f] > 0) then scaled[f] = { m = outside[f], must = must } end
      for _, t in ipairs(f.terms) do holder[t] = f end
    end,
    powi = function(f)
      spent[f] = spent[f] or math.abs(of[f]) > SPENT
      hand_down(f, f.base, false)
    end,
    prod = function(f)
      spent[f] = spent[f] or math.abs(above[f]) > SPENT or math.abs(below[f]) > SPENT
      for _, x in ipairs(f.num) do hand_down(f, x, of[f] == of[x] and outside[f]) end
      for _, x in ipairs(f.den) do hand_down(f, x, false) end
    end,
    call = function(f)
      local _, inside, degree = below_root(f)
      if not degree then return end
      local own = f.args[1]
      rooted[own] = true
      if own.f.kind == "scale" then rooted[own.f.args[1]] = true end
      hand_down(f, inside, false)
    end,
  }
  for k = #survey.list, 1, -1 do
    local f = survey.list[k]
    gain[f] = gain[f] or 0
    for _, t in ipairs(survey.refs[f] or {}) do
      local g = holder[t]
      local inner = scaled[g]
      local e = decade(t.c) - (inner and of[g] or 0)
      if not rooted[t] then -- else the scale goes through the root
        gain[f] = gain[f] + math.abs(e) - math.abs(e + of[f])
        outside[f] = agreed(outside[f], not inner and R.abs(t.c))
      end
    end
    local rule = rules[f.kind]
    if rule then rule(f) end
  end
  return scaled, of
end

-- The exponents of the sums that are scaled, each with that of the power that is used: of those that lie together, up
-- to NEAR apart, the middle.
local function powers(list, scaled, of)
  local all, power, first = {}, {}, 1
  for _, f in ipairs(list) do
    if scaled[f] then all[#all + 1] = of[f] end
  end
  table.sort(all)
  for k, e in ipairs(all) do
    if e - all[first] > NEAR then first = k end
    for j = first, k do power[all[j]] = (all[first] + e) // 2 end
  end
  return power
end

-- ---- scaling ------------------------------------------------------------------------------------------------------

-- Multiplications in the sum times m, if it is divided by s and its users by 1/s.
local function multiplications(f, s, m)
  local n = R.abs(m * s) == ONE and 0 or 1
  for _, t in ipairs(f.terms) do
    if t.f.kind ~= "one" and R.abs(t.c) ~= s then n = n + 1 end
  end
  return n
end

-- What the sum is divided by.  why: its entry of `chosen`, nil where it has none
local function scale_of(f, why, power)
  local most, bare, same = R.zero, false, R.abs(f.terms[1].c)
  for _, t in ipairs(f.terms) do
    local c = R.abs(t.c)
    if c > most then most = c end
    bare = bare or c == ONE and t.f.kind ~= "one"
    same = same == c and c
  end
  if same then return same end -- the scales of what is inside
  if not why then return ONE end
  local m = why.m
  if m and math.abs(decade(most * m)) <= LONG
    and multiplications(f, ONE / m, m) <= multiplications(f, ONE, m) then return ONE / m end
  if bare then return why.must and most or ONE end
  local e = decade(most)
  return TEN ^ (power[e] or e)
end

-- kind of a form -> its scale, from those of its parts; one, leaf and calls but roots have none
local scales = {
  sum = function(f, _, scaled, power)
    local s = scale_of(f, scaled[f], power)
    if s ~= ONE then
      for _, t in ipairs(f.terms) do t.c = t.c / s end
    end
    return s
  end,
  powi = function(f, of) return (of[f.base] or ONE) ^ f.n end,
  prod = function(f, of)
    local s = ONE
    for _, x in ipairs(f.num) do s = s * (of[x] or ONE) end
    for _, x in ipairs(f.den) do s = s / (of[x] or ONE) end
    return s
  end,
  call = function(f)
    local c, inside, degree = below_root(f)
    local e = degree and decade(c) or 0
    if math.abs(e) < LONG then return ONE end
    local s = TEN ^ (e // degree)
    f.args[1] = { c = c / s ^ degree, f = inside }
    return s
  end,
}

-- Rescales the sums below these terms.
function size.run(terms)
  local survey, of = orient.survey(terms), {}
  local scaled, exponent_of = chosen(survey)
  if next(scaled) == nil then return end
  local power = powers(survey.list, scaled, exponent_of)
  for _, f in ipairs(survey.list) do -- operands before users
    local rule = scales[f.kind]
    local s = rule and rule(f, of, scaled, power) or ONE
    if s ~= ONE then
      of[f] = s
      for _, t in ipairs(survey.refs[f] or {}) do t.c = t.c * s end
    end
  end
end

return size
