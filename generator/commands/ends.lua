-- ends.lua -- that a scene's own motion ends before its horizon, for commands that go by its equations alone.
--
-- Where contact is lost or an event stops the motion the equations lead on, and a warning is enough.  From a disc that
-- lies flat none leads on: who measures a motion refuses it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"
local engines = require "generator.commands.run.engines"
local events = require "generator.commands.events"
local happenings = require "generator.dynamics.happenings"
local options = require "generator.commands.options"

local ends = {}

-- What ends the motion before `finish` (nil: the horizon), in words; nil if nothing does.  Second result: does no
-- motion lead on?
local function of(host, job, finish)
  finish = finish or job.model:double(job.model.horizon)
  local motion = #events.of(job) > 0 and engines.general(host, job, {})
  if not motion then return nil end
  local when, failure = events.ending(host, job, motion, finish)
  if when then return happenings.at(when.said, diag.rough(when.row.t)), when.event.name == "lies_flat" end
  if failure then return happenings.at(failure.text, diag.rough(failure.t or 0.0)), true end
  return nil
end

local function warn(host, said)
  host.err("warning: " .. said .. "; what is measured beyond is of the equations, not of the body\n")
end

function ends.warn(host, job, finish)
  local said = of(host, job, finish)
  if said then warn(host, said) end
end

-- The exit status where no motion leads on, after the message; else nil, after a warning if there is one.
function ends.refused(host, job, command, finish)
  local said, over = of(host, job, finish)
  if over then return options.failed(host, command, said .. "; no motion leads on to the end", 3) end
  if said then warn(host, said) end
  return nil
end

return ends
