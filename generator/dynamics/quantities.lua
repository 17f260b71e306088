-- quantities.lua -- what the emitted code can be asked, as function descriptions.
--
-- The formulas are here, once, in the lecture's notation (description.lua: what a description is); steppers come from
-- methods/.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local state = require "generator.dynamics.state"
local frames = require "generator.dynamics.frames"
local context = require "generator.dynamics.context"
local description = require "generator.dynamics.description"
local equations = require "generator.dynamics.equations"

local quantities = {}

local comp = { "x", "y", "z" }

local array, symbols, outs, group = description.array, description.symbols, description.outs, description.group

function quantities.initial(m)
  local list = {}
  for i, s in ipairs(m.states) do
    list[i] = { array = "x", state = s.name, expr = m:constant(s.name .. "0", s.initial, "initial " .. s.name .. ", " ..
      s.unit) }
  end
  return { name = "initial", args = { "m", "xo" }, doc = { "The scene's initial state." },
    groups = { group(m.has.position and "initial state" or "initial attitude and rates", {}, list) } }
end

function quantities.mass(m)
  local com = vec.map(m.com, function(e, i)
    local form = m.parts and m.parts.com[i] - m.origin[i]
    return m:constant("R" .. comp[i], e, "centre of mass " .. comp[i] .. " from the origin of rotation, m", false, form)
  end)
  local mass = context.mass(m)
  return { name = "mass", args = { "m", array("com", 3, true) }, result = true,
    doc = { "Mass, kg; com: the centre of mass from the origin of rotation, body axes, m." },
    groups = { group("mass and centre of mass", {}, { { array = "com", index = 0, expr = com[1] },
      { array = "com", index = 1, expr = com[2] }, { array = "com", index = 2, expr = com[3] },
      { result = true, expr = mass } }) } }, mass, com
end

function quantities.inertia(m)
  return { name = "inertia", args = { "m", array("I", 6, true) },
    doc = { "The tensor of inertia about the origin of rotation, entries xx yy zz xy xz yz (off-diagonal",
      "entries are minus the products of inertia), body axes, kg m^2." },
    groups = { group("I_ij = sum m (r^2 d_ij - r_i r_j)", {}, outs("I", equations.inertia(m))) } }
end

-- With the parts that move: the tensor of the state.
function quantities.inertia_now(m)
  return { name = "inertia_now", args = { "m", "x", array("I", 6, true) },
    doc = { "The tensor about the origin of rotation with the moving parts as they are at the state's clock, same six",
      "entries; NAME_inertia and what follows from it are the body's own without them." },
    groups = { group("I + D of the state", {}, outs("I", context.of(m).tensor())) } }
end

-- I'_ij = I_ij + M (a^2 d_ij - a_i a_j) - M (2 a.R d_ij - a_i R_j - a_j R_i)
local function shifted(I, M, Rc, a)
  local entries = {}
  for n, p in ipairs(vec.pair) do
    local i, j = p[1], p[2]
    local e = -a[i] * a[j] + a[i] * Rc[j] + a[j] * Rc[i]
    if i == j then e = e + vec.dot(a, a) - 2 * vec.dot(a, Rc) end
    entries[n] = I[n] + M * e
  end
  return entries
end
quantities.shifted = shifted

-- On the diagonal a_i (a_i - 2 R_i) for a_i^2 - 2 a_i R_i: one product, and no difference of squares.
function quantities.inertia_at(m)
  local _, mass, com = quantities.mass(m)
  local a, I = symbols("a", 3), equations.inertia(m)
  local function s2(i, j) return a[i] * (a[i] - 2 * com[i]) + a[j] * (a[j] - 2 * com[j]) end
  local list = {}
  for n, p in ipairs(vec.pair) do
    local i, j = p[1], p[2]
    if i == j then
      local k, l = i % 3 + 1, (i + 1) % 3 + 1
      list[n] = I[n] + mass * s2(k, l)
    else
      list[n] = I[n] + mass * (a[i] * com[j] + a[j] * (com[i] - a[i]))
    end
  end
  return { name = "inertia_at", args = { "m", array("a", 3), array("I", 6, true) },
    doc = { "The tensor about the point a (from the origin of rotation, body axes, m), same six entries." },
    groups = { group("I'_ij = I_ij + M (a^2 d_ij - a_i a_j) - M (2 a.R d_ij - a_i R_j - a_j R_i)", {},
      outs("I", list)) } }
