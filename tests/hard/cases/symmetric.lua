-- symmetric.lua -- hard cases: the free symmetric top near the sphere, the disc and the rod, and near its own axis.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m = kit.tool "motion"
  local text = [[
local A, C = param("A", 2, "kg m^2"), param("C", 1, "kg m^2")
return scene { name = "free", body = tensor { mass = 1, xx = A, yy = A, zz = C },
  initial = { omega = {0.1, 0.2, 1} } }
]]
  local unit = { 0.5, -0.5, 0.1, 0.7 }
  local function state(w) return { unit[1], unit[2], unit[3], unit[4], w[1], w[2], w[3] } end
  local function truth(p, x0, times) return kit.free_top({ p[1], p[1], p[2], 0, 0, 0 }, x0, times) end

  -- by Taylor series (tests/oracle/heavy_top.c without weight): knows the rod, and loses nothing to a small tilt
  local function series(p, x0, times) return kit.heavy_top({ p[1], p[1], p[2] }, { 0, 0, 0 }, x0, times) end

  -- The state, and the rates across the axis over their own size, a unit of the smallest number apart.
  local function apart(x, want, pace, real)
    local size, most = m.size(want, 5, 6), 0.0
    for i = 5, 6 do most = kit.worst(most, math.abs(x[i] - want[i]) - kit.tiny[real]) end
    return kit.worst(m.state(x, want, pace), size > 0 and most / size or most)
  end

  local MPFR = "MPFR, 1280 bits, of the general free top (tests/oracle/free_top.c)"
  local BAR = "36 u: two phases reduced in pairs, rounded once, two sines and cosines, a dozen operations"

  -- The textbook: nutation angle by acos, precession and spin in Euler's angles about L (Goldstein, 5.6).
  local function textbook(p, x0, t)
    local A, C = p[1], p[2]
    local L = { A * x0[5], A * x0[6], C * x0[7] }
    local G = math.sqrt(L[1] ^ 2 + L[2] ^ 2 + L[3] ^ 2)
    local tilt, spin = math.acos(L[3] / G), (1 - C / A) * x0[7]
    local psi = math.atan(L[1], L[2]) + spin * t
    return { G / A * math.sin(tilt) * math.sin(psi), G / A * math.sin(tilt) * math.cos(psi), G / C * math.cos(tilt) }
  end
  local NAIVE = "tilt = acos(L3/|L|), rates from |L| and the tilt, w3 = |L| cos(tilt)/C (Goldstein, 5.6): rates at " ..
    "the last time"

  -- cases of {p, w, times}, p and w functions of the type or lists
  local function case(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = o.naive or NAIVE, oracle = o.truth and "Taylor series " ..
      "of MPFR, 256 bits (tests/oracle/heavy_top.c)" or MPFR,
      bound = o.bar and BAR .. "; 2^-100 of a turn for each turn, in float 2^-42" or BAR, only = o.only,
        because = o.because,
      run = function(row)
        local worst = 0.0
        for i, s in ipairs(o) do
          local function p(real) return type(s[1]) == "function" and s[1](real) or s[1] end
          local function x0(real) return state(type(s[2]) == "function" and s[2](real) or s[2]) end
          m.closed(row, { text = text, truth = o.truth or truth, measure = o.measure, p = p, x0 = x0, times = s[3],
            bar = o.bar and m.long(o.bar),
            who = #o > 1 and string.format("%d", i) or nil, library = o.library })
          local times = type(s[3]) == "function" and s[3] "double" or s[3]
          local t = times[#times]
          local got, want = textbook(p "double", x0 "double", t), (o.truth or truth)(p "double", x0 "double", { t })[1]
          local size, most = m.size(want, 5, 7), 0.0
          for k = 1, 3 do most = kit.worst(most, math.abs(got[k] - want[4 + k])) end
          worst = kit.worst(worst, size > 0 and most / size or most)
        end
        row.naive(worst)
      end }
  end
  local times = { 0, 1, 10, -100 }

  return { title = "Symmetric top", about = "Regular precession at the ends of what it can be.",
    cases = {
      case("symmetric_nearly_sphere", { fast = true, bar = 1.3,
        why = "C/A = 1 + 1e-4, 1e-8, one unit of the last place: precession and spin are almost opposite, their sum " ..
          "counts",
        { { 1, 1 + 1e-4 }, { 0.3, 0.4, 1 }, { 1, 1e6 } }, { { 1, 1 - 1e-8 }, { 0.3, 0.4, 1 }, { 1, 1e6 } },
        { function(real) return { 1, 1 - kit.u[real] } end, { 0.3, 0.4, 1 }, { 1, 1e6 } } }),
      case("symmetric_disc", { fast = true, why = "C = 2 A, the triangle's limit, and C rounded from twice a decimal",
        { { 0.1, 0.2 }, { 0.3, 0.4, 1 }, times }, { { 0.7, 1.4 }, { 0.3, 0.4, -1 }, times } }),
      case("symmetric_rod", { fast = true, truth = series, why = "C = 0 exactly, and 1e-300: the rate along the " ..
        "line has neither energy nor " ..
          "momentum, and is kept; w3 = L3/C is 0/0",
        { { 1, 0 }, { 0.3, 0.4, 1 }, times }, { { 1, 0 }, { 0, 0, 1 }, times },
        { function(real) return { 1, real == "float" and 1e-36 or 1e-300 } end, { 0.3, 0.4, 1 }, times } }),
      case("symmetric_tilt_0", { fast = true, why = "spin about the axis exactly: the precession's axis and the " ..
        "spin's are " ..
          "one, their angles are not told apart", { { 2, 1 }, { 0, 0, 1 }, times }, { { 1, 1.5 }, { 0, -0.0, 3 },
            times } }),
      case("symmetric_tilt_pi", { fast = true, why = "spin the other way about the axis: the tilt is pi",
        { { 2, 1 }, { 0, 0, -1 }, times }, { { 1, 1.5 }, { -0.0, 0, -3 }, times },
        { { 2, 1 }, { 1e-12, 0, -1 }, times } }),
      case("symmetric_tilt_1e300", { fast = true, truth = series, measure = apart, why = "a tilt of 1e-300 and of " ..
        "the smallest number: its direction turns all " ..
          "the same, its square is 0 (the rates across are judged over their own size)",
        { { 2, 1 }, function(real) return { real == "float" and 1e-38 or 1e-300, 0, 1 } end, times },
        { { 2, 1 }, function(real) return { 0, kit.tiny[real], 1 } end, times },
        { { 2, 1 }, function(real) return { 0, kit.tiny[real], -1e6 } end, { 1e-6, 2e-5 } } }),
      case("symmetric_spin_ratio", { fast = true, bar = 1e8, why = "the spin is 1e8 times the precession, and the " ..
        "precession " ..
          "1e8 times the spin (a needle): two phases of so different a speed",
        { { 1, 2 }, { 0, 1e-8, 1 }, { 1, 1e3 } }, { { 1, 1e-8 }, { 1e-8, 0, 1e8 }, { 1e-7, 1 } },
        { { 1, 1.5 }, { 1, 0, 1e8 }, { 1e-8, 1e-2 } } }),
      case("symmetric_time_1e9", { bar = 1.3, fast = true, why = "10^9 s: 2e8 turns of precession and of spin",
        { { 2, 1 }, { 0.3, 0.4, 1 }, { 1e9, -1e9 } } }),
      case("symmetric_equatorial", { fast = true, why = "no spin about the axis, with a zero of either sign: the " ..
        "rates stay",
        { { 2, 1 }, { 0.3, 0.4, 0 }, times }, { { 2, 1 }, { 0.3, 0.4, -0.0 }, times } }),
      case("symmetric_at_rest", { fast = true, why = "no rate at all: L/|L| is 0/0",
        { { 2, 1 }, { 0, 0, 0 }, times }, { { 1, 0 }, { -0.0, 0, 0 }, times } }),
      case("symmetric_scales", { why = "rates and moments 1e30 and 1e-30 (float: 1e12 and 1e-12)",
        { function(real) local k = real == "float" and 1e12 or 1e30 return { k, k / 2 } end,
          function(real) local k = real == "float" and 1e12 or 1e30 return { k, k / 3, k } end,
          function(real) local k = real == "float" and 1e-12 or 1e-30 return { k, -10 * k } end },
        { function(real) local k = real == "float" and 1e-12 or 1e-30 return { k, k / 2 } end,
          function(real) local k = real == "float" and 1e-12 or 1e-30 return { k, k / 3, k } end,
          function(real) local k = real == "float" and 1e12 or 1e30 return { k, -10 * k } end } }),
    } }
end
