-- cse.lua: pass that computes equal values once (value numbering).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line.  Two instructions are equal if opcode, operands and immediates are; no law of
-- algebra is used but one that IEEE arithmetic keeps:
--     a + b  =  b + a,   a * b  =  b * a          (not associativity)
-- The first of two equal instructions stays where it is.  A name survives: if the first has none it
-- takes the other's, if both have one the other becomes a second name for the same number and goes.

local instr = require "generator.ir.core.instr"

local cse = {}

-- Text that is equal for two instructions iff they compute the same value.
local function signature(i, leader)
  local entry = instr.of(i.op)
  local parts = { i.op }
  for _, field in ipairs(entry.srcs) do parts[#parts + 1] = leader[i[field]] or i[field] end
  if entry.commutes and parts[2] > parts[3] then parts[2], parts[3] = parts[3], parts[2] end
  for _, field in ipairs(entry.immediates) do parts[#parts + 1] = tostring(i[field]) end
  return table.concat(parts, " ")
end

-- Values first, then names: an instruction may get its name from one that comes after it.
function cse.run(ir)
  local leader = {} -- value number -> value number of the first equal instruction
  local seen = {}   -- signature -> that instruction
  local names = {}  -- value number -> the name it takes over

  local function merged(list)
    local kept = {}
    for _, i in ipairs(list) do
      local key = signature(i, leader)
      if seen[key] then
        leader[i.dst] = seen[key].dst
      else
        seen[key] = i
        kept[#kept + 1] = i
      end
    end
    return kept
  end

  local inputs, consts = merged(ir.inputs), merged(ir.consts)
  local new = instr.rebuilt(ir, function(i, emit)
    local new_i = instr.renamed(i, leader)
    local key = i.dst and signature(new_i, leader)
    local first = key and seen[key]
    if not first then
      if key then seen[key] = new_i end
      return emit(new_i)
    end
    leader[i.dst] = first.dst
    if i.name and not first.name and instr.of(first.op).srcs[1] then -- inputs, constants: their own
      names[first.dst] = names[first.dst] or i.name
    end
  end)
  new.inputs, new.consts = inputs, consts
  return instr.rebuilt(new, function(i, emit)
    emit(names[i.dst] and instr.named(i, names[i.dst]) or i)
  end)
end

return cse
