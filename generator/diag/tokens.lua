-- tokens.lua -- where a scene's text has what: just enough of Lua's lexical rules to find an argument's line.
--
-- Tokens are names, strings and long strings (with their quotes, so that none equals a name), numbers, and signs one by
-- one (== and its kin as one); comments are no tokens.  The text has been compiled, so it is well formed; if it were
-- not, only a line number in a message would be wrong.  A leaf.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tokens = {}

local open, close = { ["{"] = true, ["("] = true, ["["] = true }, { ["}"] = true, [")"] = true, ["]"] = true }
local before_key = { ["{"] = true, [","] = true, [";"] = true }

local most_steps = 20000 -- of one search: a line with thousands of braces is nobody's

-- The end of the token that starts at `at`, and whether it counts (comments do not).
local function finish(text, at)
  local comment = string.sub(text, at, at + 1) == "--"
  local _, bracket, level = string.find(text, "^%[(=*)%[", comment and at + 2 or at)
  if bracket then
    local _, last = string.find(text, "]" .. level .. "]", bracket + 1, true)
    return last or #text, not comment
  end
  if comment then return string.find(text, "\n", at, true) or #text, false end
  local c = string.sub(text, at, at)
  if c == "\"" or c == "'" then
    local i = at + 1
    while i <= #text and string.sub(text, i, i) ~= c do
      i = i + (string.sub(text, i, i) == "\\" and 2 or 1)
    end
    return i, true
  end
  local _, last = string.find(text, "^[%a_][%w_]*", at)
  if not last then _, last = string.find(text, "^%d[%w.]*", at) end
  if not last then _, last = string.find(text, "^[=~<>]=", at) end
  return last or at, true
end

-- {[1..n] = texts, line = {lines}, first = {line -> number of its first token}}
function tokens.of(text)
  local list = { line = {}, first = {} }
  local at, line = 1, 1
  while true do
    local from = string.find(text, "%S", at)
    local blank = string.sub(text, at, (from or #text + 1) - 1)
    line = line + select(2, string.gsub(blank, "\n", ""))
    if not from then return list end
    local last, counts = finish(text, from)
    local s = string.sub(text, from, last)
    if counts then
      list[#list + 1] = s
      list.line[#list] = line
      list.first[line] = list.first[line] or #list
    end
    line = line + select(2, string.gsub(s, "\n", ""))
    at = last + 1
  end
end

-- Is token i the name of the field `key`, as  key =  or  ["key"] =  ?
local function names_field(list, i, key)
  if list[i] == key then return list[i + 1] == "=" and before_key[list[i - 1]] end
  return list[i] == "[" and before_key[list[i - 1]] and list[i + 3] == "=" and list[i + 2] == "]"
    and string.sub(list[i + 1], 2, -2) == key
end

-- The line of the field `key` in a table that opens on `line`; nil if there is none.
function tokens.argument(list, line, key)
  local left = most_steps
  local i = list.first[line]
  while i and list.line[i] == line do
    if list[i] == "{" then
      local depth = 0
      for j = i, #list do
        if depth == 1 and names_field(list, j, key) then return list.line[j] end
        depth = depth + (open[list[j]] and 1 or close[list[j]] and -1 or 0)
        left = left - 1
        if depth == 0 or left == 0 then break end
      end
      if left == 0 then return nil end
    end
    i = i + 1
  end
  return nil
end

-- The line of the first  local NAME, ...  or  local function NAME  that has the name; nil if there is none.
function tokens.declaration(list, name)
  for i = 1, #list do
    if list[i] == "local" then
      local j = i + (list[i + 1] == "function" and 2 or 1)
      while list[j] ~= name and list[j + 1] == "," do j = j + 2 end
      if list[j] == name then return list.line[j] end
    end
  end
  return nil
end

-- The line of the first  :name  from `line` on; nil if there is none within a page.
function tokens.method(list, line, name)
  for i = list.first[line] or #list + 1, #list do
    if list.line[i] > line + 60 then return nil end
    if list[i] == ":" and list[i + 1] == name then return list.line[i + 1] end
  end
  return nil
end

return tokens
