-- input_file.lua -- `run --input FILE.csv`: the inputs of a scene over time, as both engines take them.
--
--     t,motor [mN m],brake
--     0,0,0
--     0.5,12,0.01
-- The first line names t and inputs of the scene, in any order, each with a unit in brackets or without: then it is
-- SI's.  Times ascend.  Between two rows the inputs are held, or on lines; before the first row and after the last
-- one they keep its values.  Empty lines and lines that begin with # are passed over.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local units = require "generator.dsl.units"
local inputs = require "generator.dynamics.inputs"
local diag = require "generator.diag"
local nearest = require "generator.nearest"

local file = {}

local most = 10000000 -- numbers in one file

local function trimmed(s) return (string.gsub(string.gsub(s, "^%s+", ""), "%s+$", "")) end

local function cells(line)
  local list = {}
  for cell in string.gmatch(line .. ",", "([^,]*),") do list[#list + 1] = trimmed(cell) end
  return list
end

-- The columns {place (0 is t), factor}, or nil and what is wrong.
local function columns(job, m, head)
  local by_name, words, list, seen = { t = { 0, units.time, "s" } }, { "t" }, {}, {}
  for i, s in ipairs(m.inputs) do
    by_name[s.label], words[#words + 1] = { i, select(2, units.parse(s.unit)), s.unit }, s.label
  end
  for k, cell in ipairs(head) do
    local name, unit = string.match(cell, "^([%w_]+)%s*%[([^%]]*)%]$")
    name = name or cell
    local known = by_name[name]
    if not known then
      local near = nearest.one(name, words)
      return nil, "the scene has no input " .. diag.show(name) .. (near and ", did you mean " .. near or "") ..
        " (it has " .. table.concat(words, ", ", 2) .. ")"
    elseif seen[name] then
      return nil, "two columns are called " .. name
    end
    seen[name] = true
    local factor = R.one
    if unit then
      local dim
      factor, dim = units.parse(unit)
      if not factor then return nil, name .. ": " .. dim end
      if not units.equal(dim, known[2]) then
        return nil, name .. " must be in " .. known[3] .. ", got [" .. unit .. "]"
      end
      factor = job.model:number(factor)
    end
    list[k] = { place = known[1], factor = R.todouble(factor) }
  end
  if not seen.t then return nil, "the first line must name t, the time" end
  local missing = {}
  for _, s in ipairs(m.inputs) do
    if not seen[s.label] then missing[#missing + 1] = s.label end
  end
  return list, nil, missing
end

-- Where a line crosses a limit of its input it has a corner: a row of its own there.  rows: lists {t, u1, u2, ..}.
local function cornered(m, rows)
  local out = {}
  for r, row in ipairs(rows) do
    local last, times = rows[r - 1], {}
    for i, s in ipairs(last and m.inputs or {}) do
      local low, high = inputs.range(m, s)
      local from, to = last[i + 1], row[i + 1]
      for _, limit in ipairs(low and { R.todouble(low), R.todouble(high) } or {}) do
        if (from - limit) * (to - limit) < 0 then
          times[#times + 1] = last[1] + (limit - from) / (to - from) * (row[1] - last[1])
        end
      end
    end
    table.sort(times)
    for _, t in ipairs(times) do
      if t > out[#out][1] and t < row[1] then
        local corner, part = { t }, (t - last[1]) / (row[1] - last[1])
        for i = 2, #row do corner[i] = last[i] + part * (row[i] - last[i]) end
        out[#out + 1] = corner
      end
    end
    out[#out + 1] = row
  end
  return out
end

-- The course {rows = {t, u1, .., t, ..}, linear =} of the text, and a list of warnings; or nil and what is wrong,
-- with the file's line.
function file.read(job, path, text, linear)
  local m, list, head, missing, n = job.model, {}, nil, nil, 0
  local function wrong(what) return nil, path .. ":" .. n .. ": " .. what end
  if #m.inputs == 0 then return nil, "--input: the scene has no inputs (effect.control, or input(name, unit))" end
  for line in string.gmatch(string.gsub(string.gsub(text, "^\239\187\191", ""), "\r\n?", "\n"), "([^\n]*)\n?") do
    n = n + 1
    if string.find(line, "%S") and not string.find(line, "^%s*#") then
      local row = cells(line)
      if not head then
        local why
        head, why, missing = columns(job, m, row)
        if not head then return wrong(why) end
      else
        if #row ~= #head then return wrong(#head .. " numbers expected, got " .. #row) end
        local made = {}
        for i = 0, #m.inputs do made[i + 1] = 0.0 end
        for k, cell in ipairs(row) do
          local x = tonumber(cell)
          if not x or x - x ~= 0 then return wrong("must be a number, got " .. diag.show(cell)) end
          made[head[k].place + 1] = x * head[k].factor
        end
        local before = list[#list]
        if before and made[1] <= before[1] then
          return wrong("times must ascend, got " .. diag.show(made[1]) .. " after " .. diag.show(before[1]))
        end
        list[#list + 1] = made
        if #list * #made > most then return wrong("at most " .. most .. " numbers") end
      end
    end
  end
  if #list == 0 then return nil, path .. ": must have a first line of names and a row" end
  if linear then list = cornered(m, list) end
  local flat, warnings = {}, {}
  for _, row in ipairs(list) do table.move(row, 1, #row, #flat + 1, flat) end
  for i, name in ipairs(missing) do
    warnings[i] = path .. ": no column for the input " .. name .. ", which stays 0\n"
  end
  return { rows = flat, linear = linear or false }, warnings
end

-- The end of a file before the motion's, as a warning, or nil; one row alone is a constant.
local function short(job, given, course)
  local width = #job.model.inputs + 1
  local last, finish = course.rows[#course.rows - width + 1], given["until"]
  for _, t in ipairs(given.at or {}) do finish = math.max(finish or t, t) end
  finish = finish or job.model:double(job.model.horizon)
  if #course.rows == width or last >= finish * (1 - 1e-12) then return nil end
  return given.input .. " ends at t = " .. diag.show(last) .. " s: its last row holds to t = " .. diag.show(finish) ..
    " s\n"
end

-- The names of a scene's inputs, for who says that they are 0; nil without any.
function file.names(job)
  local names = {}
  for i, u in ipairs(job.model.inputs) do names[i] = u.label end
  return #names > 0 and table.concat(names, ", ") or nil
end

-- The inputs over time that a command line names: warnings and these (nil: all 0), or nil and what is wrong.
function file.of(host, job, given)
  if not given.input then
    if given.between then return nil, "--between: it says how --input FILE.csv is read" end
    local names = file.names(job)
    return { names and "without --input FILE.csv these inputs are 0: " .. names .. "\n" }
  end
  local text, why = host.read(given.input)
  if not text then return nil, why end
  local course, said = file.read(job, given.input, text, given.between == "linear")
  if not course then return nil, said end
  said[#said + 1] = short(job, given, course)
  return said, course
end

return file
