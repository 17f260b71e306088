-- solar_pressure.lua -- the pressure of sunlight on a set of flat plates that are fixed in the body.
--
-- For a plate of area A, unit normal n, reflectivity rho (the part that is mirrored; the rest is absorbed), s the unit
-- vector to the sun in body axes and c = n.s, on the lit side only, which (c + |c|)/2 says without a branch; |c| is
-- sqrt(c^2 + 2^-126), so that its derivative exists where c = 0, and beyond c = 1e-11 differs by less than rounding:
--     F = -P A c ((1 - rho) s + 2 rho c n),   P = flux/299792458 m/s,    N = sum centre x F
-- Plates do not shade each other, and each has one side: the other one is a plate with -n.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local solar = {
  name = "effect.solar_pressure",
  about = "sunlight on plates {area =, normal =, centre =, reflectivity =}, flux, sun (inertial direction)",
  takes = { { "plates[i].area", "m^2", nil, "of one side" },
    { "plates[i].normal", "1", nil, "outward, body axes, of any length" },
    { "plates[i].centre", "m", nil, "from the origin of rotation, body axes" },
    { "plates[i].reflectivity", "1", "0", "part that is mirrored, 0 to 1" },
    { "flux", "W/m^2", "1361", "power of sunlight per area" },
    { "sun", "1", nil, "direction to the sun, inertial axes, of any length" } },
  idle = { { "flux" }, "no plate has an area" },
  formula = "F = -flux/c0 A c ((1 - rho) s + 2 rho c n), c = (n.s + |n.s|)/2; N = sum of centre x F; " ..
    "c0 = 299792458 m/s",
  signs = "n outward, s to the sun: light pushes the lit side away from the sun; the dark side feels nothing",
  source = "Wertz, Spacecraft Attitude Determination and Control, 17.2.2 (without diffuse reflection); flux: Kopp, " ..
    "Lean, Geophys. Res. Lett. 38 (2011) L01706",
  example = "solar_sail",
}

local smallest = expr.num(R.new(2) ^ -126)
local most_plates = 64
local comp = { "x", "y", "z" }

function solar.read(ctx, line, what, given, args)
  local a, ok = args.read(ctx, line, what, { { name = "flux", dim = "flux", sign = "nonnegative", default = 1361 },
    { name = "sun", size = 3 } }, given, { "plates" })
  local at, list = ctx.diag:locate(line, "plates"), given.plates
  if not args.plain(list) or #list < 1 or #list > most_plates or not args.list(list, #list) then
    ctx.diag:error(at, what, "plates must be a list of 1 to " .. most_plates .. " plates", list ~= nil and
      tostring(args.plain(list) and #list or list) or nil)
    return nil
  end
  a.plates = {}
  for i = 1, #list do
    local whose = what .. ", plates[" .. i .. "]"
    local p, good = args.read(ctx, at, whose, { { name = "area", dim = "area", sign = "nonnegative" },
      { name = "normal", size = 3 }, { name = "centre", dim = "length", size = 3 },
      { name = "reflectivity", sign = "nonnegative", default = 0 } }, list[i])
    if good then
      good = args.condition(ctx, at, whose, "normal must not be zero", vec.dot(p.normal, p.normal), "{0, 0, 0}") and
        args.condition(ctx, at, whose, "reflectivity must not be above 1", 1 - p.reflectivity,
          tostring(list[i].reflectivity), true)
    end
    a.plates[i], ok = p, ok and good
  end
  return ok and a or nil
end

function solar.check(a) return { { vec.dot(a.sun, a.sun), "sun must not be zero" } } end

local function unit(v)
  local n = expr.sqrt(vec.dot(v, v))
  return vec.map(v, function(x) return ratio.tidy(x / n) end)
end

-- The sun's direction in body axes.
local function sunward(a, c)
  local sun = vec.map(unit(a.sun), function(x, i) return c.constant("s" .. comp[i], x, "direction of the sun") end)
  return vec.matvec(vec.transpose(vec.rotation(c.q)), sun)
end

local function normal(p, c)
  return vec.map(unit(p.normal), function(x, i) return c.constant("n" .. comp[i], x, "normal of a plate") end)
end

-- The force on each plate in body axes.
local function forces(a, c)
  local s = sunward(a, c)
  return vec.map(a.plates, function(p)
    local push = a.flux / 299792458 * p.area / 2
    local n = normal(p, c)
    local cosine = vec.dot(n, s)
    local lit = cosine + expr.sqrt(cosine ^ 2 + smallest) -- twice the cosine, or 0
    local taken = c.constant("absorbed", push * (1 - p.reflectivity), "(1 - rho) P A/2, N")
    local thrown = c.constant("mirrored", push * p.reflectivity, "rho P A/2, N")
    return vec.scale(-lit, vec.add(vec.scale(taken, s), vec.scale(thrown * lit, n)))
  end)
end

function solar.torque(a, c)
  local N = { expr.zero, expr.zero, expr.zero }
  for i, F in ipairs(forces(a, c)) do
    local r = vec.map(a.plates[i].centre, function(x, k)
      return c.constant("centre" .. comp[k], x, "centre of a plate, m")
    end)
    N = vec.add(N, vec.cross(r, F))
  end
  return N
end

function solar.force(a, c)
  local sum = { expr.zero, expr.zero, expr.zero }
  for _, F in ipairs(forces(a, c)) do sum = vec.add(sum, F) end
  return vec.matvec(vec.rotation(c.q), sum)
end

-- Eight numbers a plate: area, reflectivity, normal, centre.
function solar.numeric(a, num)
  local rows = {}
  for _, p in ipairs(a.plates) do
    for _, list in ipairs { { p.area, p.reflectivity }, p.normal, p.centre } do
      for _, x in ipairs(list) do rows[#rows + 1] = num(x) end
    end
  end
  return { kind = "solar_pressure", flux = num(a.flux), sun = vec.map(a.sun, num), plates = rows }
end

return solar
