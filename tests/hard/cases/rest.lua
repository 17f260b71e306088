-- rest.lua -- hard cases: everything at zero, rates that are denormal, stops by friction and drag.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local R = kit.R

  -- What takes energy out, and an input, in one scene; all of it is silent at rest.
  local still = [[
return scene { name = "still", body = tensor { mass = 2, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.damping { c = { 0.1, 0.2, 0.3 } }, effect.drag { c = 0.5 },
    effect.friction { torque = 0.01, smoothing = 1e-3 }, effect.spring { stiffness = { 1, 2, 3 } },
    effect.control { max = 0.1 }, effect.dissipation { k = 0.1 } },
  initial = { omega = { 0, 0, 0 } }, time = { step = 0.01 } }
]]
  local some = { "rk4", "adaptive", "semi" }

  -- A rotor about one axis under dry friction and nothing else.
  local rub = [[
local T, s = param("T", 0.25, "N m"), param("s", 1e-3, "1/s")
return scene { name = "rub", body = tensor { mass = 2, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.friction { torque = T, smoothing = s } },
  initial = { omega = { 0, 0, 1 } }, time = { step = 0.01 } }
]]
  local paddle = [[
local c = param("c", 0.5, "N m s^2")
return scene { name = "paddle", body = tensor { mass = 2, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.drag { c = c } },
  initial = { omega = { 0, 0, 1 } }, time = { step = 0.01 } }
]]

  -- dw/dt = -(T/I) w/sqrt(w^2 + s^2) from w0: T t/I = g(w0) - g(w), g(w) = sqrt(w^2 + s^2) + s log(w/(s + sqrt(w^2 +
  -- s^2))), by separation.  w(t) by bisection of the monotonous g in ordinary numbers, good to 1e-15 where the
  -- logarithm is O(1); g is formed exactly enough by doubles because s g'(w) is never small against u g.
  local function slowed(w0, s, T_over_I, t)
    local function g(w)
      local r = math.sqrt(w * w + s * s)
      return r + s * math.log(w / (s + r))
    end
    local goal, lo, hi = g(w0) - T_over_I * t, 0.0, w0
    for _ = 1, 2000 do
      local mid = lo > hi / 4 and (lo + hi) / 2 or math.max(math.sqrt(math.max(lo, 1e-300) * hi), 1e-300)
      if mid <= lo or mid >= hi then break end
      if g(mid) > goal then hi = mid else lo = mid end
    end
    return (lo + hi) / 2
  end

  -- A decade in every row: the error of w_z against a function of t, relative to w0, for adaptive and rk4.
  local function spin_down(row, o)
    kit.each({ text = o.text, methods = { "rk4", "adaptive" } }, function(b, real)
      local p = kit.rounded(real, o.p)
      assert(b.plugin:init(p) == 0)
      local x0 = { 1, 0, 0, 0, 0, 0, kit.round(real, o.w0) }
      local worst = { rk4 = 0.0, adaptive = 0.0 }
      for _, t in ipairs(o.times) do
        local want = o.want(x0[7], p, t)
        local a = b.plugin:integrate(x0, nil, { o.tolerance[real] }, { t }, 0, "adaptive")
        local scale = o.relative and want or x0[7]
        worst.adaptive = kit.worst(worst.adaptive, a and math.abs(a[1][8] - want) / scale or math.huge)
        local n = math.ceil(t / o.h)
        local x = b.plugin:march(0, x0, nil, t / n, n, "rk4")
        worst.rk4 = kit.worst(worst.rk4, math.abs(x[7] - want) / scale)
      end
      row("adaptive", real, worst.adaptive, o.bound.adaptive(real))
      row("rk4", real, worst.rk4, o.bound.rk4(real))
      if real == "double" then
        local names, values, most = { "T", "s" }, {}, 0.0
        for i, v in ipairs(p) do values[o.names and o.names[i] or names[i]] = v end
        for i, x in ipairs(kit.library(b.job, x0, o.times, values)) do
          local want = o.want(x0[7], p, o.times[i])
          most = kit.worst(most, math.abs(x[7] - want) / (o.relative and want or x0[7]))
        end
        row("library", "long double", most, o.bound.library)
      end
    end)
  end

  local cases = {}
  local function case(c) cases[#cases + 1] = c end

  case { name = "zero_everything", fast = true,
    why = "rates, torques, spring and input are all 0: |w| has no derivative, errors to be divided by are 0, and " ..
      "step control divides by the error",
    naive = "w/|w| for the direction of friction and drag: 0/0",
    oracle = "a state of rest stays",
    bound = "none: the smallest number there is, so every component is exact",
    run = function(row)
      local w = 0.0
      row.naive(kit.number(w / math.sqrt(w * w)))
      kit.each({ text = still, methods = some }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0 = { 1, 0, 0, 0, 0, 0, 0 }
        for _, method in ipairs(some) do
          local x = b.plugin:march(0, x0, { 0, 0, 0 }, 0.01, 1000, method)
          local most = 0.0
          for i = 1, 7 do most = kit.worst(most, math.abs(x[i] - x0[i])) end
          row(method, real, most, kit.tiny[real])
        end
        local run = b.plugin:integrate(x0, { 0, 0, 0 }, { 1e-6 }, { 10 }, 0, "adaptive")
        local most = run and 0.0 or math.huge
        for i = 1, 7 do most = kit.worst(most, run and math.abs(run[1][i + 1] - x0[i]) or 0) end
        row("adaptive", real, most, kit.tiny[real])
        if real == "double" then
          local x = kit.library(b.job, x0, { 10 })[1]
          most = 0.0
          for i = 1, 7 do most = kit.worst(most, math.abs(x[i] - x0[i])) end
          row("library", "long double", most, kit.tiny.double)
        end
      end)
    end }

  case { name = "jacobian_at_rest", fast = true,
    why = "the derivative of drag at w = 0 is 0 and of friction -T/s, while |w| itself has none",
    naive = "differentiating c |w| w by the product rule: c (w w/|w| + |w|) is 0/0",
    oracle = "the limits, by hand: dN/dw = -C - T/s from damping, drag (0) and friction",
    bound = "4 u: C + T/s rounded, divided by I and rounded, T/s itself",
    run = function(row)
      local w = 0.0
      row.naive(kit.number(w * w / math.sqrt(w * w)))
      kit.each({ text = still, methods = some }, function(b, real)
        assert(b.plugin:init() == 0)
        local J = b.plugin:jacobian(0, { 1, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0 })
        local I, C, most = { 1, 2, 2.5 }, { 0.1, 0.2, 0.3 }, kit.finite(J) and 0.0 or math.huge
        for i = 1, 3 do
          local want = -(C[i] + 0.01 / 1e-3) / I[i]
          most = kit.worst(most, math.abs(J[(i + 3) * 7 + i + 4] - want) / math.abs(want))
        end
        row("model", real, most, 4 * b.u)
      end)
    end }

  case { name = "denormal_rates", fast = true,
    why = "rates of 2^-1060 and 2^-1074 (float 2^-140, 2^-149): products of two vanish, quotients lose their digits",
    naive = "unit direction w/|w| by squares: 0/0",
    oracle = "only damping is left, -c w/I, to the last place of the smallest numbers",
    bound = "2 of the smallest numbers: each product and each sum rounds to a multiple of it",
    run = function(row)
      local w = 2.0 ^ -1060
      row.naive(kit.number(w / math.sqrt(w * w) - 1))
      local text = [[return scene { name = "thin", body = tensor { mass = 2, xx = 1, yy = 2, zz = 2.5 },
        effects = { effect.damping { c = { 0.5, 0.5, 1 } }, effect.drag { c = 0.5 } }, time = { step = 0.01 } }]]
      kit.each({ text = text, methods = { "rk4" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local unit = kit.tiny[real]
        local x = { 1, 0, 0, 0, unit * 2.0 ^ 14, -unit, unit * 2.0 ^ 9 }
        local dx, I, C, most = b.plugin:rhs(0, x), { 1, 2, 2.5 }, { 0.5, 0.5, 1 }, 0.0
        for i = 1, 3 do
          -- in units of the smallest number, which is where the quotient is an ordinary one
          most = kit.worst(most, math.abs(dx[4 + i] / unit + C[i] / I[i] * (x[4 + i] / unit)))
        end
        row("model", real, most, 2)
        local after = b.plugin:march(0, x, nil, 0.01, 10, "rk4")
        row("rk4", real, kit.finite(after) and kit.norm(after) / b.u or math.huge, 4)
      end)
    end }

  case { name = "friction_comes_to_rest",
    why = "dry friction of smoothing 1e-3: within a thousandth of the whole time the torque turns from constant to " ..
      "linear, 250 times stiffer than the motion before",
    naive = "T sign(w) by rk4 with the same step: it jumps about rest for ever",
    oracle = "separation of variables, T t/I = g(w0) - g(w), solved by bisection",
    bound = "adaptive: 30 times its tolerance for 3 decades of stiffness. rk4: (h T/(I s))^4 s/w0 at the kink, " ..
      "where h T/(I s) = 0.1, or 1000 roundings of w0; library 1e-13",
    run = function(row)
      local w, h, most = 1.0, 1e-3, 0.0
      for i = 1, 20000 do
        w = w - 0.1 * h * (w > 0 and 1 or w < 0 and -1 or 0)
        if i > 19900 then most = math.max(most, math.abs(w - slowed(1, 1e-3, 0.1, i * h))) end
      end
      row.naive(most)
      local tolerance = { double = 1e-12, float = 1e-5 }
      spin_down(row, { text = rub, p = { 0.25, 1e-3 }, w0 = 1, h = 1e-3, times = { 1, 9, 9.99, 10, 10.01, 20 },
        tolerance = tolerance, want = function(w0, p, t) return slowed(w0, p[2], p[1] / 2.5, t) end,
        bound = { adaptive = function(real) return 30 * tolerance[real] end, library = 1e-13,
          rk4 = function(real) return math.max(0.1 ^ 4 * 1e-3, 1000 * kit.u[real]) end } })
    end }

  case { name = "friction_smoothing_refused", fast = true,
    why = "a smoothing rate whose square underflows makes friction at rest 0/0; parameters come at run time",
    naive = "T w/sqrt(w^2 + s^2) with s = 1e-200 at w = 0",
    oracle = "NAME_init refuses, or the torque at rest is 0",
    bound = "none: a status, or 0",
    run = function(row)
      local s, w = 1e-200, 0.0
      row.naive(kit.number(w / math.sqrt(w * w + s * s)))
      local least = { double = 1e-200, float = 1e-30 }
      kit.each({ text = rub, methods = { "rk4", "adaptive" } }, function(b, real)
        local most = 0.0
        if b.plugin:init({ 0.25, least[real] }) == 0 then
          for _, v in ipairs(b.plugin:rhs(0, { 1, 0, 0, 0, 0, 0, 0 })) do most = kit.worst(most, math.abs(v)) end
        end
        row("model", real, most, kit.tiny[real])
      end)
    end }

  case { name = "drag_for_a_long_time",
    why = "w = w0/(1 + c w0 t/I) falls by eight decades, and the step must grow by as many",
    naive = "Euler's steps of 0.2/(c w0/I), as one would choose them at the start: after 1e6 of them only t = 1e3 " ..
      "is done",
    oracle = "the formula, in doubles (no cancellation)",
    bound = "relative to w itself. adaptive: 30 tolerances (some 25 natural steps, whose errors fade); rk4 with 1e6 " ..
      "steps of h c w0/I = 0.2, where its error is below (0.2)^4/120 of the first steps' change, and 1e6 u at worst " ..
      "of roundings; library 1e-15",
    run = function(row)
      local w, h = 1000.0, 1e-3
      for _ = 1, 1000 do w = w - h * 0.2 * w * w end
      row.naive(kit.number(math.abs(w - 1000 / (1 + 0.2 * 1000)) / (1000 / (1 + 0.2 * 1000))))
      local tolerance = { double = 1e-12, float = 1e-5 }
      spin_down(row, { text = paddle, p = { 0.5 }, names = { "c" }, w0 = 1000, h = 1e-3, times = { 1e-3, 1, 1e3 },
        tolerance = tolerance, relative = true, want = function(w0, p, t) return w0 / (1 + p[1] / 2.5 * w0 * t) end,
        bound = { adaptive = function(real) return 30 * tolerance[real] end, library = 1e-15,
          rk4 = function(real) return 0.2 ^ 4 / 120 + 1e6 * kit.u[real] end } })
    end }

  case { name = "damped_below_the_smallest",
    why = "exp(-t) falls below the smallest number: it must end in zero, not in a denormal that never goes, and " ..
      "never NaN",
    naive = "w/w0 as a ratio of successive values: 0/0 after the underflow",
    oracle = "0 to within the smallest normal number",
    bound = "the smallest normal number: below it steps round",
    run = function(row)
      local w = 1.0
      for _ = 1, 1100 do w = w / 2 end
      row.naive(kit.number(w / w))
      local text = [[return scene { name = "gone", body = tensor { mass = 2, xx = 1, yy = 2, zz = 2.5 },
        effects = { effect.damping { c = { 1, 2, 2.5 } } }, time = { step = 0.01 } }]]
      kit.each({ text = text, methods = { "rk4", "adaptive", "semi", "split2" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0 = { 1, 0, 0, 0, 1, 2, -3 }
        local least = real == "double" and 2.0 ^ -1022 or 2.0 ^ -126
        for _, method in ipairs { "rk4", "adaptive", "semi", "split2" } do
          local x = b.plugin:march(0, x0, nil, 0.25, 4000, method)
          row(method, real, kit.worst(math.abs(x[5]), math.abs(x[6]), math.abs(x[7]), kit.norm(x) < 8 * b.u and 0 or 1),
            least)
        end
      end)
    end }

  case { name = "isotropic_damping_stiff", fast = true,
    why = "N = -rate L with a rate of 1e6 1/s: the motion is over in microseconds, and t = 1 s is a million times " ..
      "later",
    naive = "rk4 at h = 1 ms: each step multiplies by (h rate)^4/24",
    oracle = "w = w0 exp(-rate t); attitude: the free motion at (1 - exp(-rate t))/rate, for a spin about z an angle",
    bound = "20 u: the exponential (1 ulp), its argument's rounding times rate t <= 20, the closed form's 17 u",
    run = function(row)
      local w, k = 1.0, 1e6
      for _ = 1, 20 do
        local z = -k * 1e-3
        w = w * (1 + z + z ^ 2 / 2 + z ^ 3 / 6 + z ^ 4 / 24)
      end
      row.naive(kit.number(math.abs(w)))
      local text = [[
local k = param("k", 1e6, "1/s")
return scene { name = "syrup", body = tensor { mass = 2, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.damping { rate = k } }, initial = { omega = { 0, 0, 1000 } }, time = { step = 1e-7 } }]]
      kit.each({ text = text }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0 = { 1, 0, 0, 0, 0, 0, 1000 }
        local ok, most, limit = b.plugin:solve(x0) == 0, 0.0, 0.0
        for _, time in ipairs { 1e-9, 1e-7, 1e-6, 1e-5, 1e-3, 1 } do
          local t = kit.round(real, time)
          local decay = R.todouble(R.apply("exp", 120, R.fromdouble(-math.min(t, 7e-4)) * R.new(1000000)))
          local angle = 1000 * (1 - decay) / 1e6
          if t < 1e-8 then angle = 1000 * t * (1 - t * 1e6 / 2 + (t * 1e6) ^ 2 / 6) end -- 1 - exp cancels
          local x = ok and b.plugin:at(t) or { 0, 0, 0, 0, 0, 0, 0 }
          most = kit.worst(most, kit.angle(x, { math.cos(angle / 2), 0, 0, math.sin(angle / 2) }))
          limit = kit.worst(limit, math.abs(x[7] - 1000 * decay) / 1000)
        end
        row("at", real, ok and kit.worst(most, limit) or math.huge, 40 * b.u)
      end)
    end }

  return { title = "Rest, denormals and what stops", about = "Effects that take energy out, where nothing or next " ..
    "to " ..
    "nothing is left.", cases = cases }
end
