-- free_moments.lua -- hard cases: the free top whose moments are nearly equal, nearly none, or at the triangle's limit.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m, naive = kit.tool "motion", kit.tool "naive"
  local x0 = { 0.5, -0.5, 0.1, 0.7, 0.5, 1, 0.25 }

  local MPFR = "MPFR, 1280 bits, textbook formulas (tests/oracle/free_top.c)"
  local TEXTBOOK = "rates by the textbook's amplitudes and Jacobi's functions from T and L^2 (Landau and Lifshitz, " ..
    "Mechanics, 37), whose differences cancel; error at the last time"
  local BAR = "36 u: two phases reduced in pairs, rounded once, and some dozen operations; the differences of " ..
    "moments are " ..
    "formed before any product"
  local LONG = BAR .. "; and 2^-100 of a turn for each turn, in float 2^-42"

  local function equal(name, e, fast)
    -- the drift of the polhode is visible after 1/e; a float's phases end after 10^6 turns
    local function times(real) return { 1, -100, math.min(10 / (e or kit.u[real]),
      real == "float" and 1e5 or 1e13) } end
    return { name = name, fast = fast,
      why = string.format("the polhode goes round in 1/(B - A): with moments %s apart after that many turns of the " ..
        "body",
        e and string.format("%g", e) or "one unit of the last place"),
      naive = TEXTBOOK, oracle = MPFR, bound = LONG,
      run = function(row)
        local function d(real) return e or 2 * kit.u[real] end
        local sets = { { "A = B", function(real) return { 3, 3 * (1 + d(real)), 4 } end },
          { "B = C", function(real) return { 3, 4, 4 * (1 + d(real)) } end },
          { "A = B = C", function(real) return { 3, 3 * (1 + d(real)), 3 * (1 + 3 * d(real)) } end } }
        for i, set in ipairs(sets) do
          m.free(row, { p = set[2], x0 = x0, times = times, who = set[1], bar = m.long(1.2) })
          if i == 1 then
            local p, t = set[2] "double", times "double"
            row.naive(naive.rates_error(p, x0, t[3], m.truth(p, x0, { t[3] })[1]))
          end
        end
      end }
  end

  -- p of the real type; times 1, 10, -100
  local function plain(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = TEXTBOOK, oracle = MPFR, bound = BAR,
      only = o.only, because = o.because,
      run = function(row)
        local p = o.p "double"
        row.naive(naive.rates_error(p, x0, 10, m.truth(p, x0, { 10 })[1]))
        m.free(row, { p = o.p, x0 = x0, times = { 1, 10, -100 }, library = o.library })
      end }
  end

  return { title = "Moments", about = "The free asymmetric top near the sphere, the symmetric top, the rod, the " ..
    "lamina.",
    cases = {
      equal("moments_equal_1e4", 1e-4, true),
      equal("moments_equal_1e8", 1e-8, false),
      equal("moments_equal_1e12", 1e-12, false),
      equal("moments_equal_one_ulp", nil, true),
      plain("rod_1e8", { fast = true, p = function() return { 1e-8, 1, 1 - 5e-9 } end,
        why = "a needle: A = 1e-8 with B - C of its size, so that w1' = (B - C) w2 w3/A is of order 1" }),
      plain("rod_smallest", { fast = true, p = function(real)
          return real == "float" and { 1e-36, 1, 1 } or { 1e-300, 1, 1 }
        end,
        why = "A = 1e-300 (float: 1e-36): A^2 is 0 in the type, and I^-1 does not come back" }),
      plain("rod_subnormal", { p = function(real) return { kit.tiny[real], 1, 1 } end, fast = true,
        why = "A is the smallest number that there is: no scaling by its reciprocal, which is infinite" }),
      plain("lamina", { p = function() return { 1, 2, 3 } end, why = "A + B = C exactly: the end of what a body can " ..
        "have" }),
      plain("lamina_rounded", { fast = true, p = function() return { 0.1, 0.2, 0.1 + 0.2 } end,
        why = "A + B = C in rounded numbers: C is larger than A + B in exact ones, and must not be refused" }),
      plain("moments_1e30", { p = function(real)
          local s = real == "float" and 1e12 or 1e30
          return { s, 2 * s, 2.5 * s }
        end, why = "moments 1e30 kg m^2 (float: 1e12): squares of L and products of three moments overflow" }),
      plain("moments_1e_30", { p = function(real)
          local s = real == "float" and 1e-12 or 1e-30
          return { s, 2 * s, 2.5 * s }
        end, why = "moments 1e-30 kg m^2 (float: 1e-12): products of four moments underflow" }),
      plain("moments_subnormal", { fast = true, p = function(real)
          local s = real == "float" and 1e-40 or 1e-310
          return { s, 2 * s, 2.5 * s }
        end, why = "every moment is subnormal: L has fewer digits than w, T and L^2 are 0" }),

      { name = "rod_of_no_moment", fast = true,
        why = "A = 0 in a tensor of parameters: w1' is (B - C)/A; it must be refused, or be the rod's motion",
        naive = "the same division in doubles, from C - B = 0: 0/0; 1 if it is no number",
        oracle = "a status that is not 0 (error 0), else the rod's motion by MPFR",
        bound = "36 u",
        run = function(row)
          local p = { 0.0, 1.0, 1.0 }
          local rate = (p[2] - p[3]) / p[1]
          row.naive(rate ~= rate and 1 or 0)
          kit.each({ text = m.text }, function(b, real)
            local e = 0.0
            if b.plugin:init(p) == 0 and b.plugin:solve(x0) == 0 then
              e = m.state(b.plugin:at(3), m.truth(p, x0, { 3 })[1])
            end
            row("init", real, e, m.BAR * b.u)
          end)
        end },
    } }
end
