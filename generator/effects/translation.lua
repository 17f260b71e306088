-- translation.lua -- the body moves through space: position and velocity of its centre of mass.
--
--     m r'' = m g - c |v| v - c1 v - (kx x, ky y, kz z)
-- gravity: a number (along -z) or a vector; drag c and linear c1 act along the velocity at the centre of mass, without
-- a torque; stiffness: a restoring force towards the origin (a long pendulum's, a trap's; negative: it repels), our
-- extension.
-- |v| is written sqrt(v^2 + 2^-126 m^2/s^2), so that its derivatives exist at rest; above 1e-11 m/s the difference is
-- below rounding in double.  In a rotating frame r and v are relative to it, and gravity is fixed in it.
-- force (inertial axes, or the frame's) and thrust (body axes) also act at the centre of mass; they may vary.
-- Drag: Landau, Lifshitz, Fluid Mechanics, section 45.
-- Conserves T + V without drag, and what belongs to the turning.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local custom = require "generator.effects.custom"

local translation = {
  name = "effect.translation",
  about = "the centre of mass moves: gravity (number or vector), drag c (-c |v| v), linear c (-c v), stiffness " ..
    "(-k r), force (inertial), thrust (body)",
  takes = { { "gravity", "m/s^2", "9.80665", "a number (along -z) or a vector" },
    { "drag", "kg/m", "0", "c of -c |v| v, not negative" }, { "linear", "kg/s", "0", "c1 of -c1 v" },
    { "stiffness", "kg/s^2", "0", "a number or three, of -k r" },
    { "force", "kg m/s^2", "{0, 0, 0}", "inertial axes: numbers or expressions" },
    { "thrust", "kg m/s^2", "{0, 0, 0}", "body axes: numbers or expressions" } },
  formula = "m r'' = m g - drag |v| v - linear v - k r + force + R(q) thrust, V = -m g.r + k r^2/2",
  signs = "r is the centre of mass from the inertial origin (the frame's, if one turns); drag has no torque",
  source = "Landau, Lifshitz, Fluid Mechanics, 2nd ed., section 45 (drag)",
  example = "thrown_book",
  single = true, keeps = "T+V without drag, force and thrust, and all that belongs to the turning",
}

local comp = { "x", "y", "z" }
local none = { expr.zero, expr.zero, expr.zero }

-- Force and thrust in inertial axes; both zero: nothing.
local function pushes(a, c)
  local function lifted(v, name, about)
    return vec.map(v, function(x, i) return c.lift(x, name .. comp[i], about .. " " .. comp[i] .. ", N") end)
  end
  local force, thrust = lifted(a.force, "force", "force"), lifted(a.thrust, "thrust", "thrust")
  if not translation.pushed { force = none, thrust = a.thrust } then return force end
  return vec.add(force, vec.matvec(vec.rotation(c.q), thrust))
end

-- Is there a force or a thrust?
function translation.pushed(a)
  for i = 1, 3 do
    if a.force[i] ~= expr.zero or a.thrust[i] ~= expr.zero then return true end
  end
  return false
end
local specs = { { name = "gravity", dim = "acceleration" }, { name = "drag", dim = "drag", sign = "nonnegative" },
  { name = "linear", dim = "friction", sign = "nonnegative" },
  { name = "stiffness", dim = "stiffness" }, { name = "force", dim = "force", size = 3, motion = true },
  { name = "thrust", dim = "force", size = 3, motion = true } }

-- Own reading: gravity and stiffness are numbers or vectors.
function translation.read(ctx, line, what, given, args)
  args.unknown(ctx, line, what, specs, given)
  local a, ok = {}, true
  for _, spec in ipairs(specs) do
    local x, at = given[spec.name], ctx.diag:locate(line, spec.name)
    if x == nil and spec.name == "gravity" then x = 9.80665 end
    if x ~= nil and (spec.name == "gravity" or spec.name == "stiffness") and args.plain(x) then
      a[spec.name] = args.vector(ctx, at, what, spec.name, { dim = spec.dim, size = 3, sign = spec.sign }, x)
    elseif x ~= nil and spec.size then
      a[spec.name] = args.vector(ctx, at, what, spec.name, spec, x)
    elseif x ~= nil then
      a[spec.name] = args.scalar(ctx, at, what, spec.name, spec, x)
    end
    ok = ok and (x == nil or a[spec.name] ~= nil)
  end
  if not ok then return nil end
  local k, g = a.stiffness or expr.zero, a.gravity
  return { gravity = expr.is(g) and { expr.zero, expr.zero, -g } or g, drag = a.drag or expr.zero,
    linear = a.linear or expr.zero, stiffness = expr.is(k) and { k, k, k } or k, isotropic = expr.is(k),
    force = a.force or none, thrust = a.thrust or none }
end

function translation.moves() return true end

-- Weight per unit mass and stiffnesses as constants.
local function strengths(a, c)
  local g = vec.map(a.gravity, function(x, i) return c.constant("g" .. comp[i], x, "gravity, m/s^2") end)
  local k = vec.map(a.stiffness, function(x, i)
    return c.per_mass("k" .. (a.isotropic and "" or comp[i]), x, "stiffness, N/m")
  end)
  return g, k
end

translation.strengths = strengths

-- Weight, drag and stiffness in terms of M, the mass as a symbol, which cancels in m r'' = F.
function translation.force(a, c)
  local g, k = strengths(a, c)
  local drag = c.per_mass("drag", a.drag, "drag, N s^2/m^2")
  local linear = c.per_mass("linear", a.linear, "linear drag, N s/m")
  local speed = expr.sqrt(vec.dot(c.v, c.v) + expr.num(R.new(2) ^ -126))
  local push = pushes(a, c)
  return vec.map(g, function(x, i) return c.M * x - k[i] * c.r[i] - (linear + drag * speed) * c.v[i] + push[i] end)
end

function translation.potential(a, c)
  local g, k = strengths(a, c)
  return expr.lift "1/2" * vec.dot(k, vec.map(c.r, function(x) return x ^ 2 end)) - c.M * vec.dot(g, c.r)
end

function translation.conserves(a)
  local quiet = a.drag == expr.zero and a.linear == expr.zero and not translation.pushed(a)
  return quiet and { "T+V", "L", "w3" } or { "L", "w3" }
end

-- Force and thrust are an act of their own there.
function translation.numeric(a, num, _, code, c)
  local push = translation.pushed(a) and custom.told(nil, pushes(a, c), code) or nil
  return { kind = "translation", gravity = vec.map(a.gravity, num), drag = num(a.drag), linear = num(a.linear),
    stiffness = vec.map(a.stiffness, num) }, push
end

return translation