end

-- "L = I w" with what rotors and wheels hold, of which kinds there are; field: of their specs.
local function said(m, start, field)
  local seen = {}
  for _, e in ipairs(m.record.effects) do
    local own = e.spec[field]
    if own and not seen[own] then start = start .. " + " .. own end
    if own then seen[own] = true end
  end
  return start
end

-- The tensor of these equations, where it is not the body's.
local function which(m) return m.carried ~= m.inertia and "; I without the wheels' own moments" or "" end

-- T of the turning: expression, definitions that it uses, and its law in words.
function quantities.kinetic(m)
  if not m.has.rates then return expr.zero, {}, "" end
  local w, I = state.w, (context.now(m))
  local diagonal = I[4] == expr.zero and I[5] == expr.zero and I[6] == expr.zero
  if diagonal then
    return vec.dot(I, vec.map(w, function(x) return x ^ 2 end)) / 2, {},
      "T = (I1 w1^2 + I2 w2^2 + I3 w3^2)/2, principal axes"
  end
  local L, defs = equations.momentum(m)
  return vec.dot(w, L) / 2, defs, "T = w.L/2 (L = I w)"
end

-- What NAME_energy is, where nothing moves the body; V: the potential.
local function energy_doc(m, V, wheels)
  if V == expr.zero then
    return { wheels and "Kinetic energy of the body and its wheels, J." or "Kinetic energy T = w.I w/2, J." }
  end
  local kinds, known = {}, { ["effect.gravity"] = "V = 0 with the centre of mass at the height of the origin.",
    ["effect.plane"] = "V = 0 with the centre of mass at the inertial origin, through which the plane passes." }
  for _, e in ipairs(m.record.effects) do
    local part = e.spec.potential and e.spec.potential(e.a, context.with(context.dry(m), e))
    if part and part ~= expr.zero then kinds[#kinds + 1] = e.kind end
  end
  return { "Energy T + V, J; " .. (#kinds == 1 and known[kinds[1]] or "V is the sum of the effects' potentials.") }
end

function quantities.energy(m)
  local T, defs, why = quantities.kinetic(m)
  local V, doc = context.potential(m), nil
  if m.has.position then
    local v2 = vec.dot(state.v, state.v)
    T, why = T + context.mass(m) * v2 / 2, why .. (why == "" and "T = " or " + ") .. "m v^2/2"
  end
  T = T + context.energy(m, context.of(m), "kinetic")
  local whole = said(m, why, "has")
  local wheels = whole ~= why
  why = whole .. which(m)
  if m.has.position or m.frame then
    doc = m.frame and { "Kinetic energy relative to the frame, the effects' potential and the frame's own, J: Jacobi's",
      "integral where the frame turns at a constant rate." } or { "Energy T + V, J; V = 0 at the origin." }
  end
  doc = doc or energy_doc(m, V, wheels)
  return { name = "energy", args = { "m", "x" }, result = true, doc = doc,
    groups = { group(why .. (V ~= expr.zero and ";  V from the effects" or ""), defs,
      { { result = true, expr = T + V } }) } }
end

-- T + V - n L_z of fields that turn about inertial z at the rate n (dynamics/conserved.lua).
function quantities.jacobi_integral(m, n)
  local f = quantities.energy(m)
  local energy, V = f.groups[1], context.energy(m, context.of(m), "turning")
  local L = context.momentum(m)
  local rate = m:constant("nJ", n, "rate at which the field turns, rad/s")
  energy.outs[1].expr = energy.outs[1].expr + V - rate * vec.matvec(vec.rotation(state.q), L)[3]
  energy.why = energy.why .. ";  and of the field, less n L_z"
  return { name = "jacobi_integral", args = { "m", "t", "x" }, result = true,
    doc = { "Jacobi's integral T + V - n L_z, J, constant where the field turns about inertial z at the rate n: V is",
      "the potential of the field at the time t and of what else acts; |q| = 1." }, groups = f.groups }
end

function quantities.momentum_body(m)
  local L = context.momentum(m)
  return { name = "momentum_body", args = { "m", "x", array("L", 3, true) },
    doc = { "Angular momentum about the origin of rotation, body axes, kg m^2/s." },
    groups = { group(said(m, "L = I w", "holds") .. which(m), {}, outs("L", L)) } }
end

function quantities.momentum(m)
  local L, defs = equations.momentum(m)
  L = vec.add(L, context.held(m))
  return { name = "momentum", args = { "m", "x", array("L", 3, true) },
    doc = { "Angular momentum about the origin of rotation, inertial axes, kg m^2/s; |q| = 1." },
    groups = { group("L = I w in body axes" .. which(m), defs, {}),
      group(said(m, "turned to inertial axes: q L q*, L = I w", "holds"), {}, outs("L",
        vec.matvec(vec.rotation(state.q), L))) } }
end

-- What turns in the body and so takes part in its motion from within: wheels and rotors, moving parts, energy sinks.
local function inner(spec) return spec.momentum or spec.varies or spec.turn end

-- The torque from outside, N = I w' + w x L less what acts from within; of a state where something in the body has
-- one.
function quantities.torque(m)
  local stateful = false
  for _, e in ipairs(m.record.effects) do stateful = stateful or inner(e.spec) and #e.states > 0 end
  local w, dw = stateful and state.w or symbols("w", 3), symbols("dw", 3)
  local I = (context.now(m))
  local L, Lp, defs, within = vec.apply(I, w), {}, {}, { expr.zero, expr.zero, expr.zero }
  local c, at = context.of(m), {}
  for i = 1, 3 do at[state.w[i]] = w[i] end
  for _, e in ipairs(m.record.effects) do
    if inner(e.spec) then within = vec.add(within, equations.torque_of(m, e, context.with(c, e))) end
  end
  within = vec.map(within, function(e) return calculus.substitute(e, at) end)
  for i = 1, 3 do
    Lp[i] = L[i]
    if L[i] ~= expr.zero then
      defs[#defs + 1] = { name = "L" .. comp[i], expr = L[i] }
      Lp[i] = expr.sym("L" .. comp[i], 7)
    end
  end
  local holds = within[1] ~= expr.zero or within[2] ~= expr.zero or within[3] ~= expr.zero
  local doc = { "The torque from outside that makes the body turn with rates w and accelerations dw, body axes, N m",
    "(the torque equation read backwards: N = dL/dt + w x L in the body frame)" .. (holds and "," or ".") }
  if holds then doc[3] = "while what turns or moves in the body does what the scene says." end
  if stateful then doc[1] = string.gsub(doc[1], "rates w and", "the rates of x and") end
  local args = { "m", array("w", 3), array("dw", 3), array("N", 3, true) }
  if stateful then args = { "m", "t", "x", "u", array("dw", 3), array("N", 3, true) } end
  return { name = "torque", args = args, doc = doc, stateful = stateful,
    groups = { group("L = I w" .. which(m), defs, {}), group("N = I w' + w x L" ..
      (holds and ", less the torques from within" or ""), {},
      outs("N", vec.sub(vec.add(vec.apply(I, dw), vec.cross(w, Lp)), within))) } }
end

-- The attitude's group with halves of the rates, which are three products where halves of the sums are four.
local function halved(m, g)
  local map, defs = {}, {}
  for i, w in ipairs(state.w) do
    local name = "h" .. w.name
    while m.by_name[name] do name = name .. "_" end
    defs[i] = { name = name, expr = w / 2 }
    map[w] = 2 * expr.sym(name, 8)
  end
  return { why = g.why, where = g.where, defs = defs, outs = vec.map(g.outs, function(o)
    return { state = o.state, expr = calculus.substitute(o.expr, map) }
  end) }
end

-- The groups of the equations, with results in dx.
function quantities.rhs(eq)
  local groups = {}
  for i, g in ipairs(eq.groups) do
    if i == 1 and eq.model.has.attitude and #g.defs == 0 and g.outs[1].state == "qw" then g = halved(eq.model, g) end
    local list = vec.map(g.outs, function(o) return { array = "dx", state = o.state, expr = o.expr } end)
    groups[i] = { why = g.why, where = g.where, defs = g.defs, outs = list }
  end
  return { name = "rhs", args = { "m", "t", "x", "u", "dx" },
    doc = { "Equations of motion: dx = dx/dt at time t, state x, input u.  dx must not overlap x." }, groups = groups }
end

-- What the plane does to a body that touches it, and where the body is.
function quantities.contact(eq)
  local groups = {}
  for i, g in ipairs(eq.groups) do
    if i > 1 then groups[#groups + 1] = group(g.why, g.defs, {}) end
  end
  local results = outs("com", eq.touch.com)
  for _, o in ipairs(outs("velocity", eq.touch.velocity)) do results[#results + 1] = o end
  results[7] = { result = true, expr = context.mass(eq.model) * eq.touch.push }
  local doc = { "The reaction N of the plane, N: the force along its normal.  The motion is that of a body",
    "on the plane as long as N > 0.  com, velocity: of the centre of mass, inertial axes, m and m/s." }
  for _, e in ipairs(eq.model.record.effects) do
    if e.spec.touches and e.a.surface.disc then
      table.move({ "A disc that lies flat touches the plane in a line.  There is no motion from there: N is not a",
        "number then, nor are the rates and what a step makes of x; a run from there returns -1 and", "leaves x. " ..
        " So ask for !(N > 0) before a step: it is true where contact is lost, and for a flat disc." },
        1, 3, #doc + 1, doc)
    end
  end
  groups[#groups + 1] = group("the reaction, and the centre of mass above the contact point", {}, results)
  return { name = "contact", args = { "m", "t", "x", "u", array("com", 3, true), array("velocity", 3, true) },
    result = true, doc = doc, groups = groups }
end

-- One step by a method that is written as equation groups, as the function `name`.
function quantities.step(m, eq, method, name)
  local groups = {}
  local steps, divides = method.groups(eq, function(e, words) return m:derived(e, words) end)
  for i, g in ipairs(steps) do
    local list = vec.map(g.outs, function(o) return { array = "x", state = o.state, expr = o.expr } end)
    groups[i] = { why = g.why, where = g.where, defs = g.defs, outs = list }
  end
  local accuracy = method.order and
    string.format("  The error of a run falls as h^%d where the motion is smooth.", method.order) or ""
  local longest = method.longest and m.has.attitude and m.has.rates and
    "  Steps with h |w| above " .. method.longest .. " lose |q|." or ""
  return { name = name, args = { "m", "t", "x!", "u", "h" },
    doc = { "One step of the " .. method.title .. ": x goes from time t to t + h, the input u",
      "held.  q must be a unit quaternion (to a few per cent: it is brought back to |q| = 1)." .. longest .. accuracy },
    groups = groups,
    -- 4/(3 h) must stay finite; a step shorter than the smallest normal number moves nothing that could be seen
    guard = divides and "h" or nil }
end

local most_nodes = 300 -- beyond that e is no sum of products of tensor and inverse

-- Has e more nodes than n, as a tree?
-- Ends after n nodes, for as a tree a shared e can be astronomical.
local function large(e, n)
  local function left(x, n_)
    for _, c in ipairs(expr.children(x)) do
      if n_ < 0 then return n_ end
      n_ = left(c, n_)
    end
    return n_ - 1
  end
  return left(e, n) < 0
end

-- e without the terms c*x of the states x whose number c is only what rounding left, for in `fine`, with twice the
-- bits, it is another one: products of tensor and inverse cancel (a lamina has Izz = Ixx + Iyy), their roundings do
-- not.
local function without_roundings(m, e, fine)
  if e == fine or large(e, most_nodes) then return e end
  for _, s in ipairs(m.states) do
    local c, d = calculus.diff(e, s.sym), calculus.diff(fine, s.sym)
    if c.kind == "num" and d.kind == "num" and c ~= d and
      (d == expr.zero or R.log2(c.value - d.value) > R.log2(d.value) - 64) then
      e = calculus.substitute(e, { [s.sym] = expr.zero })
    end
  end
  return e
end

function quantities.jacobian(eq)
  local m, groups = eq.model, {}
  local n = #m.states
  local fine = equations.finer(eq)
  local inlined, finer = equations.inlined(eq.groups), fine and equations.inlined(fine.groups)
  local row, slope = {}, {}
  for i, s in ipairs(m.states) do
    row[s.name], slope[i] = i, calculus.by(s.sym)
    groups[i] = group("derivatives of d" .. s.name .. "/dt", {}, {})
  end
  for g, eg in ipairs(eq.groups) do
    for j, o in ipairs(eg.outs) do
      local e, i = inlined(o.expr), row[o.state]
      local f = fine and finer(fine.groups[g].outs[j].expr)
      for k = 1, n do
        local d = slope[k](e)
        if f then d = without_roundings(m, d, slope[k](f)) end
        groups[i].outs[k] = { array = "J", index = (i - 1) * n + k - 1, expr = d }
      end
    end
  end
  return { name = "jacobian", args = { "m", "t", "x", "u", array("J", n * n, true, { "NX", "NX" }) },
    doc = { "Jacobian of the equations of motion, row major, NX x NX: J[i*NX + k] = d(dx[i])/d(x[k])." },
    groups = groups }
end

function quantities.rate()
  local w, A, dA = symbols("w", 3), symbols("a", 3), symbols("da", 3)
  return { name = "rate", args = { array("w", 3), array("a", 3), array("da", 3), array("out", 3, true) },
    doc = { "Rate of change of the vector a in the inertial frame, from its rate da in the body frame;",
      "all in body axes, w the body's rates." },
    groups = { group("dA/dt (inertial) = dA/dt (body) + w x A", {}, outs("out", frames.rate(w, A, dA))) } }
end

function quantities.acceleration()
  local w, dw, r, v, a = symbols("w", 3), symbols("dw", 3), symbols("r", 3), symbols("v", 3), symbols("a", 3)
  local f = frames.acceleration(w, dw, r, v, a)
  local total, results = {}, {}
  for _, term in ipairs { "coriolis", "euler", "centripetal" } do
    for _, o in ipairs(outs(term, f[term])) do results[#results + 1] = o end
  end
  for i = 1, 3 do total[i] = a[i] + f.coriolis[i] + f.euler[i] + f.centripetal[i] end
  for _, o in ipairs(outs("total", total)) do results[#results + 1] = o end
  return { name = "acceleration", args = { array("w", 3), array("dw", 3), array("r", 3), array("v", 3), array("a", 3),
    array("coriolis", 3, true), array("euler", 3, true), array("centripetal", 3, true), array("total", 3, true) },
    doc = { "Inertial acceleration of a point at r that moves with velocity v and acceleration a relative to the",
      "body: the terms 2 w x v, w' x r, w x (w x r) apart, and total = a + all three; all in body axes." },
    groups = { group("total = a + 2 w x v + w' x r + w x (w x r)", {}, results) } }
end

local most_particles = 64 -- beyond that the sum is no code to read; w.I w/2 gives the same number

-- nil: the body is no set of particles, or they are too many.
function quantities.particle_energy(m)
  if not m.body.particles or #m.body.pieces > most_particles then return nil end
  local rows = {}
  for n, p in ipairs(m.body.pieces) do
    local r = vec.map(vec.sub(p.com, m.origin), ratio.tidy)
    rows[n] = { m:constant("m_" .. n, p.mass, "mass of particle " .. n .. ", kg") }
    for i = 1, 3 do
      rows[n][i + 1] = m:constant(comp[i] .. "_" .. n, r[i], comp[i] .. " of particle " .. n .. " from the origin, m")
    end
  end
  return { name = "particle_energy", args = { "m", "x" }, result = true,
    doc = { "Kinetic energy of the particles by its definition, the sum of m v^2/2 with v = w x r, J." },
    groups = { group("T = sum m (w x r)^2/2", {},
      { { result = true, expr = frames.particle_energy(rows, state.w) } }) } }
end

return quantities
