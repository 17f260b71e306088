-- steppers.lua -- the steppers that are no single function: their parts of header and source.
--
-- Each kind has a file of its own with
--     render(s, kit) -> header, list of sources
--     s: {program (of methods/), first = is it NAME_step too?, has_knots, taken = what a controlled step ends with}
--     kit: {templates, base, ctx, knots_count = text, corners (emit/switched.lua), compensated, planning}
-- SPDX-License-Identifier: GPL-3.0-or-later

local floors = require "generator.emit.floors"
local later = require "generator.later"
local number = require "generator.emit.number"
local step_control = require "generator.emit.step_control"
local switched = require "generator.emit.switched"
local plan = require "generator.emit.plan"
local template = require "generator.emit.template"

local steppers = {}

-- by the method's name, or by what it gives as its template
local KINDS = { taylor = later "generator.emit.taylor", adaptive = later "generator.emit.adaptive",
  split = later "generator.emit.split", midpoint = later "generator.emit.midpoint",
  rosenbrock = later "generator.emit.rosenbrock" }

local KNOTS, TAKEN = template.group "steppers/knots.c", template.group "steppers/taken.c"

-- The function that tells the next corner of a table, printed once, before the first stepper that stops there.
local function knots_of(kit, knots)
  local v = { knots = {}, count = string.format("%d", #knots), static = true }
  for i, k in ipairs(knots) do
    v.knots[i] = k.time.kind == "num" and number.text(k.time.value, kit.ctx.real) or "m->" .. k.time.name
    v.static = v.static and k.time.kind == "num"
  end
  kit.knots_count = v.count
  return KNOTS(kit.templates, kit.base, v) "steppers/knots.c"
end

-- {header, source, list = of {name, step (C name), run, order} for the program's own use, planned = see plan.lua}
function steppers.render(job, base, ctx)
  local kit = { templates = job.templates, base = base, ctx = ctx, knots_count = nil,
    compensated = job.compensated or false, planning = job.orders ~= nil }
  local headers, sources, list = {}, {}, {}
  local least, estimated
  for _, s in ipairs(job.steppers) do
    least = least or s.program and s.program.floors
    estimated = estimated or s.method.name == "adaptive" or s.method.name == "rosenbrock"
  end
  kit.corners = switched.needed(job.steppers)
  if least then sources[1] = floors.shared(kit, least) end
  if estimated then sources[#sources + 1] = step_control.shared(kit) end
  if kit.corners then sources[#sources + 1] = switched.shared(kit, kit.corners) end
  for i, s in ipairs(job.steppers) do
    local own = { name = s.method.name, step = i == 1 and "step" or s.method.name .. "_step",
      run = s.method.adaptive or false, order = string.format("%d", s.method.order or s.program.order or 0) }
    list[i] = own
    if s.program then
      local has_knots = s.program.knots ~= nil and #s.program.knots > 0
      if has_knots and not kit.knots_count then sources[#sources + 1] = knots_of(kit, s.program.knots) end
      local header, parts = KINDS[s.method.template or own.name].render({ program = s.program, first = i == 1,
        has_knots = has_knots, taken = s.method.adaptive and TAKEN(job.templates, base,
          { has_knots = has_knots }) "steppers/taken.c" }, kit)
      headers[#headers + 1] = header
      for _, part in ipairs(parts) do sources[#sources + 1] = part end
    end
  end
  local planned = plan.render(job, base)
  if planned then headers[#headers + 1], sources[#sources + 1] = planned.header, planned.source end
  return { header = table.concat(headers, "\n"), source = table.concat(sources, "\n"), list = list,
    planned = planned }
end

return steppers
