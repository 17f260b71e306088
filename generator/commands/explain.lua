-- explain.lua -- polhode explain: what was derived from a scene and why.
-- SPDX-License-Identifier: GPL-3.0-or-later

local measure = require "generator.commands.measure"
local options = require "generator.commands.options"
local planner = require "generator.commands.planner"
local driver = require "generator.driver"
local report = require "generator.report.explain"
local difference = require "generator.report.difference"
local inertial = require "generator.report.inertial"

local explain = {}

explain.options = { ["--format"] = { "text", "markdown", "latex", "json", "urdf", "mjcf", "sdf" }, ["--set"] = "pair",
  ["--diff"] = false, ["--real"] = { "double", "float" }, ["--target"] = "words" }
explain.operands = { 1, 2 }

local xml = { urdf = true, mjcf = true, sdf = true } -- numbers for other programs, not an explanation

-- Two scenes: by what the second differs from the first.
local function compared(host, given)
  local format, jobs = given.format or "text", {}
  if #given < 2 then
    host.err "polhode explain: --diff needs two scenes\n"
    return 2
  end
  if format ~= "text" and format ~= "json" then
    host.err("polhode explain: --diff: --format must be text or json, got " .. format .. "\n")
    return 2
  end
  for i = 1, 2 do
    local job, d, why = driver.read(host, given[i], given)
    if not job then return options.refuse(host, given[i], d, why) end
    options.warn(host, job.diag)
    jobs[i] = driver.plan(job, { command = "" })
    if not jobs[i] then return options.refuse(host, given[i], job.diag) end
  end
  host.out(difference.text(jobs[1], jobs[2], format))
  return 0
end

function explain.run(host, given)
  if given.diff then return compared(host, given) end
  if given[2] then
    host.err("polhode explain: too many operands: " .. given[2] .. "\n")
    return 2
  end
  local cores, wrong = measure.cores(given.target, given.real)
  if given.target and xml[given.format] then
    cores, wrong = nil, "--target: --format must be text, markdown, latex or json, got " .. given.format
  end
  if wrong then
    host.err("polhode explain: " .. wrong .. "\n")
    return 2
  end
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  options.warn(host, job.diag)
  if xml[given.format] then
    host.out(inertial.text(job, given.format))
    return 0
  end
  job.asked = planner.asked(host, job, given)
  if not driver.plan(job, { command = "", real = given.real }) then
    return options.refuse(host, given[1], job.diag)
  end
  if cores then
    local files = driver.files(host, job)
    if not files then return options.refuse(host, given[1], job.diag) end
    job.counted, why = measure.run(host, job, cores, files)
    if not job.counted then
      host.err("polhode explain: " .. why .. "\n")
      return 2
    end
  end
  host.out(report.text(job, given.format or "text"))
  return 0
end

return explain
