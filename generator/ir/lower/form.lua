-- form.lua: sums and products as lower wants them, hash-consed; the last algebra before the line.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line: real algebra with exact rationals, denominators taken as non-zero.
-- A TERM is { c, f }: the rational c times the form f.  The forms:
--     one                        the number 1: a term of it is a constant
--     leaf   name                an input or a named intermediate
--     sum    terms               sum of terms; the first coefficient is positive
--     prod   num, den            product of num over product of den; no coefficient, no nesting
--     powi   base, n             n >= 2
--     call   op, args            an instruction of the table; args are terms
--     scale  args                c * f as one factor, where a root must see both
-- Equal forms are one table, and so are equal up to a factor: b - a is -1 times a - b.  Forms differ
-- from expr nodes in that they are a plan of evaluation: quotients are explicit, roots are named.
-- Here are products, powers and roots.  Not here: sums (sums), sharing of parts of sums and products
-- (share), which sign is printed (orient).

local R = require "generator.algebra.rational"
local sums = require "generator.ir.lower.sums"

local form = {}

local ONE, MINUS = R.one, -R.one
local HALF = R.half

-- Bits of a constant that is no rational (pi, sqrt 2): two such factors still leave the product
-- correctly rounded to 53 bits but for one case in 2^190.
form.BITS = 256

local function abs(c) return R.sign(c) < 0 and -c or c end

local function text(c)
  if c == ONE then return "" elseif c == MINUS then return "-" end
  return tostring(c) .. "*"
end

-- e as a Lua integer where it is one.
local function plain(e)
  if math.type(e) == "integer" or not R.isint(e) then return e end
  return R.toint(e) or error("lower: exponent " .. tostring(e) .. " is too large")
end

