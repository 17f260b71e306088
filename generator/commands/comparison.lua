-- comparison.lua -- one emitted, compiled scene against the general library: the checks of `polhode check`.
--
-- Random numbers come from a fixed seed, so a failure repeats.  Parameters are drawn within a factor 2 of their
-- defaults and kept when the emitted NAME_init accepts them; the library then gets the same doubles.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local numeric = require "generator.dynamics.numeric"
local selftest = require "generator.emit.selftest"

local comparison = {}

-- xorshift64*: the same sequence on every machine (Marsaglia 2003, Vigna 2016)
local function generator(seed)
  local s = seed
  return function() -- uniform in (-1, 1)
    s = s ~ (s >> 12)
    s = s ~ (s << 25)
    s = s ~ (s >> 27)
    return ((s * 2685821657736338717) >> 11) * 2.0 ^ -52 - 1
  end
end

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

-- A double that the scene's real type holds exactly.
local function narrow(x, real)
  if real == "float" then return string.unpack("f", string.pack("f", x)) end
  return x
end

local function state(random, scale, real)
  local q, n = {}, 0
  for i = 1, 4 do q[i] = random() end
  for i = 1, 4 do n = n + q[i] * q[i] end
  n = math.sqrt(n)
  if n < 0.1 then return state(random, scale, real) end
  for i = 1, 4 do q[i] = narrow(q[i] / n, real) end
  for i = 5, 7 do q[i] = narrow(random() * scale, real) end
  return q
end

local function input(job, random, scale, real)
  for _, e in ipairs(job.record.effects) do -- the library's input has no limit: stay below the scene's
    if e.a.max then scale = math.min(scale, job.model:double(e.a.max)) end
  end
  return { narrow(random() * scale, real), narrow(random() * scale, real), narrow(random() * scale, real) }
end

-- Parameters: the scene's own, then random ones.
local function parameters(job, random, plugin, real)
  for _ = 1, 100 do
    local list, values = {}, {}
    for i, p in ipairs(job.model.params) do
      local x = narrow(R.todouble(p.default) * 2.0 ^ random(), real)
      list[i], values[p.name] = x, R.fromdouble(x)
    end
    if plugin:init(list) == 0 then return values end
  end
  return nil
end

local function ratio(got, want, scale, epsilon)
  if got ~= got then return math.huge end
  local d = math.abs(got - want)
  if d == 0 then return 0.0 end
  return d / (scale * epsilon)
end

-- Largest |w| that the scene is about.
local function rate_scale(job)
  local m = job.model
  local s = 0.0
  for i = 1, 3 do s = math.max(s, math.abs(m:double(m.omega[i]))) end
  return s > 0 and s or 1.0
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

local function rates(host, job, plugin, tap, count, name, random, real, epsilon)
  local scale, worst, energy, momentum, states, most = rate_scale(job), 0.0, 0.0, 0.0, 0, 1.0
  local sets = #job.model.params > 0 and 20 or 1
  for set = 1, sets do
    local values = set > 1 and parameters(job, random, plugin, real) or nil
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
    for _ = 1, count // sets do
      local x = state(random, scale, real)
      local u = job.equations.inputs and input(job, random, scale, real) or nil
      local want, size = library:rates(0, x, u)
      local got = plugin:rhs(0, x, u)
      for k = 1, 7 do
        if size[k] > 0 or want[k] ~= 0 or got[k] ~= 0 then
          worst = worse(worst, ratio(got[k], want[k], size[k] * factor, epsilon))
        end
      end
      local E, Es = library:energy(x)
      energy = worse(energy, ratio(plugin:energy(x), E, Es * factor, epsilon))
      local L, Ls = library:momentum(x)
      local M = plugin:momentum(x)
      for k = 1, 3 do momentum = worse(momentum, ratio(M[k], L[k], Ls * factor, epsilon)) end
      states = states + 1
    end
  end
  local where = string.format(" over %d states and %d sets of parameters%s", states, sets, said(most))
  tap.ok(worst <= 8, name .. ": rates of change to 8 ulp of the largest term" .. where, string.format("%.2f", worst))
  tap.ok(energy <= 8, name .. ": energy to 8 ulp of the largest term" .. where, string.format("%.2f", energy))
  tap.ok(momentum <= 8, name .. ": momentum to 8 ulp of the largest term" .. where, string.format("%.2f", momentum))
end

