-- contact.lua -- the equations of a body that touches a plane (effects/plane.lua).
--
-- All vectors in body axes: g = `up`, the plane's normal; r = `arm`, from the centre of mass to the contact point; y
-- the point of the ellipsoid, r = centre - y - rim g; turning = w x r.  With g' = g x w the rate of the contact's place
-- is
--     k = r' + w x r = w x (centre - y) - y',   y' of effects/surface.lua
-- in which the rim cancels.  u = U, G the gravity, Omega the rate of the plane:
--     rolling   [I/m + r.r 1 - r r^T] w' = (I/m w) x w + N/m + r x f,   f = Omega g x (u + r') - w x k - G
--     else      w' = w0' + nu b,  w0' that of the torques alone,  b = m I^-1 (r x h),  h = g - share v,
--               nu = N/m = (-g.G - g.(w x k) - w0'.s)/(1 + b.s),  s = r x g
-- from Newton's law with the acceleration of the contact point (rolling) or its component along g (else) prescribed.
-- share: c of viscous friction, mu/sqrt(v.v + e^2) of Coulomb's; v the slip.  Torques N T against spinning and rolling:
--     T = -c (g.w - Omega) g - d (w - (g.w) g),   c and d numbers, or a/sqrt(.. + e^2)
-- join r x h, and when it rolls w' = w0' + nu b as well, b the solution for T in place of the right side.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"

local contact = {}

local letters = { "x", "y", "z" }
local zero = expr.zero

-- The effect that constrains the body, or nil.
function contact.of(m)
  for _, e in ipairs(m.record.effects) do
    if e.spec.touches then return e end
  end
  return nil
end

-- Why the surface has no single point on the plane at the start; nil if it has.
local function untouched(m, a)
  local s = a.surface
  local up = vec.matvec(vec.transpose(vec.rotation(m.attitude)), a.normal)
  up = vec.matvec(vec.transpose(vec.rotation(s.axes)), up)
  local g = vec.map(up, function(x) return m:number(x) end)
  if s.disc and g[1] * g[1] + g[2] * g[2] < R.new(2) ^ -100 then
    return "the disc must not lie flat at the start: it must touch the plane in one point"
  elseif s.paraboloid and R.sign(g[3]) <= 0 then
    return "the paraboloid must touch the plane at the start: its open side faces the plane"
  elseif s.support then
    local map = {}
    for i, n in ipairs { "@nx", "@ny", "@nz" } do map[motion.sym(n)] = expr.num(-g[i]) end
    local ok, h = pcall(function() return m:number(calculus.substitute(s.support, map)) end)
    if not ok or not h then return "the support function must have a value for the normal at the start" end
  end
  return nil
end

-- What the plane cannot be together with, reported: false.
function contact.check(d, m)
  local plane = contact.of(m)
  if not plane then return true end
  local fine = true
  if m.structure.rod then
    d:error(m.line, "body", "has no moment of inertia about its line: a body that touches a plane must have one " ..
      "about each axis")
    fine = false
  end
  local wrong = untouched(m, plane.a)
  if wrong then
    d:error(plane.line, plane.kind, wrong)
    fine = false
  end
  for _, e in ipairs(m.record.effects) do
    local spec = e.spec
    local pushes = spec.force and (not spec.pushes or spec.pushes(e.a))
    if e ~= plane and (spec.carries or spec.varies or spec.turn or pushes or spec.frame or spec.name ==
      "effect.wheel") then
      d:error(e.line, e.kind, "cannot be together with effect.plane (line " .. plane.line .. "), whose equations " ..
        "know torques and rotors only")
      fine = false
    end
  end
  return fine
end

local function trivial(e) return e.kind == "num" or e.kind == "sym" end

-- A function that gives names to the components of a vector, as definitions of the group.
function contact.namer(m, group, taken)
  return function(prefix, v)
    return vec.map(v, function(e, i)
      if trivial(e) then return e end
      local name = prefix .. (#v == 3 and letters[i] or #v == 6 and vec.entry[i] or "")
      while m.by_name[name] or taken[name] do name = name .. "_" end
      taken[name] = true
      group.defs[#group.defs + 1] = { name = name, expr = e }
      return expr.sym(name, 7)
    end)
  end
end

-- w x k, the contact's vectors and gravity, as definitions of a first group.
local function geometry(m, e, c, groups)
  local a = e.a
  local s = a.surface
  local point = s.support and "centre + G + (h - n.G) n, n = -g" or s.paraboloid and "vertex - y, a paraboloid" or
    s.half[1] ~= zero and "centre - B g/sqrt(g.B g) - rim g" or "centre - rim g"
  local g = { why = "contact with the plane: r = " .. point .. ", g the plane's normal", defs = {}, outs = {} }
  local name = contact.namer(m, g, c.taken)
  local k = e.spec.contact(a, c, name)
  local place = vec.cross(c.w, k.far)
  if k.y then
    local rate = name("up_rate_", vec.cross(k.up, c.w))
    place = vec.sub(place, name("touch_rate_", k.slope(rate)))
  end
  k.place = name("place_", place)
  k.turning = name("turning_", vec.cross(c.w, k.r))
  k.bend = vec.cross(c.w, k.place)
  local G = vec.map(a.gravity, function(x, i) return c.constant("g" .. letters[i], x, "gravity, m/s^2") end)
  k.G = name("G", vec.matvec(k.back, G))
  k.weight = c.constant("weight", ratio.tidy(vec.dot(a.gravity, a.normal)), "gravity along the normal, m/s^2")
  k.x1, k.x2 = e.spec.reach(k)
  k.v1, k.v2 = e.spec.drift(k, c.w)
  groups[#groups + 1] = g
  return k, G
end

-- U in body axes and its components along e1 and e2: Omega n x P.
local function table_of(a, c, k)
  if a.rate == zero then return { zero, zero, zero }, zero, zero end
  local rate = k.rate
  local p1, p2 = c.own.p1 + k.x1, c.own.p2 + k.x2
  local u1, u2 = -rate * p2, rate * p1
  return vec.add(vec.scale(u1, k.E1), vec.scale(u2, k.E2)), u1, u2, rate
end

-- factor (g x G + Omega X') of a sphere about the centre of mass, whose velocity X' = U + r' has the components
-- p1', p2' and none along g:  r x f with the factor R, and  g x G = -(G.e2) e1 + (G.e1) e2.
local function driven(a, c, k, name, rates, factor, of)
  local rate = c.constant("rolling_Omega", ratio.tidy(factor * a.rate), "rate of the plane times " .. of)
  local function pull(i, e)
    return c.constant("rolling_g" .. i, ratio.tidy(factor * vec.dot(a.gravity, e)), "gravity along e" .. i ..
      " times " .. of)
  end
  local x1 = name("roll1", { rate * rates.p1 - pull(2, a.e2) })[1]
  local x2 = name("roll2", { rate * rates.p2 + pull(1, a.e1) })[1]
  return vec.add(vec.scale(x1, k.E1), vec.scale(x2, k.E2))
end

-- What is left of (g x G + Omega X'), as text; nil: nothing is.
local function driving(a)
  local turns = not ratio.iszero(a.rate)
  local tilted = not (ratio.iszero(vec.dot(a.gravity, a.e1)) and ratio.iszero(vec.dot(a.gravity, a.e2)))
  if tilted and turns then return "(g x G + Omega X')" end
  return tilted and "g x G" or turns and "Omega X'" or nil
end

local function isotropic(I)
  return I[1] == I[2] and I[2] == I[3] and I[4] == zero and I[5] == zero and I[6] == zero
end

-- w' of such a body: with D = I/m + R^2 the matrix is D - R^2 g g^T, whose inverse is (Sherman, Morrison 1950)
--     D^-1 + R^2 (D^-1 g) (D^-1 g)^T / den,   den = 1 - R^2 g.D^-1 g = sum g_i^2 (I_i/m)/D_i
-- A ball has den = (I/m)/D, and where no other torque acts g.n = 0: what is left is n/D, as `ball` has it.
local function round(m, e, c, k, name, n)
  local R2, I = e.a.surface.rim ^ 2, m.carried
  local function constant(i, prefix, x, about)
    return c.constant(prefix .. letters[i], ratio.tidy(x), about .. " about " .. letters[i])
  end
  local over, share = {}, {}
  for i = 1, 3 do
    local D = I[i] / m.mass + R2
    over[i] = constant(i, "roll", 1 / D, "1/(moment/mass + radius^2), 1/m^2,")
    share[i] = constant(i, "share", I[i] / m.mass / D, "moment over that about the contact point,")
  end
  local ball = I[1] == I[2] and I[2] == I[3]
  local y = name("n", vec.map(n, function(x, i) return over[i] * x end))
  local radius = c.constant("rim2", ratio.tidy(R2), "radius squared, m^2")
  local den = ball and share[1] or vec.dot(share, vec.map(k.up, function(x) return x ^ 2 end))
  local factor = name("support", { radius * vec.dot(k.up, y) / den })[1]
  return vec.map(y, function(x, i) return x + over[i] * k.up[i] * factor end)
end

-- c, or a/sqrt(square + e^2) of {coulomb = a, smoothing = e}; 0 of nil.
local function share_of(c, f, names, abouts, square)
  if not f then return zero end
  if f.viscous then return c.constant(names[1], f.viscous, abouts[1]) end
  local a = c.constant(names[2], f.coulomb, abouts[2])
  return a / expr.sqrt(square + c.constant(names[3], ratio.tidy(f.smoothing ^ 2), abouts[3]))
end

-- The torque against spinning and rolling per unit of the reaction, body axes; nil: there is none.
local function resisting(a, c, k, name)
  if not a.spinning and not a.rolling_resistance then return nil end
  local along = name("spin", { vec.dot(k.up, c.w) })[1]
  local T = { zero, zero, zero }
  if a.spinning then
    local rate = name("spin_rate", { along - k.rate })[1]
    local share = share_of(c, a.spinning, { "spin_viscous", "spin_arm", "spin_smooth" },
      { "resistance to spinning, m s", "resistance to spinning, m", "smoothing rate of spinning squared, rad^2/s^2" },
      rate ^ 2)
    T = vec.scale(-name("spin_share", { share * rate })[1], k.up)
  end
  if a.rolling_resistance then
    local w = name("roll_rate_", vec.sub(c.w, vec.scale(along, k.up)))
    local share = share_of(c, a.rolling_resistance, { "roll_viscous", "roll_arm", "roll_smooth" },
      { "resistance to rolling, m s", "resistance to rolling, m", "smoothing rate of rolling squared, rad^2/s^2" },
      vec.dot(w, w))
    T = vec.sub(T, vec.scale(name("roll_share", { share })[1], w))
  end
  return name("resist_", T)
end

-- nu b is added to w0', with nu = N/m; outs and nu.
local function supported(k, name, w0, b)
  local s = name("side_", vec.cross(k.far, k.up))
  local nu = name("push", { (-k.weight - vec.dot(k.up, k.bend) - vec.dot(w0, s)) /
    (1 + vec.dot(b, s)) })[1]
  return vec.map(w0, function(x, i) return x + nu * b[i] end), nu
end

-- (I/m w) x w + N/m + r x f, and what f is, as text.  moving: {u, rates = of the centre, rate = of the plane or nil}.
local function couple(m, a, c, I, k, name, N, moving)
  local n = vec.scale(c.constant("over_m", expr.one / m.mass, "1/mass, 1/kg"), N)
  if not isotropic(m.carried) then
    n = vec.add(n, vec.cross(name("Lm", vec.apply(I, c.w)), c.w)) -- Lx .. may be those of a torque that takes L
  end
  if k.centred then
    local of = driving(a)
    return vec.add(n, driven(a, c, k, name, moving.rates, a.surface.rim, "R")), "r x f = " .. (of and "R " .. of or "0")
  end
  local f, said = vec.scale(-expr.one, vec.add(k.G, k.bend)), "f = -G - w x k"
  if moving.rate then
    local P = vec.add(moving.u, vec.sub(k.place, k.turning)) -- u + r'
    f, said = vec.add(f, vec.scale(moving.rate, vec.cross(k.up, P))), said .. " + Omega g x (U + r')"
  end
  return vec.add(n, vec.cross(k.r, name("drive_", f))), said
end

-- solved(n) -> w', how it is done (nil: by elimination).
local function solver(m, e, c, I, k, name)
  if k.centred and I[4] == zero and I[5] == zero and I[6] == zero then
    return function(n) return round(m, e, c, k, name, vec.map(n, ratio.tidy)) end, "inverted by its diagonal and g g^T"
  end
  local r, S = k.r, nil
  return function(n)
    S = S or name("S", vec.add(I, { r[2] ^ 2 + r[3] ^ 2, r[1] ^ 2 + r[3] ^ 2, r[1] ^ 2 + r[2] ^ 2, -r[1] * r[2],
      -r[1] * r[3], -r[2] * r[3] }))
    return vec.solve(S, name("n", n), function(prefix, x) return name(prefix, { x })[1] end)
  end
end

-- w' of a ball with equal moments on which nothing else acts: r x f is along the plane, and so is w'; and its
-- law as text.
local function ball(m, a, c, k, name, rates)
  local factor, of = a.surface.rim / (m.carried[1] / m.mass + a.surface.rim ^ 2), driving(a)
  return driven(a, c, k, name, rates, factor, "R/(I/m + R^2)"),
    "Newton and Euler of a ball that rolls: w' = " .. (of and "R/(I/m + R^2) " .. of or "0")
end

local function rolling(m, e, c, N, groups)
  local k, a = geometry(m, e, c, groups), e.a
  local u, u1, u2, rate = table_of(a, c, k)
  local rates = { p1 = u1 - k.v1, p2 = u2 - k.v2 }
  local I = vec.map(m.carried, function(x, n)
    return c.constant("I" .. vec.entry[n] .. "_m", ratio.tidy(x / m.mass), "tensor entry " .. vec.entry[n] ..
      " per mass, m^2")
  end)
  local g = { defs = {} }
  local name = contact.namer(m, g, c.taken)
  local solved, how = solver(m, e, c, I, k, name)
  if k.centred and isotropic(m.carried) and N[1] == zero and N[2] == zero and N[3] == zero then
    g.outs, g.why = ball(m, a, c, k, name, rates)
  else
    local n, said = couple(m, a, c, I, k, name, N, { u = u, rates = rates, rate = rate })
    g.why = "Newton and Euler, rolling: (I/m + r.r 1 - r r^T) w' = (I w/m) x w + N/m + r x f, " .. said ..
      (how and ", " .. how or "")
    g.outs = solved(n)
  end
  local T, nu = resisting(a, c, k, name), nil
  if T then
    g.why = g.why .. "; N T against spinning and rolling by the solution b for T: w' = w0' + N/m b"
    g.outs, nu = supported(k, name, name("free_", g.outs), name("yield_", solved(T)))
  end
  groups[#groups + 1] = g
  -- N/m = g.(A - G), A = Omega g x (..) - w' x r - w x k
  local function reaction(dw)
    if nu or k.centred then return nu or -k.weight end
    return -vec.dot(k.up, vec.cross(dw, k.r)) - vec.dot(k.up, k.bend) - k.weight
  end
  return g, { coordinates = function() return rates end, reaction = reaction, k = k, c = c, a = a }
end

-- m I^-1 v, constants for what is divided by.
function contact.inverse_per_mass(m, c, name, v)
  local I = m.carried
  if I[4] == zero and I[5] == zero and I[6] == zero then
    return vec.map(v, function(x, i)
      if I[i] == zero then return zero end
      return c.constant("m_I" .. vec.entry[i], ratio.tidy(m.mass / I[i]), "mass/moment of inertia " .. vec.entry[i] ..
        ", 1/m^2") * x
    end)
  end
  local adj, det = vec.adjugate(I)
  local J = vec.map(adj, function(x, n)
    return c.constant("mJ" .. vec.entry[n], m.mass * x / det, "mass times the inverse of the tensor, " ..
      vec.entry[n] .. ", 1/m^2")
  end)
  return vec.apply(J, name("moment_", v))
end

local function touching(m, e, c, free, groups)
  local k, G = geometry(m, e, c, groups)
  local a = e.a
  local g = { why = "Newton and Euler on the plane: w' = w0' + N/m b, b = m I^-1 (r x h), " ..
    "N/m = (-g.G - g.(w x k) - w0'.s)/(1 + b.s), s = r x g", defs = {} }
  local name = contact.namer(m, g, c.taken)
  local w0 = name("free_", free)
  local h, v1, v2, share = k.up, nil, nil, zero
  if a.friction then
    local _, u1, u2 = table_of(a, c, k)
    v1 = name("slip_", { c.own.v1 + k.v1 - u1 })[1]
    v2 = name("slide_", { c.own.v2 + k.v2 - u2 })[1]
    share = name("share", { share_of(c, a.friction, { "viscous", "mu", "smooth" }, { "viscous friction, s/m",
      "coefficient of friction", "smoothing speed squared, m^2/s^2" }, v1 ^ 2 + v2 ^ 2) })[1]
    h = name("press_", vec.sub(k.up, vec.scale(share, vec.add(vec.scale(v1, k.E1), vec.scale(v2, k.E2)))))
  end
  local lever = a.friction and vec.cross(k.r, h) or vec.cross(k.far, k.up)
  local T = resisting(a, c, k, name)
  local b = name("yield_", contact.inverse_per_mass(m, c, name, T and vec.add(lever, T) or lever))
  local nu
  g.outs, nu = supported(k, name, w0, b)
  groups[#groups + 1] = g
  local function coordinates()
    local A1, A2 = vec.dot(G, k.e1), vec.dot(G, k.e2)
    if v1 then A1, A2 = A1 - nu * share * v1, A2 - nu * share * v2 end
    return { p1 = c.own.v1, p2 = c.own.v2, v1 = A1, v2 = A2 }
  end
  return g, { coordinates = coordinates, reaction = function() return nu end, k = k, c = c, a = a }
end

-- The centre of mass and its velocity in inertial axes; rates: those of the effect's own states.
local function placed(touch, rates)
  local c, k = touch.c, touch.k
  local height, rise = -vec.dot(k.up, k.r), -vec.dot(k.up, k.turning)
  local function along(x1, x2, up)
    return vec.map(k.n, function(n, i)
      local sum = up * n
      if x1 then sum = sum + x1 * k.e1[i] + x2 * k.e2[i] end
      return sum
    end)
  end
  return along(c.own.p1, c.own.p2, height), along(rates.p1, rates.p2, rise)
end

-- The groups of w' are appended to `groups`.  N: the torques of what else acts, as their names; euler(): the group of
-- Euler's equations without contact.  Returns the group whose outs are w', and a group that is none of the equations:
-- its outs are what else follows, see contact.read.
function contact.turning(m, e, constant, N, groups, euler)
  local c = context.with(context.of(m, constant), e)
  c.taken = {}
  local g, touch
  if e.a.law == "rolling" then
    g, touch = rolling(m, e, c, N, groups)
  else
    local free = euler()
    if not free then return nil end
    groups[#groups + 1] = { why = free.why .. "; without the plane", where = free.where, defs = free.defs, outs = {} }
    g, touch = touching(m, e, c, free.outs, groups)
  end
  local rates = touch.coordinates()
  local com, velocity = placed(touch, rates)
  local rest = { why = "", defs = {}, outs = { { expr = touch.reaction(g.outs) } } }
  for _, v in ipairs { com, velocity } do
    for _, x in ipairs(v) do rest.outs[#rest.outs + 1] = { expr = x } end
  end
  for _, key in ipairs { "p1", "p2", "v1", "v2" } do
    rest.outs[#rest.outs + 1] = rates[key] and { key = key, expr = rates[key] } or nil
  end
  return g, rest
end

-- Of that group when the constants stand: N/m; the centre of mass and its velocity, inertial axes; the rates of the
-- effect's own states by name.
function contact.read(rest)
  local o = vec.map(rest.outs, function(x) return x.expr end)
  local touch = { push = o[1], com = { o[2], o[3], o[4] }, velocity = { o[5], o[6], o[7] }, rates = {} }
  for i = 8, #rest.outs do touch.rates[rest.outs[i].key] = o[i] end
  return touch
end

return contact
