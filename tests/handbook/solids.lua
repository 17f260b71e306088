-- solids.lua - blocks, cylinders, cones, balls and what is cut from them, as handbooks print them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The form of a row: tests/handbook.lua.  Sources: Beer and Johnston, Vector Mechanics, tables of mass moments; Meriam
-- and Kraige, Dynamics, table D/4; Weisstein, MathWorld ("Conical Frustum", "Spherical Cap", "Spherical Sector",
-- "Capsule", "Steinmetz Solid", "Cylindrical Wedge", "Paraboloid", "Elliptic Cone"); Wikipedia, "List of moments of
-- inertia".  What has none is an elementary integral, written out.

local rows = {}
local function row(shape, args, params, at, of)
  rows[#rows + 1] = { shape = shape, args = args, params = params, at = at, of = of }
end

local function axial(x, z) return { x, x, z, 0, 0, 0 } end
local function height(z) return { 0, 0, z } end

row("solid.box", "x = a, y = b, z = c", { "a", "b", "c" }, { a = 3, b = 2, c = 1.5 }, function(e)
  return { measure = e.a * e.b * e.c,
    I = { (e.b ^ 2 + e.c ^ 2) / 12, (e.a ^ 2 + e.c ^ 2) / 12, (e.a ^ 2 + e.b ^ 2) / 12, 0, 0, 0 },
    points = { corner = { -e.a / 2, -e.b / 2, -e.c / 2 } } }
end)
row("solid.cylinder", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  return { measure = f.pi * e.r ^ 2 * e.h, I = axial((3 * e.r ^ 2 + e.h ^ 2) / 12, e.r ^ 2 / 2),
    points = { base = height(-e.h / 2), top = height(e.h / 2) } }
end)
row("solid.elliptic_cylinder", "a = a, b = b, h = h", { "a", "b", "h" }, { a = 1.4, b = 0.9, h = 2.5 },
  function(e, f)
    return { measure = f.pi * e.a * e.b * e.h,
      I = { (3 * e.b ^ 2 + e.h ^ 2) / 12, (3 * e.a ^ 2 + e.h ^ 2) / 12, (e.a ^ 2 + e.b ^ 2) / 4, 0, 0, 0 },
      points = { base = height(-e.h / 2), top = height(e.h / 2) } }
  end)
row("solid.tube", "r_in = s, r_out = s + d, h = h", { "s", "d", "h" }, { s = 0.7, d = 0.4, h = 2.5 }, function(e, f)
  local p, q = e.s, e.s + e.d
  return { measure = f.pi * (q ^ 2 - p ^ 2) * e.h,
    I = axial((3 * (p ^ 2 + q ^ 2) + e.h ^ 2) / 12, (p ^ 2 + q ^ 2) / 2),
    points = { base = height(-e.h / 2), top = height(e.h / 2) } }
end)
row("solid.cone", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  return { measure = f.pi * e.r ^ 2 * e.h / 3, com = height(e.h / 4),
    I = axial(3 * (4 * e.r ^ 2 + e.h ^ 2) / 80, 3 * e.r ^ 2 / 10),
    points = { apex = height(e.h), base = height(0) } }
end)
row("solid.elliptic_cone", "a = a, b = b, h = h", { "a", "b", "h" }, { a = 1.4, b = 0.9, h = 2.5 }, function(e, f)
  return { measure = f.pi * e.a * e.b * e.h / 3, com = height(e.h / 4),
    I = { 3 * e.b ^ 2 / 20 + 3 * e.h ^ 2 / 80, 3 * e.a ^ 2 / 20 + 3 * e.h ^ 2 / 80, 3 * (e.a ^ 2 + e.b ^ 2) / 20,
      0, 0, 0 }, points = { apex = height(e.h), base = height(0) } }
end)
-- Beer and Johnston give zz as 3 (R^5 - r^5)/10/(R^3 - r^3); z^2: int z^2 rho^2 dz with rho linear in z
row("solid.frustum", "r_base = p + d, r_top = p, h = h", { "p", "d", "h" }, { p = 0.5, d = 0.8, h = 2.5 },
  function(e, f)
    local R, q = e.p + e.d, e.p
    local s, xx = R ^ 2 + R * q + q ^ 2, 3 * (R ^ 5 - q ^ 5) / (R ^ 3 - q ^ 3) / 20
    return { measure = f.pi * e.h * s / 3, com = height(e.h * (R ^ 2 + 2 * R * q + 3 * q ^ 2) / (4 * s)),
      S = { xx, xx, e.h ^ 2 * (R ^ 2 + 3 * R * q + 6 * q ^ 2) / (10 * s), 0, 0, 0 },
      points = { base = height(0), top = height(e.h) } }
  end)
row("solid.half_cylinder", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  return { measure = f.pi * e.r ^ 2 * e.h / 2, com = { 4 * e.r / (3 * f.pi), 0, 0 },
    S = { e.r ^ 2 / 4, e.r ^ 2 / 4, e.h ^ 2 / 12, 0, 0, 0 }, points = { axis = height(0) } }
end)
row("solid.quarter_cylinder", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  local c = 4 * e.r / (3 * f.pi)
  return { measure = f.pi * e.r ^ 2 * e.h / 4, com = { c, c, 0 },
    S = { e.r ^ 2 / 4, e.r ^ 2 / 4, e.h ^ 2 / 12, e.r ^ 2 / (2 * f.pi), 0, 0 }, points = { axis = height(0) } }
end)
row("solid.hoof", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  return { measure = 2 * e.r ^ 2 * e.h / 3, com = { 3 * f.pi * e.r / 16, 0, 3 * f.pi * e.h / 32 },
    S = { 2 * e.r ^ 2 / 5, e.r ^ 2 / 5, 2 * e.h ^ 2 / 15, 0, e.r * e.h / 5, 0 },
    points = { axis = height(0), tip = { e.r, 0, e.h } } }
end)
row("solid.paraboloid", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  return { measure = f.pi * e.r ^ 2 * e.h / 2, com = height(2 * e.h / 3),
    I = axial((3 * e.r ^ 2 + e.h ^ 2) / 18, e.r ^ 2 / 3), points = { vertex = height(0), top = height(e.h) } }
end)
row("solid.bicylinder", "r = r", { "r" }, { r = 1.2 }, function(e)
  return { measure = 16 * e.r ^ 3 / 3, I = axial(7 * e.r ^ 2 / 15, 8 * e.r ^ 2 / 15) }
end)

-- ---- round ----

local function poles(r) return { pole = height(r), bottom = height(-r) } end

row("solid.sphere", "r = r", { "r" }, { r = 1.2 }, function(e, f)
  return { measure = 4 * f.pi * e.r ^ 3 / 3, I = axial(2 * e.r ^ 2 / 5, 2 * e.r ^ 2 / 5), points = poles(e.r) }
end)
row("solid.ellipsoid", "a = a, b = b, c = c", { "a", "b", "c" }, { a = 1.4, b = 0.9, c = 0.6 }, function(e, f)
  local a, b, c = e.a ^ 2, e.b ^ 2, e.c ^ 2
  return { measure = 4 * f.pi * e.a * e.b * e.c / 3, I = { (b + c) / 5, (a + c) / 5, (a + b) / 5, 0, 0, 0 },
    points = poles(e.c) }
end)
-- radii of their own: the sum of two would be rounded, and a thin wall is sensitive to that
row("solid.hollow_sphere", "r_in = p, r_out = q", { "p", "q" }, { p = 0.7, q = 1.1 }, function(e, f)
  local p, q = e.p, e.q
  local x = 2 * (q ^ 5 - p ^ 5) / (q ^ 3 - p ^ 3) / 5
  return { measure = 4 * f.pi * (q ^ 3 - p ^ 3) / 3, I = axial(x, x), points = poles(q) }
end)
row("solid.hemisphere", "r = r", { "r" }, { r = 1.2 }, function(e, f)
  return { measure = 2 * f.pi * e.r ^ 3 / 3, com = height(3 * e.r / 8), I = axial(83 * e.r ^ 2 / 320, 2 * e.r ^ 2 / 5),
    points = { base = height(0), pole = height(e.r) } }
end)
row("solid.torus", "R = r + d, r = r", { "r", "d" }, { r = 0.5, d = 1.2 }, function(e, f)
  local R = e.r + e.d
  return { measure = 2 * f.pi ^ 2 * R * e.r ^ 2,
    I = axial((4 * R ^ 2 + 5 * e.r ^ 2) / 8, (4 * R ^ 2 + 3 * e.r ^ 2) / 4), points = { tube = { R, 0, 0 } } }
end)

-- A ball between two planes, about its centre: integrals of pi (r^2 - z^2) times 1, z, z^2, (r^2 - z^2)/4.
local function zone(e, f, z1, z2)
  local function between(F) return F(z2) - F(z1) end
  local V = between(function(t) return e.r ^ 2 * t - t ^ 3 / 3 end)
  local first = between(function(t) return e.r ^ 2 * t ^ 2 / 2 - t ^ 4 / 4 end)
  local zz = between(function(t) return e.r ^ 2 * t ^ 3 / 3 - t ^ 5 / 5 end)
  local xx = between(function(t) return (e.r ^ 4 * t - 2 * e.r ^ 2 * t ^ 3 / 3 + t ^ 5 / 5) / 4 end)
  return f.pi * V, first / V, xx / V, zz / V
end
row("solid.zone", "r = r, z1 = -p, z2 = q", { "p", "q", "r" }, { p = 0.3, q = 0.9, r = 1.2 }, function(e, f)
  local V, z, xx, zz = zone(e, f, -e.p, e.q)
  return { measure = V, com = height(z), S = { xx, xx, zz, 0, 0, 0 }, points = { centre = height(0) } }
end)
for _, h in ipairs { 0.7, 1.9 } do -- less and more than half a ball
  row("solid.cap", "r = r, h = h", { "h", "r" }, { r = 1.2, h = h }, function(e, f)
    local _, z, xx, zz = zone(e, f, e.r - e.h, e.r)
    local d = e.h - e.r -- from the centre to the flat face
    return { measure = f.pi * e.h ^ 2 * (3 * e.r - e.h) / 3,
      com = height(d + 3 * (2 * e.r - e.h) ^ 2 / (4 * (3 * e.r - e.h))),
      S = { xx, xx, zz + 2 * d * z + d ^ 2, 0, 0, 0 }, points = { base = height(0), pole = height(e.h) } }
  end)
  row("solid.sector", "r = r, h = h", { "h", "r" }, { r = 1.2, h = h }, function(e, f)
    local zz = e.h * (3 * e.r - e.h) / 5 -- moment about the axis, MathWorld
    return { measure = 2 * f.pi * e.r ^ 2 * e.h / 3, com = height(3 * (2 * e.r - e.h) / 8),
      S = { zz / 2, zz / 2, 3 * e.r ^ 2 / 5 - zz, 0, 0, 0 }, points = { apex = height(0), pole = height(e.r) } }
  end)
end
row("solid.capsule", "r = r, h = h", { "r", "h" }, { r = 1.2, h = 2.5 }, function(e, f)
  local r, h = e.r, e.h
  local mc, ms = r ^ 2 * h, 4 * r ^ 3 / 3
  local x = mc * (h ^ 2 / 12 + r ^ 2 / 4) + ms * (2 * r ^ 2 / 5 + h ^ 2 / 4 + 3 * h * r / 8)
  local z = mc * r ^ 2 / 2 + 2 * ms * r ^ 2 / 5
  return { measure = f.pi * (mc + ms), I = axial(x / (mc + ms), z / (mc + ms)),
    points = { top = height(h / 2 + r), bottom = height(-h / 2 - r) } }
end)

return rows
