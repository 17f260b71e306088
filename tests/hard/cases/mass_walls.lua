-- mass_walls.lua -- hard cases: walls that vanish, holes that nearly empty the body, bodies that become others.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local bodies = kit.use "bodies"
  local M, q = bodies.moments, bodies.q

  -- What the type has beside 1 for a relative wall e: 1 - e, or the next number below 1.
  local function beside(real, e)
    return kit.round(real, 1 - math.max(e, 4 * kit.u[real]))
  end
  -- A list of values for each type, made by fn(e as the type can hold it beside 1, the number 1 - e)
  local function walls(list, fn)
    local out = {}
    for _, real in ipairs { "double", "float" } do
      out[real] = {}
      for i, e in ipairs(list) do out[real][i] = fn(beside(real, e), e) end
    end
    return out
  end

  -- The hollow sphere by mass or density in the textbook's words: 2/5 m (b^5 - a^5)/(b^3 - a^3)
  local function naive_sphere(a, b)
    return 0.4 * (b ^ 5 - a ^ 5) / (b ^ 3 - a ^ 3)
  end

  local function zone(values, count)
    return { parameters = [[local r, z1, z2 = param("r", 1, "m"), param("z1", -0.3, "m"), param("z2", 0.7, "m")
local rho = param("rho", 1000, "kg/m^3")]], body = "solid.zone { r = r, z1 = z1, z2 = z2, density = rho }",
      origin = '"centroid"', values = values, count = count, size = 1, oracle = function(p)
        local b = M.times(p[4], M.revolved({ p[1] ^ 2, 0, -1 }, p[2], p[3]))
        return M.at(b, { 0, 0, -M.com(b)[3] })
      end }
  end

  return { title = "Walls and limits", about = "Thin walls, holes that leave almost nothing, and shapes on the way " ..
    "to another.",
    cases = {
      { name = "hollow_sphere_wall_1e12", fast = true,
        why = "r_out - r_in is 1e-12 of r_out and 4 ulp of it: the wall is a difference of nearly equal numbers",
        naive = "2/5 m (r_out^5 - r_in^5)/(r_out^3 - r_in^3): both differences keep 4 digits",
        oracle = "ball minus ball as integrals of polynomials in exact rationals (tests/hard/moments.lua)",
        bound = "30 u: r_out - r_in is exact (Sterbenz), 4 powers and 5 sums of positive terms, a quotient, density " ..
          "and volume",
        run = function(row)
          local a, b = 1 - 1e-12, 1.0
          local want = M.of_mass(M.minus(M.ball(b), M.ball(a)), 1)
          row.naive(bodies.error(naive_sphere(a, b), M.tensor(want)[3], M.tensor(want)[3]))
          bodies.compare(row, { parameters = [[local r_in, r_out = param("r_in", 0.5, "m"), param("r_out", 1, "m")
local rho = param("rho", 1000, "kg/m^3")]], body = "solid.hollow_sphere { r_in = r_in, r_out = r_out, density = rho }",
            values = walls({ 1e-3, 1e-8, 1e-12, 0 }, function(inner) return { inner, 1.0, 2700.0 } end),
            size = 1, count = 30,
            oracle = function(p) return M.times(p[3], M.minus(M.ball(p[2]), M.ball(p[1]))) end })
        end },
      { name = "hollow_sphere_by_mass_to_the_shell", fast = true,
        why = "a wall of t = 1e-8 .. 1e-12 r: by mass the moment must become that of the shell, 2/3 m r^2",
        naive = "2/5 m (r^5 - (r - t)^5)/(r^3 - (r - t)^3)",
        oracle = "the shell's formula; the wall's own share of its moment is t/r to first order (derivative of the " ..
          "quotient)",
        bound = "14 u + t/r, in units of which both are given: quartic and quadratic of positive terms, quotient, " ..
          "product",
        run = function(row)
          local naive = 0.0
          for _, t in ipairs { 4e-16, 1e-15, 3e-15, 7e-15, 2e-14 } do
            naive = kit.worst(naive, math.abs(naive_sphere(1.25 - t, 1.25) / 1.25 ^ 2 * 1.5 - 1) / (14 *
              kit.u.double + t))
          end
          row.naive(naive)
          local text = bodies.scene([[local r, t = param("r", 1, "m"), param("t", 0.1, "m")
local m = param("m", 1, "kg")]], "solid.hollow_sphere { r_in = r - t, r_out = r, mass = m }")
          local job = kit.read(text)
          for _, real in ipairs(kit.reals) do
            local worst, library, commands, bounds = 0.0, 0.0, {}, {}
            for _, wall in ipairs { 1e-4, 1e-8, 1e-12, 1e-14 } do
              local p = kit.rounded(real, { 1.25, math.max(wall, real == "float" and 1e-6 or wall), 3 })
              local bound = 14 * kit.u[real] + p[2] / p[1]
              commands[#commands + 1] = { "init", table.unpack(p) }
              commands[#commands + 1] = { "inertia" }
              bounds[#commands] = bound
              if real == "double" then
                local got = kit.mass(job, { r = p[1], t = p[2], m = p[3] })
                library = kit.worst(library, math.abs(got.inertia[1] / (2 / 3 * p[3] * p[1] ^ 2) - 1) / bound)
              end
            end
            for i, a in ipairs(bodies.ask(text, real, commands)) do
              if #a == 6 then worst = kit.worst(worst, math.abs(a[3] / (2 / 3 * 3 * 1.25 ^ 2) - 1) / bounds[i]) end
            end
            row("init", real, worst, 1)
            if real == "double" then row("library", "long double", library, 1) end
          end
        end },
      { name = "tube_wall_1e12", fast = true,
        why = "as before, in two dimensions; its mass is a difference of squares",
        naive = "the outer cylinder minus the inner one, masses and moments each multiplied out",
        oracle = "cylinder minus cylinder in exact rationals",
        bound = "14 u: wall (exact), sum of radii, two squares, sum, sum with h^2, density, pi, h, mass: 12, and 2 " ..
          "of constants",
        run = function(row)
          local a, b = 1 - 1e-12, 1.0
          local function tube(p)
            return M.minus(M.revolved({ q(p[2]) ^ 2 }, -q(p[3]) / q(2), q(p[3]) / q(2)),
              M.revolved({ q(p[1]) ^ 2 }, -q(p[3]) / q(2), q(p[3]) / q(2)))
          end
          local want = M.tensor(tube { a, b, 0.125 })[3]
          row.naive(bodies.error(math.pi * 0.125 * b ^ 2 * b ^ 2 / 2 - math.pi * 0.125 * a ^ 2 * a ^ 2 / 2, want, want))
          bodies.compare(row, { parameters = [[local r_in, r_out = param("r_in", 0.5, "m"), param("r_out", 1, "m")
local h, rho = param("h", 2, "m"), param("rho", 1000, "kg/m^3")]],
            body = "solid.tube { r_in = r_in, r_out = r_out, h = h, density = rho }",
            values = walls({ 1e-3, 1e-8, 1e-12, 0 }, function(inner, e)
              return { inner, 1.0, e < 1e-8 and 1e-9 or 3.0, 2700.0 }
            end), size = 1, count = 14, oracle = function(p) return M.times(p[4], tube(p)) end })
        end },
      { name = "sphere_minus_sphere_1e12", fast = true,
        why = "a hole that leaves 3e-12 of the body, written as a difference of two solids",
        naive = "m1 - m2 and I1 - I2",
        oracle = "ball minus ball in exact rationals",
        bound = "30 u, as for the hollow sphere: the difference of the radii must come out as a factor; the library " ..
          "subtracts bodies that were rounded to doubles, which costs r_out/(r_out - r_in) of it",
        run = function(row)
          local a, b = 1 - 1e-12, 1.0
          local want = M.tensor(M.minus(M.ball(b), M.ball(a)))[3]
          row.naive(bodies.error(8 * math.pi / 15 * b ^ 5 - 8 * math.pi / 15 * a ^ 5, want, want))
          bodies.compare(row, { parameters = [[local r_in, r_out = param("r_in", 0.5, "m"), param("r_out", 1, "m")
local rho = param("rho", 1000, "kg/m^3")]],
            body = "solid.sphere { r = r_out, density = rho } - solid.sphere { r = r_in, density = rho }",
            values = walls({ 1e-3, 1e-8, 1e-12, 0 }, function(inner) return { inner, 1.0, 2700.0 } end),
            size = 1, count = 30, library_condition = function(p) return p[2] / (p[2] - p[1]) end,
            oracle = function(p) return M.times(p[3], M.minus(M.ball(p[2]), M.ball(p[1]))) end })
        end },
      { name = "box_minus_box_1e12",
        why = "the wall's thickness t is a parameter, and x - 2 t rounds to x: in float 1e-12 is nothing beside 1",
        naive = "box minus box with the inner edge computed first",
        oracle = "box minus box in exact rationals (no row of the library: it takes doubles, and x - 2 t is none)",
        bound = "40 u: a polynomial of degree 5 with positive terms once t is a factor, its powers and sums",
        run = function(row)
          local t = 1e-12
          local function box(x, y, z) return M.box(-q(x) / q(2), q(x) / q(2), -q(y) / q(2), q(y) / q(2), -q(z) /
            q(2), q(z) / q(2)) end
          local function walled(p)
            local two = q(2)
            return M.minus(box(p[1], p[2], p[3]), box(p[1] - two * p[4], p[2] - two * p[4], p[3] - two * p[4]))
          end
          local want = M.tensor(walled { q(1), q(2), q(3), q(t) })[1]
          row.naive(bodies.error((6 * 13 - (1 - 2 * t) * (2 - 2 * t) * (3 - 2 * t) * ((2 - 2 * t) ^ 2 + (3 - 2 *
            t) ^ 2)) / 12, want,
            want))
          bodies.compare(row, { parameters =
            [[local x, y, z = param("x", 1, "m"), param("y", 2, "m"), param("z", 3, "m")
local t, rho = param("t", 0.1, "m"), param("rho", 1000, "kg/m^3")]],
            body = "solid.box { x = x, y = y, z = z, density = rho } - " ..
              "solid.box { x = x - 2*t, y = y - 2*t, z = z - 2*t, density = rho }",
            values = { { 1, 2, 3, 0.25, 1000 }, { 1, 2, 3, 1e-8, 1000 }, { 1.3, 2.1, 3.7, 1e-12, 2700 } },
            size = 1, count = 40, no_library = true,
            oracle = function(p) return M.times(p[5], walled(p)) end })
        end },
      { name = "cup_of_wall_1e12", fast = true,
        why = "a box with an open top and walls of 1e-12: the hole is not concentric, its share of the centre is t " ..
          "m2/mass",
        naive = "m1 - m2, (m1 c1 - m2 c2)/mass, I1 - I2 and Steiner's terms about the origin",
        oracle = "box minus box in exact rationals, about the centre of mass and about a corner (no library, either)",
        bound = "60 u of the largest entry: as for the closed box, the reduced mass and the centre from three steps " ..
          "more",
        run = function(row)
          local t = 1e-10
          local function cup(p)
            local two = q(2)
            local x, y, z = p[1] / two, p[2] / two, p[3] / two
            return M.times(p[5], M.minus(M.box(-x, x, -y, y, -z, z),
              M.box(p[4] - x, x - p[4], p[4] - y, y - p[4], p[4] - z, z)))
          end
          local want = M.com(cup { q(1), q(2), q(3), q(t), q(1) })[3]
          local m1, m2 = 6.0, (1 - 2 * t) * (2 - 2 * t) * (3 - t)
          row.naive(bodies.error(-m2 * (t / 2) / (m1 - m2), want, want))
          for _, origin in ipairs { '"centroid"', '"corner"' } do
            bodies.compare(row, { parameters =
              [[local x, y, z = param("x", 1, "m"), param("y", 2, "m"), param("z", 3, "m")
local t, rho = param("t", 0.1, "m"), param("rho", 1000, "kg/m^3")]], origin = origin,
              body = "solid.box { x = x, y = y, z = z, density = rho } - " ..
                "solid.box { x = x - 2*t, y = y - 2*t, z = z - t, density = rho }:at{0, 0, t/2}",
              values = { { 1, 2, 3, 0.25, 1000 }, { 1, 2, 3, 1e-8, 1000 }, { 1.3, 2.1, 3.7, 1e-12, 2700 } },
              size = 1, count = 60, entries = "largest", no_library = true,
              oracle = function(p)
                local b = cup(p)
                local c = M.com(b)
                if origin ~= '"corner"' then return M.at(b, { -c[1], -c[2], -c[3] }) end
                local two = q(2)
                return M.at(b, { p[1] / two, p[2] / two, p[3] / two })
              end })
          end
        end },
      { name = "frustum_to_cylinder",
        why = "r_top -> r_base: the textbook's difference of two cones divides 0 by 0",
        naive = "Izz = 3/10 m (R^5 - r^5)/(R^3 - r^3)",
        oracle = "turned polynomial, exact rationals",
        bound = "40 u: sums of positive terms of degree 6, their powers, the square below them, mass by density",
        run = function(row)
          local function frustum(p)
            local slope = (p[2] - p[1]) / p[3]
            return M.revolved({ p[1] ^ 2, q(2) * p[1] * slope, slope ^ 2 }, 0, p[3])
          end
          local R1, r1 = 1.0, 1 - 1e-12
          local want = M.tensor(M.of_mass(frustum { q(R1), q(r1), q(2) }, 1))[3]
          row.naive(bodies.error(0.3 * (R1 ^ 5 - r1 ^ 5) / (R1 ^ 3 - r1 ^ 3), want, want))
          bodies.compare(row, { parameters = [[local r1, r2 = param("r1", 1, "m"), param("r2", 0.5, "m")
local h, rho = param("h", 2, "m"), param("rho", 1000, "kg/m^3")]],
            body = "solid.frustum { r_base = r1, r_top = r2, h = h, density = rho }",
            values = walls({ 1e-3, 1e-8, 1e-12, 0 }, function(inner, e)
              return { 1.0, inner, e < 1e-8 and 1e-9 or 3.0, 2700.0 }
            end), count = 40, oracle = function(p) return M.times(p[4], frustum(p)) end })
        end },
      { name = "cap_low_and_whole", fast = true,
        why = "the cap of a ball from a height of 1e-12 r to the whole ball, whose formula about the base cancels",
        naive = "the moment about the ball's centre by its polynomial, then parallel axes to the centroid",
        oracle = "turned polynomial, exact rationals",
        bound = "40 u",
        run = function(row)
          local function cap(p) -- based: the sphere's centre is at h - r
            local c = p[2] - p[1]
            return M.revolved({ p[1] ^ 2 - c ^ 2, q(2) * c, -1 }, 0, p[2])
          end
          local h = 1e-6 -- about the centre of the unit ball, z from 1 - h to 1
          local z = 1 - h
          local m = math.pi * (2 / 3 - z + z ^ 3 / 3)
          local f = math.pi * (1 / 4 - z ^ 2 / 2 + z ^ 4 / 4)
          local zz, rr = math.pi * (2 / 15 - z ^ 3 / 3 + z ^ 5 / 5), math.pi / 4 * (8 / 15 - z + 2 * z ^ 3 / 3 -
            z ^ 5 / 5)
          local w = M.at(cap { q(1), q(h) }, { 0, 0, -M.com(cap { q(1), q(h) })[3] })
          row.naive(bodies.error(zz + rr - f * f / m, M.tensor(w)[1], M.tensor(w)[1]))
          bodies.compare(row, { parameters = [[local r, h = param("r", 1, "m"), param("h", 0.5, "m")
local rho = param("rho", 1000, "kg/m^3")]], body = "solid.cap { r = r, h = h, density = rho }", origin = '"centroid"',
            values = { { 1, 1e-12, 2700 }, { 1, 1e-3, 1 }, { 1, 1, 1 }, { 1, 1.9, 1 }, { 1, 1.999999, 1 }, { 1, 2,
              1000 } },
            count = 40, size = 1, oracle = function(p)
              local b = M.times(p[3], cap(p))
              return M.at(b, { 0, 0, -M.com(b)[3] })
            end })
        end },
      { name = "zone_thin_at_the_equator",
        why = "between two planes that are 1e-9 apart, symmetric and not, and the whole ball as a zone",
        naive = "pi (r^2 (z2 - z1) - (z2^3 - z1^3)/3) for the mass",
        oracle = "turned polynomial, exact rationals",
        bound = "40 u: z2 - z1 is exact or rounded once and a factor; a polynomial of degree 6 whose terms are 10 " ..
          "times its value",
        run = function(row)
          local a, b = 0.5, 0.5 + 1e-9
          local want = M.revolved({ 1, 0, -1 }, a, b).m
          row.naive(bodies.error(math.pi * ((b - a) - (b ^ 3 - a ^ 3) / 3), want, want))
          bodies.compare(row, zone({ { 1, 0, 1e-9, 2700 }, { 1, -1e-9, 1e-9, 1 }, { 1, 0.5, 0.5 + 2 ^ -20, 1 },
            { 1, -1, 1, 1 }, { 1, 0, 1, 1 }, { 1, -0.5, -0.5 + 2 ^ -20, 7 } }, 40))
        end },
      { name = "zone_next_to_the_pole",
        why = "the zone from r - e to r: what it weighs is e^2 of the ball, its moments e^3",
        naive = "pi (r^2 (z2 - z1) - (z2^3 - z1^3)/3) for the mass",
        oracle = "turned polynomial, exact rationals",
        bound = "60 u (r/e)^3: multiplied out, the coefficients of Ixx's numerator add up to 1440 where it is 240 " ..
          "e^3, " ..
          "and ten roundings are made; this is the formula's law (solid.cap, which is given e itself, loses nothing)",
        run = function(row)
          local e = 2 ^ -26
          local want = M.revolved({ 1, 0, -1 }, 1 - e, 1).m
          row.naive(bodies.error(math.pi * (e - (1 ^ 3 - (1 - e) ^ 3) / 3), want, want))
          local o = zone({ { 1, 1 - 2 ^ -4, 1, 1 }, { 1, 1 - 2 ^ -7, 1, 1 }, { 1, -1, -1 + 2 ^ -7, 1 } }, 60)
          function o.condition(p) return (1 / math.min(1 - p[3], 1 + p[4])) ^ 3 end
          o.library_condition = function() return 1 end
          bodies.compare(row, o)
        end },
    } }
end
