-- midpoint.lua -- the implicit midpoint rule on the rotation group: angular momentum in space is kept by construction.
--
-- With w the rate at the middle of the step, b = h w/2, E the rotation of the unit quaternion along (1, b) (Cayley's map
-- of h w), E' its half, and N the torque at the middle, attitude q E':
--     q1 = q E,   L1 = E^T L + h E'^T N,   (L + L1)/2 = I w + k      L = I w0 + k, k the momentum of rotors
-- so without torque q1 L1 = q L for ANY w, and a torque about an inertial axis leaves the momentum about the others
-- across it.  Multiplied by 1 + b x the third equation is, c = sqrt(1 + b^2),
--     I w = I w0 + (h/2) ((I w + k) x w + c N - b (b.N)/(1 + c))
-- which for N = 0 is the midpoint rule for Euler's equations: energy, a quadratic invariant, is kept, too.  The rule is
-- symmetric (h -> -h undoes a step), of order 2.  A rod cannot take what c N - ... has along its line; there N stands in
-- its place and E'^T N becomes (1 + b x)^-1 N, the same to order 2 and as symmetric.
-- Source: Austin, Krishnaprasad, Wang 1993, J. Comput. Phys. 107, 105; Hairer, Lubich, Wanner, Geometric Numerical
-- Integration (2nd ed.), IV.8 and VII.5.  The half rotation and the factor c are derived above.
--
-- Newton from w = w0, the derivative of N through the attitude to leading order in h.  Without torque f, f_i = I^-1
-- (I w x w), is quadratic with |c_i| <= 1 in principal axes, |f'(w)| <= sqrt(2) |w|, |f| <= |w|^2/sqrt(2): by Kantorovich's
-- theorem it converges for h |w| <= 1/sqrt(2), for every body, and four iterations reach (1/9)^16 for h |w| <= 0.35.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"
local stages = require "generator.methods.stages"

local midpoint = { name = "midpoint", order = 2,
  about = "implicit midpoint rule on the rotation group, keeps L (and a free body's energy), order 2, fixed step" }

local h, q, w = state.h, state.q, state.w
local axes = { "x", "y", "z" }
local none = { expr.zero, expr.zero, expr.zero }

-- The unknown: the rate at the middle of the step.
local middle = vec.map(axes, function(a) return state.sym("mid" .. a) end)
midpoint.middle = "mid"

-- Why the method cannot step this scene; nil if it can.
local function refusal(m)
  if not m.has.rates then return "the body does not turn" end
  if m.has.position then return "the body moves through space, and this method turns bodies about a fixed point" end
  if m.frame then return "the base frame turns" end
  for _, e in ipairs(m.record.effects) do
    if #e.states > 0 then return e.kind .. " has states of its own, which this method does not solve for" end
  end
  return nil
end

