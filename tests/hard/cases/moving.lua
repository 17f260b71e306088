-- moving.lua -- hard cases: bodies that burn away, fall for ever, or are seen from a fast frame; units of any size.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local R = kit.R
  local cases = {}
  local function case(c) cases[#cases + 1] = c end

  local function exact(fn, x) return R.todouble(R.apply(fn, 160, R.is(x) and x or R.fromdouble(x))) end

  case { name = "mass_that_burns_to_nothing", fast = true,
    why = "the moment about the axis falls to 2^-20 of itself (float: 2^-8): the rate grows by as much, and ever " ..
      "faster",
    naive = "I w' = N with the present I, which forgets that what leaves takes its spin along: w stays",
    oracle = "L = I(t) w is constant: w = w0/(1 - t/T)",
    bound = "relative to w. adaptive: 30 tolerances (about 25 natural steps as I halves, 20 halvings, each error is " ..
      "carried on as it is); the clock is a state, a sum of n steps: 2 + sqrt(n) times u I0/I of w. rk4 in 2^14 " ..
      "steps of h = t/2^14 leaves out the last halving: to I = 2^-8, (h/(T - t))^4 = 2^-24 a step's 1/6 over 6 " ..
      "steps a halving",
    run = function(row)
      row.naive(math.abs(1 - 2.0 ^ 20) / 2.0 ^ 20)
      local text = [[
return scene { name = "stick", body = tensor { mass = 1, xx = 1, yy = 1, zz = 1 },
  effects = { effect.inertia_rate { zz = -1*t, xx = -t/2, yy = -t/2 } }, initial = { omega = { 0, 0, 1 } },
  time = { step = 0.001 } }]]
      kit.each({ text = text, methods = { "rk4", "adaptive" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0, deep = kit.initial(b), real == "double" and 2.0 ^ 20 or 2.0 ^ 8
        local tolerance = real == "double" and 1e-12 or 1e-6
        local a, n = b.plugin:integrate(x0, nil, { tolerance }, { 1 - 1 / deep }, 0, "adaptive")
        row("adaptive", real, a and math.abs(a[1][8] - deep) / deep or math.huge,
          30 * tolerance + (2 + math.sqrt(n or 1)) * deep * b.u)
        local t = 1 - 2.0 ^ -8
        local x = b.plugin:march(0, x0, nil, t / 16384, 16384, "rk4")
        row("rk4", real, math.abs(x[7] - 256) / 256, 2.0 ^ -24 + 2 * 256 * b.u + 16384 * b.u)
        if real == "double" then
          row("library", "long double", math.abs(kit.library(b.job, x0, { 1 - 1 / deep })[1][7] - deep) / deep,
            2 * deep * b.u)
        end
      end)
    end }

  case { name = "falling_at_the_last_speed", fast = true,
    why = "a stone under quadratic drag for 2000 times the time in which it reaches its last speed",
    naive = "height -(v^2/g) log(cosh(g t/v)): cosh overflows",
    oracle = "v tanh(g t/v), and -(v^2/g) (g t/v + log1p(exp(-2 g t/v)) - log 2), in MPFR where it matters",
    bound = "at the last speed errors of v die out. adaptive: 100 tolerances; the height adds them up over t: " ..
      "relative to it as much; rk4 h g/v = 0.1: (0.1)^4/120 at the start, relative to a height of 2000 v^2/g " ..
      "nothing: 1e-6; roundings of n sums: n u/2",
    run = function(row)
      row.naive(kit.number(math.abs(math.log((math.exp(2000) + math.exp(-2000)) / 2) - 2000)))
      local text = [[
return scene { name = "stone", body = tensor { mass = 1, xx = 1, yy = 1, zz = 1 },
  effects = { effect.translation { gravity = 1, drag = 1 } }, time = { step = 0.1 } }]]
      kit.each({ text = text, methods = { "rk4", "adaptive" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0, names = kit.initial(b), {}
        for i, s in ipairs(b.job.states) do names[s.name] = i end
        local tolerance = real == "double" and 1e-12 or 1e-5
        local function error_at(x, t)
          local height = -(t + (t < 40 and exact("log", 1 + math.exp(-2 * t)) or 0) - exact("log", 2.0))
          return kit.worst(math.abs(x[names.rz] - height) / math.abs(height),
            math.abs(x[names.vz] + exact("tanh", t)))
        end
        local n = 20000
        local a = b.plugin:integrate(x0, nil, { tolerance }, { 3, 2000 }, 0, "adaptive")
        local function reached(i, t) return error_at({ table.unpack(a[i], 2) }, t) end
        row("adaptive", real, a and kit.worst(reached(1, 3), reached(2, 2000)) or math.huge, 100 * tolerance)
        row("rk4", real, error_at(b.plugin:march(0, x0, nil, 0.1, n, "rk4"), 2000), 1e-6 + n * b.u / 2)
      end)
    end }

  case { name = "seen_from_a_fast_frame",
    why = "a free particle seen from a frame that turns at 1000 rad/s: Coriolis and centrifugal terms of 1e6 that " ..
      "must cancel to a straight line",
    naive = "Euler's steps of h = 1e-6: the circle's radius grows by (1 + (h W)^2)^(n/2)",
    oracle = "the straight line in space, turned back by the exact angle",
    bound = "relative to the distance. An error of the speed, W = 1000 of it, is carried along for W T/2 = 500 " ..
      "radians. rk4, h W = 0.001 (float 0.01): (h W)^4/120 a radian, W T of them, times 500: 4e-9 (float 4e-5); " ..
      "roundings u W of the speed in n steps: sqrt(n/3) u W, times 4, and the rounded step's 2 u W. adaptive: " ..
      "tolerance times 1000 rad times 10; library 1e-12",
    run = function(row)
      row.naive((1 + 1e-6) ^ (1e6 / 2) - 1)
      local text = [[
return scene { name = "wheeling", body = tensor { mass = 1, xx = 1, yy = 1, zz = 1 },
  effects = { effect.translation { gravity = 0 }, effect.rotating_frame { rate = { 0, 0, 1000 } } },
  time = { step = 1e-6 } }]]
      kit.each({ text = text, methods = { "rk4", "adaptive" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local names = {}
        for i, s in ipairs(b.job.states) do names[s.name] = i end
        local x0 = kit.initial(b)
        -- at rest in space at (1, 0, 0): in the frame it moves backwards at 1000 m/s
        x0[names.rx], x0[names.vy] = 1, -1000
        local function off(x)
          return math.sqrt((x[names.rx] - exact("cos", 1000.0)) ^ 2 + (x[names.ry] + exact("sin", 1000.0)) ^ 2)
        end
        local n = real == "double" and 1000000 or 100000
        local x = b.plugin:march(0, x0, nil, 1 / n, n, "rk4")
        row("rk4", real, off(x), (1000 / n) ^ 4 / 120 * 1000 * 500 + 4 * math.sqrt(n / 3) * b.u * 1000 + 2000 * b.u)
        local tolerance = real == "double" and 1e-12 or 1e-6
        local a = b.plugin:integrate(x0, nil, { tolerance }, { 1 }, 0, "adaptive")
        row("adaptive", real, a and off { table.unpack(a[1], 2) } or math.huge, 1e4 * tolerance)
        if real == "double" then
          row("library", "long double", off(kit.library(b.job, x0, { 1 })[1]), 1e-12)
        end
      end)
    end }

  -- e = (3, 4, 12)/13 along the needle; a and b stand across it.
  case { name = "needle_with_a_part_that_moves", fast = true,
    why = "the moment about the needle is 2^-30 (float: 2^-10) of the others, the axes are turned, the tensor " ..
      "changes: it must be inverted in every stage; and moments of 2^400 and 2^-400 kg m^2 (float 2^45, 2^-45)",
    naive = "adjugate over determinant: the acceleration across the needle loses what the moment about it has lost; " ..
      "the cube of a moment leaves the range",
    oracle = "the torque K (2 a + 3 b) stands across the needle: w' = 2 a + 3 b",
    bound = "Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., theorem 10.4: an exact solution for a " ..
      "tensor that is off by 3 gamma_10 = 30 u, its entries by 12 u: of a w' of 3.6 151 u across the needle (64 u " ..
      "are left for the torque), and along it that over the smallest moment",
    run = function(row)
      local e, a, b = { 3 / 13, 4 / 13, 12 / 13 }, { 0.8, -0.6, 0 }, { 36 / 65, 48 / 65, -25 / 65 }
      local function dot(x, y) return x[1] * y[1] + x[2] * y[2] + x[3] * y[3] end
      local function off(x) return math.max(math.abs(dot(a, x) - 2), math.abs(dot(b, x) - 3)) end
      local n, d = {}, 2.0 ^ -30
      for i = 1, 3 do n[i] = 2 * a[i] + 3 * b[i] end
      local function S(i, j) return (i == j and 1 or 0) - (1 - d) * e[i] * e[j] end
      local function C(i, j)
        local i1, i2, j1, j2 = i % 3 + 1, (i + 1) % 3 + 1, j % 3 + 1, (j + 1) % 3 + 1
        return S(i1, j1) * S(i2, j2) - S(i1, j2) * S(i2, j1)
      end
      local det, x = S(1, 1) * C(1, 1) + S(1, 2) * C(1, 2) + S(1, 3) * C(1, 3), {}
      for i = 1, 3 do x[i] = (C(i, 1) * n[1] + C(i, 2) * n[2] + C(i, 3) * n[3]) / det end
      row.naive(off(x))
      local text = [[
local K, d = param("K", 1, "kg m^2"), param("d", 0.5)
local k = K*(1 - d)/169
return scene { name = "needle", body = tensor { mass = 1, xx = K - 9*k, yy = K - 16*k, zz = K - 144*k, xy = -12*k,
    xz = -36*k, yz = -48*k },
  effects = { effect.inertia_rate { zz = K*quantity(1, "1/s")*t }, effect.control {} }, time = { step = 0.01 } }]]
      kit.each({ text = text, methods = { "rk4" } }, function(built, real)
        local thin = real == "double" and 2.0 ^ -30 or 2.0 ^ -10
        local large = real == "double" and 2.0 ^ 400 or 2.0 ^ 45
        for _, K in ipairs { 1.0, large, 1 / large } do
          assert(built.plugin:init { K, thin } == 0)
          local u = kit.rounded(real, { K * n[1], K * n[2], K * n[3] })
          local dx = built.plugin:rhs(0, { 1, 0, 0, 0, 0, 0, 0, 0 }, u)
          local got = { dx[5], dx[6], dx[7] }
          local what = string.format(", K = 2^%d", math.log(K, 2) // 1)
          row("across" .. what, real, kit.number(off(got)), (151 + 64) * built.u)
          row("along" .. what, real, kit.number(math.abs(dot(e, got))), (151 + 64) * built.u / thin)
        end
      end)
    end }

  -- Units whose factors are powers of two: every number of the motion scales exactly, so every bit stays.
  case { name = "units_of_any_size", fast = true,
    why = "the same top in other units: masses of 2^100 = 1e30 kg, lengths of 1e-10 m (float: 1e12 and 1e-6), times " ..
      "of 2^-30 s (float 2^-4: a series' coefficients grow like w^20): any threshold that is an absolute number shows",
    naive = "a derivative of w^2 by differences with an absolute step of 1e-6: of a rate of 1e-30 it sees nothing",
    oracle = "the motion in the first units, whose numbers are these ones' times powers of two, bit by bit",
    bound = "none: the smallest number there is, so every bit; the series' choice of steps works on rounded " ..
      "logarithms and is held to its tolerance",
    run = function(row)
      local w, d = 1e-30, 1e-6
      row.naive(math.abs(((w + d) ^ 2 - (w - d) ^ 2) / (2 * d) - 2 * w) / (2 * w))
      local text = [[
local M, L, c, k, g = param("M", 2, "kg"), param("L", 0.75, "m"), param("c", 0.01, "N m s"), param("k", 0.5, "N m"),
  param("g", 9.75, "m/s^2")
return scene { name = "unit", body = solid.box { mass = M, x = L, y = 2*L, z = 3*L }, origin = { 0, 0, -L },
  effects = { effect.gravity { g = g }, effect.damping { c = c }, effect.spring { stiffness = k, axis = { 0, 0, 1 } } },
  initial = { omega = { 1, 2, 3 } }, time = { step = 0.01 } }]]
      local methods = { "rk4", "semi", "midpoint", "split2", "adaptive", "taylor" }
      kit.each({ text = text, methods = methods }, function(b, real)
        local m, l, s = 2.0 ^ 100, 2.0 ^ -33, 2.0 ^ -30
        if real == "float" then m, l, s = 2.0 ^ 40, 2.0 ^ -20, 2.0 ^ -4 end
        local x0 = { 0.5, 0.5, -0.5, 0.5, 1, 2, -3 }
        local y0 = { 0.5, 0.5, -0.5, 0.5, 1 / s, 2 / s, -3 / s }
        local p, c, k = { 2, 0.75, 0.01, 0.5, 9.75 }, m * l * l / s, m * l * l / (s * s)
        p = kit.rounded(real, p)
        for _, method in ipairs(methods) do
          assert(b.plugin:init(p) == 0)
          local x = b.plugin:march(0, x0, nil, kit.round(real, 0.01), 500, method)
          assert(b.plugin:init({ p[1] * m, p[2] * l, p[3] * c, p[4] * k, p[5] * l / (s * s) }) == 0)
          local y, most = b.plugin:march(0, y0, nil, kit.round(real, 0.01) * s, 500, method), 0.0
          for i = 1, 7 do most = kit.worst(most, math.abs(y[i] * (i > 4 and s or 1) - x[i])) end
          row(method, real, most, kit.tiny[real])
        end
        for _, method in ipairs { "adaptive", "taylor" } do
          local tolerance = real == "double" and 1e-10 or 1e-5
          assert(b.plugin:init(p) == 0)
          local x = b.plugin:integrate(x0, nil, { tolerance }, { 5 }, 0, method)[1]
          assert(b.plugin:init({ p[1] * m, p[2] * l, p[3] * c, p[4] * k, p[5] * l / (s * s) }) == 0)
          local y, most = b.plugin:integrate(y0, nil, { tolerance }, { 5 * s }, 0, method)[1], 0.0
          for i = 2, 8 do most = kit.worst(most, math.abs(y[i] * (i > 5 and s or 1) - x[i])) end
          row(method, real, most, method == "taylor" and 30 * tolerance or kit.tiny[real])
        end
      end)
    end }

  return { title = "Bodies that burn, fall and are seen from elsewhere", about = "Mass and place that change, " ..
    "frames, " ..
    "and units.", cases = cases }
end
