-- list.lua -- polhode list: shapes, effects, methods, bodies, constants, commands; one line each, the name first.
-- Pages with formulas and pictures are made of the same tables by docs/tools/pages.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.effects"
local methods = require "generator.methods.methods"
local conserved = require "generator.dynamics.conserved"
local units = require "generator.dsl.units"
local help = require "generator.commands.help"
local options = require "generator.commands.options"
local scenes = require "generator.commands.scenes"

local list = {}

local subjects = { "shapes", "effects", "methods", "bodies", "constants", "commands" }

list.forms = { { "WHAT", "shapes, effects, methods, scenes, commands",
  "WHAT is " .. options.either(subjects) .. "." } }
list.operands = { 1, 1, "WHAT" }
list.subjects = subjects
list.options = {}
list.examples = {
  { "polhode list bodies", "the installed scenes: polhode explain NAME reads one" },
  { "polhode list constants", "the names of units and constants that a scene may use" },
}

local function aligned(rows)
  local width = 0
  for _, r in ipairs(rows) do width = math.max(width, #r[1]) end
  local out = {}
  for i, r in ipairs(rows) do out[i] = r[1] .. string.rep(" ", width - #r[1] + 2) .. r[2] .. "\n" end
  return table.concat(out)
end

local what = {}

function what.shapes()
  local rows = {}
  for i, s in ipairs(catalogue.list) do
    local names = {}
    for k, a in ipairs(s.args or {}) do names[k] = a.name end
    local takes = s.takes or "{" .. table.concat(names, ", ") .. "}"
    rows[i] = { s.name, takes .. ": " .. s.about .. "; " .. s.frame }
  end
  return rows
end

function what.effects()
  local rows = {}
  for i, e in ipairs(effects) do rows[i] = { e.name, e.about .. "; conserves " .. conserved.words(e) } end
  return rows
end

function what.methods()
  local rows = { { "exact", "closed form at any time, where the scene has one (explain says which, or why not)" } }
  for _, m in ipairs(methods) do rows[#rows + 1] = { m.name, m.about } end
  for _, row in ipairs {
    { "linearised", "small oscillations of the free top about a principal axis; run: general library" },
  } do
    rows[#rows + 1] = row
  end
  return rows
end

function what.constants()
  local rows = {}
  for i, u in ipairs(units.list) do rows[i] = { u[1], u[2] } end
  return rows
end

function what.bodies(host)
  local names, folder = scenes.names(host)
  if not names then return nil, folder end
  local rows = {}
  for i, n in ipairs(names) do
    rows[i] = { n, string.match(host.read(folder .. "/" .. n .. ".lua") or "", "^%-%-%s*([^\n]*)") or "" }
  end
  return rows
end

function what.commands()
  local rows = {}
  for i, name in ipairs(help.names) do rows[i] = { name, help.of(name).forms[1][2] } end
  return rows
end

function list.run(host, given)
  local f = what[given[1]]
  if not f then
    return options.wrong(host, "list", "must be " .. options.either(subjects) .. ", got " .. given[1] ..
      options.meant(given[1], subjects))
  end
  local rows, why = f(host)
  if not rows then return options.failed(host, "list", why) end
  host.out(aligned(rows))
  return 0
end

return list
