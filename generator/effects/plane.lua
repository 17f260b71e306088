-- plane.lua -- the body touches a plane: it rolls, slides, or is without friction.
--
--     rolling     V = U - w x r                       [I + m (r.r 1 - r r^T)] w' = L x w + N + m r x f
--     smooth      n.(V + w x r) = 0, F = N n          sliding   F = N (n - share of the slip)
-- r from the centre of mass to the contact point; V its velocity, U that of the plane's point under it.  The equations
-- are dynamics/contact.lua's.  Kept for as long as the reaction N is positive.
-- Own states: the coordinates of the centre of mass along the plane's axes e1 (as near to inertial x as there is) and
-- e2 = n x e1, and its velocity along them unless it rolls; a smooth level plane needs none of them, and has them if
-- `initial` gives position or velocity.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local meridian = require "generator.effects.meridian"
local surface = require "generator.effects.surface"

local plane = {
  name = "effect.plane", reader = "plane",
  about = "the body touches a plane with its surface: law rolling, smooth or sliding with friction; normal, turntable",
  single = true, central = true, touches = true, keeps = "T+V without friction on a plane at rest",
  takes = { { "surface", "", nil, "contact.sphere{r}, contact.ellipsoid{a, b, c}, contact.disc{r, edge}, " ..
      "contact.paraboloid{a, b}, contact.support{h}; at =" },
    { "law", "", "\"rolling\"", "or \"smooth\", \"sliding\"" },
    { "friction", "", nil, "of sliding: { viscous = c } in s/m, or { coulomb = mu, smoothing = e }, e in m/s" },
    { "spinning", "", nil, "torque N c w or N a w/sqrt(w^2 + e^2) against turning about the normal: " ..
      "{ viscous = c } in m s, or { coulomb = a, smoothing = e } in m and rad/s" },
    { "rolling_resistance", "", nil, "the same against turning about the directions of the plane" },
    { "normal", "1", "{0, 0, 1}", "of the plane, inertial axes, to the body's side, of any length" },
    { "turntable", "rad/s", "0", "rate at which the plane turns about its normal through the inertial origin" },
    { "gravity", "m/s^2", "9.80665", "a number (along -z) or a vector" },
    { "impact", "", nil, "beside effect.translation, which has the gravity: the body flies where the plane would " ..
      "have to pull, and lands with { restitution = e, friction = mu, tangential = e_t }" } },
  idle = { {}, "it always acts" },
  formula = "rolling: V + w x r = U; smooth: F = N n; sliding: F = N (n - c v), or N (n - mu v/sqrt(v^2 + e^2))",
  signs = "r from the centre of mass to the contact point, N the reaction along the normal n, v the slip V + w x r - U",
  source = "Routh, Advanced Rigid Dynamics, arts. 241-244; Neimark, Fufaev, Dynamics of Nonholonomic Systems, ch. 1",
  example = "rolling_coin",
}

-- The formula of the law that the scene has.
function plane.said(a)
  if a.law ~= "sliding" then return a.law == "rolling" and "rolling, V + w x r = U" or "smooth, F = N n" end
  return a.friction.coulomb and "sliding, F = N (n - mu v/sqrt(v^2 + e^2))" or "sliding, F = N (n - c v)"
end

-- Does the motion along the plane need states?
local function placed(a, given)
  if a.law ~= "smooth" or a.impact or given.position or given.velocity then return true end
  for i = 1, 2 do
    local e = i == 1 and a.e1 or a.e2
    if not ratio.iszero(vec.dot(a.gravity, e)) then return true end
  end
  return false
end

function plane.states(a, given)
  if not placed(a, given) then return {} end
  local none = { expr.zero, expr.zero, expr.zero }
  local p, v = given.position or none, given.velocity or none
  local function state(name, e, of, what, unit)
    return { name = name, initial = ratio.tidy(vec.dot(e, of)), unit = unit, about = what }
  end
  local list = { state("p1", a.e1, p, "centre of mass along the plane's axis e1", "m"),
    state("p2", a.e2, p, "centre of mass along e2", "m") }
  if a.law ~= "rolling" then
    list[3] = state("v1", a.e1, v, "velocity of the centre of mass along e1", "m/s")
    list[4] = state("v2", a.e2, v, "velocity along e2", "m/s")
  end
  return list