-- The equations are polynomials of degree 2 in the state (Euler, and R(q) applied to a constant), so central
-- differences have no error but rounding: a few eps of the terms of the rates over the step d.
local function jacobian(host, job, plugin, tap, name, random, real, epsilon)
  plugin:init()
  local scale, factor = rate_scale(job), cancellation(job)
  local worst = 0.0
  local library, why = host.rates(numeric.scene(job))
  if not library then
    tap.ok(false, name .. ": the library accepts the scene", why)
    return
  end
  for _ = 1, 10 do
    local x = state(random, scale, real)
    local J = plugin:jacobian(0, x)
    local _, terms = library:rates(0, x)
    local rhs_scale = math.max(largest(plugin:rhs(0, x)), largest(terms))
    for k = 1, 7 do
      local d = (k > 4 and scale or 1.0) * 2.0 ^ -10
      local up, down = { table.unpack(x) }, { table.unpack(x) }
      up[k], down[k] = narrow(x[k] + d, real), narrow(x[k] - d, real)
      local a, b = plugin:rhs(0, up), plugin:rhs(0, down)
      for i = 1, 7 do
        local difference = (a[i] - b[i]) / (up[k] - down[k])
        local size = math.max(rhs_scale, largest(a)) / d
        worst = worse(worst, math.abs(J[(i - 1) * 7 + k] - difference) / (size * 16 * factor * epsilon))
      end
    end
  end
  tap.ok(worst <= 1, name .. ": Jacobian as central differences of the rates",
    string.format("%.2g of the bound%s", worst, said(factor)))
end

local function distance(a, b)
  local d = 0.0
  for i = 1, 7 do d = worse(d, math.abs(a[i] - b[i])) end
  return d
end

-- The initial state of the scene and its numeric form with the tensor that the emitted code uses.
local function setting(job, plugin)
  plugin:init()
  local s = numeric.scene(job)
  local real = job.real
  local x = { s.q[1], s.q[2], s.q[3], s.q[4], s.w[1], s.w[2], s.w[3] }
  for i = 1, 7 do x[i] = narrow(x[i], real) end
  s.q, s.w = { table.unpack(x, 1, 4) }, { table.unpack(x, 5, 7) }
  return s, x
end

local function motion(host, job, plugin, tap, name, epsilon)
  local s, x0 = setting(job, plugin)
  local scale = rate_scale(job)
  local finish = 4.0 / scale
  local exact, why = host.run(s, { method = "adaptive", times = { finish } })
  if not exact then
    tap.ok(false, name .. ": the library follows the motion", why)
    return
  end
  local want = { table.unpack(exact[1], 2, 8) }
  local errors = {}
  -- float: longer steps, whose error still stands far above rounding
  for i, steps in ipairs(job.real == "float" and { 32, 64 } or { 64, 128 }) do
    local rows = plugin:integrate(x0, nil, finish / steps, { finish })
    errors[i] = distance({ table.unpack(rows[1], 2, 8) }, want)
  end
  local floor = 256 * epsilon * math.max(1.0, scale)
  tap.ok(errors[2] <= errors[1] / 12 + floor, name .. ": halving h divides the stepper's error by about 16",
    string.format("%.3g, %.3g", errors[1], errors[2]))
  if job.equations.free then
    local turns = finish * 25
    local row = plugin:integrate(x0, nil, finish / 256, { turns })[1]
    local x = { table.unpack(row, 2, 8) }
    local E0, E = plugin:energy(x0), plugin:energy(x)
    local L0, L = plugin:momentum(x0), plugin:momentum(x)
    -- 6400 steps: rounding grows like their square root, the method's own error is (h w)^4 of a turn
    local bound = 4096 * epsilon + (4.0 / 256) ^ 4
    local span = string.format("%.3g s", turns)
    tap.ok(math.abs(E - E0) <= bound * math.abs(E0), name .. ": energy is conserved over " .. span)
    tap.ok(largest { L[1] - L0[1], L[2] - L0[2], L[3] - L0[3] } <= bound * largest(L0),
      name .. ": angular momentum is conserved over " .. span)
  end
end

