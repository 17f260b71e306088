-- steppers.lua -- the steppers that are no single function: their parts of header and source.
-- SPDX-License-Identifier: GPL-3.0-or-later

local template = require "generator.emit.template"

local steppers = {}

local fill = { taylor = require("generator.emit.taylor").fill, adaptive = require("generator.emit.adaptive").fill,
  split = require("generator.emit.split").fill, midpoint = require("generator.emit.midpoint").fill }

-- Fills stepper_header, stepper_source and steppers, the list for the program's own use: {name, step (C name), run,
-- order}.
function steppers.render(job, v, ctx)
  v.stepper_header, v.stepper_source, v.steppers = "", "", {}
  local headers, sources = {}, {}
  for i, s in ipairs(job.steppers) do
    local own = { name = s.method.name, step = i == 1 and "step" or s.method.name .. "_step",
      run = s.method.adaptive or false, order = string.format("%d", s.method.order or s.program.order or 0) }
    v.steppers[i] = own
    if s.program then
      local kind = s.method.template or own.name
      fill[kind](ctx, s.program, v)
      v.first = i == 1
      local path = "templates/" .. kind
      headers[#headers + 1] = template.render(path .. ".h", job.templates[path .. ".h"], v)
      sources[#sources + 1] = template.render(path .. ".c", job.templates[path .. ".c"], v)
    end
  end
  v.stepper_header, v.stepper_source = table.concat(headers, "\n"), table.concat(sources, "\n")
end

return steppers
