-- floors.lua -- the least sizes of methods/floors.lua as C, printed once before the steppers that call them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local number = require "generator.emit.number"
local template = require "generator.emit.template"

local FLOORS = template.group "steppers/floors.c"

local floors = {}

-- The function, for the constants `list` of one of the steppers' programs.
function floors.shared(kit, list)
  local ctx = kit.ctx
  local v = { uses_model = false, rates = {}, speeds = {} }
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

-- The values of v's templates: to each of v.kinds the argument `least`, empty texts where the scene has none.
function floors.put(v, program, kit)
  local given, name = program.floors ~= nil, kit.ctx.name
  for _, k in ipairs(v.kinds) do
    local place = given and program.floors.places[program.states[math.tointeger(tonumber(k.first)) + 1].name]
    k.least = place and string.format("least[%d], ", place) or given and kit.base.zero .. ", " or ""
  end
  v.has_floors, v.least_first = given, given and "least" or kit.base.zero
  v.least_arg, v.norm_pass = given and name .. "_real least, " or "", given and "m, h, " or ""
  v.norm_args = given and string.format("const %s_model *m, %s_real h, ", name, name) or ""
end

return floors
