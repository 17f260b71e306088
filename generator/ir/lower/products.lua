-- products.lua: products, powers and roots among the forms of form.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line.  A product under construction is a coefficient and a map from bases to exponents, so that equal bases
-- meet whatever they come in: x^2 * (x*y)^-1 ==> x/y.  The laws, all for bases that are not zero:
--     f^a f^b       ==> f^(a + b)                 products, powers and roots are opened first
--     (c f)^n       ==> c^n f^n                   n an integer: the coefficient is exact
--     (c f)^(p/q)   ==> root_q(c)^p f^(p/q)       where the root is rational: sqrt(4*x) ==> 2*sqrt(x)
--     f^e           ==> f^floor(e) f^(e - floor(e)), and the rest 0 < r < 1 as roots:
--                       x^(1/2) = sqrt x,  x^(1/4) = sqrt sqrt x,  x^(3/4) = sqrt x * sqrt sqrt x,
--                       x^(k/3) = (cbrt x)^k, anything else pow(x, r)
-- The floor is taken of |e| and the side given back, so x^(-3/2) is 1/(x sqrt x): no power is split into a product with
-- a quotient.  Even roots are of bases that are not negative (the scene's sqrt has said so); then each law is an
-- identity, and none of them adds a root that was not there.
-- Factors keep the order in which their bases were met.

local R = require "generator.algebra.rational"

local products = {}

local ONE, HALF = R.one, R.half

-- Bits of a constant that is no rational (pi, sqrt 2).  A product of two of them is within 2^-255 of its size, and
-- rounds to 53 bits as the true product does unless that lies so near the middle of two neighbours, 2^-53 apart: for
-- digits as good as random that is one case in 2^200.
products.BITS = 256

local function abs(c) return R.sign(c) < 0 and -c or c end

-- e as a Lua integer where it is one.
local function plain(e)
  if math.type(e) == "integer" or not R.isint(e) then return e end
  return R.toint(e) or error("lower: exponent " .. tostring(e) .. " is too large")
end

-- A product under construction: coefficient c, integer exponents e of the forms in list, fractional exponents of those
-- in roots.  e[f] may become 0: then f is left out at the end, but keeps its place if it comes back.
local function begin() return { c = ONE, list = {}, e = {}, roots = {}, frac = {} } end

-- P times base^e, e no integer.
local function gather_root(P, base, e)
  if not P.frac[base] then P.roots[#P.roots + 1] = base end
  P.frac[base] = (P.frac[base] or R.zero) + e
end

-- P times f^n, n an integer; products, powers and roots are opened.
local function gather(B, P, f, n)
  if f == B.one then return end
  if f.kind == "prod" then
    for _, x in ipairs(f.num) do gather(B, P, x, n) end
    for _, x in ipairs(f.den) do gather(B, P, x, -n) end
  elseif f.kind == "powi" then
    gather(B, P, f.base, n * f.n)
  elseif f.kind == "scale" then
    P.c = P.c * f.args[1].c ^ n
    gather(B, P, f.args[1].f, n)
  elseif f.root then
    gather_root(P, f.root, f.exp * n)
  else
    if not P.e[f] then P.list[#P.list + 1] = f end
    P.e[f] = (P.e[f] or 0) + n
  end
end

-- P times t^e
local function multiply(B, P, t, e)
  local c = t.c
  if math.type(e) == "integer" then
    if c ~= ONE then P.c = P.c * (e == 1 and c or c ^ e) end
    return gather(B, P, t.f, e)
  end
  if t.f == B.one then
    if R.sign(c) < 0 then error("lower: fractional power of the negative number " .. tostring(c)) end
    P.c = P.c * (e == HALF and R.apply("sqrt", products.BITS, c) or R.apply("pow", products.BITS, c, e))
    return
  end
  local base = t.f
  if c ~= ONE then -- sqrt(4*x) ==> 2*sqrt(x); sqrt(2*x) keeps its exact 2
    local q = R.toint(R.den(e))
    local root = R.sign(c) > 0 and q and q < 64 and R.root(c, q)
    if root then
      P.c = P.c * root ^ R.toint(R.num(e))
    else
      base = B:scale(t)
    end
  end
  gather_root(P, base, e)
end

-- A root as a call that knows of what it is which power, so that gather() can open it.
local function root_form(B, op, base, exp)
  local f = B:call(op, { { c = ONE, f = base } })
  f.root, f.exp = base, exp
  return f
end

-- base^e for 0 < e < 1 as factors { form, power }, or nil if it takes pow().
local function radicals(B, base, e)
  local p, q = R.toint(R.num(e)), R.toint(R.den(e))
  if q == 3 then return { { root_form(B, "cbrt", base, R.new(1, 3)), p } } end
  if q ~= 2 and q ~= 4 then return nil end
  local sqrt = root_form(B, "sqrt", base, HALF)
  if q == 2 then return { { sqrt, 1 } } end
  local fourth = { B:call("sqrt", { { c = ONE, f = sqrt } }), 1 }
  if p == 1 then return { fourth } end
  return { { sqrt, 1 }, fourth }
end

-- Fractional exponents of P: the whole part joins the integer ones, the rest becomes roots, as { form, power }.
local function extract_roots(B, P)
  local atoms = {}
  for _, base in ipairs(P.roots) do
    local e = P.frac[base] + (P.e[base] or 0)
    P.e[base] = P.e[base] and 0
    local size, side = abs(e), R.sign(e)
    local whole = R.toint(R.num(size)) // R.toint(R.den(size))
    local factors = not R.isint(e) and radicals(B, base, size - whole)
    if R.isint(e) or factors then
      if whole > 0 then gather(B, P, base, side * whole) end
      for _, x in ipairs(factors or {}) do atoms[#atoms + 1] = { x[1], side * x[2] } end
    else
      atoms[#atoms + 1] = { B:call("pow", { { c = ONE, f = base }, B.number(e) }), 1 }
    end
  end
  return atoms
end

-- The term of P: what has a positive exponent above the line of the quotient, the rest below it.
-- 0 times anything is 0; one factor without a denominator is itself, no product.
local function finish(B, P)
  if R.sign(P.c) == 0 then return B.number(R.zero) end
  local atoms = #P.roots > 0 and extract_roots(B, P) or P.roots
  local num, den = {}, {}
  local function place(f, n)
    if n > 0 then
      num[#num + 1] = B:power(f, n)
    elseif n < 0 then
      den[#den + 1] = B:power(f, -n)
    end
  end
  for _, f in ipairs(P.list) do place(f, P.e[f]) end
  for _, atom in ipairs(atoms) do place(atom[1], atom[2]) end
  if #den == 0 and #num <= 1 then return { c = P.c, f = num[1] or B.one } end
  return { c = P.c, f = B:quotient(num, den) }
end

-- Forms that gather() takes as they are.
local simple = { leaf = true, sum = true }

-- The common case, distinct simple forms to the power one, without the machinery; nil if it is not.  It gives what the
-- machinery would: the same order, the same key.
local function plain_product(B, list)
  local c, num = ONE, {}
  for k = 1, #list do
    local x = list[k]
    local t, f = x[1], x[1].f
    if x[2] ~= 1 or not (simple[f.kind] or f == B.one) then return nil end
    if t.c ~= ONE then c = c * t.c end
    if f ~= B.one then
      for j = 1, #num do
        if num[j] == f then return nil end
      end
      num[#num + 1] = f
    end
  end
  if #num < 2 or R.sign(c) == 0 then return nil end
  return { c = c, f = B:quotient(num, {}) }
end

-- The product of { term, exponent } pairs, exponents Lua integers or rationals.
function products.product(B, list)
  local known = plain_product(B, list)
  if known then return known end
  local P = begin()
  for _, x in ipairs(list) do multiply(B, P, x[1], plain(x[2])) end
  return finish(B, P)
end

-- The factors of a form: list of bases in order, e: base -> integer exponent, roots: what has another.
function products.factors(B, f)
  local P = begin()
  gather(B, P, f, 1)
  return P
end

return products
