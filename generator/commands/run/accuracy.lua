-- accuracy.lua -- how wrong a motion by fixed steps is, and what would help: the run again with half the step.
--
-- The difference of both, times 2^p/(2^p - 1) for a method of order p, is the error (Richardson).  It is that of the
-- whole run, for both start together and then go on by themselves, and it is taken at the rows.  Runs of more than
-- motion.quick steps are compared on ten stretches, every second twentieth of the run, where both start from the same
-- state; what they differ by is added up, and doubled for the other half.  So a short run takes a second more at most,
-- and a long one twice the time.
-- Errors are measured as plan/error.lua does: the attitude by |q - q'| (half the angle between them in rad), all else
-- by the norm of the difference in parts of the largest norm in the run.
-- SPDX-License-Identifier: GPL-3.0-or-later

local err = require "generator.plan.error"
local facts = require "generator.report.facts"
local limits = require "generator.commands.run.limits"

local accuracy = {}

accuracy.limit = 1e-3 -- the messages have it too
local stretches = 10
local patience = 10 -- times motion.quick: steps of the longest run that looks for a better step

local function short(x) return string.format("%.2g", x) end

-- Two digits, not above x.
local function floor(x)
  local unit = 10.0 ^ (math.floor(math.log(x, 10)) - 1)
  local s = short(math.floor(x / unit) * unit)
  return tonumber(s) <= x and s or short(tonumber(s) - unit)
end

local function states(rows)
  local list = {}
  for i, row in ipairs(rows) do list[i] = row.x end
  return list
end

-- The sizes of the groups.  Rates that are only rounding (a body at rest, held by torques that cancel) have none of
-- their own: theirs is at least the one that turns the body by a millionth of a rad in the run, and a velocity's at
-- least the one that moves it by a billionth of its distance.
local function sizes(groups, rows)
  local scales, finish, far = err.scales(groups, states(rows)), 0.0, 0.0
  for _, row in ipairs(rows) do finish = math.max(finish, math.abs(row.t)) end
  for n, g in ipairs(groups) do far = g.name == "position" and scales[n] or far end
  for n, g in ipairs(groups) do
    local least = g.name == "rates" and 1e-6 / finish or g.name == "velocity" and 1e-9 * far / finish or 0.0
    scales[n] = finish > 0 and math.max(scales[n], least) or scales[n]
  end
  return scales
end

-- Adds to a verdict {error, t, since, group} what the group is wrong by at t.
local function note(v, group, d, t)
  if d > v.error or not v.group then v.error, v.t, v.group = d, t, group.name end
  if d > accuracy.limit and not v.since then v.since = t end
end

-- The verdict on rows against better ones, at the same times.
local function compare(job, rows, better, factor)
  local groups, v = err.groups(job), { error = 0.0 }
  local scales = sizes(groups, better)
  for i, row in ipairs(rows) do
    for n, g in ipairs(groups) do
      note(v, g, factor * err.distance(g, scales[n], row.x, better[i].x), row.t)
    end
  end
  return v
end

local function richardson(motion) return 2.0 ^ motion.order / (2.0 ^ motion.order - 1) end

-- ---- long runs ----

