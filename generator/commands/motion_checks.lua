-- motion_checks.lua -- checks of `polhode check` along a motion: what is conserved, and the closed form of a point.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local breaks = require "generator.dynamics.breaks"
local switching = require "generator.dynamics.switching"
local contact = require "generator.dynamics.contact"
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
  local times, most = {}, 0.0
  for k = 1, 64 do times[k] = span * k / 64 end
  local finer = plugin:integrate(x0, nil, span / 512, times)
  for k, row in ipairs(plugin:integrate(x0, nil, span / 256, times)) do
    local off = 0.0
    for i, s in ipairs(job.states) do
      if s.kind == "rates" then
        most, off = math.max(most, math.abs(row[i + 1])), math.max(off, math.abs(row[i + 1] - finer[k][i + 1]))
      end
    end
    local same = off <= (job.real == "float" and 1e-3 or 1e-6) * most -- false of NaN
    if not same then return row[1] / 2 end
    if most * row[1] > 6 then return row[1] end
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
  local function clear(rows)
    local before, move, near = {}, 0.0, math.huge
    for _, row in ipairs(rows) do
      for k, value in ipairs(values(row[1], { table.unpack(row, 2) })) do
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
      if clear(plugin:integrate(x, nil, span / steps, times)) then return x, span end
    end
  end
  return nil
end

-- What the scene conserves, along the emitted stepper's own motion.
function motion_checks.laws(host, job, plugin, tap, name, x0, finish, epsilon)
  local law = job.conserved.is
  local turns = job.equations.free and finish * 25 or finish
  local x = { table.unpack(plugin:integrate(x0, nil, finish / 256, { turns })[1], 2) }
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

-- The closed form of a point against the library's integration, to ten times the scene's horizon.  The emitted
-- constants are rounded to the real type, half a unit each, which the phases carry on; 16 operations and the turn add
-- to that.
function motion_checks.point(host, job, plugin, tap, name, numbers, x0, scale, epsilon)
  if plugin:solve(x0) ~= 0 then
    tap.ok(false, name .. ": the closed form accepts the initial state")
    return
  end
  local horizon, worst = job.model:double(job.model.horizon), 0.0
  local times = { horizon / 10, horizon, 10 * horizon }
  local rows, why = host.run(numbers, { method = "adaptive", times = times })
  if not rows then
    tap.ok(false, name .. ": the library follows the motion", why)
    return
  end
  local rate = rate_of(plugin, x0)
  for i, t in ipairs(times) do
    local got, want, size = plugin:at(t), numeric.part(job, rows[i], 1), {}
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
