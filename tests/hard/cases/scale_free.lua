-- scale_free.lua -- hard cases: the free top in units that nobody would choose, and attitudes of any length.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m, naive = kit.tool "motion", kit.tool "naive"
  local p = { 1, 2, 2.5 }
  local MPFR = "MPFR, 1280 bits, textbook formulas (tests/oracle/free_top.c)"
  local BAR = "36 u: units are powers of two within the set-up, so they cost no rounding"

  local function state(q, s) return { q[1], q[2], q[3], q[4], s, s, s / 2 } end
  local unit = { 0.5, -0.5, 0.1, 0.7 }

  -- Rates of about s(real), over 1, 10 and -20 radians; moments times k(real).
  local function scaled(name, why, s, k, fast, o)
    o = o or {}
    return { name = name, fast = fast, why = why, oracle = MPFR, bound = BAR,
      naive = "the textbook's formulas from T and L^2 (Landau and Lifshitz, Mechanics, 37): which overflow or " ..
        "vanish; " ..
        "rates after 10 radians",
      run = function(row)
        local function moments(real) return { p[1] * k(real), p[2] * k(real), p[3] * k(real) } end
        local x0, t = state(unit, s "double"), o.times and 1e290 or 10 / s "double"
        row.naive(naive.rates_error(moments "double", x0, t, m.truth(moments "double", x0, { t })[1]))
        m.free(row, { p = moments, x0 = function(real) return state(unit, s(real)) end,
          times = o.times or function(real) return { 1 / s(real), 10 / s(real), -20 / s(real) } end,
            library = o.library })
      end }
  end
  local function one() return 1.0 end
  local function by(double, float) return function(real) return real == "float" and float or double end end

  -- q0 times `length` of the type.
  local function quaternion(name, why, length, text, fast)
    return { name = name, fast = fast, why = why, naive = text, oracle = MPFR .. ", which takes q/|q|", bound = BAR,
      run = function(row)
        local q = { 1, 2, 0, -1 }
        local s = length "double"
        local n = math.sqrt((q[1] * s) ^ 2 + (q[2] * s) ^ 2 + (q[4] * s) ^ 2)
        local x = { q[1] * s / n, q[2] * s / n, 0, q[4] * s / n, 1, 1, 0.5 }
        local exact = state({ 1, 2, 0, -1 }, 1)
        row.naive(m.state(x, m.truth(p, exact, { 0 })[1]))
        m.free(row, { p = p, x0 = function(real)
            local l = length(real)
            return state({ q[1] * l, q[2] * l, 0, q[4] * l }, 1)
          end, times = { 0, 1, -10 } })
      end }
  end
  local NORM = "q/sqrt(q.q) in doubles: error of the attitude at t = 0"

  return { title = "Units", about = "Scales of rates, moments and quaternions.",
    cases = {
      scaled("rates_1e30", "spins of 1e30 rad/s (float: 1e12): w^4 overflows", by(1e30, 1e12), one, true),
      scaled("rates_1e_30", "spins of 1e-30 rad/s (float: 1e-12) over 1e31 s: squares of squares vanish", by(1e-30,
        1e-12),
        one, true),
      scaled("rates_1e160", "rates 1e160 (float: 1e20): w^2 is beyond the type's range; the library refuses, for " ..
        "its energy " ..
        "is no double", by(1e160, 1e20), one, true, { library = false }),
      scaled("rates_subnormal", "the spin itself is subnormal, and hardly turns the body in the longest time that " ..
        "there is",
        by(1e-310, 1e-43), one, false,
        { times = function(real) return real == "float" and { 1, 1e28 } or { 1, 1e290 } end }),
      scaled("rates_and_moments_1e30", "moments 1e30 and rates 1e30 (float: 1e12): the energy is 1e90, 1e36",
        by(1e30, 1e12), by(1e30, 1e12), false),
      scaled("rates_against_moments", "moments 1e30 with rates 1e-30 (float: 1e12, 1e-12)", by(1e-30, 1e-12),
        by(1e30, 1e12), false),

      quaternion("quaternion_not_unit", "q = (1, 2, 0, -1): |q| is irrational, an attitude all the same", one,
        NORM, true),
      quaternion("quaternion_1e150", "q of length 1e200 (float: 1e30): q.q is infinite", by(1e200, 1e30), NORM, true),
      quaternion("quaternion_1e_150", "q of length 1e-200 (float: 1e-30): q.q is 0", by(1e-200, 1e-30), NORM, true),
      quaternion("quaternion_subnormal", "all of q is subnormal, -2^-1074 its smallest component (float: 2^-149)",
        function(real) return kit.tiny[real] end, NORM, true),

      { name = "quaternion_sign", fast = true,
        why = "q and -q are one attitude: the motion from -q is the other's with the sign, to the last bit",
        naive = "the angle between two attitudes as 2 acos(q.q') of q and -q: 2 pi instead of 0",
        oracle = "the motion from q: exact symmetry", bound = "u: no difference at all is allowed, so half a unit " ..
          "is too much",
        run = function(row)
          local minus = { -0.5, 0.5, -0.1, -0.7 }
          local dot = 0.0
          for i = 1, 4 do dot = dot + unit[i] * minus[i] end
          row.naive(2 * math.acos(math.max(-1, dot)))
          kit.each({ text = m.text }, function(b, real)
            local worst = 0.0
            b.plugin:init(p)
            for _, t in ipairs { 0, 1, -33, 1e5 } do
              b.plugin:solve(state(unit, 1))
              local x = b.plugin:at(t)
              b.plugin:solve(state(minus, 1))
              local y = b.plugin:at(t)
              for i = 1, 7 do worst = kit.worst(worst, math.abs(x[i] + (i <= 4 and 1 or -1) * y[i])) end
            end
            row("at", real, worst, b.u)
          end)
        end },

      { name = "quaternion_continuity", fast = true,
        why = "a quaternion has two values for each attitude: q(t) must not jump between them, through quadrants, " ..
          "half " ..
          "periods and flips, on either side of the separatrix",
        naive = "q from the rotation matrix, the largest of four squares first, w > 0 (Shepperd): |q' - q| over 0.01 s",
        oracle = "|q'| = |w|/2 is the speed of the quaternion: |q(t + h) - q(t)| < h |w|/2 + 2 u",
        bound = "|w|/2 h + 36 u, and |w|^2 is at most 2 T over the least moment: a jump of the sign would be 2",
        run = function(row)
          local h, jump, fastest = 2.0 ^ -7, 0.0, 0.0
          kit.each({ text = m.text }, function(b, real)
            local worst = 0.0
            for _, x0 in ipairs { state(unit, 1), { 1, 0, 0, 0, 1, 0.9, 0.1 }, { 1, 0, 0, 0, 0.1, 1, 0.9 },
              { 1, 0, 0, 0, 1e-3, 1.5, 1e-3 } } do
              b.plugin:init(p)
              b.plugin:solve(kit.rounded(real, x0))
              fastest = math.max(fastest, math.sqrt(2 * b.plugin:energy(x0) / p[1]))
              local last, shown
              for n = -3000, 3000 do
                local x = b.plugin:at(n * h)
                local y = x[1] < 0 and { -x[1], -x[2], -x[3], -x[4] } or x
                local sum, other = 0.0, 0.0
                for i = 1, 4 do
                  sum = sum + (last and (x[i] - last[i]) ^ 2 or 0)
                  other = other + (shown and (y[i] - shown[i]) ^ 2 or 0)
                end
                worst, jump = kit.worst(worst, math.sqrt(sum)), kit.worst(jump, math.sqrt(other))
                last, shown = x, y
              end
            end
            row("at", real, worst, h * fastest / 2 + m.BAR * b.u)
          end)
          row.naive(jump)
        end },
    } }
end
