-- safe.lua - the part of Lua's library that a scene may be given.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Rules for what is here:
--   no way out: nothing that loads code, touches files, metatables, coroutines, the collector, or catches
--     errors (a finalizer runs with hooks off; a pcall could swallow the sandbox's);
--   no unbounded C: a C function whose work is not bounded by the size of its operands' memory is replaced by
--     one written here, whose loop the sandbox's hook can stop, or is given a bound;
--   same scene, same bytes: no addresses, no clock, no chance, no hash order.
-- Patterns (find, match, gmatch, gsub) are left out: matching backtracks in C for as long as it likes.
-- Also here: the metatable of strings gets these functions, so that ("x"):rep is bounded too.  The
-- generator itself therefore calls string.match(s, ...), never s:match(...).

-- visible(f): f behind a C function.  In `return f(x)` Lua forgets the caller before f runs, but not before a C
-- function does; so the scene's line can be named.
local visible = ...

local error, getmetatable, next, rawget, select, tostring, type =
  error, getmetatable, next, rawget, select, tostring, type
local string, table = string, table -- called as string.format: messages name "format"

local MAX_TEXT = 1000000  -- bytes of a text made by rep, concat, format
local MAX_VALUES = 10000  -- values unpacked at once
local MAX_ITEMS = 1000000 -- entries that concat joins

local function whole(value, what, name)
  local n = math.tointeger(value)
  if n == nil then
    error(string.format("%s: %s must be a whole number, got %s", name, what, type(value)), 3)
  end
  return n
end

-- Numbers before strings before booleans, each ascending: an order that does not depend on a hash.
local RANK = { number = 1, string = 2, boolean = 3 }
local function before(a, b)
  local rank_a, rank_b = RANK[type(a)], RANK[type(b)]
  if rank_a ~= rank_b then
    return rank_a < rank_b
  elseif rank_a == 3 then
    return not a and b
  end
  return a < b
end

local function safe_pairs(t)
  if type(t) ~= "table" then
    error("pairs: table expected, got " .. type(t), 2)
  end
  local keys, n = {}, 0
  for key in next, t do
    if RANK[type(key)] == nil then
      error("pairs: a key is a " .. type(key) .. "; only numbers, strings and booleans have an order", 2)
    end
    n = n + 1
    keys[n] = key
  end
  table.sort(keys, before)
  local i = 0
  return function()
    local value
    repeat -- entries removed meanwhile are passed over
      i = i + 1
      value = rawget(t, keys[i])
    until value ~= nil or i > n
    if i <= n then
      return keys[i], value
    end
  end
end

-- As tostring, but what would show an address shows its type.
local function safe_tostring(...)
  if select("#", ...) == 0 then
    error("tostring: value expected", 2)
  end
  local value = ...
  local kind = type(value)
  if kind == "table" or kind == "userdata" then
    local meta = getmetatable(value)
    if type(meta) ~= "table" or meta.__tostring == nil then
      return kind
    end
  elseif kind == "function" or kind == "thread" then
    return kind
  end
  return tostring(value)
end

local function safe_rep(s, n, separator)
  local kind = type(s)
  if kind ~= "string" and kind ~= "number" then
    error("rep: string expected, got " .. kind, 2)
  end
  s, n, separator = tostring(s), whole(n, "the count", "rep"), separator or ""
  if type(separator) ~= "string" then
    error("rep: the separator must be a string, got " .. type(separator), 2)
  end
  local each = #s + #separator
  if n <= 0 or each == 0 then
    return ""
  elseif n > MAX_TEXT // each then
    error(string.format("rep: the text would be longer than %d bytes", MAX_TEXT), 2)
  end
  return string.rep(s, n, separator)
end

local function safe_format(format, ...)
  if type(format) ~= "string" then
    error("format: string expected, got " .. type(format), 2)
  elseif #format > MAX_TEXT then
    error(string.format("format: longer than %d bytes", MAX_TEXT), 2)
  end
  -- %% first, so that "%%p" is text and not a conversion
  for conversion in string.gmatch(format, "%%[^%a%%]*[%a%%]?") do
    if string.find(conversion, "p", 1, true) then
      error("format: no addresses (%p)", 2)
    end
  end
  local values, size = { ... }, #format
  local n = select("#", ...)
  for i = 1, n do
    local value = values[i]
    if type(value) ~= "number" and type(value) ~= "string" and type(value) ~= "boolean" then
      values[i] = safe_tostring(value)
    end
    size = size + (type(value) == "string" and #value or 0)
  end
  if size > MAX_TEXT then
    error(string.format("format: the text would be longer than %d bytes", MAX_TEXT), 2)
  end
  return string.format(format, table.unpack(values, 1, n))
end

local function range(first, last, default, most, name)
  first = first == nil and 1 or whole(first, "the first index", name)
  last = last == nil and default or whole(last, "the last index", name)
  if first <= last and (last - first < 0 or last - first >= most) then
    error(string.format("%s: more than %d values", name, most), 3)
  end
  return first, last
end

-- An object with metamethods could claim any length and answer any index.
local function check_table(t, name)
  if type(t) ~= "table" or getmetatable(t) ~= nil then
    error(string.format("%s: plain table expected, got %s", name, type(t) == "table" and "an object" or type(t)), 3)
  end
end

local function safe_insert(t, ...)
  check_table(t, "insert")
  return table.insert(t, ...)
end

local function safe_remove(t, ...)
  check_table(t, "remove")
  return table.remove(t, ...)
end

local function safe_unpack(t, first, last)
  check_table(t, "unpack")
  first, last = range(first, last, #t, MAX_VALUES, "unpack")
  return table.unpack(t, first, last)
end

local function safe_concat(t, separator, first, last)
  check_table(t, "concat")
  first, last = range(first, last, #t, MAX_ITEMS, "concat")
  separator = separator or ""
  local parts, size, n = {}, 0, 0
  for i = first, last do
    local part = t[i]
    if type(part) ~= "string" and type(part) ~= "number" then
      error(string.format("concat: entry %d is a %s", i, type(part)), 2)
    end
    n = n + 1
    parts[n] = part
    size = size + #tostring(part) + #separator
    if size > MAX_TEXT then
      error(string.format("concat: the text would be longer than %d bytes", MAX_TEXT), 2)
    end
  end
  return table.concat(parts, separator)
end

-- The comparison is always a Lua function: the hook can stop a sort of millions.
local function safe_sort(t, less)
  check_table(t, "sort")
  if less ~= nil and type(less) ~= "function" then
    error("sort: function expected, got " .. type(less), 2)
  end
  return table.sort(t, less or function(a, b) return a < b end)
end

local function safe_string()
  return {
    byte = string.byte, char = string.char, format = visible(safe_format), len = string.len, lower = string.lower,
    rep = visible(safe_rep), reverse = string.reverse, sub = string.sub, upper = string.upper,
  }
end

local safe_math = {}
for name, value in next, math do
  if name ~= "random" and name ~= "randomseed" then
    safe_math[name] = value
  end
end

-- A second copy: a scene can write into the table that it is given, but never reaches this one.
getmetatable("").__index = safe_string()

return {
  assert = assert, error = error, ipairs = ipairs, pairs = visible(safe_pairs), select = select, tonumber = tonumber,
  tostring = visible(safe_tostring), type = type,
  math = safe_math,
  string = safe_string(),
  table = {
    concat = visible(safe_concat), insert = visible(safe_insert), remove = visible(safe_remove),
    sort = visible(safe_sort), unpack = visible(safe_unpack),
  },
}
