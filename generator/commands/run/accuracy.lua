-- accuracy.lua -- how wrong a motion is, of which kind its error is, and what would help: it is run again, better.
--
-- Two kinds of error: of the steps, which shorter ones or a smaller tolerance make less, and of roundings.  The better
-- run has both less: its steps are shorter, or its tolerance is smaller, and where the motion is in float, it is in
-- double.  Only where the difference exceeds the limit, more runs tell the two kinds apart:
--     float     the same steps in double: what differs is rounding
--     double    a third run, better again.  By the law of the method (order p: the error of n steps goes with n^-p;
--               that of a tolerance with it) the difference falls, while roundings stay or grow with n: two equations.
--               Where roundings are the most, the library in long double tells how large they are
-- Where the second and third run differ so much that they know no digit, the first knows none, and no number is given.
-- A tolerance that cannot be smaller is made larger instead: the difference to that run bounds the error from above.
-- Cost: 2 runs' for steps by halves, 5/4 where that takes longer than a second, about 1 for a tolerance.
-- Errors are measured as plan/error.lua does, in parts of the motion's size: the largest in the whole run, which the
-- better run looks at between the rows too.
-- SPDX-License-Identifier: GPL-3.0-or-later

local err = require "generator.plan.error"
local facts = require "generator.report.facts"
local kinds = require "generator.commands.run.advice"
local limits = require "generator.commands.run.limits"
local numeric = require "generator.dynamics.numeric"

local accuracy = {}

accuracy.limit = 1e-3 -- where --warn does not say another
local seen = 64 -- times between rows in the whole run, at which the better run is looked at
local nothing = 0.2 -- an error of the better run itself that leaves the other no digit
local share = { short = 1 / 2, long = 4 / 5 } -- of the step; long: of runs of more than motion.quick steps
local finer = 1 / 4 -- of the tolerance
local loose, looser = 1e-10, { 100, 10 } -- a tolerance that tells whether a motion is harmless; times the tolerance

-- ---- two motions side by side ----

