-- reference.lua -- the true motion from a given state, and how true it is.
--
-- The general library computes in long double: by its closed form where the scene is a free top, else by Taylor series,
-- twice, and the difference of the two runs says how far either can be from the truth.
-- SPDX-License-Identifier: GPL-3.0-or-later

local happenings = require "generator.dynamics.happenings"
local motion = require "generator.dynamics.motion"
local numeric = require "generator.dynamics.numeric"
local switching = require "generator.dynamics.switching"
local err = require "generator.plan.error"

local reference = {}
reference.__index = reference

-- Tolerances of the series a unit of time of the motion, and of the second run.  Some effects the library integrates by
-- extrapolation, which may not get there: `most` steps between two times, then the next tolerances.  Of the closed form
-- nothing is smaller than the doubles that the rows are rounded to.
local tolerances = { { 1e-18, 1e-16 }, { 1e-15, 1e-14 }, { 1e-12, 1e-11 } }
local most = 5000
-- Where the equations have corners at unknown times each step of this method sees the corner at its end, and shrinks.
local cornered = { method = "rk8pd", tolerances = { { 1e-16, 1e-15 }, { 1e-14, 1e-13 } }, most = 1000000 }
local rounding = 2.0 ^ -53

-- What computes the true motions of a scene; it remembers at which tolerances the library got there.
function reference.new(host, job)
  local way = switching.of(job.equations) and cornered or { method = "taylor", tolerances = tolerances, most = most }
  return setmetatable({ host = host, job = job, level = 1, way = way }, reference)
end

-- The states (as the scene has them) at `times` from x0 at t = 0, and their own error in the measure of error.lua;
-- or nil and why there is none.  quick: one run, no second: the error is then nil.
-- input: the values that inputs are held at (nil: none).
function reference:motion(x0, times, values, quick, input)
  local host, job, way = self.host, self.job, self.way
  local s = numeric.from(numeric.scene(job, values), job, x0)
  local function run(method, tolerance)
    local list, failure = motion.library(host, job, s, { method = method, tolerance = tolerance, most = way.most,
      course = input }).solve(times, {})
    if not list then return nil, happenings.said(failure) end
    return err.states(list)
  end
  local free = #s.effects == 0 and job.model.has.rates and not job.model.has.position
  local rows, other, why
  for level = self.level, #way.tolerances do -- what failed once is not tried again
    local t = way.tolerances[level]
    self.level = level
    rows, why = run(free and "exact" or way.method, not free and t[1] or nil)
    if rows and quick then return rows end
    if rows then other, why = run(way.method, t[free and 1 or 2]) end
    if other then return rows, (math.max(rounding, (err.of(job, other, rows)))) end
  end
  self.level = 1
  return nil, why
end

return reference
