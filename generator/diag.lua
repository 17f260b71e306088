-- diag.lua -- what is wrong with a scene, said once and clearly.
--
-- An error is `file:line: what: rule, got value`, followed by the source line it blames.  Errors are collected,
-- not thrown: a scene's author sees all of them at once (the first `cap`, then how many more).  Whoever finds an
-- error goes on with a harmless value.  A leaf: everybody may use it, it uses nobody.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = {}
diag.__index = diag

local cap = 20

-- Diagnostics for one scene: its file name as the user typed it, and its text.
function diag.new(file, text)
  local lines = {}
  for line in string.gmatch(text .. "\n", "(.-)\r?\n") do lines[#lines + 1] = line end
  return setmetatable({ file = file, lines = lines, errors = {}, warnings = {}, said = {} }, diag)
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

-- The line on which argument `key` is written in the table constructor that starts on `line`, or `line` itself.
-- A reading aid: strings and comments are skipped, nesting is counted, nothing depends on it but the line number.
function diag:locate(line, key)
  local depth, opened = 0, false
  for n = line, math.min(#self.lines, line + 200) do
    local s = self.lines[n] or ""
    s = string.gsub(s, "\"[^\"]*\"", function(q) return "\"" .. string.rep("_", #q - 2) .. "\"" end)
    s = string.gsub(s, "%-%-.*", "")
    if string.find(s, "%f[%w_]" .. key .. "%s*=[^=]") or string.find(s, "%f[%w_]" .. key .. "%s*=$") then return n end
    for c in string.gmatch(s, "[{}()]") do
      depth = depth + ((c == "{" or c == "(") and 1 or -1)
      opened = opened or depth > 0
    end
    if opened and depth <= 0 then break end
  end
  return line
end

local function entry(self, line, message)
  local text = self.file .. (line > 0 and ":" .. line or "") .. ": " .. message -- 0: nobody knows where
  if self.said[text] then return nil end
  self.said[text] = true
  local source = self.lines[line]
  if source and string.find(source, "%S") then
    text = text .. "\n    " .. string.gsub(string.gsub(source, "^%s+", ""), "\t", " ")
  end
  return { line = line, message = message, text = text }
end

-- what: the construct ("box"); rule: what must hold ("x must be positive"); got: the offending value as text.
function diag:error(line, what, rule, got)
  local message = what .. ": " .. rule .. (got and ", got " .. got or "")
  self.errors[#self.errors + 1] = entry(self, line, message)
end

function diag:warn(line, what, text)
  self.warnings[#self.warnings + 1] = entry(self, line, what .. ": " .. text)
end

function diag:failed() return #self.errors > 0 end

-- All errors in source order, as one text.
function diag:report()
  local order = {}
  for i, e in ipairs(self.errors) do order[i] = { e = e, i = i } end
  table.sort(order, function(a, b)
    if a.e.line ~= b.e.line then return a.e.line < b.e.line end
    return a.i < b.i
  end)
  local out = {}
  for i = 1, math.min(cap, #order) do out[i] = order[i].e.text end
  if #order > cap then out[#out + 1] = self.file .. ": and " .. (#order - cap) .. " more errors" end
  return table.concat(out, "\n") .. "\n"
end

-- A value as it should be quoted in a message.
function diag.show(x)
  if type(x) == "string" then
    if #x > 40 then x = string.sub(x, 1, 37) .. "..." end
    return string.format("%q", x)
  end
  if type(x) == "number" then
    if math.type(x) == "integer" then return string.format("%d", x) end
    if x ~= x then return "nan" end -- its sign, which printf shows, depends on the machine
    for digits = 15, 17 do
      local s = string.format("%." .. digits .. "g", x)
      if tonumber(s) == x then return s end
    end
    return string.format("%g", x)
  end
  if type(x) == "table" then
    local parts = {}
    for i = 1, math.min(#x, 6) do parts[i] = diag.show(x[i]) end
    if #x > 6 then parts[7] = "..." end
    return #parts > 0 and "{" .. table.concat(parts, ", ") .. "}" or "a table"
  end
  if x == nil then return "nothing" end
  if type(x) == "boolean" then return x and "true" or "false" end
  return "a " .. type(x)
end

return diag
