-- driven.lua -- the inputs of a scene over time: columns of files, the same for every command.
--
--     driven.columns(model)       the inputs as columns (csv.lua)
--     driven.wrong(model, given)  what is wrong with --input and --between, or nil
--     driven.files(host, model, paths) -> {{path, log, inputs = name -> column}, ...}, or nil and a message
--     driven.each(host, model, logs, files, given) -> of each log the course of host.course, notes; or nil, a message
--     driven.one(host, job, given) -> warnings and the course (nil: all 0), or nil and a message
--     driven.names(model)         of the inputs, for who says that they are 0; nil without any
-- A column that is called as the input, with a unit or in SI's.  Between two values the input is held, or on a straight
-- line (--between linear); missing values are passed over.  Before the first value and after the last one it stays.
-- With --between linear an input NAME_rate that has no column of its own is the slope of NAME.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local csv = require "generator.commands.csv"
local diag = require "generator.diag"
local inputs = require "generator.dynamics.inputs"
local nearest = require "generator.nearest"
local units = require "generator.dsl.units"

local driven = {}

local function dim_of(s) return (select(2, units.parse(s.unit))) end

function driven.columns(m)
  local list = {}
  for i, s in ipairs(m.inputs) do list[i] = { name = s.label, dim = dim_of(s), unit = s.unit } end
  return list
end

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

-- The file, whose columns are t and inputs of the scene; or nil and what is wrong.
local function read(host, m, path)
  local f, why = csv.open(host, path)
  if not f then return nil, why end
  local columns, places, words = {}, {}, {}
  for i, c in ipairs(driven.columns(m)) do
    words[i] = c.name
    if f.at[c.name] then
      columns[#columns + 1] = c
      places[c.name] = #columns
    end
  end
  for _, name in ipairs(f.names) do
    if name ~= "t" and not places[name] then
      local near = nearest.one(name, words)
      return f:wrong("the scene has no input " .. diag.show(name) .. " (it has " .. table.concat(words, ", ") .. ")" ..
        (near and "; did you mean " .. near .. "?" or ""))
    end
  end
  local rows
  rows, why = f:read(columns, true)
  if not rows then return nil, why end
  return { path = f.path, log = f.object, inputs = places }
end

function driven.files(host, m, paths)
  local list = {}
  for i, path in ipairs(paths or {}) do
    local made, why = read(host, m, path)
    if not made then return nil, why end
    list[i] = made
  end
  return list
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

-- The course from the first of the files that has a column, notes, and the inputs that have none.
local function course(host, m, files, linear)
  local list, notes, missing = {}, {}, {}
  local function source(s, kind)
    for _, from in ipairs(s and files or {}) do
      local column = from.inputs[s.label]
      if column then return { csv = from.log, column = column, kind = kind } end
    end
  end
  for i, s in ipairs(m.inputs) do
    local made, base = source(s, linear and "linear" or "held"), slope_of(m, s)
    if not made and linear then
      made = source(base, "slope")
      notes[#notes + 1] = made and s.label .. " is the slope of " .. base.label or nil
    end
    if made then made.low, made.high = limits(m, s) else missing[#missing + 1] = { label = s.label, base = base } end
    list[i] = made or false
  end
  return host.course(list), notes, missing
end

function driven.each(host, m, data, files, given)
  if #m.inputs == 0 then return nil end
  local all, notes, linear = {}, nil, given.between == "linear"
  for n, log in ipairs(data) do
    local file = files[n] or files[1]
    local made, said, missing = course(host, m, { log, file }, linear)
    all[n], notes = made, notes or said
    local s = missing[1]
    if s then
      return nil, log.path .. ": has no column " .. s.label .. ", an input of the scene; " ..
        (file and file.path .. " has none, either" or "a file beside it may have it (--input FILE.csv)") ..
        (s.base and not linear and "; with --between linear it is the slope of " .. s.base.label or "")
    end
  end
  return all, notes
end

-- The end of a file before the motion's, as a warning, or nil; one row alone is a constant.
local function short(job, given, from)
  local _, first, last = from.log:spacing()
  local finish = given["until"]
  for _, t in ipairs(given.at or {}) do finish = math.max(finish or t, t) end
  finish = finish or job.model:double(job.model.horizon)
  if first == last or last >= finish * (1 - 1e-12) then return nil end
  return from.path .. " ends at t = " .. diag.show(last) .. " s: its last row holds to t = " .. diag.show(finish) ..
    " s\n"
end

function driven.names(m)
  local names = {}
  for i, s in ipairs(m.inputs) do names[i] = s.label end
  return #names > 0 and table.concat(names, ", ") or nil
end

function driven.one(host, job, given)
  local wrong = driven.wrong(job.model, given) or
    given.between and not given.input and "--between: it says how --input FILE.csv is read"
  if wrong then return nil, wrong end
  if not given.input then
    local names = driven.names(job.model)
    return { names and "without --input FILE.csv these inputs are 0: " .. names .. "\n" }
  end
  local files, why = driven.files(host, job.model, { given.input })
  if not files then return nil, why end
  local made, notes, missing = course(host, job.model, files, given.between == "linear")
  for _, text in ipairs(notes) do host.err("note: " .. text .. "\n") end
  local warnings = {}
  for i, s in ipairs(missing) do
    warnings[i] = files[1].path .. ": no column for the input " .. s.label .. ", which stays 0\n"
  end
  warnings[#warnings + 1] = short(job, given, files[1])
  return warnings, made
end

return driven
