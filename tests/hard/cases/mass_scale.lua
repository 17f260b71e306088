-- mass_scale.lua -- hard cases: scales of 1e+-30, subnormal results, tensors on the edge of what can be, nothing at
-- all.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local bodies = kit.use "bodies"
  local M, q, R = bodies.moments, bodies.q, kit.R

  local function box(x, y, z)
    local two = q(2)
    return M.box(-x / two, x / two, -y / two, y / two, -z / two, z / two)
  end

  local sizes = [[local x, y, z = param("x", 1, "m"), param("y", 2, "m"), param("z", 3, "m")
local m = param("m", 1, "kg")]]
  local brick = bodies.scene(sizes, "solid.box { x = x, y = y, z = z, mass = m }")
  local tensor = [[local xx, yy, zz = param("xx", 1, "kg m^2"), param("yy", 1.5, "kg m^2"), param("zz", 2, "kg m^2")
local xy = param("xy", 0, "kg m^2")]]

  -- Is the tensor accepted by NAME_init of each type and by the library?  rows: {xx, yy, zz, xy, wanted = 0 or not};
  -- the
  -- error is how many answers are wrong.
  local function asked(row, real, list, body)
    local commands, library, wrong, off = {}, {}, 0, 0
    for i, x in ipairs(list) do
      commands[i] = { "init", table.unpack(kit.rounded(real, x)) }
      library[i] = { "check", 1, x[1], x[2], x[3], x[4], 0, 0 }
    end
    for i, a in ipairs(bodies.ask(bodies.scene(tensor, body), real, commands)) do
      if (a[1] == 0) ~= list[i].fine then wrong = wrong + 1 end
    end
    row("init", real, wrong, 0.5)
    if real == "double" then
      for i, a in ipairs(bodies.library(library)) do
        if (a[1] == 0) ~= list[i].fine then off = off + 1 end
      end
      row("library", "long double", off, 0.5)
    end
  end

  return { title = "Scales and edges", about = "The ends of the types' ranges, and tensors at the edge of what can " ..
    "exist.",
    cases = {
      { name = "scales_1e30_and_1e12", fast = true,
        why = "lengths and masses of 1e+-30 (double) and 1e+-12 (float): r^4 of a density and m r^2 have 90 and 36 " ..
          "decades",
        naive = "the volume and the moments multiplied out in the order of the textbook, (4/3 pi rho r^3)(2/5) r r: " ..
          "in float",
        oracle = "the box' moments, exact rationals",
        bound = "10 u of each moment; in float m r^2 = 1e-36 is still normal",
        run = function(row)
          local function naive(r, rho) -- in float
            local function f(x) return kit.round("float", x) end
            local r3 = f(f(r * r) * r)
            return f(f(0.4 * f(f(4.1887902 * rho) * r3)) * f(r * r))
          end
          row.naive(math.abs(naive(kit.round("float", 1e-12), 1e36) / (0.4 * 4.18879020478639 * 1e36 * 1e-60) - 1))
          bodies.compare(row, { parameters = sizes, body = "solid.box { x = x, y = y, z = z, mass = m }",
            size = 1, count = 10,
            values = { double = { { 1e30, 2e30, 3e30, 1e30 }, { 1e-30, 2e-30, 3e-30, 1e-30 }, { 1e30, 1e30, 1e30,
              1e-30 },
              { 1e-30, 2e-30, 1e-30, 1e30 } },
              float = { { 1e12, 2e12, 3e12, 1e12 }, { 1e-12, 2e-12, 3e-12, 1e-12 }, { 1e12, 1e12, 1e12, 1e-12 },
                { 1e-12, 2e-12, 1e-12, 1e12 } } },
            oracle = function(p) return M.of_mass(box(p[1], p[2], p[3]), p[4]) end })
        end },
      { name = "composite_at_scales_1e30",
        why = "two boxes, oblique tensor: the reduced mass m1 m2/mass and the determinant of the tensor have the " ..
          "square and " ..
          "the cube of a moment's exponent",
        naive = "m1 m2/(m1 + m2) in float at 1e-24 kg",
        oracle = "the boxes' moments, exact rationals",
        bound = "16 u of the largest entry; in float as far as the determinant goes, beyond it NAME_init refuses " ..
          "(next case)",
        run = function(row)
          local function f(x) return kit.round("float", x) end
          row.naive(math.abs(f(f(1e-24 * 2e-24) / f(3e-24)) / (2e-24 / 3) - 1))
          local function scaled(l, m) return { m, 3 * m, l, 2 * l, 3 * l } end
          bodies.compare(row, { parameters = [[local m1, m2 = param("m1", 1, "kg"), param("m2", 2, "kg")
local x, y, z = param("x", 1, "m"), param("y", 2, "m"), param("z", 3, "m")]], size = function(p) return p[3] end,
            body = "solid.box { x = x, y = y, z = z, mass = m1 } + solid.box { x = y, y = x, z = z, mass = m2 " ..
              "}:at{x, y, z}",
            origin = '"centroid"', count = 16, entries = "largest",
            values = { double = { scaled(1e30, 1e30), scaled(1e-30, 1e-30), scaled(1e-30, 1e30), scaled(1, 1e-30) },
              float = { scaled(1e3, 1e3), scaled(1e-3, 1e-3), scaled(1e-6, 1e12), scaled(1, 1e-12),
                scaled(1e11, 1e-12) } },
            oracle = function(p)
              local b = M.add(M.of_mass(box(p[3], p[4], p[5]), p[1]),
                M.at(M.of_mass(box(p[4], p[3], p[5]), p[2]), { p[3], p[4], p[5] }))
              local c = M.com(b)
              return M.at(b, { -c[1], -c[2], -c[3] })
            end })
        end },
      { name = "inverse_of_an_oblique_tensor_beyond_the_type", fast = true,
        why = "the determinant is the cube of a moment: with 1e13 kg m^2 in float it is infinite, and " ..
          "adjugate/determinant 0",
        naive = "adjugate over determinant in float at 1e13 kg m^2: an inverse of 0",
        oracle = "the two boxes' tensor and its inverse in exact rationals",
        bound = "200 u of |w'|: 20 roundings and a condition below 10; a refusal by NAME_init is an answer, too, " ..
          "where the cube of the trace is beyond 1e38 (1e308)",
        run = function(row)
          local function f(x) return kit.round("float", x) end
          local cube = f(f(1e13 * 1e13) * 1e13)
          row.naive(math.abs(f(1e26) / cube * 1e13 - 1))
          local text = bodies.scene([[local m1, m2 = param("m1", 1, "kg"), param("m2", 2, "kg")]],
            "solid.box { x = 1, y = 2, z = 3, mass = m1 } + solid.box { x = 2, y = 1, z = 3, mass = m2 }:at{1, 2, 3}",
            '"centroid"')
          for _, real in ipairs(kit.reals) do
            local worst = 0.0
            for _, s in ipairs(real == "double" and { 1, 1e-80, 1e80, 1e101, 1e102, 1e103, 1e110 } or
              { 1, 1e-11, 1e6, 1e11, 1e12, 3e12, 1e13, 1e16 }) do
              local p, torque = kit.rounded(real, { s, 3 * s }), kit.rounded(real, { s, -2 * s, 0.5 * s })
              local rows = bodies.ask(text, real, { { "init", p[1], p[2] },
                { "accelerated", 1, 0, 0, 0, 0, 0, 0, table.unpack(torque) } })
              local b = M.add(M.of_mass(box(q(1), q(2), q(3)), p[1]), M.at(M.of_mass(box(q(2), q(1), q(3)), p[2]),
                { 1, 2, 3 }))
              local c = M.com(b)
              local I = M.tensor(b, c)
              if rows[1][1] ~= 0 then
                local cubed = 3 * R.log2(I[1] + I[2] + I[3])
                if cubed < (real == "double" and 1022 or 126) then worst = math.huge end
              else
                local N = { q(torque[1]), q(torque[2]), q(torque[3]) }
                local xx, yy, zz, xy, xz, yz = table.unpack(I)
                local adj = { { yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy },
                  { xz * yz - xy * zz, xx * zz - xz * xz, xy * xz - xx * yz },
                  { xy * yz - xz * yy, xy * xz - xx * yz, xx * yy - xy * xy } }
                local det, want, size = xx * adj[1][1] + xy * adj[1][2] + xz * adj[1][3], {}, q(0)
                for i = 1, 3 do
                  want[i] = (adj[i][1] * N[1] + adj[i][2] * N[2] + adj[i][3] * N[3]) / det
                  size = size + R.abs(want[i])
                end
                for i = 1, 3 do worst = kit.worst(worst, bodies.error(rows[2][i], want[i], size)) end
              end
            end
            row("init, rhs", real, worst, 200 * kit.u[real])
          end
        end },
      { name = "results_below_the_normal_numbers", fast = true,
        why = "moments that are subnormal: m r^2 of 1e-310 (float 1e-42) has what digits are left, and no more",
        naive = "r^2 first: it underflows to 0, and with it the moment",
        oracle = "the box' moments, exact rationals",
        bound = "4: spacings of the subnormal numbers, each product rounded to one; and 10 u of what is larger",
        run = function(row)
          local r = 1e-170
          row.naive(r * r * 1e30 == 0 and 1 / kit.tiny.double * 1e-310 or 0)
          for _, real in ipairs(kit.reals) do
            local p = kit.rounded(real, real == "double" and { 1e-5, 2e-5, 3e-5, 1e-300 } or { 1e-2, 2e-2, 3e-2,
              1e-38 })
            local rows = bodies.ask(brick, real, { { "init", table.unpack(p) }, { "inertia" } })
            local want, worst = M.tensor(M.of_mass(box(q(p[1]), q(p[2]), q(p[3])), p[4])), 0.0
            for n = 1, 6 do
              worst = kit.worst(worst, rows[1][1] == 0 and bodies.error(rows[2][n], want[n], q(kit.tiny[real])) or
                math.huge)
            end
            row("init", real, worst, 4)
          end
        end },
      { name = "plate_exactly_and_a_hair_beyond", fast = true,
        why = "I3 = I1 + I2 is a plate, one ulp more is a plate that was rounded, 1e-9 more cannot exist",
        naive = "I1 + I2 >= I3 as it stands: refuses three entries out of seven that were rounded",
        oracle = "the triangle inequality in exact rationals, with the slack that is promised (16 u of the trace, " ..
          "docs/design.md)",
        bound = "0 wrong answers",
        run = function(row)
          local refused = 0
          for k = 1, 7 do
            local x, y = k / 10, 1 / k
            local c, s = math.cos(k), math.sin(k)
            local yy, xx = c * c * x + s * s * y, s * s * x + c * c * y
            if xx + yy < x + y then refused = refused + 1 end
          end
          row.naive(refused)
          for _, real in ipairs(kit.reals) do
            local u, hair = kit.u[real], real == "double" and 1e-9 or 1e-4
            asked(row, real, { { 1, 1.5, 2.5, 0, fine = true }, { 1, 1.5, 2.5 * (1 + 2 * u), 0, fine = true },
              { 0.1, 0.2, 0.3, 0, fine = true }, { 1, 1.5, 2.5 * (1 + hair), 0, fine = false }, { 1, 1, 2, 0.5,
                fine = true },
              { 1, 1, 2, 1 - hair, fine = true }, { 1, 1, 2 + hair, 0.5, fine = false }, { 1, 1, 1, 0, fine = true } },
              "tensor { mass = 1, xx = xx, yy = yy, zz = zz, xy = xy }")
          end
        end },
      { name = "nothing_and_less_are_refused", fast = true,
        why = "zero and negative sizes and masses, infinities and NaN as parameters",
        naive = "m (y^2 + z^2)/12 of whatever comes: a body without mass, a negative one, a NaN",
        oracle = "the rule: what is not positive and finite is no size and no mass",
        bound = "0 wrong answers: a status for each, never numbers from a status of 0",
        run = function(row)
          local wrong = 0
          for _, m in ipairs { 0.0, -1.0, 0 / 0 } do
            if m ~= m or m * 13 / 12 <= 0 then wrong = wrong + 1 end
          end
          row.naive(wrong)
          local inf, nan = math.huge, 0 / 0
          for _, real in ipairs(kit.reals) do
            local commands = {}
            for k = 1, 4 do
              for _, bad in ipairs { 0.0, -0.0, -1.0, inf, -inf, nan } do
                local p = { 1.0, 2.0, 3.0, 1.0 }
                p[k] = bad
                commands[#commands + 1] = { "init", table.unpack(p) }
              end
            end
            commands[#commands + 1] = { "init", 0, 0, 0, 0 }
            local accepted = 0
            for _, a in ipairs(bodies.ask(brick, real, commands)) do
              if a[1] == 0 then accepted = accepted + 1 end
            end
            row("init", real, accepted, 0.5)
          end
          local accepted = 0
          for _, a in ipairs(bodies.library { { "check", 0, 1, 1, 1, 0, 0, 0 }, { "check", -1, 1, 1, 1, 0, 0, 0 },
            { "check", 1, -1, 1, 1, 0, 0, 0 }, { "check", 1, inf, 1, 1, 0, 0, 0 }, { "check", nan, 1, 1, 1, 0, 0,
              0 } }) do
            if a[1] == 0 then accepted = accepted + 1 end
          end
          row("library", "long double", accepted, 0.5)
          row("exact", "double", R.sign(q(0)) == 0 and 0 or 1, 0.5)
        end },
      { name = "turned_by_almost_half_a_turn", fast = true,
        why = "a bar turned about (1, 2, 3) by an angle next to pi: products of inertia of cosine and 1 - cosine",
        naive = "the rotation's matrix by 1 - cos a = 2 for pi and sin a = 0: the angle rounded to half a turn",
        oracle = "sine and cosine with 600 bits, A I A^T in rationals",
        bound = "30 u of the largest entry: sine and cosine 1 ulp, polynomials of degree 4 in them, 12 terms",
        run = function(row)
          local function body(p)
            local a, m, two = p[1], p[2], q(2)
            local s, c = R.apply("sin", 600, a), R.apply("cos", 600, a)
            local n = R.apply("sqrt", 600, q(14))
            local k, A = { q(1) / n, two / n, q(3) / n }, {}
            local cross = { { q(0), -k[3], k[2] }, { k[3], q(0), -k[1] }, { -k[2], k[1], q(0) } }
            for i = 1, 3 do
              A[i] = {}
              for j = 1, 3 do A[i][j] = (i == j and c or q(0)) + s * cross[i][j] + (q(1) - c) * k[i] * k[j] end
            end
            return M.affine(M.of_mass(box(q(1), q(2), q(8)), m), A, { 0, 0, 0 })
          end
          local near, half = M.tensor(body { q(3.14), q(1) }), M.tensor(body { R.apply("pi", 600), q(1) })
          row.naive(R.todouble(R.abs(near[4] - half[4]) / bodies.largest(near)))
          bodies.compare(row, { parameters = 'local a, m = param("a", 0.5, "rad"), param("m", 1, "kg")',
            body = "solid.box { x = 1, y = 2, z = 8, mass = m }:turned{ axis = {1, 2, 3}, angle = a }", count = 30,
              size = 1,
            entries = "largest", values = { { math.pi, 1 }, { 3.14, 1 }, { 3.1415926, 2 }, { 1e-9, 1 }, {
              6.2831853, 1 }, { 2, 1 } },
            oracle = body })
        end },
    } }
end
