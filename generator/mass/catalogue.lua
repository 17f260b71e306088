-- catalogue.lua -- the shapes: their arguments, and their mass distribution per unit mass.
--
-- One entry a shape, in the natural frame of vocabulary: `args` is the contract the scene language checks,
-- `requires` further conditions (expressions that must be positive), `build(a)` returns
--     measure   volume, area or length, by which a density is multiplied
--     com       centroid
--     sigma     second moments about the centroid PER UNIT MASS, {xx, yy, zz, xy, xz, yz} of  mean(r r^T)
--     points    named points
-- The tensor of inertia is never written down here: it is tr(sigma) 1 - sigma times the mass (body.lua), so a
-- formula of the handbooks can be checked against it.  Sources: every sigma is the elementary integral of
-- x_i x_j over the shape; an affine image A of a shape has A sigma A^T, which is how box, ellipsoid and elliptic
-- cylinder follow from the cube (1/12), the ball (1/5) and the disc (1/4).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local zero = expr.zero
local pi = expr.pi
local function q(s) return expr.lift(s) end

local function length(name) return { name = name, dim = "length", sign = "positive" } end
local function vector(name, default) return { name = name, dim = "length", size = 3, default = default } end

local function diagonal(x, y, z) return { x, y, z, zero, zero, zero } end

local function centred(measure, sigma, points) return { measure = measure, sigma = sigma, points = points } end

