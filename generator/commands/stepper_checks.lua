-- stepper_checks.lua -- every stepper that takes the scene against the general library's motion.
--
-- A stepper that converges may converge to another motion; so errors are distances from the library's, which is
-- integrated by a method and in terms of its own.  Halving h must divide them by 2^order, which a part of them that
-- does not go away would prevent; a method that chooses its steps must keep its tolerance.
-- SPDX-License-Identifier: GPL-3.0-or-later

local equations = require "generator.dynamics.equations"
local methods = require "generator.methods.methods"
local motion = require "generator.dynamics.motion"

local stepper_checks = {}

-- The names of the methods that take the scene, the first one first, and why others do not: {name, why}.
function stepper_checks.choice(scene)
  local names, others = {}, {}
  for _, m in ipairs(methods) do
    local why = methods.refused(scene.equations, m)
    local program = not why
    if program and m.program then program, why = m.program(equations.fork(scene.equations), {}) end
    if program then names[#names + 1] = m.name else others[#others + 1] = { m.name, why } end
  end
  if scene.closed.kind then names[#names + 1] = "exact" end
  return names, others
end

-- Steps over some four radians, so many that the error is far below 1 and far above rounding; twice as many after.
local base = { 1024, 256, nil, 64, nil, 48 }

-- Half of what the order promises to be left after halving would be another order; that h is not yet small takes some.
local loss = 0.75

-- What a method that follows a tolerance may miss it by over a span of some four radians: local errors that add up, and
-- grow as neighbouring motions part.
local growth = 1e4

-- parts: of motions, {start, finish, want = the library's state at finish}; distance(x, y): of two states, against
-- their size.
function stepper_checks.run(job, plugin, tap, name, parts, distance, epsilon)
  for _, s in ipairs(job.steppers) do
    local m = s.method
    local order = m.order -- of an adaptive method that of its step, which is another function
    local worst, shown, fine = 0.0, nil, true
    for _, p in ipairs(parts) do
      local emitted = motion.emitted(job, plugin, { x = p.start, method = m.name })
      local function off(setting)
        local got = motion.to(emitted, p.finish, setting)
        return got and distance(got.x, p.want) or math.huge
      end
      if not m.adaptive then
        local n, first, second, good = base[order] // (job.real == "float" and 2 or 1), nil, nil, false
        for _ = 1, 3 do -- two powers of h may cancel at one step's size, but at no other
          first = second or off { step = p.finish / n }
          second = off { step = p.finish / (2 * n) }
          -- of two infinite errors neither is the larger; a step rounds up to some 16 times
          good = first < 0.3 and second <= first / (loss * 2 ^ order) + (256 + 16 * n) * epsilon
          if good then break end
          n = 2 * n
        end
        if not shown or fine and (not good or second > worst) then
          worst, shown = second, string.format("%.3g, %.3g", first, second)
        end
        fine = fine and good
      else
        local tolerance = job.real == "float" and 1e-5 or 1e-11
        local e = math.max(off { tolerance = tolerance }, m.name == "taylor" and off { step = p.finish / 256 } or 0.0)
        worst = math.max(worst, e)
        fine = fine and e <= growth * tolerance
        shown = string.format("%.3g at a tolerance of %g", worst, tolerance)
      end
    end
    local what = m.name == "rk4" and ": halving h divides the stepper's error by about 16" or
      not m.adaptive and string.format(": %s goes to the library's motion, halving h divides its error by about %d",
        m.name, 2 ^ order) or ": " .. m.name .. " follows the library's motion"
    tap.ok(fine, name .. what, shown)
  end
end

return stepper_checks
