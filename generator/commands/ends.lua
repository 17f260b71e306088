-- ends.lua -- that a scene's own motion ends before its horizon, for commands that go by its equations alone.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"
local engines = require "generator.commands.run.engines"
local events = require "generator.commands.events"
local happenings = require "generator.dynamics.happenings"

local ends = {}

-- Warns where contact is lost, a disc lies flat or an event stops the motion before `finish` (nil: the horizon).
function ends.warn(host, job, finish)
  finish = finish or job.model:double(job.model.horizon)
  local motion = #events.of(job) > 0 and engines.general(host, job, {})
  if not motion then return end
  local when, failure = events.ending(host, job, motion, finish)
  local said, t = when and when.said or failure and failure.text, when and when.row.t or failure and failure.t
  if said then
    host.err("warning: " .. happenings.at(said, diag.rough(t)) ..
      "; what is measured beyond is of the equations, not of the body\n")
  end
end

return ends
