-- split.lua -- splitting: the exact flow of the free body alternates with kicks that hold the attitude.
--
--     A (drift)  q, L of the free body, r += tau v, t += tau      B (kick)  L += tau N(q, r, t),  v += tau F/m
-- A step is the palindrome A(a1 h) B(b1 h) A(a2 h) ... A(a1 h); torques of attitude and time alone make B exact.  The
-- free body is made of rotations, which keep L in inertial axes (Dullweber, Leimkuhler, McLachlan 1997, J. Chem. Phys.
-- 107, 5840; McLachlan, Quispel 2002, Acta Numerica 11, 341; Fasso 2003, J. Comput. Phys. 189, 527):
--     sphere      one, about L by |L| tau/I
--     symmetric   two that commute, about L by |L| tau/I1 and about k by (1 - I3/I1) (k.w) tau: exact
--     diagonal    Kahan's map with coefficients that depend on step, energy and |L|, then two rotations: order 10,
--                 energy and L to rounding (templates/steppers/split_diagonal.c; Hairer, Vilmart 2006, J. Phys. A
--                 39, 13225)
--     full        T = L^2/(2 Ia) + Lb^2/2 (1/Ib - 1/Ia) + Lc^2/2 (1/Ic - 1/Ia), Ia the middle one: the first commutes
--                 with the others, rotations about the principal axes b and c in body axes, which NAME_init finds and a
--                 palindrome of their own composes (`inner`).  p = L/Ia is made of w and w of p by the steps of I/Ia =
--                 U^T D U forwards and backwards: each undoes the other but for its roundings, where a rounded inverse
--                 would shrink or swell the rates a little at every step
-- A constant rotor along the axis adds its momentum to the body's there.
-- Coefficients, the first half of each palindrome: Blanes, Moan 2002, J. Comput. Appl. Math. 142, 313: S10 (order 6);
-- McLachlan 1995, BIT 35, 258: order (8, 4), whose error is h^8 in the first power of the torque, h^4 in the second.
-- Digits beyond the published ones solve the order conditions (tests/methods/split.t).  Why these: docs/methods.md.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"
local claim = require "generator.methods.claim"

local split = {}

