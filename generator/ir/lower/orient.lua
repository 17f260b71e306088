-- orient.lua: settles where signs and coefficients of a sum are written.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line.  A form is shared up to a factor, so 2*(b - a) is stored as -2 times a - b.  Once
-- all uses are known the factor goes where it costs least:
--   a sum that is only subtracted turns round         -(a - b)           ==> b - a
--   so does a factor of a product that is             -(a - b)*c/d       ==> (b - a)*c/d
--   a factor moves in if that saves a multiplication  (1/6)*(3*a + 2*b)  ==> 0.5*a + (1/3)*b
-- A named intermediate is never written as a negative, its other users give way.
-- Forms are changed in place: hash-consing is over at this point.
--
-- Laws: -(x - y) = y - x and -(x y) = (-x) y, and m (a x + b y) = (m a) x + (m b) y.  The first two change no bit below
-- the line either (but for the sign of a zero); the last does, so it is done here.
-- Users come before operands in the walk: a form's coefficient is settled by those who use it before it is handed on to
-- what is inside.  A sum turns round only if one of its terms is negative, which then leads; a factor moves in only if
-- that is one multiplication less.

local R = require "generator.algebra.rational"

local orient = {}

-- The forms below `roots` (terms), each once, operands before users; and how each is referred to:
-- refs[f] lists the terms that hold f, solid[f] counts its uses without a coefficient.  inside, if
-- given, maps leaves to the forms behind them, which are then visited too.
function orient.survey(roots, inside)
  local list, refs, solid, seen = {}, {}, {}, {}
  local visit

  local function refer(t)
    local f = t.f
    local holders = refs[f]
    if holders then
      holders[#holders + 1] = t
    else
      refs[f] = { t }
    end
    if not seen[f] then visit(f) end
  end

  local function use(f)
    solid[f] = (solid[f] or 0) + 1
    if not seen[f] then visit(f) end
  end

  local below = {
    one = function() end,
    leaf = function(f) if inside and inside[f] and not seen[inside[f]] then visit(inside[f]) end end,
    sum = function(f)
      for k = 1, #f.terms do refer(f.terms[k]) end
    end,
    call = function(f) for _, t in ipairs(f.args) do refer(t) end end,
    scale = function(f) for _, t in ipairs(f.args) do refer(t) end end,
    powi = function(f) use(f.base) end,
    prod = function(f)
      local num, den = f.num, f.den
      for k = 1, #num do use(num[k]) end
      for k = 1, #den do use(den[k]) end
    end,
  }

  function visit(f)
    seen[f] = true
    below[f.kind](f)
    list[#list + 1] = f
  end

  for _, t in ipairs(roots) do refer(t) end
  return { list = list, refs = refs, solid = solid }
end

-- Is the negative of the form what its users want?  A named intermediate has the say, then the majority
-- that is all of them.
local function wanted_negative(terms)
  local positive = false
  for _, t in ipairs(terms) do
    if t.named then return R.sign(t.c) < 0 end
    positive = positive or R.sign(t.c) > 0
  end
  return not positive
end

local function negate(terms)
  for _, t in ipairs(terms) do t.c = -t.c end
end

-- Can the sum turn round without beginning with a minus?
local function turns(f)
  if f.kind ~= "sum" then return false end
  for _, t in ipairs(f.terms) do
    if R.sign(t.c) < 0 then return true end
  end
  return false
end

-- How many multiplications m times the sum costs if the factor is written inside.
local function multiplications(f, m)
  local n = 0
  for _, t in ipairs(f.terms) do
    local c = R.abs(t.c * m)
    if c ~= R.one and t.f.kind ~= "one" then n = n + 1 end
  end
  return n
end

-- The factor m > 0 with which all users multiply f, or nil.
local function common_size(terms)
  local m = R.abs(terms[1].c)
  local minus = -m
  for _, t in ipairs(terms) do
    if t.c ~= m and t.c ~= minus then return nil end
  end
  return m
end

-- Returns the survey, which stays true: only coefficients have changed.
function orient.run(roots)
  local survey = orient.survey(roots)
  local refs, solid = survey.refs, survey.solid
  for k = #survey.list, 1, -1 do -- users before operands
    local f = survey.list[k]
    local terms = refs[f]
    if terms and not solid[f] then
      if wanted_negative(terms) then
        local sum = turns(f) and f
        local factors = f.kind == "prod" and f.num or {}
        for j = 1, #factors do
          local x = factors[j]
          if not sum and turns(x) and solid[x] == 1 and not refs[x] then sum = x end
        end
        if sum then
          negate(sum.terms)
          negate(terms)
        end
      end
      local m = f.kind == "sum" and common_size(terms)
      if m and m ~= R.one and multiplications(f, m) < 1 + multiplications(f, R.one) then
        local units = 0
        for _, t in ipairs(f.terms) do
          if R.abs(t.c) == R.one then units = units + 1 end
        end
        if units < 2 then
          for _, t in ipairs(f.terms) do t.c = t.c * m end
          for _, t in ipairs(terms) do t.c = t.c / m end
        end
      end
    end
  end
  return survey
end

return orient
