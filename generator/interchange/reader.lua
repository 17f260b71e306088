-- reader.lua -- what the readers of all formats need: numbers out of XML, and complaints that name file and line.
--
-- A reader belongs to one file.  fail and warn take the element they are about; the message is
--     FILE:LINE: link "base": <mass> value must be positive, got -1
-- and goes to the functions the reader was made with.  A number means the decimal that is written, exactly.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"
local turns = require "generator.interchange.turns"
local nearest = require "generator.nearest"

local reader = {}
reader.__index = reader

-- fail(rule, got), warn(text): what to do with a complaint.
function reader.new(file, fail, warn)
  return setmetatable({ file = file, on_fail = fail, on_warn = warn, failed = false, owner = nil }, reader)
end

local function place(self, element)
  return self.file .. ":" .. element.line .. ": " .. (self.owner and self.owner .. ": " or "")
end

-- Always returns nil.
function reader:fail(element, rule, got)
  self.failed = true
  self.on_fail(place(self, element) .. rule, got)
  return nil
end

function reader:warn(element, text) self.on_warn(place(self, element) .. text) end

-- The child elements called `name`.
function reader.children(element, name)
  local list = {}
  for _, c in ipairs(element) do
    if c.name == name then list[#list + 1] = c end
  end
  return list
end

-- The child called `name`, or nil; more than one is a mistake.
function reader:child(element, name)
  local list = reader.children(element, name)
  if #list > 1 then self:fail(list[2], "<" .. element.name .. "> must have one <" .. name .. ">, got " .. #list) end
  return list[1]
end

-- A decimal number as C reads one, without infinities, NaN and hexadecimal; nil and a rule if it is none.
local function decimal(word)
  local sign, digits, exponent = string.match(word, "^([+-]?)([%d.]+)([eE]?[+-]?%d*)$")
  if not digits or not (string.find(digits, "^%d+%.?%d*$") or string.find(digits, "^%.%d+$")) or
    not (exponent == "" or string.find(exponent, "^[eE][+-]?%d+$")) then
    if string.find(word, "${", 1, true) then return nil, "must be a number (expand xacro files first)" end
    return nil, "must be a number"
  end
  if #word > 400 then return nil, "must have at most 400 characters" end -- no double needs more; exact ones must end
  if string.sub(digits, 1, 1) == "." then digits = "0" .. digits end
  if string.sub(digits, -1) == "." then digits = digits .. "0" end
  local q = R.parse((sign == "-" and "-" or "") .. digits .. exponent)
  local x = q and math.abs(R.todouble(q))
  if not q or x == math.huge or x == 0 and R.sign(q) ~= 0 then return nil, "must be within the range of double" end
  return q
end

-- n numbers with white space between, of the text found at `what`, with their words: {q, ..., words = {"1.0", ...}};
-- nil after a complaint.
function reader:numbers(element, what, text, n)
  local list = { words = {} }
  for word in string.gmatch(text, "[^ \t\r\n]+") do
    local q, rule = decimal(word)
    if not q then return self:fail(element, what .. " " .. rule, diag.show(word)) end
    list[#list + 1] = q
    list.words[#list] = word
  end
  if #list ~= n then
    return self:fail(element, what .. " must be " .. (n == 1 and "one number" or n .. " numbers"),
      #list == 0 and "none" or diag.show(text))
  end
  return list
end

-- The numbers of an attribute; `default` (a list) where there is no such attribute, nil after a complaint.
function reader:attribute(element, name, n, default)
  local what = "<" .. element.name .. "> " .. name
  local text = element.at[name]
  if text then return self:numbers(element, what, text, n) end
  if default then return default end
  return self:fail(element, what .. " is missing")
end

-- What was probably meant by a name that nobody reads, as the end of a message.  known: what there is, of which what is
-- there already cannot have been meant; show: how it is written.
local function meant(format, name, known, there, show)
  local other = format.elsewhere[name]
  if other then return ": " .. format.name .. " has " .. other end
  local list = {}
  for _, k in ipairs(known) do
    if not there(k) then list[#list + 1] = k end
  end
  local near = nearest.one(name, list)
  return near and ": did you mean " .. show(near) .. "?" or ""
end

local function tag(name) return "<" .. name .. ">" end

local function any(list, name)
  for _, k in ipairs(list or {}) do
    if k == name then return true end
  end
  return false
end

-- Warns of what nobody reads in the element and below it.  format.reads: {[name of an element] = {at = attributes, has
-- = elements, text = is its text read?}}, the whole list of what the format's reader looks at.
function reader:unread(format, element)
  local reads = format.reads[element.name]
  for _, name in ipairs(element.at) do
    if not any(reads.at, name) and not string.find(name, "^xml") then
      self:warn(element, tag(element.name) .. " " .. name .. " is not read" ..
        meant(format, name, reads.at or {}, function(k) return element.at[k] ~= nil end, tostring))
    end
  end
  if not reads.text and string.find(element.text, "%S") then
    self:warn(element, tag(element.name) .. " " .. diag.show(string.match(element.text, "^%s*(.-)%s*$")) ..
      " is not read: its numbers are in " .. (reads.at and "attributes" or "elements"))
  end
  for _, e in ipairs(element) do
    if any(reads.has, e.name) then
      self:unread(format, e)
    else
      self:warn(e, tag(e.name) .. " in " .. tag(element.name) .. " is not read" ..
        meant(format, e.name, reads.has or {}, function(k) return reader.children(element, k)[1] ~= nil end, tag))
    end
  end
end

-- Warns of what looks as if it should have been a child `name` of the element, or belongs into <inertial>.
function reader:misplaced(format, element, name)
  for _, e in ipairs(element) do
    if any(format.inside, e.name) then
      self:warn(e, tag(e.name) .. " in " .. tag(element.name) .. " is not read: it belongs into <inertial>")
    elseif e.name ~= name and nearest.slips(e.name, name) then
      self:warn(e, tag(e.name) .. " in " .. tag(element.name) .. " is not read: did you mean " .. tag(name) .. "?")
    end
  end
end

-- Warns of attributes that look like one of `names` mistyped.
function reader:mistyped(element, names)
  for _, name in ipairs(element.at) do
    local near = not any(names, name) and nearest.one(name, names)
    if near then
      self:warn(element, tag(element.name) .. " " .. name .. " is not read: did you mean " .. near .. "?")
    end
  end
end

-- Warns of angles that are probably in another unit.
function reader:angles(element, what, list, degrees)
  for _, q in ipairs(list) do
    local why = turns.suspect(q, degrees, diag.show(R.todouble(q)))
    if why then self:warn(element, what .. " " .. why) end
  end
end

-- "true" or "1".
function reader.yes(text) return text == "true" or text == "1" end

return reader
