-- phases.lua -- a body that flies and lands is two scenes: one on the plane, one in the air.
--
-- effect.plane with `impact` stands beside effect.translation.  On the plane the scene has the plane, whose gravity is
-- the translation's; in the air it has the translation, and `landing`, the plane that it may meet
-- (dynamics/landing.lua).  Everything else belongs to both.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local diag = require "generator.diag"

local phases = {}

phases.names = { "contact", "flight" }

-- Not deep.
local function copy(t)
  local c = {}
  for k, v in pairs(t) do c[k] = v end -- a copy: order is lost anyway
  return c
end

local function without(list, effect)
  local out = {}
  for _, e in ipairs(list) do
    if e ~= effect then out[#out + 1] = e end
  end
  return out
end

-- Anything but weight would have to act on the plane too.
local function weight_alone(d, flight)
  local a = flight.a
  local none = a.drag == expr.zero and a.linear == expr.zero
  for _, v in ipairs { a.stiffness, a.force, a.thrust } do
    for i = 1, 3 do none = none and v[i] == expr.zero end
  end
  if not none then
    d:error(flight.line, flight.kind, "must have gravity alone beside effect.plane with impact: on the plane its " ..
      "other forces would act too, and the equations there know weight only")
  end
  return none
end

-- The record of one of the phases; the record itself where there are none; nil after errors.
function phases.of(d, record, phase)
  local plane, flight
  for _, e in ipairs(record.effects) do
    if e.kind == "effect.plane" and e.a.impact then plane = e end
    if e.kind == "effect.translation" then flight = e end
  end
  if not plane then return record end
  if not flight then
    d:error(plane.line, plane.kind, "impact needs effect.translation, which says how the body flies")
    return nil
  end
  if not weight_alone(d, flight) then return nil end
  if plane.a.given_gravity then
    d:error(plane.line, plane.kind, "gravity is that of effect.translation (line " .. flight.line ..
      ") in a scene with impact", diag.show(plane.a.given_gravity))
    return nil
  end
  plane.a.gravity = flight.a.gravity
  local own = copy(record)
  own.given = copy(record.given)
  own.effects = without(record.effects, phase == "flight" and plane or flight)
  if phase == "flight" then
    own.landing = plane
  else
    own.flies = true
    if plane.a.law == "rolling" then -- it follows from the rates
      own.given.velocity, own.given.unused = nil, own.given.velocity -- to be checked (dynamics/start.lua)
    end
  end
  return own
end

return phases
