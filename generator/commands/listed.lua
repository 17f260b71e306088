-- listed.lua -- the functions that a scene can have: gen --list.
--
--     listed.text(unit) -> table as text: function, file, lines, operations, what it calls
--     listed.names(unit) -> list of their names, without the scene's prefix
-- unit: driver.code of a plan with everything in it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local selection = require "generator.selection"

local listed = {}

local function short(unit, name) return string.sub(name, #unit.model.name + 2) end

function listed.names(unit)
  local out = {}
  for i, f in ipairs(unit.emitted) do out[i] = short(unit, f.name) end
  return out
end

-- "12 + 24 *": what one call takes, where it is made of equations.
local function operations(row)
  local parts = {}
  for _, k in ipairs { { "add", "+" }, { "mul", "*" }, { "div", "/" }, { "sqrt", "sqrt" }, { "call", "calls" } } do
    if row and row[k[1]] ~= "0" then parts[#parts + 1] = row[k[1]] .. " " .. k[2] end
  end
  return table.concat(parts, ", ")
end

function listed.text(unit)
  local cost, public, rows, widths = {}, {}, { { "function", "file", "lines", "operations", "calls" } }, {}
  for _, row in ipairs(unit.costs) do cost[row.name] = row end
  for _, f in ipairs(unit.emitted) do public[f.name] = true end
  for _, f in ipairs(unit.emitted) do
    local name, calls = short(unit, f.name), {}
    for _, used in ipairs(f.uses) do
      if public[used] and used ~= f.name then calls[#calls + 1] = short(unit, used) end
    end
    table.sort(calls)
    rows[#rows + 1] = { name, unit.model.name .. selection.tails[selection.room(name, f.of)] .. ".c",
      string.format("%d", f.lines), operations(cost[name]), table.concat(calls, " ") }
  end
  for _, row in ipairs(rows) do
    for i, cell in ipairs(row) do widths[i] = math.max(widths[i] or 0, #cell) end
  end
  local lines = {}
  for i, row in ipairs(rows) do
    local cells = {}
    for k, cell in ipairs(row) do cells[k] = cell .. string.rep(" ", widths[k] - #cell) end
    lines[i] = string.gsub(table.concat(cells, "  "), "%s+$", "")
  end
  return table.concat(lines, "\n") .. "\n"
end

return listed
