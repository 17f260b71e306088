-- touch.lua -- the vectors of a body that touches a plane, and what its laws have in common (contact.lua).
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local touch = {}

local zero = expr.zero
local letters = { "x", "y", "z" }

local function trivial(e) return e.kind == "num" or e.kind == "sym" end

-- A function that gives names to the components of a vector, as definitions of the group; axes: the letters of its
-- components, x, y, z by default.
function touch.namer(m, group, taken, axes)
  return function(prefix, v, own)
    return vec.map(v, function(e, i)
      if trivial(e) then return e end
      local name = prefix .. (#v == 3 and (own or axes or letters)[i] or #v == 6 and vec.entry[i] or "")
      while m.by_name[name] or taken[name] do name = name .. "_" end
      taken[name] = true
      group.defs[#group.defs + 1] = { name = name, expr = e }
      return expr.sym(name, 7)
    end)
  end
end

-- Do body and surface share an axis z, so that the meridian's axes keep the tensor?
local function turned(m, e, c)
  local I = m.carried
  local plain = I[4] == zero and I[5] == zero and I[6] == zero and ratio.iszero(I[1] - I[2])
  return plain and e.spec.meridian(e.a, c)
end

local function point(s)
  if s.support then return "centre + G + (h - n.G) n, n = -g" end
  if s.paraboloid then return "vertex - y, a paraboloid" end
  return s.half[1] ~= zero and "centre - B g/sqrt(g.B g) - rim g" or "centre - rim g"
end

-- w x k, the contact's vectors and gravity, as definitions of a first group.
function touch.geometry(m, e, c, groups)
  local a, axes = e.a, turned(m, e, c)
  local g = { why = "contact with the plane: " .. (axes and "r = centre - R t - rim g, in the axes t = (g1, g2, 0)/" ..
    "rho, s = z x t, z" or "r = " .. point(a.surface)) .. ", g the plane's normal", defs = {}, outs = {} }
  local name = touch.namer(m, g, c.taken)
  local k = e.spec.contact(a, c, name, axes)
  local place = k.place or vec.cross(k.w, k.far)
  if k.y then
    local rate = name("up_rate_", vec.cross(k.up, k.w))
    place = vec.sub(place, name("touch_rate_", k.slope(rate)))
  end
  k.place = name("place_", place, k.letters)
  k.turning = name("turning_", vec.cross(k.w, k.r), k.letters)
  k.bend = vec.cross(k.w, k.place)
  k.pull = k.pull or vec.dot(k.up, k.bend)
  k.g1, k.g2, k.weight = e.spec.gravity(a, c)
  local G
  if k.g1 == zero and k.g2 == zero then
    G = vec.scale(k.weight, k.up)
  else
    G = vec.map(a.gravity, function(x, i) return c.constant("g" .. letters[i], x, "gravity, m/s^2") end)
    G = k.into(vec.matvec(k.back, G))
  end
  k.G = name("G", G, k.letters)
  k.x1, k.x2 = k.reach()
  k.v1, k.v2 = k.drift()
  k.side = name("side_", k.side, k.letters)
  groups[#groups + 1] = g
  return k
end

-- U and its components along e1 and e2: Omega n x P; and Omega, nil where the plane is at rest.
function touch.table_of(a, c, k)
  if a.rate == zero then return { zero, zero, zero }, zero, zero end
  local rate = k.rate
  local p1, p2 = c.own.p1 + k.x1, c.own.p2 + k.x2
  local u1, u2 = -rate * p2, rate * p1
  return k.span(u1, u2), u1, u2, rate
end

-- c, or a/sqrt(square + e^2) of {coulomb = a, smoothing = e}; 0 of nil.
function touch.share_of(c, f, names, abouts, square)
  if not f then return zero end
  if f.viscous then return c.constant(names[1], f.viscous, abouts[1]) end
  local a = c.constant(names[2], f.coulomb, abouts[2])
  return a / expr.sqrt(square + c.constant(names[3], ratio.tidy(f.smoothing ^ 2), abouts[3]))
end

-- The torque against spinning and rolling per unit of the reaction; nil: there is none.
function touch.resisting(a, c, k, name)
  if not a.spinning and not a.rolling_resistance then return nil end
  local along = name("spin", { vec.dot(k.up, k.w) })[1]
  local T = { zero, zero, zero }
  if a.spinning then
    local rate = name("spin_rate", { along - k.rate })[1]
    local share = touch.share_of(c, a.spinning, { "spin_viscous", "spin_arm", "spin_smooth" },
      { "resistance to spinning, m s", "resistance to spinning, m", "smoothing rate of spinning squared, rad^2/s^2" },
      rate ^ 2)
    T = vec.scale(-name("spin_share", { share * rate })[1], k.up)
  end
  if a.rolling_resistance then
    local w = name("roll_rate_", vec.sub(k.w, vec.scale(along, k.up)))
    local share = touch.share_of(c, a.rolling_resistance, { "roll_viscous", "roll_arm", "roll_smooth" },
      { "resistance to rolling, m s", "resistance to rolling, m", "smoothing rate of rolling squared, rad^2/s^2" },
      vec.dot(w, w))
    T = vec.sub(T, vec.scale(name("roll_share", { share })[1], w))
  end
  return name("resist_", T)
end

-- nu = N/m, with which nu b is added to w0'.
function touch.support(k, name, w0, b)
  return name("push", { (-k.weight - k.pull - vec.dot(w0, k.side)) / (1 + vec.dot(b, k.side)) })[1]
end

-- m/I_i, a constant.
function touch.per_moment(m, c, i)
  return c.constant("m_I" .. vec.entry[i], ratio.tidy(m.mass / m.carried[i]), "mass/moment of inertia " ..
    vec.entry[i] .. ", 1/m^2")
end

-- m I^-1 v, constants for what is divided by.
function touch.inverse_per_mass(m, c, name, v)
  local I = m.carried
  if I[4] == zero and I[5] == zero and I[6] == zero then
    return vec.map(v, function(x, i)
      if I[i] == zero then return zero end
      return touch.per_moment(m, c, i) * x
    end)
  end
  local adj, det = vec.adjugate(I)
  local J = vec.map(adj, function(x, n)
    return c.constant("mJ" .. vec.entry[n], m.mass * x / det, "mass times the inverse of the tensor, " ..
      vec.entry[n] .. ", 1/m^2")
  end)
  return vec.apply(J, name("moment_", v))
end

return touch
