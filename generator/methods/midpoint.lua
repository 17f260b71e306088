-- midpoint.lua -- the implicit midpoint rule on the rotation group: angular momentum in space is kept by construction.
--
-- With w the rate at the middle of the step, b = h w/2, E the rotation of the unit quaternion along (1, b) (Cayley's
-- map of h w), E' its half, N the torque at the middle, where the attitude is q E', and d = b/(1 + |(1, b)|), which is
-- to E' what b is to E:
--     A = L + (h/2)(N + d x N),   B = E^T A,   L1 = B + (h/2)(N - d x N),   q1 = q E,   (A + B)/2 = I w + k
-- L = I w0 + k, k the momentum of rotors.  So without torque q1 L1 = q L for ANY w.  The impulse, E^T of the first half
-- and the second one, is h E'^T N: what it gives the momentum in space is h q E' N, so that the component about an axis
-- across the torque is kept (a heavy top's L_z).  The two halves along a body's axis sum to that of h N, and with I
-- symmetric about the axis A and B agree along it: a heavy top's w3 is kept, too.  The last equation is, times 1 + b x,
--     I w = I w0 + (h/2) ((I w + k) x w + N + d x N)
-- which for N = 0 is the midpoint rule for Euler's equations: energy, a quadratic invariant, is kept.  The rule is
-- symmetric (h -> -h undoes a step), of order 2.  The halves are the derivatives of h V at the middle, which is how the
-- middle of a geodesic moves with its ends.  A rod has no momentum along its line: what d x N has there is left out,
-- and L_z then oscillates by O(h^2).  Where inner dissipation turns the axes at W beside w, b = h W/2, and
-- (I w + k) x W stands in the last equation.
-- Source: Austin, Krishnaprasad, Wang 1993, J. Comput. Phys. 107, 105; Hairer, Lubich, Wanner, Geometric Numerical
-- Integration (2nd ed.), IV.8 and VII.5.  The torque's halves are derived above.
--
-- Newton from w = w0, the derivative of N through the attitude to leading order in h.  Without torque f, that is
-- I^-1 (I w x w), is quadratic: in principal axes f_i = c_i w_j w_k with |c_i| <= 1, so |f| <= |w|^2/sqrt(2) and
-- |f'| <= sqrt(2) |w|.  By Kantorovich's theorem it converges for h |w| <= 1/sqrt(2), whatever the body; for h |w| <=
-- 0.35 four iterations reach (1/9)^16 of h |w|^2.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local constancy = require "generator.dynamics.constancy"
local sensitivity = later "generator.dynamics.sensitivity"
local state = require "generator.dynamics.state"
local cayley = require "generator.methods.cayley"

local midpoint = { name = "midpoint", order = 2,
  about = "implicit midpoint rule on the rotation group, keeps L (and a free body's energy), order 2, fixed step",
  needs = { { path = "the step", needs = "nothing moves but attitude and rates: q' = q (0, W)/2, I w' = (I w + k) x " ..
    "W + N with W = w + the slip of inner dissipation, N of attitude, rates and time, k and I constant" } } }

local h, q, w = state.h, state.q, state.w
local definer, each, none = cayley.definer, cayley.each, cayley.none

-- The unknown: the rate at the middle of the step.
local middle = vec.map({ "x", "y", "z" }, function(a) return state.sym("mid" .. a) end)

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

-- The slip at the middle.
-- Effects give it as a function of w.
local function slipped(acts)
  local at = {}
  for i = 1, 3 do at[w[i]] = middle[i] end
  return vec.map(acts.slip, function(e) return calculus.substitute(e, at) end)
end

-- b, c and the attitude at the middle, as a group with what they are called.
local function turn(m, acts)
  local N, with_attitude = acts.N, m.has.attitude
  local g = { why = "half of the step's rotation, (1, b) with b = h w/2; c = |(1, b)|", defs = {}, outs = {} }
  local define = definer(m, g)
  local hh, W = define("hh", h / 2), middle
  if acts.slip then
    g.why = "half of the step's rotation, (1, b) with b = h W/2, W the rate at which the axes turn; c = |(1, b)|"
    W = each(define, "W", vec.add(middle, slipped(acts)))
  end
  local b = each(define, "b", vec.scale(hh, W))
  local s = define("bb", 1 + vec.dot(b, b))
  local c, at = nil, {}
  if not none(N) then
    c = define("c", expr.sqrt(s))
    if with_attitude then
      local e = define("e", expr.lift(1) / expr.sqrt(2 * (s + c))) -- |(1 + c, b)|^2 = 2 c (1 + c)
      g.why = g.why .. "; attitude at the middle, q (1 + c, b)/|..|"
      local part = { define("ew", e * (1 + c)), define("ex", e * b[1]), define("ey", e * b[2]), define("ez", e * b[3]) }
      at = each(define, "qm", vec.qmul(q, part))
    end
  end
  return g, { b = b, s = s, c = c, q = at }
end

-- N + d x N, by definitions
-- d = b/(1 + c), c = |(1, b)|: Cayley's vector of half the rotation.
local function half(define, r, N)
  local turned = vec.cross(r.b, N)
  if none(turned) then return N end
  local d = define("d", expr.lift(1) / (1 + r.c))
  return vec.add(N, vec.scale(d, turned))
end

-- What the rate in the middle solves: groups, F with its definitions, the parts of the turn, the torque at the middle.
local function equation(m, acts, zero)
  local N, k = acts.N, acts.k
  local g, r = turn(m, acts)
  local hh = expr.sym(g.defs[1].name, 8)
  if none(N) then g.why = "half of the step" end
  local define
  local forced, at = N, {}
  for i = 1, 3 do at[w[i]] = middle[i] end
  for i = 1, #r.q do at[q[i]] = r.q[i] end
  at[state.t] = state.t + hh
  local torque = vec.map(N, function(e) return calculus.substitute(e, at) end)
  local list = { g }
  if not none(N) then
    local t = { why = "torque at the middle, N + d x N with d = b/(1 + c)", defs = {}, outs = {} }
    define = definer(m, t)
    torque = each(define, "N", torque)
    forced = half(define, r, torque)
    list[2] = t
  end
  local residual = { why = "F = w - w0 - (h/2) f(w)", defs = {}, outs = {} }
  define = definer(m, residual)
  local function rates(v) -- at the middle
    local moved = {}
    for i = 1, 3 do moved[w[i]] = middle[i] end
    v = vec.add(v, vec.cross(k, w))
    if acts.slip then v = vec.add(v, vec.cross(vec.add(vec.apply(cayley.inertia(m), w), k), acts.slip)) end
    return vec.map(cayley.rates(m, v), function(e) return calculus.substitute(e, moved) end)
  end
  local f, plain = rates(forced), rates(vec.map(N, function(e) return calculus.substitute(e, at) end))
  local F = {}
  for i = 1, 3 do
    F[i] = none(N) and not acts.slip and zero[state.names.rates[i]] and expr.zero or middle[i] - w[i] - hh * f[i]
  end
  list[#list + 1] = residual
  return list, each(define, "F", F), r, plain, hh
end

-- One Newton iteration, `mid` to `next`.
-- D = dF/dw with the torque's change through the attitude to leading order: it speeds Newton up, the solution is that
-- of F = 0 whatever D is.
local function iteration(m, acts, zero)
  local list, F, r, plain, hh = equation(m, acts, zero)
  local newton = { why = "Newton: w - D^-1 F, D the derivative of F", defs = {}, outs = {} }
  if #r.q > 0 then newton.why = newton.why .. "; a torque turns with the attitude, dq = (h/4) q (0, dw)" end
  local change = cayley.newton(definer(m, newton), F, function(i, j)
    local one = { expr.zero, expr.zero, expr.zero, expr.zero }
    one[j + 1] = expr.one
    local d = calculus.diff(plain[i], middle[j])
    for a, dq in ipairs(#r.q > 0 and vec.qmul(r.q, one) or {}) do
      d = d + calculus.diff(plain[i], r.q[a]) * (hh / 2) * dq
    end
    return hh * d
  end)
  for j = 1, 3 do newton.outs[j] = { array = "next", index = j, expr = middle[j] - change[j] } end
  list[#list + 1] = newton
  return list
end

-- The step once the rate at the middle is known.
local function finish(m, acts, zero)
  local N, k = acts.N, acts.k
  local g, r = turn(m, acts)
  local b, hh, at = r.b, expr.sym(g.defs[1].name, 8), {}
  for i = 1, 3 do at[w[i]] = middle[i] end
  for i = 1, #r.q do at[q[i]] = r.q[i] end
  at[state.t] = state.t + hh
  local momentum = { why = none(N) and "L1 - L: L turned back by the step's rotation" or
    "L1 - L: A, the momentum after half of the impulse, turned back by the step's rotation, and the impulse", defs = {},
    outs = {} }
  local define = definer(m, momentum)
  local A, change = vec.add(vec.apply(cayley.inertia(m), w), k), { expr.zero, expr.zero, expr.zero }
  if not none(N) then
    local T = each(define, "N", vec.map(N, function(e) return calculus.substitute(e, at) end))
    A = vec.add(A, vec.scale(hh, cayley.across(m, half(define, r, T))))
    change = vec.scale(h, T)
  end
  A = each(define, none(N) and "L" or "A", A)
  change = vec.add(change, cayley.turned(define, b, 2 / r.s, A, none(N) and "L" or "A"))
  change = each(define, "dL", change)
  local list = { g, momentum, { why = "w1 = w + I^-1 (L1 - L)", defs = {}, outs = {} } }
  for i, e in ipairs(cayley.solved(m, change)) do
    local name = state.names.rates[i]
    if not zero[name] then list[3].outs[#list[3].outs + 1] = { array = "x", state = name, expr = w[i] + e } end
  end
  if m.has.attitude then
    local a = { why = "q1 = q (1, b)/|q (1, b)|", defs = {}, outs = {} }
    define = definer(m, a)
    for i, e in ipairs(cayley.unit(define, vec.qmul(q, { expr.one, b[1], b[2], b[3] }))) do
      a.outs[i] = { array = "x", state = state.names.attitude[i], expr = e }
    end
    list[4] = a
  end
  return list
end

-- The step's transition matrix at the solution w = mid of F(mid, x) = 0: by the theorem on implicit functions
-- d mid/dx = -D^-1 dF/dx with D = dF/d mid, all of it here (Newton may do with less); then the chain rule through the
-- last part.  by, array: the same for the states into F, or for the inputs into G.  Returns groups.
local function transition(m, acts, zero, by, array)
  local list, F = equation(m, acts, zero)
  local map, columns, known, taken, groups = {}, {}, {}, {}, {}
  for j, name in ipairs { "midx", "midy", "midz" } do columns[j] = { name = name, sym = middle[j] } end
  for _, s in ipairs(by) do columns[#columns + 1] = s end
  for i in ipairs(columns) do known[i] = {} end
  for i, g in ipairs(list) do -- by names of its own, for the last part has some of them again
    local defs = {}
    for n, d in ipairs(g.defs) do
      local name = d.name .. "_0"
      defs[n] = { name = name, expr = calculus.substitute(d.expr, map) }
      map[expr.sym(d.name, 8)] = expr.sym(name, 8)
    end
    groups[i] = { why = g.why .. "; and its derivatives", defs = sensitivity.follow(defs, columns, known, taken),
      outs = {} }
  end
  local g = { why = "by how much the middle moves with the " .. (array == "F" and "state: -D^-1 dF/dx" or
    "input: -D^-1 dF/du") .. ", D = dF/dmid", defs = {}, outs = {} }
  local define, D = definer(m, g), {}
  for i = 1, 3 do
    F[i] = F[i] == expr.zero and middle[i] - w[i] or calculus.substitute(F[i], map)
    D[i] = {}
    for j = 1, 3 do D[i][j] = define("D" .. i .. j .. "_0", calculus.diff(F[i], middle[j], known[j])) end
  end
  local solved, moved = cayley.inverse(define, D), sensitivity.nothing(by)
  for c, s in ipairs(by) do
    local change = solved(vec.map(F, function(e) return calculus.diff(e, s.sym, known[c + 3]) end))
    for j, e in ipairs(each(define, "mid_" .. s.name, change)) do moved[c][middle[j]] = -e end
  end
  for _, d in ipairs(g.defs) do taken[d.name] = true end
  groups[#groups + 1] = g
  for _, more in ipairs((sensitivity.tangent(m, finish(m, acts, zero), moved, taken, by, array))) do
    groups[#groups + 1] = more
  end
  return groups
end

-- {iteration = groups, finish = groups, count = iterations, and with options.jacobians transition = groups, and where
-- there are inputs transition_u = groups}, or nil and why not.
function midpoint.program(eq, options)
  local m = eq.model
  local why = refusal(m)
  if why then return nil, why end
  local acts = cayley.acting(m)
  if acts.changing then return nil, acts.changing end
  why = cayley.missed(eq)
  if why then return nil, why end
  local zero = constancy.conserved(eq)
  return { iteration = iteration(m, acts, zero), finish = finish(m, acts, zero),
    count = none(acts.N) and not acts.slip and 4 or 6,
    transition = options.jacobians and transition(m, acts, zero, m.states, "F") or nil,
    transition_u = options.jacobians and eq.inputs and transition(m, acts, zero, m.inputs, "G") or nil }
end

return midpoint
