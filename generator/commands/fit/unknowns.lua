-- unknowns.lua -- what a fit looks for: names, units, places.
--
--     unknowns.free(job, words) -> {params = list, initial = bool} | nil, message
--     unknowns.initial(states)  -> how many numbers the initial state of the followed states has
--     unknowns.sizes(m, free)   -> of each free parameter the size of a large change, in SI units: the largest value
--                               that the scene has in its unit, or 1 where all of these are 0
--     unknowns.list(fit, free, logs) -> list of {name, unit, factor (SI units in one of `unit`), kind = "param" |
--                               "initial" | "turn", param, log = number}, as the result has them
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local options = require "generator.commands.options"

local unknowns = {}

function unknowns.free(job, words)
  local by_name, names = {}, { "initial" }
  for i, p in ipairs(job.model.params) do by_name[p.name], names[i + 1] = { p, i }, p.name end
  local free = { params = {}, places = {}, initial = false }
  local wrong = options.unknown("--free", words, names)
  if wrong then return nil, wrong end
  for _, word in ipairs(words) do
    local found = by_name[word]
    if found then
      free.params[#free.params + 1], free.places[#free.places + 1] = found[1], found[2]
    else
      free.initial = true
    end
  end
  return free
end

function unknowns.initial(states)
  local n = #states
  for _, s in ipairs(states) do n = n - (s.name == "qw" and 1 or 0) end
  return n
end

function unknowns.sizes(m, free)
  local most, list = {}, {}
  local function seen(unit, x) most[unit] = math.max(most[unit] or 0, math.abs(x)) end
  for _, p in ipairs(m.params) do seen(p.unit, R.todouble(p.default)) end
  for _, s in ipairs(m.states) do seen(s.unit, m:double(s.initial)) end
  for i, p in ipairs(free.params) do list[i] = most[p.unit] > 0 and most[p.unit] or 1.0 end
  return list
end

local function param(p)
  local factor = R.todouble(evaluate.precise(p.factor or expr.one, {}, 80))
  return { name = p.name, unit = p.own or p.unit, factor = factor, kind = "param", param = p }
end

function unknowns.list(fit, free, logs)
  local list = {}
  for i, p in ipairs(free.params) do list[i] = param(p) end
  if not free.initial then return list end
  for n, log in ipairs(logs) do
    local of = #logs > 1 and " of " .. string.match(log.path, "[^/]*$") or ""
    local function put(name, unit, kind)
      list[#list + 1] = { name = name .. of, unit = unit, factor = 1.0, kind = kind, log = n }
    end
    for _, s in ipairs(fit.states) do
      if s.name == "qw" then
        for i = 1, 3 do put("turn_" .. string.sub("xyz", i, i), "rad", "turn") end
      elseif not string.find(s.name, "^q[xyz]$") then
        put(s.name .. "(0)", s.unit, "initial")
      end
    end
  end
  return list
end

return unknowns
