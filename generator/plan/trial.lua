-- trial.lua -- runs of compiled candidates against the true motion: errors and numbers of steps.
--
-- A run is judged where generator/plan/error.lua looks, and once more at the horizon after one uninterrupted run, which
-- is also the one whose steps are counted.  As in the emitted NAME_advance, the tolerance of the series is that of the
-- whole horizon, and a part of it has its share.
-- SPDX-License-Identifier: GPL-3.0-or-later

local err = require "generator.plan.error"
local motion = require "generator.dynamics.motion"
local reference = require "generator.plan.reference"

local trial = {}
trial.__index = trial

-- How the program calls the candidate's stepper: one plugin holds all orders of the series as fixed steps.
local function called(c)
  return c.method == "taylor" and c.setting == "step" and "taylor " .. c.order or c.method
end

-- setup: {host =, job =, plugin =, apart = {method's name = {plugin =}} of other plugins, T = horizon, points =, sure =
-- {candidate, setting} of a method that serves as truth once it has been shown to, or nil: the library is asked at
-- every point}
-- A candidate may have `made`, {plugin =} of its own.
function trial.new(setup)
  local self = setmetatable(setup, trial)
  self.times, self.true_motions, self.moved = err.times(self.T), reference.new(self.host, self.job), {}
  self.log = {}
  return self
end

-- Keeps what was measured, {candidate, setting, error, steps, cost, all = from all states, not only the few at which
-- candidates compete}: tests read it.
function trial:measured(r, all)
  self.log[#self.log + 1] = { candidate = r.candidate, setting = r.setting, error = r.error, steps = r.steps,
    cost = r.cost, all = all }
  return r
end

-- The library is asked for the first `span` seconds only.
function trial:briefly(span)
  self.early = trial.new { host = self.host, job = self.job, plugin = self.plugin, apart = self.apart, T = span,
    sure = self.sure }
end

local function with_last(rows, last)
  rows[#rows + 1] = last or rows[#rows]
  return rows
end

-- Rows of the motion from the point's state: states at the 40 times and last at T in one run, and the steps of that.
function trial:run(c, setting, point)
  local plugin, x, T = (c.made or self.apart and self.apart[c.method] or self).plugin, point.x, self.T
  if point.params or self.moved[plugin] then
    local refusal = self.job.model:refusal(plugin:init(point.params))
    if refusal then return nil, "NAME_init refuses these parameters: " .. refusal end
    self.moved[plugin] = point.params ~= nil
  end
  local m = motion.emitted(self.job, plugin, { x = x, method = called(c), course = point.input, [c.setting] = setting })
  local whole, steps, list, first
  -- else the steps between the 40 times are as long as the others
  if m and (c.setting == "tolerance" or c.setting == "step" and setting > T / 1600) then
    whole, steps = m.solve({ T }, {})
    m = whole and m
  end
  if not m then return nil end
  if c.setting == "tolerance" and c.method == "taylor" then
    first = motion.to(m, self.times[1], { tolerance = setting * self.times[1] / T })
    list = first and m.solve({ table.unpack(self.times, 2) }, { from = first, tolerance = setting / #self.times * 0.1 })
    if list then table.insert(list, 1, first) end
  else
    list = m.solve(self.times, {})
  end
  return list and with_last(err.states(list), whole and whole[1].x), steps or 1
end

-- The true rows of a point, made once; nil and why.
function trial:truth(point)
  if point.truth then return point.truth end
  local rows, why
  if self.sure and not point.library then
    rows, why = self:run(self.sure[1], self.sure[2], point)
    why = why or "the motion ends in a singularity (on a plane: friction that undoes the support)"
  else
    rows, why = self.true_motions:motion(point.x, self.times, point.values, true, point.input)
    if rows then rows = with_last(rows) end
  end
  point.truth = rows
  return rows, why
end

-- How far `sure` is from the library at a point and, if `twice`, the library's two runs from each other: the larger.
function trial:doubt(point, twice)
  if self.early then return self:doubt_early(point, twice) end
  local rows, own = self.true_motions:motion(point.x, self.times, point.values, not twice, point.input)
  if not rows then return nil, own end
  point.truth, point.library = with_last(rows), true
  if not self.sure then return own or 0.0 end
  local ours = self:run(self.sure[1], self.sure[2], point)
  return ours and math.max(own or 0.0, (err.of(self.job, ours, point.truth))) or math.huge
end

-- The same where the library is asked for the beginning only: the rest is held to a run with ten times the tolerance.
function trial:doubt_early(point, twice)
  local p = { x = point.x, values = point.values, params = point.params, input = point.input }
  local doubt, why = self.early:doubt(p, twice)
  if not doubt then return nil, why end
  local rows, ended = self:truth(point)
  if not rows then return nil, ended end
  local coarse = self:run(self.sure[1], 10 * self.sure[2], point)
  return coarse and math.max(doubt, (err.of(self.job, coarse, rows))) or math.huge
end

-- The largest error of a candidate over the points and the mean of its steps.  limit: stop at the first that is above.
-- Third result: the point of the largest error.
function trial:worst(c, setting, points, limit)
  local most, sum, at = 0.0, 0.0, points[1]
  for _, p in ipairs(points) do
    local rows, steps = self:run(c, setting, p)
    local e = rows and err.of(self.job, rows, assert(self:truth(p))) or math.huge
    if c.setting == "step" then steps = math.ceil(self.T / setting * (1 - 1e-12)) end
    sum = sum + (steps or 0)
    if e > most then most, at = e, p end
    if limit and e > limit then return most, steps or math.huge, at end
  end
  return most, sum / #points, at
end

return trial
