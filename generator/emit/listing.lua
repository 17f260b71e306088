-- listing.lua -- states, inputs, parameters and constants as the header lists them, each with what it is.
-- SPDX-License-Identifier: GPL-3.0-or-later

local text = require "generator.algebra.text"
local inputs = require "generator.dynamics.inputs"
local number = require "generator.emit.number"

local listing = {}

-- States of several effects of one kind are told apart by the effects' lines.
function listing.told_apart(m, states)
  local list, alike = {}, {}
  for _, s in ipairs(states) do alike[s.about] = (alike[s.about] or 0) + 1 end
  for i, s in ipairs(states) do
    local which = s.effect and s.about ~= "" and alike[s.about] > 1 and
      string.format(" (%s:%d)", string.match(m.file, "[^/]*$"), s.effect.line) or ""
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
        (first.limits or "") .. " */"
      names = {}
    end
  end
  lines[#lines + 1] = upper .. "_" .. last
  return lines
end

-- The inputs with their limits in words; ux, uy, uz share theirs.
function listing.described(m)
  local list = {}
  for i, s in ipairs(m.inputs) do
    local low, high = inputs.range(m, s)
    list[i] = { index = s.index, about = s.about, unit = s.unit, limits = low and ", limited to " ..
      number.text(low, "double") .. " .. " .. number.text(high, "double") }
  end
  return list
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
