-- json.lua -- values as JSON text: ordered objects, numbers that read back to the same double.
-- An object is a list of {key, value} pairs marked by json.object, so the order is the writer's, never a hash's.
-- SPDX-License-Identifier: GPL-3.0-or-later

local double = require "generator.algebra.double"

local json = { null = {} }

local objects = setmetatable({}, { __mode = "k" })

function json.object(pairs_list)
  objects[pairs_list] = true
  return pairs_list
end

-- The shortest digits that read back to x.
function json.number(x)
  if x ~= x or x == math.huge or x == -math.huge then return "null" end
  if math.type(x) == "integer" then return string.format("%d", x) end
  if x == math.floor(x) and math.abs(x) < 1e15 then return string.format("%d", x) .. ".0" end
  return double.shortest(x, 15)
end

local escapes = { ["\""] = "\\\"", ["\\"] = "\\\\", ["\n"] = "\\n", ["\r"] = "\\r", ["\t"] = "\\t" }

local function quoted(s)
  return "\"" .. string.gsub(s, "[%c\"\\]", function(c)
    return escapes[c] or string.format("\\u%04x", string.byte(c))
  end) .. "\""
end

local function write(v, indent)
  if v == json.null then return "null" end
  local kind = type(v)
  if kind == "number" then return json.number(v) end
  if kind == "string" then return quoted(v) end
  if kind == "boolean" then return v and "true" or "false" end
  local inner, lines, flat = indent .. "  ", {}, true
  if objects[v] then
    if #v == 0 then return "{}" end
    for i, p in ipairs(v) do lines[i] = inner .. quoted(p[1]) .. ": " .. write(p[2], inner) end
    return "{\n" .. table.concat(lines, ",\n") .. "\n" .. indent .. "}"
  end
  for i, x in ipairs(v) do
    lines[i] = write(x, inner)
    flat = flat and type(x) == "number"
  end
  if #lines == 0 then return "[]" end
  if flat then return "[" .. table.concat(lines, ", ") .. "]" end
  return "[\n" .. inner .. table.concat(lines, ",\n" .. inner) .. "\n" .. indent .. "]"
end

function json.text(v) return write(v, "") .. "\n" end

return json
