-- steppers_free.lua -- hard cases: the free top by each stepper.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m, naive = kit.tool "motion", kit.tool "naive"
  local unit = { 0.5, -0.5, 0.5, 0.5 }
  local function state(w) return { unit[1], unit[2], unit[3], unit[4], w[1], w[2], w[3] } end
  local p = { 1, 2, 2.5 }

  local MPFR = "MPFR, 1280 bits, textbook formulas (tests/oracle/free_top.c)"
  local PLAIN = "q += h q (0, w)/2 without a norm, rates by Runge and Kutta's method, 2^-7 rad a step; state at the end"
  local LAW = "truncation h^p by each method's law (tests/hard/motion.lua: Lotkin's bound, majorants, Cayley's map) " ..
    "plus " ..
    "three standard deviations of n independent steps of 16 roundings, 3 sqrt(n) u (16 + 2 w t)"

  local function plainly(row, moments, x0, pace, radians, want, h)
    h = h or 2.0 ^ -7 / pace
    local n = math.floor(radians / (pace * h))
    row.naive(m.state(naive.march(moments, x0, h, n), want or m.truth(moments, x0, { n * h })[1]))
  end

  local function case(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = PLAIN, oracle = o.oracle or MPFR,
      bound = o.law or o.growth and LAW .. ", times exp(t/tau)" or LAW, only = o.only, because = o.because,
      run = function(row)
        for _, s in ipairs(o) do
          local function of(v) return type(v) == "function" and v or function() return v end end
          local moments, w = of(s[1]), of(s[2])
          local function pace(real) return math.max(m.size(w(real)), 1e-300) * (o.faster or 1.5) end
          m.step(row, { p = moments, x0 = function(real) return state(w(real)) end, pace = pace,
            radians = o.radians or 20,
            growth = o.growth, condition = o.condition, laws = o.laws, steppers = o.steppers })
          if s == o[1] then
            plainly(row, moments "double", state(w "double"), pace "double", o.radians or 20)
          end
        end
      end }
  end
  local function by(double, float) return function(real) return real == "float" and float or double end end
  local function times(k, list)
    return function(real) return { list[1] * k(real), list[2] * k(real), list[3] * k(real) } end
  end
  local some = { 1, 1, 0.5 }

  -- Every component stays what it is: `parts` from and to.
  local function stays(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = PLAIN .. " (and |q| with it)",
      oracle = "nothing may change", bound = o.bound,
      run = function(row)
        for i, w in ipairs(o) do
          m.each(row, { p = p, x0 = state(w) }, function(b, real, _, x0, method)
            local x, worst = b.plugin:march(0, x0, nil, 0.0625, 1000, method), 0.0
            for k = o.from, 7 do worst = kit.worst(worst, math.abs(x[k] - x0[k])) end
            row(#o > 1 and method .. ", " .. i or method, real, worst, b.u)
          end)
        end
        plainly(row, p, state(o[1]), 1, 62.5, state(o[1]), 0.0625)
      end }
  end

  return { title = "Steppers, free", about = "The free top by rk4, adaptive, taylor, split2, 4, 6, midpoint, semi.",
    cases = {
      case("steppers_on_separatrix", { { { 3, 4, 6 }, { 0.5, 1, 0.25 } }, fast = true, laws = true, faster = 1.2,
        -- |L|/B w = 1.13 in the end; sqrt((B - A)(C - B)/(A C)) = 1/3 of it is 1/tau
        growth = function(t) return math.exp(0.38 * math.abs(t)) end,
        why = "no stepper can stay on it: what a step loses grows with exp(t/tau); energy and |L| must not" }),
      case("steppers_rod", { { { 1e-8, 1, 1 - 5e-9 }, { 0.5, 1, 0.25 } },
        { by({ 1e-300, 1, 1 }, { 1e-36, 1, 1 }), { 0.5, 1, 0.25 } },
        steppers = { "rk4", "adaptive", "taylor", "split2", "split4", "split6" },
        why = "a needle: 1/A is 1e8 and 1e300 (float: 1e36), times a difference of moments that is small, or none. " ..
          "midpoint and semi have the next case" }),
      case("steppers_rod_by_momentum", { { { 0.01, 1, 1 - 0.005 }, { 0.5, 1, 0.25 } }, fast = true, condition = 108,
        steppers = { "midpoint", "semi" },
        why = "midpoint and semi keep L, and take the rates from it: about an axis of a small moment a rounding of " ..
          "L is " ..
          "|L|/(A |w|) times as large. At A = 1e-8 float has no digit left, double 8: docs/methods.md",
        law = LAW .. ", times |L|/(A |w|) = 108" }),
      case("steppers_equal_moments", { { { 2, 2, 2 }, { 0.3, 0.4, 1.2 } },
        { function(real) return { 2, 2, 2 * (1 + 2 * kit.u[real]) } end, { 0.3, 0.4, 1.2 } },
        why = "a sphere in the code of an asymmetric body, and one unit of the last place from it: differences are " ..
          "0 or noise" }),
      case("steppers_lamina", { { { 1, 2, 3 }, some }, why = "A + B = C, the ratios (C - B)/A = (C - A)/B = 1 are " ..
        "as large as " ..
        "they can be" }),
      case("steppers_1e6_rad_s", { { p, { 1e6, 1e6, 0.5e6 } }, why = "a million rad/s, steps of " ..
        "nanoseconds (taylor's w^order is " ..
          "no float: double only)" }),
      case("steppers_scales_of_rates", { { p, times(by(1e30, 1e12), some) }, { p, times(by(1e-30, 1e-12), some) },
        why = "rates 1e30 and 1e-30 (float: 1e12 and 1e-12), steps accordingly: w^2 h^2 is fine, w^4 is not; " ..
          "taylor, whose " ..
          "coefficients have w^order, is no row where that is no number" }),
      case("steppers_scales_of_moments", { { times(by(1e30, 1e12), p), some }, { times(by(1e-30, 1e-12), p), some },
        why = "moments 1e30 and 1e-30 (float: 1e12 and 1e-12): T and L^2 of them, their products and quotients" }),

      stays("steppers_zero_spin", { { 0, 0, 0 }, { -0.0, 0, -0.0 }, fast = true, from = 1,
        why = "no spin: nothing to divide by |w|, and q = (1, -1, 1, 1)/2 is a unit to the last bit",
        bound = "u: no difference at all is allowed, so a unit is too much" }),
      stays("steppers_spin_along_an_axis", { { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, -1 }, fast = true, from = 5,
        why = "about the middle axis exactly: the rates across are 0 and have nothing to grow from",
        bound = "u: the rates may not change at all" }),

      { name = "steppers_back_and_forth", fast = true,
        why = "as many steps of -h as of h: a reversible method must undo itself, the others come back to their " ..
          "truncation",
        naive = PLAIN .. ", there and back",
        oracle = "the state at the start", bound = "twice the truncation, none for split and midpoint (symmetric " ..
          "methods " ..
          "undo each step), and 3 sqrt(2 n) u (16 + 2 w t)",
        run = function(row)
          local x0 = state(some)
          m.each(row, { p = p, x0 = x0 }, function(b, real, _, start, name)
            local h, n, cut = m.plan(name, real, 1.5, 20)
            local x = b.plugin:march(0, start, nil, h, n, name)
            x = b.plugin:march(h * n, x, nil, -h, n, name)
            row(name, real, m.state(x, start), 2 * (m.keeps[name] and 0 or cut) + m.walk(2 * n, 20, b.u))
          end)
          local x = naive.march(p, x0, 2.0 ^ -7, 1706)
          row.naive(m.state(naive.march(p, x, -2.0 ^ -7, 1706), x0))
        end },

      { name = "steppers_tiny_step", fast = true,
        why = "h = 1e-12 s: an increment of 1e-12 keeps 4 digits in double, and none in float, where the state " ..
          "stands still",
        naive = string.gsub(PLAIN, "2^%-7 rad", "1e-12 s") .. ", in doubles",
        oracle = MPFR,
        bound = "n u 16, n = 1e5: each step rounds x + h x' once, the same way again and again, so errors add up in " ..
          "full; " ..
          "in float this is more than all that happens",
        run = function(row)
          local x0, n, h = state(some), 100000, 1e-12
          m.each(row, { p = p, x0 = x0 }, function(b, real, pr, start, name)
            local step = kit.round(real, h)
            local x = b.plugin:march(0, start, nil, step, n, name)
            row(name, real, m.state(x, m.truth(pr, start, { step * n })[1]), 16 * n * b.u)
          end)
          plainly(row, p, x0, 1, n * h, nil, h)
        end },

      { name = "steppers_huge_step", fast = true,
        why = "steps of one revolution, of 100, and of 1e10 s: beyond every stepper's range",
        naive = string.gsub(PLAIN, "2^%-7 rad", "one revolution") .. "; |q| - 1 and the energy's change",
        oracle = "conservation: |q| = 1 and |L| of split, midpoint and semi, T of split",
        bound = "split, midpoint, semi: 3 sqrt(n) u 16 after 1000 steps of any length; rk4, adaptive, taylor: " ..
          "polynomials of h, " ..
          "so that one revolution stays finite (0), and farther steps are not promised",
        run = function(row)
          local x0 = state(some)
          for _, h in ipairs { 2 * math.pi, 628, 1e10 } do
            m.each(row, { p = p, x0 = x0 }, function(b, real, _, start, name)
              local bounded = m.keeps[name] or name == "semi"
              if not bounded and h > 7 then return end
              local n = bounded and 1000 or 1
              local x = b.plugin:march(0, start, nil, kit.round(real, h), n, name)
              local all, momentum = m.drift(b, start, x)
              local e = kit.finite(x) and 0 or math.huge
              if bounded then e = kit.worst(e, kit.norm(x), string.find(name, "split") and all or momentum) end
              row(string.format("%s, h = %.3g", name, h), real, e, m.walk(n, 0, b.u))
            end)
          end
          local x = naive.march(p, x0, 2 * math.pi, 20)
          row.naive(kit.norm(x))
        end },

      { name = "steppers_tolerances", fast = true,
        why = "steps that a tolerance chooses, from 1e-2 to below rounding: the first step knows nothing of the motion",
        naive = PLAIN, oracle = MPFR,
        bound = "the tolerance and 16 u for each step taken, turned by w t: (tol + 16 u) steps (1 + w t); asked for " ..
          "less " ..
          "than u the run may refuse (then 0)",
        run = function(row)
          local x0, t = state(some), 20.0
          m.each(row, { p = p, x0 = x0, steppers = { "adaptive", "taylor" } }, function(b, real, pr, start, name)
            local want = m.truth(pr, start, { t })[1]
            for _, tolerance in ipairs { 1e-2, 1e-5, 1e-9, 1e-14, 1e-30 } do
              local rows, steps = b.plugin:integrate(start, nil, { kit.round(real, tolerance) }, { t }, 0, name)
              local e = rows and m.state({ table.unpack(rows[1], 2) }, want) or tolerance < b.u and 0 or math.huge
              row(string.format("%s, %g", name, tolerance), real, e,
                (math.max(tolerance, 0) + 16 * b.u) * (rows and steps or 1) * (1 + 1.5 * t))
            end
          end)
          plainly(row, p, x0, 1, t)
        end },

      { name = "steps_1e8",
        why = "the quaternion's length and sign over 10^8 steps: what a step leaves of |q| must not add up, q(t) " ..
          "not jump",
        naive = "q += h q (0, w)/2 without a norm, 10^6 steps: | |q| - 1 |",
        oracle = "|q| = 1; the state by " .. MPFR .. ", in double, with the sign of q",
        bound = "|q|: 4 u, a Newton step and the roundings of one product; the state as other steppers' rows; in " ..
          "float " ..
          "10^4 u w t is more than a turn, so |q| only",
        run = function(row)
          local x0, n, h = state(some), 100000000, 2.0 ^ -10
          m.each(row, { p = p, x0 = x0, steppers = { "rk4", "semi" } }, function(b, real, pr, start, name)
            local x = b.plugin:march(0, start, nil, h, n, name)
            row(name .. ", |q|", real, kit.norm(x), 4 * b.u)
            if real == "double" and name == "rk4" then
              local want, minus, plus = m.truth(pr, start, { n * h })[1], 0.0, 0.0
              for i = 1, 4 do minus, plus = minus + (x[i] - want[i]) ^ 2, plus + (x[i] + want[i]) ^ 2 end
              local cut = 2 * (1.5 * h) ^ 4 * 1.5 * n * h
              row(name .. ", state", real, minus < plus and m.state(x, want) or math.huge, cut + m.walk(n,
                1.5 * n * h, b.u))
            end
          end)
          row.naive(kit.norm(naive.march(p, x0, h, 1000000)))
        end },
    } }
end
