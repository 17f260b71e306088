-- steppers.lua -- the steppers that are no single function: their parts of header and source.
-- SPDX-License-Identifier: GPL-3.0-or-later

local number = require "generator.emit.number"
local plan = require "generator.emit.plan"
local template = require "generator.emit.template"

local steppers = {}

local taylor = require "generator.emit.taylor"

local fill = { taylor = taylor.fill, adaptive = require("generator.emit.adaptive").fill,
  split = require("generator.emit.split").fill, midpoint = require("generator.emit.midpoint").fill }

-- The function that tells the next corner of a table, printed once, before the first stepper that stops there.
local function knots_of(job, v, ctx, knots)
  v.knots = {}
  for i, k in ipairs(knots) do
    v.knots[i] = k.time.kind == "num" and number.text(k.time.value, ctx.real) or "m->" .. k.time.name
  end
  v.knots_count, v.knots_static = string.format("%d", #knots), true
  for _, k in ipairs(knots) do v.knots_static = v.knots_static and k.time.kind == "num" end
  return template.render("templates/steppers/knots.c", job.templates["templates/steppers/knots.c"], v)
end

-- Fills stepper_header, stepper_source and steppers, the list for the program's own use: {name, step (C name), run,
-- order}.
function steppers.render(job, v, ctx)
  v.stepper_header, v.stepper_source, v.steppers = "", "", {}
  v.planning, v.plan_orders = job.orders ~= nil, {}
  for i, n in ipairs(job.orders or {}) do v.plan_orders[i] = string.format("%d", n) end
  local headers, sources = {}, {}
  for i, s in ipairs(job.steppers) do
    local own = { name = s.method.name, step = i == 1 and "step" or s.method.name .. "_step",
      run = s.method.adaptive or false, order = string.format("%d", s.method.order or s.program.order or 0) }
    v.steppers[i] = own
    if s.program then
      local kind = s.method.template or own.name
      v.has_knots = s.program.knots ~= nil and #s.program.knots > 0
      if v.has_knots and not v.knots then sources[#sources + 1] = knots_of(job, v, ctx, s.program.knots) end
      fill[kind](ctx, s.program, v)
      v.first = i == 1
      local path = "templates/steppers/" .. kind
      headers[#headers + 1] = template.render(path .. ".h", job.templates[path .. ".h"], v)
      local function source(part, values)
        sources[#sources + 1] = template.render(part, job.templates[part], values)
      end
      if kind == "taylor" and s.program.top then
        local own_terms = "templates/steppers/taylor_top.c"
        v.taylor_top_text = template.render(own_terms, job.templates[own_terms], v)
      end
      source(path .. ".c", v)
      if kind == "taylor" then
        source(path .. "_run.c", v)
        if s.program.transition then source(path .. "_transition.c", taylor.transition(ctx, s.program, v)) end
        if v.has_knots then source(path .. "_knots.c", v) end
        if v.has_compensated then source(path .. "_compensated.c", v) end
      end
    end
  end
  headers[#headers + 1], sources[#sources + 1] = plan.render(job, v)
  v.stepper_header, v.stepper_source = table.concat(headers, "\n"), table.concat(sources, "\n")
end

return steppers
