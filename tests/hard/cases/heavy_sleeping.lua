-- heavy_sleeping.lua -- hard cases: the heavy symmetric top upright, at and around the critical spin, and hanging.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Moments 1, 1, 1/2.  The upright spin is stable where (C w3)^2 >= 4 A m g l: for m g l = 1 from w3 = 4 on.

return function(kit)
  local m = kit.tool "heavy"
  local up = { 1, 0, 0, 0 }

  local SERIES = "Taylor series of MPFR, 192 bits, which knows of no symmetry (tests/oracle/heavy_top.c)"
  local EULER = "Runge and Kutta's steps, 1/256 of the pace, in Euler's angles: 1/sin(tilt) is infinite at the " ..
    "vertical, " ..
    "and acos knows a tilt of 1e-8 to no digit; state at the last time"
  local BAR = "36 u of the pace, the larger of |w| and sqrt(m g l/A): three phases reduced in pairs, rounded once, " ..
    "four " ..
    "terms of theta series, a dozen operations; 1 - cos(tilt) comes from the state without a difference"

  local function case(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = EULER, oracle = SERIES,
      bound = o.law and BAR .. ". " .. o.law or BAR, only = o.only, because = o.because,
      run = function(row) m.run(row, o, o) end }
  end

  -- w3 times 1 -+ e (nil: a unit of the last place), tilted by about 2e-4, the axis at rest and carried along.
  local function critical(name, e, fast)
    local function w3(side) return function(real) return { 0, 1e-4, 4 * (1 + side * (e or 2 * kit.u[real])) } end end
    return case(name, { fast = fast, { { 1, 1e-4, 0, 0 }, w3(-1), 1, { 20, 60 } }, { { 1, 1e-4, 0, 0 }, w3(1), 1,
      { 20, 60 } },
      why = string.format("%s below and above the critical spin: three roots of the cubic within 1e-8 of 1, and " ..
        "whether " ..
        "the top wakes up is decided by their last digits", e and string.format("%g", e) or "one unit of the last " ..
          "place") })
  end

  -- Upright but for e, spin half of the critical: the tilt grows with exp(t/tau), 1/tau^2 = m g l/A - (C w3/2 A)^2.
  local function wakes(name, e, times, fast)
    return case(name, { fast = fast,
      why = string.format("the axis leaves the upright from a tilt of %g: 1 - cos(tilt) is 0 in the type, the top " ..
        "must " ..
        "wake up all the same, and in time", e),
      { { 1, 0, 0, 1 }, { e, 0, 2 }, 2, times }, { { 1, e, 0, 0 }, { 0, 0, 2 }, 2, times }, library = false,
      law = "(The library integrates, and loses exp(t/tau) u: no row)" })
  end

  return { title = "Sleeping top", about = "Upright, at the critical spin and around it; leaving the upright; hanging.",
    cases = {
      case("sleeping_at_critical_spin", { fast = true,
        why = "exactly upright at exactly the critical spin: all three roots of the cubic are 1, the top stays",
        { up, { 0, 0, 4 }, 1, { 1, 20, -100 } }, { up, { 0, 0, -4 }, 1, { 1, 20 } } }),
      case("sleeping_below_critical_spin", { fast = true,
        why = "exactly upright, and unstable: nothing but a rounding could wake it, and none may",
        { up, { 0, 0, 2 }, 2, { 1, 20, 100 } }, { up, { 0, 0, 0 }, 2, { 1, 100 } } }),
      case("sleeping_above_critical_spin", { fast = true, why = "exactly upright and stable; and 1e-9 beside it",
        { up, { 0, 0, 20 }, 2, { 1, 5 } }, { { 1, 1e-9, 0, 0 }, { 0, 1e-9, 20 }, 2, { 1, 5 } } }),
      critical("critical_spin_1e4", 1e-4, true),
      critical("critical_spin_1e8", 1e-8, false),
      critical("critical_spin_one_ulp", nil, true),
      wakes("wakes_from_1e8", 1e-8, { 1, 10, 20 }, true),
      wakes("wakes_from_1e30", 1e-30, { 10, 50, 70 }, false),
      { name = "wakes_from_1e200", only = "double", because = "1e-200 is 0 in float: it sleeps " ..
        "(sleeping_below_critical_spin)",
        why = "a tilt of 1e-200, whose square is 0 in any type: it falls after 347 time constants",
        naive = EULER, oracle = SERIES .. "; 320 steps of the first time it falls lose 2^500, so 700 bits", bound = BAR,
        run = function(row)
          m.run(row, { { up, { 1e-200, 0, 2 }, 2, { 300, 360 } } },
            { options = "-b 700", library = false, reals = { "double" } })
        end },
      case("hanging", { fast = true, why = "the axis exactly down, at rest and spinning; 1e-7 and 1e-120 (float: " ..
        "1e-30) beside",
        { { 0, 1, 0, 0 }, { 0, 0, 5 }, 2, { 1, 20 } }, { { 0, 1, 0, 0 }, { 0, 0, 0 }, 2, { 1, 20 } },
        { { 1e-7, 1, 0, 0 }, { 0, 1e-7, 5 }, 2, { 1, 20 } },
        { function(real) return { real == "float" and 1e-30 or 1e-120, 1, 0, 0 } end, { 0, 0, 5 }, 2, { 1, 20 } } }),
    } }
end
