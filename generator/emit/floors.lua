-- floors.lua -- the least sizes of methods/floors.lua as C, printed once before the steppers that call them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local FLOORS = template.group "steppers/floors.c"

local floors = {}

-- In space: by the terms of the forces.
local function in_space(kit, list)
  local groups = {}
  for i, g in ipairs(list.groups) do
    local outs = {}
    for k, o in ipairs(g.outs) do
      outs[k] = { array = o.array, index = string.format("%d", o.index), expr = o.expr }
    end
    groups[i] = { why = g.why, defs = g.defs, outs = outs }
  end
  local f = source.make(kit.ctx, { name = "floors", groups = groups, doc = {}, args = { "m", "t", "x", "u", "h",
    { name = "least", count = "2", out = true } } })
  return FLOORS(kit.templates, kit.base, { in_space = true, head = f.head, lines = f.lines }) "steppers/floors.c"
end

-- The function, for what `list` says of one of the steppers' programs.
function floors.shared(kit, list)
  if list.groups then return in_space(kit, list) end
  local ctx = kit.ctx
  local v = { in_space = false, head = "", lines = {} }
  v.uses_model, v.rates, v.speeds = false, {}, {}
  for _, key in ipairs { "pull", "reach", "turn" } do
    local e = list[key]
    v.uses_model = v.uses_model or e.kind ~= "num"
    v[key] = e.kind == "num" and number.text(e.value, ctx.real) or "m->" .. e.name
  end
  for _, s in ipairs(ctx.states) do
    local place = list.places[s.name]
    local of = place == 0 and v.rates or place == 1 and v.speeds or {}
    of[#of + 1] = { name = ctx.upper .. "_" .. string.upper(s.name) }
  end
  return FLOORS(kit.templates, kit.base, v) "steppers/floors.c"
end

-- What a norm is given for the floors at the start of its arguments, "" where there are none; m, u, h: as the caller
-- has the model, the input and the step.
function floors.passed(program, m, u, h)
  if not program.floors then return "" end
  return m .. ", " .. (program.floors.groups and "t, " .. u .. ", " or "") .. h .. ", "
end

-- The values of norm.c into v: to each of v.kinds the argument `least`, empty texts where the scene has none.
function floors.put(v, program, kit)
  local given, name = program.floors ~= nil, kit.ctx.name
  local moves = given and program.floors.groups ~= nil
  for _, k in ipairs(v.kinds) do
    local place = given and program.floors.places[program.states[math.tointeger(tonumber(k.first)) + 1].name]
    k.least = place and string.format("least[%d], ", place) or given and kit.base.zero .. ", " or ""
  end
  v.has_floors, v.least_first = given, given and "least" or kit.base.zero
  v.least_arg = given and name .. "_real least, " or ""
  v.floors_count, v.floors_pass = moves and "2" or "3", moves and "m, t, x, u, h" or "m, x, h"
  local of_motion = moves and string.format("%s_real t, const %s_real u[], ", name, name) or ""
  v.norm_args = given and string.format("const %s_model *m, %s%s_real h, ", name, of_motion, name) or ""
end

return floors
