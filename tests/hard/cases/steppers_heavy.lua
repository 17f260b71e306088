-- steppers_heavy.lua -- hard cases: the heavy symmetric top by each stepper.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local m, heavy, naive = kit.tool "motion", kit.tool "heavy", kit.tool "naive"

  local SERIES = "Taylor series of MPFR, 192 bits, which knows of no symmetry (tests/oracle/heavy_top.c)"
  local EULER = "Runge and Kutta's steps, 1/256 of the pace, in Euler's angles, with 1/sin(tilt); state at the end"

  local function euler(row, p, x0, t, want)
    local pace = heavy.pace(p, x0)
    row.naive(m.state(naive.euler({ p[1], p[1], p[2] }, heavy.weight(p), x0, t, 2.0 ^ -8 / pace), want, pace))
  end

  -- Steps of a = h pace, pace the sum of |w| and 2 sqrt(m g l/A), which bounds the derivatives; truncation factor
  -- a^order a
  -- radian.
  local law = { rk4 = { 4, 2.0 ^ -9, 2.0 ^ -5 }, adaptive = { 5, 2.0 ^ -8, 2.0 ^ -4 }, taylor = { 20, 0.25, 0.0625,
    10 },
    split2 = { 2, 2.0 ^ -10, 2.0 ^ -7 }, split4 = { 4, 2.0 ^ -9, 2.0 ^ -5 }, split6 = { 6, 2.0 ^ -5, 2.0 ^ -3 },
    midpoint = { 2, 2.0 ^ -10, 2.0 ^ -7 }, semi = { 1, 2.0 ^ -12, 2.0 ^ -9 } }

  local function follow(name, o)
    return { name = name, fast = o.fast, why = o.why, naive = EULER, oracle = SERIES,
      bound = "2 a^p for each radian, a = h (|w| + 2 sqrt(m g l/A)) and p the order: derivatives of the state and " ..
        "of the " ..
        "torque are below its powers; plus 3 sqrt(n) u (16 + 2 radians), n independent steps of 16 roundings" ..
        (o.growth and "; times exp(t/tau)" or ""),
      run = function(row)
        m.each(row, { text = heavy.text, p = heavy.parameters(o.mgl), x0 = o.x0 }, function(b, real, p, x0, name_)
          local l = law[name_]
          local pace = m.size(x0, 5, 7) + 2 * math.sqrt(o.mgl)
          local h = 2.0 ^ math.floor(math.log(l[real == "float" and 3 or 2] / pace, 2))
          local n = math.floor(o.t / h)
          local x = b.plugin:march(0, x0, nil, h, n, name_)
          local radians = pace * o.t
          row(name_, real, m.state(x, heavy.truth(p, x0, { n * h })[1], heavy.pace(p, x0)), (o.growth or 1) *
            (2 * (pace * h) ^ (real == "float" and l[4] or l[1]) * radians + m.walk(n, radians, b.u)))
        end)
        local p = heavy.parameters(o.mgl)
        euler(row, p, o.x0, o.t, heavy.truth(p, o.x0, { o.t })[1])
      end }
  end

  return { title = "Steppers, heavy", about = "The heavy top by rk4, adaptive, taylor, split2, 4, 6, midpoint, semi.",
    cases = {
      { name = "steppers_sleeping",
        why = "exactly upright with half the critical spin, a position that nothing but a rounding can leave",
        naive = EULER, oracle = "the axis stays upright: qx = qy = 0, w1 = w2 = 0",
        bound = "u: no difference at all is allowed, so a unit is too much",
        run = function(row)
          local x0 = { 1, 0, 0, 0, 0, 0, 2 }
          m.each(row, { text = heavy.text, p = heavy.parameters(2), x0 = x0 }, function(b, real, _, start, name)
            local x = b.plugin:march(0, start, nil, 0.0625, 2000, name)
            row(name, real, kit.worst(math.abs(x[2]), math.abs(x[3]), math.abs(x[5]), math.abs(x[6])), b.u)
          end)
          euler(row, heavy.parameters(2), x0, 10, x0)
        end },
      { name = "steppers_hanging_vertical_spin",
        why = "upright, faster than critical, w3 and |q| over 2000 steps of 1.25 rad: what turns with the axis must " ..
          "keep w3",
        naive = EULER, oracle = "w3 = 20 is an integral, |q| = 1",
        bound = "rk4, adaptive, taylor: w3 exactly, its torque is 0; split, midpoint, semi: 3 sqrt(n) u 16; |q| " ..
          "4 u, after a step of rk4 and adaptive their truncation, (h w/2)^6; of the splittings, which correct " ..
          "what they " ..
          "are given, the roundings of their 4 to 22 rotations, at random: 1.5 u each",
        run = function(row)
          local x0 = { 1, 0, 0, 0, 0, 0, 20 }
          m.each(row, { text = heavy.text, p = heavy.parameters(2), x0 = x0 }, function(b, real, _, start, name)
            local n = 2000
            local x = b.plugin:march(0, start, nil, 0.0625, n, name)
            row(name .. ", w3", real, kit.number(math.abs(x[7] / 20 - 1)), m.walk(n, 0, b.u))
            local cut = ({ rk4 = 0.625 ^ 6, adaptive = 0.625 ^ 6 })[name] or 0
            local turns = 2 * (({ split2 = 2, split4 = 6, split6 = 11 })[name] or 0) -- two rotations a drift
            row(name .. ", |q|", real, kit.norm(x), cut + (4 + 1.5 * math.sqrt(turns)) * b.u)
          end)
          euler(row, heavy.parameters(2), x0, 10, x0)
        end },
      follow("steppers_cusps", { mgl = 2, x0 = { 0.8, 0.6, 0, 0, 0, 0, 8 }, t = 4,
        why = "at a cusp the axis stands still: what divides by its speed, or chooses steps by it, stumbles" }),
      follow("steppers_through_the_vertical", { mgl = 2, x0 = { 1, 0, 0, 0, 1, 0, 3 }, t = 4,
        why = "the axis goes through the upright, where Euler's angles have no value" }),
      follow("steppers_pendulum_separatrix", { mgl = 1, x0 = { 0, 1, 0, 0, 2, 0, 0 }, t = 8, growth = math.exp(8),
        why = "a pendulum that just reaches the upright: truncation grows with exp(t/tau), exp(8) here" }),
    } }
end
