-- floors.lua -- by what, at least, the error of a step is measured where a body may come to rest on a plane.
--
-- A size that is rounding can be followed by no step: what is left of the slip, say, where v and w x r cancel.  So a
-- size is never less than what the terms of its rate, each on its own, make of it within the step h:
--     v:  |g| h, and |r| |w|, the other part of the slip       w:  m |g| |r|/I h, and |v|/|r|       place:  |r|
-- |r|: a bound of the way from the centre of mass to the contact point; I: half the trace, the largest moment or up to
-- half more.  Nothing here remembers the run.  What plays the same part in the general library is scale.c.
-- Without a plane there are no floors: terms vanish with the state, and a motion that grows out of nearly nothing is
-- followed.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local context = require "generator.dynamics.context"

local floors = {}

local function length(v) return expr.call("sqrt", vec.dot(v, v)) end

-- The place of a state in what NAME_floors gives; nil: it has no floor.
local function place(s)
  if s.kind == "rates" then return 0 end
  return string.match(s.name, "^v[12]$") and 1 or string.match(s.name, "^p[12]$") and 2 or nil
end

-- {pull = |g|, reach = |r|, turn = 2 m |g| |r|/trace I, derived constants; places = by the states' names}, or nil where
-- no plane is touched.
function floors.of(eq)
  local m = eq.model
  local plane = contact.of(m)
  if not (plane and eq.touch) then return nil end
  local a, s = plane.a, plane.a.surface
  local mass, trace = m.mass, m.inertia[1] + m.inertia[2] + m.inertia[3]
  local reach = s.rim + length(s.half) + length(vec.sub(s.at, context.of(m).origin))
  if s.support then reach = reach + expr.call("sqrt", trace / (2 * mass)) end -- its size is a function; the body's own
  local pull, places = length(a.gravity), {}
  for _, x in ipairs(m.states) do places[x.name] = place(x) end
  return { places = places,
    pull = m:constant("floor_pull", pull, "|g| of the plane, m/s^2"),
    reach = m:constant("floor_reach", reach, "bound of the way to the contact point, m"),
    turn = m:constant("floor_turn", 2 * mass * pull * reach / trace, "m |g| |r|/I, 1/s^2") }
end

return floors
