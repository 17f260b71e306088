-- axes_near.lua -- hard cases: principal axes of moments that nearly agree, differ by many decades, or vanish.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local bodies = kit.use "bodies"

  -- any scene: NAME_principal_of takes every tensor
  local scene = bodies.scene("", "solid.box { x = 1, y = 2, z = 3, mass = 1 }")
  -- bits of the method: pairs of the type less their own roundings, long double (tests/emit/principal.t)
  local BITS = { double = 100, float = 42, library = 63 }
  local BOUND = "1, in units of what rounding once leaves: moments u of the largest, axes u + 16 (largest/gap) " ..
    "2^-100 " ..
    "(float 2^-42, library 2^-63), their products 2 u, I a - m a 2 u of the largest; the library's moments twice that"
  local ORACLE = "moments by bisection with exact counts of eigenvalues, axes from the adjugate, in rationals " ..
    "(tests/hard/spectrum.lua)"
  local NAIVE = "Smith's trigonometric formula (1961) and cross products of two rows"

  local function judge(row, tensors, graded)
    local spectrum = require "generator.hard.spectrum"
    for _, real in ipairs(kit.reals) do
      local list, commands, worst, library, naive = {}, {}, 0.0, 0.0, 0.0
      for i, I in ipairs(tensors(real)) do
        list[i] = kit.rounded(real, I)
        commands[i] = { "of", table.unpack(list[i]) }
      end
      local u = kit.u[real]
      for i, a in ipairs(bodies.ask(scene, real, commands)) do
        local e = a[1] == 0 and spectrum.judge(list[i], { a[2], a[3], a[4] }, { table.unpack(a, 5, 13) },
          { u = u, bits = BITS[real], graded = graded }) or math.huge
        worst = kit.worst(worst, e)
      end
      row("principal_of", real, worst, 1)
      if real == "double" then
        for i, a in ipairs(bodies.library(commands)) do
          library = kit.worst(library, a[1] == 0 and spectrum.judge(list[i], { a[2], a[3], a[4] },
            { table.unpack(a, 5, 13) }, { u = u, bits = BITS.library, slack = 2, graded = graded }) or math.huge)
          local m, v = spectrum.naive(list[i])
          naive = kit.worst(naive, spectrum.judge(list[i], m, v, { u = u, bits = BITS.double, graded = graded }))
        end
        row("library", "long double", library, 1)
        row.naive(naive)
      end
    end
  end

  local frame = { { 2 / 3, -1 / 3, 2 / 3 }, { 2 / 3, 2 / 3, -1 / 3 }, { -1 / 3, 2 / 3, 2 / 3 } }
  local askew = { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0 }, { 0.48, 0.64, 0.6 } }
  local place = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }
  local function turned(f, values)
    local I = {}
    for n, ij in ipairs(place) do
      I[n] = 0.0
      for k = 1, 3 do I[n] = I[n] + values[k] * f[k][ij[1]] * f[k][ij[2]] end
    end
    return I
  end

  return { title = "Principal axes", about = "Equal and nearly equal moments in oblique axes, graded tensors, rods, " ..
    "needles; " ..
      "what is judged is the tensor as it is rounded.",
    cases = {
      { name = "moments_nearly_equal_1e4_to_1e16", fast = true,
        why = "moments 1 and 1 + 10^-k for k = 4 .. 16 in oblique axes: an ulp of an entry turns the axes by 2^-53 " ..
          "10^k",
        naive = NAIVE, oracle = ORACLE, bound = BOUND,
        run = function(row)
          judge(row, function(real)
            local list = {}
            for k = 4, real == "double" and 16 or 7 do
              list[#list + 1] = turned(frame, { 1, 1 + 10.0 ^ -k, 2 })
              list[#list + 1] = turned(askew, { 1, 3, 3 + 3 * 10.0 ^ -k })
            end
            return list
          end)
        end },
      { name = "all_moments_nearly_equal", fast = true,
        why = "three moments within 10^-k of each other: the tensor is 1 and roundings",
        naive = NAIVE, oracle = ORACLE, bound = BOUND,
        run = function(row)
          judge(row, function(real)
            local list = {}
            for k = 4, real == "double" and 15 or 6 do
              list[#list + 1] = turned(frame, { 1, 1 + 10.0 ^ -k, 1 - 0.7 * 10.0 ^ -k })
            end
            return list
          end)
        end },
      { name = "moments_equal_exactly", fast = true,
        why = "a 1 + b k k^T in whole numbers: any axes across k will do, but they must be axes",
        naive = NAIVE, oracle = ORACLE .. ", of the single moment; the others by I a - m a and their products",
        bound = BOUND,
        run = function(row)
          judge(row, function()
            local list = {}
            for _, k in ipairs { { 1, 2, 3 }, { 1, -1, 1 }, { 3, 0, 4 }, { 5, -7, 2 } } do
              for _, ab in ipairs { { 100, 1 }, { 100, -1 }, { 3, 0 } } do
                local I = {}
                for n, ij in ipairs(place) do I[n] = (n < 4 and ab[1] or 0) + ab[2] * k[ij[1]] * k[ij[2]] + 0.0 end
                list[#list + 1] = I
              end
            end
            return list
          end)
        end },
      { name = "graded_1_1e8_1e16", fast = true,
        why = "moments 1 : 1e-8 : 1e-16 with products of inertia to match: each is determined to its own last place",
        naive = NAIVE, oracle = ORACLE,
        bound = "1, as for the others but each moment to u of ITSELF (Demmel, Veselic 1992: scaled to unit diagonal " ..
          "the " ..
          "tensor's condition is below 20)",
        run = function(row)
          judge(row, function(real)
            local list = {}
            local step = real == "double" and 1e-4 or 1e-2
            for _, b in ipairs { { 0.45, -0.3, 0.2 }, { -0.1, 0.4, 0.45 }, { 0.3, 0.3, 0.3 } } do
              for _, d in ipairs { { 1, step, step * step }, { step, 1, step * step }, { step * step, step, 1 } } do
                list[#list + 1] = { d[1] ^ 2, d[2] ^ 2, d[3] ^ 2, b[1] * d[1] * d[2], b[2] * d[1] * d[3], b[3] *
                  d[2] * d[3] }
              end
            end
            return list
          end, true)
        end },
      { name = "rod_oblique", fast = true,
        why = "k^2 1 - k k^T: the moment along the rod is 0 and the others agree; rounded, it is of either sign",
        naive = NAIVE, oracle = ORACLE, bound = BOUND,
        run = function(row)
          judge(row, function()
            local list = {}
            for _, k in ipairs { { 1, 2, 3 }, { 1, 1, 1 }, { 0.1, 0.7, -0.3 }, { 1e-3, 1, 1 }, { 1e-9, 1, 1e-4 } } do
              list[#list + 1] = { k[2] ^ 2 + k[3] ^ 2, k[1] ^ 2 + k[3] ^ 2, k[1] ^ 2 + k[2] ^ 2, -k[1] * k[2],
                -k[1] * k[3],
                -k[2] * k[3] }
            end
            return list
          end)
        end },
      { name = "needle_and_plate_in_oblique_axes", fast = true,
        why = "moments 1e-16, 1, 1 + 1e-8 and 1, 1, 2 in oblique axes: what is left of the small one is rounding",
        naive = NAIVE, oracle = ORACLE, bound = BOUND,
        run = function(row)
          judge(row, function(real)
            local gap = real == "double" and 1e-8 or 1e-4
            return { turned(frame, { 1e-16, 1, 1 + gap }), turned(askew, { 1e-16, 1, 1 }), turned(frame, { 1, 1, 2 }),
              turned(askew, { 1, 1 + gap, 2 + gap }), turned(frame, { 1e-12, 1, 1 + 1e-12 }) }
          end)
        end },
      { name = "axes_at_the_ends_of_the_range", fast = true,
        why = "tensors of 1e-30 and 1e30, next to the largest number and below the smallest normal one",
        naive = NAIVE .. ": squares and cubes over- and underflow", oracle = ORACLE,
        bound = BOUND .. "; below the normal numbers half their spacing",
        run = function(row)
          judge(row, function(real)
            local list, ends = {}, real == "double" and { -1060, -1020, -100, 100, 1020 } or { -140, -124, -40, 40,
              124 }
            for _, p in ipairs(ends) do
              local I = turned(frame, { 1, 2, 2.5 })
              for n = 1, 6 do I[n] = I[n] * 2.0 ^ p end
              list[#list + 1] = I
            end
            return list
          end)
        end },
      { name = "almost_diagonal", fast = true,
        why = "a product of 1e-9 to 1e-200 beside moments that differ by as little, or by 1: the axis' small " ..
          "component counts",
        naive = NAIVE, oracle = ORACLE, bound = BOUND,
        run = function(row)
          judge(row, function(real)
            local list = {}
            for _, e in ipairs(real == "double" and { 1e-9, 1e-17, 1e-100, 1e-200 } or { 1e-4, 1e-9, 1e-30 }) do
              list[#list + 1] = { 1, 2, 3, e, 0, 0 }
              list[#list + 1] = { 1, 1, 2, e, -e, 0 }
              list[#list + 1] = { 2, 1, 1 + 2 * kit.u[real], e, e / 3, e }
            end
            return list
          end)
        end },
    } }
end
