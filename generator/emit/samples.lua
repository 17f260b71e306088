-- samples.lua -- what a gyro of 16 bits would have read of the scene's own motion: the table of the firmware project.
--
-- The motion is that of the emitted equations with many digits, integrated by the classical Runge-Kutta method: an
-- interval between two samples in n steps, which is doubled until n/2 steps agree to an eighth of the gyro's last bit
-- (the error of n steps is then a 128th).  To each reading noise is added before it is rounded, the sum of twelve
-- uniform numbers of a fixed generator, so that the table is the same wherever it is made.  It also finds by how much
-- one step of the scene's method changes what the motion conserves: what the firmware's watchdog must let pass.
-- ABOVE the line: rationals, rounded to `bits`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local distinct = require "generator.dynamics.distinct"
local selftest = require "generator.emit.selftest"

local samples = { count = 256, most_steps = 4096, noise = 4, full = 32768 }

local bits, two, six = 64, R.new(2), R.new(6)

local function description(job, name)
  for _, f in ipairs(job.functions) do
    if f.name == name then return f end
  end
  return nil
end

-- A description's results at a state (a list in the order of job.states): a list by place.
-- Inputs are 0.
local function values(job, f, env, t, x, h)
  local here, place, out = { t = t, h = h }, {}, {}
  for i, s in ipairs(job.states) do here[s.name], place[s.name] = x[i], i end
  for _, s in ipairs(job.model.inputs) do here[s.name] = R.zero end
  setmetatable(here, { __index = env.value })
  local ranks = setmetatable({}, { __index = function(_, name)
    return rawget(here, name) and 8 or env.value[name] and 3 or nil
  end })
  local value = evaluate.within(here, bits)
  for _, g in ipairs(distinct.run(f.groups, ranks)) do
    for _, d in ipairs(g.defs) do here[d.name] = value(d.expr) end
    for _, o in ipairs(g.outs) do
      local i = o.state and place[o.state] or o.index and o.index + 1 or 1
      out[i] = value(o.expr)
    end
  end
  return out
end

local function moved(x, c, k)
  local y = {}
  for i = 1, #x do y[i] = R.round(x[i] + c * (k[i] or R.zero), bits) end
  return y
end

-- The state after the time T in n steps.
local function integrate(job, rhs, env, t, x, T, n)
  local h = T / R.new(n)
  for _ = 1, n do
    local k1 = values(job, rhs, env, t, x)
    local k2 = values(job, rhs, env, t + h / two, moved(x, h / two, k1))
    local k3 = values(job, rhs, env, t + h / two, moved(x, h / two, k2))
    local k4 = values(job, rhs, env, t + h, moved(x, h, k3))
    local sum = {}
    for i = 1, #x do
      sum[i] = ((k1[i] or R.zero) + two * (k2[i] or R.zero) + two * (k3[i] or R.zero) + (k4[i] or R.zero)) / six
    end
    x, t = moved(x, h, sum), t + h
  end
  return x
end

-- Noise in last bits, times 65536: the generator of Knuth's MMIX, its upper 16 bits.
local function noise()
  local state = 1
  return function()
    local sum = 0
    for _ = 1, 12 do
      state = state * 6364136223846793005 + 1442695040888963407
      sum = sum + (state >> 48)
    end
    return samples.noise * (sum - 6 * 65536)
  end
end

