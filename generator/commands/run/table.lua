-- table.lua -- rows of a motion as the table that `polhode run` prints, and its two forms.
-- SPDX-License-Identifier: GPL-3.0-or-later

local json = require "generator.report.json"
local rows = require "generator.report.rows"

local tables = {}

-- A motion's solve with rows for states, row_of(t, x, energy, L, on), on: see bounce.lua.  Returns rows, and the
-- states; or nil and the failure.
function tables.solver(motion, row_of)
  return function(times)
    local states, failure = motion.solve(times, {})
    if not states then return nil, failure end
    local list = {}
    for i, s in ipairs(states) do
      local energy, L = motion.measured(s)
      if not energy then return nil, L end
      list[i] = row_of(s.t, s.x, energy, L, s.on)
      for _, x in ipairs(list[i]) do
        if x - x ~= 0 then return nil, { status = 3, t = s.t, text = "a column is not finite" } end
      end
    end
    return list, states
  end
end

tables.writers = {}

function tables.writers.csv(list, names) return rows.csv(names, list) end

-- The table of events.
function tables.events(found, names)
  local list = {}
  for i, f in ipairs(found) do list[i] = { f.event.name, table.unpack(f.row, 1, #names) } end
  return rows.csv({ "event", table.unpack(names) }, list)
end

function tables.writers.json(list, names, found)
  local out = {}
  for i, row in ipairs(list) do out[i] = row end
  local members = { { "columns", names }, { "rows", out } }
  if found then
    local events = {}
    for i, f in ipairs(found) do events[i] = json.object { { "name", f.event.name }, { "row", f.row } } end
    members[3] = { "events", events }
  end
  return json.text(json.object(members))
end

return tables
