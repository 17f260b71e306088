-- dce.lua: pass that drops what no result needs.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line.  A store is needed; a value is needed if a needed instruction reads it.  Every
-- other opcode is without effect, so dropping it preserves all values: unused inputs are not loaded,
-- unused named intermediates vanish.  Order is kept.

local instr = require "generator.ir.core.instr"

local dce = {}

function dce.run(ir)
  local needed = {}

  local function live(i)
    if i.dst and not needed[i.dst] then return false end
    for _, field in ipairs(instr.srcs(i)) do needed[i[field]] = true end
    return true
  end

  -- Backwards: definitions stand before uses, so one sweep sees every use first.
  local keep = {}
  for g = #ir.groups, 1, -1 do
    local code = ir.groups[g].code
    for k = #code, 1, -1 do keep[code[k]] = live(code[k]) end
  end

  local function only_needed(list)
    local kept = {}
    for _, i in ipairs(list) do
      if needed[i.dst] then kept[#kept + 1] = i end
    end
    return kept
  end

  local new = instr.rebuilt(ir, function(i, emit) if keep[i] then emit(i) end end)
  new.inputs, new.consts = only_needed(ir.inputs), only_needed(ir.consts)
  return new
end

return dce
