-- wires.lua -- thin rods and wires of uniform mass per length.
--
-- Sources: integrals along the curve; a straight piece d has sigma = d d^T/12.  Arc and helix are integrated over the
-- angle t from the middle, |t| <= h, where they are symmetric, and then turned by h (arc_* and catenary_*: exact.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local kit = require "generator.mass.shapes.kit"
local vec = require "generator.algebra.vec"

local zero, pi = expr.zero, expr.pi
local q, length, diagonal, centred = kit.q, kit.length, kit.diagonal, kit.centred

-- The straight pieces of a polyline, each as a shape of its own.
local function pieces(a)
  local list, p = {}, a.points
  for i = 1, a.closed and #p or #p - 1 do
    local from, to = p[i], p[i % #p + 1]
    local d = vec.sub(to, from)
    list[i] = { square = vec.dot(d, d), measure = expr.sqrt(vec.dot(d, d)), com = vec.scale(q "1/2", vec.add(from, to)),
      sigma = vec.scale(q "1/12", vec.outer(d)) }
  end
  return list
end

local function ends(a) return { first = a.points[1], last = a.points[#a.points] } end

-- All of it at once.
local function polyline(a)
  local total, first, parts = zero, { zero, zero, zero }, pieces(a)
  for _, s in ipairs(parts) do
    total = total + s.measure
    first = vec.add(first, vec.scale(s.measure, s.com))
  end
  local com = vec.scale(1 / total, first)
  local sum = diagonal(zero, zero, zero)
  for _, s in ipairs(parts) do
    sum = vec.add(sum, vec.scale(s.measure, vec.add(s.sigma, vec.outer(vec.sub(s.com, com)))))
  end
  return { measure = total, com = com, sigma = vec.scale(1 / total, sum), points = ends(a) }
end

-- Circle of radius r, |t| <= h, then turned by h: centroid, second moments, sine and cosine of h.
local function arc(r, h)
  local s, c = expr.call("sin", h), expr.call("cos", h)
  local x = r * s / h
  local sigma = kit.fan(s, c, r ^ 2 * expr.call("arc_along", h), r ^ 2 * expr.call("arc_across", h))
  return { x * c, x * s, zero }, sigma, s, c
end

-- z = k (t + h): mean k h, variance k^2 h^2/3; with what lies across the ray in the middle, r sin t, a covariance of r
-- k (mean of t sin t), which is turned by h as the arc is.
local function helix(a)
  local h, k = pi * a.turns, a.pitch / (2 * pi) -- z = k (t + h)
  local com, sigma, s, c = arc(a.r, h)
  local lever = a.r * k * expr.call("arc_lever", h)
  com[3] = k * h
  sigma[3], sigma[5], sigma[6] = k ^ 2 * h ^ 2 / 3, -s * lever, c * lever
  return { measure = a.turns * expr.sqrt((2 * pi * a.r) ^ 2 + a.pitch ^ 2), com = com, sigma = sigma,
    points = { axis = { zero, zero, zero }, first = { a.r, zero, zero } } }
end

-- half: the length from the vertex to an end, a sinh u; means over it in exact.lua.
local function catenary(a)
  local x = a.span / 2
  local u = x / a.a
  local half = a.a * expr.call("sinh", u)
  return { measure = 2 * half, com = { zero, a.a + half * expr.call("catenary_rise", u), zero },
    sigma = diagonal(x ^ 2 * expr.call("catenary_width", u), half ^ 2 * expr.call("catenary_height", u), zero),
    points = { vertex = { zero, a.a, zero } } }
end

return {
  { name = "rod.straight", measure = "length", frame = "centred, along z", about = "thin rod of the length",
    args = { length "length" },
    build = function(a)
      return centred(a.length, diagonal(zero, zero, a.length ^ 2 / 12), { ["end"] = kit.axial(-a.length / 2) })
    end },
  { name = "rod.between", measure = "length", frame = "as given", about = "thin rod between two points",
    args = { kit.vector "from", kit.vector "to" },
    requires = function(a)
      local d = vec.sub(a.to, a.from)
      return { { vec.dot(d, d), "from and to must be different points" } }
    end,
    build = function(a)
      local d = vec.sub(a.to, a.from)
      return { measure = expr.sqrt(vec.dot(d, d)), com = vec.scale(q "1/2", vec.add(a.from, a.to)),
        sigma = vec.map(vec.outer(d), function(s) return s / 12 end), points = { from = a.from, to = a.to } }
    end },
  { name = "wire.hoop", measure = "length", curved = true, frame = "circle's centre, in z = 0", about = "radius r",
    args = { length "r" },
    build = function(a)
      return centred(2 * pi * a.r, diagonal(a.r ^ 2 / 2, a.r ^ 2 / 2, zero), { rim = { a.r, zero, zero } })
    end },
  { name = "wire.arc", measure = "length", curved = true, frame = "circle's centre, in z = 0",
    about = "radius r, from the x axis to the angle", args = { length "r", kit.angle },
    requires = function(a) return { kit.full_turn(a) } end,
    build = function(a)
      local com, sigma = arc(a.r, a.angle / 2)
      return { measure = a.r * a.angle, com = com, sigma = sigma,
        points = { centre = { zero, zero, zero }, first = { a.r, zero, zero } } }
    end },
  { name = "wire.polyline", measure = "length", curved = true, frame = "as given",
    about = "straight pieces through points, open or closed",
    args = { kit.rows("points", 3, 2), kit.flag "closed" },
    requires = function(a)
      local list = {}
      for i, s in ipairs(pieces(a)) do
        list[i] = { s.square, "points must differ from their neighbours" }
      end
      return list
    end,
    build = polyline, pieces = pieces, points = ends },
  { name = "wire.helix", measure = "length", curved = true, frame = "axis z, from (r, 0, 0)",
    about = "radius r, rise per turn (pitch, any sign), turns",
    args = { length "r", kit.coordinate "pitch", { name = "turns", dim = "none", sign = "positive" } },
    build = helix },
  { name = "wire.catenary", measure = "length", curved = true, frame = "y = a cosh(x/a) in z = 0, |x| <= span/2",
    about = "hanging chain", args = { length "a", length "span" }, build = catenary },
}
