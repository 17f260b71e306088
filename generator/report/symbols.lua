-- symbols.lua -- the table of symbols of a document about a scene: formula/symbols.lua with the scene's names.
-- SPDX-License-Identifier: GPL-3.0-or-later

local symbols = require "generator.formula.symbols"

local scene = {}

function scene.of(f)
  local names = {}
  for i, q in ipairs(f.params) do names[i] = q.name end
  for _, input in ipairs(f.job.model.inputs or {}) do names[#names + 1] = input.name end
  return symbols.new(names, { mass = f.mass.kind == "sym" and f.mass.name or nil })
end

return scene
