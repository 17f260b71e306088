-- stiffness.lua -- does something decay much faster than the motion changes? How fast, and what explicit steps cost.
--
-- J = dx'/dx by central differences, at `samples` times of the motion from the scene's own state.  Its spectral radius
-- r is the mean growth of a power iteration (Gelfand), which complex pairs share.  All eigenvalues lie in |z| <= r;
-- those of J - r have |z| = 2 r only for a real decay -r, and at most sqrt(2) r for an oscillation.  So the radius of J
-- - r less r tells a decay (r) from an oscillation (0.41 r).
-- SPDX-License-Identifier: GPL-3.0-or-later

local motion = require "generator.dynamics.motion"
local rates = require "generator.plan.rates"
local states = require "generator.plan.states"

local stiffness = {}

local samples, powers = 24, 40
local decay = 0.8 -- of the radius: between the two cases above, nearer to the first
local enough = 1000 -- decays over the horizon; below it explicit methods are not limited by their stability for long
local tolerance, most = 1e-5, 200000 -- of the run that looks; steps between two samples

-- How far on the negative real axis explicit steps are stable, |z| = h rate: Runge and Kutta's, Dormand and Prince's
-- (Hairer, Wanner, Solving ODEs II, IV.2), and Taylor series of order p, whose bound grows to p/e.
function stiffness.reach(method, order)
  if method == "taylor" then return 1.3 + 0.4 * (order or 20) end
  return method == "adaptive" and 3.31 or 2.79
end

-- The longest step that rk4 may take.
function stiffness.longest(rate) return stiffness.reach "rk4" / rate end

-- df/dx as rows.  A step of a cube root of the rounding of each state's size.
local function jacobian(f, x, epsilon)
  local rows, size = {}, 0.0
  for i = 1, #x do
    rows[i] = {}
    size = math.max(size, math.abs(x[i]))
  end
  for k = 1, #x do
    local h = epsilon ^ (1 / 3) * math.max(math.abs(x[k]), 1e-2 * size)
    local a, b = { table.unpack(x) }, { table.unpack(x) }
    a[k], b[k] = x[k] + h, x[k] - h
    local fa, fb = f(a), f(b)
    for i = 1, #x do rows[i][k] = (fa[i] - fb[i]) / (a[k] - b[k]) end
  end
  return rows
end

-- The spectral radius of J - s; 0 of what is nilpotent, nil where it is not finite.
local function radius(J, s)
  local n, v, sum, counted = #J, {}, 0.0, 0
  for i = 1, n do v[i] = 1 + 0.37 * ((i * 7) % 5) end
  for p = 1, powers do
    local w, square = {}, 0.0
    for i = 1, n do
      local row, y = J[i], -s * v[i]
      for k = 1, n do y = y + row[k] * v[k] end
      w[i], square = y, square + y * y
    end
    local length = math.sqrt(square)
    if length == 0 then return 0.0 end
    if length ~= length or length == math.huge then return nil end
    for i = 1, n do v[i] = w[i] / length end
    if p > powers / 2 then sum, counted = sum + math.log(length), counted + 1 end
  end
  return math.exp(sum / counted)
end

-- The rate of decay of f = x' at x, 1/s; 0 if what is fastest oscillates.
function stiffness.rate(f, x, epsilon)
  local J = jacobian(f, x, epsilon)
  local r = radius(J, 0.0)
  local left = r and r > 0 and radius(J, r)
  return left and left - r >= decay * r and r or 0.0
end

-- Of the motion from point: {rate = the fastest decay, 1/s, decays = the integral of the rate over the horizon T}; nil
-- if it is not stiff.  plugin: its emitted code, with `adaptive`.
function stiffness.of(job, plugin, point, T, epsilon)
  local fastest, decays, at = 0.0, 0.0, { t = 0.0, x = point.x }
  -- what needs more steps than `most` is stiff by what was seen
  local m = motion.emitted(job, plugin, { method = "adaptive", x = point.x, course = point.input, most = most,
    tolerance = math.max(tolerance, 16 * epsilon) })
  local function f(y) return plugin:rhs(at.t, y, point.input) end
  for k = 0, samples - 1 do
    local r = stiffness.rate(f, at.x, epsilon)
    fastest, decays = math.max(fastest, r), decays + r * T / samples
    local next_t = T * (k + 1) / samples
    at = motion.to(m, next_t, { from = at })
    if not at then
      local left = T - next_t
      if fastest * left > enough then decays = decays + fastest * left end
      break
    end
  end
  return decays > enough and { rate = fastest, decays = decays } or nil
end

-- Whether it is looked for: not where the motion has a closed form, nor where no limits tell what the inputs may be.
function stiffness.sought(job)
  return not job.closed.full and (not job.equations.inputs or states.limits(job) ~= nil)
end

-- The same of the scene's first state alone, without a compiler.
function stiffness.start(job)
  if not stiffness.sought(job) then return nil end
  local point, T = states.points(job, "double", 1)[1], job.model:double(job.model.horizon)
  local exact = rates.new(job)
  local r = stiffness.rate(function(x) return exact:of(0.0, x, point.input) end, point.x, 2.0 ^ -52)
  return r * T > enough and { rate = r, decays = r * T } or nil
end

return stiffness
