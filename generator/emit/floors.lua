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

-- To each of v.kinds the argument `least`; always: zero where the scene has none.
function floors.put(v, program, kit, always)
  for _, k in ipairs(v.kinds) do
    local place = program.floors and program.floors.places[program.states[math.tointeger(tonumber(k.first)) + 1].name]
    k.least = place and string.format("least[%d], ", place) or
      (program.floors or always) and kit.base.zero .. ", " or ""
  end
end

return floors
