-- mass_sums.lua -- hard cases: sums that cancel: parallel axes, reduced mass, composites, graded densities.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local bodies = kit.use "bodies"
  local M, q, R = bodies.moments, bodies.q, kit.R

  local function about_com(b)
    local c = M.com(b)
    return M.at(b, { -c[1], -c[2], -c[3] })
  end
  local function box(x, y, z)
    local two = q(2)
    return M.box(-q(x) / two, q(x) / two, -q(y) / two, q(y) / two, -q(z) / two, q(z) / two)
  end

  return { title = "Sums that cancel", about = "Parallel axes there and back, reduced masses, composites, densities " ..
    "with zeros.",
    cases = {
      { name = "parallel_axes_to_1e9_and_back", fast = true,
        why = "NAME_inertia_at for a point 1e9 m away, and back from a body whose origin is 1e9 m away",
        naive = "I + M R^2 - M R^2",
        oracle = "the box' moments about that point, exact rationals",
        bound = "12 u of the largest entry that went in or comes out: there it is M R^2, and back it is M R^2, too, " ..
          "of " ..
          "which the answer keeps u R^2/L^2 (NAME_inertia_at adds; a scene with that origin does not subtract)",
        run = function(row)
          local far = 1e9
          row.naive(math.abs((10 / 12 + far ^ 2 - far ^ 2) - 10 / 12) / (10 / 12))
          local text = bodies.scene([[local x, y, z = param("x", 1, "m"), param("y", 2, "m"), param("z", 3, "m")
local m, d = param("m", 1, "kg"), param("d", 1, "m")]], "solid.box { x = x, y = y, z = z, mass = m }:at{d, -d, 2*d}")
          for _, real in ipairs(kit.reals) do
            local worst = 0.0
            for _, d in ipairs(kit.rounded(real, { 0, far, 1e3 + 0.1 })) do
              local p = kit.rounded(real, { 1, 2, 3, 1.7, d })
              local b = M.of_mass(M.at(box(p[1], p[2], p[3]), { q(d), -q(d), q(2 * d) }), p[4])
              local points = { kit.rounded(real, { 1e9, -2e9, 3e8 }), { d, -d, 2 * d }, kit.rounded(real, { 0.1, d,
                0.3 }) }
              local commands = { { "init", table.unpack(p) }, { "inertia" } }
              for i, a in ipairs(points) do commands[2 + i] = { "at", table.unpack(a) } end
              local rows = bodies.ask(text, real, commands)
              if rows[1][1] ~= 0 and d == far then goto next end -- its inverse is beyond the type: said by a status
              local own = bodies.largest(M.tensor(b))
              for i, a in ipairs(points) do
                local want, got = M.tensor(b, a), rows[2 + i]
                local size = bodies.largest(want)
                local scale = size > own and size or own
                -- M a^2 and M a.R are terms, too
                local terms = q(p[4]) * (q(a[1]) ^ 2 + q(a[2]) ^ 2 + q(a[3]) ^ 2)
                if terms > scale then scale = terms end
                for n = 1, 6 do worst = kit.worst(worst, bodies.error(got[n], want[n], scale)) end
              end
              ::next::
            end
            row("inertia_at", real, worst, 12 * kit.u[real])
          end
          -- the library by its general formula, from the centre of the box
          local I = { 13 / 12, 10 / 12, 5 / 12, 0, 0, 0 }
          local r = bodies.library { { "shift", I[1], I[2], I[3], 0, 0, 0, 1, 0, 0, 0, 1e9, -2e9, 3e8 } }[1]
          local worst = 0.0
          local a = { q(1e9), q(-2e9), q(3e8) }
          local square = a[1] ^ 2 + a[2] ^ 2 + a[3] ^ 2
          local want = { q(I[1]) + square - a[1] ^ 2, q(I[2]) + square - a[2] ^ 2, q(I[3]) + square - a[3] ^ 2,
            -a[1] * a[2],
            -a[1] * a[3], -a[2] * a[3] }
          for n = 1, 6 do worst = kit.worst(worst, bodies.error(r[1 + n], want[n], square)) end
          row("library", "long double", worst, 12 * kit.u.double)
        end },
      { name = "body_1e9_away_about_its_centre", fast = true,
        why = "two boxes 1 m apart, moved together by 2^30 m: only their distance matters about the centre of mass",
        naive = "sum of m (r^2 1 - r r^T) about the origin less M R^2",
        oracle = "the boxes' moments, exact rationals",
        bound = "16 u of the largest entry: distances are differences of what was given, the reduced mass 3 roundings",
        run = function(row)
          local d = 2.0 ^ 30
          row.naive(math.abs((2 * d ^ 2 + 3 * (d + 1) ^ 2 - 5 * ((2 * d + 3 * (d + 1)) / 5) ^ 2) / 1.2 - 1))
          bodies.compare(row, { parameters = [[local m1, m2 = param("m1", 1, "kg"), param("m2", 2, "kg")
local x1, y1 = param("x1", 0, "m"), param("y1", 0, "m")
local x2, y2 = param("x2", 1, "m"), param("y2", 1, "m")]],
            body = "solid.box { x = 1, y = 2, z = 3, mass = m1 }:at{x1, y1, 0} + " ..
              "solid.box { x = 0.5, y = 0.25, z = 1, mass = m2 }:at{x2, y2, 0}", origin = '"centroid"', count = 16,
                size = 1,
            entries = "largest", values = { double = { { 2, 3, d, d, d + 1, d + 0.25 }, { 1, 1e-9, -d, d, 2 - d,
              d + 4 } },
              float = { { 2, 3, 4096, 4096, 4097, 4096.25 }, { 1, 1e-9, -4096, 4096, -4094, 4100 } } },
            oracle = function(p)
              return about_com(M.add(M.at(M.of_mass(box(1, 2, 3), p[1]), { p[3], p[4], 0 }),
                M.at(M.of_mass(box(0.5, 0.25, 1), p[2]), { p[5], p[6], 0 })))
            end })
        end },
      { name = "centre_of_mass_almost_on_the_origin",
        why = "two bodies that balance to 1e-12: the first moment is what two equal ones leave",
        naive = "m1 x1 + m2 x2 of masses from density times volume: each product is rounded first",
        oracle = "exact rationals",
        bound = "10 u of the distance of the parts for the centre, of the moments themselves for the tensor",
        run = function(row)
          local m1, m2, x1, x2 = 0.1, 0.3, 0.3, -0.1 + 1e-13
          local want = (q(m1) * q(x1) + q(m2) * q(x2)) / (q(m1) + q(m2))
          row.naive(bodies.error((m1 * x1 + m2 * x2) / (m1 + m2), want, want))
          bodies.compare(row, { parameters = [[local m1, m2 = param("m1", 1, "kg"), param("m2", 2, "kg")
local x1, x2 = param("x1", 1, "m"), param("x2", -0.5, "m")]],
            body = "solid.box { x = 0.1, y = 0.2, z = 0.3, mass = m1 }:at{x1, 0, 0} + " ..
              "solid.sphere { r = 0.1, mass = m2 }:at{x2, 0, 0}", count = 10, size = 0.1, entries = "largest",
            values = { { 0.1, 0.3, 0.3, -0.1 + 1e-13 }, { 1, 1, 1, -1 + 1e-6 }, { 7, 3, 0.3, -0.7 } },
            oracle = function(p)
              return M.add(M.at(M.of_mass(M.box(-q "1/20", q "1/20", -q "1/10", q "1/10", -q "3/20", q "3/20"),
                p[1]), { p[3], 0, 0 }),
                M.at(M.of_mass(M.ball(q "1/10"), p[2]), { p[4], 0, 0 }))
            end })
        end },
      { name = "two_bodies_reduced_mass", fast = true,
        why = "masses 1 and 1e-15 at 1e9 m: the centre lies 1e-6 m from the heavy one",
        naive = "sum of m r^2 about the origin less M R^2",
        oracle = "two points, exact rationals",
        bound = "12 u of the moment: reduced mass (3 roundings), distance, square, product; centre 4",
        run = function(row)
          local m, d = 1e-15, 1e9
          local mu = m / (1 + m)
          row.naive(math.abs((m * d ^ 2 - (1 + m) * (m * d / (1 + m)) ^ 2) / (mu * d ^ 2) - 1) +
            math.abs((1 * d ^ 2 - (1 + m) * (1 * d / (1 + m)) ^ 2) / (mu * d ^ 2) - 1))
          bodies.compare(row, { parameters = [[local m1, m2 = param("m1", 1, "kg"), param("m2", 2, "kg")
local x1, x2 = param("x1", 0, "m"), param("x2", 1, "m")]], body = "points { {m1, x1, 0, 0}, {m2, x2, 0, 0} }",
            effects = "",
            origin = '"centroid"', count = 12, size = function(p) return R.abs(p[4] - p[3]) end, values = { { 1,
              1e-15, 0, 1e9 }, { 1e-15, 1, 0, 1e9 }, { 1, 1, -1e9, 1e9 },
              { 1, 1e-6, 1e6, 1e6 + 2 } },
            oracle = function(p)
              return about_com(M.add(M.point(p[1], { p[3], 0, 0 }), M.point(p[2], { p[4], 0, 0 })))
            end })
        end },
      { name = "parts_of_masses_1_to_1e15",
        why = "a grain of 1e-15 kg on a block of 1 kg, on a long arm: its share is an ulp of the mass and half of a " ..
          "moment",
        naive = "moments of m1 + m2 about the origin less those of the whole mass at the centre",
        oracle = "exact rationals",
        bound = "14 u of the largest entry about the centre",
        run = function(row)
          local m, d = 1e-15, 3e7
          local mu = m / (1 + m)
          local want = 1 / 6 + mu * d * d
          row.naive(math.abs(1 / 6 + m * d * d + 5e5 ^ 2 * (1 + m) + 2 * m * d * 5e5 - (1 + m) * (5e5 + m * d /
            (1 + m)) ^ 2 - want) / want)
          bodies.compare(row, { parameters = [[local m1, m2 = param("m1", 1, "kg"), param("m2", 2, "kg")
local s, d = param("s", 1, "m"), param("d", 1, "m")]],
            body = "solid.box { x = s, y = s, z = s, mass = m1 } + solid.sphere { r = s/8, mass = m2 }:at{d, d/2, -d}",
            origin = '"centroid"', count = 14, size = function(p) return p[4] end, entries = "largest",
            values = { { 1, 1e-15, 1, 3e7 }, { 1e-15, 1, 1, 3e7 }, { 1, 1e-15, 1, 0.5 } },
            oracle = function(p)
              return about_com(M.add(M.of_mass(box(p[3], p[3], p[3]), p[1]),
                M.at(M.of_mass(M.ball(p[3] / q(8)), p[2]), { p[4], p[4] / q(2), -p[4] })))
            end })
        end },
      { name = "tensor_about_the_origin_with_a_far_centre", fast = true,
        why = "a measured tensor about the origin, the centre 1000 m away: what is asked is the tensor about the " ..
          "same origin",
        naive = "to the centre of mass by I - M R^2 and back by + M R^2",
        oracle = "the given numbers themselves",
        bound = "1 u of each entry: what is given about the origin comes back as it was given; the library keeps " ..
          "bodies " ..
          "about their centre, which costs it u of the largest twice, 4 u here",
        run = function(row)
          local M_, R_ = 3.0, 1000.1
          local I = 0.7 + M_ * R_ ^ 2
          row.naive(math.abs((I - M_ * R_ ^ 2) + M_ * R_ ^ 2 - I) / I + math.abs((I - M_ * R_ ^ 2) / 0.7 - 1))
          bodies.compare(row, { parameters =
            [[local xx, yy = param("xx", 0.7, "kg m^2"), param("yy", 3000601, "kg m^2")
local zz = param("zz", 3000601.2, "kg m^2")
local x, m = param("x", 1000.1, "m"), param("m", 3, "kg")]],
            body = 'tensor { mass = m, com = {x, 0, 0}, xx = xx, yy = yy, zz = zz, about = "origin" }', count = 1,
              library_count = 4,
            values = { { 0.7, 3000601.5, 3000601.25, 1000.1, 3 }, { 0.75, 1001, 1001.25, 18.25, 3 } },
            oracle = function(p)
              local half = (p[1] + p[2] + p[3]) / q(2)
              return { m = p[5], f = { p[5] * p[4], q(0), q(0) }, s = { half - p[1], half - p[2], half - p[3],
                q(0), q(0), q(0) } }
            end })
        end },
      { name = "density_with_a_zero", fast = true,
        why = "a block whose density is rho (1 - x/a)^2 written out, taken from 0 to a: 1 - 2 + 1 of every integral",
        naive = "the three integrals of the written terms, added in double, of the part next to a",
        oracle = "the integral of (1 - x)^2 as a polynomial, exact rationals",
        bound = "16 u of the largest entry: integrated exactly, only the result's products are rounded",
        run = function(row)
          local e = 1e-6
          local c = 1 - e
          row.naive(math.abs(((1 - c) - (1 - c ^ 2) + (1 - c ^ 3) / 3) / (e ^ 3 / 3) - 1))
          bodies.compare(row, { parameters =
            [[local a, b, h = param("a", 1, "m"), param("b", 1, "m"), param("h", 1, "m")
local rho = param("rho", 1000, "kg/m^3")]],
            body = "region { {x, 0, a}, {y, 0, b}, {z, 0, h}, density = rho*(1 - 2*x/a + x^2/a^2) }", origin =
              '"centroid"',
            count = 16, size = 1, entries = "largest", values = { { 1, 2, 3, 1000 }, { 1e-6, 1, 1, 1 }, { 3, 1e-6,
              1e-3, 7 } },
            oracle = function(p) -- weights 1/3, mean a/4, mean square a^2/10 of (1 - x/a)^2
              local a, b, h, third = p[1], p[2], p[3], q "1/3"
              local out = M.none()
              out.m = p[4] * a * b * h * third
              out.s = { out.m * a ^ 2 * (q "1/10" - q "1/16"), out.m * b ^ 2 / q(12), out.m * h ^ 2 / q(12), q(0),
                q(0), q(0) }
              return out
            end })
        end },
    } }
end
