-- check.lua -- polhode check: emitted code against the general library and the invariants, as TAP.
--
-- For each scene, in double and float: compile with warnings as errors, then compare over random parameters and states.
-- What is compared and how much may differ:
--   tensor      the library's from the shapes; a few roundings of the largest entry each
--   rates       1000 random states; 8 ulp of the largest term that was added (host.rates gives it)
--   energy, momentum   8 ulp of the largest term
--   Jacobian    against central differences of the emitted rates, whose own error is eps^(2/3) of the scale
--   steppers    all that take the scene: their order, by halving h, or their tolerance, against the library's motion
--   closed form against the library's exact solver at the emitted tensor: what both promise
-- Exit status 3 when a number fails.
-- SPDX-License-Identifier: GPL-3.0-or-later

local json = require "generator.report.json"
local options = require "generator.commands.options"
local build = require "generator.commands.build"
local driver = require "generator.driver"
local comparison = require "generator.commands.comparison"
local progress = require "generator.commands.progress"
local stepper_checks = require "generator.commands.stepper_checks"

local check = {}

local most = 1000000 -- states: minutes for a scene

check.forms = { { "SCENE...", "emitted code against the general library",
  "The code is compiled and compared over random states and parameters, as TAP; see docs/design.md." } }
check.operands = { 1, math.huge, "SCENE" }
check.options = {
  { "--real", { "double", "float" }, "the type of the emitted code's numbers", default = "both, one after the other" },
  { "--states", "number", "how many random states, at least 1", value = "N", default = "1000" },
}
check.examples = { { "polhode check dropped_stone foucault --real double", "two scenes, in double alone" } }

-- Prints one result a line; while a terminal shows how far the work is, that line is cleared first.
local function results(host, bar)
  local tap = { n = 0, failed = 0 }
  function tap.ok(pass, what, detail)
    tap.n = tap.n + 1
    if not pass then tap.failed = tap.failed + 1 end
    local tail = detail and " (" .. detail .. ")" or ""
    bar.clear()
    host.out(string.format("%s %d - %s%s\n", pass and "ok" or "not ok", tap.n, what, tail))
  end
  return tap
end

-- The checks of one scene, of both types of numbers unless one is given; the exit status of what fails before them, and
-- whether nothing can be checked.  from, to: how far the work is, before and after.
local function one(host, tap, bar, scene, given, states, from, to)
  local worst = 0
  local names, others = stepper_checks.choice(scene)
  local reals = given.real and { given.real } or { "double", "float" }
  for k, real in ipairs(reals) do
    bar.show(scene.model.name .. ", " .. real, from + (to - from) * (k - 1) / #reals)
    local plugin, kind, why
    local job, d = driver.plan(scene, { real = real, command = "", methods = names })
    if job then
      plugin, why, kind = build.plugin(host, job)
    else
      worst = math.max(worst, options.refuse(host, d))
    end
    if kind == "compiler" then
      host.out("Bail out! No C compiler.\n")
      return options.failed(host, "check", why), true
    end
    -- what float cannot hold is no fault of a scene that is checked in double beside it
    local refused = kind == "range" and real == "float" and not given.real
    local what = scene.model.name .. ", " .. real .. ": the emitted code compiles without a warning"
    if refused then what = what .. " # SKIP its constants are outside the range of float; --real float says which" end
    tap.ok(plugin ~= nil or refused, what)
    if plugin then
      for _, o in ipairs(real == "double" and others or {}) do
        host.out("# " .. o[1] .. " does not take " .. scene.model.name .. ": " .. o[2] .. "\n")
      end
      comparison.run(host, job, plugin, tap, math.tointeger(states))
    elseif not refused then
      if kind == "range" then worst = math.max(worst, 1) end
      if why then host.err(why .. "\n") end -- else it was said where the plan failed
    end
  end
  return worst
end

function check.run(host, given)
  local states = given.states or 1000
  if not (states >= 1 and states <= most and states % 1 == 0) then
    return options.wrong(host, "check", "--states must be a whole number from 1 to " .. string.format("%d", most) ..
      ", got " .. json.number(states))
  end
  local bar = progress.of(host)
  local tap = results(host, bar)
  host.out("TAP version 13\n")
  local worst = 0
  for i = 1, #given do
    local scene, d, unread = driver.read(host, given[i], {})
    local phases = { scene }
    if not scene then
      worst = math.max(worst, options.refuse(host, d, unread))
      tap.ok(false, given[i] .. " is a scene")
    elseif scene.record.flies then
      scene, d = driver.flight(scene, {})
      if not scene then worst = math.max(worst, options.refuse(host, d)) end
      phases[2] = scene
    end
    for k, phase in ipairs(phases) do
      if k == #phases then options.warn(host, phase.diag) end -- what the phases share is said once
      local status, ends = one(host, tap, bar, phase, given, states, (i - 1 + (k - 1) / #phases) / #given,
        (i - 1 + k / #phases) / #given)
      if ends then return status end
      worst = math.max(worst, status)
    end
  end
  bar.clear()
  host.out("1.." .. tap.n .. "\n")
  if worst > 0 then return worst end
  return tap.failed > 0 and 3 or 0
end

return check
