-- separatrix.lua -- hard cases: the free asymmetric top on the separatrix and on both its sides.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- (B - A) A w1^2 = (C - B) C w3^2 holds in whole numbers for moments 3, 4, 6: w1 = 2 w3.

return function(kit)
  local m, naive = kit.tool "motion", kit.tool "naive"
  local p = { 3, 4, 6 }
  local function state(w1, w2, w3) return { 0.5, -0.5, 0.1, 0.7, w1, w2, w3 } end
  local on = state(0.5, 1, 0.25)

  local MPFR = "MPFR, 1280 bits, textbook formulas (tests/oracle/free_top.c)"
  local MODULUS = "k^2, the amplitudes and Jacobi's functions of the textbook (Landau and Lifshitz, Mechanics, 37) " ..
    "from T " ..
    "and L^2: the differences 2TC - L^2, L^2 - 2TB cancel; error of the rates at the last time"
  local BAR = "36 u: two phases, each reduced in pairs and rounded once, their sines and cosines, some dozen " ..
    "operations on " ..
    "numbers below 2, twice for the angle. Nothing grows: the distance from the separatrix is formed exactly"

  -- Both sides: w1 times 1 - e and 1 + e; e of the type (nil: one unit of the last place).
  local function near(name, e, fast)
    return { name = name, fast = fast,
      why = e and string.format("L passes the middle axis within %g of the motion without a period", e) or
        "w1 is one unit of the last place off the motion without a period: L lingers near the middle axis, then flips",
      naive = MODULUS, oracle = MPFR, bound = BAR,
      run = function(row)
        for _, side in ipairs { -1, 1 } do
          local function x0(real) return state(0.5 * (1 + side * (e or 2 * kit.u[real])), 1, 0.25) end
          m.free(row, { p = p, x0 = x0, times = { 0, 1, 10, 100, -37 }, who = side < 0 and "below" or "above" })
          if side > 0 then row.naive(naive.rates_error(p, x0 "double", 100, m.truth(p, x0 "double", { 100 })[1])) end
        end
      end }
  end

  return { title = "Separatrix", about = "The free asymmetric top next to the motion without a period.",
    cases = {
      { name = "separatrix_on_it", fast = true,
        why = "A w1^2 (B - A) = C w3^2 (C - B) exactly: the period is infinite, the modulus is 1",
        naive = MODULUS, oracle = MPFR, bound = BAR,
        run = function(row)
          row.naive(naive.rates_error(p, on, 30, m.truth(p, on, { 30 })[1]))
          m.free(row, { p = p, x0 = on, times = { 0, 1, 10, 30, -30 } })
        end },

      { name = "separatrix_on_it_1e9_s",
        why = "10^8 time constants on it: sech underflows, the body turns about its middle axis for ever, and " ..
          "nothing " ..
          "may push it off",
        naive = MODULUS, oracle = MPFR,
        bound = BAR .. "; and what the header promises of phases after N turns, 2^-100 N turns, in float 2^-42 N",
        run = function(row)
          row.naive(naive.rates_error(p, on, 1e9, m.truth(p, on, { 1e9 })[1]))
          m.free(row, { p = p, x0 = on, times = { 1e4, 1e9, -1e9 }, bar = m and m.long(1.2) })
        end },

      near("separatrix_sides_1e4", 1e-4, false),
      near("separatrix_sides_1e8", 1e-8, true),
      near("separatrix_sides_one_ulp", nil, true),

      { name = "separatrix_period", fast = true,
        why = "the period grows with the logarithm of the distance: which sign of the last bit is on which side " ..
          "decides",
        naive = "4 K/lambda with K by its power series, 1000 terms, of the textbook's k^2",
        oracle = "MPFR (free_top -p)",
        bound = "8 u relative: K/lambda is formed in pairs and rounded once; of the rotation number (the quotient) " ..
          "the " ..
          "precession's rate has one more; on the separatrix it is infinite exactly",
        run = function(row)
          for _, real in ipairs(kit.reals) do
            local worst = 0.0
            for _, k in ipairs { -4, -1, 1, 4, 1000 } do
              local x0 = state(0.5 * (1 + k * 2 * kit.u[real]), 1, 0.25)
              local got = m.ask { real = real, p = p, x0 = x0 }
              local period, precession = m.periods(p, x0)
              worst = kit.worst(worst, math.abs(got[1] / period - 1), math.abs(got[2] / precession - 1),
                math.abs(got[3] / (period * precession / (2 * math.pi)) - 1))
              if k == 1 and real == "double" then
                local c = naive.constants(p, { x0[5], 1, 0.25 })
                row.naive(kit.worst(math.abs(4 * naive.quarter(c.k2) / c.lambda / period - 1)))
              end
            end
            local never = m.ask { real = real, p = p, x0 = on }
            if never[1] ~= math.huge or never[3] ~= math.huge then worst = math.huge end
            row("polhode_period", real, worst, 8 * kit.u[real])
          end
        end },

      { name = "separatrix_next_flip", fast = true,
        why = "the flip about to happen, one unit of the last place from the motion that never flips again",
        naive = "t + a quarter of the textbook's period, from w2 = 0 (a half later it flips)",
        oracle = "the rates by MPFR at that time: w2 changes its sign there, so w2/w2' is how far the time is off",
        bound = "36 u for the phase, over |w2'| there; 2 u t for the rounding of t and of the sum",
        run = function(row)
          for _, real in ipairs(kit.reals) do
            local worst, at, bound = -1.0, 0.0, 1.0
            for k = -1, 1 do
              local x0 = state(0.5 * (1 + k * 2 * kit.u[real]), -1, 0.25)
              local t = 0.0
              for n = 1, k == 0 and 1 or 3 do
                t = m.ask { real = real, p = p, x0 = x0, t = t }[4]
                local x = m.truth(p, x0, { t })[1]
                local slope = (p[3] - p[1]) / p[2] * x[7] * x[5]
                local e = kit.number(math.abs(x[6] / slope))
                local bar = (m.BAR / math.abs(slope) + 2 * t) * kit.u[real]
                if e / bar > worst then worst, at, bound = e / bar, e, bar end
                if k == 1 and n == 1 and real == "double" then
                  local c = naive.constants(p, { x0[5], -1, 0.25 })
                  row.naive(kit.worst(math.abs(naive.quarter(c.k2) / c.lambda - t)))
                end
              end
            end
            row("next_flip", real, at, bound)
          end
        end },
    } }
end
