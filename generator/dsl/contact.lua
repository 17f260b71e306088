-- contact.lua -- the surface with which a body touches a plane, and effect.plane as a scene writes it.
--
--     contact.sphere { r =, at = {..} }                       contact.disc { r =, edge = 0, at = {..} }   axis: body z
--     contact.ellipsoid { a =, b =, c =, at = {..}, turned = rotation }
--     contact.paraboloid { a =, b =, at = {..}, turned = rotation }       a, b: radii of curvature of its lowest point
--     contact.support { h = function(n) return .. end, at = {..}, turned = rotation }
-- at: the centre of the surface, in the coordinates of the body's shapes (a paraboloid's: its lowest point).  Every
-- surface is {half = {3 lengths}, axes = quaternion from the surface's axes to the body's, rim = radius of a ball that
-- rolls over it, at =}: a sphere has no half axes, a disc two, and its edge is the rim.  h is the distance from `at` to
-- the plane that touches the surface where its outward normal is n, a unit vector in the surface's axes.  open: the
-- surface need not have a point for every normal.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local args = require "generator.dsl.args"
local rotation = later "generator.dsl.rotation"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local contact = {}

local zero, one = expr.zero, expr.one
local object = { __name = "contact", __tostring = function() return "a contact surface" end }
local made = setmetatable({}, { __mode = "k" }) -- surfaces by their handles

local function length(name, sign, default) return { name = name, dim = "length", sign = sign, default = default } end

local at = { name = "at", dim = "length", size = 3, default = { 0, 0, 0 } }
local upright = { one, zero, zero, zero }

-- ---- support functions ----

-- Components of the outward normal in a support function.
contact.normals = { motion.sym "@nx", motion.sym "@ny", motion.sym "@nz" }

