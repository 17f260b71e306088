-- plan.lua -- the planned method as C: templates/steppers/plan.*, and what the self-test expects of it.
--
-- job.planned is what generator/plan/decision.lua describes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local template = require "generator.emit.template"

local GROUP = template.group("steppers/plan.h", "steppers/plan.c")

local plan = {}

local about = { step = { "step", "s", "STEP" }, tolerance = { "tolerance", "1", "TOLERANCE" } }

local function notes(p, base)
  if p.setting == "step" then
    return { "The span is cut into equal steps no longer than " .. base.upper .. "_PLANNED_STEP." }
  elseif p.setting == "tolerance" and p.method == "taylor" then
    return { "The tolerance is that of the whole horizon; a part of it has its share." }
  elseif p.setting == "tolerance" then
    return { "The tolerance is that of each step." }
  end
  return { "The closed form through x, once; for many times from one state call " .. base.name .. "_solve and " ..
    base.name .. "_at." }
end

-- Numbers two to a line.
local function lines(list)
  local out = {}
  for i = 1, #list, 2 do
    out[#out + 1] = list[i] .. (list[i + 1] and ", " .. list[i + 1] or "") .. (list[i + 2] and "," or "")
  end
  return out
end

-- nil if nothing is planned, else {header, source, want, tolerance = lines of the state at the horizon}.
function plan.render(job, base)
  local p = job.planned
  if not p then return nil end
  local real, names = job.real, about[p.setting]
  local v = { accuracy = p.accuracy_text, method = p.title, steps = names ~= nil, note = notes(p, base),
    input = base.has_inputs and ", the input u held" or "", kind_step = p.setting == "step",
    kind_run = p.setting == "tolerance", kind_closed = p.setting == "none", run = p.method,
    share = p.method == "taylor", slack = number.text(R.new(2) ^ (real == "float" and -20 or -40), real) }
  if names then
    v.what, v.unit, v.constant = table.unpack(names)
    v.literal = number.text(R.parse(p.value_text), real)
  end
  local want, tolerance = {}, {}
  for i, text in ipairs(p.expected) do
    want[i] = number.text(R.parse(text), real)
    tolerance[i] = number.text(R.parse(p.bounds[i]), real)
  end
  local render = GROUP(job.templates, base, v)
  return { header = render "steppers/plan.h", source = render "steppers/plan.c", want = lines(want),
    tolerance = lines(tolerance) }
end

return plan