-- The states after every interval T: a list with the initial state at 0; nil if that takes too many steps.  Without lsb
-- with two steps each, unchecked; else the first eight intervals and then every eighth are checked.
local function motion(job, env, x, T, lsb)
  local rhs, n, list, where = description(job, "rhs"), 2, { [0] = x }, {}
  for i, s in ipairs(job.states) do where[s.name] = i end
  for k = 1, samples.count do
    local t = T * R.new(k - 1)
    local fine = integrate(job, rhs, env, t, x, T, n)
    local coarse = lsb and (k <= 8 or k % 8 == 0) and integrate(job, rhs, env, t, x, T, n // 2)
    while coarse do
      local agree = true
      for _, name in ipairs { "wx", "wy", "wz" } do
        local i = where[name]
        agree = agree and R.abs(fine[i] - coarse[i]) * R.new(8) <= lsb
      end
      if agree then break end
      n = 2 * n
      if n > 128 then return nil end
      coarse, fine = fine, integrate(job, rhs, env, t, x, T, n)
    end
    x = fine
    list[k] = x
  end
  return list, where
end

-- The smallest power of two that is at least q > 0.
local function power_above(q)
  local p = two ^ R.log2(q)
  while p < q do p = two * p end
  return p
end

-- What is conserved, by the names of the emitted functions: {name, count, timed = takes the time}.
function samples.conserved(job)
  local law, list = job.conserved.is, {}
  if job.conserved.rate then
    list[1] = { name = "jacobi_integral", count = 1, timed = true }
  elseif law["T+V"] then
    list[1] = { name = "energy", count = 1 }
  end
  if law.L then list[#list + 1] = { name = "momentum", count = 3 } end
  return list
end

-- For each of what is conserved: `jump`, what one step may change it by, and `size`, the magnitude of its terms; and
-- what | |q|^2 - 1 | may be after a step.
local function jumps(job, env, states, T, h, epsilon)
  local step, list, stepped, norm = description(job, "step"), samples.conserved(job), {}, R.zero
  for k = 0, samples.count - 1, 16 do
    local x = states[k]
    local y, n = values(job, step, env, T * R.new(k), x, h), -R.one
    for i, s in ipairs(job.states) do
      y[i] = y[i] or x[i]
      if s.kind == "attitude" then n = n + y[i] * y[i] end
    end
    stepped[k] = y
    if R.abs(n) > norm then norm = R.abs(n) end
  end
  for _, c in ipairs(list) do
    local f, worst, size = description(job, c.name), R.zero, R.zero
    for k = 0, samples.count - 1, 16 do
      local t, x, y = T * R.new(k), states[k], stepped[k]
      local before, after = values(job, f, env, t, x), values(job, f, env, t + h, y)
      local here = { t = t }
      for i, s in ipairs(job.states) do here[s.name] = x[i] end
      local _, slack = selftest.expect(f, env, here, function(o) return o.index and o.index + 1 or 1 end, epsilon)
      for i = 1, c.count do
        local d = R.abs(after[i] - before[i])
        if d > worst then worst = d end
        if slack[i] > size then size = slack[i] end
      end
    end
    -- four times the worst step, and the roundings of three evaluations: before, after, and of the state between
    c.jump, c.size = R.round(R.new(4) * worst + R.new(3) * size, 24), R.round(size / epsilon / R.new(32), 24)
  end
  return list, R.round(R.new(4) * norm + R.new(64) * epsilon, 24)
end

-- The largest of |x[i]|, i from the places, over all states.
local function largest(states, places)
  local most = R.zero
  for k = 0, #states do
    for _, i in ipairs(places) do
      local a = R.abs(states[k][i])
      if a > most then most = a end
    end
  end
  return most
end

-- {table = rows of three integers, every = steps between samples, lsb, full (rad/s), laws}; nil and why.
-- round: to the real type; epsilon: its unit.
function samples.of(job, params, round, epsilon)
  local m = job.model
  local env, h = selftest.environment(m, params, job.held), round(m:number(m.step))
  local steps = R.toint(R.floor(m:number(m.horizon) / h))
  local every = math.max(1, math.min(steps, samples.most_steps) // samples.count)
  local T = h * R.new(every)
  local x = {}
  for i, s in ipairs(job.states) do x[i] = round(m:number(s.initial)) end
  local places = {}
  for i, s in ipairs(job.states) do
    if s.kind == "rates" then places[#places + 1] = i end
  end
  -- the last bit is not known before the motion is, so once roughly
  local rough = largest(motion(job, env, x, T), places)
  if R.sign(rough) == 0 then rough = R.one / (T * R.new(samples.count)) end -- at rest
  local states, where = motion(job, env, x, T, power_above(rough) / R.new(samples.full))
  if not states then return nil, "its motion cannot be followed to the last bit of a gyro" end
  local most = largest(states, places)
  local full = power_above((R.sign(most) > 0 and most or rough) * R.new(5, 4))
  local lsb, rows, random = full / R.new(samples.full), {}, noise()
  for k = 1, samples.count do
    rows[k] = {}
    for j, name in ipairs { "wx", "wy", "wz" } do
      local raw = R.toint(R.floor(states[k][where[name]] / lsb + R.new(random(), 65536) + R.half))
      rows[k][j] = math.max(-32768, math.min(32767, raw))
    end
  end
  local laws, norm = jumps(job, env, states, T, h, epsilon)
  return { table = rows, every = every, lsb = lsb, full = full, laws = laws, norm = norm }
end

return samples
