-- laws.lua -- what an effect conserves, decided from its torque, force and potential.
--
-- Of what the effect alone brings to the motion, with N in body axes and F in inertial ones:
--     T+V    N.w + F.v + dV/dt = 0, dV/dt along q' = q (0, w)/2, r' = v and the effect's own states
--     L      N = 0          L_z    (R(q) N)_z = 0          w3     N_z = 0          |L|    N.(I w) = 0
-- q is put on the unit sphere by (1 - s^2, 2 a, 2 b, 2 c)/(1 + s^2), s^2 = a^2 + b^2 + c^2, so that an identity which
-- needs |q| = 1 is one of rational functions.  Not proven is not conserved.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"

local laws = {}

local zero = expr.zero
local nothing = { zero, zero, zero }

local a, b, c = expr.sym("a of q", 8), expr.sym("b of q", 8), expr.sym("c of q", 8)
local s2 = a ^ 2 + b ^ 2 + c ^ 2
local unit = { (1 - s2) / (1 + s2), 2 * a / (1 + s2), 2 * b / (1 + s2), 2 * c / (1 + s2) }

-- The laws that effect e of the model keeps, as effects/effects.lua names them.
function laws.of(m, e)
  local ctx = context.with(context.dry(m), e)
  local N = e.spec.torque and e.spec.torque(e.a, ctx) or nothing
  local F = m.has.position and e.spec.force and e.spec.force(e.a, ctx) or nothing
  local V = e.spec.potential and e.spec.potential(e.a, ctx) or zero
  local sphere = {}
  for i, x in ipairs(ctx.q) do sphere[x] = unit[i] end
  -- Most laws hold for q of any length, which is proved in a tenth of the time.
  local function vanishes(x)
    return x == zero or ratio.iszero(x) or ratio.iszero(calculus.substitute(x, sphere))
  end
  local list = {}

  local power = vec.dot(N, ctx.w) + vec.dot(F, ctx.v)
  local turn = vec.qmul(ctx.q, { zero, ctx.w[1], ctx.w[2], ctx.w[3] })
  for i, x in ipairs(ctx.q) do power = power + calculus.diff(V, x) * turn[i] / 2 end
  for i, x in ipairs(ctx.r) do power = power + calculus.diff(V, x) * ctx.v[i] end
  local rates = #e.states > 0 and e.spec.derivative(e.a, ctx)
  for _, s in ipairs(e.states) do power = power + calculus.diff(V, s.sym) * rates[s.key] end
  if vanishes(power) then list[1] = "T+V" end

  local function put(law, x)
    if vanishes(x) then list[#list + 1] = law end
  end
  if vanishes(N[1]) and vanishes(N[2]) and vanishes(N[3]) then
    list[#list + 1] = "L"
  else
    put("|L|", vec.dot(N, vec.apply(m.inertia, ctx.w)))
    put("L_z", vec.matvec(vec.rotation(ctx.q), N)[3])
  end
  put("w3", N[3])
  return list
end

return laws
