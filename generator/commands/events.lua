-- events.lua -- where expressions of the states change sign along a motion that can be had at any times.
--
-- Signs are compared at the ends of intervals of the scene's time.step (at most `most` of them): two crossings within
-- one are not seen.  All intervals with a change are narrowed together, one sweep over the motion a round: first into
-- `parts`, then around the chord's zero, whose error is the square of the interval's length, so that a bracket closes
-- by 32 and then by 512 at a time; where that misses it is cut into `parts` again.  The last piece, some 1e-8 of the
-- interval, goes by the chord.  The chord's error is that squared, times g''/(2 g') of the expression g: below the
-- rounding of t unless the crossing is all but tangential.
-- The motion is had in pieces, short ones where an event may end it: it goes on only where none does.
-- SPDX-License-Identifier: GPL-3.0-or-later

local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local contact = require "generator.dynamics.contact"
local happenings = require "generator.dynamics.happenings"
local numeric = require "generator.dynamics.numeric"
local columns = require "generator.commands.run.columns"
local flat = require "generator.commands.run.flat"
local rest = require "generator.commands.run.rest"
local touch = require "generator.commands.run.touch"

local events = {}

local most, parts, rounds, narrow = 100000, 16, 14, 2.0 ^ -28
local piece, short = 4096, 64 -- of the grid at once; where an event may end the motion

