-- cayley.lua -- what steppers on the rotation group share: torques, I^-1, one Newton step, Cayley's rotation.
--
-- Cayley's map of a vector 2 b is the rotation of the unit quaternion along (1, b), R = 1 + s (b x + b x b x) with
-- s = 2/(1 + b^2); its inverse takes L to L + s (b x (b x L) - b x L).  Source: Hairer, Lubich, Wanner, Geometric
-- Numerical Integration (2nd ed.), IV.8.3.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local equations = require "generator.dynamics.equations"
local moving = require "generator.dynamics.moving"
local state = require "generator.dynamics.state"
local claim = require "generator.methods.claim"

local cayley = {}

local w = state.w
local axes = { "x", "y", "z" }

-- Adds definitions to group g, with names that no constant of the model has; numbers and symbols stay.
function cayley.definer(m, g)
  return function(name, e)
    if e.kind == "num" or e.kind == "sym" then return e end
    while m.by_name[name] do name = name .. "_" end
    g.defs[#g.defs + 1] = { name = name, expr = e }
    return expr.sym(name, 8)
  end
end

-- Entries of a vector or a quaternion by names ending in x y z or w x y z.
function cayley.each(define, name, v)
  return vec.map(v, function(e, i) return define(name .. (#v == 4 and i == 1 and "w" or axes[i - #v + 3]), e) end)
end

function cayley.none(v) return v[1] == expr.zero and v[2] == expr.zero and v[3] == expr.zero end

-- The tensor that the rates carry, with moving parts; second result: whether there are such.
function cayley.inertia(m) return context.now(m) end

-- What acts on the body: {N = torque, k = the rotors' momentum where it is constant, changing = which effect's is not
-- (N then has what it does to the body) or nil, slip = rate at which the axes turn beside w, or nil}.  Not in N: what
-- turning L with the axes does, which is the slip's torque; what moving parts do, where the step takes their tensor.
function cayley.acting(m)
  local zero = { expr.zero, expr.zero, expr.zero }
  local N, k, names, changing, slip, turning = zero, zero, { t = true }, nil, nil, zero
  for _, s in ipairs(m.states) do names[s.name] = true end
  local c = context.of(m)
  for _, e in ipairs(m.record.effects) do
    local own = context.with(c, e)
    local held = e.spec.momentum and e.spec.momentum(e.a, own) or zero
    local constant = #e.states == 0
    for i = 1, 3 do constant = constant and expr.constant(held[i], names) end
    if e.spec.turn then
      slip = vec.add(slip or zero, e.spec.turn(e.a, own))
    elseif constant then
      N, k = vec.add(N, e.spec.torque and e.spec.torque(e.a, own) or zero), vec.add(k, held)
    elseif not e.spec.varies then
      N, changing = vec.add(N, equations.torque_of(m, e, own)), e.kind .. "'s angular momentum is not constant"
      turning = vec.add(turning, held)
    end
  end
  if slip then N = vec.add(N, vec.cross(turning, slip)) end -- the slip turns all of L, the step only I w + k
  return { N = N, k = k, changing = changing, slip = slip }
end

-- v without what is along the line of a rod, where it has no momentum.
function cayley.across(m, v)
  local s = m.structure
  return s.rod and vec.sub(v, vec.scale(vec.dot(s.k, v) / s.k2, s.k)) or v
end

-- I^-1 (I w x w + N) without definitions
function cayley.rates(m, N)
  local g = equations.euler(m, cayley.across(m, N))
  return vec.map(g.outs, function(e) return equations.inline({ g }, e) end)
end

-- I^-1 v
function cayley.solved(m, v)
  local still = {}
  for i = 1, 3 do still[w[i]] = expr.zero end
  -- v may have w in it, so it stands in by symbols
  local list, back = {}, {}
  for i = 1, 3 do
    list[i] = v[i] == expr.zero and v[i] or expr.sym("entry " .. axes[i], 8)
    back[list[i]] = v[i]
  end
  if m.structure.rod then list = cayley.across(m, list) end
  local g = equations.euler(m, list)
  return vec.map(g.outs, function(e)
    return calculus.substitute(calculus.substitute(equations.inline({ g }, e), still), back)
  end)
end

-- Nil where a step on the rotation group stands for the scene's equations: q' = (q (0, W) - (0, Omega) q)/2, W = w and
-- the slip, I w' = (I w + k) x W + N - D' w with what acts (cayley.acting) and moving parts D; else why not.  Other
-- states are stepped by their equations as they are.
function cayley.missed(eq)
  local m = eq.model:fork() -- what the proof asks for is not the scene's
  local acts, I = cayley.acting(m), cayley.inertia(m)
  local N, W = vec.add(acts.N, vec.cross(acts.k, w)), w
  if acts.slip then
    W = vec.add(w, acts.slip)
    N = vec.add(N, vec.cross(vec.add(vec.apply(I, w), acts.k), acts.slip))
  end
  for _, e in ipairs(m.record.effects) do
    local own = context.with(context.of(m), e)
    if e.spec.varies and e.spec.varies(e.a, own) then N = vec.add(N, e.spec.torque(e.a, own)) end
  end
  local turn
  if m.frame then
    local Omega, defs = moving.rate(m)
    turn = vec.map(Omega, function(e) return equations.inline({ { defs = defs } }, e) end)
  end
  local claimed, rates = claim.turning(W, turn), claim.rates(eq.groups)
  for i, e in ipairs(cayley.rates(m, N)) do claimed[state.names.rates[i]] = e end
  for _, s in ipairs(m.states) do
    if s.kind ~= "attitude" and s.kind ~= "rates" then claimed[s.name] = rates[s.name] end
  end
  local name = claim.miss(m.states, rates, claimed, m)
  return name and "the rate of " .. name .. " is more than free turning and a torque" or nil
end

-- Cyclic indices give the cofactor its sign.
local function cofactor(A, i, j)
  local a, b, c, d = i % 3 + 1, (i + 1) % 3 + 1, j % 3 + 1, (j + 1) % 3 + 1
  return A[a][c] * A[b][d] - A[a][d] * A[b][c]
end

-- J^-1 by cofactors: returns F -> J^-1 F.
-- Law: (J^-1)_ji = K_ij/det J, K the cofactors, det J by the first row of J and K.
function cayley.inverse(define, J)
  local K = {}
  for i = 1, 3 do
    K[i] = {}
    for j = 1, 3 do K[i][j] = define("K" .. axes[i] .. axes[j], cofactor(J, i, j)) end
  end
  local over = define("over", expr.lift(1) / (J[1][1] * K[1][1] + J[1][2] * K[1][2] + J[1][3] * K[1][3]))
  return function(F)
    return vec.map(F, function(_, j) return over * (K[1][j] * F[1] + K[2][j] * F[2] + K[3][j] * F[3]) end)
  end
end

-- (1 - D)^-1 F; D near 0, entries D(i, j).  Rows whose F is zero do not move.
-- The identity's row stands for such a row, so what is solved stays 3 by 3.
function cayley.newton(define, F, D)
  local J = {}
  for i = 1, 3 do
    J[i] = {}
    for j = 1, 3 do
      local one = i == j and expr.one or expr.zero
      J[i][j] = F[i] == expr.zero and one or define("D" .. axes[i] .. axes[j], one - D(i, j))
    end
  end
  local change = cayley.inverse(define, J)(F)
  return vec.map(F, function(e, j) return e == expr.zero and e or change[j] end)
end

-- What turning L back by the rotation of (1, b) adds to it; s = 2/(1 + b^2), `name` what L is called.
-- R^T L - L = s (b x (b x L) - b x L): a difference that is small with b and does not cancel.
function cayley.turned(define, b, s, L, name)
  local bL = cayley.each(define, "b" .. name, vec.cross(b, L))
  return vec.scale(define("s", s), vec.sub(vec.cross(b, bL), bL))
end

-- The quaternion along p
function cayley.unit(define, p)
  p = cayley.each(define, "p", p)
  local n = define("n", expr.lift(1) / expr.sqrt(p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2 + p[4] ^ 2))
  return vec.scale(n, p)
end

return cayley
