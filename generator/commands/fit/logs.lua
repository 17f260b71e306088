-- logs.lua -- the files of --data, their columns found by name and unit.
--
--     logs.read(host, outputs, inputs, paths) -> list of {path, log, rows, counts, unused, sigmas, inputs}; or nil
--                                     and a message
--         log: of host.log; counts: values of each column; unused: names of columns that no output takes; sigmas: of
--         each column in SI units, false where the file has none; inputs: name of an input -> its column, where the
--         file has one (commands/fit/driven.lua); odd: sentences, taken: of each column, how its values are taken;
--         the same without outputs: files of inputs alone
--     logs.columns(outputs)           the columns in the order of the outputs: {name, dim, output}
-- Columns have their unit in brackets behind the name or in a comment `# units:`; without one, SI's.  A comment
-- `# sigma:` has standard deviations in these units.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local units = require "generator.dsl.units"
local diag = require "generator.diag"
local nearest = require "generator.nearest"

local logs = {}

local MOST_BEFORE, MOST = 1e6, 1e8 -- distances of rows before the first row, and in all

function logs.columns(outputs)
  local list = {}
  for _, o in ipairs(outputs) do
    for i, name in ipairs(o.columns) do list[#list + 1] = { name = name, dim = o.dims[i], output = o } end
  end
  return list
end

-- The factor to SI units of a column called `name`, whose dimension must be dim; or nil and what is wrong.
local function factor_of(name, unit, dim)
  if not unit or unit == "" then return 1.0 end
  local factor, own = units.parse(unit)
  if not factor then return nil, "column " .. name .. ": " .. own end
  if not units.equal(own, dim) then
    return nil, "column " .. name .. " must be in " .. units.si(dim) .. ", got [" .. unit .. "]"
  end
  return R.todouble(evaluate.precise(factor, {}, 80))
end

-- Where each name of the head stands, and its unit; or nil and what is wrong.
local function places(names, given)
  local at, all = {}, {}
  for i, cell in ipairs(names) do
    local name, unit = string.match(cell, "^(.-)%s*%[([^%]]*)%]$")
    name, unit = name or cell, unit or given[i]
    if name == "" then return nil, "column " .. i .. " has no name" end
    if at[name] then return nil, "two columns are called " .. name end
    at[name], all[i] = { i, unit }, name
  end
  return at, all
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

-- The columns of the list that the file has.
local function present(list, names)
  local has, some = {}, {}
  for _, cell in ipairs(names) do has[string.match(cell, "^(.-)%s*%[[^%]]*%]$") or cell] = true end
  for _, c in ipairs(list) do some[#some + 1] = has[c.name] and c or nil end
  return some
end

local function wanted(columns, names, given, noise)
  local at, all = places(names, given)
  if not at then return nil, all end
  local list, sigmas, taken = {}, {}, { t = true }
  for i, c in ipairs { { name = "t", dim = units.time }, table.unpack(columns) } do
    local place = at[c.name]
    if not place then
      local best = nearest.one(c.name, all)
      return nil, "has no column " .. c.name .. (c.name == "t" and ", the time" or ", which the scene measures") ..
        " (it has " .. table.concat(all, ", ") .. ")" .. (best and "; did you mean " .. best .. "?" or "")
    end
    local factor, why = factor_of(c.name, place[2], c.dim)
    local sigma
    if factor and i > 1 and c.output then sigma, why = sigma_of(c, noise[place[1]], factor) end
    if why then return nil, why end
    sigmas[i - 1] = sigma
    list[i], taken[c.name] = { place[1], factor }, true
  end
  local unused = {}
  for _, name in ipairs(all) do unused[#unused + 1] = not taken[name] and name or nil end
  return list, unused, sigmas
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

local function one(host, measured, inputs, path)
  local log = host.log(path)
  local names, given, noise, line = log:head()
  if not names then return nil, given end
  if #given > 0 and #given ~= #names then
    return nil, path .. ":" .. diag.show(line) .. ": " .. #names .. " names, but " .. #given .. " units above them"
  end
  if #noise > 0 and #noise ~= #names then
    return nil, path .. ":" .. diag.show(line) .. ": " .. #names .. " names, but " .. #noise .. " sigmas above them"
  end
  local columns, driven = table.move(measured, 1, #measured, 1, {}), {}
  for i, c in ipairs(present(inputs, names)) do columns[#measured + i], driven[c.name] = c, #measured + i end
  if #columns == 0 then
    local words = {}
    for i, c in ipairs(inputs) do words[i] = c.name end
    return nil, path .. ":" .. diag.show(line) .. ": has no column of an input (" .. table.concat(words, ", ") .. ")"
  end
  local list, unused, sigmas = wanted(columns, names, given, noise)
  if not list then return nil, path .. ":" .. diag.show(line) .. ": " .. unused end
  local rows, counts = log:read(list)
  if not rows then return nil, counts end
  if rows < 2 then return nil, path .. ": must have two rows or more, got " .. diag.show(rows) end
  local spacing, first, last = log:spacing()
  if first > MOST_BEFORE * spacing or last > MOST * spacing then -- of a clock that began long before
    return nil, path .. ": the rows are " .. diag.show(spacing) .. " s apart and go from t = " .. diag.show(first) ..
      " s to " .. diag.show(last) .. " s, too many steps from the beginning of the motion at t = 0 (subtract the " ..
      "time of its beginning)"
  end
  for i, c in ipairs(columns) do
    if counts[i] == 0 then return nil, path .. ": column " .. c.name .. " has no value" end
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
  local odd, taken = oddities(host, log, path, columns)
  return { path = path, log = log, rows = rows, counts = counts, unused = unused, sigmas = sigmas, inputs = driven,
    odd = odd, taken = taken }
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
