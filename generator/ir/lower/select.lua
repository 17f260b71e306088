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

local R = require "generator.algebra.rational"

local select = {}

local ONE, MINUS = R.one, -R.one

-- A selector for ir; `survey` tells how each form is used.  values: form -> value number, to be set by
-- the caller for leaves; made: value number -> its instruction.
function select.new(ir, survey)
  local S = { values = {}, made = {} }
  local constants, scaled = {}, {}
  local code

  -- Instructions go to this list from now on.
  function S.into(list) code = list end

  local function emit(op, src1, src2, n)
    ir.n = ir.n + 1
    local i = { op = op, dst = ir.n, src1 = src1, src2 = src2, n = n }
    code[#code + 1] = i
    S.made[ir.n] = i
    return ir.n
  end

  local function constant(c)
    local key = tostring(c)
    if not constants[key] then
      ir.n = ir.n + 1
      constants[key] = ir.n
      ir.consts[#ir.consts + 1] = { op = "const", dst = ir.n, value = c }
    end
    return constants[key]
  end

  local value

  -- Is f used with one coefficient only, and never without?
  local function one_scale(f)
    local terms = survey.refs[f]
    if not terms or survey.solid[f] then return false end
    for _, t in ipairs(terms) do
      if R.abs(t.c) ~= R.abs(terms[1].c) then return false end
    end
    return true
  end

  local function used_once(f)
    return not survey.solid[f] and #survey.refs[f] == 1
  end

  -- c * num / den.  first: value of the first factor if it is not plainly num[1]'s.
  local function product(f, c, first)
    local acc
    if c ~= ONE or #f.num == 0 then acc = constant(c) end
    for k = 1, #f.num do
      local v = k == 1 and first or value(f.num[k])
      acc = acc and emit("mul", acc, v) or v
    end
    local under
    for k = 1, #f.den do
      local v = value(f.den[k])
      under = under and emit("mul", under, v) or v
    end
    return under and emit("div", acc, under) or acc
  end

  -- |c| * f, computed once.
  local function magnitude(t)
    local c = t.c
    if c == ONE or c == MINUS then return value(t.f) end
    c = R.abs(c)
    if t.f.kind == "one" then return constant(c) end
    local known = scaled[t.f]
    if not known then
      known = {}
      scaled[t.f] = known
    end
    local key = tostring(c)
    if not known[key] then
      if t.f.kind == "prod" and one_scale(t.f) then
        known[key] = product(t.f, c)
      else
        known[key] = emit("mul", constant(c), value(t.f))
      end
    end
    return known[key]
  end

  -- c * f with its sign.
  local function signed(t)
    if R.sign(t.c) >= 0 then return magnitude(t) end
    local f = t.f
    if f.kind == "one" then return constant(t.c) end
    if used_once(f) then
      if t.c ~= MINUS then
        if f.kind == "prod" then return product(f, t.c) end
        return emit("mul", constant(t.c), value(f))
      elseif f.kind == "prod" then
        if #f.num == 0 then return product(f, t.c) end
        return product(f, ONE, emit("neg", value(f.num[1])))
      end
    end
    return emit("neg", magnitude(t))
  end
  S.signed = signed

  local function sum(f)
    local lead
    for k, t in ipairs(f.terms) do
      if R.sign(t.c) > 0 then
        lead = k
        break
      end
    end
    local acc = signed(f.terms[lead or 1])
    for k, t in ipairs(f.terms) do
      if k ~= (lead or 1) then
        local v = magnitude(t)
        acc = emit(R.sign(t.c) > 0 and "add" or "sub", acc, v)
      end
    end
    return acc
  end

  local compute = {
    one = function() return constant(ONE) end,
    leaf = function(f) error("lower: '" .. f.name .. "' is used before it is defined") end,
    sum = sum,
    prod = function(f) return product(f, ONE) end,
    powi = function(f) return emit("powi", value(f.base), nil, f.n) end,
    scale = function(f) return signed(f.args[1]) end,
    call = function(f)
      local v = {}
      for k, t in ipairs(f.args) do v[k] = signed(t) end
      local result = emit(f.op, v[1], v[2])
      S.made[result].src3 = v[3]
      return result
    end,
  }

  function value(f)
    local v = S.values[f]
    if not v then
      v = compute[f.kind](f)
      S.values[f] = v
    end
    return v
  end

  return S
end

return select