-- The times with others between them, in the order of the run; the places of the rows among them; the run's length; the
-- places of all.
local function spread(times)
  local length, at, list, places = 0.0, 0.0, {}, {}
  for _, t in ipairs(times) do length, at = length + math.abs(t - at), t end
  at = 0.0
  for i, t in ipairs(times) do
    local n = length > 0 and math.floor(seen * math.abs(t - at) / length) or 0
    for k = 1, n do list[#list + 1] = at + (t - at) * (k / (n + 1)) end
    list[#list + 1], at = t, t
    places[i] = #list
  end
  local all = {}
  for i in ipairs(list) do all[i] = i end
  return list, places, length, all
end

-- The sizes of the groups in a run of that length: their largest norms.  What is only rounding has none of its own (a
-- body at rest, held by torques that cancel).  So rates have at least the one that turns the body by a millionth of a
-- rad in the run, a position a billionth of the way that the velocity makes, and a velocity that of the position.
local function sizes(s, rows)
  local states = err.states(rows)
  states[#states + 1] = numeric.initial(s.job)
  local scales, of = err.scales(s.groups, states), {}
  for n, g in ipairs(s.groups) do of[g.name] = scales[n] end
  for n, g in ipairs(s.groups) do
    local least = g.name == "rates" and 1e-6 / s.length or g.name == "velocity" and 1e-9 * of.position / s.length or
      g.name == "position" and of.velocity and 1e-9 * of.velocity * s.length or 0.0
    scales[n] = math.max(scales[n], least)
  end
  return scales
end

-- How far rows are from better ones, times a factor: {error =, t =, group = where it is largest, since = the first time
-- at which it is above the limit}.
local function difference(s, rows, better, factor, limit)
  local v = { error = 0.0 }
  s.scales = s.scales or sizes(s, better)
  for i, row in ipairs(rows) do
    for n, g in ipairs(s.groups) do
      local d = factor * err.distance(g, s.scales[n], row.x, better[i].x)
      if d > v.error or not v.group then v.error, v.t, v.group = d, row.t, g.name end
      if d > (limit or s.limit) and not v.since then v.since = row.t end
    end
  end
  return v
end

local function at_rows(s, list)
  local rows = {}
  for i, k in ipairs(s.places) do rows[i] = list[k] end
  return rows
end

-- ---- better runs ----

-- What a better run is asked for than one with n steps of that length: {step =}, its steps, and the part of the error
-- that it keeps.
local function shorter(s, step, n)
  local part = share[n > s.motion.quick and "long" or "short"]
  step = step * part
  while limits.steps(s.list, step) < n * (1 + 1 / part) / 2 do step = step / 2 end -- rows are nearer than that
  local more = limits.steps(s.list, step)
  return { o = { step = step }, n = more, kept = (n / more) ^ s.motion.order, grows = more / n }
end

-- The k-th better setting, nil if there is none.
local function setting(s, before)
  local m = s.motion
  if m.step then
    return shorter(s, before and before.o.step or m.step, before and before.n or limits.steps(s.times, m.step))
  end
  local tolerance = finer * (before and before.o.tolerance or m.tolerance)
  if tolerance < s.sure.least then return nil end
  return { o = { tolerance = tolerance }, kept = finer, grows = 1 }
end

-- Puts apart what two differences show, of the rows to the better run a and of that to b: the errors of the steps and
-- of roundings.
local function apart(first, second, a, b)
  local falls = a.kept * (1 - b.kept) / (1 - a.kept)
  local rounding = math.min(first, math.max(0.0, (second - falls * first) / (a.grows - falls)))
  return (first - rounding) / (1 - a.kept), rounding
end

local function without_number(v)
  return { lost = true, error = v.error, t = v.since, group = v.group, since = v.since }
end

-- Of a motion in float: `first` is the better run in double.
local function of_float(s, rows, v, a, first)
  local same = s.sure.solve(s.list, s.motion.step and { step = s.motion.step } or { tolerance = s.motion.tolerance })
  if not same then return v end
  local own = difference(s, same, first, a.kept / (1 - a.kept), nothing)
  if own.since then return without_number(own) end
  v.steps, v.rounding = own.error / a.kept, difference(s, rows, at_rows(s, same), 1).error
  if v.rounding > v.steps then v.error = v.error * (1 - a.kept) end
  return v
end

-- Of one whose roundings are the most of its error, v: by the library in long double, where that is sure of itself.
-- Two runs in double may differ by far more than one of them errs.
local judged
local function by_library(s, rows, v)
  local judge = s.motion.judge and s.motion.judge()
  local better = judge and judge.solve(s.list, {})
  if not better then return v end
  local own = judged({ job = s.job, motion = judge, sure = judge, times = s.list, list = s.list, groups = s.groups,
    places = s.all, limit = s.limit, length = s.length }, better)
  if not own or own.lost or own.error > s.limit then return v end
  local w = difference(s, rows, at_rows(s, better), 1)
  w.steps, w.rounding = v.steps, math.max(0.0, w.error - v.steps)
  return w
end

-- Of one in double.
local function of_double(s, rows, v, a, first)
  local b = setting(s, a)
  local second = b and s.motion.solve(s.list, b.o)
  if not second then return v end
  local own = difference(s, first, second, 1 / (1 - b.kept), nothing)
  if own.since then return without_number(own) end
  local near = difference(s, at_rows(s, first), at_rows(s, second), 1).error
  v.steps, v.rounding = apart(difference(s, rows, at_rows(s, first), 1).error, near, a, b)
  v.error = v.steps + v.rounding
  return v.rounding > v.steps and by_library(s, rows, v) or v
end

-- By runs with larger tolerances.  The error is that of the motion's own tolerance, a hundredth of the first, or
-- rounding.
local function from_above(s, rows)
  local m, runs, v = s.motion, {}, nil
  local list = { m.tolerance * looser[1], m.tolerance * looser[2] }
  if list[1] < loose then table.insert(list, 1, loose) end
  for _, tolerance in ipairs(list) do
    local other = m.solve(s.list, { tolerance = tolerance })
    s.scales = other and sizes(s, other) or s.scales
    v = other and difference(s, rows, at_rows(s, other), 1) or v
    if other and v.error <= s.limit then return v end
    runs[#runs + 1] = other and { rows = other, error = v.error } or nil
  end
  if #runs < 2 then return v end
  local far, near = runs[#runs - 1], runs[#runs]
  local own = difference(s, far.rows, near.rows, 1, nothing)
  if own.since then return without_number(own) end
  v.steps = math.max(0.0, far.error - near.error) / (looser[1] - looser[2])
  v.rounding = math.max(0.0, near.error - (looser[2] - 1) * v.steps)
  v.error = v.steps + v.rounding
  return v
end

-- The verdict {error, t, group, since, steps =, rounding = its parts, lost = no number is known} on the rows.
function judged(s, rows)
  local a = setting(s)
  local first = a and (s.motion.step or setting(s, a)) and s.sure.solve(s.list, a.o)
  if not first and not s.motion.step then return from_above(s, rows) end
  if not first then return { error = math.huge, t = s.times[#s.times], since = s.times[1] } end
  s.scales = sizes(s, first)
  local v = difference(s, rows, at_rows(s, first), 1 / (1 - a.kept))
  if v.error <= s.limit then return v end
  return (s.sure == s.motion and of_double or of_float)(s, rows, v, a, first)
end

-- ---- for run.lua ----

-- What is looked at: the motion and the one that is sure of its digits, in double.
local function study(job, motion, times, limit)
  local s = { job = job, motion = motion, times = times, groups = err.groups(job), limit = limit or accuracy.limit }
  s.list, s.places, s.length, s.all = spread(times)
  s.sure = motion.twin and motion.twin() or motion
  function s.compare(rows, better, factor) return difference(s, rows, better, factor) end
  return s
end

-- A warning on the rows of a closed form, or nil.  In float: how far they are from those in double.  As no number of
-- the scene is known better than to a rounding, the state at t is no better than that at t (1 + epsilon) tells; where
-- both are only noise, |w| t epsilon does.
local function closed(s, rows)
  local motion, later = s.motion, {}
  if s.sure ~= motion then
    local exact = s.sure.solve(s.list, {})
    s.scales = exact and sizes(s, exact)
    local v = exact and difference(s, rows, at_rows(s, exact), 1)
    if v and v.error <= s.limit then return nil end
    v = v or { error = math.huge, t = s.times[#s.times], since = s.times[1] }
    v.steps, v.rounding = 0.0, v.error
    return kinds.warning(s, v)
  end
  for i, row in ipairs(rows) do later[i] = row.t * (1 + motion.epsilon) end
  local moved = motion.solve(later, {})
  s.scales = sizes(s, motion.solve(s.list, {}) or rows)
  local v = moved and difference(s, rows, moved, 1) or { error = math.huge, group = "state", t = rows[#rows].t,
    since = rows[1].t }
  for _, g in ipairs(s.groups) do
    for _, row in ipairs(g.name == "rates" and rows or {}) do
      local square = 0.0
      for _, i in ipairs(g) do square = square + row.x[i] ^ 2 end
      local d = math.sqrt(square) * math.abs(row.t) * motion.epsilon / 2
      if d > v.error then v.error, v.t, v.group = d, row.t, "attitude" end
      if d > s.limit then v.since = math.min(v.since or row.t, row.t) end
    end
  end
  return v.error > s.limit and kinds.conditioned(s, v) or nil
end

-- A warning on the linearised motion: how far the exact one, solve(times), is from it.
local function linearised(s, rows, exact)
  s.scales = sizes(s, exact)
  local v = difference(s, rows, exact, 1)
  return v.error > s.limit and kinds.linearised(s, v, facts.of(s.job).linearised.own.e) or nil
end

-- A warning on rows of a motion at these times, or nil.  exact: a motion that the linearised one is compared with;
-- limit: the error above which there is one.
function accuracy.warning(job, motion, times, rows, exact, limit)
  local s = study(job, motion, times, limit)
  if s.length == 0 then return nil end
  if motion.method == "linearised" then
    local other = exact().solve(times, {})
    return other and linearised(s, rows, other)
  end
  if motion.closed then return closed(s, rows) end
  local v = judged(s, rows)
  return v and (v.lost or v.error > s.limit) and kinds.warning(s, v) or nil
end

-- What helps when the numbers of a run failed at time t.
function accuracy.help(job, motion, times, t)
  local list = {}
  if motion.step then
    list[1] = kinds.advice(study(job, motion, times), {})
  elseif motion.method == "linearised" then
    list[1] = "--method exact"
  elseif motion.adaptive then
    list[1] = "another --method or --tolerance, unless the motion itself ends there"
  end
  if t and t ~= 0 then list[#list + 1] = "only times before, for the rows that there are" end
  return table.concat(list, "; or ")
end

return accuracy
