-- heavy.lua -- what the hard cases of the heavy symmetric top share.
--
--     local m = kit.tool "heavy"
--     m.run(row, list, o)      list of {q, w, mgl, times, A, C}: closed form and library against MPFR's Taylor series,
--                              and the naive road; o.bar(p, x0, t, u), o.library_bar, o.options of the oracle,
-- o.library = false
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local motion, naive = kit.tool "motion", kit.tool "naive"
  local m = { BAR = motion.BAR }

  -- The arm is so short that m l^2 never spoils A: the weight is g.
  local ARM = 2.0 ^ -100

  m.text = [[
local A, C = param("A", 1, "kg m^2"), param("C", 0.5, "kg m^2")
local g, l = param("g", 10, "m/s^2"), param("l", 0.1, "m")
return scene { name = "heavy",
  body = tensor { mass = 1, com = {0, 0, l}, about = "origin", xx = A, yy = A, zz = C, xy = 0, xz = 0, yz = 0 },
  origin = {0, 0, 0}, effects = { effect.gravity { g = g } } }
]]

  function m.parameters(mgl, A, C) return { A or 1, C or 0.5, math.abs(mgl) / ARM, mgl < 0 and -ARM or ARM } end
  function m.weight(p) return p[3] * p[4] end

  function m.truth(p, x0, times, options)
    return kit.heavy_top({ p[1], p[1], p[2] }, { 0, 0, m.weight(p) }, x0, times, options or "-b 192")
  end

  -- The largest of |w| at t = 0 and sqrt(m g l/A): a pendulum at its turn has no rate, but a pace.
  function m.pace(p, x0)
    return math.max(motion.size(x0, 5, 7), math.sqrt(math.abs(m.weight(p)) / p[1]))
  end

  function m.run(row, list, o)
    o = o or {}
    local worst = 0.0
    for i, s in ipairs(list) do
      local function of(k, real) return type(s[k]) == "function" and s[k](real) or s[k] end
      local function p(real) return m.parameters(of(3, real), of(5, real), of(6, real)) end
      local function x0(real)
        local q, w = of(1, real), of(2, real)
        return { q[1], q[2], q[3], q[4], w[1], w[2], w[3] }
      end
      local function truth(pr, x, times) return m.truth(pr, x, times, o.options) end
      motion.closed(row, { text = m.text, p = p, x0 = x0, times = function(real) return of(4, real) end, truth = truth,
        pace = m.pace, bar = o.bar, library_bar = o.library_bar, library = o.library,
        who = #list > 1 and string.format("%d", i) or nil })
      -- Euler's angles, steps of 1/256 of the pace
      local pr, x = p "double", x0 "double"
      local times = of(4, "double")
      local t = times[#times]
      local n = math.sqrt(x[1] ^ 2 + x[2] ^ 2 + x[3] ^ 2 + x[4] ^ 2)
      local y = { x[1] / n, x[2] / n, x[3] / n, x[4] / n, x[5], x[6], x[7] }
      local got = naive.euler({ pr[1], pr[1], pr[2] }, m.weight(pr), y, t, 2.0 ^ -8 / m.pace(pr, x))
      worst = kit.worst(worst, motion.state(got, truth(pr, x, { t })[1], m.pace(pr, x)))
    end
    row.naive(worst)
  end

  return m
end
