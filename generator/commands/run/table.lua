-- table.lua -- rows of a motion as the table that `polhode run` prints, and its two forms.
-- SPDX-License-Identifier: GPL-3.0-or-later

local json = require "generator.report.json"

local tables = {}

-- A motion's solve with rows for states, row_of(t, x, energy, L, on), on: see bounce.lua.  Returns rows, and the
-- states; or nil and the failure.
function tables.solver(motion, row_of)
  return function(times)
    local states, failure = motion.solve(times, {})
    if not states then return nil, failure end
    local rows = {}
    for i, s in ipairs(states) do
      local energy, L = motion.measured(s)
      if not energy then return nil, L end
      rows[i] = row_of(s.t, s.x, energy, L, s.on)
      for _, x in ipairs(rows[i]) do
        if x - x ~= 0 then return nil, { status = 3, t = s.t, text = "a column is not finite" } end
      end
    end
    return rows, states
  end
end

-- A name as a cell of CSV.
local function cell(name)
  return string.find(name, '[,"]') and '"' .. string.gsub(name, '"', '""') .. '"' or name
end

local function heading(names)
  local cells = {}
  for i, name in ipairs(names) do cells[i] = cell(name) end
  return table.concat(cells, ",")
end

tables.writers = {}

function tables.writers.csv(rows, names)
  local out = { heading(names) }
  for i, row in ipairs(rows) do
    local cells = {}
    for k = 1, #names do cells[k] = json.number(row[k]) end
    out[i + 1] = table.concat(cells, ",")
  end
  return table.concat(out, "\n") .. "\n"
end

-- The table of events.
function tables.events(found, names)
  local out = { "event," .. heading(names) }
  for i, f in ipairs(found) do
    local cells = { f.event.name }
    for k = 1, #names do cells[k + 1] = json.number(f.row[k]) end
    out[i + 1] = table.concat(cells, ",")
  end
  return table.concat(out, "\n") .. "\n"
end

function tables.writers.json(rows, names, found)
  local out = {}
  for i, row in ipairs(rows) do out[i] = row end
  local members = { { "columns", names }, { "rows", out } }
  if found then
    local list = {}
    for i, f in ipairs(found) do list[i] = json.object { { "name", f.event.name }, { "row", f.row } } end
    members[3] = { "events", list }
  end
  return json.text(json.object(members))
end

return tables