end

-- Does the surface have axes of its meridian?
function plane.meridian(a, c) return meridian.fits(a.surface, c.origin) end

-- ---- the contact: what dynamics/contact.lua and the energy are made of ----

local function constants(c, prefix, v, about, unit)
  return vec.map(v, function(x, i)
    local letter = string.sub("xyz", i, i)
    return c.constant(prefix .. letter, ratio.tidy(x), about .. " " .. letter .. unit)
  end)
end

-- The vectors of the contact, by names that `name(prefix, vector)` may give them: in body axes, or where `axes` says so
-- in those of the meridian.
function plane.contact(a, c, name, axes)
  local k = { n = constants(c, "plane", a.normal, "normal of the plane,", ""),
    e1 = constants(c, "along", a.e1, "e1 of the plane,", ""),
    e2 = constants(c, "beside", a.e2, "e2 of the plane,", "") }
  k.rate = c.constant("Omega_plane", a.rate, "rate of the plane, rad/s")
  if axes then return meridian.place(a, c, k, name) end
  return plane.axes(c, plane.place(a, c, k, name))
end

-- Adds to {up}, the normal in body axes, what is at the lowest point: far, from the centre of mass to the centre of
-- curvature; r, to the point; y and slope, of effects/surface.lua.
function plane.lowest(a, c, k, name)
  local s = a.surface
  local centre = constants(c, "centre", vec.sub(s.at, c.origin), "centre of the surface from the centre of mass,",
    ", m")
  local rim = c.constant("rim", s.rim, "radius of the sphere, or of the rounded edge, m")
  local far, along = surface.revolved(s, c, centre, k.up, name)
  if far then
    k.moved = along
  else
    k.y, k.slope = surface.point(s, c, k.up, name)
    far = k.y and name("far_", vec.sub(centre, k.y)) or centre -- c - y
  end
  k.far, k.rim = far, rim
  k.r = name("arm_", vec.sub(far, vec.scale(rim, k.up)))
  k.centred = far[1] == expr.zero and far[2] == expr.zero and far[3] == expr.zero
  return k
end

-- The same for {n}, the normal in inertial axes.
function plane.place(a, c, k, name)
  k.back = vec.transpose(vec.rotation(c.q))
  k.up = name("up_", vec.matvec(k.back, k.n))
  return plane.lowest(a, c, k, name)
end

local function same(v) return v end

-- Adds to the vectors: w; into, out, which turn a vector into their axes and back; reach, drift, the components along
-- e1 and e2 of r and of w x r; span, the vector of such components; side = far x g; height, of the centre of mass.
-- r = -rim g of a sphere about the centre of mass has none, and e1.(w x g) = w.(g x e1) = w.e2, e2.(w x g) = -w.e1.
function plane.axes(c, k)
  local E1, E2 = vec.matvec(k.back, k.e1), vec.matvec(k.back, k.e2)
  k.w, k.into, k.out = c.w, same, same
  if k.moved then
    k.place, k.side, k.pull = k.moved(c.w)
  else
    k.side = vec.cross(k.far, k.up)
  end
  k.height = k.centred and k.rim or -vec.dot(k.up, k.r)
  function k.span(x1, x2) return vec.add(vec.scale(x1, E1), vec.scale(x2, E2)) end
  function k.reach()
    if k.centred then return expr.zero, expr.zero end
    return vec.dot(E1, k.r), vec.dot(E2, k.r)
  end
  function k.drift()
    if k.centred then return -k.rim * vec.dot(c.w, E2), k.rim * vec.dot(c.w, E1) end
    local turning = k.turning or vec.cross(c.w, k.r)
    return vec.dot(E1, turning), vec.dot(E2, turning)
  end
  return k
end

