-- what.lua -- what --what names beside the pictures: columns and expressions, each a panel, {A, B} in one.
--
--     what.of(list, read) -> {[entry] = panels: {title =, note =, {name =, unit =, place = in wanted}, ...}}, wanted
--     (all their columns); or nil and what is wrong.  read: entry -> its columns (run/columns.lua), or nil and why not
-- SPDX-License-Identifier: GPL-3.0-or-later

local columns = require "generator.commands.run.columns"
local options = require "generator.commands.options"
local panels = require "generator.plot.panels"

local what = {}

local most = 5 -- curves of a panel that can be told apart; nine become three panels of three

local known = {}
for _, name in ipairs(panels.names) do known[name] = true end

-- What --range calls an entry: the name that the user gave an expression, else its text.
function what.key(entry)
  return string.match(entry, "^([%a_][%w_]*)%s*=%s*[^=]") or entry
end

function what.sorted(set)
  local list = {}
  for name in pairs(set) do list[#list + 1] = name end -- sorted below
  table.sort(list)
  return list
end

function what.of_scene(host, job) return columns.reader(host, job, "--what", panels.names) end

-- Columns of one unit together, no more than can be told apart.
local function split(entry, list, about)
  local out, size = {}, #list % 3 == 0 and #list > most and 3 or most
  for _, c in ipairs(list) do
    local last = out[#out]
    if not last or last[1].unit ~= c.unit or #last == size then
      last = { title = entry, note = about }
      out[#out + 1] = last
    end
    last[#last + 1] = c
  end
  return out
end

function what.of(list, read)
  local asked, wanted = {}, {}
  for _, entry in ipairs(list or {}) do
    local inner = string.match(entry, "^{(.*)}$")
    local found, about = {}, nil
    local words = known[entry] and {} or inner and options.entries(inner) or { entry }
    for _, word in ipairs(words) do
      if word == "" then return nil, "--what must have words or expressions between commas, got " .. entry end
      local some, why = read(word)
      if not some then return nil, why end
      for _, c in ipairs(some) do
        wanted[#wanted + 1] = c
        found[#found + 1] = { name = c.name, unit = c.unit, place = #wanted }
      end
      about = not inner and some.about or nil
    end
    if inner and #found > most then
      return nil, "--what: a panel has up to " .. most .. " curves, got " .. #found .. " in " .. entry
    end
    asked[entry] = not inner and split(entry, found, about) or { { title = table.concat(words, ", "),
      table.unpack(found) } }
  end
  return asked, wanted
end

return what
