-- recorded.lua -- a motion that the general library computes before the page is made: `polhode view --trajectory`.
--
-- Rows at equal steps, as many as the fastest turn of the body needs; the page shows them and computes nothing.
-- SPDX-License-Identifier: GPL-3.0-or-later

local bounce = require "generator.commands.run.bounce"
local events = require "generator.commands.events"
local touch = require "generator.commands.run.touch"
local facts = require "generator.report.facts"
local bytes = require "generator.page.bytes"

local recorded = {}

local FEWEST, MOST = 600, 4000
local BYTES = 600000 -- of the rows in base64: a page has at most 1 MB
local ANGLE = 0.04 -- rad from row to row: what an eye takes for a continuous turn

-- States and what was measured of them at n + 1 times up to the end; or nil and a failure of run/engines.lua.
local function rows_of(seen, finish, n)
  local ts = {}
  for i = 0, n do ts[i + 1] = finish * (i / n) end
  local out, failure = seen(ts)
  for i, s in ipairs(out or {}) do
    out[i] = { s.t, table.unpack(s.x) }
    for _, v in ipairs { s.energy, s.L[1], s.L[2], s.L[3] } do table.insert(out[i], v) end
    local k = s.contact
    for _, v in ipairs(k and { 1, 2, 3, 4, 11, 12, 13 } or {}) do table.insert(out[i], k[v]) end -- N, com, point
  end
  return out, failure
end

-- How many rows the motion wants: by its largest rate in the first ones.
local function wanted(scene, rows, finish)
  local largest = 0.0
  for _, row in ipairs(rows) do
    local sum = 0.0
    for i, s in ipairs(scene.states) do
      if s.kind == "rates" then sum = sum + row[1 + i] ^ 2 end
    end
    largest = math.max(largest, math.sqrt(sum))
  end
  local most = math.min(MOST, BYTES // (#rows[1] * 8 * 4 // 3))
  return math.floor(math.max(FEWEST, math.min(most, largest * finish / ANGLE)))
end

-- The rows {t, states, energy, L, with a plane N, centre of mass and contact point}, the method, and what is said of an
-- end before the horizon; or nil and a failure.  given: the command's, its ground that of bounce.lua; inputs: over
-- time, or nil.
function recorded.rows(host, scene, given, inputs)
  local method, finish = (given.method or {})[1], scene.model:double(scene.model.horizon)
  local motion, failure = bounce.motion(host, scene, { method = method, ground = given.ground }, inputs)
  if not motion then return nil, failure end
  local seen = touch.seen(host, scene, motion, inputs, given.ground)
  local ending, wrong = events.ending(host, scene, motion, finish, inputs)
  if ending == false then return nil, wrong end
  if ending and ending.event.reaction then ending = nil end -- the rows show it
  if ending then finish = ending.row.t end
  local rows
  rows, failure = rows_of(seen, finish, FEWEST)
  local n = rows and wanted(scene, rows, finish)
  if n and n > FEWEST then rows, failure = rows_of(seen, finish, n) end
  if not rows then return nil, failure end
  return rows, motion.method, ending and ending.said
end

-- {method, count, rows (in base64), mass, com, inertia, moments, axes}, or nil and a failure.
function recorded.of(host, scene, given, inputs)
  local rows, method, ended = recorded.rows(host, scene, given, inputs)
  if not rows then return nil, method end
  local all = {}
  for _, row in ipairs(rows) do table.move(row, 1, #row, #all + 1, all) end
  local f = facts.of(scene)
  return { ended = ended, finish = rows[#rows][1], method = method, count = #rows,
    rows = bytes.doubles(all), mass = f.mass_number,
    com = f.arm_number, inertia = f.inertia_number, moments = f.moments, axes = f.axes }
end

return recorded