local function bare(_, v) return v end

-- Rates of the contact's coordinates: components of the velocity along e1, e2 and n, in space.
function plane.velocity(a, c, k)
  local rise = -vec.dot(k.w, k.side)
  if a.law ~= "rolling" then
    if not c.own.v1 then return expr.zero, expr.zero, rise end
    return c.own.v1, c.own.v2, rise
  end
  local x1, x2 = k.reach()
  local v1, v2 = k.drift()
  return -v1 - k.rate * (c.own.p2 + x2), -v2 + k.rate * (c.own.p1 + x1), rise
end

function plane.kinetic(a, c)
  local k = plane.contact(a, c, bare, plane.meridian(a, c))
  local V = { plane.velocity(a, c, k) }
  if a.law == "rolling" and a.rate == expr.zero then V = vec.cross(k.w, k.r) end -- V + w x r = 0
  return c.constant("mass", c.mass, "mass, kg") * vec.dot(V, V) / 2
end

-- Gravity along the normal, less than 0 where it presses the body to the plane.
function plane.weight(a) return ratio.tidy(vec.dot(a.gravity, a.normal)) end

-- Gravity along e1, e2 and the normal, as constants.  Where all of it is along the normal the first two are exactly 0.
-- A vector would keep what the rounding of a normal of irrational length leaves.
function plane.gravity(a, c)
  local function along(name, g, what) return c.constant(name, g, "gravity along " .. what .. ", m/s^2") end
  return along("slope1", ratio.tidy(vec.dot(a.gravity, a.e1)), "e1"),
    along("slope2", ratio.tidy(vec.dot(a.gravity, a.e2)), "e2"), along("weight", plane.weight(a), "the normal")
end

-- V = -m G.x, x the centre of mass.
function plane.potential(a, c)
  local k = plane.contact(a, c, bare, plane.meridian(a, c))
  local g1, g2, weight = plane.gravity(a, c)
  local sum = weight * k.height
  if c.own.p1 then sum = sum + g1 * c.own.p1 + g2 * c.own.p2 end
  return -c.M * sum
end

function plane.conserves(a, c)
  if a.spinning or a.rolling_resistance then return {} end
  local s, central = a.surface, a.law == "smooth" and not a.surface.support and a.surface.half[1] == expr.zero
  for i = 1, 3 do central = central and ratio.iszero(s.at[i] - c.origin[i]) end
  if central then return { "T+V", "L", "w3" } end -- the reaction goes through the centre of mass
  return a.law ~= "sliding" and a.rate == expr.zero and { "T+V", "w3", "L_z" } or { "w3" }
end

local law_numbers = { rolling = 0.0, smooth = 1.0, sliding = 2.0 }

-- The coefficient of a resistance and its smoothing, 0 where it is viscous.
local function numbers(f, num)
  if not f then return { 0.0, 0.0 } end
  return { num(f.coulomb or f.viscous), f.smoothing and num(f.smoothing) or 0.0 }
end

function plane.numeric(a, num, given, code, c)
  local s, f = a.surface, a.friction or {}
  return { kind = "plane", law = f.coulomb and 3.0 or law_numbers[a.law], placed = placed(a, given) and 1.0 or 0.0,
    surface = s.support and 2.0 or s.paraboloid and 1.0 or 0.0, support = s.support and code(s.support) or nil,
    half_axes = vec.map(s.half, num), axes = { num(s.axes[1]), num(s.axes[2]), num(s.axes[3]), num(s.axes[4]) },
    rim = num(s.rim), centre = vec.map(vec.sub(s.at, c.origin), num), normal = vec.map(a.normal, num),
    e1 = vec.map(a.e1, num), rate = num(a.rate), gravity = vec.map(a.gravity, num),
    friction = f.coulomb and num(f.coulomb) or f.viscous and num(f.viscous) or 0.0,
    smoothing = f.smoothing and num(f.smoothing) or 0.0, spinning = numbers(a.spinning, num),
    rolling = numbers(a.rolling_resistance, num) }
end

return plane