-- {a = drifts, b = kicks, c = the time of each kick} of a palindrome from its first half; what is left to make the sums
-- 1 goes into the middle, which belongs to the drifts if middle = "a".
local function palindrome(middle, a, b)
  local list, half = { a = {}, b = {} }, { a = a, b = b }
  for _, name in ipairs { "a", "b" } do
    local own, left, out = half[name], R.one, list[name]
    for i, x in ipairs(own) do
      out[i] = R.lift(x)
      left = left - R.lift(2) * out[i]
    end
    if name == middle then
      out[#out + 1] = left
    else
      out[#out + 1], out[#out + 2] = left / R.lift(2), left / R.lift(2)
    end
    for i = #own, 1, -1 do out[#out + 1] = out[i] end
  end
  local t = R.zero
  list.c = {}
  for i in ipairs(list.b) do
    t = t + list.a[i]
    list.c[i] = t
  end
  return list
end

split.coefficients = {
  strang = palindrome("b", {}, {}),
  S10 = palindrome("a", { "0.0502627644003922", "0.413514300428348280764209253255138114149686",
      "0.0450798897943974211608542852757026623955981", "-0.188054853819572834204124900735074375035274",
      "0.541960678450781754723292263234705650176817" },
    { "0.148816447901042589908187280537323712859617", "-0.132385865767782209619702251588944972760032",
      "0.0673076046921852373718361905790506189051134", "0.432666402578172088198748915901779274874621" }),
  M84 = palindrome("b", { "0.0753469602698928884165278036834744643726527",
      "0.517916854688256782300773978496315644323847" },
    { "0.190225939373676619245230762738453897461204", "0.846524070443526257055080544646775834177114" }),
}

local function short(e) return (string.gsub(e.kind, "^effect%.", "")) end

-- Names of what a kick changes: the states of rates and velocity.
local of_rates = {}
for _, kind in ipairs { "rates", "velocity" } do
  for _, name in ipairs(state.names[kind]) do of_rates[name] = true end
end

-- What of the scene's effects cannot be a kick, in words, and whether some depend on rates.
local function refused(m, order)
  if m.frame then return "the base frame turns: its terms depend on the velocity" end
  local slowed = false
  for _, e in ipairs(m.record.effects) do
    if #e.states > 0 then return short(e) .. " has a state of its own, which no kick changes exactly" end
    if e.spec.turn then return short(e) .. " turns the attitude beside the rates, which no kick of the rates does" end
    local c = context.with(context.dry(m), e)
    for _, deed in ipairs { "torque", "force" } do
      for _, x in ipairs(e.spec[deed] and e.spec[deed](e.a, c) or {}) do
        if not expr.constant(x, of_rates) then
          if order > 2 then
            return short(e) .. " depends on the rates: order " .. order .. " has steps back in time, where what " ..
              "damps would drive (split2 takes it)"
          end
          slowed = true
        end
      end
    end
  end
  return nil, slowed
end

-- The momentum of the constant rotors as c times k; k is theirs if it is not given.  nil if it points elsewhere.
local function rotor(m, k)
  local h = { expr.zero, expr.zero, expr.zero }
  for _, e in ipairs(m.record.effects) do
    local own = e.spec.momentum and e.spec.momentum(e.a, context.with(context.dry(m), e))
    if own then h = vec.map(vec.add(h, own), ratio.tidy) end
  end
  if h[1] == expr.zero and h[2] == expr.zero and h[3] == expr.zero then return expr.zero, k end
  if not k then return expr.one, h end
  for _, x in ipairs(vec.cross(h, k)) do
    if not ratio.iszero(x) then return nil end
  end
  return ratio.tidy(vec.dot(h, k) / vec.dot(k, k)), k
end

-- The drift: {kind, constants = {name -> expr}, axis = 1..3}; or nil and why not.
-- constants: local names in the template -> derived constants of the model.  A rotor along the axis changes the rate
-- about it alone: (I3 w3 + h)/I1 - w3 = c w3 + h/I1.
local function drift(m)
  local s = m.structure
  if not m.has.rates then return { kind = "point", constants = {} } end
  if s.kind == "sphere" or s.kind == "symmetric" then
    local h, k = rotor(m, s.kind == "symmetric" and s.k or nil)
    if not h then return nil, "the rotor is not along the symmetry axis: the free flow is then elliptic" end
    if not k then return { kind = "sphere", constants = {} } end
    local out = { kind = "oblique", axis = equations.coordinate(k), constants = {} }
    if s.kind == "sphere" then s = { alpha = s.alpha, axial = s.alpha, k2 = expr.one } end
    local c = out.constants
    c.c = m:constant("cs", (s.axial - s.alpha) / (s.alpha * s.k2), "(I3 - I1)/I1")
    c.h = m:constant("hs", h * (out.axis and k[out.axis] or expr.one) / s.alpha,
      "momentum of the rotor along the axis, divided by I1, rad/s")
    if out.axis then
      out.kind = "axis"
    else
      for i, name in ipairs { "x", "y", "z" } do
        c["k" .. name] = m:constant("k" .. name, k[i], "direction of the symmetry axis")
      end
    end
    return out
  end
  if rotor(m) ~= expr.zero then
    return nil, "the free flow of an asymmetric body with a rotor is not made of rotations"
  end
  if s.kind ~= "diagonal" then return { kind = "full", constants = {} } end
  local I = m.inertia
  local out = { kind = "diagonal", constants = {} }
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    local difference = m.parts and m.parts:difference(j, k)
    out.constants["a" .. i] = m:constant("c" .. i, (I[j] - I[k]) / I[i],
      string.format("(I%d - I%d)/I%d", j, k, i), false, difference and difference / equations.inertia(m)[i])
  end
  for _, i in ipairs { 1, 3 } do
    out.constants["j" .. i] = m:constant("g" .. i, I[i] / I[2], string.format("I%d/I2", i))
  end
  return out
end

local w_zero = {}
for _, w in ipairs(state.w) do w_zero[w] = expr.zero end

local function turns(g) return #g.outs > 0 and string.match(g.outs[1].state, "^w[xyz]$") ~= nil end

-- Groups of the kick, outs {state, expr} of the rates of w and v; and the states that have one.  What is left of the
-- equations of Euler at w = 0 is the torque's part.
local function kick(eq, slowed)
  local groups, kicked = {}, {}
  for _, g in ipairs(eq.groups) do
    local put = { why = g.why, where = g.where, defs = {}, outs = {} }
    local function at_rest(e)
      return (turns(g) or not slowed) and calculus.substitute(e, w_zero) or e
    end
    for _, d in ipairs(g.defs) do put.defs[#put.defs + 1] = { name = d.name, expr = at_rest(d.expr) } end
    for _, o in ipairs(g.outs) do
      local e = at_rest(o.expr)
      if of_rates[o.state] and e ~= expr.zero then
        put.outs[#put.outs + 1] = { state = o.state, expr = e }
        kicked[#kicked + 1] = o.state
      end
    end
    if turns(g) then put.why = "the torque's part of Euler's equations" end
    -- the attitude's group is the drift's; one of definitions alone may be needed by others
    if not (g.outs[1] and g.outs[1].state == "qw") and (#put.outs > 0 or #g.outs == 0) then
      groups[#groups + 1] = put
    end
  end
  return groups, kicked
end

-- Nil where drift and kick are the scene's equations: q' = q (0, w)/2, r' = v, I w' = (I w + h) x w with h the rotors',
-- beside what the kick changes, which knows no rates unless it is `slowed` by them; else why not.
local function missed(eq, kicks, slowed)
  local m = eq.model:fork() -- what the proof asks for is not the scene's
  local claimed, kick_rates = claim.turning(), claim.rates(kicks)
  local function put(name, e)
    local own = kick_rates[name] or expr.zero
    claimed[name] = (slowed or expr.constant(own, of_rates)) and e + own or nil
  end
  for i = 1, 3 do
    put(state.names.position[i], state.v[i])
    put(state.names.velocity[i], expr.zero)
  end
  if m.has.rates then
    local g = equations.euler(m, vec.cross(context.held(m), state.w))
    local whole = claim.rates { { defs = g.defs, outs = vec.map(g.outs, function(e, i)
      return { state = state.names.rates[i], expr = e }
    end) } }
    for _, name in ipairs(state.names.rates) do put(name, whole[name]) end
  end
  local name = claim.miss(m.states, claim.rates(eq.groups), claimed, m)
  return name and "the rate of " .. name .. " is more than free motion and a kick" or nil
end

-- The program of a method for emit/split.lua, or nil and why there is none.
local function program(method)
  return function(eq)
    local m = eq.model
    local why, slowed = refused(m, method.order)
    if why then return nil, why end
    local free, not_free = drift(m)
    if not free then return nil, not_free end
    local groups, kicked = kick(eq, slowed)
    why = missed(eq, groups, slowed)
    if why then return nil, why end
    if slowed and rotor(m) ~= expr.zero then return nil, "a rotor and what depends on the rates, together" end
    local k = split.coefficients
    return { order = method.order, drift = free, groups = groups, kicked = kicked, slowed = slowed,
      outer = k[method.outer], inner = k[method.inner], has = m.has, source = method.source }
  end
end

local step = "every equation is free motion, q' = q (0, w)/2, r' = v, I w' = (I w + h) x w with a constant h of " ..
  "rotors, and a kick: of rates and velocity, by attitude, position, time and inputs"

local needs = {
  { path = "drift of a sphere", needs = "three equal moments, no rotor" },
  { path = "drift about an axis", needs = "symmetric, the rotors along the axis; or a sphere with rotors" },
  { path = "drift by Kahan's map", needs = "no products of inertia, no rotor" },
  { path = "drift about principal axes", needs = "any tensor, no rotor" },
}

-- outer, inner: names of palindromes, of the step and of the drift of a body with three moments.
local function method(order, outer, inner, about, source)
  local m = { name = "split" .. order, order = order, outer = outer, inner = inner, template = "split", about = about,
    source = source }
  m.needs = { { path = "the step", needs = step .. (order == 2 and "; also by rates and velocity, without a rotor" or
    "") }, table.unpack(order == 2 and needs or {}) }
  m.program = program(m)
  return m
end

split.methods = {
  method(2, "strang", "strang", "exact free flow and kicks in turn, order 2 (Strang); no energy drift in long runs",
    "Strang 1968, SIAM J. Numer. Anal. 5, 506"),
  method(4, "M84", "S10", "exact free flow and kicks in turn, order 4, and 8 in weak torques (McLachlan)",
    "McLachlan 1995, BIT 35, 258: order (8, 4)"),
  method(6, "S10", "S10", "exact free flow and kicks in turn, order 6 (Blanes and Moan)",
    "Blanes, Moan 2002, J. Comput. Appl. Math. 142, 313: S10"),
}

return split
