-- touch.lua -- the contact of a body with a plane along a motion, by the general library.
-- SPDX-License-Identifier: GPL-3.0-or-later

local contact = require "generator.dynamics.contact"
local flat = require "generator.commands.run.flat"
local happenings = require "generator.dynamics.happenings"
local numeric = require "generator.dynamics.numeric"
local vec = require "generator.algebra.vec"

local touch = {}

-- Of a body in the air: no force; its lowest point.
local function above(library, x)
  local low = library:gap({ table.unpack(x, 1, 13) })
  if not low then return nil end
  local list = { 0.0, table.unpack(x, 8, 13) }
  for i = 1, 3 do list[7 + i], list[10 + i], list[13 + i] = 0.0, low[2 + i], low[5 + i] end
  return list
end

-- A function of t, the scene's state, the inputs over time (or nil), and `on`: {N, com, com_velocity, force, point,
-- slip}, each vector as three numbers; nil where the body has no single contact point.  Without a plane there is no
-- function.  ground: of a body that flies and lands the scene on the plane; `on` is then its state, nil in the air.
function touch.of(host, job, ground)
  if not contact.of(job.model) and not ground then return nil end
  local library = host.rates(numeric.scene(ground or job))
  return function(t, x, inputs, on)
    if ground and not on then return above(library, numeric.whole(job, x)) end
    return (library:contact(t, numeric.whole(ground or job, on or x), inputs))
  end
end

-- A function of times: the states of a motion with their energy, L and `contact`, what touch.of has of them; or nil and
-- a failure.
function touch.seen(host, job, motion, inputs, ground)
  local touching = touch.of(host, job, ground)
  return function(ts)
    local states, failure = motion.solve(ts, {})
    local out = {}
    for i, s in ipairs(states or {}) do
      local energy, L = motion.measured(s)
      if not energy then return nil, L end
      out[i] = { t = s.t, x = s.x, on = s.on, energy = energy, L = L,
        contact = touching and touching(s.t, s.x, inputs, s.on) }
      if touching and not out[i].contact then return nil, { status = 3, t = s.t, text = happenings.no_point } end
    end
    return states and out, failure
  end
end

-- The plane of a scene that has one, as doubles: {normal, e1, e2 (inertial axes), open = not every attitude touches,
-- flies = does the body leave it and come back?, weight = the gravity along the normal, m/s^2, disc = flat.numbers}.
function touch.plane(job)
  local e = contact.of(job.model) or job.record.landing
  if not e then return nil end
  local function numbers(v)
    local list = {}
    for i = 1, 3 do list[i] = job.model:double(v[i]) + 0.0 end
    return list
  end
  return { normal = numbers(e.a.normal), e1 = numbers(e.a.e1), e2 = numbers(e.a.e2), open = e.a.surface.open or false,
    flies = job.record.landing ~= nil,
    disc = flat.numbers(job, e), weight = -vec.dot(numbers(e.a.gravity), numbers(e.a.normal)) }
end

return touch
