-- proof.lua -- NAME_proof.c (gen --with proof): what drives the steppers under Frama-C's Eva.
--
--     proof.check(job) -> bool         can it be asked of this scene?  If not, with an error in job.diag
--     proof.fill(job, v)               values for templates/test/proof.c, order.c and the Makefile
-- What is shown and under which assumptions: docs/proof.md.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local inputs = require "generator.dynamics.inputs"
local number = require "generator.emit.number"
local guard = require "generator.emit.guard"

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

function proof.fill(job, v)
  v.has_proof = job.proof or false
  if not v.has_proof then return end
  local real = job.real
  local function text(q) return number.text(q, real) end
  v.proof_largest = text(largest[real])
  v.proof_step = job.planned and v.upper .. "_PLANNED_STEP" or v.step_literal
  v.proof_part = text(guard.part)
  v.proof_params, v.proof_cases = {}, divides_by_norm(job)
  for i, p in ipairs(job.ranges.params) do
    local low, high = guard.ends(p, real)
    v.proof_params[i] = { name = v.upper .. "_" .. string.upper(p.name), low = low, high = high }
  end
  v.proof_inputs = {}
  for i, s in ipairs(job.model.inputs) do
    local low, high = inputs.range(job.model, s)
    v.proof_inputs[i] = { name = v.upper .. "_" .. s.index, low = text(low), high = text(high) }
  end
  v.proof_steps, v.proof_reached = {}, ""
  for i, s in ipairs(job.steppers) do
    local step = i == 1 and "step" or s.method.name .. "_step"
    v.proof_steps[i], v.proof_reached = step, v.proof_reached .. " " .. step .. "_done"
  end
  v.proof_own = job.libm == "own"
  local f = real == "float" and "f" or ""
  v.proof_cpp = "-I." .. (v.proof_own and string.format(" -include math.h -D__builtin_sqrt%s=sqrt%s" ..
    " -D__builtin_fabs%s=fabs%s", f, f, f, f) or "")
  v.proof_options = "-eva -eva-precision 3 -eva-split-return auto -warn-special-float non-finite" ..
    " -kernel-warn-key parser:decimal-float=inactive" ..
    (v.proof_cases and " -eva-split-return-function part:full" or "") ..
    (v.has_order and " -eva-use-spec " .. v.name .. "_order" or "")
end

return proof
