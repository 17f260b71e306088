-- selftest.lua -- expected numbers for the emitted self-test.
--
-- Every case is computed from the exact expressions, with the parameters and states rounded to the emitted real
-- type first (so the inputs are the very numbers the C code sees), at `bits` bits.  The tolerance of a number is
-- `roundings` units of the type's epsilon times its magnitude: the value of the same expression with every term
-- made positive, a bound of what can cancel.  No result of the emitted file is more than 32 operations deep.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"

local selftest = { bits = 200, roundings = 32 }

-- The value of e with every term of every sum made positive: e's magnitude before cancellation.
local function magnitude(e, env)
  local memo = {}
  local function value(u) return R.abs(evaluate.precise(u, env, selftest.bits)) end
  local function mag(u)
    if memo[u] then return memo[u] end
    local v
    if u.kind == "add" then
      v = R.zero
      for i = 1, #u do v = v + mag(u[i]) end
    elseif u.kind == "mul" then
      v = R.one
      for i = 1, #u do v = v * mag(u[i]) end
    elseif u.kind == "pow" and R.isint(u.exp) and R.sign(u.exp) > 0 then
      v = mag(u.base) ^ R.toint(u.exp)
    elseif u.kind == "pow" then -- relative error of the base times |exponent|
      local b = value(u.base)
      v = R.sign(b) == 0 and R.zero or value(u) * (mag(u.base) / b) * (R.abs(u.exp) + R.one)
    else
      v = value(u)
    end
    memo[u] = R.round(v, 64)
    return memo[u]
  end
  return mag(e)
end

-- env of rationals rounded to the real type
function selftest.rounded(env, real)
  local out = {}
  for k, v in pairs(env) do -- into a table: order is lost anyway
    out[k] = R.fromdouble(real == "float" and R.tofloat(v) or R.todouble(v))
  end
  return out
end

-- Replaces definitions and derived constants of a function description by what they stand for.
local function inlined(m, f)
  local map, list = {}, {}
  for _, member in ipairs(m.members) do map[member.sym] = member.e end
  for _, g in ipairs(f.groups) do
    for _, d in ipairs(g.defs) do
      local e = calculus.substitute(d.expr, map)
      for rank = 6, 9 do map[expr.sym(d.name, rank)] = e end
    end
    for _, o in ipairs(g.outs) do list[#list + 1] = { out = o, e = calculus.substitute(o.expr, map) } end
  end
  return list
end

-- Expected values and tolerances (rationals) of a description's results in the environment, in the order of `index`
-- (out -> position from 1).
function selftest.expect(m, f, env, index, epsilon)
  local want, tolerance = {}, {}
  for _, x in ipairs(inlined(m, f)) do
    local i = index(x.out)
    if i then
      want[i] = evaluate.precise(x.e, env, selftest.bits)
      tolerance[i] = R.round(magnitude(x.e, env) * epsilon * R.new(selftest.roundings), 64)
    end
  end
  return want, tolerance
end

return selftest
