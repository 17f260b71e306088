-- snippets.lua -- a snippet for each shape and effect, and for a scene, as editors of the VS Code family read them.
--
--     snippets.text(tables) -> JSON; tables: as for language/definitions.lua
-- Each argument is a place to fill in, with its default or a plausible value.
-- SPDX-License-Identifier: GPL-3.0-or-later

local fields = require "generator.language.fields"

local snippets = {}

local function quoted(text)
  return '"' .. string.gsub(text, '[%c"\\]', { ['"'] = '\\"', ["\\"] = "\\\\", ["\n"] = "\\n", ["\t"] = "\\t" }) .. '"'
end

local function entry(prefix, about, body)
  return string.format("  %s: {\n    \"scope\": \"lua\",\n    \"prefix\": %s,\n    \"description\": %s,\n    " ..
    "\"body\": %s\n  }", quoted(prefix), quoted(prefix), quoted(about), quoted(body))
end

-- What stands in a place: braces and dollars mean something there.
local function place(n, text) return "${" .. n .. ":" .. string.gsub(text, "[\\$}]", "\\%0") .. "}" end

local guesses = { length = "0.1", mass = "1", none = "1", inertia = "0.01", rate = "1", torque = "0.1",
  angular_momentum = "0.1", acceleration = "9.81" }

local function guess(a)
  if a.choice then return type(a.choice[1]) == "string" and '"' .. a.choice[1] .. '"' or tostring(a.choice[1]) end
  if a.flag then return tostring(a.default or false) end
  if a.size then return a.size == 3 and "{0, 0, 1}" or "{1, 0, 0, 0}" end
  if a.rows then return a.rows == 2 and "{{0, 0}, {0.1, 0}, {0, 0.1}}" or "{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}" end
  return a.default ~= nil and tostring(a.default) or guesses[a.dim or "none"] or "1"
end

local function body(name, parts)
  for i, p in ipairs(parts) do parts[i] = p[1] .. " = " .. place(string.format("%d", i), p[2]) end
  return name .. " { " .. table.concat(parts, ", ") .. " }"
end

local function required(args)
  local parts = {}
  for _, a in ipairs(args) do
    if a.default == nil and not a.optional then parts[#parts + 1] = { a.name, guess(a) } end
  end
  return parts
end

local function shape(s)
  local read = s.reader and fields.read_shapes[s.name]
  if s.name == "points" then return "points { " .. place("1", "{1, 0, 0, 0}, {1, 0.1, 0, 0}") .. " }" end
  if s.name == "region" then
    return "region { " .. place("1", "{x, 0, 0.1}, {y, 0, 0.1}, {z, 0, 0.1}, density = 1000") .. " }"
  end
  local parts = read and {} or required(s.args)
  for _, a in ipairs(read or {}) do parts[#parts + 1] = a.needed and { a[1], '"' .. a[1] .. '"' } or nil end
  if s.measure then parts[#parts + 1] = { "mass", "1" } end
  return body(s.name, parts)
end

local function effect(e)
  local parts, seen = {}, {}
  for _, t in ipairs(e.takes or {}) do
    local name = string.match(t[1], "^%w+")
    if not seen[name] and not (t[3] and #parts > 0) and not string.find(t[4], "^or: ") then
      parts[#parts + 1] = { name, t[3] or name }
    end
    seen[name] = true
  end
  return body(e.name, e.takes and parts or required(e.args))
end

local scene = [[
return scene {
  name    = "${1:body}",
  body    = solid.box { x = ${2:0.2}, y = ${3:0.1}, z = ${4:0.05}, mass = ${5:1} },
  effects = { $0 },
  initial = { omega = {${6:0.1}, ${7:6}, ${8:0.2}} },
  time    = { horizon = ${9:10} },
}]]

function snippets.text(tables)
  local out = { entry("scene", "a scene: body, effects, initial state", scene),
    entry("param", "a parameter with its unit", 'local ${1:a} = param("${1:a}", ${2:0.1}, "${3:m}")'),
    entry("input", "what a controller decides",
      'local ${1:u} = input("${1:u}", "${2:N m}", { min = -${3:1}, max = ${3:1} })'),
    entry("event", "a zero crossing that run looks for", '{ name = "${1:up}", when = ${2:wz}, direction = ${3:1} }') }
  for _, s in ipairs(tables.shapes) do out[#out + 1] = entry(s.name, s.about, shape(s)) end
  for _, e in ipairs(tables.effects) do out[#out + 1] = entry(e.name, e.about, effect(e)) end
  return "{\n" .. table.concat(out, ",\n") .. "\n}\n"
end

return snippets
