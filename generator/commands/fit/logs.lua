-- logs.lua -- the files of --data, their columns found by name and unit.
--
--     logs.read(host, outputs, inputs, paths) -> list of {path, log, rows, counts, unused, sigmas, inputs}; or nil
--                                     and a message
--         log: of host.csv; counts: values of each column; unused: names of columns that no output takes; sigmas: of
--         each column in SI units, false where the file has none; inputs: name of an input -> its column, where the
--         file has one (commands/driven.lua); odd: sentences, taken: of each column, how its values are taken
--     logs.columns(outputs)           the columns in the order of the outputs: {name, dim, output}
-- A comment `# sigma:` of a file has standard deviations of its columns in their units.
-- SPDX-License-Identifier: GPL-3.0-or-later

local csv = require "generator.commands.csv"
local diag = require "generator.diag"
local units = require "generator.dsl.units"

local logs = {}

local MOST_BEFORE, MOST = 1e6, 1e8 -- distances of rows before the first row, and in all

function logs.columns(outputs)
  local list = {}
  for _, o in ipairs(outputs) do
    for i, name in ipairs(o.columns) do list[#list + 1] = { name = name, dim = o.dims[i], output = o } end
  end
  return list
end

-- The standard deviation of a column in SI units, false where the file has none; or nil and what is wrong.
local function sigma_of(column, text, factor)
  if not text or text == "" or text == "-" then return false end
  local x = tonumber(text)
  if not x or x ~= x or x <= 0 or x == math.huge then
    return nil, "sigma of column " .. column.name .. " must be a positive number, got " .. diag.show(text)
  elseif not column.output.e then
    return nil, "sigma of column " .. column.name .. ": the scene says it of an attitude, as a small turn in rad"
  end
  return x * factor
end

-- What is odd in the columns: sentences with file and line; and of each column {wrapped = bool, low, high, turn = are
-- its values within a turn}, how its values are to be taken.
local function oddities(host, log, path, columns)
  local list, taken = {}, {}
  for i, o in ipairs(host.odd(log)) do
    local c = columns[i]
    local at = o.kind and path .. ":" .. diag.show(o.line) .. ": column " .. c.name .. " "
    local value, rows = diag.show(o.value), diag.show(o.rows)
    taken[i] = { turn = o.turn }
    if o.kind == "constant" and c.output and c.output.e then
      list[#list + 1] = at .. "has the same value in all " .. rows .. " rows, " .. value .. ": is the sensor on?"
    elseif o.kind == "limit" and c.output then
      list[#list + 1] = at .. "stays at its extreme value " .. value .. " for " .. rows .. " rows: a sensor at its " ..
        "limit; such values say only that the model must not be inside it"
      taken[i].low, taken[i].high = o.low, o.high
    elseif o.kind == "wrapped" and units.equal(c.dim, units.none) and c.output and c.output.e then
      list[#list + 1] = at .. "jumps by " .. value .. ", a turn: the angle is wrapped; the shorter way round to the " ..
        "model is taken"
      taken[i].wrapped = true
    end
  end
  return list, taken
end

-- The standard deviations that the file states of its columns; or nil and what is wrong.
local function sigmas_of(f, measured, factors)
  local list = {}
  for i, c in ipairs(measured) do
    local sigma, why = sigma_of(c, f.sigmas[f.at[c.name]], factors[i])
    if why then return f:wrong(why) end
    list[i] = sigma
  end
  return list
end

local function one(host, measured, inputs, path)
  local f, why = csv.open(host, path)
  if not f then return nil, why end
  local columns, driven, taken, unused = table.move(measured, 1, #measured, 1, {}), {}, { t = true }, {}
  for _, c in ipairs(inputs) do
    if f.at[c.name] then
      columns[#columns + 1] = c
      driven[c.name] = #columns
    end
  end
  for _, c in ipairs(columns) do taken[c.name] = true end
  for _, name in ipairs(f.names) do unused[#unused + 1] = not taken[name] and name or nil end
  local rows, counts, factors = f:read(columns, true, 2)
  if not rows then return nil, counts end
  local sigmas
  sigmas, why = sigmas_of(f, measured, factors)
  if not sigmas then return nil, why end
  local log = f.object
  local spacing, first, last, line = log:spacing()
  if first < 0 then
    return nil, path .. ":" .. diag.show(line) .. ": times must not be negative (the motion begins at t = 0), got " ..
      diag.show(first) .. " s"
  elseif first > MOST_BEFORE * spacing or last > MOST * spacing then -- of a clock that began long before
    return nil, path .. ": the rows are " .. diag.show(spacing) .. " s apart and go from t = " .. diag.show(first) ..
      " s to " .. diag.show(last) .. " s, too many steps from the beginning of the motion at t = 0 (subtract the " ..
      "time of its beginning)"
  end
  for i, c in ipairs(measured) do
    local begins = i == 1 or c.output ~= measured[i - 1].output
    local bad = begins and not c.output.e and log:zero(i, #c.output.columns)
    if bad then
      return nil, path .. ":" .. diag.show(bad) .. ": " .. c.output.name .. " is 0, 0, 0, 0, which is no attitude " ..
        "(leave the cells empty where the sensor has none)"
    end
  end
  for i = #counts, #measured + 1, -1 do counts[i] = nil end -- an input is no value that is fitted
  local odd, how = oddities(host, log, path, columns)
  return { path = path, log = log, rows = rows, counts = counts, unused = unused, sigmas = sigmas, inputs = driven,
    odd = odd, taken = how }
end

-- A sensor that loses the turns of an angle in one log does so in all, if no jump of them shows it or not.
local function alike(list, columns)
  for i in ipairs(columns) do
    local wrapped = false
    for _, d in ipairs(list) do wrapped = wrapped or d.taken[i].wrapped end
    for _, d in ipairs(list) do
      if wrapped and d.taken[i].turn then d.taken[i] = { wrapped = true } end
    end
  end
end

function logs.read(host, outputs, inputs, paths)
  local list, columns = {}, logs.columns(outputs)
  for i, path in ipairs(paths) do
    local made, why = one(host, columns, inputs, path)
    if not made then return nil, why end
    list[i] = made
  end
  alike(list, columns)
  return list
end

return logs
