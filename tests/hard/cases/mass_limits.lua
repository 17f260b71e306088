-- mass_limits.lua -- hard cases: needles, plates, rods, thin rings, short arcs, shells on the way to balls and discs.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local bodies = kit.use "bodies"
  local M, q, R = bodies.moments, bodies.q, kit.R

  local function square(x) return q(x) ^ 2 end
  local function apply(name, ...) return R.apply(name, M.bits, ...) end

  -- A body of revolution about z, centred: m, mean of x^2 and of z^2.
  local function symmetric(m, xx, zz)
    local out = M.none()
    out.m, out.s[1], out.s[2], out.s[3] = m, m * xx, m * xx, m * zz
    return out
  end

  -- The surface of a spheroid x^2/a^2 + z^2/c^2 = 1, of density rho: dA = 2 pi a sqrt(1 + k z^2) dz with
  -- k = (a^2 - c^2)/c^4, in elementary functions.
  local function spheroid(a, c, rho)
    a, c = q(a), q(c)
    local k = (square(a) - square(c)) / c ^ 4
    local root = apply("sqrt", 1 + k * c ^ 2) -- = a/c, at the pole
    local bare, zz -- half the integrals of sqrt(1 + k z^2) and of z^2 times it, from 0 to c
    if R.sign(k) == 0 then bare, zz = c, c ^ 3 / q(3)
    else
      local s = apply("sqrt", R.abs(k))
      local arc = apply(R.sign(k) > 0 and "asinh" or "asin", s * c) / s
      bare = (c * root + arc) / q(2)
      zz = (c * root ^ 3 - bare) / (q(4) * k)
    end
    local area = q(4) * M.pi() * a * bare
    local mean = zz / bare
    return symmetric(area * q(rho), square(a) * (1 - mean / square(c)) / q(2), mean)
  end

  -- Plane figures about the ray at half the angle: sector or arc of the half angle h, radius 1, area or length 1
  -- (x along the ray): mean x, x^2, y^2 times the means of r and r^2.
  local function fan(h, r1, r2)
    local sin, cos = apply("sin", h), apply("cos", h)
    local x, xx = sin / h, (1 + sin * cos / h) / q(2)
    local out = M.none()
    out.m, out.f[1], out.s[1], out.s[2] = q(1), r1 * x, r2 * xx, r2 * (1 - xx)
    return M.affine(out, { { cos, -sin, 0 }, { sin, cos, 0 }, { 0, 0, 1 } }, { 0, 0, 0 })
  end
  local function about_com(b) -- the same about its centre of mass
    local c = M.com(b)
    return M.at(b, { -c[1], -c[2], -c[3] })
  end

  return { title = "Needles, plates, limits", about = "Bodies one size of which vanishes, and forms that divide 0 " ..
    "by 0 there.",
    cases = {
      { name = "needle_1e8", fast = true,
        why = "a cylinder of radius 1e-8 of its length: Izz is 6e-16 of Ixx and must keep its own digits",
        naive = "Izz = Ixx + Iyy - 2 m (mean of z^2): the trace less twice a second moment",
        oracle = "turned polynomial, exact rationals",
        bound = "12 u of each moment itself: squares, a sum of positive terms, mass by density",
        run = function(row)
          local r, h = 1e-8, 1.0
          local xx = (3 * r * r + h * h) / 12
          row.naive(math.abs((2 * xx - 2 * (h * h / 12)) / (r * r / 2) - 1))
          bodies.compare(row, { parameters = [[local r, h = param("r", 1, "m"), param("h", 2, "m")
local rho = param("rho", 1000, "kg/m^3")]], body = "solid.cylinder { r = r, h = h, density = rho }", size = 1,
            count = 12,
            -- float ends at 1e-38, and Izz is r^4
            values = { double = { { 1e-8, 1, 2700 }, { 1.3e-8, 3, 7800 }, { 1e-12, 1.7, 7800 } },
              float = { { 1e-8, 1, 2700 }, { 1.3e-8, 3, 7800 } } },
            oracle = function(p)
              return M.times(p[3], M.revolved({ p[1] ^ 2 }, -p[2] / q(2), p[2] / q(2)))
            end })
        end },
      { name = "plate_1e8_and_1e12",
        why = "a box 1e-8 and 1e-12 thick: Izz = Ixx + Iyy to the last digit, and x^2 + z^2 forgets z",
        naive = "the thickness's own moment m z^2/12 as (Ixx + Iyy - Izz)/2, as from any tensor",
        oracle = "box, exact rationals",
        bound = "10 u of each moment: three squares and sums of positive terms, a mass of three products",
        run = function(row)
          local x, y, z = 1.0, 0.7, 1e-12
          local I = { (y * y + z * z) / 12, (x * x + z * z) / 12, (x * x + y * y) / 12 }
          row.naive(math.abs((I[1] + I[2] - I[3]) / 2 / (z * z / 12) - 1))
          bodies.compare(row, { parameters =
            [[local x, y, z = param("x", 1, "m"), param("y", 2, "m"), param("z", 3, "m")
local rho = param("rho", 1000, "kg/m^3")]], body = "solid.box { x = x, y = y, z = z, density = rho }", size = 1,
            count = 10,
            values = { { 1, 0.7, 1e-8, 2700 }, { 1, 0.7, 1e-12, 2700 }, { 1e-8, 1e-12, 1.3, 1 } },
            oracle = function(p)
              local two = q(2)
              return M.times(p[4], M.box(-p[1] / two, p[1] / two, -p[2] / two, p[2] / two, -p[3] / two, p[3] / two))
            end })
        end },
      { name = "torus_thin_and_closed",
        why = "a tube of 1e-12 of the ring, and one that all but closes the hole in the middle",
        naive = "washers: pi ((R + s)^2 - (R - s)^2), a difference of squares",
        oracle = "washers in exact rationals: (R + s)^2 - (R - s)^2 = 4 R s and its like, integrals of s = sqrt(r^2 " ..
          "- z^2)",
        bound = "14 u of each moment",
        run = function(row)
          local function torus(p)
            local a, r, pi = p[1], p[2], M.pi()
            local m = q(2) * pi ^ 2 * a * r ^ 2 * p[3]
            return symmetric(m, (square(a) + q(3) / q(4) * square(r)) / q(2), square(r) / q(4))
          end
          local s = 1e-9
          row.naive(math.abs(((1 + s) ^ 2 - (1 - s) ^ 2) / (4 * s) - 1))
          bodies.compare(row, { parameters = [[local c, r = param("c", 1, "m"), param("r", 0.5, "m")
local rho = param("rho", 1000, "kg/m^3")]], body = "solid.torus { R = c, r = r, density = rho }", size = 1, count = 14,
            values = { double = { { 1, 1e-12, 2700 }, { 1, 1e-6, 1 }, { 1, 1 - 2 ^ -52, 1 } },
              float = { { 1, 1e-12, 2700 }, { 1, 1e-6, 1 }, { 1, 1 - 2 ^ -23, 1 } } }, oracle = torus })
        end },
      { name = "ellipsoid_shell_near_the_sphere", fast = true,
        why = "axes that differ by 1e-8 and 1e-15: the closed area divides arccos by a root of their difference",
        naive = "area 2 pi a^2 (1 + (c/(a e)) asin e), e^2 = 1 - a^2/c^2, and its moment with 1/e^2",
        oracle = "the spheroid's integrals in elementary functions, 600 bits",
        bound = "24 u of each moment: the algorithm's means to 4 u (docs/design.md), two of them in a sum of four " ..
          "terms, " ..
          "the area, density and pi",
        run = function(row)
          local a, c = 1.0, 1 + 1e-12
          local e = math.sqrt(1 - a * a / (c * c))
          local want = spheroid(a, c, 1)
          local k = (a * a - c * c) / c ^ 4
          local bare = (a + math.asin(math.sqrt(-k) * c) / math.sqrt(-k)) / 2
          local naive = (a ^ 3 / c ^ 2 - bare) / (4 * k) / bare
          row.naive(e > 0 and bodies.error(naive, want.s[3] / want.m, want.s[3] / want.m) or 1)
          bodies.compare(row, { parameters = [[local a, c = param("a", 1, "m"), param("c", 2, "m")
local rho = param("rho", 1000, "kg/m^2")]], body = "shell.ellipsoid { a = a, b = a, c = c, density = rho }", size = 1,
            count = 24, values = { { 1, 1, 1 }, { 1, 1 + 2 ^ -20, 1 }, { 1, 1 - 2 ^ -23, 3 }, { 1, 1 - 1e-3, 3 },
              { 1 + 1e-15, 1, 3 }, { 1 + 1e-8, 1, 3 } },
            oracle = function(p) return spheroid(p[1], p[2], p[3]) end })
        end },
      { name = "ellipsoid_shell_needle_and_disc",
        why = "ratios of axes of 1e8: the surface of a needle, and of a disc of two sides",
        naive = "Knud Thomsen's formula for the area with p = 1.6075, good to 1 %",
        oracle = "the spheroid's integrals in elementary functions, 600 bits",
        bound = "24 u of each moment, as for the nearly spherical one: no term cancels at any ratio",
        run = function(row)
          local p, c = 1.6075, 1e8
          local want = spheroid(1, c, 1).m
          row.naive(bodies.error(4 * math.pi * ((1 + 2 * c ^ p) / 3) ^ (1 / p), want, want))
          bodies.compare(row, { parameters = [[local a, c = param("a", 1, "m"), param("c", 2, "m")
local rho = param("rho", 1000, "kg/m^2")]], body = "shell.ellipsoid { a = a, b = a, c = c, density = rho }", size = 1,
            count = 24, values = { { 1, 1e4, 1 }, { 1e-8, 1, 1 }, { 1, 1e-8, 3 }, { 1, 1e-4, 2 } },
            oracle = function(v) return spheroid(v[1], v[2], v[3]) end })
        end },
      { name = "sector_and_arc_of_1e8", fast = true,
        why = "arcs of 1e-8 rad: their own moments across vanish with angle^2 and along with angle^4",
        naive = "(1 - sin(2 h)/(2 h))/2 and (1 + sin(2 h)/(2 h))/2 - (sin h/h)^2",
        oracle = "sine and cosine with 600 bits",
        bound = "16 u of the largest entry about the centre: a mean by its series to 2 u, sine, cosine, four " ..
          "products, a sum",
        run = function(row)
          local h = 0.5e-4
          local want = about_com(fan(q(h), q(1), q(1))).s
          local along = (1 + math.sin(2 * h) / (2 * h)) / 2 - (math.sin(h) / h) ^ 2
          local exact = (1 + apply("sin", q(2 * h)) / q(2 * h)) / q(2) - (apply("sin", q(h)) / q(h)) ^ 2
          row.naive(bodies.error(along, exact, exact) + 0 * #want)
          bodies.compare(row, { parameters =
            [[local r, angle, m = param("r", 1, "m"), param("angle", 0.5, "rad"), param("m", 1, "kg")]],
            body = "wire.arc { r = r, angle = angle, mass = m }", origin = '"centroid"', count = 16, size = 1,
              entries = "largest",
            values = { double = { { 1, 1e-8, 1 }, { 1, 1e-4, 1 }, { 2, 0.01, 3 }, { 1, 1, 1 }, { 1, 6.25, 1 } },
              -- the determinant of the tensor is angle^6, and float ends at 1e-38
              float = { { 1, 1e-5, 1 }, { 1, 1e-4, 1 }, { 2, 0.01, 3 }, { 1, 1, 1 }, { 1, 6.25, 1 } } },
            oracle = function(p) return M.times(p[3], about_com(M.scaled(fan(p[2] / q(2), q(1), q(1)), p[1], p[1],
              1))) end })
        end },
      { name = "rod_between_far_points", fast = true,
        why = "a rod of 1 m that lies 1e9 m away, oblique: ends minus ends",
        naive = "the tensor about the origin less m R^2",
        oracle = "the segment's moments, exact rationals",
        bound = "10 u of the largest entry about the centre: the differences of the ends are exact (Sterbenz), " ..
          "squares, sums",
        run = function(row)
          local x = { 1e9, 1e9 + 0.5, 1e9 - 2 }
          local y = { 1e9 + 1, 1e9 + 0.25, 1e9 - 1.5 }
          local want = M.tensor(about_com(M.simplex({ x, y }, 1)))
          local function second(i) return (x[i] ^ 2 + x[i] * y[i] + y[i] ^ 2) / 3 end
          local function com(i) return (x[i] + y[i]) / 2 end
          row.naive(bodies.error(second(2) + second(3) - com(2) ^ 2 - com(3) ^ 2, want[1], want[1]))
          local function near(p, size) -- the type's numbers near size
            local out = { 1 }
            for i, d in ipairs(p) do out[1 + i] = size + d end
            return out
          end
          bodies.compare(row, { parameters = [[local m = param("m", 1, "kg")
local x, y, z = param("x", 0, "m"), param("y", 0, "m"), param("z", 0, "m")
local X1, Y1, Z1 = param("ex", 1, "m"), param("ey", 2, "m"), param("ez", 3, "m")]],
            body = "rod.between { from = {x, y, z}, to = {X1, Y1, Z1}, mass = m }", origin = '"centroid"', count = 10,
            size = 1, entries = "largest", effects = "",
            values = { double = { near({ 0, 0.5, -2, 1, 0.25, -1.5 }, 2 ^ 30) },
              float = { near({ 0, 64, -128, 192, 320, -448 }, 2 ^ 29) } },
            oracle = function(p)
              return about_com(M.simplex({ { p[2], p[3], p[4] }, { p[5], p[6], p[7] } }, p[1]))
            end })
        end },
      { name = "capsule_and_cap_degenerate",
        why = "a capsule without cylinder (1e-12) and one without ends",
        naive = "cylinder and two half balls with parallel axes there and back: (h/2 + 3 r/8)^2 - (3 r/8)^2",
        oracle = "three turned polynomials, exact rationals",
        bound = "20 u of each moment: a cubic of positive terms, a quotient, the mass",
        run = function(row)
          local function capsule(p)
            local r, h = p[1], p[2] / q(2)
            local up = M.revolved({ r ^ 2 - h ^ 2, q(2) * h, -1 }, h, h + r)
            local both = M.add(M.revolved({ r ^ 2 }, -h, h), M.add(up, M.scaled(up, 1, 1, -1)))
            return M.times(p[3], both)
          end
          local r, h = 1e-8, 1.0
          local want = M.tensor(capsule { q(r), q(h), q(1) })[3]
          local all = math.pi * r * r * (h + 4 * r / 3)
          local xx = math.pi * r * r * (h ^ 3 / 12 + r * r * h / 4 + 4 * r / 3 * (0.4 * r * r + h * h / 4 + 0.375 *
            h * r))
          local zz = math.pi * r * r * (h ^ 3 / 12 + 4 * r / 3 * (0.2 * r * r + h * h / 4 + 0.375 * h * r))
          row.naive(bodies.error(2 * (xx - zz) + 0 * all, want, want))
          bodies.compare(row, { parameters = [[local r, h = param("r", 1, "m"), param("h", 2, "m")
local rho = param("rho", 1000, "kg/m^3")]], body = "solid.capsule { r = r, h = h, density = rho }", size = 1,
            count = 20,
            values = { double = { { 1, 1e-12, 1 }, { 1e-8, 1, 1 }, { 1e-12, 1, 2700 } },
              float = { { 1, 1e-12, 1 }, { 1e-8, 1, 1 } } }, oracle = capsule })
        end },
    } }
end
