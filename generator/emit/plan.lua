-- plan.lua -- the planned method as C: values for templates/steppers/plan.* and the self-test; the header's report.
--
-- job.planned is what generator/plan/decision.lua describes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local template = require "generator.emit.template"

local plan = {}

local about = { step = { "step", "s", "STEP" }, tolerance = { "tolerance", "1", "TOLERANCE" } }

local function notes(p, v)
  if p.setting == "step" then
    return { "The span is cut into equal steps no longer than " .. v.upper .. "_PLANNED_STEP." }
  elseif p.setting == "tolerance" and p.method == "taylor" then
    return { "The tolerance is that of the whole horizon; a part of it has its share." }
  elseif p.setting == "tolerance" then
    return { "The tolerance is that of each step." }
  end
  return { "The closed form through x, once; for many times from one state call " .. v.name .. "_solve and " ..
    v.name .. "_at." }
end

-- Numbers two to a line.
local function lines(list)
  local out = {}
  for i = 1, #list, 2 do
    out[#out + 1] = list[i] .. (list[i + 1] and ", " .. list[i + 1] or "") .. (list[i + 2] and "," or "")
  end
  return out
end

-- Sets v.planned and what the templates want; returns the parts of header and source, or nil.
function plan.render(job, v)
  local p = job.planned
  v.planned = p ~= nil
  if not p then return nil end
  local real = job.real
  local names = about[p.setting]
  v.plan_accuracy, v.plan_method = p.accuracy_text, p.title
  v.plan_steps = names ~= nil
  if names then
    v.plan_what, v.plan_unit, v.plan_constant = table.unpack(names)
    v.plan_literal = number.text(R.parse(p.value_text), real)
  end
  v.plan_note = notes(p, v)
  v.plan_input = v.has_inputs and ", the input u held" or ""
  v.plan_kind_step, v.plan_kind_run = p.setting == "step", p.setting == "tolerance"
  v.plan_kind_closed, v.plan_run, v.plan_share = p.setting == "none", p.method, p.method == "taylor"
  v.plan_slack = number.text(R.new(2) ^ (real == "float" and -20 or -40), real)
  local want, tolerance = {}, {}
  for i, text in ipairs(p.expected) do
    want[i] = number.text(R.parse(text), real)
    tolerance[i] = number.text(R.parse(p.bounds[i]), real)
  end
  v.plan_want, v.plan_tolerance = lines(want), lines(tolerance)
  local banner = { table.unpack(v.banner) }
  for _, line in ipairs(p.report) do banner[#banner + 1] = line end
  v.banner = banner
  return template.render("templates/steppers/plan.h", job.templates["templates/steppers/plan.h"], v),
    template.render("templates/steppers/plan.c", job.templates["templates/steppers/plan.c"], v)
end

return plan
