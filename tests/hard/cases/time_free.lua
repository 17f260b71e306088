-- time_free.lua -- hard cases: the free top after long times, before 0, and counted in ticks.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m, naive = kit.tool "motion", kit.tool "naive"
  local p, x0 = { 1, 2, 2.5 }, { 0.5, -0.5, 0.1, 0.7, 1, 1, 0.5 }
  -- the quaternion of x0 is of length 1; L and the energy make it turn at less than 1.5 rad/s
  local RATE = 1.5

  local MPFR = "MPFR, 1280 bits, textbook formulas (tests/oracle/free_top.c), at the time that the type holds"
  local BAR = "36 u for the state at a phase; its rates are pairs, good to 2^-100 of a turn for each turn, in float " ..
    "to " ..
    "2^-42 (the emitted header)"
  local PHASE = "cos and sin of lambda t in doubles from the textbook: lambda t has u lambda t of error; rates"

  local function long(name, times, o)
    return { name = name, fast = o.fast, why = o.why, naive = PHASE, oracle = MPFR, bound = BAR, only = o.only,
      because = o.because,
      run = function(row)
        local t = times[1]
        row.naive(naive.rates_error(p, x0, t, m.truth(p, x0, { t })[1]))
        m.free(row, { p = p, x0 = x0, times = times, bar = m.long(RATE), reals = o.only and { o.only } })
      end }
  end

  -- The state after n ticks of h against MPFR at n h, where that is a double; else at what turns are left, exactly.
  local function ticks(row, list, bar)
    for _, real in ipairs(kit.reals) do
      local worst, at, bound = -1.0, 0.0, 1.0
      for _, job in ipairs(list) do
        local h, n = kit.round(real, job[1]), job[2]
        assert(n == 0 or (h * n) / n == h and math.tointeger(h * n / h) == n, "n h is a double")
        local _, x = m.ask { real = real, p = p, x0 = x0, h = h, n = n }
        local e = x and m.state(x, m.truth(p, x0, { h * n })[1]) or math.huge
        local b = bar(h * n, kit.u[real]) * kit.u[real]
        if e / b > worst then worst, at, bound = e / b, e, b end
      end
      row("at_tick", real, at, bound)
    end
  end

  return { title = "Time", about = "The free asymmetric top after long times.",
    cases = {
      long("time_1e9_s", { 1e9, 1e9 + 1 }, { why = "1.4e8 turns: a phase in one double is off by 1e-7 " ..
        "rad" }),
      long("time_1e6_turns", { 4.2e6, -4.2e6, 4194304.5 }, {
        why = "a million turns: a phase in one float has no digit left, a pair of floats has 2^-28 of a turn" }),
      long("time_1e15_s", { 1e15, -0.9e15 }, { only = "double",
        why = "2e14 turns: the spacing of doubles there is 0.125 s, the phase must be right to 1e-16 all the same",
        because = "a pair of floats has 46 bits, which 2^47 turns use up: the header says that nobody knows the " ..
          "phase then" }),
      long("time_negative", { -1, -10, -1e6 }, { why = "whole turns are taken off towards which side?" }),

      { name = "ticks_2_62",
        why = "n = 2^62 ticks of a step: n h is beyond what any phase in floating point can reduce, and half of " ..
          "what n holds",
        naive = "t = n h in doubles and the textbook's rates there; h = 2^-32 s",
        oracle = MPFR .. "; n h = 2^30 s is a double, although n h in float loses all digits of a phase",
        bound = BAR .. ". The tick's phases are integers of 128 bits, of rates known no better",
        run = function(row)
          local t = 2.0 ^ 30
          row.naive(naive.rates_error(p, x0, t, m.truth(p, x0, { t })[1]))
          ticks(row, { { 2.0 ^ -32, 1 << 62 }, { 2.0 ^ -32, -(1 << 62) } },
            function(span, u) return m.long(RATE)(nil, nil, span, u) end)
        end },

      { name = "ticks_are_times",
        why = "steps that are no power of two, over 10^6 steps of both signs: t += h in float would be 1e-3 off",
        naive = "t += h in single precision, 10^6 times: |t - n h| |w|, rad",
        oracle = MPFR .. " at n h, exactly a double",
        bound = "36 u: the phase of a step is rounded to 2^-128 of a turn",
        run = function(row)
          local h, t = kit.round("float", 0.001), 0.0
          for _ = 1, 1000000 do t = kit.round("float", t + h) end
          row.naive(math.abs(t - 1000000 * h) * RATE)
          ticks(row, { { h, 1000000 }, { h, -999999 }, { 0.0625, 12345 }, { 0.0625, 0 } },
            function(span, u) return m.long(RATE)(nil, nil, span, u) end)
        end },

      { name = "rotation_number",
        why = "turns about L while w goes round once: nearly symmetric bodies have millions, next to the axis it is " ..
          "a limit",
        naive = "L/I3 t + Legendre's integral by its first term: G/I of the mean moment times the textbook's period",
        oracle = "MPFR (free_top -p): period times mean rate over 2 pi",
        bound = "4 u relative: the rate and the period are right to the last place, then a product",
        run = function(row)
          local sets = { { p, x0 }, { { 1, 2, 2 + 1e-6 }, x0 }, { { 1, 1 + 1e-5, 2 }, x0 },
            { p, { 1, 0, 0, 0, 1e-7, 1e-7, 1 } }, { p, { 1, 0, 0, 0, 1, 1e-7, 1e-7 } } }
          local worst = 0.0
          for _, real in ipairs(kit.reals) do
            local most = 0.0
            for _, set in ipairs(sets) do
              local q, x = kit.rounded(real, set[1]), kit.rounded(real, set[2])
              local got = m.ask { real = real, p = q, x0 = x }
              local period, rate = m.periods(q, x)
              local true_number = period * rate / (2 * math.pi)
              most = kit.worst(most, math.abs(got[3] / true_number - 1), math.abs(got[1] / period - 1))
              if real == "double" then
                local c = naive.constants(q, { x[5], x[6], x[7] })
                local G = math.sqrt((q[1] * x[5]) ^ 2 + (q[2] * x[6]) ^ 2 + (q[3] * x[7]) ^ 2)
                local guess = G / q[2] * 4 * naive.quarter(c.k2) / c.lambda / (2 * math.pi)
                worst = kit.worst(worst, math.abs(guess / true_number - 1))
              end
            end
            row("rotation_number", real, most, 4 * kit.u[real])
          end
          row.naive(worst)
        end },
    } }
end
