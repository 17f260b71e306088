-- q31_run.lua -- the fixed-point step with Lua's integers: the expected bits of the emitted self-test.
--
-- The same list of nodes as the C text (methods/fixed.lua), run with products of 64 bits; what C does about it (limits,
-- remainders) is written here a second time.  A state is 14 whole numbers: q, w, and their remainders.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local bounded = require "generator.dynamics.bounded"
local fixed = require "generator.methods.fixed"
local q31 = require "generator.methods.q31"

local run = {}

local names = { "qw", "qx", "qy", "qz", "wx", "wy", "wz" }
run.names = names

-- Exponent, bits of the remainder, limit of each of the seven states of a step (methods/q31.lua).
function run.layout(step)
  local list = {}
  for i = 1, 7 do
    local w = i > 4
    list[i] = { name = names[i], e = w and step.x.w or 30, k = w and step.x.d - step.x.w or step.x.a - 32,
      limit = w and step.limit[i - 4] or step.attitude_limit, node = w and step.dw[i - 4] or step.dq[i] }
  end
  return list
end

-- The whole numbers of a real state, seven rationals: q is brought to |q| = 1 first.
function run.from_real(step, real)
  local x, square = {}, R.zero
  for i = 1, 4 do square = square + real[i] * real[i] end
  local length = R.apply("sqrt", 200, square)
  for i, s in ipairs(run.layout(step)) do
    local fine = fixed.nearest(i <= 4 and real[i] / length or real[i], s.e + s.k)
    x[i] = s.k > 0 and fixed.floor_shift(fine + (1 << s.k - 1), s.k) or fine
    x[i + 7] = fine - (x[i] << s.k)
  end
  return x
end

-- Seven rationals: what the whole numbers stand for.
function run.to_real(step, x)
  return vec.map(run.layout(step), function(s, i)
    return R.new((x[i] << s.k) + x[i + 7]) * R.new(2) ^ -(s.e + s.k)
  end)
end

-- Words beyond their limits are brought to them, without a remainder; returns the bits of those.
local function limited(layout, x)
  local bits = 0
  for i, s in ipairs(layout) do
    if math.abs(x[i]) > s.limit then
      x[i], x[i + 7] = x[i] > 0 and s.limit or -s.limit, 0
      bits = bits | 1 << i - 1
    end
  end
  return bits
end

-- One step of x, in place; u: a whole number for each input, or nil.  Returns the bits.
function run.step(step, x, u)
  local layout, given = run.layout(step), {}
  local bits = limited(layout, x)
  for i, s in ipairs(layout) do given[s.name] = x[i] end
  for i, s in ipairs(step.u) do
    local x_i = math.max(s.low, math.min(s.high, u[i]))
    given[s.node.name] = x_i
    if x_i ~= u[i] then bits = bits | 1 << s.bit end
  end
  local value, flags = step.program:run(given)
  for i, s in ipairs(layout) do
    if s.node then
      local t = x[i + 7] + value(s.node)
      local d = s.k > 0 and fixed.floor_shift(t + (1 << s.k - 1), s.k) or t
      x[i], x[i + 7] = x[i] + d, t - (d << s.k)
    end
  end
  return bits | flags | limited(layout, x)
end

-- The words after each of these numbers of steps, and all bits on the way.
local function states(step, start, u, counts)
  local x, runs, done = table.move(start, 1, 14, 1, {}), {}, 0
  for i, n in ipairs(counts) do
    local bits = 0
    for _ = done + 1, n do bits = bits | run.step(step, x, u) end
    runs[i], done = { steps = n, x = table.move(x, 1, 14, 1, {}), bits = bits }, n
  end
  return { start = start, u = u, runs = runs }
end

-- What the emitted self-test runs: the scene's own motion, a tumbling one, one that is driven over its limits.
local function cases(step, start)
  local third, list = R.new(1, 3), {}
  local rest, full
  for i, u in ipairs(step.u) do -- every third one is more than the scene allows
    rest, full = rest or {}, full or {}
    rest[i] = math.max(u.low, math.min(u.high, 0))
    full[i] = i % 3 == 1 and u.high // 2 or i % 3 == 2 and u.low // 4 * 3 or (1 << 31) - 1
  end
  list[1] = states(step, start, rest, { 1, 10, 1000 })
  list[1].what = "the scene's own motion"
  local w = step.rates.limit
  list[2] = states(step, run.from_real(step, { R.one, R.new(-2), R.new(3), R.new(4), w[1] * third, -w[2] * third,
    w[3] * R.half }), full, { 1, 100 })
  list[2].what = "tumbling" .. (full and ", with inputs" or "")
  local top = (1 << 31) - 1
  local beyond = { top, -top, 0, top, top, -top, step.limit[3] }
  for i = 8, 14 do beyond[i] = 0 end
  list[3] = states(step, beyond, full, { 1, 2 })
  list[3].what = "driven over the limits"
  return list
end

-- What is emitted for a scene with --with q31, or nil after an error in job.diag:
-- {step, layout, start, energy, cases}
function run.plan(job)
  local rates = bounded.of(job)
  local step = rates and q31.of(job, rates)
  if not step then return nil end
  local m, real = job.model, {}
  for i = 1, 4 do real[i] = m:number(m.attitude[i]) end
  for i = 1, 3 do real[i + 4] = m:number(m.omega[i]) end
  local start, energy = run.from_real(step, real), q31.energy(step)
  local value = energy.program:run { wx = start[5], wy = start[6], wz = start[7] }
  energy.start = value(energy.node)
  return { step = step, layout = run.layout(step), start = start, energy = energy, cases = cases(step, start) }
end

return run