-- The closed form against the library's exact solver, by another road, at the tensor that the emitted code returns: the
-- scene's state and random ones, up to a million revolutions (float: a thousand, as its phases have fewer digits).
-- Bound: 18 units of the last place are promised of the emitted code (tests/emit/top.t), 1e-15 of the library.  The
-- symmetric forms are computed from the moments instead of the tensor: to each of the phases the roundings of both,
-- 2 units of them, are added.
local function closed(host, job, plugin, tap, name, random, epsilon)
  local s, x0 = setting(job, plugin)
  local I, mass = plugin:inertia(), host.mass(s)
  local rod = job.model.structure.rod -- a rounded tensor is no rod any more: there the shapes themselves are compared
  local t = { shape = "tensor", mass = mass.mass, com = { 0.0, 0.0, 0.0 }, about = "com", xx = I[1], yy = I[2],
    zz = I[3], xy = I[4], xz = I[5], yz = I[6] }
  if not rod then s.body, s.origin = t, { 0.0, 0.0, 0.0 } end
  local scale = rate_scale(job)
  local finish = 2 * math.pi / scale * (job.real == "float" and 1e3 or 1e6)
  local worst, count = 0.0, 0
  for n = 1, 100 do
    local x = n == 1 and x0 or state(random, scale, job.real)
    s.q, s.w = { table.unpack(x, 1, 4) }, { table.unpack(x, 5, 7) }
    local times = {}
    for i, part in ipairs { 1e-6, 1e-3, 1 } do times[i] = narrow(finish * part * (1.5 + 0.5 * random()), job.real) end
    local rows, why = host.run(s, { method = "exact", times = times })
    if not rows or plugin:solve(x) ~= 0 then
      tap.ok(false, name .. ": library and closed form accept the state", why)
      return
    end
    for i, time in ipairs(times) do
      local got, want = plugin:at(time), { table.unpack(rows[i], 2, 8) }
      local most = largest { want[5], want[6], want[7] }
      local bound = 18 * epsilon + 1e-15
      if job.closed.kind ~= "asymmetric" then bound = bound + 2 * epsilon * most * time end
      for k = 1, 7 do
        worst = worse(worst, math.abs(got[k] - want[k]) / (k > 4 and most > 0 and most or 1.0) / bound)
      end
      count = count + 1
    end
  end
  tap.ok(worst <= 1, string.format("%s: the closed form is the library's, %d times up to %.0e revolutions", name, count,
    finish * scale / math.pi), string.format("%.2g of the bound", worst))
end

-- A closed form of forced motion from the scene's state, a hundred revolutions, against the library's Taylor series,
-- whose steps of 1e-15 each have grown to 1e-12 by then.  Each phase has the roundings of the constants in both.
local function forced(host, job, plugin, tap, name, _, epsilon)
  local s, x0 = setting(job, plugin)
  local scale = rate_scale(job)
  local times, worst = {}, 0.0
  for i, turns in ipairs { 0.3, 7, 100 } do times[i] = narrow(2 * math.pi * turns / scale, job.real) end
  local rows, why = host.run(s, { method = "adaptive", times = times })
  if not rows or plugin:solve(x0) ~= 0 then
    tap.ok(false, name .. ": library and closed form accept the state", why)
    return
  end
  for i, time in ipairs(times) do
    local got, want = plugin:at(time), { table.unpack(rows[i], 2, 8) }
    local most = math.max(scale, largest { want[5], want[6], want[7] })
    local bound = 18 * epsilon + 1e-12 + 4 * epsilon * most * time
    for k = 1, 7 do worst = worse(worst, math.abs(got[k] - want[k]) / (k > 4 and most or 1.0) / bound) end
  end
  tap.ok(worst <= 1, name .. ": the closed form is the library's motion over 100 revolutions",
    string.format("%.2g of the bound", worst))
end

-- All checks of one compiled scene.
function comparison.run(host, job, plugin, tap, count)
  local real = job.real
  local name = job.model.name .. ", " .. real
  local epsilon = real == "float" and 2.0 ^ -23 or 2.0 ^ -52
  local random = generator(0x9E3779B97F4A7C15)
  tap.ok(plugin:init() == 0, name .. ": the scene's own parameters are accepted")
  local mass, why = host.mass(numeric.scene(job))
  if not mass then
    tap.ok(false, name .. ": the library accepts the body", why)
    return
  end
  tensors(job, name, plugin, mass, tap, epsilon)
  rates(host, job, plugin, tap, count, name, random, real, epsilon)
  jacobian(host, job, plugin, tap, name, random, real, epsilon)
  motion(host, job, plugin, tap, name, epsilon)
  if job.closed.full then
    local compare = job.equations.free and closed or forced
    compare(host, job, plugin, tap, name, random, epsilon)
  end
end

return comparison
