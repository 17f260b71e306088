-- comparison.lua -- one emitted, compiled scene against the general library: the checks of `polhode check`.
--
-- States and parameters are drawn by drawn.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local switching = require "generator.dynamics.switching"
local forced = require "generator.commands.forced"
local contact = require "generator.dynamics.contact"
local drawn = require "generator.commands.drawn"
local happenings = require "generator.dynamics.happenings"
local motion = require "generator.dynamics.motion"
local numeric = require "generator.dynamics.numeric"
local selftest = require "generator.emit.selftest"
local motion_checks = require "generator.commands.motion_checks"
local stepper_checks = require "generator.commands.stepper_checks"
local touch_checks = require "generator.commands.touch_checks"

local comparison = {}

local narrow, state = numeric.narrow, drawn.state

-- The larger of two; a NaN counts as infinite, so that it cannot pass a test (math.max would drop it).
local function worse(a, b)
  if b ~= b then return math.huge end
  return b > a and b or a
end

local function largest(v)
  local m = 0.0
  for i = 1, #v do m = worse(m, math.abs(v[i])) end
  return m
end

-- The difference in units of scale x epsilon; infinite for NaN.
local function ratio(got, want, scale, epsilon)
  if got ~= got or scale == math.huge then return math.huge end
  local d = math.abs(got - want)
  if d == 0 then return 0.0 end
  return d / (scale * epsilon)
end

-- What each kind of state is about: the largest initial |w|, |r| and so on, where that is not 0; of the rates at least
-- the rate of a frame.  A velocity also is a length by the fastest rate.
local function scales(job)
  local m = job.model
  local s = { attitude = 1.0 }
  local function largest_of(v)
    local most = 0.0
    for _, e in ipairs(v) do most = math.max(most, math.abs(m:double(e))) end
    return most
  end
  for _, x in ipairs(job.states) do
    if x.kind ~= "attitude" then s[x.kind] = math.max(s[x.kind] or 0.0, largest_of { x.initial }) end
  end
  s.rates = s.rates and s.rates > 0 and s.rates or 1.0
  if m.has.position then
    s.position = s.position > 0 and s.position or 1.0
    s.velocity = s.velocity > 0 and s.velocity or s.position
  end
  for _, x in ipairs(job.states) do s[x.kind] = s[x.kind] > 0 and s[x.kind] or 1.0 end
  return s
end

