-- proof.lua -- NAME_proof.c (gen --with proof): what drives the steppers under Frama-C's Eva.
--
--     proof.check(job) -> bool         can it be asked of this scene?  If not, with an error in job.diag
--     proof.of(job, base, order)       nil, or {text = of NAME_proof.c, make = values for the Makefile}
-- What is shown and under which assumptions: docs/proof.md.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local inputs = require "generator.dynamics.inputs"
local number = require "generator.emit.number"
local guard = require "generator.emit.guard"
local template = require "generator.emit.template"

local GROUP = template.group "test/proof.c"

local proof = {}

-- Steppers whose quotients stay finite for a reason that intervals do not show: numerator and divisor vanish together.
local function beyond(s)
  local drift = s.program and s.program.drift
  if drift and (drift.kind == "diagonal" or drift.kind == "full") then
    return "the splitting of a body with three different moments divides by L^2, which intervals let be 0"
  elseif s.program and s.program.shift then
    return "the series of a free body with three different moments divides by |L|, which intervals let be 0"
  end
  return nil
end

-- The first input without limits, or nil.
local function unlimited(job)
  for _, s in ipairs(job.model.inputs) do
    if not s.low then return s end
  end
  return nil
end

-- Does a step divide by |q|?  That it is not 0 shows only where the cases of a large component are told apart.
local function divides_by_norm(job)
  for _, s in ipairs(job.steppers) do
    local name = s.method.name
    if job.model.has.attitude and (name == "midpoint" or name == "semi" and job.model.frame) then return true end
  end
  return false
end

-- Eva follows intervals: whatever enters a step must have ends, and the step a fixed length.
function proof.check(job)
  local line = job.record.line
  local function refuse(rule, got)
    job.diag:error(line, "with proof", rule, got)
    return false
  end
  if not job.ranges then
    return refuse("the scene must declare ranges, of every state but the attitude", "a scene without")
  end
  line = job.ranges.line
  local missing = {}
  for i, s in ipairs(job.states) do
    if s.kind ~= "attitude" and not job.ranges.states[i] then missing[#missing + 1] = s.name end
  end
  if #missing > 0 then
    return refuse("ranges must have every state but the attitude", "none of " .. table.concat(missing, ", "))
  end
  local open = unlimited(job)
  if open then
    line = open.line
    return refuse("every input must have limits: effect.control{ max = }, input(name, unit, { min =, max = })",
      open.label .. " without")
  end
  if job.planned and job.planned.setting ~= "step" then
    return refuse("NAME_step must have a fixed step", "a plan with " .. (job.planned.setting == "none" and
      "the closed form" or "a tolerance"))
  end
  for _, s in ipairs(job.steppers) do
    local why = beyond(s)
    if why then return refuse("interval analysis must follow the method: " .. why, s.method.name) end
  end
  return true
end

local two = R.new(2)
local largest = { float = (two - two ^ -23) * two ^ 127, double = (two - two ^ -52) * two ^ 1023 }

-- order: does NAME_init compute signs of moments (templates/numeric/order.c)?
function proof.of(job, base, order)
  if not job.proof then return nil end
  local real, own = job.real, job.libm == "own"
  local function text(q) return number.text(q, real) end
  local v = { largest = text(largest[real]), part = text(guard.part), params = {}, inputs = {}, steps = {},
    h = job.planned and base.upper .. "_PLANNED_STEP" or base.step_literal, cases = divides_by_norm(job) }
  for i, p in ipairs(job.ranges.params) do
    local low, high = guard.ends(p, real)
    v.params[i] = { name = base.upper .. "_" .. string.upper(p.name), low = low, high = high }
  end
  for i, s in ipairs(job.model.inputs) do
    local low, high = inputs.range(job.model, s)
    v.inputs[i] = { name = base.upper .. "_" .. s.index, low = text(low), high = text(high) }
  end
  local reached = ""
  for i, s in ipairs(job.steppers) do
    local step = i == 1 and "step" or s.method.name .. "_step"
    v.steps[i], reached = step, reached .. " " .. step .. "_done"
  end
  local f = real == "float" and "f" or ""
  v.cpp = "-I." .. (own and string.format(" -include math.h -D__builtin_sqrt%s=sqrt%s" ..
    " -D__builtin_fabs%s=fabs%s", f, f, f, f) or "")
  v.options = "-eva -eva-precision 3 -eva-split-return auto -warn-special-float non-finite" ..
    " -kernel-warn-key parser:decimal-float=inactive" ..
    (v.cases and " -eva-split-return-function part:full" or "") ..
    (order and " -eva-use-spec " .. base.name .. "_sort_moments" or "")
  return { text = GROUP(job.templates, base, v) "test/proof.c",
    make = { cases = v.cases, cpp = v.cpp, options = v.options, own = own, reached = reached } }
end

return proof
