-- definitions.lua -- the scene language as definitions for the Lua language server (LuaCATS), from our own tables.
--
--     definitions.text(tables) -> text of polhode.d.lua
-- tables: {shapes = catalogue's list, effects = list, units = dsl/units, functions = of values, watched = words of
-- events}.
-- Completion, hover and the check of arguments in an editor come from this file: polhode init writes it into a project.
-- SPDX-License-Identifier: GPL-3.0-or-later

local fields = require "generator.language.fields"

local definitions = {}

local head = [[
---@meta polhode
-- The scene language of polhode.  Made by `polhode init` from the program's own tables; do not edit.

---A number of a scene: it may have a unit, contain parameters, and depend on time and states where that is allowed.
---@class Quantity
---@operator add(Quantity|number): Quantity
---@operator sub(Quantity|number): Quantity
---@operator mul(Quantity|number): Quantity
---@operator div(Quantity|number): Quantity
---@operator pow(Quantity|number): Quantity
---@operator unm: Quantity

---@alias Value number|Quantity
---@alias Vector Value[]

---What acts on a body.
---@class Effect
]]

local function words(text) return (string.gsub(text, "%s+", " ")) end

local function with_unit(about, unit) return (unit and unit ~= "" and "[" .. unit .. "] " or "") .. about end

