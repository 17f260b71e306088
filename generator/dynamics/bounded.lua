-- bounded.lua -- the rates' equation of a free or torque-bounded body as numbers, and how large the rates can become.
--
--     w' = b + A w + I^-1 (I w x w) + B u,   low <= u <= high
-- for effects that do not depend on the attitude: control, a torque in body axes that is constant or linear in inputs,
-- linear damping, a rotor.  b, A and B are read from the scene's own equations, which are polynomials of degree two in
-- w and linear in what the limits leave of u: differences of their values at rational numbers are exact.  About
-- principal axes E (rows), moments I_k, the rest is c_k w_j w_l with c_k = (I_j - I_l)/I_k.  A scene that is none
-- of these is refused by the name of what makes it so.
--
-- The bound: where no torque feeds the motion (b = 0, no input, w.I A w <= 0 for every w), 2 T = w.I w never grows, so
-- w_i^2 <= 2 T (I^-1)_ii; with A = 0, |L| is constant too, w_i^2 <= L^2 (I^-2)_ii.  Both are convex, so their largest
-- values over the declared range are at its corners.  With a torque the declared range is the law.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local jacobi = require "generator.mass.jacobi"
local inputs = require "generator.dynamics.inputs"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"

local bounded = {}

local BITS = 200
local axes = { "x", "y", "z" }

bounded.needs = { { path = "the step", needs = "attitude and rates of a body that is no rod, with control, torques " ..
  "in body axes that are constant or linear in limited inputs, constant damping and rotors; ranges of the rates" } }

local known = { control = true, torque = true, damping = true, rotor = true }

local function short(e) return (string.gsub(e.kind, "^effect%.", "")) end

-- Is the component constant, or linear in what the limits leave of the inputs?
local function linear(m, e)
  local map, is = {}, {}
  for i, s in ipairs(m.inputs) do
    is[i] = expr.sym("within " .. s.name, motion.rank)
    map[s.value] = is[i]
  end
  e = calculus.substitute(e, map)
  for _, sym in ipairs(is) do
    local slope = calculus.diff(e, sym)
    if not motion.free(slope) then return false end
    e = calculus.substitute(e, { [sym] = expr.zero })
  end
  return motion.free(e)
end

local most_inputs = 8 -- each has a bit of what a step returns, of 16

