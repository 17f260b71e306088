-- scene_page.lua -- polhode-scene(5): the scene language, from the tables of fields, shapes, effects and units.
-- SPDX-License-Identifier: GPL-3.0-or-later

local fields = require "generator.language.fields"
local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.effects"
local conserved = require "generator.dynamics.conserved"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local reference = require "generator.commands.reference"
local roff = require "docs.tools.roff"

local example = [[
local a, b = param("a", 0.2, "m"), param("b", 0.1, "m")
return scene {
  name    = "box",
  body    = solid.box { x = a, y = b, z = 0.05, mass = 2.4 },
  effects = { effect.damping { rate = quantity(0.1, "1/s") } },
  initial = { omega = {0.1, 6, 0.2} },
}]]

local function sentence(text)
  return string.gsub(text, "^%l", string.upper) .. (string.find(text, "%.$") and "" or ".")
end

local function field(page, f)
  local unit, default = f[3] ~= "" and " Unit: " .. f[3] .. "." or "", f[4] and " Default: " .. f[4] .. "." or ""
  page:entry(f[1], nil, sentence(f[5]) .. unit .. default .. (f.needed and " Required." or ""))
end

local function called(page, name, takes, about)
  local names = {}
  for i, a in ipairs(takes) do names[i] = a[1] end
  page:entry(name .. "(" .. table.concat(names, ", ") .. ")", nil, sentence(about))
  page:inner(function()
    for _, a in ipairs(takes) do page:entry(a[1], nil, sentence(a[3])) end
  end)
end

local function shape(page, s)
  local names = {}
  for i, a in ipairs(s.args or {}) do names[i] = a.name end
  local takes = s.takes or "{" .. table.concat(names, ", ") .. "}"
  page:entry(s.name, takes, sentence(s.about) .. " Frame: " .. s.frame .. "." ..
    (s.measure and " Mass, or density per " .. s.measure .. "." or ""))
end

local function effect(page, e)
  local rows = {}
  for _, t in ipairs(e.takes or {}) do
    rows[#rows + 1] = t[1] .. " [" .. t[2] .. "]: " .. t[4] .. (t[3] and " (default " .. t[3] .. ")" or "")
  end
  for _, a in ipairs(not e.takes and e.args or {}) do
    rows[#rows + 1] = a.name .. " [" .. (a.flag and "true or false" or units.si(units.of(a.dim or "none"))) .. "]"
  end
  page:entry(e.name, nil, sentence(e.about) .. " Formula: " .. e.formula .. ". Signs: " .. e.signs .. ". Conserves: " ..
    conserved.words(e) .. ".")
  if #rows > 0 then
    page:inner(function()
      for _, r in ipairs(rows) do page:entry(string.match(r, "^(.-) %["), nil, string.match(r, " (%[.*)$")) end
    end)
  end
end

return function(version, date)
  local page = roff.page("polhode-scene", 5, version, date, "the language that describes a rigid body and its motion")
  page:section "DESCRIPTION"
  page:text("A scene is a Lua script that returns scene{...}. It runs in a sandbox: it cannot read or write files, " ..
    "and its memory and steps are limited. Numbers are exact: 0.1 is one tenth. A number without a unit is in SI " ..
    "units, an angle in rad. polhode reports every error with its line, and an unknown name is an error.")
  page:text "polhode list shapes, list effects and list constants print the names. polhode(1) explains the commands."
  page:section "EXAMPLE"
  page:literal(example)
  page:section "FUNCTIONS"
  for _, f in ipairs(fields.functions) do called(page, f[1], f[2], f[4]) end
  for _, g in ipairs(fields.groups) do
    page:section("TABLE " .. string.upper(g.name))
    page:text(g.about)
    for _, f in ipairs(g.fields) do field(page, f) end
  end
  page:section "PLACING SHAPES"
  page:text "a + b puts two shapes together. a - b cuts b out of a, and b must lie inside a."
  for _, p in ipairs(fields.placing) do called(page, "shape:" .. p[1], p[2], p[3]) end
  page:section "SHAPES"
  for _, s in ipairs(catalogue.list) do shape(page, s) end
  page:section "EFFECTS"
  for _, e in ipairs(effects) do effect(page, e) end
  page:section "EXPRESSIONS OF THE MOTION"
  page:text("Events, outputs to measure and many arguments of effects are expressions of time, states and inputs. " ..
    "The dimension of every expression is checked.")
  for _, w in ipairs(fields.words) do
    page:entry(w[1], nil, sentence(w[3]) .. (w[2] ~= "" and " Unit: " .. w[2] .. "." or ""))
  end
  local names, words = {}, {}
  for _, f in ipairs(value.functions) do names[#names + 1] = f[1] end
  page:text("Functions: " .. table.concat(names, ", ") .. ".")
  for i, w in ipairs(reference.watched()) do words[i] = w[1] end
  page:text("Events also know, where the scene has it: " .. table.concat(words, ", ") .. ".")
  page:text "A function of effect.custom receives a table with these:"
  for _, m in ipairs(fields.motion) do page:entry("s." .. m[1], nil, sentence(m[3])) end
  page:section "UNITS"
  local list = {}
  for i, u in ipairs(units.list) do list[i] = u[1] end
  page:text("A unit is a product of these with powers, such as kg m^2/s^2: " .. table.concat(list, ", ") .. ".")
  page:see { { "polhode", 1 }, { "polhode-gen", 1 }, { "polhode", 3 } }
  return page:done()
end
