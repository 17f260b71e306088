-- form.lua: what lower makes of expressions: forms, hash-consed; the last algebra before the line.
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
-- Forms differ from expr nodes in that they are a plan of evaluation: quotients are explicit, roots are named.
--
-- Invariants.  Every form of a builder is in `unique` under a key that spells its kind and the ids of its parts, so
-- equal forms are one table, and `==` is equality.  A coefficient is never inside a product, and a sum is scaled so
-- that its first term is positive: so what is equal up to a factor is one form too, b - a is -1 times a - b.  Ids
-- count up in order of creation and parts are made before wholes: f.id is larger than the id of any part, and the
-- order of ids is the same at every run.  All this holds until share.lua and orient.lua change forms in place.
--
-- Here is the table of forms.  Not here: products, powers and roots (products), sums (sums), sharing of parts of sums
-- and products (share), which sign is printed (orient).

local R = require "generator.algebra.rational"
local products = require "generator.ir.lower.products"
local sums = require "generator.ir.lower.sums"

local form = { BITS = products.BITS }

local ONE, MINUS = R.one, -R.one

-- A coefficient in a key.
local function text(c)
  if c == ONE then return "" elseif c == MINUS then return "-" end
  return tostring(c) .. "*"
end

-- f is new.
local function intern(B, key, f)
  B.count = B.count + 1
  f.id = B.count
  B.unique[key] = f
  return f
end

-- The methods of a builder.  The terms that a form keeps are its own tables: orient.lua changes their coefficients.
local methods = { product = products.product, factors = products.factors, sum = sums.sum }

function methods.leaf(B, name)
  local key = "s" .. name
  return B.unique[key] or intern(B, key, { kind = "leaf", name = name })
end

local function with_args(B, kind, op, args)
  local key = { kind, op }
  for k, t in ipairs(args) do key[k + 2] = text(t.c) .. t.f.id end
  key = table.concat(key, " ")
  if B.unique[key] then return B.unique[key] end
  local own = {}
  for k, t in ipairs(args) do own[k] = { c = t.c, f = t.f } end
  return intern(B, key, { kind = kind, op = op, args = own })
end

function methods.call(B, op, args) return with_args(B, "call", op, args) end

-- The term as one factor, its coefficient inside.
function methods.scale(B, t) return with_args(B, "scale", "", { t }) end

-- f^n, n >= 1
function methods.power(B, f, n)
  if n == 1 then return f end
  local key = "^" .. f.id .. " " .. n
  return B.unique[key] or intern(B, key, { kind = "powi", base = f, n = n })
end

-- The product of the forms num over that of the forms den.  The key has their order, which is that of evaluation, so
-- x*y and y*x are two forms: the constructors of expr have put factors into one order already.
function methods.quotient(B, num, den)
  local key = {}
  for k = 1, #num do key[k] = num[k].id end
  key[#key + 1] = "/"
  for k = 1, #den do key[#key + 1] = den[k].id end
  key = table.concat(key, " ")
  return B.unique[key] or intern(B, key, { kind = "prod", num = num, den = den })
end

-- The form of these terms, which are in their final order and scale.
function methods.sum_form(B, terms)
  local key = { "+" }
  for k, t in ipairs(terms) do key[k + 1] = text(t.c) .. t.f.id end
  key = table.concat(key, " ")
  return B.unique[key] or intern(B, key, { kind = "sum", terms = terms })
end

-- A builder makes the forms of one program.
function form.builder()
  local B = { count = 0, unique = {} }
  for name, f in pairs(methods) do B[name] = f end -- order does not matter: into a table
  B.one = intern(B, "1", { kind = "one" })
  function B.number(c) return { c = c, f = B.one } end
  return B
end

return form
