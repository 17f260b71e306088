-- motion_checks.lua -- checks of `polhode check` along a motion: what is conserved, and the closed form of a point.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local breaks = require "generator.dynamics.breaks"
local switching = require "generator.dynamics.switching"
local contact = require "generator.dynamics.contact"
local happenings = require "generator.dynamics.happenings"
local motion = require "generator.dynamics.motion"
local numeric = require "generator.dynamics.numeric"

local motion_checks = {}

local function largest(v)
  local m = 0.0
  for i = 1, #v do m = math.max(m, v[i] ~= v[i] and math.huge or math.abs(v[i])) end
  return m
end

-- The largest rate in the Jacobian: |J_ik J_ki|^(1/2) is one whatever the states' units are.
local function rate_of(plugin, x0)
  local J, n, rate = plugin:jacobian(0, x0), #x0, 0.0
  for i = 1, n do
    for k = 1, n do
      rate = math.max(rate, math.sqrt(math.abs(J[(i - 1) * n + k] * J[(k - 1) * n + i])))
    end
  end
  return rate
end

-- On a plane a body may become faster by far than it started (a disc that falls flat, in microseconds): the part of the
-- span, in 64 parts, in which it turns by some six radians of its largest rate so far, and before a step that is fine
-- for the start is too long for what follows: rates by half of it differ by more than 1e-6 (float: 1e-3).
local function faster(job, plugin, x0, span)
  local m, most = motion.emitted(job, plugin, { x = x0 }), 0.0
  local coarse, finer
  for k = 1, 64 do
    local t, off = span * k / 64, 0.0
    coarse = motion.to(m, t, { from = coarse, step = span / 256 })
    finer = coarse and motion.to(m, t, { from = finer, step = span / 512 })
    if not finer then return t / 2 end
    for i, s in ipairs(job.states) do
      if s.kind == "rates" then
        most, off = math.max(most, math.abs(coarse.x[i])), math.max(off, math.abs(coarse.x[i] - finer.x[i]))
      end
    end
    if off > (job.real == "float" and 1e-3 or 1e-6) * most then return t / 2 end
    if most * t > 6 then return t end
  end
  return span
end

-- A span of some four radians of the fastest rate, of w and, with effects, of the Jacobian (1 where both are 0); not
-- beyond the scene's own horizon where something moves away, nor beyond a corner of a table.
function motion_checks.span(job, plugin, x0)
  local rate = 0.0
  for i, s in ipairs(job.states) do
    if s.kind == "rates" then rate = math.max(rate, math.abs(x0[i])) end
  end
  if not job.equations.free then rate = math.max(rate, rate_of(plugin, x0)) end
  if rate == 0 then rate = 1.0 end
  local horizon, first = job.model:double(job.model.horizon), breaks.first(job.equations)
  if first and rate * R.todouble(first) < 4 then return R.todouble(first) end
  if job.model.has.position and rate * horizon < 4 then return horizon end
  local span = 4.0 / rate
  return contact.of(job.model) and faster(job, plugin, x0, math.min(span, horizon)) or span
end

-- A motion without corners at unknown times, on which a stepper has its order: its start and span.  draw() gives random
-- states, which are tried after x0, each also for a sixteenth of its span.  nil if all have corners.
function motion_checks.smooth(job, plugin, x0, draw)
  local corners, values = switching.values(job.equations)
  local steps = 256
  -- no corner lies between samples that stay further from 0 than they move
  local function clear(list)
    local before, move, near = {}, 0.0, math.huge
    for _, s in ipairs(list) do
      for k, value in ipairs(values(s.t, s.x)) do
        move = math.max(move, before[k] and math.abs(value - before[k]) or 0.0)
        if before[k] and value * before[k] <= 0 then return false end
        near, before[k] = math.min(near, math.abs(value)), value
      end
    end
    return near > 2 * move
  end
  for n = 0, corners > 0 and 20 or 0 do
    local x = n == 0 and x0 or draw()
    local finish = motion_checks.span(job, plugin, x)
    if corners == 0 then return x, finish end
    for _, span in ipairs { finish, finish / 16 } do
      local times = {}
      for k = 0, steps do times[k + 1] = span * k / steps end
      local list = motion.emitted(job, plugin, { x = x, step = span / steps }).solve(times, {})
      if list and clear(list) then return x, span end
    end
  end
  return nil
end