-- Unit vectors with rational components: the sphere seen from a pole, and its mirror image.
local function directions()
  local list = {}
  for a = -2, 2 do
    for b = -2, 2 do
      local x, y = R.new(a, 2), R.new(b, 2)
      local d = R.new(1) + x * x + y * y
      for _, up in ipairs { 1, -1 } do
        list[#list + 1] = { R.new(2) * x / d, R.new(2) * y / d, R.new(up) * (R.new(2) / d - R.new(1)) }
      end
    end
  end
  return list
end

-- The surface of h is convex where its radii of curvature are not negative.  They are those of A = H + (h - n.G) 1
-- across n, with the gradient G and the matrix H of second derivatives of h: their sum is tr H - n.H n + 2 (h - n.G),
-- their product n.adj(A) n.  Looked at in 50 directions, for the parameters' defaults; there is no surface where h has
-- no value.
local function convex(ctx, line, what, h)
  local n = contact.normals
  local G = vec.map(n, function(x) return calculus.diff(h, x) end)
  local H = {}
  for i, p in ipairs(vec.pair) do H[i] = calculus.diff(G[p[1]], n[p[2]]) end
  local c, none = h - vec.dot(n, G), 0
  local A = { H[1] + c, H[2] + c, H[3] + c, H[4], H[5], H[6] }
  local sum = vec.trace(H) - vec.dot(n, vec.apply(H, n)) + 2 * c
  local product = vec.dot(n, vec.apply((vec.adjugate(A)), n))
  local least = -(R.new(2) ^ -100)
  for _, d in ipairs(directions()) do
    local map = {}
    for i = 1, 3 do map[n[i]] = expr.num(d[i]) end
    local ok, s, p = pcall(function()
      return value.number(calculus.substitute(sum, map)), value.number(calculus.substitute(product, map))
    end)
    if not ok or not s or not p then
      none = none + 1
    elseif s < least or p < least then
      ctx.diag:error(line, what, "h must belong to a convex surface: its radii of curvature must not be negative",
        string.format("they are at n = {%s, %s, %s}", tostring(d[1]), tostring(d[2]), tostring(d[3])))
      return false
    end
  end
  if none == 50 then ctx.diag:error(line, what, "h has no value, or no second derivative, in any direction") end
  return none < 50
end

-- The expression of h in the symbols of the normal; nil after errors.
local function support(ctx, line, what, given)
  local where = ctx.diag:locate(line, "h")
  if type(given) ~= "function" then
    ctx.diag:error(where, what, "h must be a function of the outward normal: function(n) return ... end",
      diag.show(given))
    return nil
  end
  local normal = vec.map(contact.normals, function(x) return value.new(x, units.none, true) end) -- as plain as t
  local h = args.scalar(ctx, where, what, "h", { dim = "length", motion = true }, given(normal))
  if not h then return nil end
  for _, x in ipairs(expr.symbols(h)) do
    if x.rank == motion.rank and not string.find(x.name, "^@n[xyz]$") then
      ctx.diag:error(where, what, "h must depend on the normal and on parameters only", (string.gsub(x.name, "^@", "")))
      return nil
    end
  end
  return convex(ctx, where, what, h) and h or nil
end

-- ---- surfaces ----

local kinds = {
  { name = "contact.sphere", about = "a sphere of radius r", args = { length("r", "positive"), at },
    build = function(a) return { half = { zero, zero, zero }, axes = upright, rim = a.r } end },
  { name = "contact.ellipsoid", about = "an ellipsoid of semi-axes a, b, c along x, y, z, turned before it is placed",
    args = { length("a", "positive"), length("b", "positive"), length("c", "positive"), at }, turned = true,
    build = function(a) return { half = { a.a, a.b, a.c }, axes = a.turned or upright, rim = zero } end },
  { name = "contact.disc", about = "the edge of a disc of radius r about z; edge: radius of its rounding",
    args = { length("r", "positive"), length("edge", "nonnegative", 0), at },
    build = function(a) return { half = { a.r, a.r, zero }, axes = upright, rim = a.edge, disc = true } end },
  { name = "contact.paraboloid", about = "z = x^2/(2 a) + y^2/(2 b): a, b are the radii of curvature of its lowest " ..
    "point, which is `at`; turned before it is placed",
    args = { length("a", "positive"), length("b", "positive"), at }, turned = true,
    build = function(a)
      return { half = { a.a, a.b, zero }, axes = a.turned or upright, rim = zero, paraboloid = true, open = true }
    end },
  { name = "contact.support", about = "any smooth convex surface: h = function(n) is the distance from `at` to the " ..
    "plane that touches it where its outward normal is the unit vector n; turned before it is placed",
    args = { at }, turned = true, support = true,
    build = function(a)
      return { half = { zero, zero, zero }, axes = a.turned or upright, rim = zero, support = a.h, open = true }
    end },
}
contact.kinds = kinds

-- The constructor of one kind.
-- A handle with errors is a surface that is broken: nothing more is said of it.
function contact.constructor(ctx)
  return function(kind)
    return function(given)
      local line = ctx.diag:here()
      local turned
      local rest = {}
      for k, v in pairs(args.plain(given) and given or {}) do rest[k] = v end -- into a table: order is lost anyway
      if kind.turned and rest.turned ~= nil then
        turned = rotation.read(ctx, ctx.diag:locate(line, "turned"), kind.name, rest.turned)
        rest.turned = nil
      end
      local h
      if kind.support and args.plain(given) then
        h = support(ctx, line, kind.name, rest.h)
        rest.h = nil
      end
      local a, ok = args.read(ctx, line, kind.name, kind.args, args.plain(given) and rest or given,
        kind.support and { "h" })
      local handle = setmetatable({}, object)
      if ok and (h or not kind.support) then
        a.turned, a.h = turned, h
        local s = kind.build(a)
        s.at, s.name = a.at, kind.name
        made[handle] = s
      else
        made[handle] = { broken = true }
      end
      return handle
    end
  end
end

local laws = { rolling = true, smooth = true, sliding = true }
local specs = { { name = "surface" }, { name = "law" }, { name = "friction" }, { name = "spinning" },
  { name = "rolling_resistance" }, { name = "normal" }, { name = "turntable" }, { name = "gravity" },
  { name = "impact" } }

-- Dimensions of {viscous, coulomb, smoothing}: of a force per N against a velocity, of a torque per N against a rate.
-- (friction: N s/m per N; spinning: N m s per N, and N m per N)
local against = {
  friction = { "slowness", "none", "velocity" },
  spinning = { units.times(units.length, units.time), "length", "rate" },
}
against.rolling_resistance = against.spinning

-- {viscous} or {coulomb, smoothing}, the others nil; key: which of the three it is.
local function resistance(ctx, line, what, key, given)
  local where = ctx.diag:locate(line, key)
  local coulomb, dims = args.plain(given) and given.coulomb ~= nil, against[key]
  local list = coulomb and { { name = "coulomb", dim = dims[2], sign = "nonnegative" },
    { name = "smoothing", dim = dims[3], sign = "positive" } } or
    { { name = "viscous", dim = dims[1], sign = "nonnegative" } }
  local f, ok = args.read(ctx, where, what .. ": " .. key, list, given)
  if not ok then return nil end
  return { viscous = f.viscous, coulomb = f.coulomb, smoothing = f.smoothing }
end

-- The torques against spinning and rolling; false after errors.
local function resistances(ctx, line, what, given, a)
  local ok = true
  for _, key in ipairs { "spinning", "rolling_resistance" } do
    if given[key] ~= nil and a.law == "smooth" then
      ctx.diag:error(ctx.diag:locate(line, key), what, key .. " needs law = \"rolling\" or \"sliding\"",
        diag.show(given[key]))
      ok = false
    elseif given[key] ~= nil then
      a[key] = resistance(ctx, line, what, key, given[key])
      ok = ok and a[key] ~= nil
    end
  end
  return ok
end

-- Of numbers alone, for the axes e1 and e2 are chosen by them.
local function normal(ctx, line, what, given)
  local where = ctx.diag:locate(line, "normal")
  local n = args.vector(ctx, where, what, "normal", { size = 3 }, given)
  if not n then return nil end
  for i = 1, 3 do
    if not expr.constant(n[i]) then
      ctx.diag:error(where, what, "normal must be numbers: it cannot depend on parameters", diag.show(given))
      return nil
    end
  end
  return args.condition(ctx, where, what, "normal must not be zero", vec.dot(n, n), diag.show(given)) and n or nil
end

-- A number is along -z.
local function gravity(ctx, line, what, given)
  local where = ctx.diag:locate(line, "gravity")
  if args.plain(given) then
    return args.vector(ctx, where, what, "gravity", { dim = "acceleration", size = 3 }, given)
  end
  local g = args.scalar(ctx, where, what, "gravity", { dim = "acceleration", sign = "nonnegative" }, given)
  return g and { zero, zero, -g }
end

-- Restitution e of 0 to 1; of a law with friction its coefficient, which is that of {coulomb = mu} unless it is given,
-- and the restitution along the plane, -1 to 1.  A rolling body sticks: friction is nil.
local function impact(ctx, line, what, given, a)
  local where = ctx.diag:locate(line, "impact")
  local list, slides = { { name = "restitution", sign = "nonnegative" } }, a.law == "sliding"
  what = what .. ": impact"
  if slides then
    list[2] = { name = "friction", sign = "nonnegative", default = a.friction.coulomb and 0 or nil }
    list[3] = { name = "tangential", default = 0 }
  end
  local own, ok = args.read(ctx, where, what, list, given)
  if not ok then return nil end
  ok = args.condition(ctx, where, what, "restitution must not be above 1", one - own.restitution,
    diag.show(given.restitution), true)
  if not slides then return ok and { restitution = own.restitution, friction = a.law == "smooth" and zero or nil } end
  if given.friction == nil then own.friction = a.friction.coulomb end
  for _, sign in ipairs { 1, -1 } do
    local left = one - expr.num(R.new(sign)) * own.tangential
    ok = args.condition(ctx, where, what, "tangential must be from -1 to 1", left, diag.show(given.tangential), true)
      and ok
  end
  return ok and own or nil
end

-- A unit vector in the plane, as near to inertial x as there is; as near to y where the normal is within 6 degrees of
-- x for the scene's own parameters, so that no digits are lost.
local function along(n)
  local function square(e)
    local x = value.number(e)
    return x * x
  end
  local k = square(n[2]) + square(n[3]) < square(n[1]) / R.new(100) and 2 or 1
  local e = vec.map(n, function(x, i) return (i == k and vec.dot(n, n) or zero) - n[k] * x end)
  return vec.scale(one / expr.sqrt(vec.dot(e, e)), e)
end

-- The arguments of effect.plane.
function contact.plane(ctx, line, what, given)
  args.unknown(ctx, line, what, specs, given)
  local s, a, ok = made[given.surface], {}, true
  if given.surface == nil then
    ctx.diag:error(line, what, "surface is missing")
    ok = false
  elseif not s then
    ctx.diag:error(ctx.diag:locate(line, "surface"), what, "surface must be a contact such as contact.sphere{ r = 1 }",
      diag.show(given.surface))
    ok = false
  end
  a.law = given.law == nil and "rolling" or given.law
  if not laws[a.law] then
    ctx.diag:error(ctx.diag:locate(line, "law"), what, "law must be \"rolling\", \"smooth\" or \"sliding\"",
      diag.show(given.law))
    ok = false
  end
  if (a.law == "sliding") ~= (given.friction ~= nil) and laws[a.law] then
    ctx.diag:error(ctx.diag:locate(line, "friction"), what, a.law == "sliding" and
      "law = \"sliding\" needs friction = { viscous = c } or { coulomb = mu, smoothing = e }" or
      "friction needs law = \"sliding\"", diag.show(given.friction))
    ok = false
  elseif given.friction ~= nil then
    a.friction = resistance(ctx, line, what, "friction", given.friction)
    ok = ok and a.friction ~= nil
  end
  ok = resistances(ctx, line, what, given, a) and ok
  if given.impact ~= nil and laws[a.law] and ok then
    a.impact, a.given_gravity = impact(ctx, line, what, given.impact, a), given.gravity
    ok = a.impact ~= nil
  end
  local n = normal(ctx, line, what, given.normal or { 0, 0, 1 })
  a.gravity = gravity(ctx, line, what, given.gravity or 9.80665)
  a.rate = args.scalar(ctx, ctx.diag:locate(line, "turntable"), what, "turntable", { dim = "rate" },
    given.turntable or 0)
  if not ok or not n or not a.gravity or not a.rate or s.broken then return nil end
  a.normal = vec.scale(one / expr.sqrt(vec.dot(n, n)), n)
  a.e1 = along(n)
  a.e2 = vec.cross(a.normal, a.e1)
  if a.law == "smooth" and a.rate ~= zero then
    ctx.diag:error(ctx.diag:locate(line, "turntable"), what, "turntable has no effect on a smooth plane")
    return nil
  end
  a.surface = s
  return a
end

return contact
