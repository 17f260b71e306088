-- watched.lua -- words that events of a scene know beside t and the states: quantities of the motion, and states that
-- effects bring along.
--
--     watched.new(ctx, list) -> f(name), the value of such a word; nil: there is none of that name
-- Which of them a scene has is known when it has been read, so `polhode run` says which word is missing.  Elsewhere in
-- a scene these are unknown names, which `watched.idle` reports: an argument that has one says nothing of it.
-- Within a scene the symbol of a word has a mark before its name, which no other symbol has.
-- SPDX-License-Identifier: GPL-3.0-or-later

local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"

local watched = {}

local pattern = "^" .. value.watched .. "(.*)$"

-- States of effects, with the units of their numbers, and the energy.  A second wheel's is wheel_2, and so on.
watched.states = { { "energy", "J", "energy" },
  { "p1", "m", "centre of mass along the axis e1 of a plane" }, { "p2", "m", "centre of mass along its axis e2" },
  { "v1", "m/s", "velocity of the centre of mass along e1" }, { "v2", "m/s", "velocity along e2" },
  { "wheel", "rad/s", "speed of a wheel relative to the body" }, { "anomaly", "rad", "true anomaly of an orbit" },
  { "clock", "s", "time of moving parts" } }

-- The unit of the word, or nil.
local function unit_of(ctx, list, name)
  for _, words in ipairs { watched.states, list } do
    for _, w in ipairs(words) do
      if w[1] == name or w[1] == "wheel" and string.find(name, "^wheel_%d+$") then return w[2] end
    end
  end
  return ctx.own_states and ctx.own_states[name] -- of effect.custom
end

-- list: quantities, {name, unit, ...} each.
function watched.new(ctx, list)
  ctx.watched = {}
  return function(name, line)
    local unit = unit_of(ctx, list, name)
    if not unit then return nil end
    ctx.watched[#ctx.watched + 1] = { name = name, line = line }
    local _, dim = units.parse(unit)
    return value.new(motion.sym(value.watched .. name), dim, "bare")
  end
end

-- The expression with these words by their own names, which are noted as taken.
function watched.plain(ctx, e)
  local map = {}
  for _, s in ipairs(expr.symbols(e)) do
    local name = string.match(s.name, pattern)
    if name then
      map[s] = motion.sym(name)
      for _, w in ipairs(ctx.watched) do w.taken = w.taken or w.name == name end
    end
  end
  return next(map) and calculus.substitute(e, map) or e
end

-- The words that the scene wrote and no event took: reported as what they are elsewhere, unknown names.
function watched.idle(ctx)
  for _, w in ipairs(ctx.watched or {}) do
    if not w.taken then
      ctx.diag:error(w.line, "script", string.format("unknown name %q (%s is a word of `when` of events alone)",
        w.name, w.name))
    end
  end
end

return watched
