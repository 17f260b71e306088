-- equations.lua -- the equations of motion of a scene, in the least form its body's structure allows.
--
--     q' = q (0, w)/2                                        kinematics (Hamilton product)
--     I w' + w x I w = N                                      Euler's equations (Goldstein 5.39)
-- The structure of I (mass/principal.lua) decides what is written down:
--     sphere      I w' = N: no gyroscopic term at all
--     symmetric   I = alpha 1 + beta k k^T/k^2:   w' = -Omega-terms: (beta/(alpha k^2)) (k.w) (k x w), so the
--                 component of w along k has no equation of its own
--     diagonal    three quotients of principal moments
--     full        L = I w,  w' = I^-1 (N + L x w), structural zeros of I and of its inverse vanishing
-- The centre of mass (dynamics/moving.lua) and the states that effects declare follow.
-- An equation group is {why, where, defs = {{name, expr}}, outs = {{state, expr}}}.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local attitude = require "generator.dynamics.attitude"
local contact = require "generator.dynamics.contact"
local context = require "generator.dynamics.context"
local fold = require "generator.dynamics.fold"
local moving = require "generator.dynamics.moving"
local state = require "generator.dynamics.state"
local stages = require "generator.stages"

local equations = {}

local axis_name = { "x", "y", "z" }
local tidy = ratio.tidy

local function place(m, line) return line and (string.match(m.file, "[^/]*$") .. ":" .. line) or nil end

-- Is k a coordinate axis?  Returns its number.
local function coordinate(k)
  local found
  for i = 1, 3 do
    if k[i] ~= expr.zero then
      if found then return nil end
      found = i
    end
  end
  return found
end
equations.coordinate = coordinate

equations.inertia = context.inertia

