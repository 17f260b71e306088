-- guard.lua -- NAME_within: is a state within the ranges that the scene declares?  Emitted where it declares any.
--
-- The attitude is held by its norm alone: an angle of `ranges` says where motions start, not how far they turn.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local template = require "generator.emit.template"

local GROUP = template.group("core/guard.h", "core/guard.c")

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

-- nil without ranges, else {header, source, rows = what the self-test tries of each state}.
-- A row has the ends, which must pass, and numbers just beyond them, which must not.
function guard.of(job, base)
  if not job.ranges then return nil end
  local real, first, rows = job.real, nil, {}
  local v = { norm = false, states = {}, about = {}, least = number.text(guard.least, real),
    most = number.text(guard.most, real), component = number.text(guard.component, real) }
  for i, s in ipairs(job.states) do
    local name = base.upper .. "_" .. string.upper(s.name)
    if s.kind == "attitude" then
      first = first or name
      v.norm = true
      local scalar = name == first -- |q|^2 = 1/4, from (1/2, 0, 0, 0), and 4, from (-1, 1, 1, 1)
      rows[i] = { low = scalar and base.half or base.zero, high = (scalar and "-" or "") .. base.one, answer = first,
        below = scalar and number.text(R.new(7, 16), real) or "-" .. base.two,
        above = number.text(R.new(33, 16), real) }
    else
      local range = job.ranges.states[i]
      local row = { name = name, range = range ~= nil }
      if range then
        row.low, row.high = guard.ends(range, real)
        row.below = number.text(beyond(range.lo, -1, real), real)
        row.above = number.text(beyond(range.hi, 1, real), real)
        v.about[#v.about + 1] = s.name .. " from " .. plain(range.lo) .. " to " .. plain(range.hi) ..
          (s.unit == "1" and "" or " " .. s.unit)
      else
        row.low, row.high, row.below, row.above = base.zero, base.zero, "-infinite", "infinite" -- as the test has it
        v.about[#v.about + 1] = s.name .. " any finite number"
      end
      v.states[#v.states + 1] = row
      rows[i] = { low = row.low, high = row.high, below = row.below, above = row.above, answer = name }
    end
  end
  for i, row in ipairs(rows) do row.tail = i < #rows and "," or "" end
  local render = GROUP(job.templates, base, v)
  return { header = render "core/guard.h", source = render "core/guard.c", rows = rows }
end

return guard
