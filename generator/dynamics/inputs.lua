-- inputs.lua -- the inputs u[] of a scene, in their order: ux, uy, uz of effect.control, then those that it names.
--
-- An entry is {name (of the symbol, also the C local), label (the scene's word), index (what its enumerator ends in),
-- sym, value (what stands in expressions: the symbol, within its limits where it has some), about, unit, low, high
-- (expressions, or nil), line}.  Inputs are held during a step.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local state = require "generator.dynamics.state"

local inputs = {}

-- Does x, an expression or a table with expressions somewhere in it, depend on the symbol of that name?
local function mentions(x, name)
  if expr.is(x) then return not expr.constant(x, { [name] = true }) end
  if type(x) ~= "table" then return false end
  for k, v in pairs(x) do -- in any order: it does or it does not
    if k ~= "spec" and mentions(v, name) then return true end
  end
  return false
end

-- Those of effect.control: the widest limit counts where there are two.
local function control(record)
  local first, limit
  for _, e in ipairs(record.effects) do
    if e.spec.input then
      first = first or e
      limit = e.a.max and (limit or e == first and e.a.max) or nil
    end
  end
  local list = {}
  for i, s in ipairs(first and state.inputs or {}) do
    list[i] = { name = s.name, label = s.name, index = s.index, sym = s.sym, about = s.about, unit = s.unit,
      value = limit and expr.call("clamp", s.sym, -limit, limit) or s.sym, low = limit and -limit, high = limit,
      line = first.line }
  end
  return list
end

-- The inputs of the record; one that no effect uses is pointed out: it stays, for callers count on the places in u[].
function inputs.of(d, record)
  local list = control(record)
  for _, s in ipairs(record.inputs or {}) do
    list[#list + 1] = { name = s.symbol.name, label = s.name, index = string.upper(s.name), sym = s.symbol, value = s.e,
      about = s.name, unit = s.unit, own = s.own, factor = s.factor, low = s.low, high = s.high, line = s.line }
    if d and not mentions(record.effects, s.symbol.name) then
      d:warn(s.line, "input", s.name .. " is used by no effect: it does nothing")
    end
  end
  return list
end

-- Constants that limits become are called by their input, or by all that share one: expression -> {name, about}.
function inputs.limits(list)
  local map, order = {}, {}
  local function put(s, word, e)
    local limit = map[e]
    if not limit then
      limit = { name = s.label .. "_" .. word, word = word .. " of the input ", labels = {}, unit = s.unit }
      map[e], order[#order + 1] = limit, limit
    end
    local last = limit.labels[#limit.labels]
    if last and last ~= s.label then limit.name, limit.word = "limit", "limit of the inputs " end
    if last ~= s.label then limit.labels[#limit.labels + 1] = s.label end
  end
  for _, s in ipairs(list) do
    if s.low and s.label == s.about then -- that of effect.control is the effect's
      put(s, "min", s.low)
      put(s, "max", s.high)
    end
  end
  for _, limit in ipairs(order) do
    limit.about = limit.word .. table.concat(limit.labels, ", ") .. ", " .. limit.unit
  end
  return map
end

-- Low and high of the input as rationals at the parameters' defaults, or nil.
function inputs.range(m, s)
  if not s.low then return nil end
  return m:number(s.low), m:number(s.high)
end

-- A value of input number i for tests: i/4 without limits, else from 7/20 to 1/2 of the way between them.
function inputs.sample(m, s, i)
  local low, high = inputs.range(m, s)
  if not low then return R.new(i, 4) end
  return low + (high - low) * R.new(5 + 2 * i, 16 + 4 * i)
end

return inputs
