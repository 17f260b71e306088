-- touch_laws.lua -- what a body on a plane conserves beside the laws of dynamics/conserved.lua.
--
-- r goes from the centre of mass to the contact point, g is the normal, both in body axes; L = I w; V the velocity of
-- the centre of mass p; R the radius of a sphere; k the body's axis, I3 and I1 the moments about and across it.
--     E - Omega n.(L + m p x V)      rolls on a level turntable of the rate Omega: what turns with it sees no time
--     -L.r                           Jellett 1872: sphere whose centre lies on k or is that of mass, whatever the law
--     w3 sqrt(I1 I3 + m r.I r)       Routh, Advanced Rigid Dynamics, 243: that body rolls on a level plane at rest
--     L - m r x V - m R (n x G) t    in inertial axes; sphere about the centre of mass, so r is constant and the force
--                                    drops out, as m V' = F + m G (Chaplygin 1903 for the rolling one)
--     w.n                            homogeneous ball that rolls: the plane's force has no moment about n
--     L.n                            smooth: nor have its forces;   I3 w3: smooth and of one axis with the surface
-- Each needs the plane to be the one effect, without resistance to spinning and rolling.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local context = require "generator.dynamics.context"
local state = require "generator.dynamics.state"

local touch_laws = {}

local zero = expr.zero

local function bare(_, v) return v end

-- Is the vector zero for every value of the parameters?
local function none(v)
  for i = 1, 3 do
    if not ratio.iszero(v[i]) then return false end
  end
  return true
end

-- Is the surface one of revolution about the body's axis z through the centre of mass?
local function about_z(s, centre)
  if not (ratio.iszero(centre[1]) and ratio.iszero(centre[2])) then return false end
  if s.support then return false end
  local straight = s.axes[2] == zero and s.axes[3] == zero
  return straight and ratio.iszero(s.half[1] - s.half[2])
end

-- What the conditions ask, decided for all values of the parameters: {surface, centre, sphere, ball, axis (unit vector
-- or nil), I1, I3, aligned: the centre lies on the axis, revolved: body and surface are of revolution about z, level}.
function touch_laws.facts(m, e)
  local a, S = e.a, m.structure
  local s = a.surface
  local centre = vec.map(vec.sub(s.at, m.origin), ratio.tidy)
  local sphere = s.half[1] == zero and not s.support and not s.paraboloid
  local f = { surface = s, centre = centre, sphere = sphere, level = none(vec.cross(a.normal, a.gravity)) }
  if S.kind == "sphere" then
    f.I1, f.I3 = S.alpha, S.alpha
    f.ball = sphere and none(centre)
    f.axis = none(centre) and { zero, zero, expr.one } or
      vec.scale(expr.one / expr.sqrt(vec.dot(centre, centre)), centre)
    f.aligned = true
  elseif S.kind == "symmetric" then
    f.I1, f.I3 = S.alpha, S.axial
    f.axis = vec.scale(expr.one / expr.sqrt(vec.dot(S.k, S.k)), S.k)
    f.aligned = none(vec.cross(centre, S.k))
  end
  local z = S.kind == "sphere" or S.kind == "symmetric" and ratio.iszero(S.k[1]) and ratio.iszero(S.k[2])
  f.revolved = z and about_z(s, centre)
  return f
end

-- Every law that there is: {key, symbol, formula (notation of formula/read.lua), what, unit, e: an expression of the
-- states and t, holds}.
function touch_laws.all(m)
  local e, list = contact.of(m), {}
  local a = e.a
  local c, f = context.with(context.dry(m), e), touch_laws.facts(m, e)
  local alone = #m.record.effects == 1 and not a.spinning and not a.rolling_resistance
  local k = e.spec.contact(a, c, bare)
  local x, y, z = e.spec.velocity(a, c, k)
  local w, I = state.w, m.carried or m.inertia
  local L, mass, r = vec.apply(I, w), m.mass, k.r
  local along = { vec.matvec(k.back, k.e1), vec.matvec(k.back, k.e2), k.up } -- e1, e2 and n in body axes
  local V = vec.add(vec.scale(x, along[1]), vec.add(vec.scale(y, along[2]), vec.scale(z, k.up)))
  local rolls, level, R = a.law == "rolling", f.level, f.surface.rim
  local function put(key, symbol, formula, what, unit, value, holds)
    list[#list + 1] = { key = key, symbol = symbol, formula = formula, what = what, unit = unit, e = value,
      holds = alone and holds or false }
  end
  if rolls and a.rate ~= zero then
    local p1, p2 = c.own.p1, c.own.p2
    local J = vec.dot(k.up, L) + mass * (p1 * y - p2 * x)
    local E = (vec.dot(w, L) + mass * vec.dot(V, V)) / 2 + calculus.substitute(e.spec.potential(a, c), { [c.M] = mass })
    put("turntable_energy", "E_0", "E - Omega ~n . ( ~L + M ~p x ~v )", "conserved on a turntable", "J",
      E - a.rate * J, level)
  end
  put("jellett", "C_J", "- ~L . ~r", "Jellett's integral, conserved", "kg m^3/s", -vec.dot(L, r),
    f.sphere and (f.aligned or none(f.centre)))
  if rolls and f.axis then
    put("routh", "C_R", "omega_3 sqrt(I_1 I_3 + M ~r . I ~r)", "Routh's integral, conserved", "kg m^2 rad/s",
      vec.dot(w, f.axis) * expr.sqrt(f.I1 * f.I3 + mass * vec.dot(r, vec.apply(I, r))),
      f.sphere and f.aligned and level and a.rate == zero)
  end
  local K, slope = vec.sub(L, vec.scale(mass, vec.cross(r, V))), vec.cross(a.normal, a.gravity)
  for i, name in ipairs { "e1", "e2", "n" } do
    local lift = vec.dot(slope, ({ a.e1, a.e2, a.normal })[i])
    local axis = name == "n" and "~n" or "~e_" .. string.sub(name, 2)
    put("chaplygin_" .. name, "C_" .. (name == "n" and "n" or "e" .. string.sub(name, 2)),
      "( ~L - M ~r x ~v" .. (level and "" or " - M R ( ~n x ~g ) t") .. " ) . " .. axis,
      "Chaplygin's vector along " .. name .. ", conserved",
      "N m s", vec.dot(K, along[i]) - mass * R * lift * state.t, f.sphere and none(f.centre))
  end
  if rolls then
    put("spin_about_normal", "omega_n", "~omega . ~n", "spin about the normal of a homogeneous ball, conserved",
      "rad/s", vec.dot(w, k.up), f.ball or false)
  end
  if a.law == "smooth" then
    put("momentum_about_normal", "L_n", "~L . ~n", "nothing turns it about the normal: conserved", "N m s",
      vec.dot(L, k.up), true)
    if f.axis then
      put("momentum_about_axis", "L_3", "I_3 omega_3", "of a body of revolution, conserved", "N m s",
        f.I3 * vec.dot(w, f.axis), f.sphere and f.aligned or f.revolved)
    end
  end
  return list
end

-- Those that hold.
function touch_laws.of(m)
  local list = {}
  for _, law in ipairs(contact.of(m) and touch_laws.all(m) or {}) do
    if law.holds then list[#list + 1] = law end
  end
  return list
end

return touch_laws
