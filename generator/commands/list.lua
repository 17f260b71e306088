-- list.lua -- polhode list: shapes, effects, methods, bodies, constants; one line each, the name first.
-- list shapes --format markdown -o DIR writes the page of all shapes with pictures instead, list effects that of all
-- effects (run where bodies/ is).
-- SPDX-License-Identifier: GPL-3.0-or-later

local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.list"
local methods = require "generator.methods.list"
local conserved = require "generator.dynamics.conserved"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"

local list = {}

list.options = { ["--format"] = { "text", "markdown" }, ["-o"] = "text" }
list.operands = { 1, 1 }

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
  local names, why = host.list_dir("bodies", ".lua")
  if not names then return nil, why end
  local rows = {}
  for i, n in ipairs(names) do
    local text = host.read("bodies/" .. n) or ""
    rows[i] = { (string.gsub(n, "%.lua$", "")), string.match(text, "^%-%-%s*([^\n]*)") or "" }
  end
  return rows
end

-- What a scene of bodies/ says of itself: the comment that it begins with, without its name.
local function titles(host)
  local map = {}
  for _, e in ipairs(effects) do
    local words = {}
    for line in string.gmatch(host.read("bodies/" .. e.example .. ".lua") or "", "([^\n]*)\n") do
      local comment = string.match(line, "^%-%- (.*)$")
      if not comment or string.find(comment, "^SPDX") then break end
      words[#words + 1] = comment
    end
    map[e.example] = #words > 0 and (string.gsub(table.concat(words, " "), "^%S+%.lua %-+ ", "")) or nil
  end
  return map
end

-- DIR/shapes.md and DIR/shapes/NAME.svg, or DIR/effects.md
local function page(host, given)
  if given[1] ~= "shapes" and given[1] ~= "effects" or not given.o then
    host.err("polhode list: --format markdown is for shapes and effects and needs -o DIR\n")
    return 2
  end
  local files
  if given[1] == "shapes" then
    files = require("generator.report.shapes").files(catalogue.list)
  else
    local scenes = titles(host)
    if not next(scenes) then
      host.err("polhode list: --format markdown of effects needs the scenes of the sources, the folder bodies here\n")
      return 2
    end
    files = require("generator.report.effects").files(effects, scenes, { keeps = conserved.words,
      unit = function(dim) return units.si(units[dim or "none"]) end, show = value.show })
  end
  local ok, why = host.write_files(given.o, files)
  if not ok then
    host.err("polhode list: " .. why .. "\n")
    return 2
  end
  return 0
end

function list.run(host, given)
  if given.format == "markdown" then return page(host, given) end
  if given.o then
    host.err("polhode list: -o goes with --format markdown\n")
    return 2
  end
  local f = what[given[1]]
  if not f then
    host.err("polhode list: must be shapes, effects, methods, bodies or constants, got " .. given[1] .. "\n")
    return 2
  end
  local rows, why = f(host)
  if not rows then
    host.err("polhode list: " .. why .. "\n")
    return 2
  end
  host.out(aligned(rows))
  return 0
end

return list
