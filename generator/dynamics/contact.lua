-- contact.lua -- the equations of a body that touches a plane (effects/plane.lua).
--
-- All vectors in body axes, or for a disc about the body's axis in those of its lowest point (effects/meridian.lua); w'
-- is turned back.  g = `up`, the plane's normal; r = `arm`, from the centre of mass to the contact point; y
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
-- rolling.lua has the first of them, touch.lua the vectors.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local rolling = require "generator.dynamics.rolling"
local start = require "generator.dynamics.start"
local touch = require "generator.dynamics.touch"

local contact = {}

local zero, body = expr.zero, { "x", "y", "z" }

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
  local flying = m.record.flies and m.given.position -- it starts in the air
  if fine and not flying then fine = start.check(d, m, plane, m.given.velocity or m.given.unused) end
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

local function touching(m, e, c, free, groups)
  local k = touch.geometry(m, e, c, groups)
  local a = e.a
  local g = { why = "Newton and Euler on the plane: w' = w0' + N/m b, b = m I^-1 (r x h), " ..
    "N/m = (-g.G - g.(w x k) - w0'.s)/(1 + b.s), s = r x g", defs = {} }
  local name = touch.namer(m, g, c.taken, k.letters)
  local w0 = name("free_", free, body)
  local h, v1, v2, share = k.up, nil, nil, zero
  if a.friction then
    local _, u1, u2 = touch.table_of(a, c, k)
    v1 = name("slip_", { c.own.v1 + k.v1 - u1 })[1]
    v2 = name("slide_", { c.own.v2 + k.v2 - u2 })[1]
    share = name("share", { touch.share_of(c, a.friction, { "viscous", "mu", "smooth" }, { "viscous friction, s/m",
      "coefficient of friction", "smoothing speed squared, m^2/s^2" }, v1 ^ 2 + v2 ^ 2) })[1]
    h = name("press_", vec.sub(k.up, vec.scale(share, k.span(v1, v2))))
  end
  local lever = a.friction and vec.cross(k.r, h) or k.side
  local T = touch.resisting(a, c, k, name)
  local b = name("yield_", touch.inverse_per_mass(m, c, name, T and vec.add(lever, T) or lever))
  local nu = touch.support(k, name, k.into(w0), b)
  g.outs = vec.add(w0, k.out(vec.scale(nu, b)))
  groups[#groups + 1] = g
  local function coordinates()
    local A1, A2 = k.g1, k.g2
    if v1 then A1, A2 = A1 - nu * share * v1, A2 - nu * share * v2 end
    return { p1 = c.own.v1, p2 = c.own.v2, v1 = A1, v2 = A2 }
  end
  return g, { coordinates = coordinates, reaction = function() return nu end, k = k, c = c, a = a }
end

-- The centre of mass and its velocity in inertial axes; rates: those of the effect's own states.
local function placed(t, rates)
  local c, k = t.c, t.k
  local height, rise = k.height, -vec.dot(k.w, k.side)
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
  local g, t
  if e.a.law == "rolling" then
    g, t = rolling.turning(m, e, c, N, groups)
  else
    local free = euler()
    if not free then return nil end
    groups[#groups + 1] = { why = free.why .. "; without the plane", where = free.where, defs = free.defs, outs = {} }
    g, t = touching(m, e, c, free.outs, groups)
  end
  local rates = t.coordinates()
  local com, velocity = placed(t, rates)
  local rest = { why = "", defs = {}, outs = { { expr = t.reaction() } } }
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
  local t = { push = o[1], com = { o[2], o[3], o[4] }, velocity = { o[5], o[6], o[7] }, rates = {} }
  for i = 8, #rest.outs do t.rates[rest.outs[i].key] = o[i] end
  return t
end

return contact
