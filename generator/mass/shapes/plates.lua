-- plates.lua -- thin flat plates of uniform mass per area.
--
-- Sources: integrals over the plane figure; triangle: sum (v - c)(v - c)^T/12.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local kit = require "generator.mass.shapes.kit"
local polygon = require "generator.mass.polygon"
local vec = require "generator.algebra.vec"

local zero, pi = expr.zero, expr.pi
local q, length, diagonal, centred = kit.q, kit.length, kit.diagonal, kit.centred

local function normal(v) return vec.cross(vec.sub(v[2], v[1]), vec.sub(v[3], v[1])) end

return {
  { name = "plate.disc", measure = "area", frame = "centred in z = 0", about = "radius r", args = { length "r" },
    build = function(a)
      return centred(pi * a.r ^ 2, diagonal(a.r ^ 2 / 4, a.r ^ 2 / 4, zero), { rim = { a.r, zero, zero } })
    end },
  { name = "plate.annulus", measure = "area", frame = "centred in z = 0", about = "radii r_in < r_out",
    args = { length "r_in", length "r_out" },
    requires = function(a) return { { a.r_out - a.r_in, "r_out must be larger than r_in" } } end,
    build = function(a)
      -- (o^4 - i^4)/(4 (o^2 - i^2))
      local s = (a.r_in ^ 2 + a.r_out ^ 2) / 4
      return centred(pi * (a.r_out - a.r_in) * (a.r_out + a.r_in), diagonal(s, s, zero),
        { rim = { a.r_out, zero, zero } })
    end },
  { name = "plate.ellipse", measure = "area", frame = "centred in z = 0", about = "semi-axes a, b along x, y",
    args = { length "a", length "b" },
    build = function(a)
      return centred(pi * a.a * a.b, diagonal(a.a ^ 2 / 4, a.b ^ 2 / 4, zero), { rim = { a.a, zero, zero } })
    end },
  { name = "plate.rectangle", measure = "area", frame = "centred in z = 0", about = "edges x, y",
    args = { length "x", length "y" },
    build = function(a)
      return centred(a.x * a.y, diagonal(a.x ^ 2 / 12, a.y ^ 2 / 12, zero),
        { corner = { -a.x / 2, -a.y / 2, zero } })
    end },
  { name = "plate.sector", measure = "area", frame = "apex at the origin, in z = 0",
    about = "radius r, from the x axis to the angle (pi: half disc)", args = { length "r", kit.angle },
    requires = function(a) return { kit.full_turn(a) } end,
    build = function(a)
      local r, h = a.r, a.angle / 2 -- along a ray the mean distance is 2 r/3, the mean square r^2/2
      local s, c = expr.call("sin", h), expr.call("cos", h)
      local x = q "2/3" * r * s / h
      -- variance of rho cos t: mean of rho^2 times that of cos t, and that of rho, r^2/18, times the squared mean of
      -- cos t
      local along = r ^ 2 * expr.call("arc_along", h) / 2 + (x / 2) ^ 2 / 2
      return { measure = r ^ 2 * h, com = { x * c, x * s, zero },
        sigma = kit.fan(s, c, along, r ^ 2 * expr.call("arc_across", h) / 2), points = { apex = { zero, zero, zero } } }
    end },
  { name = "plate.triangle", measure = "area", frame = "as given", about = "three corners in space",
    args = { kit.rows("vertices", 3, nil, 3) },
    requires = function(a)
      local n = normal(a.vertices)
      return { { vec.dot(n, n), "vertices must not lie on one line" } }
    end,
    build = function(a)
      local v = a.vertices
      local n = normal(v)
      local c = vec.scale(q "1/3", vec.add(vec.add(v[1], v[2]), v[3]))
      local sigma = diagonal(zero, zero, zero)
      for i = 1, 3 do sigma = vec.add(sigma, vec.outer(vec.sub(v[i], c))) end
      return { measure = expr.sqrt(vec.dot(n, n)) / 2, com = c, sigma = vec.scale(q "1/12", sigma),
        points = { v1 = v[1], v2 = v[2], v3 = v[3] } }
    end },
  { name = "plate.polygon", measure = "area", frame = "as given, in z = 0", about = "polygon with holes",
    args = { kit.profile, kit.holes }, polygons = true,
    build = function(a)
      local area, c, s = polygon.moments(a.profile, a.holes)
      return { measure = area, com = { c[1], c[2], zero }, sigma = { s[1], s[2], zero, s[3], zero, zero } }
    end },
}
