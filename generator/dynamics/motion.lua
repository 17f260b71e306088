-- motion.lua -- a scene's motion at given times, whoever computes it: one kind of object for all commands.
--
--     motion.emitted(job, plugin, way)    the emitted code, by its closed form for the method "exact", else by steps;
--         nil and a failure where the closed form refuses the start.  way: {method =, x = start (nil: the scene's own),
--         step = or tolerance =, most = steps between two times, course = the inputs over time or what they are held
--         at, corners = times at which fixed steps shall end too, dated = a failure says at which time, which takes 40
--         runs more}; with {peer = name, patience = s} by an integrator of others around the emitted rates.  A plugin
--         has one orbit: the next closed motion that is made of it takes it over
--     motion.library(host, job, numbers, way)    the general library from a scene of numeric.scene.  way: {method =,
--         step = or tolerance =, most =, course =, seen = function(t)}
-- A motion is the table `way` that it is made from, with
--     solve(times, o)   a list of {t =, x = state as the scene has it, ...}, all numbers finite and |q| near 1, and of
--                       emitted steps their number; or nil and a failure {status =, text =, t = when it went wrong}.
--                       o: {step = another step, tolerance = another, from = one of these states, to start there}
--     measured(state)   its energy and L, or nil and a failure
--     stiff             of the library: what was had of it turned to an implicit method
-- SPDX-License-Identifier: GPL-3.0-or-later

local happenings = require "generator.dynamics.happenings"
local numeric = require "generator.dynamics.numeric"

local motion = {}

local function failed(t, text) return nil, { status = 3, t = t, text = text } end

-- The state at the time t alone; or nil and the failure.
function motion.to(m, t, o)
  local list, failure = m.solve({ t }, o or {})
  return list and list[1], failure
end

local function finite(list)
  for _, x in ipairs(list) do
    if x - x ~= 0 then return false end
  end
  return true
end

-- Rows {t, x...} as states.
local function states(rows)
  local list = {}
  for i, row in ipairs(rows) do list[i] = { t = row[1], x = { table.unpack(row, 2) } } end
  return list
end

-- The states, or nil and the failure where one of them is none.  job: of emitted steps, which lose |q| (it is not 1 to
-- some per cent) with an h |w| beyond what the method can do.  As templates/sweep/members.c has it.
local function sound(list, job)
  for _, s in ipairs(list) do
    if not finite(s.x) then return failed(s.t, happenings.infinite) end
    local square = job and job.model.has.attitude and 0.0 or 1.0
    for i, state in ipairs(square == 0 and job.states or {}) do
      square = square + (state.kind == "attitude" and s.x[i] ^ 2 or 0.0)
    end
    if not (square >= 0.9 and square <= 1.1) then return failed(s.t, happenings.long_step) end
  end
  return list
end

-- ---- the emitted code ----

-- The times and the corners of tables between them, where fixed steps shall end too: over a corner a step has no order.
-- Second result: which of them were asked for.
local function with_corners(times, corners, from)
  local all, asked, c = {}, {}, 1
  for _, t in ipairs(times) do
    while corners[c] and corners[c] < t do
      if corners[c] > from then all[#all + 1] = corners[c] end
      c = c + 1
    end
    all[#all + 1] = t
    asked[#all] = true
    while corners[c] and corners[c] <= t do c = c + 1 end
    from = math.max(from, t)
  end
  return all, asked
end

-- When steps of the tolerance's choice, which reached `last` of the times, lead no further.  reach(from, t): the state
-- at t, or nil.
local function ended(reach, from, times, last)
  local t, middle = times[#times], last
  for i = #times, 1, -1 do t = (times[i - 1] or from.t) == last and times[i] or t end
  for _ = 0, 40 do
    if middle ~= from.t and middle ~= t then
      local s = reach(from, middle)
      if s then from = s else t = middle end
    end
    middle = from.t + (t - from.t) / 2
  end
  return t
end

local function stepped(job, plugin, way, start)
  local function integrate(from, times, step, tolerance)
    if way.peer then return plugin:peer(way.peer, step or tolerance, from.x, times, nil, way.patience) end
    return plugin:integrate(from.x, way.course, step or { tolerance, way.most }, times, from.t, way.method)
  end
  return function(asked, o)
    local from, step, tolerance = o.from or start, o.step or way.step, o.tolerance or way.tolerance
    local times, wanted = asked, nil
    if step and way.corners then times, wanted = with_corners(asked, way.corners, from.t) end
    local rows, steps, infinite = integrate(from, times, step, tolerance)
    if not rows then
      return failed(way.dated and ended(function(s, t)
        local row = integrate(s, { t }, nil, tolerance)
        return row and states(row)[1]
      end, from, times, steps) or nil, happenings.no_steps)
    end
    if infinite then return failed(infinite, happenings.infinite) end
    local list, failure = sound(states(rows), job)
    if not list then return nil, failure end
    local kept = {}
    for i, s in ipairs(list) do kept[#kept + 1] = (not wanted or wanted[i]) and s or nil end
    return kept, steps
  end
end

local function closed(plugin)
  return function(times)
    local list = {}
    for i, t in ipairs(times) do list[i] = { t = t, x = plugin:at(t) } end
    return sound(list)
  end
end

function motion.emitted(job, plugin, way)
  local start = { t = 0.0, x = way.x or numeric.initial(job) }
  if way.method ~= "exact" then
    way.solve = stepped(job, plugin, way, start)
  elseif plugin:solve(start.x) == 0 then
    way.solve = closed(plugin)
  else
    return failed(nil, "the closed form refuses the initial state")
  end
  function way.measured(state)
    local energy, L = plugin:energy(state.x), job.model.has.attitude and plugin:momentum(state.x) or {}
    if not finite { energy } then return failed(state.t, "the energy is not finite") end
    if not finite(L) then return failed(state.t, "the angular momentum is not finite") end
    return energy, L
  end
  return way
end

-- ---- the general library ----

function motion.library(host, job, numbers, way)
  function way.solve(times, o)
    local rows, why, kind, t = host.run(o.from and numeric.from(numbers, job, o.from.x) or numbers, {
      method = way.method, step = o.step or way.step, tol = o.tolerance or way.tolerance, most = way.most,
      times = times, u = way.course, seen = way.seen, t0 = o.from and o.from.t or 0.0 })
    if not rows then
      return nil, { status = kind == "numbers" and 3 or 2, t = t, text = string.gsub(why, "^at t = %S+ s: ", "") }
    end
    way.stiff = way.stiff or way.method ~= "implicit" and why > 0
    for i, row in ipairs(rows) do
      local n = #row - 4
      rows[i] = { t = row[1], x = numeric.part(job, row, 1), energy = row[n + 1], L = { table.unpack(row, n + 2) } }
    end
    return rows
  end
  function way.measured(state) return state.energy, state.L end
  return way
end

return motion