-- A builder makes the forms of one program; ids count up in order of creation.
function form.builder()
  local B = { count = 0 }
  local unique = {}

  local function intern(key, f)
    B.count = B.count + 1
    f.id = B.count
    unique[key] = f
    return f
  end

  local function kept(key, kind)
    local f = unique[key]
    if f then return f end
    return intern(key, { kind = kind })
  end

  local one = kept("1", "one")
  B.one = one

  function B.number(c) return { c = c, f = one } end

  function B.leaf(name)
    local f = kept("s" .. name, "leaf")
    f.name = name
    return f
  end

  local function with_args(kind, op, args)
    local key = { kind, op }
    for k, t in ipairs(args) do key[k + 2] = text(t.c) .. t.f.id end
    key = table.concat(key, " ")
    if unique[key] then return unique[key] end
    local own = {}
    for k, t in ipairs(args) do own[k] = { c = t.c, f = t.f } end
    return intern(key, { kind = kind, op = op, args = own })
  end

  function B.call(op, args) return with_args("call", op, args) end

  local function powi(f, n)
    if n == 1 then return f end
    local key = "^" .. f.id .. " " .. n
    return unique[key] or intern(key, { kind = "powi", base = f, n = n })
  end

  -- ---- products ------------------------------------------------------------------------------------

  -- A product under construction: coefficient c, integer exponents e of the forms in list,
  -- fractional exponents of those in roots.
  local function begin() return { c = ONE, list = {}, e = {}, roots = {}, frac = {} } end

  -- P times f^n, n an integer; products, powers and roots are opened so that equal bases meet.
  local function gather(P, f, n)
    if f == one then return end
    if f.kind == "prod" then
      for _, x in ipairs(f.num) do gather(P, x, n) end
      for _, x in ipairs(f.den) do gather(P, x, -n) end
    elseif f.kind == "powi" then
      gather(P, f.base, n * f.n)
    elseif f.kind == "scale" then
      P.c = P.c * f.args[1].c ^ n
      gather(P, f.args[1].f, n)
    elseif f.root then
      if not P.frac[f.root] then P.roots[#P.roots + 1] = f.root end
      P.frac[f.root] = (P.frac[f.root] or R.zero) + f.exp * n
    else
      if not P.e[f] then P.list[#P.list + 1] = f end
      P.e[f] = (P.e[f] or 0) + n
    end
  end

  local function multiply(P, t, e)
    local c = t.c
    if math.type(e) == "integer" then
      if c ~= ONE then P.c = P.c * (e == 1 and c or c ^ e) end
      return gather(P, t.f, e)
    end
    if t.f == one then
      if R.sign(c) < 0 then error("lower: fractional power of the negative number " .. tostring(c)) end
      P.c = P.c * (e == HALF and R.apply("sqrt", form.BITS, c) or R.apply("pow", form.BITS, c, e))
      return
    end
    local base = t.f
    if c ~= ONE then -- sqrt(4*x) ==> 2*sqrt(x); sqrt(2*x) keeps its exact 2
      local q = R.toint(R.den(e))
      local root = R.sign(c) > 0 and q and q < 64 and R.root(c, q)
      if root then
        P.c = P.c * root ^ R.toint(R.num(e))
      else
        base = with_args("scale", "", { t })
      end
    end
    if not P.frac[base] then P.roots[#P.roots + 1] = base end
    P.frac[base] = (P.frac[base] or R.zero) + e
  end

  local function root_form(op, base, exp)
    local f = B.call(op, { { c = ONE, f = base } })
    f.root, f.exp = base, exp
    return f
  end

  -- x^e for 0 < e < 1 as factors { form, power }, or nil if it takes pow():
  -- x^(1/2) = sqrt x,  x^(1/4) = sqrt sqrt x,  x^(3/4) = sqrt x * sqrt sqrt x,  x^(k/3) = (cbrt x)^k.
  local function radicals(base, e)
    local p, q = R.toint(R.num(e)), R.toint(R.den(e))
    if q == 3 then return { { root_form("cbrt", base, R.new(1, 3)), p } } end
    if q ~= 2 and q ~= 4 then return nil end
    local sqrt = root_form("sqrt", base, HALF)
    if q == 2 then return { { sqrt, 1 } } end
    local fourth = { B.call("sqrt", { { c = ONE, f = sqrt } }), 1 }
    if p == 1 then return { fourth } end
    return { { sqrt, 1 }, fourth }
  end

  -- Fractional exponents of P: the whole part joins the integer ones, the rest becomes roots.
  local function extract_roots(P)
    local atoms = {}
    for _, base in ipairs(P.roots) do
      local e = P.frac[base] + (P.e[base] or 0)
      P.e[base] = P.e[base] and 0
      local size, side = abs(e), R.sign(e)
      local whole = R.toint(R.num(size)) // R.toint(R.den(size))
      local factors = not R.isint(e) and radicals(base, size - whole)
      if R.isint(e) or factors then
        if whole > 0 then gather(P, base, side * whole) end
        for _, x in ipairs(factors or {}) do atoms[#atoms + 1] = { x[1], side * x[2] } end
      else
        atoms[#atoms + 1] = { B.call("pow", { { c = ONE, f = base }, B.number(e) }), 1 }
      end
    end
    return atoms
  end

  local function finish(P)
    if R.sign(P.c) == 0 then return B.number(R.zero) end
    local atoms = #P.roots > 0 and extract_roots(P) or P.roots
    local num, den = {}, {}
    local function place(f, n)
      if n > 0 then
        num[#num + 1] = powi(f, n)
      elseif n < 0 then
        den[#den + 1] = powi(f, -n)
      end
    end
    for _, f in ipairs(P.list) do place(f, P.e[f]) end
    for _, atom in ipairs(atoms) do place(atom[1], atom[2]) end
    if #den == 0 and #num <= 1 then return { c = P.c, f = num[1] or one } end
    local key = {}
    for k, f in ipairs(num) do key[k] = f.id end
    key[#key + 1] = "/"
    for _, f in ipairs(den) do key[#key + 1] = f.id end
    key = table.concat(key, " ")
    return { c = P.c, f = unique[key] or intern(key, { kind = "prod", num = num, den = den }) }
  end

  -- Forms that gather() takes as they are.
  local simple = { leaf = true, sum = true }

  -- The common case, distinct simple forms to the power one, without the machinery; nil if it is not.
  local function plain_product(list)
    local c, num, key = ONE, {}, {}
    for k = 1, #list do
      local x = list[k]
      local t, f = x[1], x[1].f
      if x[2] ~= 1 or not (simple[f.kind] or f == one) then return nil end
      if t.c ~= ONE then c = c * t.c end
      if f ~= one then
        for j = 1, #num do
          if num[j] == f then return nil end
        end
        num[#num + 1] = f
        key[#num] = f.id
      end
    end
    if #num < 2 or R.sign(c) == 0 then return nil end
    key[#num + 1] = "/"
    key = table.concat(key, " ")
    return { c = c, f = unique[key] or intern(key, { kind = "prod", num = num, den = {} }) }
  end

  -- The product of { term, exponent } pairs, exponents Lua integers or rationals.
  function B.product(list)
    local known = plain_product(list)
    if known then return known end
    local P = begin()
    for _, x in ipairs(list) do multiply(P, x[1], plain(x[2])) end
    return finish(P)
  end

  -- ---- for sums.lua -----------------------------------------------------------------------------------

  -- The factors of a form: list of bases in order, e: base -> integer exponent, roots: what has another.
  function B.factors(f)
    local P = begin()
    gather(P, f, 1)
    return P
  end

  -- The form of these terms, which are in their final order and scale.
  function B.sum_form(terms)
    local key = { "+" }
    for k, t in ipairs(terms) do key[k + 1] = text(t.c) .. t.f.id end
    key = table.concat(key, " ")
    return unique[key] or intern(key, { kind = "sum", terms = terms })
  end

  sums.extend(B)
  return B
end

return form
