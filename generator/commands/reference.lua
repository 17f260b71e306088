-- reference.lua -- polhode help NAME for a name of the scene language: scene.initial, effect.wheel, solid.cone, s.q.
-- SPDX-License-Identifier: GPL-3.0-or-later

local conserved = require "generator.dynamics.conserved"
local effects = require "generator.effects.effects"
local quantities = require "generator.attitude.quantities"
local language = require "generator.language.reference"
local catalogue = require "generator.mass.catalogue"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local watched = require "generator.dsl.watched"

local reference = {}

-- Words of events, {name or names with commas between, unit, what it is}: states of effects, and quantities.
function reference.watched()
  local list = {}
  for i, w in ipairs(watched.states) do list[i] = w end
  for _, q in ipairs(quantities.list) do
    local names = {}
    for k, ending in ipairs(q[5] or {}) do names[k] = q[1] .. (q.plain and "" or "_") .. ending end
    list[#list + 1] = { #names > 0 and table.concat(names, ", ") or q[1], q[3], q.about }
    if q.length then list[#list + 1] = { q[1], q[3], q.length } end
  end
  return list
end

function reference.entries()
  return language.entries { shapes = catalogue.list, effects = effects, units = units, functions = value.functions,
    watched = reference.watched(), conserved = conserved.words }
end

-- The text of an entry, or of a row of one whose rows are entries themselves (a function); or nil and all names.
function reference.help(name)
  local names = {}
  for _, e in ipairs(reference.entries()) do
    if e.name == name then return language.text(e) end
    names[#names + 1] = e.name
    for _, r in ipairs(e.each and e.rows or {}) do
      if string.find(", " .. r[1] .. ",", ", " .. name .. ",", 1, true) then
        return language.row(e, r, name)
      end
      names[#names + 1] = r[1]
    end
  end
  return nil, names
end

return reference