-- Why the scene has no such equation: line, rule and what it got; nil if it has.
local function refusal(m, ranges)
  local control
  for _, s in ipairs(m.inputs) do
    if not s.low then
      return s.line, "takes inputs with limits: effect.control{ max = }, input(name, unit, { min =, max = })",
        s.label .. " without"
    end
  end
  if #m.inputs > most_inputs then
    return m.inputs[#m.inputs].line, "takes at most " .. most_inputs .. " inputs", string.format("%d", #m.inputs)
  end
  for _, e in ipairs(m.record.effects) do
    local name = short(e)
    if not known[name] then
      local own = e.states and e.states[1] and " (states of an effect's own, a wheel's speed, have no scaling)" or ""
      return e.line, "takes effect.control, effect.torque in body axes, effect.damping and effect.rotor" .. own, e.kind
    elseif name == "torque" and not e.a.body then
      return e.line, "takes a torque in body axes: one in inertial axes depends on the attitude", "effect.torque"
    elseif name == "torque" and not (linear(m, e.a.body[1]) and linear(m, e.a.body[2]) and linear(m, e.a.body[3])) then
      return e.line, "takes a torque that is constant or linear in inputs: what else varies can be an input",
        "effect.torque"
    elseif name == "damping" and e.spec.varies_with(e.a) then
      return e.line, "takes a constant damping", "one that varies"
    elseif name == "control" and control then
      return e.line, "takes one effect.control", "a second one"
    end
    if name == "control" then control = e end
  end
  if not m.has.rates or not m.has.attitude then
    return m.record.line, "takes a body with attitude and rates", m.has.rates and "rates alone" or "a point"
  elseif m.has.position then
    return m.record.line, "takes rotation alone, about a fixed point or the centroid", "a position"
  elseif m.structure.rod then
    return m.line, "takes a body with a moment about each axis", "a rod"
  end
  for i, s in ipairs(m.states) do
    if s.kind == "rates" and not (ranges and ranges.states[i]) then
      return m.record.line, "takes its scaling from the declared range of the rates: write ranges = { omega = 5 }, " ..
        "the largest |w_i| in rad/s", ranges and "no range of " .. s.name or "no ranges"
    end
  end
  return nil
end

-- f(w, u) -> the three w' of the scene's own equations, rationals.
-- u must lie within the inputs' limits, which the equations contain.
local function evaluator(m, eq)
  local members, rates = {}, {}
  for _, member in ipairs(m.members) do members[member.sym] = member.e end -- into a table: order is lost anyway
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do
      for i, name in ipairs(state.names.rates) do
        if o.state == name then rates[i] = calculus.substitute(equations.inline(eq.groups, o.expr), members) end
      end
    end
  end
  return function(w, u)
    local map = {}
    for i = 1, 3 do map[state.w[i]] = expr.num(w[i]) end
    for i, s in ipairs(m.inputs) do map[s.sym] = expr.num(u[i]) end
    return vec.map(rates, function(e) return m:number(calculus.substitute(e, map)) end)
  end
end

-- s e_i; of s = 0 the zero vector
local function unit(i, s)
  local v = { R.zero, R.zero, R.zero }
  v[i] = R.new(s)
  return v
end

local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

local function matrix(e) return { { e[1], e[4], e[5] }, { e[4], e[2], e[6] }, { e[5], e[6], e[3] } } end

-- Of a symmetric matrix; cyclic minors have their sign.
local function inverse(S)
  local function minor(i, j)
    local a, b, c, d = i % 3 + 1, (i + 1) % 3 + 1, j % 3 + 1, (j + 1) % 3 + 1
    return S[a][c] * S[b][d] - S[a][d] * S[b][c]
  end
  local det = S[1][1] * minor(1, 1) + S[1][2] * minor(1, 2) + S[1][3] * minor(1, 3)
  local out = {}
  for i = 1, 3 do
    out[i] = {}
    for j = 1, 3 do out[i][j] = minor(j, i) / det end
  end
  return out
end

-- Does w.S w <= 0 hold for all w?  -S has principal minors none of which is negative.
local function takes_energy(S)
  local d = {}
  for i = 1, 3 do
    d[i] = {}
    for j = 1, 3 do d[i][j] = -(S[i][j] + S[j][i]) / R.new(2) end
    if R.sign(d[i][i]) < 0 then return false end
  end
  for i = 1, 3 do
    local j = i % 3 + 1
    if R.sign(d[i][i] * d[j][j] - d[i][j] * d[i][j]) < 0 then return false end
  end
  local det = d[1][1] * (d[2][2] * d[3][3] - d[2][3] * d[2][3]) - d[1][2] * (d[1][2] * d[3][3] - d[2][3] * d[1][3]) +
    d[1][3] * (d[1][2] * d[2][3] - d[2][2] * d[1][3])
  return R.sign(det) >= 0
end

-- The largest 2 T and |L|^2 over the corners of the box.
local function at_corners(I, box)
  local energy, momentum = R.zero, R.zero
  for n = 0, 7 do
    local w = {}
    for i = 1, 3 do w[i] = (n >> (i - 1)) & 1 == 0 and box[i].lo or box[i].hi end
    local L = { dot(I[1], w), dot(I[2], w), dot(I[3], w) }
    local T, L2 = dot(w, L), dot(L, L)
    energy, momentum = T > energy and T or energy, L2 > momentum and L2 or momentum
  end
  return energy, momentum
end

local function root(q) return R.apply("sqrt", BITS, q) end

-- |w_i| at most, three rationals, and the words that say why.
-- Without a feed by the smaller of the two bounds of the head; with one the range itself.
local function limits(r, box, line)
  local out = {}
  local declared = "the range declared in line " .. line .. " of the scene"
  if r.fed then
    for i = 1, 3 do
      local a, b = R.abs(box[i].lo), R.abs(box[i].hi)
      out[i] = a > b and a or b
    end
    return out, declared .. "; a torque may drive the body out of it, which is reported"
  end
  local I, J = matrix(r.tensor), inverse(matrix(r.tensor))
  local energy, momentum = at_corners(I, box)
  for i = 1, 3 do
    local square = energy * J[i][i]
    local other = momentum * dot(J[i], J[i])
    out[i] = root(r.free and other < square and other or square)
  end
  local kept = r.free and "2 T and |L|, which are constant" or "2 T, which never grows"
  return out, kept .. ", at their largest over " .. declared
end

-- c_k = (I_j - I_l)/I_k, zero where it is only what rounding left of it.
local function products(moments)
  local c = {}
  for k = 1, 3 do
    local j, l = k % 3 + 1, (k + 1) % 3 + 1
    c[k] = (moments[j] - moments[l]) / moments[k]
    if R.abs(c[k]) < R.new(2) ^ -60 then c[k] = R.zero end
  end
  return c
end

-- Sets r.b, r.A and the inputs' columns of B in w' = (Euler's products) + b + A w + B u, from values of it, f(w, u).
-- It is quadratic in w, the products being even and zero at w = 0, and affine in each u (refusal has seen to that); so
-- differences are exact: A_j = (f(e_j, u) - f(-e_j, u))/2, B_k = (f(0, u + d e_k) - f(0, u))/d, b = f(0, u) - B u.
-- Inputs stand at a quarter of their range and step by half of it, so that no limit is met.
local function response(m, r, f)
  local within = {}
  r.inputs = {}
  for i, s in ipairs(m.inputs) do
    local low, high = inputs.range(m, s)
    r.inputs[i] = { label = s.label, index = s.index, unit = s.unit, low = low, high = high }
    within[i] = low + (high - low) / R.new(4)
  end
  local there = f(unit(1, 0), within)
  r.b, r.A = { table.unpack(there) }, { {}, {}, {} }
  for j = 1, 3 do
    local up, down = f(unit(j, 1), within), f(unit(j, -1), within)
    for i = 1, 3 do r.A[i][j] = (up[i] - down[i]) / R.new(2) end
  end
  for k, u in ipairs(r.inputs) do
    local other, half = { table.unpack(within) }, (u.high - u.low) / R.new(2)
    other[k] = other[k] + half
    u.response = vec.map(f(unit(1, 0), other), function(x, i) return (x - there[i]) / half end)
    for i = 1, 3 do r.b[i] = r.b[i] - u.response[i] * within[k] end
  end
end

-- Sets r.free (no torque depends on the rates) and r.fed (something may add energy).  T' = w.(S w) + w.I(b + B u) with
-- S = I A, so without b and u the sign of S's symmetric part decides.
local function energy_flow(r)
  local I, S, still = matrix(r.tensor), {}, true
  r.free = true
  for i = 1, 3 do
    S[i] = {}
    for j = 1, 3 do
      S[i][j] = I[i][1] * r.A[1][j] + I[i][2] * r.A[2][j] + I[i][3] * r.A[3][j]
      r.free = r.free and r.A[i][j] == R.zero
    end
    still = still and r.b[i] == R.zero
  end
  r.fed = not (still and #r.inputs == 0 and takes_energy(S))
end

-- What w' is made of, as rationals, or nil after an error in d:
-- {moments, axes (rows, body axes), diagonal, c, b, A, tensor, free, fed, limit, why, inputs}, inputs being a list of
-- {label, index, unit, low, high, response}, response a column of B.
-- job: {diag, model, equations, ranges}
function bounded.of(job)
  local m, d = job.model, job.diag
  local line, rule, got = refusal(m, job.ranges)
  if line then
    d:error(line, "--with q31", rule, got)
    return nil
  end
  local r = { tensor = vec.map(m.inertia, function(e) return m:number(e) end) }
  local zero = R.zero
  r.diagonal = r.tensor[4] == zero and r.tensor[5] == zero and r.tensor[6] == zero
  if r.diagonal then
    r.moments, r.axes = { r.tensor[1], r.tensor[2], r.tensor[3] }, {}
    for i = 1, 3 do r.axes[i] = unit(i, 1) end
  else
    r.moments, r.axes = jacobi.precise(r.tensor, BITS)
  end
  r.c = products(r.moments)
  response(m, r, evaluator(m, job.equations))
  energy_flow(r)
  local box = {}
  for i, s in ipairs(m.states) do
    if s.kind == "rates" then box[s.place] = job.ranges.states[i] end
  end
  r.limit, r.why = limits(r, box, job.ranges.line)
  for i = 1, 3 do
    local w = m:number(m.omega[i])
    if w < box[i].lo or w > box[i].hi then
      d:error(job.ranges.line, "--with q31", "the initial w" .. axes[i] .. " must be within the range of omega",
        string.format("%.17g", R.todouble(w)))
      return nil
    end
  end
  return r
end

return bounded
