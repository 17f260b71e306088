-- solids.lua -- blocks, cylinders and cones, and what is cut from them.
--
-- Sources: the elementary integrals of x_i x_j.  An affine image A of a shape has A sigma A^T: box, ellipsoid, elliptic
-- cylinder and elliptic cone follow from the cube (1/12), the ball (1/5), the disc (1/4) and the circular cone.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local kit = require "generator.mass.shapes.kit"

local zero, pi = expr.zero, expr.pi
local q, length, diagonal, centred, axial = kit.q, kit.length, kit.diagonal, kit.centred, kit.axial

local function ends(h) return { base = axial(-h / 2), top = axial(h / 2) } end

-- Moments of a solid whose cross-section shrinks linearly to an apex at height h: a slice weighs (1 - z/h)^2, so the
-- mean of z is h/4, its variance 3/80 h^2, and the mean of (1 - z/h)^2, which scales the base's squares, 3/5.
local function to_apex(measure, xx, yy, h)
  return { measure = measure, com = axial(h / 4), sigma = diagonal(xx, yy, q "3/80" * h ^ 2),
    points = { apex = axial(h), base = axial(zero) } }
end

return {
  { name = "solid.box", measure = "volume", frame = "centred", about = "edges x, y, z along the axes",
    args = { length "x", length "y", length "z" },
    build = function(a)
      return centred(a.x * a.y * a.z, diagonal(a.x ^ 2 / 12, a.y ^ 2 / 12, a.z ^ 2 / 12),
        { corner = { -a.x / 2, -a.y / 2, -a.z / 2 } })
    end },
  { name = "solid.cylinder", measure = "volume", frame = "centred, axis z", about = "radius r, height h",
    args = { length "r", length "h" },
    build = function(a)
      return centred(pi * a.r ^ 2 * a.h, diagonal(a.r ^ 2 / 4, a.r ^ 2 / 4, a.h ^ 2 / 12), ends(a.h))
    end },
  { name = "solid.elliptic_cylinder", measure = "volume", frame = "centred, axis z",
    about = "semi-axes a, b along x, y, height h", args = { length "a", length "b", length "h" },
    build = function(a)
      return centred(pi * a.a * a.b * a.h, diagonal(a.a ^ 2 / 4, a.b ^ 2 / 4, a.h ^ 2 / 12), ends(a.h))
    end },
  { name = "solid.tube", measure = "volume", frame = "centred, axis z",
    about = "radii r_in < r_out, height h", args = { length "r_in", length "r_out", length "h" },
    requires = function(a) return { { a.r_out - a.r_in, "r_out must be larger than r_in" } } end,
    build = function(a)
      -- (o^4 - i^4)/(4 (o^2 - i^2))
      local s = (a.r_in ^ 2 + a.r_out ^ 2) / 4
      return centred(pi * (a.r_out - a.r_in) * (a.r_out + a.r_in) * a.h, diagonal(s, s, a.h ^ 2 / 12), ends(a.h))
    end },
  { name = "solid.cone", measure = "volume", frame = "based, axis z, apex at z = h",
    about = "base radius r, height h", args = { length "r", length "h" },
    build = function(a)
      local s = q "3/20" * a.r ^ 2
      return to_apex(pi * a.r ^ 2 * a.h / 3, s, s, a.h)
    end },
  { name = "solid.elliptic_cone", measure = "volume", frame = "based, axis z, apex at z = h",
    about = "base semi-axes a, b along x, y, height h", args = { length "a", length "b", length "h" },
    build = function(a)
      return to_apex(pi * a.a * a.b * a.h / 3, q "3/20" * a.a ^ 2, q "3/20" * a.b ^ 2, a.h)
    end },
  { name = "solid.frustum", measure = "volume", frame = "based, axis z",
    about = "radii r_base in z = 0 and r_top at z = h", args = { length "r_base", length "r_top", length "h" },
    build = function(a)
      -- integrals of powers of the radius, linear in z; every coefficient is positive, so r_base = r_top is regular
      local b, t, h = a.r_base, a.r_top, a.h
      local s = b ^ 2 + b * t + t ^ 2
      local xx = q "3/20" * (b ^ 4 + b ^ 3 * t + b ^ 2 * t ^ 2 + b * t ^ 3 + t ^ 4) / s
      local zz = q "3/80" * h ^ 2 * (b ^ 4 + 4 * b ^ 3 * t + 10 * b ^ 2 * t ^ 2 + 4 * b * t ^ 3 + t ^ 4) / s ^ 2
      return { measure = pi * h * s / 3, com = axial(h * (b ^ 2 + 2 * b * t + 3 * t ^ 2) / (4 * s)),
        sigma = diagonal(xx, xx, zz), points = { base = axial(zero), top = axial(h) } }
    end },
  { name = "solid.half_cylinder", measure = "volume", frame = "cylinder's axis on z, centred in z, x >= 0",
    about = "radius r, height h", args = { length "r", length "h" },
    build = function(a)
      -- less the square of a half disc's centroid, 4 r/(3 pi)
      local s = a.r ^ 2 / 4
      return { measure = pi * a.r ^ 2 * a.h / 2, com = { 4 * a.r / (3 * pi), zero, zero },
        sigma = diagonal(s - q "16/9" * a.r ^ 2 / pi ^ 2, s, a.h ^ 2 / 12), points = { axis = axial(zero) } }
    end },
  { name = "solid.quarter_cylinder", measure = "volume", frame = "cylinder's axis on z, centred in z, x, y >= 0",
    about = "radius r, height h", args = { length "r", length "h" },
    build = function(a)
      -- over the quarter disc x y is r^4/8: a mean of r^2/(2 pi)
      local c = 4 * a.r / (3 * pi)
      local s = a.r ^ 2 / 4 - c ^ 2
      return { measure = pi * a.r ^ 2 * a.h / 4, com = { c, c, zero },
        sigma = { s, s, a.h ^ 2 / 12, a.r ^ 2 / (2 * pi) - c ^ 2, zero, zero }, points = { axis = axial(zero) } }
    end },
  { name = "solid.hoof", measure = "volume", frame = "cylinder's axis on z, x >= 0, 0 <= z <= h x/r",
    about = "half cylinder of radius r cut obliquely, h high at x = r", args = { length "r", length "h" },
    build = function(a)
      local r, h = a.r, a.h -- integrals over the half disc: x^2: pi r^4/8, x^3: 4 r^5/15, x y^2: 2 r^5/15
      local x, z = q "3/16" * pi * r, q "3/32" * pi * h
      return { measure = q "2/3" * r ^ 2 * h, com = { x, zero, z },
        sigma = { q "2/5" * r ^ 2 - x ^ 2, r ^ 2 / 5, q "2/15" * h ^ 2 - z ^ 2, zero, r * h / 5 - x * z, zero },
        points = { axis = axial(zero), tip = { r, zero, h } } }
    end },
  { name = "solid.paraboloid", measure = "volume", frame = "vertex down at the origin, axis z",
    about = "radius r at z = h", args = { length "r", length "h" },
    build = function(a)
      -- a slice weighs z and has radius^2 = r^2 z/h: means 2/3 h of z and h^2/2 of z^2
      return { measure = pi * a.r ^ 2 * a.h / 2, com = axial(q "2/3" * a.h),
        sigma = diagonal(a.r ^ 2 / 6, a.r ^ 2 / 6, a.h ^ 2 / 18),
        points = { vertex = axial(zero), top = axial(a.h) } }
    end },
  { name = "solid.bicylinder", measure = "volume", frame = "centred; the cylinders' axes are x and y",
    about = "common part of two cylinders of radius r that cross at right angles", args = { length "r" },
    build = function(a) -- the section at height z is a square of half side sqrt(r^2 - z^2)
      -- a slice weighs r^2 - z^2 as a ball's does; x^2 over it (r^2 - z^2)/3, whose mean is 4/15 r^2
      local s = q "4/15" * a.r ^ 2
      return centred(q "16/3" * a.r ^ 3, diagonal(s, s, a.r ^ 2 / 5))
    end },
}
