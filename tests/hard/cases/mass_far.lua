-- mass_far.lua -- hard cases: bodies 1e9 m from the origin of their coordinates, flat ones, slivers, meshes.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local bodies = kit.use "bodies"
  local M, q, R = bodies.moments, bodies.q, kit.R

  local function about_com(b)
    local c = M.com(b)
    return M.at(b, { -c[1], -c[2], -c[3] })
  end
  local FAR = { double = 2.0 ^ 30, float = 2.0 ^ 12 } -- where the type still has 2^-22 and 2^-11 m

  -- "local x1, y1, z1 = param(...)" for n points at the defaults, and their list {x1, y1, z1}, ...
  local function places(points)
    local text, names = {}, {}
    for i, p in ipairs(points) do
      for k, c in ipairs { "x", "y", "z" } do
        if p[k] then text[#text + 1] = string.format('local %s%d = param("%s%d", %.17g, "m")', c, i, c, i, p[k]) end
      end
      names[i] = p[3] and string.format("{x%d, y%d, z%d}", i, i, i) or string.format("{x%d, y%d}", i, i)
    end
    return table.concat(text, "\n"), "{" .. table.concat(names, ", ") .. "}"
  end
  -- The values of the points, moved by d in all coordinates, after `first`.
  local function values(first, points, d)
    local out = { table.unpack(first) }
    for _, p in ipairs(points) do
      for k = 1, #p do out[#out + 1] = p[k] + d end
    end
    return out
  end
  local function taken(p, from, size) -- the points out of a list of values
    local out = {}
    for i = from, #p, size do out[#out + 1] = { p[i], p[i + 1], size == 3 and p[i + 2] or q(0) } end
    return out
  end
  local function corners(p) return M.tetrahedron(table.unpack(taken(p, 2, 3))) end

  local shape = { { 0, 0, 0 }, { 2, 0, 0.5 }, { 0.25, 1.5, 0 }, { 0.5, 0.25, 1 } }
  -- The second moment of a simplex about the origin less that of its mass: what is left far away.
  local function naive_tetrahedron(v)
    local sum, own = 0, 0
    for i = 1, 4 do sum, own = sum + v[i][1], own + v[i][1] ^ 2 end
    return (sum ^ 2 + own) / 20 - (sum / 4) ^ 2
  end

  return { title = "Far, flat and fine", about = "Far origins, almost flat solids, slivers and meshes of tiny " ..
    "triangles.",
    cases = {
      { name = "tetrahedron_1e9_away", fast = true,
        why = "corners at 2^30 m, a body of 1 m: the second moments about the origin are 1e18 times its own",
        naive = "((sum x)^2 + sum x^2)/20 - (mean x)^2",
        oracle = "the simplex's moments, exact rationals",
        bound = "20 u of the largest entry about the centre: differences of corners are exact, squares, ten sums, " ..
          "one product",
        run = function(row)
          local v = {}
          for i, p in ipairs(shape) do v[i] = { p[1] + 2 ^ 30 } end
          local b = about_com(M.tetrahedron(table.unpack(shape)))
          row.naive(bodies.error(naive_tetrahedron(v), b.s[1] / b.m, b.s[1] / b.m))
          local text, list = places(shape)
          bodies.compare(row, { parameters = 'local m = param("m", 1, "kg")\n' .. text,
            body = "solid.tetrahedron { vertices = " .. list .. ", mass = m }", origin = '"centroid"', count = 20,
              size = 1,
            entries = "largest", values = { double = { values({ 1 }, shape, FAR.double), values({ 3 }, shape,
              -FAR.double / 4) },
              float = { values({ 1 }, shape, FAR.float), values({ 3 }, shape, -FAR.float / 4) } },
            oracle = function(p) return about_com(M.of_mass(corners(p), p[1])) end })
        end },
      { name = "tetrahedron_almost_flat",
        why = "four corners 1e-12 m off a plane: the volume is a determinant that nearly vanishes, the body a plate",
        naive = "the moment about the normal's line, less the other two: 2 m (mean z^2) = Ixx + Iyy - Izz",
        oracle = "the simplex's moments, exact rationals",
        bound = "30 u of the largest entry: in this frame the determinant is one product, its other terms are 0",
        run = function(row)
          local z = 1e-10
          local v = { { 0, 0, 0 }, { 2, 0, 0 }, { 0.25, 1.5, 0 }, { 0.5, 0.25, z } }
          local b = about_com(M.tetrahedron(table.unpack(v)))
          local I = M.tensor(M.of_mass(b, 1))
          local d = {}
          for n = 1, 3 do d[n] = R.todouble(I[n]) end
          row.naive(bodies.error((d[1] + d[2] - d[3]) / 2, b.s[3] / b.m, b.s[3] / b.m))
          local text, list = places(v)
          local function flat(h) return values({ 2700 }, { v[1], v[2], v[3], { 0.5, 0.25, h } }, 0) end
          bodies.compare(row, { parameters = 'local rho = param("rho", 1, "kg/m^3")\n' .. text,
            body = "solid.tetrahedron { vertices = " .. list .. ", density = rho }", origin = '"centroid"', count = 30,
            size = 1, entries = "largest", values = { flat(1e-3), flat(1e-8), flat(1e-12) },
            oracle = function(p) return about_com(M.times(p[1], corners(p))) end })
        end },
      { name = "polygon_sliver_1e9_away",
        why = "a triangle 1 m by 2^-8 m whose coordinates are 2^30 m: Gauss's area formula is a sum of products of " ..
          "1e18",
        naive = "the shoelace formula as it stands",
        oracle = "triangles from the origin, exact rationals",
        bound = "24 u of the largest entry about the centre, area included: every coordinate enters as a difference",
        run = function(row)
          local v = { { 0, 0 }, { 1, 0.5 }, { 0.5, 0.25 + 2 ^ -8 } }
          local d, area = 2 ^ 30, 0.0
          for i, a in ipairs(v) do
            local b = v[i % 3 + 1]
            area = area + (a[1] + d) * (b[2] + d) - (b[1] + d) * (a[2] + d)
          end
          local want = M.polygon(v).m
          row.naive(bodies.error(area / 2, want, want))
          local text, list = places(v)
          bodies.compare(row, { parameters = 'local rho = param("rho", 1, "kg/m^2")\n' .. text, effects = "",
            body = "plate.polygon { profile = " .. list .. ", density = rho }",
            origin = '"centroid"', count = 24, size = 1, entries = "largest",
            values = { double = { values({ 3 }, v, FAR.double), values({ 3 }, v, 0) },
              float = { values({ 3 }, v, FAR.float), values({ 3 }, v, 0) } },
            oracle = function(p) return about_com(M.times(p[1], M.polygon(taken(p, 2, 2)))) end })
        end },
      { name = "mesh_1e9_away_of_tiny_triangles", fast = true,
        why = "a box of 1 m at 2^30 m, one side cut into slivers of 2^-20 m",
        naive = "the sum of signed tetrahedra from the origin, in double",
        oracle = "the same sum in exact rationals",
        bound = "4 u of the largest entry about the centre: the library sums about a corner and rounds once, the " ..
          "code once more",
        run = function(row)
          local d = 2.0 ^ 30
          local v, faces = {}, {}
          for i = 0, 7 do v[i + 1] = { d + i % 2, d + i // 2 % 2, d + i // 4 } end
          -- a row of points along the edge from v1 to v2, the last slivers 2^-20 wide
          local row_of = { 1 }
          for k = 0, 5 do
            v[#v + 1] = { d + 0.5 + k * 2.0 ^ -20, d, d }
            row_of[#row_of + 1] = #v
          end
          row_of[#row_of + 1] = 2
          for k = 1, #row_of - 1 do
            faces[#faces + 1] = { row_of[k], row_of[k + 1], 5 } -- the side y = 0
            faces[#faces + 1] = { row_of[k + 1], row_of[k], 3 } -- the bottom z = 0
          end
          for _, f in ipairs { { 2, 6, 5 }, { 2, 3, 4 }, { 5, 6, 8 }, { 5, 8, 7 }, { 3, 7, 8 }, { 3, 8, 4 }, { 1,
            5, 7 },
            { 1, 7, 3 }, { 2, 4, 8 }, { 2, 8, 6 } } do faces[#faces + 1] = f end
          local text, triangles, sum = {}, {}, 0.0
          for i, p in ipairs(v) do text[i] = string.format("v %.17g %.17g %.17g\n", p[1], p[2], p[3]) end
          for i, f in ipairs(faces) do
            text[#text + 1] = string.format("f %d %d %d\n", f[1], f[2], f[3])
            local a, b, c = v[f[1]], v[f[2]], v[f[3]]
            triangles[i] = { a, b, c }
            sum = sum + (a[1] * (b[2] * c[3] - b[3] * c[2]) - a[2] * (b[1] * c[3] - b[3] * c[1]) +
              a[3] * (b[1] * c[2] - b[2] * c[1])) / 6
          end
          kit.beside("far.obj", table.concat(text))
          local want = M.mesh(triangles)
          row.naive(bodies.error(sum, want.m, want.m))
          bodies.compare(row, { parameters = 'local rho = param("rho", 1, "kg/m^3")', count = 4, size = 1,
            entries = "largest",
            body = 'mesh { file = "far.obj", units = "m", density = rho }', origin = '"centroid"', values = { {
              2700 } },
            no_algebra = true, oracle = function(p) return about_com(M.times(p[1], want)) end })
        end },
      { name = "parallelepiped_nearly_degenerate",
        why = "three edges that are 2^-k off a plane: the volume is a determinant of nearly equal products",
        naive = "a . (b x c) as it stands, in double",
        oracle = "the cube's image, exact rationals",
        bound = "24 u |a||b||c|/volume for the mass and with it all entries: the condition of a determinant; the " ..
          "library, " ..
          "which has 11 bits more, 24 u",
        run = function(row)
          local function edges(e) return { { 1, 0.5, 0.25 }, { 0.3, 1, 0.7 }, { 1.3, 1.5, 0.95 + e } } end
          local function body(p)
            local A = { { p[2], p[5], p[8] }, { p[3], p[6], p[9] }, { p[4], p[7], p[10] } }
            local b = M.affine(M.box(0, 1, 0, 1, 0, 1), A, { 0, 0, 0 })
            local det = A[1][1] * (A[2][2] * A[3][3] - A[2][3] * A[3][2]) - A[1][2] * (A[2][1] * A[3][3] -
              A[2][3] * A[3][1]) +
              A[1][3] * (A[2][1] * A[3][2] - A[2][2] * A[3][1])
            return M.times(p[1] * R.abs(det), b)
          end
          local function values_of(e) return values({ 2 }, edges(e), 0) end
          local v = edges(2 ^ -30)
          local det = v[1][1] * (v[2][2] * v[3][3] - v[2][3] * v[3][2]) - v[1][2] * (v[2][1] * v[3][3] - v[2][3] *
            v[3][1]) +
            v[1][3] * (v[2][1] * v[3][2] - v[2][2] * v[3][1])
          local exact = {}
          for i, x in ipairs(values_of(2 ^ -30)) do exact[i] = q(x) end
          local want = body(exact).m / q(2)
          row.naive(bodies.error(det, want, want))
          local text, list = places(edges(0.5))
          local function condition(x) -- {init, rho, a, b, c}
            local e = {}
            for i, c in ipairs(x) do e[i] = math.type(c) and q(c) end
            return 2 ^ 2 / R.todouble(body({ table.unpack(e, 2) }).m / e[2])
          end
          bodies.compare(row, { parameters = 'local rho = param("rho", 1, "kg/m^3")\n' .. text,
            body = "solid.parallelepiped { edges = " .. list .. ", density = rho }", count = 24, entries = "largest",
            values = { values_of(0.5), values_of(2 ^ -6), values_of(2 ^ -10) }, condition = condition, oracle = body })
        end },
    } }
end