local function group(out, g)
  out[#out + 1] = "---" .. words(g.about)
  out[#out + 1] = "---@class " .. g.name .. (g.array and ": { [integer]: Value }" or "")
  for _, f in ipairs(g.fields) do
    local name, kind, unit, default, about = f[1], f[2], f[3], f[4], f[5]
    out[#out + 1] = string.format("---@field %s %s %s%s", name .. (f.needed and "" or "?"), kind,
      with_unit(words(about), unit), default and "; default " .. default or "")
  end
  if g.also then out[#out + 1] = "---@field [string] " .. g.also end
  out[#out + 1] = ""
end

local function call(out, path, takes, result, about)
  out[#out + 1] = "---" .. words(about)
  local names = {}
  for i, a in ipairs(takes) do
    local kind, optional = string.match(a[2], "^(.-)(%??)$")
    names[i] = a[1]
    out[#out + 1] = string.format("---@param %s%s %s %s", a[1], optional, kind, words(a[3]))
  end
  if result then out[#out + 1] = "---@return " .. result end
  out[#out + 1] = string.format("function %s(%s) end\n", path, table.concat(names, ", "))
end

-- "solid.box" -> "SolidBox"
local function class_of(name)
  return (string.gsub(string.gsub(name, "%.", "_"), "_?(%a)([^_]*)", function(a, b) return string.upper(a) .. b end))
end

local function type_of(a)
  if a.choice then
    local list = {}
    for i, c in ipairs(a.choice) do list[i] = type(c) == "string" and '"' .. c .. '"' or tostring(c) end
    return table.concat(list, "|")
  end
  if a.flag then return "boolean" end
  if a.lists then return "Vector[][]" end
  if a.rows then return "Vector[]" end
  return a.size and "Vector" or "Value"
end

local signs = { positive = "positive", nonnegative = "not negative" }

-- The default as a scene would write it.
local function shown(x)
  if type(x) ~= "table" then return tostring(x) end
  local list = {}
  for i, v in ipairs(x) do list[i] = tostring(v) end
  return "{" .. table.concat(list, ", ") .. "}"
end

-- Rows of a declared argument list as lines of a class.
local function arguments(out, units, args)
  for _, a in ipairs(args) do
    local unit = not a.flag and not a.choice and units.si(units.of(a.dim or "none"))
    local about = { a.about, a.size and a.size .. " components", signs[a.sign],
      a.motion and "may depend on the motion" }
    local list = {}
    for k = 1, 4 do list[#list + 1] = about[k] or nil end
    if a.default ~= nil then list[#list + 1] = "default " .. shown(a.default) end
    local optional = a.default ~= nil or a.optional
    out[#out + 1] = string.format("---@field %s %s %s", a.name .. (optional and "?" or ""), type_of(a),
      with_unit(table.concat(list, "; "), unit ~= "1" and unit or nil))
  end
end

-- Rows {argument, unit, default, about} of an effect that reads its own; names with a dot or an index are inside
-- others.
local function taken(out, takes)
  local seen = {}
  for _, t in ipairs(takes) do
    for name in string.gmatch(t[1], "[^,%s]+") do
      local outer = string.match(name, "^(%w+)[%.%[]")
      local of = outer or name
      if not seen[of] then
        seen[of] = true
        local kind = outer and "table" or t[2] == "true or false" and "boolean" or "any"
        out[#out + 1] = string.format("---@field %s? %s %s%s", of, kind,
          outer and "" or with_unit(t[4], t[2] ~= "1" and t[2] ~= "any" and t[2] or nil),
          not outer and t[3] and "; default " .. t[3] or "")
      end
    end
  end
end

-- The table of arguments as a class, and the function that takes it.
local function constructor(out, path, result, about, body)
  local class = class_of(path) .. "Arguments"
  out[#out + 1] = "---@class " .. class
  body()
  out[#out + 1] = ""
  out[#out + 1] = "---" .. words(about)
  out[#out + 1] = "---@param arguments " .. class
  out[#out + 1] = "---@return " .. result
  out[#out + 1] = "function " .. path .. "(arguments) end\n"
end

local function shape(out, tables, s)
  local about = s.about .. ". Frame: " .. s.frame .. "."
  local read = s.reader and fields.read_shapes[s.name]
  if read and not string.find(s.takes, "^{%l") then return call(out, s.name, read, "Shape", about) end
  constructor(out, s.name, "Shape", about, function()
    for _, a in ipairs(read or {}) do
      out[#out + 1] = string.format("---@field %s %s %s", a[1] .. (a.needed and "" or "?"), a[2], a[3])
    end
    if not read then arguments(out, tables.units, s.args) end
    if s.measure then
      out[#out + 1] = "---@field mass? Value [kg] mass, or give a density"
      out[#out + 1] = "---@field density? Value per " .. s.measure .. ", or give a mass"
    end
  end)
end

local function effect(out, tables, e)
  local about = e.about .. ". `" .. e.formula .. "`. Signs: " .. e.signs .. "."
  constructor(out, e.name, "Effect", about, function()
    if e.takes then taken(out, e.takes) else arguments(out, tables.units, e.args) end
  end)
end

-- Families with a dot are tables of their own class, so that an unknown member is reported.
local function families(out, list)
  local seen = {}
  for _, entry in ipairs(list) do
    local family = string.match(entry.name, "^(%w+)%.")
    if family and not seen[family] then
      seen[family] = true
      out[#out + 1] = string.format("---@class %sFamily\n%s = {}\n", class_of(family), family)
    end
  end
end

function definitions.text(tables)
  local out = { head }
  for _, g in ipairs(fields.groups) do group(out, g) end
  out[#out + 1] = "---A body or a part of one; a + b puts two together, a - b cuts b out of a.\n---@class Shape"
  out[#out + 1] = "---@operator add(Shape): Shape\n---@operator sub(Shape): Shape\nlocal shape = {}\n"
  for _, p in ipairs(fields.placing) do call(out, "shape:" .. p[1], p[2], "Shape", p[3]) end
  for _, f in ipairs(fields.functions) do call(out, f[1], f[2], f[3], f[4]) end
  for _, f in ipairs(tables.functions) do
    local takes = { { "x", "Value", "a number or an expression" } }
    if f[2] ~= 1 then takes[2] = { "y", "Value", "the second one" } end
    if not f[2] then takes[3] = { "...", "Value", "more" } end
    call(out, f[1], takes, "Quantity", f[1] .. " of a number or an expression")
  end
  for _, w in ipairs(fields.words) do
    out[#out + 1] = "---" .. with_unit(w[3], w[2]) .. "\n---@type Quantity\n" .. w[1] .. " = nil\n"
  end
  for _, w in ipairs(tables.watched) do
    for name in string.gmatch(w[1], "[^, ]+") do
      out[#out + 1] = "---" .. with_unit(w[3], w[2]) .. "; in events\n---@type Quantity\n" .. name .. " = nil\n"
    end
  end
  families(out, tables.shapes)
  families(out, tables.effects)
  for _, s in ipairs(tables.shapes) do shape(out, tables, s) end
  for _, e in ipairs(tables.effects) do effect(out, tables, e) end
  return table.concat(out, "\n") .. "\n"
end

return definitions
