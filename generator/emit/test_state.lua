-- test_state.lua -- the states at which the self-test looks at functions, beside the scene's own.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"

local test_state = {}

-- Per kind of state, in units of its size.
test_state.vector = { x2 = { "3/4", "-5/8", "9/16" }, x3 = { "-3/8", "1/2", "7/8" } }

local fixed = { x2 = { "1/2", "-1/2", "1/2", "1/2" }, x3 = { "-1/2", "1/2", "1/2", "1/2" } }
-- Turns of 25 degrees: a body on a plane has no contact in every attitude.
local turns = { x2 = { "40/41", "8/41", "-4/41", "1/41" }, x3 = { "40/41", "-1/41", "8/41", "4/41" } }

-- The quaternion of the state of that name; own: the scene's initial state; round: to the emitted type.
function test_state.attitude(job, name, own, round)
  if not contact.of(job.model) then return vec.map(fixed[name], R.lift) end
  local q = {}
  for i, s in ipairs(job.states) do
    if s.kind == "attitude" then q[s.place] = own[i] end
  end
  return vec.map(vec.qmul(q, vec.map(turns[name], R.lift)), round)
end

return test_state
