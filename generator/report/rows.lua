-- rows.lua -- rows of numbers and names as CSV: what all commands write.  src/cli/host/csv.h has the law of such files.
-- SPDX-License-Identifier: GPL-3.0-or-later

local json = require "generator.report.json"

local rows = {}

-- Text as it stands, in quotes where it has to be; a number by the shortest digits that read back, or nan.
local function cell(x)
  if type(x) == "number" then return x ~= x and "nan" or json.number(x) end
  if not string.find(x, '[,"\n]') and not string.find(x, "^[#%s]") and not string.find(x, "%s$") then return x end
  return '"' .. string.gsub(x, '"', '""') .. '"'
end

local function line(list, n)
  local cells = {}
  for k = 1, n do cells[k] = cell(list[k]) end
  return table.concat(cells, ",")
end

-- list: rows of as many cells as there are names, or more, which are left out.
function rows.csv(names, list)
  local out = { line(names, #names) }
  for i, row in ipairs(list) do out[i + 1] = line(row, #names) end
  return table.concat(out, "\n") .. "\n"
end

return rows
