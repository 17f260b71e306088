-- inputs.lua -- hard cases: inputs beyond their limits, wheels, pulses and tables, clocks that are far on.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local R = kit.R

  local function most_of(x, want, scale)
    local most = 0.0
    for i = 1, #want do most = kit.worst(most, math.abs(x[i] - want[i])) end
    return most / scale
  end

  local cases = {}
  local function case(c) cases[#cases + 1] = c end

  case { name = "control_far_beyond_its_limit", fast = true,
    why = "inputs of 1e0 to 1e17 times the limit, and of 1e30 (float) and 1e300",
    naive = "(|u + max| - |u - max|)/2, the branch-free formula that everybody uses: of large u nothing is left",
    oracle = "max/I, and u/I within",
    bound = "4 u: the limit, 1/I, and their product are rounded",
    run = function(row)
      local m, most = 0.1, 0.0
      for k = 0, 17 do
        local u = 10.0 ^ k
        most = kit.worst(most, math.abs((math.abs(u + m) - math.abs(u - m)) / 2 - m) / m)
      end
      row.naive(most)
      local text = [[
local limit = param("limit", 0.1, "N m")
return scene { name = "held", body = tensor { mass = 1, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.control { max = limit } }, time = { step = 0.25 } }]]
      local methods = { "rk4", "semi", "midpoint", "split4", "taylor" }
      kit.each({ text = text, methods = methods }, function(b, real)
        local limit, I, worst = kit.round(real, 0.1), { 1, 2, 2.5 }, 0.0
        assert(b.plugin:init({ limit }) == 0)
        local list = { 0, 0.05, 0.0999, 0.1, 0.1001, 1e-30, real == "double" and 1e300 or 1e30 }
        for k = 0, 17 do list[#list + 1] = 10.0 ^ k end
        for _, u in ipairs(list) do
          local v = kit.round(real, u)
          local dx = b.plugin:rhs(0, { 1, 0, 0, 0, 0, 0, 0 }, { v, -v, v })
          for i = 1, 3 do
            local want = (i == 2 and -1 or 1) * math.min(v, limit) / I[i]
            worst = kit.worst(worst, math.abs(dx[4 + i] - want) / (want == 0 and 1 or math.abs(want)))
          end
        end
        row("model", real, worst, 4 * b.u)
        for _, method in ipairs(methods) do
          -- from rest about z by a huge input: w = limit h/I
          local x = b.plugin:march(0, { 1, 0, 0, 0, 0, 0, 0 }, { 0, 0, 1e20 }, 0.25, 4, method)
          row(method, real, math.abs(x[7] - limit / 2.5) / (limit / 2.5), 4 * 4 * b.u)
        end
      end)
    end }

  case { name = "wheel_that_is_nearly_all_of_it", fast = true,
    why = "a wheel that has 1 - 2^-20 of the body's moment about its axis: what is left over carries the torque alone",
    naive = "I - J with I and J from decimals of 7 digits: the rest is off by its whole size",
    oracle = "a motor's torque u turns the rest by -u/(I - J), exactly: I and J are powers of two",
    bound = "8 u and one rounding of I - J, which is exact here",
    run = function(row)
      local J, I = 1 - 2.0 ^ -20, 1.0
      row.naive(math.abs((I - tonumber(string.format("%.7g", J))) / (I - J) - 1))
      local text = [[
local J, u = param("J", 0.5, "kg m^2"), param("u", 0.25, "N m")
return scene { name = "drum", body = tensor { mass = 1, xx = 1, yy = 1.5, zz = 1.75 },
  effects = { effect.wheel { axis = { 1, 0, 0 }, inertia = J, torque = u, included = true } },
  time = { step = 0.01 } }]]
      kit.each({ text = text, methods = { "rk4", "adaptive" } }, function(b, real)
        assert(b.plugin:init({ J, 0.25 }) == 0)
        local x0 = { 1, 0, 0, 0, 0, 0, 0, 0 }
        local dx = b.plugin:rhs(0, x0)
        local want = -0.25 / (I - J)
        row("model", real, math.abs(dx[5] - want) / math.abs(want), 9 * b.u)
        local x = b.plugin:march(0, x0, nil, 2.0 ^ -10, 16, "rk4")
        row("rk4", real, math.abs(x[5] - want * 2.0 ^ -6) / math.abs(want * 2.0 ^ -6), (9 + 16) * b.u)
        local a = b.plugin:integrate(x0, nil, { 1e-4 }, { 2.0 ^ -6 }, 0, "adaptive")[1]
        row("adaptive", real, math.abs(a[6] - want * 2.0 ^ -6) / math.abs(want * 2.0 ^ -6), 1e-4)
      end)
    end }

  case { name = "wheel_run_up_and_down",
    why = "momentum is moved between wheel and body for 1e5 steps; the sum in space must stay while both are large",
    naive = "body and wheel by Euler's steps: each step adds h^2/2 of the torque's change",
    oracle = "conservation of I w + J W a in inertial axes",
    bound = "rk4: at most one rounding of the wheel's momentum each step, n u of it, and its truncation, (h " ..
      "w)^4/120 of |L| a revolution; adaptive: 1e-11 per step natural (300 of them), float 1e-5",
    run = function(row)
      local L, w, h = 1.0, 0.0, 1e-3
      for i = 1, 10000 do
        local u = 0.1 * math.cos(1e-3 * i)
        w, L = w + h * u, L - h * 0.1 * math.cos(1e-3 * (i + 1))
      end
      row.naive(math.abs(w + L - 1))
      local text = [[
return scene { name = "spool", body = tensor { mass = 1, xx = 3, yy = 4, zz = 5 },
  effects = { effect.wheel { axis = { 1, 2, 2 }, inertia = 0.1, torque = 0.5 * cos(0.5 * t), speed = 30,
    included = false } },
  initial = { omega = { 0.1, -0.2, 0.3 } }, time = { step = 0.01 } }]]
      kit.each({ text = text, methods = { "rk4", "adaptive" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0 = kit.initial(b)
        local L0 = b.plugin:momentum(x0)
        local size = math.sqrt(L0[1] ^ 2 + L0[2] ^ 2 + L0[3] ^ 2)
        local n = 100000
        local x = b.plugin:march(0, x0, nil, 2.0 ^ -10, n, "rk4")
        row("rk4", real, most_of(b.plugin:momentum(x), L0, size), n * b.u)
        local tolerance = real == "double" and 1e-11 or 1e-5
        local a = b.plugin:integrate(x0, nil, { tolerance }, { 20 }, 0, "adaptive")[1]
        row("adaptive", real, most_of(b.plugin:momentum { table.unpack(a, 2) }, L0, size), 300 * tolerance)
      end)
    end }

  case { name = "pulse_between_two_steps", fast = true,
    why = "a torque that lasts a microsecond inside a step of a second: whoever asks at the step's stages only " ..
      "misses it",
    naive = "rk4 with h = 1 s asks at t = 0, 0.5, 1: the pulse at 0.3 s does not exist",
    oracle = "its area: a trapezium of 1e3 N m over 1e-6 s and two flanks of 1e-6 s, so 2e-3 N m s",
    bound = "adaptive, taylor (which stop at the table's rows): 20 times their tolerance or 40 u, and the clock's u " ..
      "t times the torque: t = 0.3 is rounded, 4 rows",
    run = function(row)
      local function pulse(t) return t > 0.3 and t < 0.300003 and 1000 or 0 end
      local got = (pulse(0) + 4 * pulse(0.5) + pulse(1)) / 6 / 2 -- rk4 of w' = N(t)/I is Simpson's rule
      row.naive(math.abs(got - 1e-3) / 1e-3)
      local text = [[
return scene { name = "kick", body = tensor { mass = 1, xx = 1, yy = 2, zz = 2 },
  effects = { effect.torque { body = { 0, 0,
    { { 0.3, 0 }, { 0.300001, 1000 }, { 0.300002, 1000 }, { 0.300003, 0 } } } } },
  time = { step = 0.01 } }]]
      local want = 2e-3 / 2
      kit.each({ text = text, methods = { "adaptive", "taylor" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0, tolerance = { 1, 0, 0, 0, 0, 0, 0 }, real == "double" and 1e-12 or 1e-5
        local clock = 4 * 0.3 * b.u * 1000 / 2 -- rows rounded to the clock's grid: areas off by that much
        for _, method in ipairs { "adaptive", "taylor" } do
          local a = b.plugin:integrate(x0, nil, { tolerance }, { 1 }, 0, method)
          row(method, real, a and math.abs(a[1][8] - want) / want or math.huge,
            20 * tolerance + 40 * b.u + clock / want)
        end
        if real == "double" then
          row("library", "long double", math.abs(kit.library(b.job, x0, { 1 })[1][7] - want) / want,
            40 * b.u + clock / want)
        end
      end)
    end }

  case { name = "torque_at_a_late_hour", fast = true,
    why = "sin(w t) at t = 1e9 s: the clock's own place is 1e-7 s, the angle 1e9 rad",
    naive = "the clock as a sum of steps, t += 0.001, a billion times: here a million times and scaled",
    oracle = "MPFR: sin of the exact product of the doubles",
    bound = "the clock's value is given; w t is rounded once: u w t, and 8 u",
    run = function(row)
      local t = 0.0
      for _ = 1, 1000000 do t = t + 0.001 end
      row.naive(math.abs(math.sin(1e6 * t) - math.sin(1e6 * 1000)))
      local text = [[
return scene { name = "hum", body = tensor { mass = 1, xx = 1, yy = 2, zz = 2 },
  effects = { effect.torque { body = { 0, 0, 2 * sin(t) } } }, time = { step = 0.01 } }]]
      kit.each({ text = text }, function(b, real)
        assert(b.plugin:init() == 0)
        local most = 0.0
        for _, time in ipairs { 1e9, 123456789.125, 1e9 + 64, 2.0 ^ 40 } do
          local t1 = kit.round(real, time)
          local want = R.todouble(R.apply("sin", 200, R.fromdouble(t1)))
          most = kit.worst(most, math.abs(b.plugin:rhs(t1, { 1, 0, 0, 0, 0, 0, 0 })[7] - want))
        end
        row("model", real, most, 8 * b.u)
      end)
    end }

  case { name = "steps_of_all_sizes", fast = true,
    why = "h from 1e-300 to nine radians' worth, also negative and 0: a state that is finite, a quaternion that is " ..
      "a unit",
    naive = "q + h q' without a norm, h = 10",
    oracle = "|q| = 1; for h = 0 the state itself; for tiny h the state to rounding",
    bound = "8 u for h |w| up to 0.003, where the polynomials' own defect of |q|, (h |w|/2)^6/144 of rk4, is below " ..
      "u; longer steps, to h |w| = 9, must be finite (error 0 or infinite): semi, midpoint and split keep |q| " ..
      "there, too",
    run = function(row)
      row.naive(math.sqrt(1 + (10 * 3 / 2) ^ 2) - 1)
      local text = [[
return scene { name = "leap", body = tensor { mass = 1, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.damping { c = 1e-3 } }, initial = { omega = { 1, 2, -2 } }, time = { step = 0.01 } }]]
      local methods = { "rk4", "semi", "midpoint", "split2", "adaptive", "taylor" }
      local group = { semi = true, midpoint = true, split2 = true }
      kit.each({ text = text, methods = methods }, function(b, real)
        assert(b.plugin:init() == 0)
        local x0 = kit.initial(b)
        for _, method in ipairs(methods) do
          local most = 0.0
          for _, h in ipairs { real == "double" and 1e-300 or 1e-37, 1e-30, 1e-9, 1e-3, 0.1, 0.5, 0, 3 } do
            for sign = -1, 1, 2 do
              local x = b.plugin:march(0, x0, nil, sign * h, 1, method)
              if not kit.finite(x) then most = math.huge end
              if h <= 1e-3 or group[method] then most = kit.worst(most, kit.norm(x)) end
              if h <= 1e-30 then most = kit.worst(most, kit.state(x, x0) / 4) end
            end
          end
          row(method, real, most, 8 * b.u)
        end
      end)
    end }

  return { title = "Inputs, wheels and clocks", about = "What comes from outside, from motors and from tables over " ..
    "time.",
    cases = cases }
end
