-- bytes.lua -- bytes as base64, and numbers as JSON and as little-endian words: what a page carries.
-- SPDX-License-Identifier: GPL-3.0-or-later

local bytes = {}

local letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"

function bytes.base64(s)
  local out = {}
  for i = 1, #s, 3 do
    local a, b, c = string.byte(s, i, i + 2)
    local n = a << 16 | (b or 0) << 8 | (c or 0)
    local four = ""
    for k = 18, 0, -6 do
      local at = (n >> k & 63) + 1
      four = four .. string.sub(letters, at, at)
    end
    out[#out + 1] = string.sub(four, 1, c and 4 or b and 3 or 2) .. (c and "" or b and "=" or "==")
  end
  return table.concat(out)
end

-- The bytes that hexadecimal digits name.
function bytes.of_hex(s)
  return (string.gsub(s, "..", function(two) return string.char(tonumber(two, 16)) end))
end

-- Numbers as IEEE binary32, little-endian, in base64.
function bytes.floats(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = string.pack("<f", x) end
  return bytes.base64(table.concat(out))
end

-- The same as IEEE binary64.
function bytes.doubles(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = string.pack("<d", x) end
  return bytes.base64(table.concat(out))
end

local escapes = { ['"'] = '\\"', ["\\"] = "\\\\", ["\n"] = "\\n", ["<"] = "\\u003c" } -- no end of a script element

-- JSON of strings, numbers, booleans, lists and tables with names, which are sorted.  {} is a list.
function bytes.json(v)
  local kind = type(v)
  if kind == "string" then return '"' .. string.gsub(v, '["\\\n<]', escapes) .. '"' end
  if kind == "number" then return math.type(v) == "integer" and string.format("%d", v) or string.format("%.17g", v) end
  if kind ~= "table" then return tostring(v) end
  local out, names = {}, {}
  if next(v) == nil or #v > 0 then
    for i, x in ipairs(v) do out[i] = bytes.json(x) end
    return "[" .. table.concat(out, ",") .. "]"
  end
  for name in pairs(v) do names[#names + 1] = name end
  table.sort(names)
  for i, name in ipairs(names) do out[i] = bytes.json(name) .. ":" .. bytes.json(v[name]) end
  return "{" .. table.concat(out, ",\n") .. "}"
end

return bytes
