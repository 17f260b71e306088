-- critical.lua -- what decides the sign of an expression of parameters, as few small polynomials as possible.
--
-- An expression is cancelled and factored; factors that the scene's own conditions keep positive (masses, sizes, sums
-- of positive terms, r_out - r_in) are dropped.  What is left are the ATOMS: primitive polynomials whose signs multiply
-- to the sign of the expression:  M (3 r^2 - h^2)/12  has the one atom  3 r^2 - h^2,  M (b - a) (b + a)/12  has b - a.
-- A condition  atom > 0  is written as a person would: solved for one parameter where that is a linear or purely
-- quadratic equation (h < sqrt(3) r), else with every term on the side where it is positive (b^2 + c^2 > 3 a^2).
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local poly = require "generator.algebra.poly"
local radical = require "generator.algebra.radical"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"

local critical = {}

local affordable = 4000 -- products of terms: what is longer decides nothing that a person could read
critical.__index = critical

-- Is e > 0 (strict) or >= 0 (not strict) for all values of its symbols, positive ones positive?
-- By form: a product of positive factors, a sum without a negative term and with a positive one.  False is no proof.
local function surely(e, strict)
  if e.kind == "num" then return R.sign(e.value) > (strict and 0 or -1) end
  if e.kind == "sym" then return e.positive end
  if e.kind == "pow" then
    if surely(e.base, true) then return true end
    return not strict and expr.nonnegative(e)
  end
  if e.kind == "mul" then
    for i = 1, #e do
      if not surely(e[i], strict) then return false end
    end
    return true
  end
  if e.kind == "add" then
    local some = not strict
    for i = 1, #e do
      if not surely(e[i], false) then return false end
      some = some or surely(e[i], true)
    end
    return some
  end
  if e.fn == "exp" or e.fn == "cosh" or e.fn == "pi" then return true end
  return not strict and expr.nonnegative(e)
end

