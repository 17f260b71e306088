-- polyhedra.lua -- solids with plane faces, and what a polygon sweeps out.
--
-- Sources: a simplex with corners v has sigma = sum (v - c)(v - c)^T / ((n+1)(n+2)), n its dimension (tetrahedron 1/20,
-- triangle 1/12); polygons: mass/polygon.lua; the regular ones: Wikipedia, "List of moments of inertia", whose
-- dodecahedron and icosahedron agree with the tables in tests/reference.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local kit = require "generator.mass.shapes.kit"
local polygon = require "generator.mass.polygon"
local vec = require "generator.algebra.vec"

local zero = expr.zero
local q, length, diagonal = kit.q, kit.length, kit.diagonal

local function determinant(u, v, w) return vec.dot(u, vec.cross(v, w)) end

local function from_first(v) return { vec.sub(v[2], v[1]), vec.sub(v[3], v[1]), vec.sub(v[4], v[1]) } end

-- Extruded from z = 0 to h.
local function prism(profile, holes, h)
  local area, c, s = polygon.moments(profile, holes)
  return { measure = area * h, com = { c[1], c[2], h / 2 }, sigma = { s[1], s[2], h ^ 2 / 12, s[3], zero, zero } }
end

local root5 = expr.sqrt(expr.lift(5))
local golden = (1 + root5) / 2

-- Volume / edge^3, sigma / edge^2, and one corner / edge.
local regular = {
  [4] = { expr.sqrt(expr.lift(2)) / 12, q "1/40", vec.map({ 1, 1, 1 }, function(x)
    return x * expr.sqrt(expr.lift(2)) / 4
  end) },
  [6] = { expr.one, q "1/12", { -q "1/2", -q "1/2", -q "1/2" } },
  [8] = { expr.sqrt(expr.lift(2)) / 3, q "1/20", { expr.sqrt(expr.lift(2)) / 2, zero, zero } },
  [12] = { (15 + 7 * root5) / 4, (39 * golden + 28) / 300, { golden / 2, golden / 2, golden / 2 } },
  [20] = { 5 * (3 + root5) / 12, golden ^ 2 / 20, { zero, q "1/2", golden / 2 } },
}

return {
  { name = "solid.pyramid", measure = "volume", frame = "based, apex at z = h",
    about = "rectangular base x, y, height h", args = { length "x", length "y", length "h" },
    build = function(a)
      -- sections shrink as a cone's do: 3/5 of the base's x^2/12
      return { measure = a.x * a.y * a.h / 3, com = kit.axial(a.h / 4),
        sigma = diagonal(a.x ^ 2 / 20, a.y ^ 2 / 20, q "3/80" * a.h ^ 2),
        points = { apex = kit.axial(a.h), base = kit.axial(zero) } }
    end },
  { name = "solid.wedge", measure = "volume", frame = "right angle at the origin, edges along x, y, z",
    about = "half of a box: triangle (0, 0), (x, 0), (0, y) extruded to z",
    args = { length "x", length "y", length "z" },
    build = function(a)
      return { measure = a.x * a.y * a.z / 2, com = { a.x / 3, a.y / 3, a.z / 2 },
        -- triangle: sum (v - c)^2 = 2/3 x^2 and -x y/3, over 12
        sigma = { a.x ^ 2 / 18, a.y ^ 2 / 18, a.z ^ 2 / 12, -a.x * a.y / 36, zero, zero },
        points = { corner = { zero, zero, zero } } }
    end },
  { name = "solid.prism", measure = "volume", frame = "as given, extruded from z = 0",
    about = "polygon {{x, y}, ...} of height h", args = { kit.profile, length "h" }, polygons = true,
    build = function(a) return prism(a.profile, {}, a.h) end },
  { name = "solid.tetrahedron", measure = "volume", frame = "as given", about = "four corners",
    args = { kit.rows("vertices", 3, nil, 4) },
    requires = function(a)
      return { { determinant(table.unpack(from_first(a.vertices))) ^ 2, "vertices must not lie in one plane" } }
    end,
    build = function(a)
      local v = a.vertices
      local c = vec.scale(q "1/4", vec.add(vec.add(v[1], v[2]), vec.add(v[3], v[4])))
      local sigma = diagonal(zero, zero, zero)
      for i = 1, 4 do sigma = vec.add(sigma, vec.outer(vec.sub(v[i], c))) end
      return { measure = expr.call("abs", determinant(table.unpack(from_first(v)))) / 6, com = c,
        sigma = vec.scale(q "1/20", sigma), points = { v1 = v[1], v2 = v[2], v3 = v[3], v4 = v[4] } }
    end },
  { name = "solid.parallelepiped", measure = "volume", frame = "one corner at the origin",
    about = "three edges from the origin", args = { kit.rows("edges", 3, nil, 3) },
    requires = function(a)
      return { { determinant(table.unpack(a.edges)) ^ 2, "edges must not lie in one plane" } }
    end,
    build = function(a)
      local e = a.edges
      local sigma = vec.add(vec.add(vec.outer(e[1]), vec.outer(e[2])), vec.outer(e[3]))
      return { measure = expr.call("abs", determinant(table.unpack(e))),
        com = vec.scale(q "1/2", vec.add(vec.add(e[1], e[2]), e[3])), sigma = vec.scale(q "1/12", sigma),
        points = { corner = { zero, zero, zero } } }
    end },
  { name = "solid.regular", measure = "volume", frame = "centred",
    about = "regular polyhedron of 4, 6, 8, 12 or 20 faces",
    args = { { name = "faces", choice = { 4, 6, 8, 12, 20 } }, length "edge" },
    build = function(a)
      local r = regular[a.faces]
      local s = r[2] * a.edge ^ 2
      return kit.centred(r[1] * a.edge ^ 3, diagonal(s, s, s), { vertex = vec.scale(a.edge, r[3]) })
    end },
  { name = "extrude", measure = "volume", frame = "as given, along z from 0",
    about = "polygon with holes, height h", args = { kit.profile, length "h", kit.holes }, polygons = true,
    build = function(a) return prism(a.profile, a.holes, a.h) end },
  { name = "revolve", measure = "volume", frame = "as given, axis z",
    about = "polygon {{x, z}, ...} on x >= 0, with holes, turned about z", args = { kit.profile, kit.holes },
    polygons = "x",
    build = function(a)
      local volume, z, across, along = polygon.revolved(a.profile, a.holes)
      return { measure = volume, com = kit.axial(z), sigma = diagonal(across, across, along),
        points = { origin = kit.axial(zero) } }
    end },
}
