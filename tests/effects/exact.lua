-- exact.lua -- the emitted equations evaluated in 200 bits, at values without a pattern.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     exact.fraction()            a number in (-1, 1), another one each time; exact.seed(n) begins a sequence
--     exact.values(m)             env, params: values for all that the model's expressions read
--     exact.value(e, env, params) the number of an expression
--     exact.rates(eq, value)      { state = its rate }

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local equations = require "generator.dynamics.equations"
local calculus = require "generator.algebra.calculus"
local scenes = require "tests.effects.scenes"

local exact = { BITS = 200 }
local random

function exact.seed(n) random = scenes.new(n, 0) end

function exact.fraction() return R.new(random:random(2000001) - 1000001, 1000000) end

-- Parameters near their defaults, a unit quaternion, all else in (-1, 1).
function exact.values(m)
  local params, env, fraction = {}, {}, exact.fraction
  for _, p in ipairs(m.params) do params[p.name] = p.default * (R.one + fraction() / R.new(16)) end
  for _, member in ipairs(m.members) do env[member.name] = evaluate.precise(member.e, params, exact.BITS) end
  local a, b, c = fraction(), fraction(), fraction()
  local s = R.one / (R.one + a * a + b * b + c * c)
  local q = { (R.one - a * a - b * b - c * c) * s, R.new(2) * a * s, R.new(2) * b * s, R.new(2) * c * s }
  for _, x in ipairs(m.states) do env[x.name] = x.kind == "attitude" and q[x.place] or fraction() end
  for _, u in ipairs(m.inputs) do env[u.name] = fraction() end
  env.t, env["the mass"] = R.abs(fraction()), evaluate.precise(m.mass, params, exact.BITS)
  for _, k in ipairs { "x", "y", "z" } do env["dw" .. k] = R.zero end
  return env, params
end

function exact.value(e, env, params)
  return evaluate.precise(calculus.substitute(e, {}), setmetatable({}, { __index = function(_, k)
    return env[k] or params[k]
  end }), exact.BITS)
end

function exact.rates(eq, value)
  local rates = {}
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do rates[o.state] = value(equations.inline(eq.groups, o.expr)) end
  end
  return rates
end

return exact
