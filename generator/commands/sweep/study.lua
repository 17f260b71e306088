-- study.lua -- the study of a sweep, as emit/members.lua takes it: values, what is kept, and the steps between times.
--
--     study.read(host, job, given, wrong) -> study | nil after messages in `wrong`
--     study.steps(s, step)           the stretches of equal steps; even numbers of them where two runs are compared
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local breaks = require "generator.dynamics.breaks"
local diag = require "generator.diag"
local equations = require "generator.dynamics.equations"
local keep = require "generator.commands.sweep.keep"
local values = require "generator.commands.sweep.values"

local study = {}

local MOST_STEPS = 1 << 31 - 1 -- of a stretch; an int counts them

function study.read(host, job, given, wrong)
  local s = values.read(host, job, given, wrong)
  local taken = {}
  for _, v in ipairs(s.values) do taken[v.name] = true end
  local finish = given["until"] or job.model:double(job.model.horizon)
  if finish <= 0 then wrong[#wrong + 1] = "--until must be positive, got " .. diag.show(finish) end
  if given.step and given.step <= 0 then
    wrong[#wrong + 1] = "--step must be positive, got " .. diag.show(given.step)
  end
  if given.accuracy and not (given.accuracy > 0 and given.accuracy < 1) then
    wrong[#wrong + 1] = "--accuracy must be between 0 and 1, got " .. diag.show(given.accuracy)
  end
  if given.accuracy and given.step then wrong[#wrong + 1] = "--step: --accuracy looks for the step" end
  if given.seed and (given.seed % 1 ~= 0 or given.seed < 0 or given.seed > 1 << 53) then
    wrong[#wrong + 1] = "--seed must be a whole number from 0 to 2^53, got " .. diag.show(given.seed)
  end
  s.keeps, s.times = keep.read(host, job, given.keep, finish, taken, wrong)
  s.finish, s.members = finish, #wrong == 0 and math.tointeger(s.grid * s.samples) or 0
  s.seed, s.points, s.stats, s.accuracy = math.tointeger(given.seed or 1) or 1, given.points, given.stats,
    given.accuracy
  local varied = false
  for _, v in ipairs(s.values) do varied = varied or v.kind == "param" end
  s.knots = {}
  for _, k in ipairs(breaks.knots(equations.fork(job.equations))) do
    if varied and k.time.kind ~= "num" then
      wrong[#wrong + 1] = "a table over time has a corner that depends on parameters: only initial states can be varied"
    end
    s.knots[#s.knots + 1] = R.todouble(k.value)
  end
  return #wrong == 0 and s or nil
end

-- As `polhode run` has them: equal steps, no longer than `step`, from one time at which something is kept or a table
-- has its corner to the next.
function study.steps(s, step)
  local ends, place = {}, {}
  for i, t in ipairs(s.times) do
    if not place[t] then ends[#ends + 1] = t end
    place[t] = i
  end
  local last = #s.times > 0 and #s.keeps == 1 and s.times[#s.times] or s.finish
  for _, t in ipairs(s.knots) do
    if t > 0 and t < last and not place[t] then
      ends[#ends + 1] = t
      place[t] = 0
    end
  end
  if not place[last] then
    ends[#ends + 1] = last
    place[last] = 0
  end
  table.sort(ends)
  s.stretches = {}
  local from = 0.0
  for _, t in ipairs(ends) do
    local span, time = t - from, place[t] > 0 and place[t] or nil
    local n = math.ceil(span / step * (1 - 1e-12))
    if s.accuracy then n = 2 * math.ceil(n / 2) end
    if n > MOST_STEPS then return nil, "--step: more than 2^31 steps between two times" end
    s.stretches[#s.stretches + 1] = { t0 = from, t1 = t, h = n > 0 and span / n or 0.0, steps = n, time = time }
    from = t
  end
  return s
end

return study
