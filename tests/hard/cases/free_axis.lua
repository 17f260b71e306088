-- free_axis.lua -- hard cases: the free top that spins next to an axis, or exactly about it, or not at all.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m, naive = kit.tool "motion", kit.tool "naive"
  local p = { 1, 2, 2.5 }

  local MPFR = "MPFR, 1280 bits, textbook formulas (tests/oracle/free_top.c)"
  local BAR = "36 u: two phases reduced in pairs, rounded once, and some dozen operations. The growth of 1e-300 " ..
    "next to the " ..
    "middle axis is in the closed form, the inputs are exact: no condition number"

  -- A state with w = 1 about the axis, e about the others.
  local function state(axis, e)
    local x = { 0.5, -0.5, 0.1, 0.7, e, e, e }
    x[4 + axis] = 1
    return x
  end

  -- What textbook's rates make of the middle axis after t.
  local function textbook(x0, t, want) return naive.rates_error(p, x0, t, want) end

  -- Next to a stable axis MPFR's formulas lose 2 log2(1/e) bits; below 1e-150 the motion is the constant rotation about
  -- the axis to more digits than anybody looks at, and MPFR gets that.
  local function truth(axis)
    return function(_, x0, times)
      local x = { table.unpack(x0) }
      for i = 5, 7 do
        if i ~= 4 + axis and axis ~= 2 and math.abs(x[i]) < 1e-150 then x[i] = 0.0 end
      end
      return m.truth(p, x, times)
    end
  end

  local function within(name, e, fast)
    return { name = name, fast = fast,
      why = string.format("the rates across are %s of the spin: about the middle axis they grow to 1 in %d s; about " ..
        "the " ..
        "others they must stay", e and string.format("%g", e) or "subnormal",
          e and math.floor(2.59 * math.log(1 / e)) or
        1925),
      naive = "the textbook's formulas, whose k^2 is 1 +- 1e-16 as soon as e^2 is below 1e-16; rates after the flip",
      oracle = MPFR .. "; about the outer axes below 1e-150 a constant rotation, from which it is e t away",
        bound = BAR,
      run = function(row)
        for axis = 1, 3 do
          local function x0(real) return state(axis, e and math.max(e, kit.tiny[real]) or kit.tiny[real]) end
          local function times(real)
            if axis ~= 2 then return { 1, 10, -100 } end
            local once = -2.5820 * math.log(x0(real)[5]) -- time constants sqrt(A C/((B - A)(C - B)))/w, and 1 more
            return { 1, once, once + 5, 2 * once + 7, -once - 3 }
          end
          local who = ({ "least", "middle", "largest" })[axis]
          m.free(row, { p = p, x0 = x0, times = times, who = who, truth = truth(axis) })
          if axis == 2 then
            local x, t = x0 "double", times "double"[3]
            row.naive(textbook(x, t, m.truth(p, x, { t })[1]))
          end
        end
      end }
  end

  -- Exactly about an axis: the rates stay to the last bit.
  local function still(name, why, states, fast)
    return { name = name, fast = fast, why = why,
      naive = "the axis of rotation by dividing L by |L| and the amplitudes by the textbook: 0/0 or the root of a " ..
        "rounding below 0; error of the rates after 10 s",
      oracle = "uniform rotation: rates constant, |q| = 1, q = q0 exp(w t/2) by MPFR",
      bound = "36 u; the rates exactly (else the error is infinite)",
      run = function(row)
        local worst = 0.0
        for _, w in ipairs(states) do
          local x0 = { 0.5, -0.5, 0.1, 0.7, w[1], w[2], w[3] }
          m.free(row, { p = p, x0 = x0, times = { 1, 10, -1000 }, who = string.format("%g, %g, %g", w[1], w[2], w[3]),
            bar = m.long(1) })
          kit.each({ text = m.text }, function(b, real)
            local x = b.plugin:init(p) == 0 and b.plugin:solve(x0) == 0 and b.plugin:at(777.7)
            local same = x and x[5] == w[1] and x[6] == w[2] and x[7] == w[3]
            row("rates of " .. string.format("%g, %g, %g", w[1], w[2], w[3]), real, same and 0 or math.huge, b.u)
          end)
          worst = kit.worst(worst, naive.rates_error(p, x0, 10, x0))
        end
        row.naive(worst)
      end }
  end

  return { title = "Next to an axis", about = "The free asymmetric top with almost all of its spin about one axis.",
    cases = {
      within("spin_within_1e8", 1e-8, true),
      within("spin_within_1e16", 1e-16, false),
      within("spin_within_1e150", 1e-150, false),
      within("spin_within_1e300", 1e-300, true),
      within("spin_within_subnormal", nil, true),
      still("spin_exactly_about_an_axis", "about the middle axis nothing may start: there is no rate to grow",
        { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, -1, 0 } }, true),
      still("zero_spin", "no rate at all, with zeros of either sign: nothing to divide by", { { 0, 0, 0 }, { -0.0,
        0, -0.0 } },
        true),
      { name = "rate_of_negative_zero", fast = true,
        why = "a zero's sign decides a branch or a quadrant (atan2): the motion must be that of +0",
        naive = "atan2(w2, w1) with w1 = -0: an amplitude of pi instead of 0 at w2 = 0; error of the rates after 10 s",
        oracle = MPFR, bound = BAR,
        run = function(row)
          local worst = 0.0
          for i, w in ipairs { { -0.0, 1, 0.5 }, { 0.5, -0.0, 0.5 }, { 0.25, 1, -0.0 }, { -0.0, -0.0, 0.5 } } do
            local x0 = { 0.5, -0.5, 0.1, 0.7, w[1], w[2], w[3] }
            m.free(row, { p = p, x0 = x0, times = { 1, 10, -100 }, who = "zero " .. i })
            worst = kit.worst(worst, naive.rates_error(p, x0, 10, m.truth(p, x0, { 10 })[1]))
          end
          row.naive(worst)
        end },
    } }
end
