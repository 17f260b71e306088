-- order.lua: pass that puts instructions where a reader, and a register, wants them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line; moves instructions, changes none.  The groups, and within a group the stores and
-- the named intermediates, keep their order.  Everything else is placed just before the first of
-- these that needs it, operands first, left before right: live ranges start late, a temporary
-- belongs to the first group that uses it, and the result depends on the program alone.

local instr = require "generator.ir.core.instr"

local order = {}

function order.run(ir)
  local define = instr.definitions(ir)
  local placed = {}
  for _, list in ipairs { ir.inputs, ir.consts } do
    for _, i in ipairs(list) do placed[i.dst] = true end
  end

  return instr.rebuilt(ir, function(root, emit)
    if not (root.name or not root.dst) then return end

    local function place(i)
      if i.dst then
        if placed[i.dst] then return end
        placed[i.dst] = true
      end
      for _, field in ipairs(instr.srcs(i)) do
        place(define[i[field]] or error("order: value " .. i[field] .. " is never defined"))
      end
      emit(i)
    end

    place(root)
  end)
end

return order
