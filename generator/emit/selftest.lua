-- selftest.lua -- expected numbers for the emitted self-test.
--
-- Every case is computed from the exact expressions, with the parameters and states rounded to the emitted real
-- type first (so the inputs are the very numbers the C code sees), at `bits` bits.  The tolerance of a number is
-- `roundings` units of the type's epsilon times its magnitude: the value of the same expression with every term
-- made positive, a bound of what can cancel.  No result of the emitted file is more than 32 operations deep, but for
-- those of a step, which has at most 7 stages as deep as that, one after the other: `stages` times as many.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local distinct = require "generator.dynamics.distinct"

local selftest = { bits = 200, roundings = 32, stages = R.new(8) }

-- An environment holds values and magnitudes of names: {value = {name -> R}, size = {name -> R}}; a name without a
-- size is an input, whose size is its absolute value.  Names may be added to it as they become known.

-- Of a power of two: a magnitude beyond it is put to it.  Where sums cancel in each stage of a step, magnitudes are
-- multiplied with each other as often as the stages' degree, and become numbers of a million bits that tell nothing.
local widest = 900

-- Two functions of expressions in the environment: their value, and their value with every term of every sum made
-- positive, which is the magnitude before cancellation.
-- |a - b| is bounded by a + b of magnitudes, a product by their product; a quotient's relative error is its base's.
local function within(env)
  local value, memo = evaluate.within(env.value, selftest.bits), {}
  local function mag(u)
    if memo[u] then return memo[u] end
    local v
    if u.kind == "sym" and env.size[u.name] then
      v = env.size[u.name]
    elseif u.kind == "add" then
      v = R.zero
      for i = 1, #u do v = v + mag(u[i]) end
    elseif u.kind == "mul" then
      v = R.one
      for i = 1, #u do v = v * mag(u[i]) end
    elseif u.kind == "pow" and R.isint(u.exp) and R.sign(u.exp) > 0 then
      v = mag(u.base) ^ R.toint(u.exp)
    elseif u.kind == "pow" then -- relative error of the base times |exponent|
      local b = R.abs(value(u.base))
      v = R.sign(b) == 0 and R.zero or R.abs(value(u)) * (mag(u.base) / b) * (R.abs(u.exp) + R.one)
    else
      v = R.abs(value(u))
    end
    if R.sign(v) ~= 0 and R.log2(v) > widest then v = R.new(2) ^ widest end
    memo[u] = R.round(v, 64)
    return memo[u]
  end
  return value, mag
end

-- The environment of the model's derived constants, for these parameters (name -> rational).  The parameters
-- themselves are not in it: only NAME_init sees them, and their names may be those of states or arguments.
-- A constant's size is that of its form, which is what NAME_init computes.
function selftest.environment(m, params, held)
  local from, env = { value = {}, size = {} }, { value = {}, size = {} }
  for k, v in pairs(params) do from.value[k] = v end -- into a table: order is lost anyway
  local value, magnitude = evaluate.within(params, selftest.bits), select(2, within(from))
  local function put(name, pure, form) from.value[name], from.size[name] = value(pure), magnitude(form) end
  for _, step in ipairs(m.parts and m.parts.list or {}) do put(step.name, step.pure, step.e) end
  for _, k in ipairs(held or {}) do env.value[k.name] = k.value end -- baked: rounded once, like an input
  for _, member in ipairs(m.members) do
    if member.form ~= member.sym then put(member.name, member.e, member.form) end
    env.value[member.name], env.size[member.name] = from.value[member.name], from.size[member.name]
  end
  return env
end

-- How many times larger than the derived constants the terms are that cancel in them, at worst: what an error of
-- rounding is multiplied with before the motion begins.
function selftest.cancellation(m, params)
  local env, worst = selftest.environment(m, params), 1.0
  for _, member in ipairs(m.members) do
    local x = R.abs(env.value[member.name])
    if R.sign(x) > 0 then worst = math.max(worst, R.todouble(env.size[member.name] / x)) end
  end
  return worst
end

-- Expected values and tolerances (rationals) of a description's results: env from selftest.environment, state: more
-- inputs; index: out -> position from 1.
function selftest.expect(f, env, state, index, epsilon)
  local here = { value = setmetatable(state, { __index = env.value }), size = setmetatable({}, { __index = env.size }) }
  local want, tolerance = {}, {}
  local ranks = setmetatable({}, { __index = function(_, name)
    return rawget(state, name) and 8 or env.value[name] and 3 or nil
  end })
  local value, magnitude = within(here)
  for _, g in ipairs(distinct.run(f.groups, ranks)) do
    for _, d in ipairs(g.defs) do here.value[d.name], here.size[d.name] = value(d.expr), magnitude(d.expr) end
    for _, o in ipairs(g.outs) do
      local i = index(o)
      if i then
        want[i] = value(o.expr)
        tolerance[i] = R.round(magnitude(o.expr) * epsilon * R.new(selftest.roundings), 64)
      end
    end
  end
  return want, tolerance
end

-- The verdicts of NAME_spin_stable for these parameters: a list of {axis, dissipation, want, last}.  Without axes in
-- closed form nothing is expected: what NAME_principal makes of nearly equal moments is its own affair.
function selftest.spins(job, params)
  local s, list = job.stability, {}
  if not s or not s.axes then return list end
  local signs = s:signs(function(atom)
    local ok, x = pcall(evaluate.exact, atom, params)
    return R.sign(ok and x or evaluate.precise(atom, params, selftest.bits))
  end)
  for k = 1, 3 do
    for dissipation = 0, 1 do
      list[#list + 1] = { axis = k - 1, dissipation = dissipation, want = s.verdict(signs, k, dissipation == 1) }
    end
  end
  list[#list].last = true
  return list
end

return selftest