local list = {
  { name = "solid.box", measure = "volume", frame = "centred", about = "edges x, y, z along the axes",
    args = { length "x", length "y", length "z" },
    build = function(a)
      return centred(a.x * a.y * a.z, diagonal(a.x ^ 2 / 12, a.y ^ 2 / 12, a.z ^ 2 / 12),
        { corner = { -a.x / 2, -a.y / 2, -a.z / 2 } })
    end },
  { name = "solid.sphere", measure = "volume", frame = "centred", about = "ball of radius r",
    args = { length "r" },
    build = function(a)
      return centred(q "4/3" * pi * a.r ^ 3, diagonal(a.r ^ 2 / 5, a.r ^ 2 / 5, a.r ^ 2 / 5))
    end },
  { name = "solid.ellipsoid", measure = "volume", frame = "centred", about = "semi-axes a, b, c along x, y, z",
    args = { length "a", length "b", length "c" },
    build = function(a)
      return centred(q "4/3" * pi * a.a * a.b * a.c, diagonal(a.a ^ 2 / 5, a.b ^ 2 / 5, a.c ^ 2 / 5))
    end },
  { name = "solid.cylinder", measure = "volume", frame = "centred, axis z", about = "radius r, height h",
    args = { length "r", length "h" },
    build = function(a)
      return centred(pi * a.r ^ 2 * a.h, diagonal(a.r ^ 2 / 4, a.r ^ 2 / 4, a.h ^ 2 / 12),
        { base = { zero, zero, -a.h / 2 }, top = { zero, zero, a.h / 2 } })
    end },
  { name = "solid.elliptic_cylinder", measure = "volume", frame = "centred, axis z",
    about = "semi-axes a, b along x, y, height h", args = { length "a", length "b", length "h" },
    build = function(a)
      return centred(pi * a.a * a.b * a.h, diagonal(a.a ^ 2 / 4, a.b ^ 2 / 4, a.h ^ 2 / 12))
    end },
  { name = "solid.tube", measure = "volume", frame = "centred, axis z",
    about = "radii r_in < r_out, height h", args = { length "r_in", length "r_out", length "h" },
    requires = function(a) return { { a.r_out - a.r_in, "r_out must be larger than r_in" } } end,
    build = function(a)
      local s = (a.r_in ^ 2 + a.r_out ^ 2) / 4
      return centred(pi * (a.r_out - a.r_in) * (a.r_out + a.r_in) * a.h, diagonal(s, s, a.h ^ 2 / 12))
    end },
  { name = "solid.cone", measure = "volume", frame = "based, axis z, apex at z = h",
    about = "base radius r, height h", args = { length "r", length "h" },
    build = function(a)
      return { measure = pi * a.r ^ 2 * a.h / 3, com = { zero, zero, a.h / 4 },
        sigma = diagonal(q "3/20" * a.r ^ 2, q "3/20" * a.r ^ 2, q "3/80" * a.h ^ 2),
        points = { apex = { zero, zero, a.h } } }
    end },
  { name = "solid.hemisphere", measure = "volume", frame = "based", about = "half ball of radius r on z >= 0",
    args = { length "r" },
    build = function(a)
      return { measure = q "2/3" * pi * a.r ^ 3, com = { zero, zero, q "3/8" * a.r },
        sigma = diagonal(a.r ^ 2 / 5, a.r ^ 2 / 5, q "19/320" * a.r ^ 2) }
    end },
  { name = "solid.torus", measure = "volume", frame = "centred, axis z",
    about = "centre radius R, tube radius r < R", args = { length "R", length "r" },
    requires = function(a) return { { a.R - a.r, "R must be larger than r" } } end,
    build = function(a)
      local s = a.R ^ 2 / 2 + q "3/8" * a.r ^ 2
      return centred(2 * pi ^ 2 * a.R * a.r ^ 2, diagonal(s, s, a.r ^ 2 / 4))
    end },
  { name = "plate.disc", measure = "area", frame = "centred in z = 0", about = "radius r", args = { length "r" },
    build = function(a) return centred(pi * a.r ^ 2, diagonal(a.r ^ 2 / 4, a.r ^ 2 / 4, zero)) end },
  { name = "plate.rectangle", measure = "area", frame = "centred in z = 0", about = "edges x, y",
    args = { length "x", length "y" },
    build = function(a)
      return centred(a.x * a.y, diagonal(a.x ^ 2 / 12, a.y ^ 2 / 12, zero),
        { corner = { -a.x / 2, -a.y / 2, zero } })
    end },
  { name = "rod.straight", measure = "length", frame = "centred, along z", about = "thin rod of the length",
    args = { length "length" },
    build = function(a)
      return centred(a.length, diagonal(zero, zero, a.length ^ 2 / 12),
        { ["end"] = { zero, zero, -a.length / 2 } })
    end },
  { name = "rod.between", measure = "length", frame = "as given", about = "thin rod between two points",
    args = { vector "from", vector "to" },
    requires = function(a)
      local d = vec.sub(a.to, a.from)
      return { { vec.dot(d, d), "from and to must be different points" } }
    end,
    build = function(a)
      local d = vec.sub(a.to, a.from)
      return { measure = expr.sqrt(vec.dot(d, d)), com = vec.scale(expr.lift "1/2", vec.add(a.from, a.to)),
        sigma = vec.map(vec.outer(d), function(s) return s / 12 end), points = { from = a.from, to = a.to } }
    end },
  { name = "wire.hoop", measure = "length", curved = true, frame = "circle's centre, in z = 0", about = "radius r",
    args = { length "r" },
    build = function(a) return centred(2 * pi * a.r, diagonal(a.r ^ 2 / 2, a.r ^ 2 / 2, zero)) end },
  { name = "shell.ellipsoid", measure = "area", curved = true, frame = "centred",
    about = "semi-axes a, b, c along x, y, z; uniform areal density", args = { length "a", length "b", length "c" },
    build = function(a)
      local function mean(x, y, z) return x ^ 2 * (1 + expr.call("ellipsoid_normal", x, y, z)) / 4 end
      return centred(4 * pi * expr.call("ellipsoid_area", a.a, a.b, a.c),
        diagonal(mean(a.a, a.b, a.c), mean(a.b, a.c, a.a), mean(a.c, a.a, a.b)))
    end },
  { name = "points", frame = "as given", about = "particles {{m, x, y, z}, ...}", rows = true },
  { name = "tensor", frame = "as given",
    about = "mass, com, tensor entries xx .. yz about the centre of mass or the origin",
    args = {
      { name = "mass", dim = "mass", sign = "positive" }, vector("com", { 0, 0, 0 }),
      { name = "xx", dim = "inertia", sign = "nonnegative" }, { name = "yy", dim = "inertia", sign = "nonnegative" },
      { name = "zz", dim = "inertia", sign = "nonnegative" },
      { name = "xy", dim = "inertia", default = 0 }, { name = "xz", dim = "inertia", default = 0 },
      { name = "yz", dim = "inertia", default = 0 },
      { name = "about", choice = { "com", "origin" }, default = "com" },
    } },
}

local catalogue = { list = list, by_name = {} }
for _, s in ipairs(list) do catalogue.by_name[s.name] = s end

return catalogue