-- The events of a scene: its own, and what ends the run of a body on a plane: the loss of contact, and that a disc lies
-- flat (flat.lua); and that it has come to rest (rest.lua).  reaction: its value is N, which the library computes from
-- the state; motion: a function of the library's rates.
function events.of(job)
  local plane, list = contact.of(job.model), job.record.events
  local flies = not plane and job.record.landing
  if not plane and not flies then return list end
  list = { table.unpack(list) }
  if plane then
    list[#list + 1] = { name = "contact_lost", direction = -1, stop = true, line = plane.line, reaction = true,
      said = happenings.contact_lost }
  end
  for _, e in ipairs(flat.events(job, plane or flies)) do list[#list + 1] = e end
  for _, e in ipairs(rest.events(job)) do list[#list + 1] = e end
  return list
end

-- Reports what events depend on and the scene does not have: false.
function events.check(job)
  for _, e in ipairs(job.record.events) do
    for _, s in ipairs(expr.symbols(e.when)) do
      if s.rank >= motion.rank and not job.model.states.by_name[s.name] then
        local _, by_name = columns.words(job)
        if not by_name[s.name] then
          job.diag:error(e.line, "event " .. e.name, "when must be made of parameters and what this scene has: " ..
            columns.told(job), s.name)
        end
      end
    end
  end
  return not job.diag:failed()
end

-- What an event needs beyond time and states: words of columns.lua.
local function beyond(job, e, by_name)
  local list = {}
  for _, s in ipairs(expr.symbols(e.when)) do
    if s.rank >= motion.rank and not job.model.states.by_name[s.name] then list[#list + 1] = by_name[s.name] end
  end
  return list
end

-- A function that puts these words of an event into `env`; false where one has no value.
local function filler(host, job, motion_of, inputs)
  local _, by_name = columns.words(job)
  local sample, needs = columns.sampler(host, job, { course = inputs, ground = motion_of.ground }), {}
  return function(env, e, at)
    needs[e] = needs[e] or beyond(job, e, by_name)
    if #needs[e] == 0 then return true end
    local energy, L = motion_of.measured(at)
    if not energy then return false end
    local s = sample(at.t, at.x, energy, L, at.on)
    for _, w in ipairs(needs[e]) do env[w.name] = w.f(s) end
    return true
  end
end

-- The value of an event at a state {t =, x =}; nil if it is not a number there.  motion_of: what has the states.
local function valuer(host, job, motion_of, course)
  local env, touching, library = {}, touch.of(host, job), nil
  local fill
  for name, q in pairs(job.model.defaults) do env[name] = q end -- into a table: order is lost anyway
  return function(e, at)
    if e.reaction then
      local c = touching(at.t, at.x, course)
      return c and c[1] or nil
    end
    if e.motion then
      library = library or host.rates(numeric.scene(job))
      return e.motion(library, at, course)
    end
    if e.value then return e.value(at) end
    env.t = at.t
    for i, s in ipairs(job.states) do env[s.name] = at.x[i] end
    fill = fill or filler(host, job, motion_of, course)
    if not fill(env, e, at) then return nil end
    local g = evaluate.double(e.when, env)
    return g == g and g or nil
  end
end

-- Where to look within the bracket {a, b, ga, gb}: times in ascending order.
local function points(c)
  local a, b, list = c.a, c.b, {}
  if c.share then
    local zero, d = a + (b - a) * (c.ga / (c.ga - c.gb)), (b - a) * c.share
    for _, t in ipairs { zero - d, zero, zero + d } do
      if t > a and t < b and t ~= list[#list] then list[#list + 1] = t end
    end
  end
  for i = 1, #list == 0 and parts - 1 or 0 do
    local t = a + (b - a) * (i / parts)
    if t > a and t < b and t ~= list[#list] then list[#list + 1] = t end
  end
  return list
end

-- One round: of each bracket that is not narrow the first part with the change of sign.  Returns whether one was.
local function narrowed(list, solve, value)
  local times, wanted, open = {}, {}, {}
  for _, c in ipairs(list) do
    local at = not c.at and c.b - c.a > narrow * c.whole and points(c) or {}
    if #at > 0 then open[#open + 1] = { c, at } end
    for _, t in ipairs(at) do
      if not wanted[t] then times[#times + 1], wanted[t] = t, true end
    end
  end
  if #open == 0 then return false end
  table.sort(times)
  local states, why = solve(times, {})
  if not states then return nil, why end
  local at = {}
  for i, s in ipairs(states) do at[times[i]] = s end
  for _, o in ipairs(open) do
    local c, before = o[1], o[1].b - o[1].a
    for _, t in ipairs(o[2]) do
      local g = value(c.event, at[t])
      if g and g ~= 0 and (g > 0) == (c.gb > 0) then
        c.b, c.gb = t, g
        break
      elseif g and g ~= 0 then
        c.a, c.ga = t, g
      end
    end
    local closed = before / math.max(c.b - c.a, 2.0 ^ -1000)
    c.share = closed >= parts / 2 and (c.share and 2.0 ^ -10 or 2.0 ^ -6) or nil
  end
  return true
end

-- An event at a time.
local function at_once(e, t)
  return { at = t, a = t, b = t, ga = 0.0, gb = 0.0, whole = 1.0, size = 0.0, event = e }
end

-- Where signs change between two times of the grid: brackets {a, b, ga, gb, event} for the list.  seen: of each event
-- the last time and value that was not 0, from piece to piece, and of one that `stays` what waits for the next time to
-- confirm it.  Such an event may have its sign from the first: then it is there at once.
local function changes(asked, states, value, seen, list)
  for _, e in ipairs(asked) do
    local last = seen[e] or {}
    for _, s in ipairs(states) do
      local g = value(e, s)
      if g and g ~= 0 then
        local ga, waiting, c = last.g, last.waiting, nil
        if ga and (g > 0) ~= (ga > 0) and e.direction * g >= 0 then
          c = { a = last.t, b = s.t, ga = ga, gb = g, event = e, whole = s.t - last.t,
            size = math.max(math.abs(ga), math.abs(g)) }
        end
        if c and not e.stays then list[#list + 1] = c end
        if waiting and g * e.direction > 0 then list[#list + 1] = waiting end
        if e.stays and not ga and g * e.direction > 0 then c = at_once(e, s.t) end
        last = { t = s.t, g = g, waiting = e.stays and c or nil }
      elseif not g then
        last = {}
      end
    end
    seen[e] = last
  end
end

-- An event at a state of its own, or so much before as the motion from the start needs that comes to it by other steps.
local function instant(e, course, at)
  local t, back = at.t, 4 * course.epsilon * at.t
  while not course.solve({ t }, {}) and back < t do t, back = t - back, 2 * back end
  return at_once(e, t)
end

-- The event of the disc that lies flat within what is left of the motion at a state, if there is one: a bracket.
local function nearby(asked, course, at, step)
  for _, e in ipairs(asked) do
    if e.meets and e.meets(at, 2 * step, course.epsilon) then return instant(e, course, e.approach(course, at)) end
  end
  return nil
end

-- The last state before the motion fails after `last` at t, and how far from it the motion fails.
local function reached(course, last, t)
  local back, failed = 2 * course.epsilon * t, t
  for _ = 1, 60 do
    if t - back <= last.t then break end
    local list, why = course.solve({ t - back }, { from = last })
    if list then return list[1], failed - list[1].t end
    failed = why.t or t - back
    t, back = math.min(t, failed), 2 * back
  end
  return last, failed - last.t
end

-- Where the motion fails between `last` and the times of the grid: the list, if an event that stops it comes before.
local function failing(asked, course, value, why, grid, last, seen, list)
  local times, stops = {}, false
  for _, t in ipairs(grid) do
    if t < (why.t or 0) then times[#times + 1] = t end
  end
  local states = #times > 0 and course.solve(times, { from = last }) or {}
  changes(asked, states, value, seen, list)
  last = states[#states] or last
  for _, e in ipairs(asked) do
    list[#list + 1] = seen[e] and seen[e].waiting
    if e.within and last and why.t and why.t > last.t then
      local at, tick = reached(course, last, why.t)
      if e.within(at, tick) then list[#list + 1] = instant(e, course, at) end
    end
  end
  for _, c in ipairs(list) do stops = stops or c.event.stop end
  if stops then return list end
  return nil, why
end

-- The reaction at the start where it is negative, or nil.
local function pull(asked, start, value)
  for _, e in ipairs(asked) do
    local N = e.reaction and value(e, start)
    if N and N < 0 then return N end
  end
  return nil
end

-- An event that holds from the start is confirmed before the next time of the grid, if the disc would be flat by then:
-- the time for that, or nil.
local function soon(asked, seen, t, step)
  for _, e in ipairs(asked) do
    local s = seen[e]
    local wait = s and s.waiting and s.waiting.at and e.confirm(s.g)
    if wait and wait < step then return t + wait end
  end
  return nil
end

-- Narrows all brackets; true, or nil and what went wrong.
local function settled(list, solve, value)
  for _ = 1, rounds do
    local more, wrong = narrowed(list, solve, value)
    if wrong then return nil, wrong end
    if not more then break end
  end
  return true
end

-- Is there a zero in the bracket, and no pole?
local function is_zero(c) return math.min(math.abs(c.ga), math.abs(c.gb)) <= c.size end

-- Does an event of the list end the motion? Or nil and what went wrong.
local function ending(list, course, value)
  local any = false
  for _, c in ipairs(list) do any = any or c.event.stop end
  if not any then return false end
  local done, wrong = settled(list, course.solve, value)
  if not done then return nil, wrong end
  for _, c in ipairs(list) do
    if c.event.stop and is_zero(c) then return true end
  end
  return false
end

-- The brackets of the whole motion, from piece to piece, so that not all of its states are there at once, up to an
-- event that ends it.
local function brackets(asked, course, value, finish, step)
  local n, list, seen, last = math.max(1, math.min(most, math.ceil(finish / step))), {}, {}, nil
  local first, size, disc = 0, piece, nil
  for _, e in ipairs(asked) do
    disc = e.size and e or disc
    size = e.stop and short or size
  end
  if disc then size = 1 end
  while first <= n do
    local grid = {}
    grid[1] = last and soon(asked, seen, last.t, finish / n)
    for i = first, math.min(first + size - 1, n) do grid[#grid + 1] = i == n and finish or finish * (i / n) end
    local states, why = course.solve(grid, { from = last })
    if not states then return failing(asked, course, value, why, grid, last, seen, list) end
    last = states[#states]
    local pulled = first == 0 and pull(asked, states[1], value)
    if pulled then
      return nil, { status = 3, t = 0.0, text = string.format("the plane would have to pull the body: N = %.4g N " ..
        "(effect.plane has impact for bodies that fly)", pulled) }
    end
    changes(asked, states, value, seen, list)
    list[#list + 1] = disc and last.t < finish and nearby(asked, course, last, finish / n) or nil
    local over, wrong = ending(list, course, value)
    if wrong then return nil, wrong end
    if over then break end
    first, size = first + size, disc and disc.size(last, finish / n) or size
  end
  return list
end

-- The events from 0 to `finish` in the order of time: a list of {event, row}, cut after the first that stops; or nil
-- and what went wrong.  course: the motion, engines.lua; solve(times) -> rows of the table; inputs:
-- the scene's over time, or nil; asked: those of events.of that are looked for, nil: all.
function events.find(host, job, course, solve, finish, step, inputs, asked)
  local value = valuer(host, job, course, inputs)
  local list, why = brackets(asked or events.of(job), course, value, finish, step)
  if not list then return nil, why end
  if #list == 0 then return {} end
  local done, failure = settled(list, course.solve, value)
  if not done then return nil, failure end
  local zeros = {}
  for i, c in ipairs(list) do
    c.t, c.place = c.at or c.a + (c.b - c.a) * (c.ga / (c.ga - c.gb)), i
    if is_zero(c) then zeros[#zeros + 1] = c end -- else a pole
  end
  list = zeros
  table.sort(list, function(a, b) return a.t < b.t or a.t == b.t and a.place < b.place end)
  local times, out = {}, {}
  for i, c in ipairs(list) do
    times[i] = c.t
    if c.event.stop then break end
  end
  local single = {} -- equal times once
  for i, t in ipairs(times) do
    if t ~= times[i - 1] then single[#single + 1] = t end
  end
  local rows, wrong = solve(single)
  if not rows then return nil, wrong end
  local k = 0
  for i, t in ipairs(times) do
    if t ~= times[i - 1] then k = k + 1 end
    out[i] = { event = list[i].event, row = rows[k] }
  end
  return out
end

-- What ends a motion before `finish`, for what shows it: an event with its row (a state) and `said`, what it is in
-- words; nil if nothing does.  Or false and a failure, also where the motion ends at the start.
function events.ending(host, job, course, finish, inputs)
  local step, ends = course.step or job.model:double(job.model.step), {}
  for _, e in ipairs(events.of(job)) do ends[#ends + 1] = e.stop and e or nil end
  if #ends == 0 then return nil end
  local function solve(ts) return course.solve(ts, {}) end
  local found, failure = events.find(host, job, course, solve, finish, step, inputs, ends)
  if not found then return false, failure end
  local first = found[1]
  if first then first.said = first.event.said or "event " .. first.event.name end
  if first and first.row.t == 0 then
    return false, { status = 3, t = 0.0, text = first.said .. ": there is no motion to show" }
  end
  return first
end

return events
