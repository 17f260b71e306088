-- midpoint.lua -- the midpoint rule as C: iteration and last part printed, the loop in templates/steppers/midpoint.c.
-- SPDX-License-Identifier: GPL-3.0-or-later

local source = require "generator.emit.source"
local template = require "generator.emit.template"

local GROUP = template.group("steppers/midpoint.h", "steppers/midpoint.c")

local midpoint = {}

-- Header and source of the program of methods/midpoint.lua.  s, kit: see emit/steppers.lua.
function midpoint.render(s, kit)
  local program, ctx = s.program, kit.ctx
  local v = { count = string.format("%d", program.count), free = program.count == 4, first = s.first,
    transition = program.transition ~= nil, transition_u = program.transition_u ~= nil }
  local function put(name, groups, x, out)
    local args = { "m", "t", x, "u", "h", { name = "mid", count = 3 }, out }
    local f = source.make(ctx, { name = "midpoint_" .. name, groups = groups, doc = {}, args = args })
    v[name .. "_head"], v[name .. "_lines"] = f.head, f.lines
  end
  local groups = {}
  for i, g in ipairs(program.iteration) do
    local outs = {}
    for k, o in ipairs(g.outs) do
      outs[k] = { array = o.array, index = string.format("%d", o.index - 1), expr = o.expr }
    end
    groups[i] = { why = g.why, defs = g.defs, outs = outs }
  end
  put("newton", groups, "x", { name = "next", count = 3, out = true })
  put("finish", program.finish, "x!")
  local n = #ctx.states
  if v.transition then put("tangent", program.transition, "x", { name = "F", count = n * n, out = true }) end
  if v.transition_u then
    put("tangent_u", program.transition_u, "x", { name = "G", count = n * #ctx.inputs, out = true })
  end
  local render = GROUP(kit.templates, kit.base, v)
  return render "steppers/midpoint.h", { render "steppers/midpoint.c" }
end

return midpoint
