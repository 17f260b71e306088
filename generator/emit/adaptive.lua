-- adaptive.lua -- the embedded pair as C: the trial step, printed; templates/steppers/adaptive.c controls it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local source = require "generator.emit.source"
local step_control = require "generator.emit.step_control"
local switched = require "generator.emit.switched"
local template = require "generator.emit.template"

local GROUP = template.group("steppers/adaptive.h", "steppers/adaptive.c")

local function text(n) return string.format("%d", n) end

local adaptive = {}

-- Header and source of the program of methods/adaptive.lua.  s, kit: see emit/steppers.lua.
function adaptive.render(s, kit)
  local program, ctx = s.program, kit.ctx
  local position, names = {}, {}
  for i, state in ipairs(program.states) do
    position[state.name], names[i] = i - 1, state.name
  end
  local groups = {}
  for i, g in ipairs(program.groups) do
    local outs = {}
    for k, o in ipairs(g.outs) do
      outs[k] = { array = o.array, index = text(position[o.index]), expr = o.expr }
    end
    groups[i] = { why = g.why, defs = g.defs, outs = outs }
  end
  local n, attitude = #program.states, program.states[1].name == "qw"
  local args = { "m", "t", "x", "u", "h", { name = "k1", count = n, names = names } }
  if program.switches then args[#args + 1] = switched.sides(program.switches) end
  for _, name in ipairs { "out", "k7", "error" } do args[#args + 1] = { name = name, count = n, out = true } end
  if attitude then args[#args + 1] = { name = "turn", count = 4, out = true } end
  local f = source.make(ctx, { name = "adaptive_trial", groups = groups, doc = {}, args = args })
  local v = { head = f.head, lines = f.lines, count = text(n), states = {}, attitude = attitude,
    turn = attitude and ", turn" or "", room = attitude and ", turn[4]" or "",
    has_knots = s.has_knots, first = s.first, taken = s.taken }
  for i, state in ipairs(program.states) do v.states[i] = { name = ctx.upper .. "_" .. string.upper(state.name) } end
  switched.put(v, s, kit, "adaptive")
  step_control.put(v, s, kit, "adaptive")
  local render = GROUP(kit.templates, kit.base, v)
  return render "steppers/adaptive.h", { render "steppers/adaptive.c" }
end

return adaptive
