-- driven.lua -- where the inputs of a scene come from in a fit: columns of the log itself, or of a file beside it.
--
--     driven.columns(model)       the inputs as columns: {name, dim}
--     driven.files(host, model, given) -> logs of --input, or nil and a message
--     driven.of(model, logs, files, given) -> of each log the list for src/cli/fit/fit.c, and notes; or nil, message
-- A column that is called as the input, with a unit or in SI's.  Between two values the input is held, or on a straight
-- line (--between linear); missing values are passed over.  Before the first value and after the last one it stays.
-- With --between linear an input NAME_rate that has no column of its own is the slope of NAME.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local inputs = require "generator.dynamics.inputs"
local logs = require "generator.commands.fit.logs"
local units = require "generator.dsl.units"

local driven = {}

local function dim_of(s) return (select(2, units.parse(s.unit))) end

function driven.columns(m)
  local list = {}
  for i, s in ipairs(m.inputs) do list[i] = { name = s.label, dim = dim_of(s) } end
  return list
end

-- What the command line says of inputs and the scene does not take, or nil.
function driven.wrong(m, given)
  if given.input and #m.inputs == 0 then
    return "--input: the scene has no inputs (effect.control, or input(name, unit))"
  elseif given.between and #m.inputs == 0 then
    return "--between: the scene has no inputs"
  elseif given.input and given.data and #given.input ~= 1 and #given.input ~= #given.data then
    return "--input must be given once, or once for each --data"
  end
  return nil
end

function driven.files(host, m, given)
  if not given.input then return {} end
  return logs.read(host, {}, driven.columns(m), given.input)
end

-- The input whose slope `s` is: the one called so without _rate, of the right dimension; or nil.
local function slope_of(m, s)
  local base = string.match(s.label, "^(.+)_rate$")
  for _, other in ipairs(m.inputs) do
    if other.label == base and units.equal(units.times(dim_of(s), units.time), dim_of(other)) then return other end
  end
  return nil
end

local function limits(m, s)
  local low, high = inputs.range(m, s)
  return low and R.todouble(low) or 0 / 0, high and R.todouble(high) or 0 / 0
end

function driven.of(m, data, files, given)
  if #m.inputs == 0 then return nil end
  local linear, all, notes = given.between == "linear", {}, {}
  for n, log in ipairs(data) do
    local file = files[n] or files[1]
    local function source(s)
      for _, from in ipairs { log, file } do
        local column = from.inputs[s.label]
        if column then return { log = from.log, column = column + 0.0, kind = linear and "linear" or "held" } end
      end
    end
    all[n] = {}
    for i, s in ipairs(m.inputs) do
      local made, base = source(s), slope_of(m, s)
      if not made and base and linear then
        made = source(base)
        if made then
          made.kind = "slope"
          if n == 1 then notes[#notes + 1] = s.label .. " is the slope of " .. base.label end
        end
      end
      if not made then
        return nil, log.path .. ": has no column " .. s.label .. ", an input of the scene; " ..
          (file and file.path .. " has none, either" or "a file beside it may have it (--input FILE.csv)") ..
          (base and not linear and "; with --between linear it is the slope of " .. base.label or "")
      end
      made.low, made.high = limits(m, s)
      all[n][i] = made
    end
  end
  return all, notes
end

return driven
