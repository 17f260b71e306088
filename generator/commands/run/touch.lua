-- touch.lua -- the contact of a body with a plane along a motion, by the general library.
-- SPDX-License-Identifier: GPL-3.0-or-later

local contact = require "generator.dynamics.contact"
local numeric = require "generator.dynamics.numeric"

local touch = {}

-- A function of t, the scene's state and the inputs over time (or nil): {N, com, com_velocity, force, point, slip},
-- each vector as three numbers; nil where the body has no single contact point.  Without a plane there is no function.
function touch.of(host, job)
  if not contact.of(job.model) then return nil end
  local library = host.rates(numeric.scene(job))
  return function(t, x, inputs) return (library:contact(t, numeric.whole(job, x), inputs)) end
end

-- The plane of a scene that has one, as doubles: {normal, e1, e2 (inertial axes), open = not every attitude touches}.
function touch.plane(job)
  local e = contact.of(job.model)
  if not e then return nil end
  local function numbers(v)
    local list = {}
    for i = 1, 3 do list[i] = job.model:double(v[i]) + 0.0 end
    return list
  end
  return { normal = numbers(e.a.normal), e1 = numbers(e.a.e1), e2 = numbers(e.a.e2), open = e.a.surface.open or false }
end

return touch
