-- explain.lua -- polhode explain: what was derived from a scene and why.
-- SPDX-License-Identifier: GPL-3.0-or-later

local measure = require "generator.commands.measure"
local options = require "generator.commands.options"
local planner = require "generator.commands.planner"
local driver = require "generator.driver"
local handout = require "generator.report.handout.handout"
local report = require "generator.report.explain"
local difference = require "generator.report.difference"
local inertial = require "generator.report.inertial"
local stiffness = require "generator.plan.stiffness"

local explain = {}

explain.forms = {
  { "SCENE", "what was derived from a scene, and why" },
  { "--diff A B", "the terms by which two scenes differ" },
}
explain.operands = { 1, 2, "SCENE" }
explain.options = {
  { "--format", { "text", "markdown", "latex", "html", "typst", "json", "urdf", "mjcf", "sdf" }, "text and json are " ..
    "explanations; markdown, latex, html and typst a hand-out with set formulas; urdf, mjcf and sdf the <inertial> " ..
    "of a robot file", value = "FORMAT", default = "text" },
  { "--sections", "words", "of a hand-out: all, or some of " .. table.concat(handout.sections, ", "),
    value = "WORD,...", default = "all but attitude and costs" },
  { "--title", "text", "of a hand-out: its title", value = "TEXT", default = "the name of the scene" },
  { "--author", "text", "of a hand-out: the line under its title", value = "TEXT", default = "none" },
  { "--date", "text", "of a hand-out: after the author, as it is written here", value = "TEXT", default = "none" },
  { "--diff", false, "compare two scenes; as text or json" },
  { "--real", { "double", "float" }, "the type for which costs are given", default = "double" },
  { "--target", "words", "count instructions, flash and stack on small processors under emulators: all, or some of " ..
    table.concat(measure.names, ", "), value = "CORE,...", default = "costs are estimated" },
  { "--phase", { "contact", "flight" }, "of a body that flies and lands (effect.plane with impact): the scene on " ..
    "the plane, or in the air", default = "contact" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
}
explain.examples = {
  { "polhode explain brick --set a=0.3", "the whole derivation, for another edge" },
  { "polhode explain brick --format latex --sections tensor,euler", "a hand-out for pdflatex, of these two parts" },
  { "polhode explain brick --format typst --title 'Exercise 3'", "a hand-out with a title of its own" },
  { "polhode explain brick --format urdf", "mass, centre and tensor for a robot file" },
  { "polhode explain --diff brick brick_centroid", "what the corner adds" },
}

local xml = { urdf = true, mjcf = true, sdf = true } -- numbers for other programs, not an explanation

-- The first option that only the head of a hand-out has, or nil.
local function headed(given)
  return given.title and "title" or given.author and "author" or given.date and "date"
end

-- Two scenes: by what the second differs from the first.
local function compared(host, given)
  local format, plans = given.format or "text", {}
  local wrong = #given < 2 and "--diff needs two scenes" or
    format ~= "text" and format ~= "json" and "--diff: --format must be text or json, got " .. format or
    given.target and "--target: a difference has no counted costs" or
    given.sections and "--sections: a difference has none" or
    headed(given) and "--" .. headed(given) .. ": a difference is no hand-out" or
    given.real and "--real: a difference is of expressions, before they have a type"
  if wrong then return options.wrong(host, "explain", wrong) end
  for i = 1, 2 do
    local scene, d, why = driver.read(host, given[i], given)
    if not scene then return options.refuse(host, d, why) end
    options.warn(host, scene.diag)
    plans[i], d = driver.plan(scene, { command = "" })
    if not plans[i] then return options.refuse(host, d) end
  end
  host.out(difference.text(plans[1], plans[2], format))
  return 0
end

-- The sections of a hand-out, nil for the usual ones; second result: what is wrong with the options for one.
local function sections_of(given)
  local list, option = given.sections, given.sections and "sections" or headed(given)
  if option and not handout.formats[given.format] then
    return nil, "--" .. option .. ": --format must be markdown, latex, html or typst, got " .. (given.format or "text")
  end
  if not list then return given.target and handout.sections or nil end
  if #list == 1 and list[1] == "all" then return handout.sections end
  return list, options.unknown("--sections", list, handout.sections, "all")
end

function explain.run(host, given)
  if given.diff then return compared(host, given) end
  if given[2] then return options.wrong(host, "explain", "too many operands: " .. given[2]) end
  local cores, wrong = measure.cores(given.target, given.real)
  if given.target and xml[given.format] then
    cores, wrong = nil, "--target: --format must be text, markdown, latex, html, typst or json, got " .. given.format
  end
  if given.real and xml[given.format] then wrong = "--real: --format " .. given.format .. " has no costs" end
  local sections, mistaken = sections_of(given)
  wrong = wrong or mistaken
  if wrong then return options.wrong(host, "explain", wrong) end
  local scene, d, why = driver.read(host, given[1], given)
  if not scene then return options.refuse(host, d, why) end
  options.warn(host, scene.diag)
  if xml[given.format] then
    host.out(inertial.text(scene, given.format))
    return 0
  end
  local told, counted = { asked = planner.asked(host, scene, given), stiff = stiffness.start(scene) }, nil
  local plan, errors = driver.plan(scene, { command = "", real = given.real })
  if not plan then return options.refuse(host, errors) end
  if cores then
    local unit = driver.files(plan)
    if not unit then return options.refuse(host, plan.diag) end
    counted, why = measure.run(host, unit, cores, unit.files)
    if not counted then return options.failed(host, "explain", why) end
  end
  local unit = driver.code(plan, { counted = counted })
  if not unit then return options.refuse(host, plan.diag) end
  host.out(report.text(unit, given.format or "text", told, sections, given))
  return 0
end

return explain
