-- units.lua -- C text in its parts: functions, types, data, macros, and what each of them uses.
--
--     units.parse(text) -> list of { text =, names = {..} | kind = "heading", prototype = bool, static = bool,
--                          global = bool (a function that is not static), uses = {identifier, ..} }
-- In the emitted code a part begins in the first column, with its comment, and ends with a } or ; there; blank lines
-- stand between parts.  A comment of its own is the heading of what follows, up to the next heading.  What an #if at
-- the first column holds is one part.  BELOW the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local plain = require "generator.emit.plain"

local units = {}

local has, name_before = plain.has, plain.name_before

-- Without comments, strings and characters.
local function bare(text)
  text = plain.uncommented(text, " ")
  if not has(text, '"') and not has(text, "'") then return text end
  text = string.gsub(text, "\\.", "")
  return (string.gsub(string.gsub(text, '"[^"\n]*"', '""'), "'[^'\n]*'", "''"))
end
units.bare = bare

-- The names that a declaration or a definition (without comments) gives.
local function names_of(code)
  local macro = string.match(code, "^%s*#define%s+([%w_]+)")
  if macro then return { macro } end
  local brace = string.find(code, "{", 1, true)
  local head = brace and string.sub(code, 1, brace - 1) or code
  if string.find(head, "^%s*typedef") then
    local last = string.find(code, ";%s*$")
    local out = { last and name_before(code, last) or string.match(code, "([%w_]+)%s*__attribute__") }
    out[#out + 1] = string.match(head, "struct%s+([%w_]+)")
    return out
  elseif string.find(head, "^%s*enum") then
    local out = {}
    for name in string.gmatch(string.match(code, "{(.*)}") or "", "[%a_][%w_]*") do out[#out + 1] = name end
    return out
  end
  local call = string.find(head, "(", 1, true)
  local equals, bracket = string.find(head, "=", 1, true), string.find(head, "[", 1, true)
  local value = equals and bracket and math.min(equals, bracket) or equals or bracket
  if value and not (call and call < value) then return { name_before(head, value) } end
  local last = call or string.find(head, ";", 1, true)
  return { last and name_before(head, last) }
end

-- The line after the comment that begins on line i; and is there code behind it?
local function after_comment(lines, i)
  while not string.find(lines[i], "*/", 1, true) do i = i + 1 end
  return i + 1, not string.find(lines[i], "%*/%s*$")
end

-- The last line of the #if that begins on line i.
local function matching(lines, i)
  local depth = 0
  repeat
    if string.find(lines[i], "^#if") then depth = depth + 1 end
    if string.find(lines[i], "^#endif") then depth = depth - 1 end
    i = i + 1
  until depth == 0
  return i - 1
end

-- The last line of the definition or declaration of which line i is the first line of code.
local function definition(lines, i)
  local depth, open, inside = 0, false, false
  while true do
    local line = lines[i]
    if inside then
      local _, last = string.find(line, "*/", 1, true)
      line = last and string.sub(line, last + 1) or ""
      inside = not last
    end
    if has(line, "/*") or has(line, '"') or has(line, "'") then
      line = bare(line)
      local from = string.find(line, "/*", 1, true)
      if from then line, inside = string.sub(line, 1, from - 1), true end
    end
    if has(line, "{") or has(line, "}") then
      for brace in string.gmatch(line, "[{}]") do depth = depth + (brace == "{" and 1 or -1) end
      open = true
    end
    if depth == 0 and not inside and (string.find(line, ";%s*$") or open and string.find(line, "^}%s*$")) then
      return i
    end
    i = i + 1
  end
end

-- Each identifier once, in the order of appearance.
local function used(code)
  local seen, list, n = {}, {}, 0
  for name in string.gmatch(code, "[%a_][%w_]*") do
    if not seen[name] then
      n = n + 1
      seen[name], list[n] = true, name
    end
  end
  return list
end

local function part(lines, from, to)
  local text = table.concat(lines, "\n", from, to)
  local code = bare(text)
  local word = string.match(code, "^%s*([%w_]+)") or ""
  local open = string.find(code, "{", 1, true)
  local call = string.find(code, "(", 1, true)
  return { text = text, names = names_of(code), uses = used(code), static = word == "static",
    global = word ~= "static" and word ~= "typedef" and string.find(word, "%l") ~= nil and open ~= nil and
      call ~= nil and call < open,
    -- what is declared here and defined elsewhere: a function, or a constant that is extern
    prototype = not open and not has(code, "=") and not has(code, "#") and (string.find(code, "%)%s*;%s*$") ~= nil or
      string.find(code, "^%s*extern ") ~= nil) }
end

-- What stands between #if and #endif, in one: whatever begins in the first column there has a name.
local function conditional(lines, first, from, to)
  local text, names = table.concat(lines, "\n", first, to), {}
  for i = from, to do
    local line = bare(lines[i])
    if string.find(line, "^#define") or string.find(line, "^[%a_]") then
      for _, name in ipairs(names_of(line)) do names[#names + 1] = name end
    end
  end
  return { text = text, names = names, uses = used(bare(text)), static = true }
end

function units.parse(text)
  local lines, out, i = plain.lines(text), {}, 1
  while i <= #lines do
    local first, heading = i, false
    if lines[i] == "" then
      i = i + 1
    else
      if string.find(lines[i], "^/%*") then
        local next_line, more = after_comment(lines, i)
        while not more and string.find(lines[next_line] or "", "^/%*") do
          next_line, more = after_comment(lines, next_line)
        end
        if more then next_line = next_line - 1 end
        heading = not more and (lines[next_line] == nil or lines[next_line] == "")
        i = next_line
      end
      if heading then
        out[#out + 1] = { text = table.concat(lines, "\n", first, i - 1), kind = "heading", names = {}, uses = {} }
      elseif string.find(lines[i], "^#if") then
        local last = matching(lines, i)
        out[#out + 1] = conditional(lines, first, i, last)
        i = last + 1
      elseif string.find(lines[i], "^#") then
        local last = i
        while string.find(lines[last], "\\$") do last = last + 1 end
        out[#out + 1] = part(lines, first, last)
        i = last + 1
      else
        local last = definition(lines, i)
        out[#out + 1] = part(lines, first, last)
        i = last + 1
      end
    end
  end
  return out
end

return units
