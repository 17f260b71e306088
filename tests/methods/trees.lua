-- trees.lua - rooted trees, by which the order of one-step methods is counted: {forest, size, text}, and their
-- densities.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local trees = {}

-- All rooted trees with n vertices, each a list of subtrees in a canonical order; `text` tells them apart.
local forests = {}

local function of(n)
  local list = {}
  for _, forest in ipairs(forests[n - 1]) do
    local texts = {}
    for i, s in ipairs(forest) do texts[i] = s.text end
    table.sort(texts)
    list[#list + 1] = { forest = forest, size = n, text = "(" .. table.concat(texts) .. ")" }
  end
  return list
end

-- Of up to `most` vertices.  Multisets of trees with n vertices in all: those whose largest tree is no larger than what
-- came before.
function trees.build(most)
  forests[0] = { {} }
  local all = {}
  for n = 1, most do
    for _, t in ipairs(of(n)) do all[#all + 1] = t end
    local seen, list = {}, {}
    local function extend(forest, left, from)
      if left == 0 then
        local texts = {}
        for i, s in ipairs(forest) do texts[i] = s.text end
        table.sort(texts)
        local key = table.concat(texts)
        if not seen[key] then list[#list + 1] = { table.unpack(forest) } end
        seen[key] = true
        return
      end
      for i = from, #all do
        if all[i].size <= left then
          forest[#forest + 1] = all[i]
          extend(forest, left - all[i].size, i)
          forest[#forest] = nil
        end
      end
    end
    extend({}, n, 1)
    forests[n] = list
  end
  return all
end

function trees.density(t)
  local g = R.new(t.size)
  for _, s in ipairs(t.forest) do g = g * trees.density(s) end
  return g
end

return trees
