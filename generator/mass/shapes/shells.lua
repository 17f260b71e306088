-- shells.lua -- thin shells of uniform mass per area.
--
-- Sources: integrals over the surface; a zone of a sphere is uniform in z (Archimedes).  The ellipsoid of uniform
-- thickness has elliptic integrals: ellipsoid_area and ellipsoid_normal.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local kit = require "generator.mass.shapes.kit"

local zero, pi = expr.zero, expr.pi
local q, length, diagonal, centred, axial = kit.q, kit.length, kit.diagonal, kit.centred, kit.axial

-- Mean of x^2: a^2 (1 + N)/4, N the mean of the squared component of the unit normal (see ellipsoid_normal).
local function ellipsoid(a)
  local function mean(x, y, z) return x ^ 2 * (1 + expr.call("ellipsoid_normal", x, y, z)) / 4 end
  return centred(4 * pi * expr.call("ellipsoid_area", a.a, a.b, a.c),
    diagonal(mean(a.a, a.b, a.c), mean(a.b, a.c, a.a), mean(a.c, a.a, a.b)),
    { pole = axial(a.c), bottom = axial(-a.c) })
end

return {
  { name = "shell.sphere", measure = "area", curved = true, frame = "centred", about = "sphere of radius r",
    args = { length "r" },
    build = function(a)
      local s = a.r ^ 2 / 3
      return centred(4 * pi * a.r ^ 2, diagonal(s, s, s), { pole = axial(a.r), bottom = axial(-a.r) })
    end },
  { name = "shell.hemisphere", measure = "area", curved = true, frame = "based, open",
    about = "half sphere of radius r on z >= 0", args = { length "r" },
    build = function(a)
      return { measure = 2 * pi * a.r ^ 2, com = axial(a.r / 2),
        sigma = diagonal(a.r ^ 2 / 3, a.r ^ 2 / 3, a.r ^ 2 / 12), points = { base = axial(zero), pole = axial(a.r) } }
    end },
  { name = "shell.zone", measure = "area", curved = true, frame = "sphere's centre",
    about = "the part z1 <= z <= z2 of a sphere of radius r",
    args = { length "r", kit.coordinate "z1", kit.coordinate "z2" }, requires = kit.zone_limits,
    build = function(a)
      local p, s = a.z1, a.z2
      -- uniform in z: x^2 is half of r^2 less the mean of z^2, (p^2 + p s + s^2)/3
      local xx = (3 * a.r ^ 2 - p ^ 2 - p * s - s ^ 2) / 6
      return { measure = 2 * pi * a.r * (s - p), com = axial((p + s) / 2), sigma = diagonal(xx, xx, (s - p) ^ 2 / 12),
        points = { centre = axial(zero) } }
    end },
  { name = "shell.ellipsoid", measure = "area", curved = true, frame = "centred",
    about = "ellipsoid of uniform thickness, semi-axes a, b, c along x, y, z",
    args = { length "a", length "b", length "c" }, build = ellipsoid },
  { name = "shell.cylinder", measure = "area", curved = true, frame = "centred, axis z",
    about = "radius r, height h, open or with its two ends", args = { length "r", length "h", kit.flag "ends" },
    build = function(a)
      local r, h = a.r, a.h
      local points = { base = axial(-h / 2), top = axial(h / 2) }
      if not a.ends then return centred(2 * pi * r * h, diagonal(r ^ 2 / 2, r ^ 2 / 2, h ^ 2 / 12), points) end
      local s = h + r -- side and ends weigh h : r
      local xx = r ^ 2 * (2 * h + r) / (4 * s)
      return centred(2 * pi * r * s, diagonal(xx, xx, h ^ 2 * (h + 3 * r) / (12 * s)), points)
    end },
  { name = "shell.cone", measure = "area", curved = true, frame = "based, open, apex at z = h",
    about = "side of a cone of base radius r and height h", args = { length "r", length "h" },
    build = function(a)
      -- a ring at the part c of the way from the apex weighs c: the mean of c^2 is 1/2, half of it for x
      return { measure = pi * a.r * expr.sqrt(a.r ^ 2 + a.h ^ 2), com = axial(a.h / 3),
        sigma = diagonal(a.r ^ 2 / 4, a.r ^ 2 / 4, a.h ^ 2 / 18), points = { apex = axial(a.h), base = axial(zero) } }
    end },
  { name = "shell.torus", measure = "area", curved = true, frame = "centred, axis z",
    about = "centre radius R, tube radius r < R", args = { length "R", length "r" },
    requires = function(a) return { { a.R - a.r, "R must be larger than r" } } end,
    build = function(a)
      -- a ring at R + x weighs R + x: the mean of rho^2 is R^2 + 3 r^2/2, x^2 having r^2/2 over the tube's circle
      local s = a.R ^ 2 / 2 + q "3/4" * a.r ^ 2
      return centred(4 * pi ^ 2 * a.R * a.r, diagonal(s, s, a.r ^ 2 / 2), { tube = { a.R, zero, zero } })
    end },
  { name = "shell.box", measure = "area", curved = true, frame = "centred", about = "six faces of edges x, y, z",
    args = { length "x", length "y", length "z" },
    build = function(a)
      local x, y, z = a.x, a.y, a.z
      local s = x * y + x * z + y * z
      -- the two faces across an axis lie at half its edge, the other four are spread along it
      return centred(2 * s, diagonal(x ^ 2 * (3 * y * z + x * y + x * z) / (12 * s),
        y ^ 2 * (3 * x * z + x * y + y * z) / (12 * s), z ^ 2 * (3 * x * y + x * z + y * z) / (12 * s)),
        { corner = { -x / 2, -y / 2, -z / 2 } })
    end },
}
