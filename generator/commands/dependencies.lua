-- dependencies.lua -- gen --deps: a rule for make, as a compiler's -MMD -MP writes it.
--
--     dependencies.rule(folder, files, scene, read) -> text
-- files: those that were made, {name =}; scene: the file as it was named; read: what it read, {path =}.  Each file
-- that was read has an empty rule of its own, so that make goes on when it was renamed.
-- SPDX-License-Identifier: GPL-3.0-or-later

local dependencies = {}

-- A name as make reads it.  A blank, # and $ can be written; what else make takes for its own cannot, and is rare.
local function escaped(name)
  return (string.gsub(string.gsub(name, "[ #\\]", "\\%0"), "%$", "$$$$"))
end

function dependencies.rule(folder, files, scene, read)
  local made, needs = {}, { escaped(scene) }
  for _, f in ipairs(files) do
    if string.find(f.name, "%.[ch]$") then made[#made + 1] = escaped(folder .. "/" .. f.name) end
  end
  for _, f in ipairs(read) do needs[#needs + 1] = escaped(f.path) end
  local out = { table.concat(made, " \\\n  ") .. ": \\\n  " .. table.concat(needs, " \\\n  ") .. "\n" }
  for i = 2, #needs do out[#out + 1] = needs[i] .. ":\n" end
  return table.concat(out, "\n")
end

return dependencies
