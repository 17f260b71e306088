-- diag.lua -- what is wrong with a scene, said once and clearly.
--
-- An error is `file:line: what: rule, got value`, followed by the source line it blames.  Errors are collected,
-- not thrown: a scene's author sees all of them at once (the first `cap`, then how many more).  Whoever finds an
-- error goes on with a harmless value.  A leaf: everybody may use it, it uses only diag/.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local broken = require "generator.diag.broken"
local tokens = later "generator.diag.tokens"

local diag = {}
diag.__index = diag

local cap = 20

-- Diagnostics for one scene: its file name as the user typed it, and its text.
function diag.new(file, text)
  local lines = {}
  text = string.gsub(string.gsub(text, "\r\n", "\n"), "\r", "\n") -- lines as Lua counts them
  for line in string.gmatch(text .. "\n", "([^\n]*)\n") do lines[#lines + 1] = line end
  return setmetatable({ file = file, text = text, lines = lines, errors = {}, warnings = {}, said = {} }, diag)
end

-- The diagnostics of one use of a scene that was accepted: errors of its own.
function diag:fork()
  return setmetatable({ errors = {}, said = {} }, { __index = self })
end

-- The line of the scene that is being executed, seen from inside one of the functions it calls.
function diag:here()
  local level = 2
  while true do
    local info = debug.getinfo(level, "Sl")
    if not info then return 0 end
    if info.source == "@" .. self.file and info.currentline > 0 then return info.currentline end
    level = level + 1
  end
end

-- The line on which argument `key` is written in a table constructor that opens on `line`, or `line` itself: the first
-- such table that has the key, at its own level, decides.  A reading aid: nothing depends on it but the line number.
function diag:locate(line, key)
  self.tokens = self.tokens or tokens.of(self.text)
  return tokens.argument(self.tokens, line, key) or line
end

-- The line of the first  :name  on or after `line`, where a chain of calls begins; `line` if there is none near.
function diag:called(line, name)
  self.tokens = self.tokens or tokens.of(self.text)
  return tokens.method(self.tokens, line, name) or line
end

-- Names of the locals that the scene can see where it is being executed, each once per function that has it.
function diag:locals()
  local list, level = {}, 2
  while true do
    local info = debug.getinfo(level, "Sf")
    if not info then return list end
    local n = 1
    while info.source == "@" .. self.file do
      local name = debug.getlocal(level, n)
      if not name then break end
      if string.find(name, "^[%a_]") then list[#list + 1] = name end -- not "(temporary)"
      n = n + 1
    end
    for i = 1, info.source == "@" .. self.file and 255 or 0 do -- Lua's own limit of upvalues
      local name = debug.getupvalue(info.func, i)
      if not name then break end
      if name ~= "_ENV" then list[#list + 1] = name end
    end
    level = level + 1
  end
end

-- The line that declares a local of this name, wherever; nil if none does.
function diag:declared(name)
  self.tokens = self.tokens or tokens.of(self.text)
  return tokens.declaration(self.tokens, name)
end

-- A scene shall not steer the terminal: Lua's own messages quote it as it is.
local function plain(message) return (string.gsub(message, "[\0-\8\11-\31\127]", "?")) end

local function entry(self, line, message)
  message = plain(message)
  local text = self.file .. (line > 0 and ":" .. line or "") .. ": " .. message -- 0: nobody knows where
  if self.said[text] then return nil end
  self.said[text] = true
  local source = self.lines[line]
  if source and string.find(source, "%S") then
    source = string.gsub(string.gsub(source, "^%s+", ""), "%c", " ")
    text = text .. "\n    " .. diag.cut(source, 160)
  end
  return { line = line, message = message, text = text }
end

-- what: the construct ("box"); rule: what must hold ("x must be positive"); got: the offending value as text.
-- A message that quotes what an unknown name stands for follows from the error that reported the name: it counts as an
-- error and is not shown.
function diag:error(line, what, rule, got)
  local message = what .. ": " .. rule .. (got and ", got " .. got or "")
  local e = entry(self, line, message)
  if e then e.follows = self:failed() and string.find(message, broken.mark, 1, true) ~= nil end
  self.errors[#self.errors + 1] = e
end

function diag:warn(line, what, text)
  self.warnings[#self.warnings + 1] = entry(self, line, what .. ": " .. text)
end

function diag:failed() return #self.errors > 0 end

-- All errors in source order, as one text.
function diag:report()
  local order = {}
  for i, e in ipairs(self.errors) do
    if not e.follows then order[#order + 1] = { e = e, i = i } end
  end
  table.sort(order, function(a, b)
    if a.e.line ~= b.e.line then return a.e.line < b.e.line end
    return a.i < b.i
  end)
  local out = {}
  for i = 1, math.min(cap, #order) do out[i] = order[i].e.text end
  local more = #order - cap
  if more > 0 then out[#out + 1] = self.file .. ": and " .. more .. " more error" .. (more > 1 and "s" or "") end
  return table.concat(out, "\n") .. "\n"
end

-- s, or its first n bytes (whole characters of UTF-8) and dots.
function diag.cut(s, n)
  if #s <= n then return s end
  return (string.gsub(string.sub(s, 1, n - 3), "[\192-\255][\128-\191]*$", "")) .. "..."
end

-- A number that was computed, for a message: three digits say enough.
function diag.rough(x) return string.format("%.3g", x) end

-- A value as it should be quoted in a message: on one line, bounded, the same on every machine.
function diag.show(x, depth)
  if type(x) == "string" then return (string.gsub(string.format("%q", diag.cut(x, 40)), "\\\n", "\\n")) end
  if type(x) == "number" then
    if math.type(x) == "integer" then return string.format("%d", x) end
    if x ~= x then return "nan" end -- its sign, which printf shows, depends on the machine
    for digits = 15, 17 do
      local s = string.format("%." .. digits .. "g", x)
      if tonumber(s) == x then return s end
    end
    return string.format("%g", x) -- an infinity
  end
  if type(x) == "table" then
    local meta = getmetatable(x)
    if meta and meta.__tostring then return tostring(x) end -- an object of the scene language
    depth = depth or 0
    local parts = {}
    for i = 1, math.min(#x, 6) do parts[i] = depth < 2 and diag.show(x[i], depth + 1) or "..." end
    if #x > 6 then parts[7] = "..." end
    return #parts > 0 and "{" .. table.concat(parts, ", ") .. "}" or "a table"
  end
  if x == nil then return "nothing" end
  if type(x) == "boolean" then return x and "true" or "false" end
  return "a " .. type(x)
end

return diag
