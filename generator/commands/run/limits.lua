-- limits.lua -- which steps and tolerances `polhode run` takes: the rule that is broken, in words.
-- SPDX-License-Identifier: GPL-3.0-or-later

local shortest = require("generator.plan.decision").shortest
local json = require "generator.report.json"

local limits = {}


limits.rows = 1000000        -- more is a slip of --every
limits.library = 5000000     -- steps of the library between two rows (src/cli/engine/run.c)
limits.emitted = 10000000000 -- steps of emitted code in a run: minutes

-- Smallest and largest tolerance: below the first a step asks for more digits than the type has, above the second for
-- nothing.  The library computes in long double (src/runtime/integrate/run.c).
limits.tolerances = { general = { 1e-19, 0.1 }, double = { 2.0 ^ -52, 0.1 }, float = { 2.0 ^ -23, 0.1 } }

-- What emitted code is run with where no tolerance is asked for.
limits.usual = { double = 1e-12, float = 1e-6 }

-- Steps to all the times, one after the other, from t0: as many as emitted code and library take.
function limits.steps(times, h, t0)
  local n, t = 0, t0 or 0.0
  for _, at in ipairs(times) do
    n, t = n + math.ceil(math.abs(at - t) / h * (1 - 1e-12)), at
  end
  return n
end

-- What is wrong with --step and --tolerance for a method, or nil.  m: {method =, closed = it takes no steps, adaptive =
-- it can choose them, tolerances = {least, most}}.
function limits.refused(job, given, m)
  local step, tolerance = given.step, given.tolerance
  if step and step <= 0 then return "--step must be positive, got " .. json.number(step) end
  if step and tolerance then return "--step and --tolerance exclude each other" end
  if step and m.closed and #job.record.events == 0 then -- else they are looked for every step
    return "--step: the method " .. m.method .. " has no steps"
  end
  if not tolerance then return nil end
  if not m.adaptive then
    return "--tolerance: the method " .. m.method .. (m.closed and " has no steps" or " has a fixed step")
  end
  local least, most = table.unpack(m.tolerances)
  if not (tolerance >= least and tolerance <= most) then
    return string.format("--tolerance must be from %.2g to %.1g, got %s", least, most, json.number(tolerance))
  end
  return nil
end

-- More steps than a motion does: a message, or nil.
function limits.exceeded(motion, times, given)
  if not motion.step then return nil end
  local most, before = 0, 0.0
  for _, t in ipairs(times) do
    if motion.between then
      most = math.max(most, limits.steps({ t }, motion.step, before))
    end
    before = t
  end
  if not motion.between then most = limits.steps(times, motion.step) end
  if most <= motion.longest then return nil end
  return string.format("%s = %s s: %.2g steps %s, and %.1g are the most", given.step and "--step" or "time.step",
    shortest(motion.step), most, motion.between and "between two rows" or "in all", motion.longest)
end

return limits