-- What the scene conserves, along the emitted stepper's own motion.
function motion_checks.laws(host, job, plugin, tap, name, x0, finish, epsilon)
  local law = job.conserved.is
  local turns = job.equations.free and finish * 25 or finish
  local last, failure = motion.to(motion.emitted(job, plugin, { x = x0, step = finish / 256 }), turns)
  if not last then
    tap.ok(false, name .. ": the emitted steps follow the motion", happenings.said(failure))
    return
  end
  local x = last.x
  -- 6400 steps: rounding grows like their square root, the method's own error is (h w)^4 of a turn
  local bound = 4096 * epsilon + (4.0 / 256) ^ 4
  local span = string.format("%.3g s", turns)
  local function keeps(what, error, size)
    tap.ok(size < math.huge and error <= bound * size, name .. ": " .. what .. " is conserved over " .. span,
      string.format("%.2g of %.3g", error, size))
  end
  if law["T+V"] then
    local E0, E, size = plugin:energy(x0), plugin:energy(x), 0.0
    local library = host.rates(numeric.scene(job))
    for _, y in ipairs { x0, x } do
      local _, terms = library:energy(numeric.whole(job, y))
      size = math.max(size, terms)
    end
    keeps("energy", math.abs(E - E0), job.equations.free and math.abs(E0) or size)
  end
  if job.conserved.rate then -- its terms: of T + V, n L_z, and the potential of what turns, which is the rest
    local J0, J, size = plugin:integral(0, x0), plugin:integral(turns, x), 0.0
    local library, n = host.rates(numeric.scene(job)), job.model:double(job.conserved.rate)
    for _, y in ipairs { x0, x } do
      local E, terms = library:energy(numeric.whole(job, y))
      local turned = n * plugin:momentum(y)[3]
      size = math.max(size, terms + math.abs(turned) + math.abs(J0 - E + turned))
    end
    keeps("Jacobi's integral", math.abs(J - J0), size)
  end
  if job.model.has.attitude and (law.L or law["|L|"] or law.L_z) then
    local L0, L = plugin:momentum(x0), plugin:momentum(x)
    local function norm(v) return math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2) end
    if law.L then
      keeps("angular momentum", largest { L[1] - L0[1], L[2] - L0[2], L[3] - L0[3] }, largest(L0))
    elseif law["|L|"] then
      keeps("the length of L", math.abs(norm(L) - norm(L0)), norm(L0))
    end
    if law.L_z and not law.L then keeps("L_z", math.abs(L[3] - L0[3]), math.max(norm(L), norm(L0))) end
  end
  if law.w3 then
    for i, s in ipairs(job.states) do
      if s.name == "wz" then keeps("w3", math.abs(x[i] - x0[i]), math.abs(x0[i])) end
    end
  end
end

-- Gives the library's scene s the tensor that the emitted code returns; a rod stays, as a rounded tensor is none.
function motion_checks.at_tensor(host, job, plugin, s)
  if job.model.structure.rod then return end
  local I, mass = plugin:inertia(), host.mass(s)
  s.body = { shape = "tensor", mass = mass.mass, com = { 0.0, 0.0, 0.0 }, about = "com", xx = I[1], yy = I[2],
    zz = I[3], xy = I[4], xz = I[5], yz = I[6], formal = job.model.unlawful }
  s.origin = { 0.0, 0.0, 0.0 }
end

-- The closed form and the library's motion from x side by side: a list of {t, got, want}, states; or nil, what should
-- have been, and why it is not.  numbers: the library's scene from x.
function motion_checks.both(host, job, plugin, x, numbers, method, times)
  local closed = motion.emitted(job, plugin, { x = x, method = "exact" })
  if not closed then return nil, "the closed form accepts the initial state" end
  local want, failure = motion.library(host, job, numbers, { method = method }).solve(times, {})
  if not want then return nil, "the library follows the motion", happenings.said(failure) end
  local got, wrong = closed.solve(times)
  if not got then return nil, "the closed form follows the motion", happenings.said(wrong) end
  for i, s in ipairs(want) do got[i] = { t = s.t, got = got[i].x, want = s.x } end
  return got
end

-- The closed form of a point against the library's integration, to ten times the scene's horizon.  The emitted
-- constants are rounded to the real type, half a unit each, which the phases carry on; 16 operations and the turn add
-- to that.
function motion_checks.point(host, job, plugin, tap, name, numbers, x0, scale, epsilon)
  local horizon, worst = job.model:double(job.model.horizon), 0.0
  local list, wanted, why = motion_checks.both(host, job, plugin, x0, numbers, "adaptive",
    { horizon / 10, horizon, 10 * horizon })
  if not list then
    tap.ok(false, name .. ": " .. wanted, why)
    return
  end
  local rate = rate_of(plugin, x0)
  for _, p in ipairs(list) do
    local t, got, want, size = p.t, p.got, p.want, {}
    for k, s in ipairs(job.states) do
      size[s.kind] = math.max(size[s.kind] or scale[s.kind], math.abs(want[k]))
    end
    for k, s in ipairs(job.states) do
      worst = math.max(worst, largest { got[k] - want[k] } / (size[s.kind] * epsilon * (32 + 4 * rate * t)))
    end
  end
  tap.ok(worst <= 1, name .. ": the closed form agrees with the library's integration",
    string.format("%.2g of the bound", worst))
end

return motion_checks