-- The factors of e: coefficient, and a list of {base, exponent}.
local function factors(e)
  local c, rest = expr.split(e)
  local list = {}
  for _, f in ipairs(rest == expr.one and {} or rest.kind == "mul" and rest or { rest }) do
    if f.kind == "pow" then list[#list + 1] = { f.base, f.exp } else list[#list + 1] = { f, R.one } end
  end
  return c, list
end

-- What the conditions of the model (expressions that are positive for every set of parameters that NAME_init accepts)
-- say: symbols that are positive, sums of known sign, and products of such as have one together.
-- An object with :signs(e) and :positive(e).
function critical.of(conditions)
  local self = setmetatable({ map = {}, known = {}, products = {} }, critical)
  local simple = {} -- not pivots of a tensor and places of holes: large, and the sign of no factor follows from them
  for _, c in ipairs(conditions) do
    if not c.opaque then simple[#simple + 1] = c end
  end
  for _, c in ipairs(simple) do
    local coefficient, list = factors((ratio.tidy(c.e)))
    if not c.allow_zero and R.sign(coefficient) > 0 and #list == 1 and list[1][1].kind == "sym" then
      local s = list[1][1]
      self.map[s] = expr.sym(s.name, s.rank, true)
    end
  end
  for _, c in ipairs(simple) do
    local coefficient, list = factors(self:plain(c.e))
    local left = {}
    for _, f in ipairs(list) do
      if not surely(f[1], true) then left[#left + 1] = f end
    end
    local odd, whole = {}, not c.allow_zero
    for _, f in ipairs(left) do
      whole = whole and R.isint(f[2])
      if whole and R.toint(f[2]) % 2 == 1 then odd[#odd + 1] = f[1] end
    end
    if whole and #odd == 1 then
      self.known[odd[1]] = R.sign(coefficient)
    elseif whole and #odd > 1 then
      self.products[#self.products + 1] = { sign = R.sign(coefficient), atoms = odd }
    end
  end
  return self
end

-- e factored, with the positive symbols marked as such.
function critical:plain(e)
  return (ratio.tidy(calculus.substitute(e, self.map), affordable))
end

-- p/q where that is a polynomial again.
local function quotient(p, q) return (ratio.tidy(p / q)) end

-- x^2n - y^2m with square coefficients: (x^n - y^m)(x^n + y^m).
-- 4 a^2 - b^2 ==> (2 a - b) (2 a + b); a coefficient whose root is irrational: nil.
local function split_squares(e)
  if #e ~= 2 then return nil end
  local root = {}
  for i = 1, 2 do
    local c, list = factors(e[i])
    root[i] = expr.num(R.abs(c)) ^ R.half
    if root[i].kind ~= "num" or (i == 2) ~= (R.sign(c) < 0) then return nil end
    for _, f in ipairs(list) do
      if not R.isint(f[2] / R.new(2)) then return nil end
      root[i] = root[i] * f[1] ^ (f[2] / R.new(2))
    end
  end
  return { root[1] - root[2], root[1] + root[2] }
end

-- 1 - sin(a)^2: cos(a), twice; else nil.
local function cosine(e)
  if #e ~= 2 or e[1] ~= expr.one then return nil end
  for _, s in ipairs(e[2].kind == "mul" and e[2] or {}) do
    local sine = s.kind == "pow" and s.base
    if sine and sine.kind == "call" and sine.fn == "sin" and e[2] == -(sine ^ 2) then
      local c = expr.call("cos", sine[1])
      return { c, c }
    end
  end
  return nil
end

-- x^2n - 2 x^n y^m + y^2m, or with a plus: the root x^n -+ y^m; else nil.
-- a^2 - 2 a b + b^2 ==> a - b
local function square_root(e)
  if #e ~= 3 then return nil end
  for middle = 1, 3 do
    local i, j = middle % 3 + 1, (middle + 1) % 3 + 1
    for _, s in ipairs { -1, 1 } do
      if R.sign((expr.split(e[i]))) > 0 and R.sign((expr.split(e[j]))) > 0 then
        local root = expr.sqrt(e[i]) + s * expr.sqrt(e[j])
        if ratio.iszero(root ^ 2 - e) then return root end
      end
    end
  end
  return nil
end

-- A factor of the sum e that does not contain all of e's symbols: the common divisor of e's coefficients as a
-- polynomial in one of them.
-- Returns it and the rest.  a b + a c ==> a, b + c, where expr has left the sum as it is.
local function content(e)
  local ring, p = poly.modest(e)
  if not p or p.n > 200 then return nil end
  for v = 1, #ring.gens do
    local by = {}
    local degrees = {}
    for _, t in ipairs(poly.sorted(p)) do
      local list = { expr.lift(t.c) }
      for i, x in ipairs(t.e) do
        if x ~= 0 and i ~= v then list[#list + 1] = expr.pow(ring.gens[i], x) end
      end
      local d = t.e[v]
      if not by[d] then
        by[d], degrees[#degrees + 1] = expr.zero, d
      end
      by[d] = by[d] + expr.mul(list)
    end
    local g = by[degrees[1]]
    for i = 2, #degrees do -- gcd(g, b) is what cancels from g/b
      local q = quotient(g, by[degrees[i]])
      local _, list = factors(q)
      local numerator = { (expr.split(q)) }
      for _, f in ipairs(list) do
        if R.sign(f[2]) > 0 then numerator[#numerator + 1] = expr.pow(f[1], f[2]) end
      end
      g = quotient(g, expr.mul(numerator))
    end
    if #degrees > 1 and not expr.constant(g) then return g, quotient(e, g) end
  end
  return nil
end

-- The sign of e as constant * product of the signs of atoms: returns the constant (-1, 0, 1) and the list of atoms.
-- An even power counts twice: its base may be zero, which a sign of 0 must tell.
function critical:signs(e)
  e = self:plain(e)
  if e == expr.zero then return 0, {} end
  local sign, atoms = 1, {}
  local function put(f)
    if surely(f, true) then return end -- decides nothing
    if f.kind == "num" then
      sign = sign * R.sign(f.value)
    elseif f.kind == "mul" or f.kind == "pow" then
      local c, list = factors(f)
      sign = sign * R.sign(c)
      for _, x in ipairs(list) do
        local times = R.isint(x[2]) and R.toint(x[2]) % 2 == 0 and 2 or 1
        for _ = 1, surely(x[1], true) and 0 or times do put(x[1]) end
      end
    elseif self.known[f] then
      sign = sign * self.known[f]
    elseif f.kind == "call" and f.fn == "abs" then
      put(f[1] ^ 2)
    elseif expr.constant(f) then
      sign = sign * R.sign(evaluate.precise(f, {}, 240))
    else
      local pair = f.kind == "add" and (cosine(f) or split_squares(f))
      local root = f.kind == "add" and square_root(f)
      local g, rest
      if root then pair = { root, root } end
      if f.kind == "add" and not pair then g, rest = content(f) end
      if pair then
        put(pair[1])
        put(pair[2])
      elseif g then
        put(g)
        put(rest)
      else
        atoms[#atoms + 1] = f
      end
    end
  end
  put(e)
  return sign * self:reduced(atoms), atoms
end

-- Takes out of the list the atoms whose product has a known sign; returns the sign of what was taken.
-- With a b > 0 known: a, b, a - b ==> a - b.
function critical:reduced(atoms)
  local sign = 1
  for _, p in ipairs(self.products) do
    local at, all = {}, true
    for _, wanted in ipairs(p.atoms) do
      local found
      for i, a in ipairs(atoms) do
        if a == wanted and not at[i] then found = i end
      end
      all = all and found ~= nil
      if found then at[found] = true end
    end
    if all then
      sign = sign * p.sign
      for i = #atoms, 1, -1 do
        if at[i] then table.remove(atoms, i) end
      end
    end
  end
  return sign
end

-- Is e positive whatever the parameters?
function critical:positive(e) return surely(self:plain(e), true) end

---- conditions as text ------------------------------------------------------------------------------

local longest = 44 -- characters of a right side that is worth solving for

local flip = { [">"] = "<", ["<"] = ">", ["≠"] = "≠", ["="] = "=" }

-- The square root of q as text: what is a square stands before the root, the rest and sums under one root.
-- 12 r^2/5 ==> √(3/5) 2 r
local function root_text(q, style)
  local c, list = factors(q)
  local function opened(n)
    local whole, roots = radical.open(n, R.half)
    local rest = R.one
    for _, r in ipairs(roots) do rest = rest * r[1] end
    return whole, rest
  end
  local above, n = opened(R.num(c))
  local below, d = opened(R.den(c))
  local outside, inside = { expr.num(above / below) }, { expr.num(n / d) }
  for _, f in ipairs(list) do
    local half = f[1].kind == "add" and R.zero or R.floor(R.abs(f[2]) / R.new(2)) * R.new(R.sign(f[2]))
    outside[#outside + 1] = expr.pow(f[1], half)
    inside[#inside + 1] = expr.pow(f[1], f[2] - R.new(2) * half)
  end
  outside, inside = expr.mul(outside), expr.mul(inside)
  if inside == expr.one then return text.of(outside, style) end
  local under = text.of(inside, style)
  local root = style == "plain" and "sqrt(" .. under .. ")" or
    string.find(under, "^%w+$") and "√" .. under or "√(" .. under .. ")"
  if outside == expr.one then return root end
  local before = text.of(outside, style)
  if string.sub(before, 1, 2) == "1/" then return root .. string.sub(before, 2) end
  return root .. (style == "plain" and "*" or " ") .. before
end

-- e = a v^n + b with a, b free of the symbol v and n 1 or 2: a, b, n; nil otherwise.
-- Any higher power of v: nil.
local function binomial(e, v)
  local b = calculus.substitute(e, { [v] = expr.zero })
  local slope = calculus.diff(e, v)
  local n = 1
  if not expr.constant(slope, { [v.name] = true }) then
    n = 2
    slope = ratio.tidy(slope / (2 * v))
    if not expr.constant(slope, { [v.name] = true }) then return nil end
  end
  return slope, b, n
end

-- Solutions of  e rel 0  for a parameter: a list of {v, relation, right side, squared = is v^2 compared with it?}.
-- Dividing by a turns the relation round where a < 0; where the sign of a is not known v is no solution.
function critical:solutions(e, relation)
  local list = {}
  local ring = poly.modest(e)
  if not ring then return list end
  for _, v in ipairs(expr.symbols(e)) do
    local inside = false -- of a function: no polynomial in v
    for _, g in ipairs(ring.gens) do inside = inside or g ~= v and not expr.constant(g, { [v.name] = true }) end
    local a, b, n
    if not inside then a, b, n = binomial(e, v) end
    if a then
      local up, down = surely(a, true), surely(-a, true)
      local squared = n == 2
      local solvable = not squared or v.positive and (up and surely(-b, true) or down and surely(b, true))
      if (up or down) and solvable then
        list[#list + 1] = { v = v, relation = up and relation or flip[relation], right = self:plain(-b / a),
          squared = squared }
      end
    end
  end
  return list
end

-- The root of a positive expression, as text.
function critical:root(e, style) return root_text(self:plain(e), style or "unicode") end

local words = { plain = { ["≠"] = "!=" }, unicode = {} }

local function right_text(s, style) return s.squared and root_text(s.right, style) or text.of(s.right, style) end

-- e rel 0 as people write it; relation: ">", "<" or "≠" (not equal); style as in text.of; prefer: the parameter to
-- solve for, if that can be done.
function critical:condition(e, relation, style, prefer)
  style = style or "unicode"
  local best, least
  for _, s in ipairs(self:solutions(e, relation)) do
    local right = right_text(s, "unicode")
    local size = #s.v.name + utf8.len(right) + (string.find(right, "/", 1, true) and 2 or 0)
    if size <= longest and s.v == prefer then size = 0 end
    if size <= longest and (not least or size < least) then best, least = s, size end
  end
  relation = best and best.relation or relation
  local left, right
  if best then
    left, right = text.of(best.v, style), right_text(best, style)
  else
    local sides = { {}, {} }
    for _, t in ipairs(e.kind == "add" and e or { e }) do
      local side = R.sign((expr.split(t))) > 0 and 1 or 2
      table.insert(sides[side], side == 1 and t or -t)
    end
    if #sides[1] == 0 then
      sides[1], sides[2], relation = sides[2], sides[1], flip[relation]
    end
    left, right = text.of(expr.add(sides[1]), style), text.of(expr.add(sides[2]), style)
  end
  return left .. " " .. (words[style][relation] or relation) .. " " .. right
end

return critical
