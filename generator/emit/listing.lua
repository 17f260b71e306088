-- listing.lua -- states, inputs, parameters and constants as the header lists them, each with what it is.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local inputs = require "generator.dynamics.inputs"
local number = require "generator.emit.number"

local listing = {}

-- States of several effects of one kind are told apart by the effects' lines, and those of one line, a helper's, by
-- their order in the scene.
function listing.told_apart(m, states)
  local list, alike, there, seen = {}, {}, {}, {}
  local function place(s) return s.effect and s.about .. s.effect.line end
  for _, s in ipairs(states) do
    alike[s.about] = (alike[s.about] or 0) + 1
    if place(s) then there[place(s)] = (there[place(s)] or 0) + 1 end
  end
  for i, s in ipairs(states) do
    local at, which = place(s), ""
    if at and s.about ~= "" and alike[s.about] > 1 then
      seen[at] = (seen[at] or 0) + 1
      which = string.format(" (%s:%d%s)", string.match(m.file, "[^/]*$"), s.effect.line,
        there[at] > 1 and string.format(", no. %d of that line", seen[at]) or "")
    end
    list[i] = { name = s.name, about = s.about .. which, unit = s.unit }
  end
  return list
end

-- Enumerators with their meaning; names that share one meaning (about = "" after the first) share a line.
function listing.enumeration(upper, list, last)
  local lines, names = {}, {}
  for i, s in ipairs(list) do
    names[#names + 1] = upper .. "_" .. (s.index or string.upper(s.name)) .. ","
    local next_one = list[i + 1]
    if not next_one or next_one.about ~= "" then
      local first = list[i - #names + 1]
      lines[#lines + 1] = table.concat(names, " ") .. " /* " .. first.about .. " [" .. first.unit .. "]" ..
        (first.limits or first.given or "") .. " */"
      names = {}
    end
  end
  lines[#lines + 1] = upper .. "_" .. last
  return lines
end

local longest = 40 -- letters of a formula that stands in a comment

-- The limits of an input in words, or nil: numbers, unless the parameters decide; then their formulas, and what the
-- scene's own parameters make of them.
local function limits(m, s)
  local low, high = inputs.range(m, s)
  if not low then return nil end
  local words = number.text(low, "double") .. " .. " .. number.text(high, "double")
  if expr.constant(s.low) and expr.constant(s.high) then return ", limited to " .. words end
  local formula = text.of(s.low) .. " .. " .. text.of(s.high)
  return ", limited to " .. (#formula <= longest and formula or "what the parameters say") .. "; by default " .. words
end

-- The inputs with their limits; ux, uy, uz share theirs.
function listing.described(m)
  local list = {}
  for i, s in ipairs(m.inputs) do
    list[i] = { index = s.index, about = s.about, unit = s.unit, limits = limits(m, s) }
  end
  return list
end

-- Has an input limits?
function listing.limited(m)
  for _, s in ipairs(m.inputs) do
    if s.low then return true end
  end
  return false
end

-- Members of the model with what they are; two with the same words also with their formula.
function listing.members(members, real_name)
  local list, alike = {}, {}
  for _, member in ipairs(members) do alike[member.about] = (alike[member.about] or 0) + 1 end
  for i, member in ipairs(members) do
    local line, about = real_name .. " " .. member.name .. "; ", member.about
    if alike[about] > 1 then -- what tells them apart
      local formula = text.of(member.e)
      about = about .. (#formula <= 60 and ": " .. formula or "; " .. member.name)
    end
    list[i] = { lines = { line .. "/* " .. about .. " */" } }
  end
  return list
end

return listing
