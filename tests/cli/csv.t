#!/usr/bin/env lua5.4
-- csv.t - every command that reads a CSV file takes the same files and refuses the same files with the same words.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A table, door x file.  Oracle of a file that is taken: the output of the plain file, byte for byte, as what was done
-- to it changes no number.  Oracle of one that is refused: status 2, nothing on standard output, and the message that
-- stands here once for all doors.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = os.getenv "PWD" .. "/" .. binary end
local dir = program.directory()

program.write(dir .. "/s.lua", [[
local push, w3 = input("push", "N m"), param("w3", 0.3, "rad/s")
return scene { name = "s", body = tensor { mass = 1, xx = 1.5, yy = 1.75, zz = 2 },
  effects = { effect.torque { body = { 0, 0, push } } }, initial = { omega = { 0, 0, w3 } },
  time = { horizon = 2, step = 0.01 }, measure = { wz = wz, sigma = 0.5 } }
]])
program.write(dir .. "/free.lua", [[
return scene { name = "free", body = tensor { mass = 1, xx = 1.5, yy = 1.75, zz = 2 }, outputs = { "rates" },
  initial = { omega = { 0, 0.1, 1 } }, time = { horizon = 2, step = 0.01 } }
]])
program.write(dir .. "/top.lua", [[
local w3 = param("w3", 1.3, "rad/s")
return scene { name = "top", body = tensor { mass = 1, xx = 2, yy = 2, zz = 3 },
  initial = { omega = { 0, 0, w3 } }, measure = { wz = wz, sigma = 0.5 } }
]])
program.write(dir .. "/log.csv", "t,wz\n0,0.3\n0.5,0.5\n1,0.8\n1.5,1.2\n")

-- ---- the doors ----

-- value: the column of numbers; timed: t is one, too; only: no other column is allowed; needed: no value may be
-- missing; least: rows; counts: a value fewer changes what is said.  The value of the second row is that of the first:
-- held inputs do not change without it.
local ROWS = { { "0", "1" }, { "1", "1" }, { "2", "2" }, { "3", "2" } }
local COURSE = { value = "push", timed = true, only = true, least = "a row" }
local DOORS = {
  { "run --input", "run s.lua --input w.csv --every 0.5", COURSE },
  { "plot --input", "plot s.lua --input w.csv --what rates", COURSE },
  { "view --input", "view s.lua --trajectory --input w.csv -o -", COURSE },
  { "fit --input", "fit s.lua --data log.csv --input w.csv --free w3", COURSE },
  { "design --input", "design s.lua --input w.csv --free w3 --until 2 --rate 10", COURSE },
  { "fit --data", "fit top.lua --data w.csv --free w3", { value = "wz", timed = true, least = "two rows",
    counts = true } },
  { "plot --from", "plot --from w.csv --what energy", { value = "energy", timed = true, needed = true,
    least = "two rows" } },
  { "chart --from", "chart --from w.csv --x t --y z", { value = "z", first = "t", least = "a row", counts = true } },
  { "sweep --covariance", "sweep free.lua --sample 4 --covariance w.csv", { value = "mean", only = true, needed = true,
    first = "name", head = { "name", "mean", "wy", "wz" }, rows = { { "wy", "0.1", "0.01", "0" },
      { "wz", "1", "0", "0.04" } } } },
}

