-- events.lua -- where expressions of the states change sign along a motion that can be had at any times.
--
-- Signs are compared at the ends of intervals of the scene's time.step (at most `most` of them): two crossings within
-- one are not seen.  Each interval with a change is cut into `parts` again and again, all intervals in one sweep over
-- the motion, and its last piece, some 1e-8 of the interval, by the chord.  The chord's error is that squared, times
-- g''/(2 g') of the expression g: below the rounding of t unless the crossing is all but tangential.
-- SPDX-License-Identifier: GPL-3.0-or-later

local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"

local events = {}

local most, parts, rounds = 100000, 16, 7 -- 16^7 = 2.7e8

-- What an event depends on and the scene does not have: a message, or nil.
function events.missing(job)
  for _, e in ipairs(job.record.events) do
    for _, s in ipairs(expr.symbols(e.when)) do
      if s.rank >= motion.rank and s.name ~= "t" and not job.model.states.by_name[s.name] then
        return "event " .. e.name .. " (line " .. e.line .. ") depends on " .. s.name .. ", no state of this scene"
      end
    end
  end
  return nil
end

-- The value of an expression on a row of the table; nil if it is not a number there.
local function valuer(job, names)
  local env = {}
  for name, q in pairs(job.model.defaults) do env[name] = q end -- into a table: order is lost anyway
  return function(e, row)
    for i, name in ipairs(names) do env[name] = row[i] end
    local g = evaluate.double(e, env)
    return g == g and g or nil
  end
end

local function between(a, b, i) return i == parts and b or a + (b - a) * (i / parts) end

-- One round: of each interval {a, b, ga, gb, event} the first part with the change of sign.
local function narrowed(list, solve, value)
  local times, wanted = {}, {}
  for _, c in ipairs(list) do
    for i = 1, parts - 1 do
      local t = between(c.a, c.b, i)
      if not wanted[t] then times[#times + 1], wanted[t] = t, true end
    end
  end
  table.sort(times)
  local rows, why = solve(times)
  if not rows then return nil, why end
  local at = {}
  for i, row in ipairs(rows) do at[times[i]] = row end
  for _, c in ipairs(list) do
    local a, ga, b, gb = c.a, c.ga, c.b, c.gb
    for i = 1, parts - 1 do
      local t = between(a, b, i)
      local g = value(c.event.when, at[t])
      if g and g ~= 0 and (g > 0) == (gb > 0) then
        c.b, c.gb = t, g
        break
      elseif g and g ~= 0 then
        c.a, c.ga = t, g
      end
    end
    if c.a == a and c.b == b then c.ga, c.gb = ga, gb end
  end
  return true
end

-- Where signs change between two times of the grid: intervals {a, b, ga, gb, event}.
local function changes(job, rows, value)
  local list = {}
  for _, e in ipairs(job.record.events) do
    local a, ga
    for _, row in ipairs(rows) do
      local g = value(e.when, row)
      if g and g ~= 0 then
        if ga and (g > 0) ~= (ga > 0) and e.direction * g >= 0 then
          list[#list + 1] = { a = a, b = row[1], ga = ga, gb = g, event = e,
            size = math.max(math.abs(ga), math.abs(g)) }
        end
        a, ga = row[1], g
      elseif not g then
        ga = nil
      end
    end
  end
  return list
end

-- The events from 0 to `finish` in the order of time: a list of {event, row}, cut after the first that stops; or nil
-- and what went wrong.  solve(times) -> rows with the columns `names`, t the first.
function events.find(job, solve, names, finish, step)
  local n = math.max(1, math.min(most, math.ceil(finish / step)))
  local grid = {}
  for i = 0, n do grid[i + 1] = i == n and finish or finish * (i / n) end
  local rows, why = solve(grid)
  if not rows then return nil, why end
  local value = valuer(job, names)
  local list = changes(job, rows, value)
  if #list == 0 then return {} end
  for _ = 1, rounds do
    local ok, wrong = narrowed(list, solve, value)
    if not ok then return nil, wrong end
  end
  local zeros = {}
  for i, c in ipairs(list) do
    c.t, c.place = c.a + (c.b - c.a) * (c.ga / (c.ga - c.gb)), i
    if math.min(math.abs(c.ga), math.abs(c.gb)) <= c.size then zeros[#zeros + 1] = c end -- else a pole
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
  rows, why = solve(single)
  if not rows then return nil, why end
  local k = 0
  for i, t in ipairs(times) do
    if t ~= times[i - 1] then k = k + 1 end
    out[i] = { event = list[i].event, row = rows[k] }
  end
  return out
end

return events
