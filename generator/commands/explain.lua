-- explain.lua -- polhode explain: what was derived from a scene and why.
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"
local driver = require "generator.driver"
local report = require "generator.report.explain"
local inertial = require "generator.report.inertial"

local explain = {}

explain.options = { ["--format"] = { "text", "markdown", "latex", "json", "urdf", "mjcf", "sdf" }, ["--set"] = "pair" }
explain.operands = { 1, 1 }

local xml = { urdf = true, mjcf = true, sdf = true } -- numbers for other programs, not an explanation

function explain.run(host, given)
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  options.warn(host, job.diag)
  if xml[given.format] then
    host.out(inertial.text(job, given.format))
    return 0
  end
  driver.plan(job, { command = "" })
  host.out(report.text(job, given.format or "text"))
  return 0
end

return explain
