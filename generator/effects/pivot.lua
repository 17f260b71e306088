-- pivot.lua -- the support moves: the origin of rotation, carried along without turning, has the acceleration a(t).
--
-- About the moving origin the inertial force -m a acts at the centre of mass, beside gravity:
--     N = r x R(q)^T (-m a(t))            r the centre of mass from the origin
-- a is given in inertial axes, component by component, or as a vibration along an axis: the support is at
-- amplitude cos(rate t) along it, so a = -amplitude rate^2 cos(rate t).  There is no potential; the support does work.
-- A rod upside down stands if amplitude^2 rate^2 > 2 g l, l = I/(m r) (Kapitza).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local pivot = {
  name = "effect.pivot",
  about = "the support moves: acceleration (inertial, expressions of t and inputs), or amplitude, rate and axis of " ..
    "a vibration",
  keeps = "L_z if the support moves along z, w3 if the centre of mass is on the body's z",
  fixed = "its support is the origin of rotation",
  takes = { { "acceleration", "m/s^2", nil, "of the support, inertial axes: numbers, or expressions of t and inputs" },
    { "amplitude", "m", nil, "or: of a vibration amplitude cos(rate t)" }, { "rate", "rad/s", nil, "of the vibration" },
    { "axis", "1", "{0, 0, 1}", "of the vibration, inertial axes, of any length" } },
  idle = { { "acceleration", "amplitude", "rate" }, "the origin is the centre of mass, about which the support " ..
    "exerts no torque (origin = ... is the fixed point about which the body turns)" },
  formula = "N = r x R(q)^T (-m a(t)); vibration: a = -amplitude rate^2 cos(rate t) axis/|axis|",
  signs = "a is the support's acceleration in inertial axes; the vibration starts at its turning point on the axis",
  source = "Landau, Lifshitz, Mechanics, sections 30 and 39; Kapitza, Usp. Fiz. Nauk 44 (1951) 7",
  example = "kapitza",
}

local comp = { "x", "y", "z" }

function pivot.read(ctx, line, what, given, args)
  if (given.acceleration == nil) == (given.amplitude == nil) then
    ctx.diag:error(line, what, "give acceleration, or amplitude and rate, one of them")
    return nil
  end
  if given.acceleration == nil then
    local a, ok = args.read(ctx, line, what, { { name = "amplitude", dim = "length" }, { name = "rate", dim = "rate" },
      { name = "axis", size = 3, default = { 0, 0, 1 } } }, given)
    return ok and a or nil
  end
  args.unknown(ctx, line, what, { { name = "acceleration" } }, given)
  local at = ctx.diag:locate(line, "acceleration")
  local v = args.vector(ctx, at, what, "acceleration", { dim = "acceleration", size = 3, motion = true },
    given.acceleration)
  if not v then return nil end
  for i, x in ipairs(v) do
    for _, s in ipairs(expr.symbols(x)) do
      if s.rank >= motion.rank and s.name ~= "t" and not string.find(s.name, "^u_") then
        ctx.diag:error(at, what, "acceleration[" .. i .. "] must depend on time and inputs only", s.name)
        return nil
      end
    end
  end
  return { acceleration = v }
end

function pivot.check(a) return a.axis and { { vec.dot(a.axis, a.axis), "axis must not be zero" } } or {} end

-- The acceleration of the support times the mass, each component's constants kept.
local function load(a, c)
  if a.acceleration then
    return vec.map(a.acceleration, function(x, i)
      return c.lift(c.mass * x, "ma" .. comp[i], "mass times acceleration of the support, N")
    end)
  end
  local n = expr.sqrt(vec.dot(a.axis, a.axis))
  local wave = expr.call("cos", c.constant("shake", a.rate, "rate of the support, rad/s") * c.t)
  return vec.map(a.axis, function(x, i)
    return wave * c.constant("ma" .. comp[i], ratio.tidy(-c.mass * a.amplitude * a.rate ^ 2 * x / n),
      "mass times largest acceleration of the support, N")
  end)
end

function pivot.torque(a, c)
  local r = vec.map(c.com, function(x, i)
    return c.constant("com" .. comp[i], ratio.tidy(x), "centre of mass " .. comp[i] .. ", m")
  end)
  return vec.cross(vec.matvec(vec.transpose(vec.rotation(c.q)), load(a, c)), r)
end

-- As of gravity, whose place the support's acceleration takes.
function pivot.conserves(a, c)
  local list, v = {}, a.acceleration or a.axis
  if v[1] == expr.zero and v[2] == expr.zero then list[1] = "L_z" end
  if c.com[1] == expr.zero and c.com[2] == expr.zero then list[#list + 1] = "w3" end
  return list
end

function pivot.numeric(a, num, _, code)
  if not a.acceleration then
    return { kind = "pivot", amplitude = num(a.amplitude), rate = num(a.rate), axis = vec.map(a.axis, num) }
  end
  return { kind = "pivot", acceleration = vec.map(a.acceleration, function(e)
    if motion.free(e) then return num(e) end
    return { code = code(e) }
  end) }
end

return pivot
