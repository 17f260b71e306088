-- events.lua -- the key `events` of a scene: zero crossings that `polhode run` looks for.
--
--     events = { { name = "upright", when = 1 - 2*(qx*qx + qy*qy), direction = 1, stop = true }, ... }
-- when: an expression of t, the states and the words of dsl/watched.lua; direction: 1 for upward crossings, -1 for
-- downward ones, 0 (the default) for both; stop: the run ends there.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local args = require "generator.dsl.args"
local names = require "generator.dsl.names"
local value = require "generator.dsl.value"
local watched = require "generator.dsl.watched"
local diag = require "generator.diag"

local events = {}

local keys = { { name = "name" }, { name = "when" }, { name = "direction" }, { name = "stop" } }

-- One event, or nil after an error; seen: names so far.
local function read(ctx, at, i, e, seen)
  local what = "events[" .. i .. "]"
  if not args.plain(e) then
    ctx.diag:error(at, what, "must be a table {name =, when =, direction =, stop =}", diag.show(e))
    return nil
  end
  args.unknown(ctx, at, what, keys, e)
  local out = { name = e.name, direction = 0, stop = false, line = at }
  local rule = names.identifier(e.name)
  if rule or seen[e.name] then
    ctx.diag:error(at, what, "name " .. (rule or "is given twice"), diag.show(e.name))
    return nil
  end
  seen[e.name] = true
  local r, why = value.of(e.when)
  if not r or motion.free(r.e) then
    ctx.diag:error(at, what, "when " .. (why or "must depend on t or on states"),
      r and value.show(e.when) or diag.show(e.when))
    return nil
  end
  for _, s in ipairs(expr.symbols(r.e)) do
    if string.find(s.name, "^u_") and s.rank == motion.rank then
      ctx.diag:error(at, what, "when must not depend on an input", value.show(e.when))
      return nil
    end
  end
  out.when = watched.plain(ctx, r.e)
  if e.direction ~= nil then
    if e.direction ~= 1 and e.direction ~= -1 and e.direction ~= 0 then
      ctx.diag:error(at, what, "direction must be 1, -1 or 0", diag.show(e.direction))
    else
      out.direction = e.direction
    end
  end
  if e.stop ~= nil then out.stop = args.flag(ctx, at, what, "stop", nil, e.stop) or false end
  return out
end

-- The list of events {name, when = expression, direction, stop, line}.
function events.read(ctx, line, given)
  if given == nil then return {} end
  local at, list, seen = ctx.diag:locate(line, "events"), {}, {}
  if not args.plain(given) or not args.list(given, #given) then
    ctx.diag:error(at, "events", "must be a list of tables {name =, when =, direction =, stop =}", diag.show(given))
    return list
  end
  for i = 1, #given do list[#list + 1] = read(ctx, at, i, given[i], seen) end
  return list
end

return events