-- The ends of the twentieths of a long run, each the next of the times where one is near, and the times with them; nil
-- where times run backwards.
local function marked(times)
  local finish, last = times[#times], 0.0
  for _, t in ipairs(times) do
    if t < last then return nil end
    last = t
  end
  local marks, list, i = {}, {}, 1
  for k = 0, 2 * stretches do
    local mark = k == 2 * stretches and finish or finish * (k / (2 * stretches))
    while i <= #times and times[i] < mark do
      list[#list + 1] = times[i]
      i = i + 1
    end
    if times[i] and times[i] - mark < finish / (8 * stretches) then
      mark, i = times[i], i + 1
    end
    marks[k + 1], list[#list + 1] = mark, mark
  end
  return marks, list
end

local function sampled(job, motion, marks, rows)
  local groups, v, at, sums, length = err.groups(job), { error = 0.0 }, {}, {}, 0.0
  local scales = sizes(groups, rows)
  for _, row in ipairs(rows) do at[row.t] = row end
  for k = 1, 2 * stretches, 2 do length = length + marks[k + 1] - marks[k] end
  local factor = richardson(motion) * marks[#marks] / length
  for k = 1, 2 * stretches, 2 do
    local from, to = at[marks[k]], at[marks[k + 1]]
    local better = motion.solve({ to.t }, { step = motion.step / 2, from = from })
    for n, g in ipairs(groups) do
      local d = better and err.distance(g, scales[n], to.x, better[1].x) or math.huge
      sums[n] = (sums[n] or 0.0) + factor * d
      note(v, g, sums[n], to.t)
    end
  end
  return v
end

-- ---- what helps ----

-- The step that has half the error that is allowed, by the order, where an error is small enough to tell.
local function by_order(motion, step, e)
  if not e or e > 0.5 then return nil end
  return "--step " .. floor(step * (accuracy.limit / 2 / e) ^ (1 / motion.order)) .. " (by the method's order)"
end

-- The first of the halved steps whose own error is below the limit, in words; nil if none is found with patience.
local function shorter(job, motion, times, finer)
  local step, last, slow = motion.step / 2, nil, 0
  if not finer then finer = motion.solve(times, { step = step }) end
  while limits.steps(times, step / 2) <= patience * motion.quick do
    local finest = motion.solve(times, { step = step / 2 })
    local e = finer and finest and compare(job, finer, finest, richardson(motion)).error
    if e and e <= accuracy.limit then return "--step " .. floor(step) .. " (estimated error " .. short(e) .. ")" end
    slow = e and last and e > 0.7 * last and slow + 1 or 0
    if slow > 3 then return nil end -- rounding, or a motion that forgets where it came from
    finer, last, step = finest, e, step / 2
  end
  return by_order(motion, 2 * step, last)
end

-- A sentence for the step that helps, and other methods.
local function advice(job, motion, times, v, finer)
  local list, better = {}, nil
  if limits.steps(times, motion.step) <= motion.quick then
    better = shorter(job, motion, times, finer)
  elseif v then
    better = by_order(motion, motion.step, v.error)
  end
  list[1] = better or "a much smaller --step than " .. short(motion.step)
  if motion.adaptive then
    list[#list + 1] = "no --step: " .. motion.method .. " then chooses its own"
  else
    list[#list + 1] = "--method adaptive, which chooses its own steps"
  end
  if motion.exact then list[#list + 1] = "--engine generated --method exact" end
  return table.concat(list, "; or ")
end

local function amount(v)
  if v.error == math.huge then return "not finite" end
  if v.error > 10 then return "more than 10 (" .. v.group .. ")" end
  if v.group == "attitude" then
    return short(v.error) .. " (attitude: " .. short(4 * math.asin(math.min(2 ^ -0.5, v.error / 2))) .. " rad)"
  end
  return short(v.error) .. " (" .. v.group .. ", in parts of the largest)"
end

local function sentence(v)
  return string.format("%s at t = %.4g s, above 1e-3 from t = %.4g s on", amount(v), v.t, v.since)
end

-- ---- for run.lua ----

local function long(motion, times)
  return motion.step ~= nil and limits.steps(times, motion.step) > motion.quick
end

-- The times at which the motion is to be had: those of the rows, and of a long run the ends of its stretches.
function accuracy.times(motion, times)
  local marks, list
  if long(motion, times) then marks, list = marked(times) end
  return marks and list or times
end

-- A warning on the rows of a motion by fixed steps, taken at accuracy.times, or nil.
function accuracy.warning(job, motion, times, rows)
  if not motion.step or limits.steps(times, motion.step) == 0 then return nil end
  local marks, v, finer
  if long(motion, times) then marks = marked(times) end
  if marks then
    v = sampled(job, motion, marks, rows)
  else
    finer = motion.solve(times, { step = motion.step / 2 })
    v = finer and compare(job, rows, finer, richardson(motion)) or
      { error = math.huge, t = times[#times], since = times[1] }
  end
  if v.error <= accuracy.limit then return nil end
  return string.format("%s with steps of %s s: its error is estimated at %s\n  what helps: %s\n", motion.method,
    short(motion.step), sentence(v), advice(job, motion, times, v, finer))
end

-- What helps when the numbers of a run failed at time t.
function accuracy.help(job, motion, times, t)
  local list = {}
  if motion.step then
    list[1] = advice(job, motion, times)
  elseif motion.method == "linearised" then
    list[1] = "--method exact"
  elseif motion.adaptive then
    list[1] = "another --method or --tolerance, unless the motion itself ends there"
  end
  if t and t ~= 0 then list[#list + 1] = "only times before, for the rows that there are" end
  return table.concat(list, "; or ")
end

-- A warning on rows that no steps lead to, or nil.  As no number of the scene is known better than to a rounding, the
-- state at t is no better than that at t (1 + epsilon) tells; where both are only noise, |w| t epsilon does.
function accuracy.conditioned(job, motion, rows)
  local later = {}
  for i, row in ipairs(rows) do later[i] = row.t * (1 + motion.epsilon) end
  local moved = motion.solve(later, {})
  local v = moved and compare(job, rows, moved, 1) or { error = math.huge, group = "state", t = rows[#rows].t,
    since = rows[1].t }
  for _, g in ipairs(err.groups(job)) do
    local still = { x = {} }
    for i in ipairs(job.states) do still.x[i] = 0.0 end
    for _, row in ipairs(g.name == "rates" and rows or {}) do
      note(v, { name = "attitude" }, err.distance(g, 1, row.x, still.x) * math.abs(row.t) * motion.epsilon / 2, row.t)
    end
  end
  if v.error <= accuracy.limit then return nil end
  return string.format("%s: the last digit of t, or of any number of the scene, changes the state by %s\n" ..
    "  what helps: times nearer to 0%s\n", motion.method, sentence(v), motion.epsilon > 2.0 ^ -50 and
    "; or --real double" or "")
end

-- A warning on the rows of the linearised motion: how far the exact one, solve(times), is from it.
function accuracy.linearised(job, rows, solve)
  local times = {}
  for i, row in ipairs(rows) do times[i] = row.t end
  local exact = solve(times)
  if not exact then return nil end
  local v = compare(job, rows, exact, 1)
  if v.error <= accuracy.limit then return nil end
  local own = facts.of(job).linearised.own
  return string.format("linearised: the exact motion differs by %s; the transverse rates are %s of the spin, and " ..
    "terms of the order of their square are left out\n  what helps: --method exact\n", sentence(v), short(own.e))
end

return accuracy
