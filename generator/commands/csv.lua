-- csv.lua -- the columns of a CSV file by name and unit, for every command that reads one.
--
--     csv.open(host, path) -> file, or nil and a message
--         file.path, file.line (of the names), file.names; file.at[name] = place, file.units[place],
--         file.sigmas[place]
--         file.object: of host.csv, which has the law of such files (src/cli/host/csv.h)
--     file:read(columns, timed, least) -> rows, {values of each column}, {factor of each}; or nil and a message
--         columns: {name =, dim = (nil: numbers as they stand), unit = the dimension's name in messages (nil: SI's),
--         needed = no value may be missing}; timed: the column t is read, too; least: how many rows there must be
--     file:wrong(why) -> nil and the message, with the line of the names
-- Columns have their unit in brackets behind the name or in a comment `# units:`; without one, SI's.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local diag = require "generator.diag"
local nearest = require "generator.nearest"
local units = require "generator.dsl.units"

local csv, file = {}, {}
file.__index = file

local time = { name = "t", dim = units.time }

function file:wrong(why) return nil, self.path .. ":" .. diag.show(self.line) .. ": " .. why end

-- Names and units of the columns; or nil and what is wrong.
local function named(f, cells, given)
  local mark, numbers = #cells == 1 and string.match(cells[1], "[;\t]"), true
  if mark then
    return f:wrong("cells must be separated by commas, got " .. (mark == ";" and "semicolons" or "tabs"))
  end
  for i, cell in ipairs(cells) do
    local name, unit = string.match(cell, "^(.-)%s*%[([^%]]*)%]$")
    name, unit, numbers = name or cell, unit or given[i], numbers and tonumber(cell)
    if name == "" then return f:wrong("column " .. diag.show(i) .. " has no name") end
    if f.at[name] then return f:wrong("two columns are called " .. name) end
    f.at[name], f.names[i], f.units[i] = i, name, unit ~= "" and unit or nil
  end
  if numbers then return f:wrong "must name the columns, got numbers" end
  return true
end

function csv.open(host, path)
  local object, why = host.csv(path)
  if not object then return nil, why end
  local cells, given, sigmas, line = object:head()
  if not cells then return nil, given end
  local f = setmetatable({ object = object, path = path == "-" and "standard input" or path, line = line, names = {},
    at = {}, units = {}, sigmas = sigmas or {} }, file)
  local ok
  ok, why = named(f, cells, given or {})
  if not ok then return nil, why end
  for _, above in ipairs { { given or cells, "units" }, { sigmas or cells, "sigmas" } } do
    if #above[1] ~= #cells then
      return f:wrong(diag.show(#cells) .. " names, but " .. diag.show(#above[1]) .. " " .. above[2] .. " above them")
    end
  end
  return f
end

-- The factor to SI units; or nil and what is wrong.
local function factor_of(c, unit)
  if not unit or not c.dim then return 1.0 end
  local factor, own = units.parse(unit)
  if not factor then return nil, "column " .. c.name .. ": " .. own end
  if not units.equal(own, c.dim) then
    return nil, "column " .. c.name .. " must be in " .. (c.unit or units.si(c.dim)) .. ", got [" .. unit .. "]"
  end
  return R.todouble(evaluate.precise(factor, {}, 80))
end

function file:read(columns, timed, least)
  local list, factors, first = {}, {}, timed and 1 or 0
  for i = 1 - first, #columns do
    local c = i == 0 and time or columns[i]
    local place = self.at[c.name]
    if not place then
      local best = nearest.one(c.name, self.names)
      return self:wrong("has no column " .. c.name .. (i == 0 and ", the time" or c.output and
        ", which the scene measures" or "") .. " (it has " .. table.concat(self.names, ", ") .. ")" ..
        (best and "; did you mean " .. best .. "?" or ""))
    end
    local factor, why = factor_of(c, self.units[place])
    if not factor then return self:wrong(why) end
    list[i + first], factors[i] = { place, factor, i == 0 or c.needed }, factor
  end
  local rows, counts = self.object:read(list, timed)
  if not rows then return nil, counts end
  least = least or 1
  if rows < least then
    return nil, self.path .. ": must have " .. (least > 1 and "two rows" or "a row") .. " or more, got " ..
      diag.show(rows)
  end
  for i, n in ipairs(counts) do
    if n == 0 then return nil, self.path .. ": column " .. columns[i].name .. " has no value" end
  end
  return rows, counts, factors
end

return csv
