-- adaptive.lua -- the embedded pair as C: the trial step, printed; templates/steppers/adaptive.c controls it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local source = require "generator.emit.source"

local function text(n) return string.format("%d", n) end

local adaptive = {}

-- Fills the template's values for the program of methods/adaptive.lua.
function adaptive.fill(ctx, program, v)
  local position, names = {}, {}
  for i, s in ipairs(program.states) do
    position[s.name], names[i] = i - 1, s.name
  end
  local groups = {}
  for i, g in ipairs(program.groups) do
    local outs = {}
    for k, o in ipairs(g.outs) do
      outs[k] = { array = o.array, index = text(position[o.index]), expr = o.expr }
    end
    groups[i] = { why = g.why, defs = g.defs, outs = outs }
  end
  local n = #program.states
  local f = source.make(ctx, { name = "adaptive_trial", groups = groups, doc = {},
    args = { "m", "t", "x", "u", "h", { name = "k1", count = n, names = names },
      { name = "out", count = n, out = true }, { name = "k7", count = n, out = true },
      { name = "error", count = n, out = true }, program.states[1].name == "qw" and { name = "turn", count = 4, out =
        true } or
      nil } })
  v.adaptive_head, v.adaptive_lines = f.head, f.lines
  v.adaptive_count, v.adaptive_states = text(n), {}
  for i, s in ipairs(program.states) do
    v.adaptive_states[i] = { index = text(i - 1), name = ctx.upper .. "_" .. string.upper(s.name) }
  end
  v.adaptive_attitude = program.states[1].name == "qw"
  v.adaptive_turn, v.adaptive_room = v.adaptive_attitude and ", turn" or "", v.adaptive_attitude and ", turn[4]" or ""
  v.kinds = source.kinds(program.states)
end

return adaptive
