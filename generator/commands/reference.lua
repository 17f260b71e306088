-- reference.lua -- polhode help NAME for a name of the scene language: scene.initial, effect.wheel, solid.cone, s.q.
-- SPDX-License-Identifier: GPL-3.0-or-later

local conserved = require "generator.dynamics.conserved"
local effects = require "generator.effects.effects"
local language = require "generator.language.reference"
local catalogue = require "generator.mass.catalogue"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"

local reference = {}

function reference.entries()
  return language.entries { shapes = catalogue.list, effects = effects, units = units, functions = value.functions,
    conserved = conserved.words }
end

-- The text of an entry, or nil and all names.
function reference.help(name)
  local names = {}
  for i, e in ipairs(reference.entries()) do
    if e.name == name then return language.text(e) end
    names[i] = e.name
  end
  return nil, names
end

return reference
