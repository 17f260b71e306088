-- midpoint.lua -- the midpoint rule as C: iteration and last part printed, the loop in templates/steppers/midpoint.c.
-- SPDX-License-Identifier: GPL-3.0-or-later

local source = require "generator.emit.source"

local midpoint = {}

-- Fills the template's values for the program of methods/midpoint.lua.
function midpoint.fill(ctx, program, v)
  local groups = {}
  for i, g in ipairs(program.iteration) do
    local outs = {}
    for k, o in ipairs(g.outs) do
      outs[k] = { array = o.array, index = string.format("%d", o.index - 1), expr = o.expr }
    end
    groups[i] = { why = g.why, defs = g.defs, outs = outs }
  end
  local f = source.make(ctx, { name = "midpoint_newton", groups = groups, doc = {},
    args = { "m", "t", "x", "u", "h", { name = "mid", count = 3 }, { name = "next", count = 3, out = true } } })
  v.midpoint_newton_head, v.midpoint_newton_lines = f.head, f.lines
  f = source.make(ctx, { name = "midpoint_finish", groups = program.finish, doc = {},
    args = { "m", "t", "x!", "u", "h", { name = "mid", count = 3 } } })
  v.midpoint_finish_head, v.midpoint_finish_lines = f.head, f.lines
  v.midpoint_transition = program.transition ~= nil
  if program.transition then
    local n = #ctx.states
    f = source.make(ctx, { name = "midpoint_tangent", groups = program.transition, doc = {},
      args = { "m", "t", "x", "u", "h", { name = "mid", count = 3 }, { name = "F", count = n * n, out = true } } })
    v.midpoint_tangent_head, v.midpoint_tangent_lines = f.head, f.lines
  end
  v.midpoint_transition_u = program.transition_u ~= nil
  if program.transition_u then
    f = source.make(ctx, { name = "midpoint_tangent_u", groups = program.transition_u, doc = {},
      args = { "m", "t", "x", "u", "h", { name = "mid", count = 3 },
        { name = "G", count = #ctx.states * #ctx.inputs, out = true } } })
    v.midpoint_tangent_u_head, v.midpoint_tangent_u_lines = f.head, f.lines
  end
  v.midpoint_count = string.format("%d", program.count)
  v.midpoint_free = program.count == 4
end

return midpoint
