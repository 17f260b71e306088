-- expr.lua -- hash-consed expressions over the reals, with constructors that simplify.
--
-- ABOVE the line: every rule here is a law of real algebra and may not hold for IEEE numbers (0*x ==> 0,
-- x - x ==> 0, x/x ==> 1; inputs are assumed finite and denominators non-zero).  Two nodes are equal
-- expressions in canonical form iff they are the same table, so `==` is structural equality and every
-- shared subexpression is shared by construction.
--
-- Kinds (six, no more):   num   value            an exact rational
--                         sym   name, rank, positive
--                         add   [1..n]           n >= 2 terms, sorted; PRIMITIVE: the rational content and
--                                                the sign of the first term are pulled out, so that x - y
--                                                and 2y - 2x share one node
--                                                (a content beyond 64 bits, of rounded constants, stays:
--                                                numbers keep their size)
--                         mul   [1..n]           n >= 2 factors, sorted; a rational coefficient is [1]
--                         pow   base, exp        exp an exact rational, not 0 or 1
--                         call  fn, [1..n]       sin cos tan asin acos atan atan2 exp log sinh cosh tanh pi; abs side
--                                                sign min max clamp (choice.lua);
--                                                ellipsoid_area ellipsoid_normal, arc_* and catenary_* (exact.lua);
--                                                opaque, the value of its argument: one generator of polynomials
-- Invariants.  Every node is in `unique` under a key made of its kind and the ids of its parts; nodes are never
-- changed, so what is found out about one may be kept for it.  A sum has no two terms that are multiples of one node
-- and no term that is a sum; a product no two factors of one base and no factor that is a product; no part is the
-- number that would leave the rest as it is.  The constructors see to it, in time linear in what they are given but
-- for sorting.  They do not multiply out: (a + b)*(a - b) and a^2 - b^2 are two nodes, of which ratio.iszero tells
-- that they are equal.  Not here: signs (sign.lua), derivatives and substitution (calculus.lua), polynomial normal
-- forms (poly.lua), text (text.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local radical = require "generator.algebra.radical"
local canonical = require "generator.algebra.order"
local sign = require "generator.algebra.sign"

local expr = {}
local compare, factor = canonical.compare, canonical.factor
expr.compare = compare

local node = {} -- the metatable of every node
node.__index = node

local unique = {} -- canonical key -> node
local count = 0

-- The one node of this key, e if there is none.  Ids count nodes as they are made, so no order may rest on them.
local function intern(key, e)
  local old = unique[key]
  if old then return old end
  count = count + 1
  e.id = count
  unique[key] = setmetatable(e, node)
  return e
end

function expr.is(x) return getmetatable(x) == node end

local small = {} -- the nodes of small whole numbers, each of which is one object (rational.h)

local function num(value)
  if small[value] then return small[value] end
  local e = intern("n" .. tostring(value), { kind = "num", value = value })
  if R.small(value) then small[value] = e end
  return e
end

-- An expression for x: a node, a rational, an integer, a finite double (its decimal) or "p/q".
local function lift(x)
  if getmetatable(x) == node then return x end
  local value, why = R.lift(x)
  if not value then error("not an expression: " .. (why or type(x)), 2) end
  return num(value)
end
expr.lift = lift
expr.num = lift

-- A symbol.  rank orders factors in a product (masses before lengths, parameters before states);
-- positive = true lets square roots of its squares open.  Same name, rank and sign: same node.
function expr.sym(name, rank, positive)
  rank = rank or 5
  local key = "s" .. name .. ":" .. rank .. (positive and "+" or "")
  return intern(key, { kind = "sym", name = name, rank = rank, positive = positive or false })
end

local zero, one, minus_one = num(R.zero), num(R.one), num(-R.one)
expr.zero, expr.one = zero, one

---- products --------------------------------------------------------------------------------------

local function ids(list)
  local key = {}
  for i = 1, #list do key[i] = list[i].id end
  return table.concat(key, ",")
end

-- The product of factors in canonical order.
local function of_factors(factors)
  factors.kind = "mul"
  return intern("*" .. ids(factors), factors)
end

-- e = coefficient * rest, the coefficient rational, rest without one (rest is `one` for a number).
local function split(e)
  if e.kind == "num" then return e.value, one end
  if e.kind == "mul" and e[1].kind == "num" then
    if #e == 2 then return e[1].value, e[2] end
    return e[1].value, of_factors(table.move(e, 2, #e, 1, {}))
  end
  return R.one, e
end
expr.split = split

local nonnegative = sign.nonnegative
expr.nonnegative = nonnegative

-- base^exp as it stands: the caller has tried the laws.
local function raw_pow(base, exp)
  if exp == R.one then return base end
  return intern("^" .. base.id .. ":" .. tostring(exp), { kind = "pow", base = base, exp = exp })
end

-- Products.  A product is gathered as a coefficient and a map from bases to exponents, by these laws, all of them for
-- real numbers, bases not zero where exponents are negative:
--     x^a * x^b ==> x^(a+b)         0 * x ==> 0         |x|^(2 k) ==> x^(2 k)
--     n^k of a number joins the coefficient; n^(p/q) opens into primes with 0 < exponent < 1 (radical.lua), so that
--     sqrt 8 is 2 sqrt 2 and equal numbers are equal nodes;  ((x*y)^(1/2))^2 ==> x*y is opened again.
-- An opened base gives powers of smaller bases, so rounds end: after one round unless a root or |x| was opened.

-- Adds the powers { base, exp } of list to the map exps; bases that are new come to the end of order.
local function collect(order, exps, list)
  for _, f in ipairs(list) do
    local base, exp = f[1], f[2]
    local earlier = exps[base]
    if not earlier then order[#order + 1] = base end
    exps[base] = earlier and earlier + exp or exp
  end
end

-- Takes out of exps what is a number, has the exponent 0, or opens into other powers, which go to pending.  Returns the
-- coefficient, and whether the base is still one.
local function settle(base, exps, coefficient, pending)
  local exp = exps[base]
  if base.kind == "num" and R.isint(exp) then
    coefficient, exps[base] = coefficient * base.value ^ R.toint(exp), nil
  elseif base.kind == "num" and (R.sign(exp) < 0 or exp > R.one) then
    exps[base] = nil -- 2^(3/2) ==> 2*2^(1/2), 2^(-1/2) ==> 2^(1/2)/2
    local c, roots = radical.open(base.value, exp)
    coefficient = coefficient * c
    for _, r in ipairs(roots) do pending[#pending + 1] = { num(r[1]), r[2] } end
  elseif R.sign(exp) == 0 then
    exps[base] = nil
  elseif base.kind == "call" and base.fn == "abs" and R.isint(exp / R.new(2)) then
    exps[base] = nil -- |x|^2 ==> x^2
    local inside = base[1].kind == "mul" and base[1] or { base[1] }
    for i = 1, #inside do
      local b, x = factor(inside[i])
      pending[#pending + 1] = { b, x * exp }
    end
  else
    return coefficient, true
  end
  return coefficient, false
end

-- The powers of the product once more, with the base, a product itself, opened: (x*y)^(1/2) squared.
local function opened(coefficient, order, exps, base)
  local again = { { num(coefficient), R.one } }
  for _, other in ipairs(order) do
    if other ~= base then again[#again + 1] = { other, exps[other] } end
  end
  for i = 1, #base do
    local b, x = factor(base[i])
    again[#again + 1] = { b, x * exps[base] }
  end
  return again
end

local function before(a, b) return compare(a, b) < 0 end

-- The node of the coefficient and of factors, which are in their final form but for their order.
local function joined(coefficient, factors)
  if #factors > 1 then table.sort(factors, before) end
  if #factors == 0 then return num(coefficient) end
  if coefficient == R.one then
    if #factors == 1 then return factors[1] end
  else
    table.insert(factors, 1, num(coefficient))
  end
  return of_factors(factors)
end

-- The product of a rational, not 0, and of a node without a rational factor.
local function scaled(c, e)
  if c == R.one then return e end
  if e == one then return num(c) end
  return of_factors(e.kind == "mul" and table.move(e, 1, #e, 2, { num(c) }) or { num(c), e })
end

-- The product of a rational and of a list of powers { base, exp }.
local function product(coefficient, list)
  local order, exps = {}, {}
  local pending = list
  while #pending > 0 do
    collect(order, exps, pending)
    pending = {}
    local kept = {}
    for _, base in ipairs(order) do
      local stays
      coefficient, stays = settle(base, exps, coefficient, pending)
      if stays then kept[#kept + 1] = base end
    end
    order = kept
  end
  if R.sign(coefficient) == 0 then return zero end
  local factors = {}
  for k, base in ipairs(order) do
    if base.kind == "mul" and R.isint(exps[base]) then
      return product(R.one, opened(coefficient, order, exps, base))
    end
    factors[k] = raw_pow(base, exps[base])
  end
  return joined(coefficient, factors)
end

-- All factors at once: the result does not depend on their order.
function expr.mul(list)
  local coefficient, powers = nil, {}
  for _, x in ipairs(list) do
    local e = lift(x)
    local factors = e.kind == "mul" and e or { e }
    for i = 1, #factors do
      local f = factors[i]
      if f.kind == "num" then
        coefficient = coefficient and coefficient * f.value or f.value
      else
        local base, exp = factor(f)
        powers[#powers + 1] = { base, exp }
      end
    end
  end
  return product(coefficient or R.one, powers)
end

---- powers ----------------------------------------------------------------------------------------

-- e^n for a rational n.  (x*y)^n ==> x^n*y^n for integer n, and for any n when the factor is >= 0;
-- (x^a)^n ==> x^(a*n) likewise, and (x^2)^(1/2) ==> |x| otherwise.
function expr.pow(x, n)
  local e = lift(x)
  n = R.lift(n)
  if R.sign(n) == 0 then return one end
  if n == R.one then return e end
  local whole = R.isint(n)
  if e.kind == "num" then
    local s = R.sign(e.value)
    if s == 0 then
      if R.sign(n) < 0 then error("division by zero", 2) end
      return zero
    end
    if whole then return num(e.value ^ R.toint(n)) end
    if s < 0 then error("root of the negative number " .. tostring(e.value), 2) end
    local c, roots = radical.open(e.value, n)
    local list = {}
    for i, r in ipairs(roots) do list[i] = { num(r[1]), r[2] } end
    return product(c, list)
  end
  if e.kind == "pow" then
    if whole or nonnegative(e.base) then return expr.pow(e.base, e.exp * n) end
    if R.isint(e.exp / R.new(2)) then return expr.pow(expr.call("abs", e.base), e.exp * n) end
    return raw_pow(e, n)
  end
  if e.kind == "mul" then
    local out, inside = {}, {}
    for i = 1, #e do
      local f = e[i]
      if f.kind == "num" and not whole and R.sign(f.value) < 0 then
        if f.value ~= -R.one then out[#out + 1] = expr.pow(num(-f.value), n) end
        inside[#inside + 1] = num(-R.one)
      elseif whole or nonnegative(f) or (f.kind == "pow" and R.isint(f.exp / R.new(2))) then
        out[#out + 1] = expr.pow(f, n)
      else
        inside[#inside + 1] = f
      end
    end
    if #out > 0 then
      if #inside > 0 then out[#out + 1] = expr.pow(expr.mul(inside), n) end
      return expr.mul(out)
    end
    return raw_pow(e, n)
  end
  return e.kind == "call" and product(R.one, { { e, n } }) or raw_pow(e, n)
end

function expr.sqrt(x) return expr.pow(x, R.half) end

---- sums ------------------------------------------------------------------------------------------

-- Sum of the list.  Like terms are collected, nested sums (with a rational factor) are flattened, the
-- content is pulled out: 2x + 4y ==> 2*(x + 2y),  -x + y ==> -(x - y).
function expr.add(list)
  local order, coefficients = {}, {}
  local function gather(e, scale)
    local c, rest = split(e)
    if rest.kind == "add" then
      for i = 1, #rest do gather(rest[i], scale and scale * c or c) end
      return
    end
    if scale then c = scale * c end
    local earlier = coefficients[rest]
    if not earlier then order[#order + 1] = rest end
    coefficients[rest] = earlier and earlier + c or c
  end
  for _, x in ipairs(list) do gather(lift(x)) end
  local terms = {}
  for _, rest in ipairs(order) do
    if R.sign(coefficients[rest]) ~= 0 then terms[#terms + 1] = rest end
  end
  if #terms == 0 then return zero end
  if #terms == 1 then return scaled(coefficients[terms[1]], terms[1]) end
  table.sort(terms, before)
  local content = R.zero
  for _, t in ipairs(terms) do content = R.gcd(content, coefficients[t]) end
  if R.log2(R.num(content)) > 64 or R.log2(R.den(content)) > 64 then content = R.one end -- see the head
  if R.sign(coefficients[terms[1]]) < 0 then content = -content end
  local sum, whole = { kind = "add" }, content == R.one
  for i, t in ipairs(terms) do
    sum[i] = scaled(whole and coefficients[t] or coefficients[t] / content, t)
  end
  return scaled(content, intern("+" .. ids(sum), sum))
end

---- functions -------------------------------------------------------------------------------------

local exact = require("generator.algebra.exact")(expr)

-- fn(args): exact values open (sin(pi/6) ==> 1/2), odd and even symmetry is used, else a call node.
function expr.call(fn, ...)
  local args = { ... }
  for i = 1, #args do args[i] = lift(args[i]) end
  local value = exact(fn, args)
  if value then return value end
  args.kind, args.fn = "call", fn
  return intern("c" .. fn .. ":" .. ids(args), args)
end

expr.pi = intern("cpi:", { kind = "call", fn = "pi" })

---- operators -------------------------------------------------------------------------------------

function node.__add(a, b) return expr.add { a, b } end
function node.__sub(a, b) return expr.add { a, expr.mul { minus_one, b } } end
function node.__mul(a, b) return expr.mul { a, b } end
function node.__div(a, b) return expr.mul { a, expr.pow(b, -1) } end
function node.__unm(a) return expr.mul { minus_one, a } end
function node.__pow(a, n)
  if expr.is(n) then
    if n.kind ~= "num" then error("an exponent must be a number", 2) end
    n = n.value
  end
  return expr.pow(a, n)
end

function expr.iszero(e) return e == zero end

require("generator.algebra.walk")(expr) -- children, map, symbols, constant

return expr