-- I w as named definitions, unless an entry is trivial.
local function momentum(m)
  local Iw = vec.apply((context.now(m)), state.w)
  local defs, L = {}, {}
  for i = 1, 3 do
    if Iw[i] == expr.zero then
      L[i] = expr.zero
    else
      defs[#defs + 1] = { name = "L" .. axis_name[i], expr = Iw[i] }
      L[i] = expr.sym("L" .. axis_name[i], 7)
    end
  end
  return L, defs
end
equations.momentum = momentum

-- The torque of an effect; one that holds angular momentum h of its own (a rotor) adds -(h' + w x h).
local function torque_of(m, e, c)
  local zero = { expr.zero, expr.zero, expr.zero }
  local N = e.spec.torque and e.spec.torque(e.a, c) or zero
  local h = e.spec.momentum and e.spec.momentum(e.a, c)
  if not h then return N end
  local rate = e.spec.momentum_rate and e.spec.momentum_rate(e.a, c) or zero
  if #e.states > 0 and not e.spec.momentum_rate then
    local change = e.spec.derivative(e.a, c)
    rate = vec.map(h, function(x)
      local sum = expr.zero
      for _, s in ipairs(e.states) do sum = sum + calculus.diff(x, s.sym) * change[s.key] end
      return sum
    end)
  end
  return vec.sub(vec.sub(N, rate), vec.cross(m.has.rates and state.w or zero, h))
end

equations.torque_of = torque_of

-- Sum of the torques of all effects in body axes, each effect one group of definitions N1x .. ; and what they use.
-- gyric: three principal moments of the body alone, so that what effects say of the rates' products goes there.
local function torques(m, gyric)
  local total, groups = { expr.zero, expr.zero, expr.zero }, {}
  local need_L = false
  local provisional, constant = fold.constants()
  local c = context.of(m, constant)
  c.L = function()
    if m.carried ~= m.inertia or m.locked ~= m.inertia then return vec.apply(c.tensor(), state.w) end
    need_L = true
    return (momentum(m))
  end
  for _, e in ipairs(m.record.effects) do
    local own = context.with(c, e)
    local products = gyric and e.spec.products and e.spec.products(e.a, own)
    local N = products or torque_of(m, e, own)
    local group = { why = string.gsub(e.kind, "^effect%.", "") .. ": " .. (e.spec.term or context.formula(e)),
      where = place(m, e.line),
      defs = {}, outs = {} }
    for i = 1, 3 do
      local n = N[i]
      if n ~= expr.zero and n.kind ~= "num" and n.kind ~= "sym" then
        local number = #m.record.effects > 1 and "_" .. #groups + 1 or ""
        if #groups >= 9 then number = number .. "_" end -- Nx_12 would be Nx_1 at stage 2
        local name = (products and "P" or "N") .. axis_name[i] .. number
        while fold.taken(m, provisional, name) do name = name .. "_" end -- a constant of the effect may be called so
        group.defs[#group.defs + 1] = { name = name, expr = n }
        n = expr.sym(name, 7)
      end
      if products then
        groups.products = groups.products or { expr.zero, expr.zero, expr.zero }
        groups.products[i] = groups.products[i] + n
      else
        total[i] = total[i] + n
      end
    end
    if products then group.why = group.why .. "; what it adds to the products of the rates" end
    if #group.defs > 0 then groups[#groups + 1] = group end
  end
  groups.provisional, groups.constant = provisional, constant
  return total, groups, need_L
end

-- The function that replaces the definitions' names in an expression by their expressions: for zero tests,
-- derivatives and reports.
function equations.inlined(groups)
  local map = {}
  for _, g in ipairs(groups) do
    for _, d in ipairs(g.defs) do map[expr.sym(d.name, 7)] = calculus.substitute(d.expr, map) end
  end
  return calculus.substitution(map)
end

-- The same for one expression.
function equations.inline(groups, e) return equations.inlined(groups)(e) end

-- e in the parameters alone: derived constants replaced by what they stand for, so that k.(r x d) = 0 is seen for r
-- along k.
local function resolved(m, e, provisional)
  local map = {}
  for sym, p in pairs(provisional) do map[sym] = p.e end -- into a table: order is lost anyway
  for _, member in ipairs(m.members) do map[member.sym] = member.e end
  return calculus.substitute(e, map)
end

-- n/I as fold.over has it; axis: number of the component that n is.
local function over(m, groups, n, I, axis)
  return fold.over(m, groups.provisional, groups, n, I, axis_name[axis], equations.inline)
end

-- builders[kind](m, N, groups, d, I) -> {why, defs, outs = the three expressions of w'}, nil after an error in d.  N:
-- the torque by the names that the torques' groups define; groups.provisional: constants that may still be folded.
local builders = {}

function builders.sphere(m, N, groups)
  local alpha = m:constant("I1", m.carrier.alpha, "moment of inertia about any axis, kg m^2")
  return { why = "Euler: I w' = N, every axis is a principal one", defs = {},
    outs = vec.map(N, function(n, i) return over(m, groups, n, alpha, i) end) }
end

-- (I_jj - I_kk)/I_ii in the body's parts; nil when it has none.
local function quotient(m, j, k, i)
  return m.parts and m.carried == m.inertia and m.parts:difference(j, k) / equations.inertia(m)[i] or nil
end

-- I^-1 = 1/alpha + (1/axial - 1/alpha) k k^T/k^2; of a rod 1/alpha across k, along which the rate is kept.
function builders.symmetric(m, N, groups, d)
  local s = m.carrier
  local k, w = s.k, state.w
  local axis = coordinate(k)
  local across = axis and axis % 3 + 1
  local c = m:constant("cs", (s.axial - s.alpha) / (s.alpha * s.k2), "(I3 - I1)/I1" ..
    (s.k2 == expr.one and "" or " / k^2"), false, axis and quotient(m, axis, across, across))
  local kk = axis and k or vec.map(k, function(x, i)
    return m:constant("k" .. axis_name[i], x, "direction of the symmetry axis")
  end)
  local defs, Omega = {}, expr.sym("Omega", 7)
  local g = { why = "Euler, symmetric top: w' = Omega k x w, Omega = (I3 - I1)/I1 k.w", defs = defs }
  if s.rod then g.why = "Euler, rod: w' = Omega k x w, Omega = -k.w; the rate along k is kept" end
  local spin = c * vec.dot(kk, w)
  local turning = vec.cross(kk, w)
  g.outs = { expr.zero, expr.zero, expr.zero }
  if spin ~= expr.zero then
    defs[1] = { name = "Omega", expr = spin }
    g.outs = vec.map(turning, function(x) return Omega * x end)
  end
  local plain = vec.map(N, function(n) return n == expr.zero end)
  if plain[1] and plain[2] and plain[3] then return g end
  -- I^-1 N = N/alpha + (1/axial - 1/alpha) k (k.N)/k^2
  local along = vec.dot(k, N)
  if s.rod and not ratio.iszero(resolved(m, equations.inline(groups, along), groups.provisional)) then
    d:error(m.line, "body", "is a rod: no torque may act along its line, where it has no moment of inertia")
    return nil
  end
  local alpha = m:constant("I1", s.alpha, "moment of inertia across the symmetry axis, kg m^2")
  if axis then
    local I3 = s.rod and expr.one or m:constant("I3", s.axial, "moment of inertia about the symmetry axis, kg m^2")
    for i = 1, 3 do
      if not (s.rod and i == axis) then g.outs[i] = g.outs[i] + over(m, groups, N[i], i == axis and I3 or alpha, i) end
    end
    return g
  end
  for i = 1, 3 do g.outs[i] = g.outs[i] + N[i] / alpha end
  if not s.rod then
    local extra = m:constant("e", (s.alpha - s.axial) / (s.alpha * s.axial * s.k2), "(1/I3 - 1/I1)/k^2, 1/(kg m^2)")
    defs[#defs + 1] = { name = "Nk", expr = extra * vec.dot(kk, N) }
    for i = 1, 3 do g.outs[i] = g.outs[i] + kk[i] * expr.sym("Nk", 7) end
  end
  return g
end

function builders.diagonal(m, N, groups)
  local I, w = m.carried, state.w
  local why = "Euler, principal axes: I1 w1' = (I2 - I3) " .. (groups.products and "(w2 w3 + P1)" or "w2 w3") ..
    (#m.record.effects > (groups.products and 1 or 0) and " + N1" or "") .. ", and cyclic"
  local g = { why = why, defs = {}, outs = {} }
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    local c = m:constant("c" .. i, (I[j] - I[k]) / I[i], string.format("(I%d - I%d)/I%d", j, k, i), false,
      quotient(m, j, k, i))
    g.outs[i] = groups.products and c * (w[j] * w[k] + groups.products[i]) or c * w[j] * w[k]
    if N[i] ~= expr.zero then
      g.outs[i] = g.outs[i] + over(m, groups, N[i], m:constant("I" .. vec.entry[i], I[i], "moment of inertia " ..
        vec.entry[i] .. ", kg m^2"), i)
    end
  end
  return g
end

-- Terms of the longest sum in e.
local function largest_sum(e)
  local n = e.kind == "add" and #e or 0
  for _, c in ipairs(expr.children(e)) do n = math.max(n, largest_sum(c)) end
  return n
end

-- With parts that move: (I + D) w' = N + L x w, the term -D' w being among the torques.
function builders.varying(_, N, _, _, I)
  local g = { why = "Euler, moving parts: L = (I + D) w, (I + D) w' = N + L x w", defs = {} }
  local function named(prefix, v, letters)
    return vec.map(v, function(e, i)
      if e.kind == "num" or e.kind == "sym" then return e end
      g.defs[#g.defs + 1] = { name = prefix .. letters[i], expr = e }
      return expr.sym(prefix .. letters[i], 7)
    end)
  end
  local L = named("L", vec.apply(I, state.w), axis_name)
  local S = named("S", I, vec.entry)
  local n = vec.add(N, vec.cross(L, state.w))
  if I[4] == expr.zero and I[5] == expr.zero and I[6] == expr.zero then
    g.outs = vec.map(n, function(e, i) return e / S[i] end)
    return g
  end
  local function one(name, e) return named(name, { e }, { "" })[1] end
  g.outs = vec.solve(S, named("n", n, axis_name), one)
  g.why = g.why .. ", by S = L D L^T"
  return g
end

-- I^-1 as six constants, adjugate over determinant, each entry cancelled where that is affordable.
function builders.full(m, N)
  local L, defs = momentum(m)
  local adj, det = vec.adjugate(m.carried)
  local named, whole = vec.adjugate(context.carried(m))
  -- expanded, the determinant of a simple body is a sum of positive terms; of a complicated one it is unreadable
  local small = not m.parts and largest_sum(tidy(det)) <= 24
  local expanded = small and ratio.over(adj, det)
  local J = vec.map(adj, function(e, n)
    local entry = m:constant("J" .. vec.entry[n], expanded and expanded[n] or e / det,
      "inverse of the tensor, " .. vec.entry[n] .. ", 1/(kg m^2)", true, not expanded and tidy(named[n] / whole) or nil)
    -- where the determinant is beyond the type the quotient is 0: a body that would never accelerate
    if n <= 3 then m:positive(entry) end
    return entry
  end)
  for n, entry in ipairs(J) do m:inverse(entry, J, n) end
  local n = vec.add(N, vec.cross(L, state.w))
  local names = {}
  for i = 1, 3 do
    defs[#defs + 1] = { name = "n" .. axis_name[i], expr = n[i] }
    names[i] = expr.sym("n" .. axis_name[i], 7)
  end
  local torque = #m.record.effects > 0 and "N + " or ""
  local which = m.carried ~= m.inertia and "; I without the wheels' own moments" or ""
  return { why = "Euler: L = I w, n = " .. torque .. "L x w, w' = I^-1 n" .. which, defs = defs, outs = vec.apply(J,
    names) }
end

-- Euler's equations for a torque of any form (along a rod's line it must be zero): one group, outs the rates of w.
-- Moving parts have their tensor here, and their torque -D' w in N.
function equations.euler(m, N)
  local I, moves = context.now(m)
  return builders[moves and "varying" or m.carrier.kind](m, N, { provisional = {} }, nil, I)
end

-- Euler's equations with the torques of the effects, appended to list; nil after an error.
local function turning(d, m, list)
  local I, moves = context.now(m)
  local kind = moves and "varying" or m.carrier.kind
  local plane = contact.of(m)
  local rolls = plane and plane.a.law == "rolling" -- its equations have torques, and no products of the rates
  local N, groups, need_L = torques(m, not rolls and kind == "diagonal" and m.locked == m.inertia and
    m.carried == m.inertia)
  local L_defs = {}
  if need_L then -- before the torques that use it
    L_defs = select(2, momentum(m))
    table.insert(groups, 1, { why = "angular momentum L = I w, body axes", defs = L_defs, outs = {} })
  end
  local euler, rest
  -- builders.full and .varying begin with L again
  local function free()
    local g = builders[kind](m, N, groups, d, I)
    if g and (kind == "full" or kind == "varying") then -- which begins with the same definitions
      for _ = 1, #L_defs do table.remove(g.defs, 1) end
    end
    return g
  end
  if plane then
    euler, rest = contact.turning(m, plane, groups.constant, N, groups, free)
  else
    euler = free()
  end
  if not euler then return nil end
  euler.where = place(m, m.line)
  for i, n in ipairs(state.names.rates) do euler.outs[i] = { state = n, expr = euler.outs[i] } end
  if plane then groups[#groups + 1] = rest else groups[#groups + 1] = euler end
  -- what stands behind the torques now has provisional constants, too
  fold.settle(m, groups.provisional, groups)
  list.touch = plane and contact.read(table.remove(groups))
  if need_L and not fold.uses(groups, L_defs) then table.remove(groups, 1) end
  for _, g in ipairs(groups) do list[#list + 1] = g end
  return true
end

-- w' as the groups have it, or nil.
local function rates_of(groups)
  for _, g in ipairs(groups) do
    if g.outs[1] and g.outs[1].state == "wx" then return vec.map(g.outs, function(o) return o.expr end) end
  end
  return nil
end

local of_attitude = { qw = true, qx = true, qy = true, qz = true }

-- The equations of m, a pool of constants on the model: groups, and coupled, which tells whether the attitude's
-- equation or another one needs the attitude at every stage.  Reports what cannot be (torque along a rod) and returns
-- nil then.
function equations.of(d, m)
  local groups = {}
  if m.has.attitude then groups[1] = attitude.group(m, place) end
  if m.has.rates and not turning(d, m, groups) then return nil end
  if m.has.position then
    for _, g in ipairs(moving.groups(m, groups[1])) do
      g.where = place(m, g.line)
      groups[#groups + 1] = g
    end
  end
  local c = context.of(m)
  c.dw = rates_of(groups) or c.dw
  for _, e in ipairs(m.record.effects) do
    local change = #e.states > 0 and (e.spec.touches and groups.touch.rates or
      e.spec.derivative(e.a, context.with(c, e)))
    local g = { why = string.gsub(e.kind, "^effect%.", "") .. ": its own states", where = place(m, e.line), defs = {},
      outs = {} }
    for i, s in ipairs(e.states) do g.outs[i] = { state = s.name, expr = change[s.key] } end
    if #g.outs > 0 then groups[#groups + 1] = g end
  end

  local coupled = m.frame ~= nil and m.has.attitude
  for i = m.has.attitude and 2 or 1, #groups do
    for _, list in ipairs { groups[i].defs, groups[i].outs } do
      for _, x in ipairs(list) do
        if not expr.constant(x.expr, of_attitude) then coupled = true end
      end
    end
  end
  return stages.made("equations", { groups = groups, coupled = coupled, turn = m.has.attitude and groups[1].turn,
    inputs = #m.inputs > 0, free = #m.record.effects == 0, touch = groups.touch or false, model = m })
end

-- The same equations with a pool of constants of their own, for who asks for more.
function equations.fork(eq)
  local own = stages.copy(eq)
  own.model = eq.model:fork()
  return stages.close(own)
end

-- The same equations with twice the bits in their numbers; nil where no number was rounded, so that all are exact.
function equations.finer(eq)
  return eq.model.rounded and equations.of(nil, eq.model:fork(true)) or nil -- nothing is left to be reported
end

return equations
