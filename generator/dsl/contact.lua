-- contact.lua -- the surface with which a body touches a plane, and effect.plane as a scene writes it.
--
--     contact.sphere { r =, at = {..} }                       contact.disc { r =, edge = 0, at = {..} }   axis: body z
--     contact.ellipsoid { a =, b =, c =, at = {..}, turned = rotation }
-- at: the centre of the surface, in the coordinates of the body's shapes.  Every surface is {half = {3 half axes},
-- axes = quaternion from the ellipsoid's axes to the body's, rim = radius of a ball that rolls over it, at =}: a sphere
-- has no half axes, a disc two, and its edge is the rim.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local args = require "generator.dsl.args"
local rotation = require "generator.dsl.rotation"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local contact = {}

local zero, one = expr.zero, expr.one
local object = { __name = "contact", __tostring = function() return "a contact surface" end }
local made = setmetatable({}, { __mode = "k" }) -- surfaces by their handles

local function length(name, sign, default) return { name = name, dim = "length", sign = sign, default = default } end

local at = { name = "at", dim = "length", size = 3, default = { 0, 0, 0 } }
local upright = { one, zero, zero, zero }

local kinds = {
  { name = "contact.sphere", about = "a sphere of radius r", args = { length("r", "positive"), at },
    build = function(a) return { half = { zero, zero, zero }, axes = upright, rim = a.r } end },
  { name = "contact.ellipsoid", about = "an ellipsoid of semi-axes a, b, c along x, y, z, turned before it is placed",
    args = { length("a", "positive"), length("b", "positive"), length("c", "positive"), at }, turned = true,
    build = function(a) return { half = { a.a, a.b, a.c }, axes = a.turned or upright, rim = zero } end },
  { name = "contact.disc", about = "the edge of a disc of radius r about z; edge: radius of its rounding",
    args = { length("r", "positive"), length("edge", "nonnegative", 0), at },
    build = function(a) return { half = { a.r, a.r, zero }, axes = upright, rim = a.edge, disc = true } end },
}
contact.kinds = kinds

-- The constructor of one kind.
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
      local a, ok = args.read(ctx, line, kind.name, kind.args, args.plain(given) and rest or given)
      local handle = setmetatable({}, object)
      if ok then
        a.turned = turned
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
local specs = { { name = "surface" }, { name = "law" }, { name = "friction" }, { name = "normal" },
  { name = "turntable" }, { name = "gravity" } }

local function friction(ctx, line, what, given)
  local where = ctx.diag:locate(line, "friction")
  local coulomb = args.plain(given) and given.coulomb ~= nil
  local list = coulomb and { { name = "coulomb", sign = "nonnegative" },
    { name = "smoothing", dim = "velocity", sign = "positive" } } or
    { { name = "viscous", dim = "slowness", sign = "nonnegative" } }
  local f, ok = args.read(ctx, where, what .. ": friction", list, given)
  if not ok then return nil end
  return { viscous = f.viscous, coulomb = f.coulomb, smoothing = f.smoothing }
end

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

local function gravity(ctx, line, what, given)
  local where = ctx.diag:locate(line, "gravity")
  if args.plain(given) then
    return args.vector(ctx, where, what, "gravity", { dim = "acceleration", size = 3 }, given)
  end
  local g = args.scalar(ctx, where, what, "gravity", { dim = "acceleration", sign = "nonnegative" }, given)
  return g and { zero, zero, -g }
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
    a.friction = friction(ctx, line, what, given.friction)
    ok = ok and a.friction ~= nil
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
