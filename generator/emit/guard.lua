-- guard.lua -- NAME_within: is a state within the ranges that the scene declares?  Emitted where it declares any.
--
-- The attitude is held by its norm alone: an angle of `ranges` says where motions start, not how far they turn.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local template = require "generator.emit.template"

local guard = {}

-- |q|^2 of what is taken for an attitude: from 1/4 to 4, so each component is within -2 and 2.
-- `part`: what the largest component at least is then, a little less than 1/4 for the sake of rounding.
guard.least, guard.most, guard.component, guard.part = R.new(1, 4), R.lift(4), R.lift(2), R.new(15, 64)

-- The two ends of a range, as the real type has them: texts.
function guard.ends(range, real)
  return number.text(range.lo, real), number.text(range.hi, real)
end

-- A number a few units of the last place beyond q, so that it does not round to q.
local function beyond(q, side, real)
  local bits = real == "float" and 20 or 49
  return q + R.new(side) * (R.abs(q) * R.new(2) ^ -bits + R.new(2) ^ -100)
end

local function plain(q) -- for a comment: the double, without the suffix of a float
  return number.text(R.fromdouble(R.todouble(q)), "double")
end

-- Fills guard_header and guard_source, and what the self-test wants of them; empty without ranges.
function guard.fill(job, v)
  v.has_guard, v.guard_header, v.guard_source = job.ranges ~= nil, "", ""
  if not v.has_guard then return end
  local real = job.real
  v.guard_norm, v.guard_states, v.guard_about, v.guard_rows = false, {}, {}, {}
  v.guard_least, v.guard_most = number.text(guard.least, real), number.text(guard.most, real)
  v.guard_component = number.text(guard.component, real)
  local first
  for i, s in ipairs(job.states) do
    local name = v.upper .. "_" .. string.upper(s.name)
    if s.kind == "attitude" then
      first = first or name
      v.guard_norm = true
      local scalar = name == first -- |q|^2 = 1/4, from (1/2, 0, 0, 0), and 4, from (-1, 1, 1, 1)
      v.guard_rows[i] = { low = scalar and v.half or v.zero, high = (scalar and "-" or "") .. v.one, answer = first,
        below = scalar and number.text(R.new(7, 16), real) or "-" .. v.two, above = number.text(R.new(33, 16), real) }
    else
      local range = job.ranges.states[i]
      local row = { name = name, range = range ~= nil }
      if range then
        row.low, row.high = guard.ends(range, real)
        row.below = number.text(beyond(range.lo, -1, real), real)
        row.above = number.text(beyond(range.hi, 1, real), real)
        v.guard_about[#v.guard_about + 1] = s.name .. " from " .. plain(range.lo) .. " to " .. plain(range.hi) ..
          (s.unit == "1" and "" or " " .. s.unit)
      else
        row.low, row.high, row.below, row.above = v.zero, v.zero, "-" .. v.huge, v.huge
        v.guard_about[#v.guard_about + 1] = s.name .. " any finite number"
      end
      v.guard_states[#v.guard_states + 1] = row
      v.guard_rows[i] = { low = row.low, high = row.high, below = row.below, above = row.above, answer = name }
    end
  end
  v.guard_attitude = first or ""
  for i, row in ipairs(v.guard_rows) do row.tail = i < #v.guard_rows and "," or "" end
  local function render(name) return template.render(name, job.templates[name], v) end
  v.guard_header, v.guard_source = render "templates/core/guard.h", render "templates/core/guard.c"
end

return guard
