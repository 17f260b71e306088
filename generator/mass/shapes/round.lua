-- round.lua -- balls, what planes cut from them, tori and capsules.
--
-- Sources: integrals over slices of radius sqrt(R^2 - z^2), z from the sphere's centre.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local kit = require "generator.mass.shapes.kit"

local zero, pi = expr.zero, expr.pi
local q, length, diagonal, centred, axial = kit.q, kit.length, kit.diagonal, kit.centred, kit.axial

local function cap_height(a) return { { 2 * a.r - a.h, "h must not exceed 2 r", true } } end

return {
  { name = "solid.sphere", measure = "volume", frame = "centred", about = "ball of radius r",
    args = { length "r" },
    build = function(a)
      return centred(q "4/3" * pi * a.r ^ 3, diagonal(a.r ^ 2 / 5, a.r ^ 2 / 5, a.r ^ 2 / 5),
        { pole = axial(a.r), bottom = axial(-a.r) })
    end },
  { name = "solid.ellipsoid", measure = "volume", frame = "centred", about = "semi-axes a, b, c along x, y, z",
    args = { length "a", length "b", length "c" },
    build = function(a)
      return centred(q "4/3" * pi * a.a * a.b * a.c, diagonal(a.a ^ 2 / 5, a.b ^ 2 / 5, a.c ^ 2 / 5),
        { pole = axial(a.c), bottom = axial(-a.c) })
    end },
  { name = "solid.hollow_sphere", measure = "volume", frame = "centred", about = "radii r_in < r_out",
    args = { length "r_in", length "r_out" },
    requires = function(a) return { { a.r_out - a.r_in, "r_out must be larger than r_in" } } end,
    build = function(a)
      -- (o^5 - i^5)/(o^3 - i^3) with o - i cancelled: thin walls keep their digits
      local i, o = a.r_in, a.r_out
      local s = o ^ 2 + o * i + i ^ 2
      local xx = (o ^ 4 + o ^ 3 * i + o ^ 2 * i ^ 2 + o * i ^ 3 + i ^ 4) / (5 * s)
      return centred(q "4/3" * pi * (o - i) * s, diagonal(xx, xx, xx), { pole = axial(o), bottom = axial(-o) })
    end },
  { name = "solid.hemisphere", measure = "volume", frame = "based", about = "half ball of radius r on z >= 0",
    args = { length "r" },
    build = function(a)
      -- the ball's mean squares, r^2/5, less the square of the centroid: 1/5 - 9/64 = 19/320
      return { measure = q "2/3" * pi * a.r ^ 3, com = axial(q "3/8" * a.r),
        sigma = diagonal(a.r ^ 2 / 5, a.r ^ 2 / 5, q "19/320" * a.r ^ 2),
        points = { base = axial(zero), pole = axial(a.r) } }
    end },
  { name = "solid.cap", measure = "volume", frame = "based, top at z = h",
    about = "cap of height h <= 2 r of a ball of radius r", args = { length "r", length "h" }, requires = cap_height,
    build = function(a)
      local r, h = a.r, a.h
      -- u from the top down: a slice weighs 2 r u - u^2
      local s = 3 * r - h
      local xx = h * (20 * r ^ 2 - 15 * r * h + 3 * h ^ 2) / (20 * s)
      return { measure = pi * h ^ 2 * s / 3, com = axial(h * (4 * r - h) / (4 * s)),
        sigma = diagonal(xx, xx, h ^ 2 * (40 * r ^ 2 - 24 * r * h + 3 * h ^ 2) / (80 * s ^ 2)),
        points = { base = axial(zero), pole = axial(h) } }
    end },
  { name = "solid.zone", measure = "volume", frame = "sphere's centre",
    about = "the part z1 <= z <= z2 of a ball of radius r",
    args = { length "r", kit.coordinate "z1", kit.coordinate "z2" }, requires = kit.zone_limits,
    build = function(a)
      -- z = m + d s, |s| <= 1/2; a slice weighs  A - 2 m d s - d^2 s^2,  A = r^2 - m^2
      local m, d = (a.z1 + a.z2) / 2, a.z2 - a.z1
      local A = a.r ^ 2 - m ^ 2
      local W0, W2 = A - d ^ 2 / 12, A / 12 - d ^ 2 / 80
      local zz = d ^ 2 * (W2 * W0 - m ^ 2 * d ^ 2 / 36) / W0 ^ 2
      local xx = (A ^ 2 + (4 * m ^ 2 - 2 * A) * d ^ 2 / 12 + d ^ 4 / 80) / (4 * W0)
      return { measure = pi * d * W0, com = axial(m - m * d ^ 2 / (6 * W0)), sigma = diagonal(xx, xx, zz),
        points = { centre = axial(zero) } }
    end },
  { name = "solid.sector", measure = "volume", frame = "apex (the ball's centre) at the origin, axis z",
    about = "cone and cap of height h <= 2 r of a ball of radius r", args = { length "r", length "h" },
    requires = cap_height,
    build = function(a)
      local r, h = a.r, a.h -- radius and direction are independent: mean rho^2 = 3 r^2/5, cos theta uniform
      local xx = h * (3 * r - h) / 10
      return { measure = q "2/3" * pi * r ^ 2 * h, com = axial(q "3/8" * (2 * r - h)),
        sigma = diagonal(xx, xx, (12 * r ^ 2 - 12 * r * h + 19 * h ^ 2) / 320),
        points = { apex = axial(zero), pole = axial(r) } }
    end },
  { name = "solid.capsule", measure = "volume", frame = "centred, axis z",
    about = "cylinder of radius r and length h with two half balls", args = { length "r", length "h" },
    build = function(a)
      local r, h = a.r, a.h -- cylinder and balls weigh 3 h : 4 r
      local s = 3 * h + 4 * r
      local xx = r ^ 2 * (15 * h + 16 * r) / (20 * s)
      return centred(pi * r ^ 2 * s / 3,
        diagonal(xx, xx, (5 * h ^ 3 + 20 * h ^ 2 * r + 30 * h * r ^ 2 + 16 * r ^ 3) / (20 * s)),
        { top = axial(h / 2 + r), bottom = axial(-h / 2 - r) })
    end },
  { name = "solid.torus", measure = "volume", frame = "centred, axis z",
    about = "centre radius R, tube radius r < R", args = { length "R", length "r" },
    requires = function(a) return { { a.R - a.r, "R must be larger than r" } } end,
    build = function(a)
      -- a ring at R + x weighs R + x: the mean of rho^2 is R^2 + 3 r^2/4, x^2 having r^2/4 over the tube's section
      local s = a.R ^ 2 / 2 + q "3/8" * a.r ^ 2
      return centred(2 * pi ^ 2 * a.R * a.r ^ 2, diagonal(s, s, a.r ^ 2 / 4), { tube = { a.R, zero, zero } })
    end },
}
