-- gyrostat.lua -- hard cases: a body of three moments with a rotor along its third axis.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Moments 1, 2, 5/2.  The spin s about the third axis is unstable for h between -(C - A) s and -(C - B) s: -3/2 and
-- -1/2.

return function(kit)
  local m, naive = kit.tool "motion", kit.tool "naive"
  local text = [[
local A, B, C = param("A", 1, "kg m^2"), param("B", 2, "kg m^2"), param("C", 2.5, "kg m^2")
local H = param("H", 20, "kg m^2/s")
return scene { name = "dual", body = tensor { mass = 1, xx = A, yy = B, zz = C },
  effects = { effect.rotor { axis = {0, 0, 1}, momentum = H } } }
]]
  local function truth(p, x0, times, bits)
    return kit.heavy_top({ p[1], p[2], p[3] }, { 0, 0, p[4] }, x0, times, string.format("-b %d -r", bits or 224))
  end
  local function pace(p, x0)
    local M = math.sqrt((p[1] * x0[5]) ^ 2 + (p[2] * x0[6]) ^ 2 + (p[3] * x0[7] + p[4]) ^ 2)
    return math.max(m.size(x0, 5, 7), M / math.min(p[1], p[2], p[3]))
  end

  local SERIES = "Taylor series of MPFR, 224 bits, of a body with a rotor (tests/oracle/heavy_top.c -r)"
  local PLAIN = "Euler's equations with h by Runge and Kutta's steps, 2^-8 of the pace, q += h q (0, w)/2 without a " ..
    "norm; state " ..
    "at the last time"
  local BAR = "36 u of the pace, the larger of |w| and |M| over the least moment: three phases reduced in pairs, " ..
    "rounded once, " ..
    "five terms of theta series, a dozen operations"

  -- list of {moments and h, rates, times}; o.growth, 1/s: the library integrates, and loses with it
  local function case(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = PLAIN, oracle = SERIES,
      bound = o.growth and BAR .. "; the library's 1e-18 for each unit of time grows with exp(t/tau)" or BAR,
      run = function(row)
        local worst = 0.0
        for i, s in ipairs(o) do
          local function of(k, real) return type(s[k]) == "function" and s[k](real) or s[k] end
          local function x0(real)
            local w = of(2, real)
            return { 0.5, -0.5, 0.1, 0.7, w[1], w[2], w[3] }
          end
          m.closed(row, { text = text, p = s[1], x0 = x0, times = s[3], pace = pace, library = o.library,
            truth = function(q, y, times) return truth(q, y, times, o.bits) end,
            who = #o > 1 and string.format("%d", i) or nil,
            library_bar = o.growth and function(_, _, t,
              u) return m.BAR + 4e-18 * math.exp(o.growth * math.abs(t)) / u end })
          local p, x, t = of(1, "double"), x0 "double", s[3][#s[3]]
          local fast = pace(p, x)
          local n = math.ceil(math.abs(t) * fast * 256)
          local got = naive.march(p, x, t / n, n, p[4])
          worst = kit.worst(worst, m.state(got, truth(p, x, { t }, o.bits)[1], fast))
        end
        row.naive(worst)
      end }
  end

  -- next to the spin s = 1 about the rotor's axis, with h
  local function near(h, e, times)
    return { function(real) return { 1, 2, 2.5, type(h) == "function" and h(real) or h } end,
      function(real) return { math.max(e, kit.tiny[real]), 0, 1 } end, times }
  end

  return { title = "Gyrostat", about = "A rotor that makes an axis critical, that does nothing, that does everything.",
    cases = {
      case("gyrostat_critical_rotor", { near(-0.5, 1e-4, { 1, 20, -50 }), near(-1.5, 1e-4, { 1, 20 }),
        near(-0.5, 0, { 1, 20 }), fast = true,
        why = "h = -(C - B) s exactly: the spin about the rotor's axis is neither stable nor unstable; also " ..
          "with the smallest number across, whose square is 0" }),
      case("gyrostat_stable_axis", { fast = true, why = "the spin is stable, and what is across it is 1e-300 and " ..
        "the smallest " ..
        "number (float: 1e-40): two bands whose width is a square of that", near(1, 1e-300, { 1, 20, -50 }),
        near(1, 0, { 1, 20 }), { { 1, 2, 2.5, 1 }, function(real)
          local e = real == "float" and 1e-40 or 1e-300
          return { 1, e, -e }
        end, { 1, 20 } } }),
      case("gyrostat_critical_sides", { fast = true, why = "h one unit of the last place and 1e-8 on either side of it",
        near(function(real) return -0.5 * (1 + 2 * kit.u[real]) end, 1e-6, { 1, 50 }),
        near(function(real) return -0.5 * (1 - kit.u[real]) end, 1e-6, { 1, 50 }), near(-0.5 * (1 + 1e-8), 1e-6,
          { 1, 50 }),
        near(-0.5 * (1 - 1e-8), 1e-6, { 1, 50 }) }),
      case("gyrostat_unstable_axis", { library = false, bits = 384,
        near(-1, 1e-8, { 10, 60, 100 }), near(-1, 1e-40, { 100, 300 }),
        why = "h makes the rotor's axis unstable: from 1e-8 and 1e-40 across it (a subnormal float) it falls away " ..
          "in time. (The library " ..
          "integrates, and loses exp(t/tau) u: no row)" }),
      case("gyrostat_rotor_off", { { { 1, 2, 2.5, 0 }, { 1, 1, 0.5 }, { 1, 20, -7 } }, fast = true, growth = 0.4,
        { { 1, 2, 2.5, -0.0 }, { 1, 1, 0.5 }, { 1, 20 } }, { { 3, 4, 6, 0 }, { 0.5, 1, 0.25 }, { 1, 20 } },
        { { 2, 2, 2.5, 0 }, { 1, 1, 0.5 }, { 1, 20 } }, { { 2, 2, 2, 0 }, { 1, 1, 0.5 }, { 1, 20 } },
        why = "h = 0, +0 and -0: the free top, its separatrix, the symmetric top and the sphere in a gyrostat's " ..
          "code" }),
      case("gyrostat_rotor_fast", { { { 1, 2, 2.5, 1e8 }, { 1e-3, 1e-3, 1e-3 }, { 1e-8, 1e-6 } }, fast = true,
        { { 1, 2, 2.5, 1e4 }, { 0.05, -0.02, 0.01 }, { 1e-3, 1e-2 } },
        why = "the rotor has all the momentum: the platform's slow rates are differences of what is 1e11 times as " ..
          "large" }),
      case("gyrostat_no_momentum", { { { 1, 2, 2.5, -2.5 }, { 0, 0, 1 }, { 1, 20 } }, fast = true,
        { { 1, 2, 2.5, -2.5 }, function(real) return { real == "float" and 1e-30 or 1e-200, 0, 1 } end, { 1, 20 } },
        { { 1, 2, 2.5, -2.5 }, { 1e-7, 1e-7, 1 }, { 1, 20 } }, { { 1, 2, 2.5, 0 }, { 0, 0, 0 }, { 1, 20 } },
        why = "I w + h = 0: there is no direction of M to turn about, and 1e-200 beside it (float: 1e-30) there is " ..
          "one" }),
    } }
end
