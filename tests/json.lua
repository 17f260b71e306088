-- json.lua - reads JSON in a test: objects and arrays as tables, null as json.null.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- RFC 8259 and nothing beside it: trailing commas, bare words, comments, NaN and text after the value are errors, so
-- that reading is a test of the writer.  An object keeps the order of its keys in `keys[object]`.

local json = { null = {}, keys = setmetatable({}, { __mode = "k" }) }

local value

local function fail(at, what) error("json: byte " .. at .. ": " .. what, 0) end

local function blank(text, i) return text:match("^[ \t\r\n]*()", i) end

local escapes = { ['"'] = '"', ["\\"] = "\\", ["/"] = "/", b = "\b", f = "\f", n = "\n", r = "\r", t = "\t" }

local function string_at(text, i)
  local out, at = {}, i + 1
  while true do
    local plain, stop = text:match('^([^"\\%c]*)()', at)
    out[#out + 1] = plain
    local c = text:sub(stop, stop)
    if c == '"' then return table.concat(out), stop + 1 end
    if c ~= "\\" then fail(stop, "a string does not end, or holds a control character") end
    local hex = text:match("^u(%x%x%x%x)", stop + 1)
    if hex then
      out[#out + 1], at = utf8.char(tonumber(hex, 16)), stop + 6
    else
      out[#out + 1] = escapes[text:sub(stop + 1, stop + 1)] or fail(stop, "unknown escape")
      at = stop + 2
    end
  end
end

-- Items from i (behind the opening bracket) to `close`, separated by commas.
local function sequence(text, i, close, item)
  i = blank(text, i)
  if text:sub(i, i) == close then return i + 1 end
  while true do
    i = blank(text, item(blank(text, i)))
    local c = text:sub(i, i)
    if c == close then return i + 1 end
    if c ~= "," then fail(i, "a comma or " .. close .. " must follow") end
    i = i + 1
  end
end

function value(text, i)
  local c = text:sub(i, i)
  if c == "{" then
    local object, keys = {}, {}
    local after = sequence(text, i + 1, "}", function(at)
      if text:sub(at, at) ~= '"' then fail(at, "a key must be a string") end
      local key, colon = string_at(text, at)
      if object[key] ~= nil then fail(at, "the key " .. key .. " comes twice") end
      colon = blank(text, colon)
      if text:sub(colon, colon) ~= ":" then fail(colon, "a colon must follow a key") end
      local next_at
      object[key], next_at = value(text, blank(text, colon + 1))
      keys[#keys + 1] = key
      return next_at
    end)
    json.keys[object] = keys
    return object, after
  elseif c == "[" then
    local array = {}
    local after = sequence(text, i + 1, "]", function(at)
      local v, next_at = value(text, at)
      array[#array + 1] = v
      return next_at
    end)
    return array, after
  elseif c == '"' then
    return string_at(text, i)
  end
  for word, v in pairs { ["true"] = true, ["false"] = false, null = json.null } do
    if text:sub(i, i + #word - 1) == word then return v, i + #word end
  end
  local number, after = text:match("^(%-?%d+%.?%d*[eE]?[+-]?%d*)()", i)
  if not number or number:find "^%-?0%d" or number:find "%.$" or number:find "%.[eE]" or not tonumber(number) then
    fail(i, "no value")
  end
  return tonumber(number), after
end

function json.read(text)
  local v, after = value(text, blank(text, 1))
  if blank(text, after) <= #text then fail(after, "text after the value") end
  return v
end

return json
