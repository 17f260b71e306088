-- table.lua -- rows of a motion as the table that `polhode run` prints, and its two forms.
-- SPDX-License-Identifier: GPL-3.0-or-later

local json = require "generator.report.json"

local tables = {}

-- The names of the columns, and a row of them from t, the scene's state, energy and L (nil without attitude).
function tables.columns(job)
  local list, first = { "t" }, {}
  for i, s in ipairs(job.states) do
    if s.kind == "attitude" or s.kind == "rates" then
      list[#list + 1], first[#first + 1] = s.name, i
    end
  end
  list[#list + 1] = "energy"
  for _, name in ipairs(job.model.has.attitude and { "Lx", "Ly", "Lz" } or {}) do list[#list + 1] = name end
  for i = #first + 1, #job.states do list[#list + 1] = job.states[i].name end
  return list, function(t, x, energy, L)
    local row = { t, table.unpack(x, 1, #first) }
    row[#row + 1] = energy
    for _, y in ipairs(job.model.has.attitude and L or {}) do row[#row + 1] = y end
    for i = #first + 1, #x do row[#row + 1] = x[i] end
    return row
  end
end

-- A motion's solve with rows of the table for states: rows, and the states; or nil and the failure.
function tables.solver(job, motion)
  local _, row_of = tables.columns(job)
  return function(times)
    local states, failure = motion.solve(times, {})
    if not states then return nil, failure end
    local rows = {}
    for i, s in ipairs(states) do
      local energy, L = motion.measured(s)
      if not energy then return nil, L end
      rows[i] = row_of(s.t, s.x, energy, L)
    end
    return rows, states
  end
end

tables.writers = {}

function tables.writers.csv(rows, names, found)
  local out = { table.concat(names, ",") }
  for i, row in ipairs(rows) do
    local cells = {}
    for k = 1, #names do cells[k] = json.number(row[k]) end
    out[i + 1] = table.concat(cells, ",")
  end
  local text = table.concat(out, "\n") .. "\n"
  if not found then return text end
  out = { "event," .. table.concat(names, ",") }
  for i, f in ipairs(found) do
    local cells = { f.event.name }
    for k = 1, #names do cells[k + 1] = json.number(f.row[k]) end
    out[i + 1] = table.concat(cells, ",")
  end
  return text .. "\n" .. table.concat(out, "\n") .. "\n"
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
