-- heavy_motion.lua -- hard cases: the heavy symmetric top's kinds of nutation, pendulums, weights and long times.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m, motion = kit.tool "heavy", kit.tool "motion"
  local half = { 0.8, 0.6, 0, 0 } -- the axis 73.7 degrees from the vertical
  local loose = { 0.9, 0.3, 0.1, -0.2 }

  local SERIES = "Taylor series of MPFR, 192 bits, which knows of no symmetry (tests/oracle/heavy_top.c)"
  local EULER = "Runge and Kutta's steps, 1/256 of the pace, in Euler's angles, with 1/sin(tilt): infinite at the " ..
    "vertical, large near it; state at the last time"
  local BAR = "36 u of the pace, the larger of |w| and sqrt(m g l/A): three phases reduced in pairs, rounded once, " ..
    "four " ..
    "terms of theta series, a dozen operations"

  local function case(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = EULER, oracle = SERIES,
      bound = o.law and BAR .. ". " .. o.law or BAR, only = o.only, because = o.because,
      run = function(row) m.run(row, o, o) end }
  end

  -- What the library's integration leaves of 1e-18 a unit of time where errors grow with exp(t).
  local function grows(_, _, t, u) return motion.BAR + 4e-18 * math.exp(math.abs(t)) / u end
  local GROWS = "The library integrates: its 1e-18 a unit of time grows with exp(t/tau)"

  -- The weight and spins in other units, over ten radians.
  local function scaled(k, s)
    return { loose, function(real) return { s(real), s(real) / 2, 5 * s(real) } end,
      function(real) return 2 * k(real) * s(real) ^ 2 end, function(real) return { 1 / s(real), 10 / s(real) } end, k,
      function(real) return k(real) / 2 end }
  end
  local function by(double, float) return function(real) return real == "float" and float or double end end

  return { title = "Heavy symmetric top", about = "Kinds of nutation, pendulums, tiny and huge weights, long times.",
    cases = {
      case("nutation_cusps", { why = "the axis is released from rest: at each cusp it stands still " ..
        "exactly, " ..
        "and its azimuth's rate is 0/0 in form", { half, { 0, 0, 8 }, 2, { 1, 20, -7 } }, { half, { 0, 0, 0.5 }, 2,
          { 20 } } }),
      case("nutation_loops", { why = "the precession turns back in every loop", { { 0.9, 0.4, 0.1, 0 }, { -2, 1, 9 }, 2,
        { 1, 10, -3 } } }),
      case("nutation_none", { why = "regular precession: a double root of the cubic, exactly in double " ..
        "and " ..
        "nearly (1e-9 beside it); the square of the modulus is 0 or 1e-18",
        { half, { 0, 0.96, 4.56 }, 2, { 1, 20 } }, { half, { 1e-9, 0.96, 4.56 }, 2, { 1, 20 } },
        { { 0.6, 0.8, 0, 0 }, { 0, 2, 0 }, 1, { 1, 20 } } }),
      case("nutation_through_the_vertical", { why = "L_z = C w3: the axis passes exactly through the " ..
        "upright, " ..
        "where Euler's angles have no value; and 1e-10 past it",
        { { 1, 0, 0, 0 }, { 1, 0, 3 }, 2, { 1, 20, -7 } }, { { 1, 1e-10, 0, 0 }, { 1, 0, 3 }, 2, { 1, 20 } } }),
      case("nutation_through_the_bottom", { why = "and through the hanging point, which is the vertical too",
        { { 0, 0.8, 0.6, 0 }, { 1, 0, 3 }, 2, { 1, 20 } }, { { 0, 0.8, 0.6, 1e-10 }, { 1, 0, 3 }, 2, { 1, 20 } } }),
      case("fast_top", { why = "spin 1e4 times the precession: phases of very different speeds, a tiny " ..
        "cusp",
        { half, { 0, 0, 1e4 }, 2, { 1e-3, 0.1 } }, { half, { 0, 2e-4, 1e4 }, 2, { 1e-3, 0.1 } } }),
      case("pendulum_spherical", { why = "no spin: a spherical, a plane and a turning pendulum; L_3 is " ..
        "0 and the " ..
        "cubic is the pendulum's", { { 0.3, 0.9, 0.2, 0.1 }, { 1, 0.5, 0 }, 2, { 1, 20 } },
        { { 0.6, 0.8, 0, 0 }, { 0.5, 0, 0 }, 2, { 1, 20 } }, { { 0.6, 0.8, 0, 0 }, { 5, 0, 0 }, 2, { 1, 10 } } }),
      case("pendulum_separatrix", { library_bar = grows, law = GROWS,
        why = "from the bottom with just the rate that ends upright, at no finite time",
        { { 0, 1, 0, 0 }, { 2, 0, 0 }, 1, { 1, 5, 15, -10 } } }),
      case("pendulum_separatrix_60_tau", { library = false,
        why = "60 time constants on it: what is off by u at the start is off by exp(60) u = 1e10 at the end",
        law = "The orbit keeps that it has no period; so float stays there, too. (The library integrates, and " ..
          "falls: no row)",
        { { 0, 1, 0, 0 }, { 2, 0, 0 }, 1, { 30, 60, -60 } } }),
      case("pendulum_separatrix_sides", { library = false,
        why = "the rate at the bottom one unit of the last place less and more: it comes back, it goes over",
        { { 0, 1, 0, 0 }, function(real) return { 2 - 2 * kit.u[real], 0, 0 } end, 1, { 10, 50 } },
        { { 0, 1, 0, 0 }, function(real) return { 2 + 4 * kit.u[real], 0, 0 } end, 1, { 10, 50 } } }),
      case("weight_tiny", { why = "m g l = 1e-20 and 1e-300 (float: 1e-30): the free top's limit; and " ..
        "no weight",
        { loose, { 1, 0.5, 5 }, 1e-20, { 1, 10 } }, { loose, { 1, 0.5, 5 }, by(1e-280, 1e-30), { 1, 10 } },
        { loose, { 1, 0.5, 5 }, 0, { 1, 10 } } }),
      case("weight_huge", { why = "m g l = 1e20 against rates of 5 rad/s: the pendulum's limit, 1e10 times faster " ..
        "than the spin",
        { loose, { 1, 0.5, 5 }, by(1e20, 1e6), function(real)
          return real == "float" and { 1e-3, 1e-2 } or { 1e-10, 1e-9 } end } }),
      case("heavy_rod_sphere_disc", {
        library_bar = function(p, x0, t, u)
          return motion.BAR + (p[2] > 0 and p[1] / p[2] or 0) * 2.0 ^ -64 * math.abs(t) * m.pace(p, x0) / u
        end,
        law = "The library keeps a tensor as second moments, whose sum has C to 2^-64 of A: times A/C and the " ..
          "radians", why = "C = 0, 1e-6, A, 2 A: no spin momentum, the sphere's (whose axis is " ..
        "that of its weight), the triangle's limit",
        { loose, { 1, 0.5, 3 }, 1, { 1, 10 }, 1, 0 }, { loose, { 1, 0.5, 300 }, 1, { 1, 5 }, 1, 1e-6 },
        { loose, { 1, 0.5, 3 }, 1, { 1, 10 }, 1, 1 }, { loose, { 1, 0.5, 3 }, 1, { 1, 10 }, 1, 2 } }),
      case("heavy_scales", { why = "moments 1e30 with paces 1e-15 and the reverse (float: 1e12 and 1e-6)",
        scaled(by(1e30, 1e10), by(1e-15, 1e-5)), scaled(by(1e-30, 1e-10), by(1e14, 1e5)) }),

      { name = "time_1e6_nutations",
        why = "a million nutations: three phases, none of them commensurable, whose rates come from integrals",
        naive = "the same state after the time less N periods, the period rounded to a double: N u T times the pace",
        oracle = "MPFR's Taylor series over one period, found by Newton's method, and powers of its turn (heavy_top " ..
          "-p)",
        bound = BAR .. "; and 2^-100 of a turn for each turn, in float 2^-42",
        run = function(row)
          local x0 = { 0.9, 0.3, 0.1, -0.2, 1, 0.5, 5 }
          for _, real in ipairs(kit.reals) do
            local x, p = kit.rounded(real, x0), m.parameters(2)
            local b = kit.emitted({ text = m.text })[real]
            -- an approximation of the period, from when gamma_z comes back: twice its way from turn to turn
            b.plugin:init(p)
            b.plugin:solve(x)
            local function slope(t)
              local y = b.plugin:at(t)
              return 2 * (y[2] * y[4] - y[1] * y[3]) * y[6] - 2 * (y[3] * y[4] + y[1] * y[2]) * y[5]
            end
            local turns, last = {}, slope(0)
            for n = 1, 2000 do
              local now = slope(n / 256)
              if last * now < 0 then
                local a, c = (n - 1) / 256, n / 256
                for _ = 1, 40 do
                  local middle = (a + c) / 2
                  if slope(a) * slope(middle) <= 0 then c = middle else a = middle end
                end
                turns[#turns + 1] = a
              end
              last = now
            end
            local period = turns[3] - turns[1]
            local t = kit.round(real, 1.0e6 * period)
            local line = { 1, 1, 0.5, 0, 0, 2, x[5], x[6], x[7], x[1], x[2], x[3], x[4], t, period }
            local r = kit.oracle("heavy_top", "-b 192 -p", { line })[1]
            local want = { r[4], r[5], r[6], r[7], r[1], r[2], r[3] }
            local pace = m.pace(p, x)
            row("at", real, motion.state(b.plugin:at(t), want, pace), motion.long(2 * pace)(p, x, t, b.u) * b.u)
            if real == "double" then
              row.naive(motion.state(b.plugin:at(math.fmod(t, period)), want, pace))
            end
          end
        end },
    } }
end
