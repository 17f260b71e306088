-- steady.lua -- steady rolling of a body of revolution at any tilt, and how it nods about it.
--
-- theta: the body's axis k from the normal, s and c its sine and cosine; t across the axis in the plane of both, so
-- that the normal is s t + c k; n the precession, w the rate about the axis.  The contact is r = x t + y k, and moves
-- by rho (-c t + s k) dtheta over the body, rho the radius of curvature.
-- Height h = -(x s + y c), its slope b = y s - x c; the centre moves at v = n s y - w x along t x k.  Rolling gives
--     (I1 + m r^2) theta'' = M = I1 n^2 s c - I3 n s w - m n h v - m G b      (to first order in theta')
--     f = (y (I3 w/I1 - n c) + rho (n s^2 + w c) - n h)/(1 + m y^2/I1 + m x^2/I3)
--     dn/dtheta = (I3/I1 w - 2 n c - m y f/I1)/s,      dw/dtheta = m x f/I3
-- (Routh, Advanced Rigid Dynamics, 241-244: a solid of revolution on a rough plane).  M = 0 is linear in w; about it
-- the tilt has the frequency squared -(dM/dtheta)/(I1 + m r^2), along the two last equations.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local context = require "generator.dynamics.context"
local equations = require "generator.dynamics.equations"
local touch = require "generator.dynamics.touch"
local upright = require "generator.dynamics.upright"

local steady = {}

local tilt, n = expr.sym("tilt", 6), expr.sym("n", 6)

-- upright.revolved of a body that rolls, or nil.
local function rolls(m)
  local at = upright.revolved(m)
  return at and at.e.a.law == "rolling" and at or nil
end

-- The radius of curvature of the meridian at the contact, without a rim or the radius of a sphere: a^2 b^2/(a^2 s^2 +
-- b^2 c^2)^(3/2) of an ellipsoid of the half axes a, a, b, a/c^3 of a paraboloid, 0 of a disc's edge.
local function curvature(s, sine, cosine)
  if s.paraboloid then return s.half[1] / cosine ^ 3 end
  local A, B = s.half[1] ^ 2, s.half[3] ^ 2
  return B == expr.zero and expr.zero or A * B / expr.sqrt(A * sine ^ 2 + B * cosine ^ 2) ^ 3
end

-- The contact at the tilt and what follows from it, as definitions of the group.  plain: no constant is kept.
local function geometry(m, group, plain)
  local at = rolls(m)
  local c = context.with(plain and context.dry(m) or context.of(m), at.e)
  local name = touch.namer(m, group, {})
  local function one(prefix, e) return name(prefix, { e })[1] end
  local k = { s = one("sine", expr.call("sin", tilt)), c = one("cosine", expr.call("cos", tilt)) }
  local function constant(prefix, e, about) return c.constant(prefix, ratio.tidy(e), about) end
  local surface = at.f.surface
  local rim = constant("rim", surface.rim, "radius of the sphere, or of the rounded edge, m")
  local r
  if surface.disc then -- whose y would be R g/|g|: no number near flat
    local radius, z = constant("radius", surface.half[1], "radius of the disc's centre circle, m"),
      constant("centrez", at.f.centre[3], "centre of the surface from the centre of mass, z, m")
    r = { -(radius + rim * k.s), expr.zero, z - rim * k.c }
  else
    r = at.e.spec.lowest(at.e.a, c, { up = { k.s, expr.zero, k.c } }, name).r
  end
  k.x, k.y = one("arm_x", r[1]), one("arm_z", r[3])
  k.rho = one("bend", rim + curvature(surface, k.s, k.c))
  k.h, k.b = one("height", -(k.x * k.s + k.y * k.c)), one("lever", k.y * k.s - k.x * k.c)
  k.m1 = constant("m_I1", m.mass / at.I1, "mass over the moment across the axis, 1/m^2")
  k.m3 = constant("m_I3", m.mass / at.I3, "mass over the moment about the axis, 1/m^2")
  k.I1 = constant("I1_m", at.I1 / m.mass, "moment across the axis over the mass, m^2")
  k.I3 = constant("I3_m", at.I3 / m.mass, "moment about the axis over the mass, m^2")
  k.G = constant("weight", at.G, "gravity, m/s^2")
  k.one = one
  return k
end

-- M = 0 for w, over the mass.
local function spin(k)
  local s, c, x, y, h = k.s, k.c, k.x, k.y, k.h
  return (k.I1 * n ^ 2 * s * c - n ^ 2 * s * y * h - k.G * k.b) / (n * (k.I3 * s - x * h))
end

local function steady_spin(m)
  local group = { why = "steady rolling: I1 n^2 s c - I3 n s w = m n h v + m G b, v = n s y - w x", defs = {} }
  local k = geometry(m, group)
  group.outs = { { result = true, expr = spin(k) } }
  return { name = "steady_spin", args = { "m", "tilt", "n" }, result = true, groups = { group },
    doc = { "The rate about the axis, rad/s, of steady rolling with the axis at `tilt` from the normal, rad, and the",
      "precession n about the normal, rad/s, not 0: the centre of mass moves on a circle, and N is the weight." } }
end

-- The square of the nutation's rate.
local function nod(k)
  local s, c, x, y, h, b, one = k.s, k.c, k.x, k.y, k.h, k.b, k.one
  local w = one("w", spin(k))
  local v = one("v", n * s * y - w * x)
  local f = one("f", (y * (k.I3 * k.m1 * w - n * c) + k.rho * (n * s ^ 2 + w * c) - n * h) / (1 + k.m1 * y ^ 2 +
    k.m3 * x ^ 2))
  local dn = one("n_slope", (k.I3 * k.m1 * w - 2 * n * c - k.m1 * y * f) / s)
  local dw = one("w_slope", k.m3 * x * f)
  local dv, db = n * c * y + k.rho * (n * s ^ 2 + w * c), k.rho - h
  local along = k.I1 * n ^ 2 * (c ^ 2 - s ^ 2) - k.I3 * n * c * w - n * (b * v + h * dv) - k.G * db
  local by_n = 2 * k.I1 * n * s * c - k.I3 * s * w - h * v - n * h * s * y
  local by_w = n * (h * x - k.I3 * s)
  return -(along + by_n * dn + by_w * dw) / (k.I1 + x ^ 2 + y ^ 2)
end

local function steady_nod(m)
  local group = { why = "small nutations about steady rolling: -(dM/dtheta)/(I1 + m r^2), M of steady_spin", defs = {} }
  group.outs = { { result = true, expr = nod(geometry(m, group)) } }
  return { name = "steady_nod", args = { "m", "tilt", "n" }, result = true, groups = { group },
    doc = { "The square of the rate, rad^2/s^2, at which the tilt nods about the steady rolling of steady_spin:",
      "positive where it is stable.  0 < tilt < pi, n not 0; the margins stable_.. tell of upright spins." } }
end

local bits = 128

-- The steady rolling of this tilt, by its sine and cosine, and rate w about the axis, rationals, parameters at their
-- defaults: a list of {n, nod}, of the roots of s (I1 c - m h y) n^2 - (I3 s - m h x) w n = m G b; nil where nothing
-- rolls so.  b is cancelled before it is evaluated: of a sphere about the centre of mass it is 0.
function steady.of(m, sine, cosine, w)
  if not rolls(m) then return nil end
  local group = { defs = {} }
  local k = geometry(m, group, true)
  local bare, square = #group.defs, nod(k)
  local below = { defs = table.move(group.defs, 3, bare, 1, {}) } -- sine and cosine, before, are given
  local lever = ratio.tidy(equations.inline({ below }, k.b))
  local function values(upto, precession) -- a function of expressions, with the definitions up to there
    local env = { n = precession }
    for name, x in pairs(m.defaults) do env[name] = x end -- into a table: order is lost anyway
    env[k.s.name], env[k.c.name] = sine, cosine -- the first two definitions
    local value = evaluate.within(env, bits)
    for i = 3, upto do env[group.defs[i].name] = value(group.defs[i].expr) end
    return value
  end
  local value = values(bare)
  local A, B = value(k.s * (k.I1 * k.c - k.h * k.y)), value(k.I3 * k.s - k.h * k.x) * w
  local C = value(k.G * lever)
  local square_root = B * B + R.new(4) * A * C
  local list = {}
  if R.sign(A) == 0 or R.sign(square_root) < 0 then return list end
  local wide = R.sign(square_root) > 0 and R.apply("sqrt", bits, square_root) or R.zero
  local far = (B + (R.sign(B) < 0 and -wide or wide)) / (R.new(2) * A)
  if R.sign(far) == 0 then return list end
  for _, root in ipairs { far, -C / A / far } do
    if R.sign(root) ~= 0 then list[#list + 1] = { n = root, nod = values(#group.defs, root)(square) } end
  end
  return list
end

-- The functions of the emitted code that are `made`, a function of their names; none where nothing rolls so.
function steady.list(m, made)
  local list = {}
  for _, f in ipairs { { "steady_spin", steady_spin }, { "steady_nod", steady_nod } } do
    if made(f[1]) and rolls(m) then list[#list + 1] = f[2](m) end
  end
  return list
end

return steady
