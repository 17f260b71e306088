-- select.lua: the step across the line, from forms to instructions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line on entry, below it on exit: what is chosen here is the evaluation order that the
-- IEEE semantics, the passes and the C text then keep to the bit.
--   sum      in its order, but the first positive term leads:  b*c - a*d,  1 - x
--   product  coefficient, factors in order, then one division by the product of the denominators;
--            a product that is used with several coefficients is computed by itself
--   minus    goes into a subtraction, a constant or the first factor; else it is a neg
-- Equal terms are computed once, where they are first needed.
--
-- Invariants.  A value number is defined by one instruction, which stands before its users: an instruction is emitted
-- after its operands, and groups are filled in their order.  S.values has a number for each form that was computed, so
-- a form is computed once; S.scaled has one for each form and |coefficient|.  Of c*f only |c|*f is kept: its negative
-- is a subtraction at the place where it is used, for a - b is as good as a + (-b) (IEEE 754: the same value).  A minus
-- is moved by -(x*y) = (-x)*y and -(c*x) = (-c)*x alone, which change no bit, as rounding to nearest is symmetric.
-- The work is one visit of each form and each term.

local R = require "generator.algebra.rational"

local select = {}

local ONE, MINUS = R.one, -R.one

-- Appends an instruction to the list that is being filled; returns the number of its value.
local function emit(S, op, src1, src2, n)
  local ir = S.ir
  ir.n = ir.n + 1
  local i = { op = op, dst = ir.n, src1 = src1, src2 = src2, n = n }
  S.code[#S.code + 1] = i
  S.made[ir.n] = i
  return ir.n
end

-- The value number of a constant; constants stand before all groups.
local function constant(S, c)
  local key, ir = tostring(c), S.ir
  if not S.constants[key] then
    ir.n = ir.n + 1
    S.constants[key] = ir.n
    ir.consts[#ir.consts + 1] = { op = "const", dst = ir.n, value = c }
  end
  return S.constants[key]
end

local compute -- kind of a form -> how it is computed, below

-- The value number of a form.
local function value(S, f)
  local v = S.values[f]
  if not v then
    v = compute[f.kind](S, f)
    S.values[f] = v
  end
  return v
end

-- ---- terms --------------------------------------------------------------------------------------------------------

-- Is f used with one |coefficient| only, and never without?  Then the coefficient may be the product's first factor:
-- nobody wants the product by itself.
local function one_scale(S, f)
  local terms = S.survey.refs[f]
  if not terms or S.survey.solid[f] then return false end
  for _, t in ipairs(terms) do
    if R.abs(t.c) ~= R.abs(terms[1].c) then return false end
  end
  return true
end

local function used_once(S, f) return not S.survey.solid[f] and #S.survey.refs[f] == 1 end

-- c * num / den.  first: value of the first factor if it is not plainly num[1]'s.
local function product(S, f, c, first)
  local acc
  if c ~= ONE or #f.num == 0 then acc = constant(S, c) end
  for k = 1, #f.num do
    local v = k == 1 and first or value(S, f.num[k])
    acc = acc and emit(S, "mul", acc, v) or v
  end
  local under
  for k = 1, #f.den do
    local v = value(S, f.den[k])
    under = under and emit(S, "mul", under, v) or v
  end
  return under and emit(S, "div", acc, under) or acc
end

-- |c| * f, computed once.
local function magnitude(S, t)
  local c = t.c
  if c == ONE or c == MINUS then return value(S, t.f) end
  c = R.abs(c)
  if t.f.kind == "one" then return constant(S, c) end
  local known = S.scaled[t.f]
  if not known then
    known = {}
    S.scaled[t.f] = known
  end
  local key = tostring(c)
  if not known[key] then
    if t.f.kind == "prod" and one_scale(S, t.f) then
      known[key] = product(S, t.f, c)
    else
      known[key] = emit(S, "mul", constant(S, c), value(S, t.f))
    end
  end
  return known[key]
end

-- c * f with its sign, where no subtraction takes it: a negative constant where the term is used here alone (else its
-- magnitude is shared), the negative of a product's first factor, or a neg at last.
local function signed(S, t)
  if R.sign(t.c) >= 0 then return magnitude(S, t) end
  local f = t.f
  if f.kind == "one" then return constant(S, t.c) end
  if used_once(S, f) then
    if t.c ~= MINUS then
      if f.kind == "prod" then return product(S, f, t.c) end
      return emit(S, "mul", constant(S, t.c), value(S, f))
    elseif f.kind == "prod" then
      if #f.num == 0 then return product(S, f, t.c) end
      return product(S, f, ONE, emit(S, "neg", value(S, f.num[1])))
    end
  end
  return emit(S, "neg", magnitude(S, t))
end

-- ---- forms --------------------------------------------------------------------------------------------------------

-- The first positive term leads; where there is none the first one does, as a negative.
local function sum(S, f)
  local lead
  for k, t in ipairs(f.terms) do
    if R.sign(t.c) > 0 then
      lead = k
      break
    end
  end
  local acc = signed(S, f.terms[lead or 1])
  for k, t in ipairs(f.terms) do
    if k ~= (lead or 1) then
      local v = magnitude(S, t)
      acc = emit(S, R.sign(t.c) > 0 and "add" or "sub", acc, v)
    end
  end
  return acc
end

compute = {
  one = function(S) return constant(S, ONE) end,
  leaf = function(_, f) error("lower: '" .. f.name .. "' is used before it is defined") end,
  sum = sum,
  prod = function(S, f) return product(S, f, ONE) end,
  powi = function(S, f) return emit(S, "powi", value(S, f.base), nil, f.n) end,
  scale = function(S, f) return signed(S, f.args[1]) end,
  call = function(S, f)
    local v = {}
    for k, t in ipairs(f.args) do v[k] = signed(S, t) end
    local result = emit(S, f.op, v[1], v[2])
    S.made[result].src3 = v[3]
    return result
  end,
}

-- ---- the selector -------------------------------------------------------------------------------------------------

-- A selector for ir; `survey` tells how each form is used (orient.lua).  values: form -> value number, to be set by
-- the caller for leaves; made: value number -> its instruction.
function select.new(ir, survey)
  return { ir = ir, survey = survey, values = {}, made = {}, constants = {}, scaled = {}, code = nil }
end

-- Instructions go to this list from now on.
function select.into(S, list) S.code = list end

-- The value number of a term.
select.signed = signed

return select
