-- rest.lua -- when a body on a plane has come to rest, as an event.
--
-- Its speed s is the larger of its centre's and of what its turning gives the contact point, its acceleration a
-- likewise.  It is at rest when these are
--   rounding   s and a D, D the time.step, not above 2^-32 of the speeds of its motion: those at the start, and
--              sqrt(G R), which a fall over the way R to the contact point gives; or
--   creeping   s not above a thousandth of the least speed that a smoothed law of friction is smoothed at, while it
--              dies out as by such laws: s/a is the time in which one of them stops that speed, within 16 times.  The
--              law without smoothing has stopped the body by then.  What rolls on slowly, slides down evenly or only
--              turns back is not at rest.
-- The value of the event is above 0 while the body moves.  Nothing ends there: a torque may set it off again.
-- SPDX-License-Identifier: GPL-3.0-or-later

local contact = require "generator.dynamics.contact"
local numeric = require "generator.dynamics.numeric"
local vec = require "generator.algebra.vec"

local rest = {}

local rounding, creep, dying = 2.0 ^ -32, 1e-3, 16.0

local function norm(v) return math.sqrt(vec.dot(v, v)) end

-- The way to the contact point, and the speeds of a state.
local function moving(c, x)
  local arm = norm { c[11] - c[2], c[12] - c[3], c[13] - c[4] }
  return arm, math.max(norm { c[5], c[6], c[7] }, arm * norm { x[5], x[6], x[7] })
end

-- Of the smoothed laws: the least speed, and the shortest and longest time in which one stops its own; nil without any.
local function smoothed(job, a, arm, G)
  local least, shortest, longest
  local function law(f, length, unit)
    if not f or not f.smoothing then return end
    local speed = job.model:double(f.smoothing) * length
    local full = job.model:double(f.coulomb) * G / unit
    if full <= 0 then return end
    least, shortest = math.min(least or speed, speed), math.min(shortest or math.huge, speed / full)
    longest = math.max(longest or 0.0, speed / full)
  end
  law(a.friction, 1.0, 1.0)
  law(a.spinning, arm, arm)
  law(a.rolling_resistance, arm, arm)
  return least, shortest, longest
end

-- Does anything brake the body?
local function braked(a) return a.friction or a.spinning or a.rolling_resistance end

-- The events of a scene's body on the plane of an effect, as events.lua has them: `motion` is their value of the
-- library's rates object, a state of the scene and the inputs.
function rest.events(job)
  local plane = contact.of(job.model)
  if not plane or not braked(plane.a) then return {} end
  local m, scale, places = job.model, nil, {}
  local G, D = norm(vec.map(plane.a.gravity, function(e) return m:double(e) + 0.0 end)), m:double(m.step)
  local at = numeric.positions(job)
  for i, s in ipairs(job.states) do
    if s.effect == plane and (s.key == "v1" or s.key == "v2") then places[#places + 1] = at[i] end
  end
  local first = numeric.whole(job, numeric.initial(job))
  local function value(library, state, inputs)
    local x = numeric.whole(job, state.x)
    local c, dx = library:contact(state.t, x, inputs), library:rates(state.t, x, inputs)
    if not c or not dx then return nil end
    local arm, speed = moving(c, x)
    if not scale then
      local start = library:contact(0.0, first, inputs)
      local _, s = moving(start or c, first)
      scale = s + math.sqrt(G * arm)
    end
    local pull = arm * norm { dx[5], dx[6], dx[7] }
    for _, k in ipairs(places) do pull = math.max(pull, math.abs(dx[k])) end
    local away = math.max(speed, pull * D) / (rounding * scale)
    local least, shortest, longest = smoothed(job, plane.a, arm, G)
    if least and pull > 0 and speed > 0 then
      away = math.min(away, math.max(speed / (creep * least), speed / (pull * longest * dying),
        pull * shortest / (speed * dying)))
    end
    return math.log(math.max(away, 2.0 ^ -1000))
  end
  return { { name = "at_rest", direction = -1, line = plane.line, motion = value } }
end

return rest
