-- separatrix.lua -- hard cases: the free asymmetric top on the separatrix, on both its sides, and about an axis.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local scene = [[
local A, B, C = param("A", 1, "kg m^2"), param("B", 2, "kg m^2"), param("C", 3, "kg m^2")
return scene { name = "free", body = tensor { mass = 1, xx = A, yy = B, zz = C },
  initial = { omega = {0.1, 1, 0.1} } }
]]
  -- docs/errormap.md: at most 10 u in rates and 14 u in attitude over the sweep; 3 u for the rounding of the result
  local BOUND = { double = 17 * kit.u.double, float = 17 * kit.u.float }

  -- The worst over times of the closed form from x0 (as the type holds it) with moments p, and of the library.
  local function closed(row, p, x0, times, bound)
    kit.each({ text = scene }, function(b, real)
      local pr, x, ts = kit.rounded(real, p), kit.rounded(real, x0), kit.rounded(real, times)
      local want = kit.free_top({ pr[1], pr[2], pr[3], 0, 0, 0 }, x, ts)
      local worst = 0.0
      if b.plugin:init(pr) ~= 0 or b.plugin:solve(x) ~= 0 then worst = math.huge
      else
        for i, t in ipairs(ts) do worst = kit.worst(worst, kit.state(b.plugin:at(t), want[i])) end
      end
      row("at", real, worst, (bound or BOUND)[real])
      if real == "double" then
        local values = { A = pr[1], B = pr[2], C = pr[3] }
        local rows = kit.library(b.job, x, ts, values)
        worst = 0.0
        for i in ipairs(ts) do worst = kit.worst(worst, kit.state(rows[i], want[i])) end
        row("library", "long double", worst, (bound or BOUND).double)
      end
    end)
  end

  -- The textbook's modulus, k^2 = (B - A)(2 T C - L^2) / ((C - B)(L^2 - 2 T A)), as it stands (Landau and Lifshitz,
  -- Mechanics, 37): how far K(k) is off, relatively; 1 where k >= 1 gives no period at all.
  local function naive_modulus(p, w)
    local A, B, C = p[1], p[2], p[3]
    local T2 = A * w[1] ^ 2 + B * w[2] ^ 2 + C * w[3] ^ 2
    local L2 = (A * w[1]) ^ 2 + (B * w[2]) ^ 2 + (C * w[3]) ^ 2
    return (B - A) * (T2 * C - L2) / ((C - B) * (L2 - T2 * A))
  end

  return { title = "Separatrix", about = "The free asymmetric top next to the motion without a period.",
    cases = {
      { name = "separatrix_on_it", fast = true,
        why = "A w1^2 (B - A) C = C w3^2 (C - B) A exactly: the period is infinite, the modulus is 1",
        naive = "k^2 of the textbook from T and L^2: rounding makes it 1 +- 1e-16, so K(k) is finite or no number",
        oracle = "MPFR, 1280 bits, textbook formulas (tests/oracle/free_top.c)",
        bound = "17 u: 14 u of docs/errormap.md and the rounding of seven results",
        run = function(row)
          -- (B - A) A w1^2 = (C - B) C w3^2 holds in whole numbers for 3, 4, 6: 3 w1^2 = 12 w3^2
          local p, x0 = { 3, 4, 6 }, { 1, 0, 0, 0, 0.5, 1, 0.25 }
          row.naive(math.abs(naive_modulus({ 3, 4, 6 }, { 0.1, 1, 0.05 }) - 1) > 0 and 1 or 0)
          closed(row, p, x0, { 0, 1, 10, 30 })
        end },
    } }
end