-- The file of a door as a list of lists of cells.
local function plain(door)
  local head, list = door.head or { door.first or "t", door.value }, {}
  list[1] = table.move(head, 1, #head, 1, {})
  for i, row in ipairs(door.rows or ROWS) do list[i + 1] = table.move(row, 1, #row, 1, {}) end
  return list
end

local function text_of(list, comma)
  local lines = {}
  for i, row in ipairs(list) do lines[i] = table.concat(row, comma or ",") end
  return table.concat(lines, "\n") .. "\n"
end

local function run(command, text)
  if text then program.write(dir .. "/w.csv", text) end
  local status = program.shell(string.format("cd %s && (%s %s) > out 2> err < /dev/null", dir, binary, command))
  return status, program.read(dir .. "/out"), program.read(dir .. "/err")
end

-- ---- what is done to the file ----

-- A change of cells or of the text; each gives the text, or nil where a door has no such thing.
local function cells(change)
  return function(door)
    local list = plain(door)
    for i, row in ipairs(list) do
      for k = 1, #row do row[k] = change(row[k], i, k, door) or row[k] end
    end
    return text_of(list)
  end
end
local function whole(change) return function(door) return change(text_of(plain(door))) end end
local function rows(change)
  return function(door)
    local list = plain(door)
    change(list, door)
    return text_of(list)
  end
end
-- The value of the second line of numbers.
local function value(new)
  return cells(function(_, i, k, door)
    return i == 3 and k == (door.head and 2 or #plain(door)[1]) and new or nil
  end)
end
local function timed(f) return function(door) return door.timed and f(door) or nil end end

local TAKEN = {
  { "lines that end with CR LF", whole(function(s) return (s:gsub("\n", "\r\n")) end) },
  { "lines that end with CR", whole(function(s) return (s:gsub("\n", "\r")) end) },
  { "a byte order mark", whole(function(s) return "\239\187\191" .. s end) },
  { "a last line without its end", whole(function(s) return s:sub(1, -2) end) },
  { "comments and empty lines", whole(function(s)
    return "# by hand\n\n" .. s:gsub("\n", "\n \t\n  # and, so \"on\n")
  end) },
  { "quotes", cells(function(s) return '"' .. s .. '"' end) },
  { "blanks around cells", cells(function(s) return " \t" .. s .. " " end) },
  { "numbers with exponents", value "10e-1", function(door) return not door.rows end },
  { "another column", function(door)
    local list = plain(door)
    for i, row in ipairs(list) do row[#row + 1] = i == 1 and "note" or '"so, ""and"" so"' end
    return text_of(list)
  end, function(door) return not door.only end },
  { "columns in another order", rows(function(list)
    for _, row in ipairs(list) do row[1], row[2] = row[2], row[1] end
  end), function(door) return not door.rows end },
  { "times in ms", timed(cells(function(s, i, k)
    return k == 1 and (i == 1 and "t [ms]" or s .. "000") or nil
  end)) },
  { "units in a comment", timed(function(door)
    return "# units: ms,; by hand\n" .. cells(function(s, i, k) return k == 1 and i > 1 and s .. "000" or nil end)(door)
  end) },
  { "a value that is missing", value "", function(door) return not door.needed end },
  { "a value that is not a number by name", value "NaN", function(door) return not door.needed end },
}

-- Words of a message: VALUE the column, FIRST the first one, WIDE how many, NARROW one fewer, LONG one more, LAST line.
local REFUSED = {
  { "an empty file", function() return "" end, "w.csv: has no line that names its columns" },
  { "comments alone", function() return "# nothing\n\n" end, "w.csv: has no line that names its columns" },
  { "names alone", rows(function(list) for i = #list, 2, -1 do list[i] = nil end end), function(door)
    return door.rows and "w.csv:1: must be name,mean and the names, and each name must have a row" or
      "w.csv: must have " .. door.least .. " or more, got 0"
  end },
  { "semicolons", function(door) return text_of(plain(door), ";") end,
    "w.csv:1: cells must be separated by commas, got semicolons" },
  { "tabs", function(door) return text_of(plain(door), "\t") end,
    "w.csv:1: cells must be separated by commas, got tabs" },
  { "numbers without names", function(door)
    return not door.rows and text_of(table.move(plain(door), 2, 5, 1, {})) or nil
  end, "w.csv:1: must name the columns, got numbers" },
  { "a column twice", rows(function(list, door)
    for i, row in ipairs(list) do row[#row + 1] = i == 1 and door.value or "1" end
  end), "w.csv:1: two columns are called VALUE" },
  { "a column without a name", rows(function(list)
    for i, row in ipairs(list) do row[#row + 1] = i == 1 and "" or "1" end
  end), "w.csv:1: column LONG has no name" },
  { "a row that is too short", rows(function(list) table.remove(list[3]) end),
    "w.csv:3: WIDE cells expected, got NARROW" },
  { "a row that is too long", rows(function(list) table.insert(list[3], "1") end),
    "w.csv:3: WIDE cells expected, got LONG" },
  { "a comma too many", whole(function(s) return (s:gsub("\n", ",\n")) end), "w.csv:1: column LONG has no name" },
  { "a last line that is cut", function(door)
    return (text_of(plain(door)):gsub(",[^\n]*\n$", ""))
  end, "w.csv:LAST: WIDE cells expected, got 1, where the file ends" },
  { "a word", value "two", 'w.csv:3: column VALUE must be a number, got "two"' },
  { "two numbers", value "1 2", 'w.csv:3: column VALUE must be a number, got "1 2"' },
  { "an infinity", value "inf", 'w.csv:3: column VALUE must be a number, got "inf"' },
  { "a number that is too large", value "1e999", 'w.csv:3: column VALUE must be a number, got "1e999"' },
  { "a value that is missing and needed", value "", 'w.csv:3: column VALUE must be a number, got ""',
    function(door) return door.needed end },
  { "a quote without its end", value '"1', "w.csv:3: a cell that begins with a quote must end with one" },
  { "more behind a quote", value '"1"2', "w.csv:3: a cell that begins with a quote must end with one" },
  { "a byte of 0", value "1\0", "w.csv:3: must be text in UTF-8, got a byte of 0" },
  { "a line of a megabyte", value((" "):rep(1 << 20) .. "1"), "w.csv:3: is longer than 1 MiB" },
  { "no values", rows(function(list) for i = 2, #list do list[i][2] = "" end end), "w.csv: column VALUE has no value",
    function(door) return not door.needed end },
  { "a column that is missing", cells(function(_, i, k) return i == 1 and k == 1 and "u" or nil end), function(door)
    return door.rows and "w.csv:1: must be name,mean and the names" or door.only and
      'w.csv:1: the scene has no input "u" (it has push)' or "w.csv:1: has no column t" ..
      (door.timed and ", the time" or "") .. " (it has u, " .. door.value .. ")"
  end },
  { "no times", timed(function(door) return door.value .. "\n1\n2\n" end),
    "w.csv:1: has no column t, the time (it has VALUE)" },
  { "a time twice", timed(cells(function(_, i, k) return i == 3 and k == 1 and "0" or nil end)),
    "w.csv:3: times must ascend, got 0 s after 0 s" },
  { "a time that goes back", timed(cells(function(_, i, k) return i == 4 and k == 1 and "0.5" or nil end)),
    "w.csv:4: times must ascend, got 0.5 s after 1 s" },
  { "a time that is missing", timed(cells(function(_, i, k) return i == 3 and k == 1 and "" or nil end)),
    'w.csv:3: column t must be a number, got ""' },
  { "times in kg", timed(cells(function(_, i, k) return i == 1 and k == 1 and "t [kg]" or nil end)),
    "w.csv:1: column t must be in s, got [kg]" },
  { "a unit that is none", timed(cells(function(s, i, k) return i == 1 and k == 2 and s .. " [furlong]" or nil end)),
    'w.csv:1: column VALUE: unknown unit "furlong"' },
  { "units for other columns", timed(function(door) return "# units: s\n" .. text_of(plain(door)) end),
    "w.csv:2: 2 names, but 1 units above them" },
}

-- ---- the table ----

local function message(words, door)
  if type(words) == "function" then words = words(door) end
  local n = #plain(door)[1]
  return (words:gsub("%u%u+", { VALUE = door.value, FIRST = door.first or "t", WIDE = n, NARROW = n - 1, LONG = n + 1,
    LAST = #plain(door) }))
end

local function refused(name, door, command, text, words)
  local status, out, err = run(command, text)
  tap.ok(status == 2 and out == "" and err:find(words, 1, true) ~= nil, name .. " is refused",
    words .. "\nbut " .. status .. ": " .. err .. (door.counts and "" or out:sub(1, 100)))
end

for _, d in ipairs(DOORS) do
  local name, command, door = d[1], d[2], d[3]
  local status, first, err = run(command, text_of(plain(door)))
  tap.ok(status == 0 and #first > 0, name .. ": the plain file is taken", status .. ": " .. err)
  for _, case in ipairs(TAKEN) do
    local text = (not case[3] or case[3](door)) and case[2](door) or nil
    if text then
      local code, out, said = run(command, text)
      -- a value fewer is another fit, and another point of a chart; a fit names the columns that it leaves
      local other = door.counts and case[1]:find "^a value" or out:find("measures note", 1, true)
      tap.ok(code == 0 and (out == first or other), name .. ": " .. case[1], code .. ": " .. said)
    end
  end
  for _, case in ipairs(REFUSED) do
    local text = (not case[4] or case[4](door)) and case[2](door) or nil
    if text then refused(name .. ": " .. case[1], door, command, text, message(case[3], door)) end
  end
  local function other(path) return (command:gsub("w%.csv", path)) end
  refused(name .. ": no file", door, other "none.csv", nil, "cannot read none.csv: No such file or directory")
  refused(name .. ": a folder", door, other ".", nil, "cannot read .: it is a directory")
  refused(name .. ": a device", door, other "/dev/zero", nil, "cannot read /dev/zero: it is not a regular file")
end

program.finish()
tap.done()