-- What cancels in the constants themselves for these parameters (nil: the scene's own), and how to say so.
local function cancellation(job, values)
  local params = {}
  for _, p in ipairs(job.model.params) do params[p.name] = values and values[p.name] or p.default end
  return selftest.cancellation(job.model, params)
end

local function said(factor)
  return factor > 1.5 and string.format(" x %.3g that cancels in the constants", factor) or ""
end

local function tensors(job, name, plugin, mass, tap, epsilon)
  local I, worst = plugin:inertia(), 0.0
  local factor = cancellation(job)
  local scale = largest(mass.inertia) * factor
  for k = 1, 6 do worst = worse(worst, ratio(I[k], mass.inertia[k], scale, epsilon)) end
  -- a tensor of n pieces is about 4 n roundings of terms no larger than its largest entry
  tap.ok(worst <= 8, name .. ": tensor as the library's from the shapes",
    string.format("%.2f ulp of the largest entry%s", worst, said(factor)))
  local moments = plugin:principal()
  worst = 0.0
  for k = 1, 3 do worst = worse(worst, ratio(moments[k], mass.moments[k], mass.moments[3] * factor, epsilon)) end
  -- Jacobi's rotations: at most 12 roundings of the largest moment, after the tensor's own 8
  tap.ok(worst <= 20, name .. ": principal moments", string.format("%.2f ulp of the largest", worst))
end

-- Rates, energy and momentum of the emitted code against the library's, at `count` states, spread over the scene's own
-- parameters and random ones.
local function rates(host, job, plugin, tap, count, name, random, real, epsilon)
  local scale, worst, energy, momentum, states, most = scales(job), 0.0, 0.0, 0.0, 0, 1.0
  local sets = #job.model.params > 0 and math.min(20, count) or 1
  local span = math.max(1.0, job.model:double(job.model.horizon)) -- of times, for what depends on them
  for set = 1, sets do
    local values = set > 1 and drawn.parameters(job, random, plugin, real) or nil
    if set == 1 then
      plugin:init()
      if real == "float" then values = {} end
      for _, p in ipairs(real == "float" and job.model.params or {}) do
        values[p.name] = R.fromdouble(narrow(R.todouble(p.default), real))
      end
    end
    local library, why = host.rates(numeric.scene(job, values))
    if not library then
      tap.ok(false, name .. ": the library accepts the scene", why)
      return
    end
    local factor = cancellation(job, values)
    most = math.max(most, factor)
    for _ = 1, count // sets + (set <= count % sets and 1 or 0) do
      local x, t = state(job, random, scale, real), narrow(math.abs(random()) * span, real)
      local u = job.equations.inputs and drawn.input(job, random, scale.rates, real) or nil
      local full = numeric.whole(job, x)
      local want, size = library:rates(t, full, u)
      want, size = numeric.part(job, want), numeric.part(job, size)
      local got = plugin:rhs(t, x, u)
      for k = 1, #x do
        if size[k] > 0 or want[k] ~= 0 or got[k] ~= 0 then
          worst = worse(worst, ratio(got[k], want[k], size[k] * factor, epsilon))
        end
      end
      local E, Es = library:energy(full)
      energy = worse(energy, ratio(plugin:energy(x), E, Es * factor, epsilon))
      local L, Ls = library:momentum(full)
      local M = job.model.has.attitude and plugin:momentum(x) or L
      for k = 1, 3 do momentum = worse(momentum, ratio(M[k], L[k], Ls * factor, epsilon)) end
      states = states + 1
    end
  end
  local where = string.format(" over %d states and %d sets of parameters%s", states, sets, said(most))
  tap.ok(worst <= 8, name .. ": rates of change to 8 ulp of the largest term" .. where, string.format("%.2f", worst))
  tap.ok(energy <= 8, name .. ": energy to 8 ulp of the largest term" .. where, string.format("%.2f", energy))
  if not job.model.has.attitude then return end
  tap.ok(momentum <= 8, name .. ": momentum to 8 ulp of the largest term" .. where, string.format("%.2f", momentum))
end

-- The largest entry of a list over the states of the kind of state i.
local function size_of(job, list, i)
  local most = 0.0
  for k, s in ipairs(job.states) do
    if s.kind == job.states[i].kind then most = worse(most, math.abs(list[k])) end
  end
  return most
end

-- A random state beside which the equations are smooth as far as the steps width(state) go: no corner changes its sign
-- there.  nil if that is so at none of twenty; corners, values: see switching.values.
local function smooth_state(job, corners, values, random, scale, width)
  local function clear(x)
    local here, near = values(0.0, x), { table.unpack(x) }
    for i, s in ipairs(job.states) do
      for _, side in ipairs { -1, 1 } do
        near[i] = x[i] + side * width(s)
        for k, value in ipairs(values(0.0, near)) do
          if value * here[k] <= 0 then return false end
        end
      end
      near[i] = x[i]
    end
    return true
  end
  for _ = 1, 20 do
    local x = state(job, random, scale, job.real)
    if corners == 0 or clear(x) then return x end
  end
  return nil
end

-- Against central differences over the steps d and d/2.  Their rounding is a few eps of the terms of the rates over d;
-- what the longer one errs by beside it is four thirds of their difference, the third derivative's part.
local function jacobian(host, job, plugin, tap, name, random, real, epsilon)
  plugin:init()
  local scale, factor = scales(job), cancellation(job)
  local worst, tried = 0.0, 0
  local corners, values = switching.values(job.equations)
  local function width(s) return scale[s.kind] * 2.0 ^ -10 end
  local library, why = host.rates(numeric.scene(job))
  if not library then
    tap.ok(false, name .. ": the library accepts the scene", why)
    return
  end
  local function difference_at(x, k, d)
    local up, down = { table.unpack(x) }, { table.unpack(x) }
    up[k], down[k] = narrow(x[k] + d, real), narrow(x[k] - d, real)
    local a, b = plugin:rhs(0, up), plugin:rhs(0, down)
    local slope = {}
    for i = 1, #x do slope[i] = (a[i] - b[i]) / (up[k] - down[k]) end
    return slope, a
  end
  for _ = 1, 10 do
    local x = smooth_state(job, corners, values, random, scale, width)
    if not x then break end
    tried = tried + 1
    local J, n = plugin:jacobian(0, x), #x
    local _, terms = library:rates(0, numeric.whole(job, x))
    terms = numeric.part(job, terms)
    for k = 1, n do
      local d = width(job.states[k])
      local slope, a = difference_at(x, k, d)
      local half = difference_at(x, k, d / 2)
      for i = 1, n do
        local bound = math.max(size_of(job, terms, i), size_of(job, a, i)) / d * 16 * factor * epsilon +
          2 * math.abs(slope[i] - half[i])
        local error = math.abs(J[(i - 1) * n + k] - slope[i])
        if error ~= 0 then worst = worse(worst, error / bound) end
      end
    end
  end
  local what = name .. ": Jacobian as central differences of the rates"
  if tried == 0 then
    tap.ok(true, what .. " # SKIP every state that was tried lies beside a corner")
  else
    tap.ok(worst <= 1, what, string.format("%.2g of the bound%s", worst, said(factor)))
  end
end

-- Largest difference of two states, each component by its scale or by its size where that is larger.
local function distance(job, scale, a, b)
  local d = 0.0
  for i, s in ipairs(job.states) do
    d = worse(d, math.abs(a[i] - b[i]) / math.max(scale[s.kind], math.abs(a[i])))
  end
  return d
end

-- The numeric form of the scene with the tensor that the emitted code uses, and its state: x, or the scene's own.
local function setting(job, plugin, x)
  plugin:init()
  x = x or numeric.initial(job)
  for i, y in ipairs(x) do x[i] = narrow(y, job.real) end
  return numeric.from(numeric.scene(job), job, x), x
end

-- The steppers, on motions without corners: from the scene's own state or one near it, and from another one.
local function steppers(host, job, plugin, tap, name, x0, random, epsilon)
  local scale, parts = scales(job), {}
  local function draw() return state(job, random, scale, job.real) end
  if contact.of(job.model) then -- of a state drawn at random the plane might have to pull the body
    function draw()
      local x = { table.unpack(x0) }
      for i, s in ipairs(job.states) do
        if s.kind == "rates" then x[i] = x[i] * 0.875 end
      end
      return x
    end
  end
  for n = 1, 2 do
    local start, finish = motion_checks.smooth(job, plugin, n == 1 and x0 or draw(), draw)
    if start then
      local exact, failure = motion.to(motion.library(host, job, (setting(job, plugin, start)), {}), finish)
      if not exact then
        tap.ok(false, name .. ": the library follows the motion", happenings.said(failure))
        return
      end
      parts[#parts + 1] = { start = start, finish = finish, want = exact.x }
    end
  end
  if #parts == 0 then
    tap.ok(true, name .. ": halving h divides the stepper's error by about 16 # SKIP every motion that was " ..
      "tried has corners, where the order is 1")
    return
  end
  stepper_checks.run(job, plugin, tap, name, parts, function(a, b) return distance(job, scale, a, b) end, epsilon)
end

local function along(host, job, plugin, tap, name, random, epsilon)
  local _, x0 = setting(job, plugin)
  if contact.of(job.model) then
    local c = host.rates(numeric.scene(job)):contact(0.0, numeric.whole(job, x0))
    if not c or c[1] < 0 then
      tap.ok(true, name .. ": steppers # SKIP at the start the body does not stand on the plane")
      return
    end
  end
  steppers(host, job, plugin, tap, name, x0, random, epsilon)
  motion_checks.laws(host, job, plugin, tap, name, x0, motion_checks.span(job, plugin, x0), epsilon)
end

-- The closed form against the library's exact solver, by another road, at the tensor that the emitted code returns: the
-- scene's state and random ones, up to a million revolutions (float: a thousand, as its phases have fewer digits).
-- Bound: 18 units of the last place are promised of the emitted code (tests/emit/top.t), 1e-15 of the library.  The
-- symmetric forms are computed from the moments instead of the tensor: to each of the phases the roundings of both,
-- 2 units of them, are added.
local function closed(host, job, plugin, tap, name, random, epsilon)
  local s, x0 = setting(job, plugin)
  motion_checks.at_tensor(host, job, plugin, s)
  local scale = scales(job).rates
  local finish = 2 * math.pi / scale * (job.real == "float" and 1e3 or 1e6)
  local worst, count = 0.0, 0
  for n = 1, 100 do
    local x = n == 1 and x0 or state(job, random, scales(job), job.real)
    local times = {}
    for i, part in ipairs { 1e-6, 1e-3, 1 } do times[i] = narrow(finish * part * (1.5 + 0.5 * random()), job.real) end
    local list, wanted, why = motion_checks.both(host, job, plugin, x, numeric.from(s, job, x), "exact", times)
    if not list then
      tap.ok(false, name .. ": " .. wanted, why)
      return
    end
    for _, p in ipairs(list) do
      local got, want = p.got, p.want
      local most = largest { want[5], want[6], want[7] }
      local bound = 18 * epsilon + 1e-15
      if job.closed.kind ~= "asymmetric" then bound = bound + 2 * epsilon * most * p.t end
      for k = 1, 7 do
        worst = worse(worst, math.abs(got[k] - want[k]) / (k > 4 and most > 0 and most or 1.0) / bound)
      end
      count = count + 1
    end
  end
  tap.ok(worst <= 1, string.format("%s: the closed form is the library's, %d times up to %.0e revolutions", name, count,
    finish * scale / math.pi), string.format("%.2g of the bound", worst))
end

-- All checks of one compiled scene.
function comparison.run(host, job, plugin, tap, count)
  local real = job.real
  local name = job.model.name .. ", " .. real
  local epsilon = real == "float" and 2.0 ^ -23 or 2.0 ^ -52
  local random = drawn.numbers(0x9E3779B97F4A7C15)
  local status = plugin:init()
  local accepted = status == 0
  tap.ok(accepted, name .. ": the scene's own parameters are accepted", job.model:refusal(status))
  if not accepted then return end
  local mass, why = host.mass(numeric.scene(job))
  if not mass then
    tap.ok(false, name .. ": the library accepts the body", why)
    return
  end
  if job.model.has.rates then tensors(job, name, plugin, mass, tap, epsilon) end
  rates(host, job, plugin, tap, count, name, random, real, epsilon)
  jacobian(host, job, plugin, tap, name, random, real, epsilon)
  along(host, job, plugin, tap, name, random, epsilon)
  if job.closed.kind == "point" or job.closed.flags and job.closed.flags.flies then
    local numbers, x0 = setting(job, plugin)
    motion_checks.point(host, job, plugin, tap, name, numbers, x0, scales(job), epsilon)
  elseif job.closed.kind and not job.equations.free then
    local starts = { (select(2, setting(job, plugin))) }
    for n = 2, 5 do starts[n] = state(job, random, scales(job), real) end
    forced.run(host, job, plugin, tap, name, epsilon, scales(job).rates, starts, function(x)
      return (setting(job, plugin, x))
    end)
  elseif job.closed.full then
    closed(host, job, plugin, tap, name, random, epsilon)
  end
  if contact.of(job.model) and real == "double" then
    touch_checks.run(host, job, tap, name, random, scales(job))
  end
end

return comparison