-- Definitions of a group, with names that no constant of the model has.
local function definer(m, g)
  return function(name, e)
    if e.kind == "num" or e.kind == "sym" then return e end
    while m.by_name[name] do name = name .. "_" end
    g.defs[#g.defs + 1] = { name = name, expr = e }
    return expr.sym(name, 8)
  end
end

local function each(define, name, v)
  return vec.map(v, function(e, i) return define(name .. (#v == 4 and i == 1 and "w" or axes[i - #v + 3]), e) end)
end

-- Torque of all effects at the middle and the rotors' momentum; nil and why if that is not constant.
local function acting(m, at)
  local N, k, names = none, none, { t = true }
  for _, s in ipairs(m.states) do names[s.name] = true end
  local c = context.of(m)
  c.L = function() return vec.apply(equations.inertia(m), w) end
  for _, e in ipairs(m.record.effects) do
    local own = context.with(c, e)
    if e.spec.torque then N = vec.add(N, e.spec.torque(e.a, own)) end
    local held = e.spec.momentum and e.spec.momentum(e.a, own) or none
    for i = 1, 3 do
      if not expr.constant(held[i], names) then return nil, e.kind .. "'s angular momentum is not constant" end
    end
    k = vec.add(k, held)
  end
  return vec.map(N, function(e) return calculus.substitute(e, at) end), k
end

-- I^-1 ((I w + k) x w + N) at the middle, written without definitions.
local function rates(m, N, k)
  local g = equations.euler(m, vec.add(N, vec.cross(k, w)))
  local map = {}
  for i = 1, 3 do map[w[i]] = middle[i] end
  return vec.map(g.outs, function(e) return calculus.substitute(equations.inline({ g }, e), map) end)
end

-- I^-1 v; for a rod, of what is across its line.
local function solved(m, v)
  local s = m.structure
  if s.rod then v = vec.sub(v, vec.scale(vec.dot(s.k, v) / s.k2, s.k)) end
  local g, still = equations.euler(m, v), {}
  for i = 1, 3 do still[w[i]] = expr.zero end
  return vec.map(g.outs, function(e) return calculus.substitute(equations.inline({ g }, e), still) end)
end

local function free(N) return N[1] == expr.zero and N[2] == expr.zero and N[3] == expr.zero end

-- b, c and the attitude at the middle, as a group with what they are called.
local function turn(m, N, with_attitude)
  local g = { why = "half of the step's rotation, (1, b) with b = h w/2; c = |(1, b)|", defs = {}, outs = {} }
  local define = definer(m, g)
  local b = each(define, "b", vec.scale(define("hh", h / 2), middle))
  local s = define("bb", 1 + vec.dot(b, b))
  local c, at = nil, {}
  if not free(N) then
    c = define("c", expr.sqrt(s))
    if with_attitude then
      local e = define("e", expr.lift(1) / expr.sqrt(2 * (s + c))) -- |(1 + c, b)|^2 = 2 c (1 + c)
      g.why = g.why .. "; attitude at the middle, q (1 + c, b)/|..|"
      local half = { define("ew", e * (1 + c)), define("ex", e * b[1]), define("ey", e * b[2]), define("ez", e * b[3]) }
      at = each(define, "qm", vec.qmul(q, half))
    end
  end
  return g, { b = b, s = s, c = c, q = at }
end

local function cofactor(A, i, j)
  local a, b, c, d = i % 3 + 1, (i + 1) % 3 + 1, j % 3 + 1, (j + 1) % 3 + 1
  return A[a][c] * A[b][d] - A[a][d] * A[b][c]
end

-- One Newton iteration, `mid` to `next`.
local function iteration(m, N, k, zero)
  local g, r = turn(m, N, m.has.attitude)
  local b, hh = r.b, expr.sym(g.defs[1].name, 8)
  if free(N) then g.why = "half of the step" end
  local define
  local forced, at = none, {}
  for i = 1, 3 do at[w[i]] = middle[i] end
  for i = 1, #r.q do at[q[i]] = r.q[i] end
  at[state.t] = state.t + hh
  local torque = vec.map(N, function(e) return calculus.substitute(e, at) end)
  local list = { g }
  if not free(N) then
    local t = { why = "torque at the middle" .. (m.structure.rod and "" or ", times c across b"), defs = {}, outs = {} }
    define = definer(m, t)
    local named = each(define, "N", torque)
    forced = torque
    if not m.structure.rod then
      local along = define("along", vec.dot(b, named) / (1 + r.c))
      forced = vec.sub(vec.scale(r.c, named), vec.scale(along, b))
    end
    list[2] = t
  end
  local residual = { why = "F = w - w0 - (h/2) f(w)", defs = {}, outs = {} }
  define = definer(m, residual)
  local f, plain = rates(m, forced, k), rates(m, torque, k)
  local F = {}
  for i = 1, 3 do
    F[i] = zero[state.names.rates[i]] and expr.zero or middle[i] - w[i] - hh * f[i]
  end
  F = each(define, "F", F)
  local newton = { why = "Newton: w - D^-1 F, D the derivative of F; a torque turns with the attitude, dq = (h/4) q (0, dw)", defs = {}, outs = {} }
  if free(N) or not m.has.attitude then newton.why = "Newton: w - D^-1 F, D the derivative of F" end
  define = definer(m, newton)
  local J = {}
  for i = 1, 3 do
    J[i] = {}
    for j = 1, 3 do
      local one = { expr.zero, expr.zero, expr.zero, expr.zero }
      one[j + 1] = expr.one
      local d = calculus.diff(plain[i], middle[j])
      for a, change in ipairs(#r.q > 0 and vec.qmul(r.q, one) or {}) do
        d = d + calculus.diff(plain[i], r.q[a]) * (hh / 2) * change
      end
      local e = (i == j and expr.one or expr.zero) - hh * d
      J[i][j] = F[i] == expr.zero and (i == j and expr.one or expr.zero) or define("D" .. axes[i] .. axes[j], e)
    end
  end
  local C = {}
  for i = 1, 3 do
    C[i] = {}
    for j = 1, 3 do C[i][j] = define("A" .. axes[i] .. axes[j], cofactor(J, i, j)) end
  end
  local over = define("over", expr.lift(1) / (J[1][1] * C[1][1] + J[1][2] * C[1][2] + J[1][3] * C[1][3]))
  for j = 1, 3 do
    local sum = C[1][j] * F[1] + C[2][j] * F[2] + C[3][j] * F[3]
    newton.outs[j] = { array = "next", index = j, expr = F[j] == expr.zero and middle[j] or middle[j] - over * sum }
  end
  list[#list + 1], list[#list + 2] = residual, newton
  return list
end

-- The step once the rate at the middle is known.
local function finish(m, N, k, zero)
  local g, r = turn(m, N, m.has.attitude)
  local b, hh, at = r.b, expr.sym(g.defs[1].name, 8), {}
  for i = 1, 3 do at[w[i]] = middle[i] end
  for i = 1, #r.q do at[q[i]] = r.q[i] end
  at[state.t] = state.t + hh
  local momentum = { why = "L1 - L: L turned back by the step's rotation" .. (free(N) and "" or
    ", and the impulse of the torque"), defs = {}, outs = {} }
  local define = definer(m, momentum)
  local L = each(define, "L", vec.add(vec.apply(equations.inertia(m), w), k))
  local bL = each(define, "bL", vec.cross(b, L))
  local change = vec.scale(define("s", 2 / r.s), vec.sub(vec.cross(b, bL), bL))
  if not free(N) then
    local T = each(define, "N", vec.map(N, function(e) return calculus.substitute(e, at) end))
    local bN = each(define, "bN", vec.cross(b, T))
    if m.structure.rod then
      change = vec.add(change, vec.scale(define("sN", h / r.s), vec.add(vec.sub(T, bN), vec.scale(vec.dot(b, T), b))))
    else
      local impulse = vec.sub(vec.scale(define("over", expr.lift(1) / (1 + r.c)), vec.cross(b, bN)), bN)
      change = vec.add(change, vec.add(vec.scale(h, T), vec.scale(define("sN", h / r.c), impulse)))
    end
  end
  change = each(define, "dL", change)
  local list = { g, momentum, { why = "w1 = w + I^-1 (L1 - L)", defs = {}, outs = {} } }
  for i, e in ipairs(solved(m, change)) do
    local name = state.names.rates[i]
    if not zero[name] then list[3].outs[#list[3].outs + 1] = { array = "x", state = name, expr = w[i] + e } end
  end
  if m.has.attitude then
    local a = { why = "q1 = q (1, b)/|q (1, b)|", defs = {}, outs = {} }
    define = definer(m, a)
    local p = each(define, "p", vec.qmul(q, { expr.one, b[1], b[2], b[3] }))
    local n = define("n", expr.lift(1) / expr.sqrt(p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2 + p[4] ^ 2))
    for i, name in ipairs(state.names.attitude) do a.outs[i] = { array = "x", state = name, expr = n * p[i] } end
    list[4] = a
  end
  return list
end

-- {iteration = groups, finish = groups, count = iterations}, or nil and why not.
function midpoint.program(eq)
  local m = eq.model
  local why = refusal(m)
  if why then return nil, why end
  local N, k = acting(m, {})
  if not N then return nil, k end
  local zero = stages.conserved(eq)
  return { iteration = iteration(m, N, k, zero), finish = finish(m, N, k, zero), count = free(N) and 4 or 6 }
end

return midpoint
