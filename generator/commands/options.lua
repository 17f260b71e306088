-- options.lua -- a command's options: one table from which they are read and explained (commands/help.lua).
--
-- command.options is a list of rows, in the order in which help prints them:
--     { "--step", "number", "what it does, with its unit", value = "H", default = "the scene's time.step" }
-- The second field is the kind of value: false (a flag), text, texts (may be given again), number, numbers, words (with
-- commas between), pair (NAME=NUMBER, may be given again), pairs (the same, or NAME=NUMBER,NUMBER), ranges
-- (NAME=LOW:HIGH, may be given again), or a list of choices (with several = true in it: any of them, commas between;
-- the result is also a set; open = true: and other words, of which the command knows; elsewhere = {word = what to ask
-- instead}).  value: what help calls it; default: what holds without it (none for a flag, a pair and ranges); each =
-- {choice = what it means}.
-- command.operands is {least, most, what they are}: SCENE (a file, -, or the name of an installed scene), FILE or WHAT.
-- -o DIR and --name=value are understood.  The result of parse maps names without dashes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local slips = require "generator.dsl.slips"
local nearest = require "generator.nearest"

local options = {}

local function split(s)
  local list = {}
  for word in string.gmatch(s .. ",", "([^,]*),") do list[#list + 1] = word end
  return list
end

-- The double nearest to what is written, or nil and the rule that it breaks.
local function number(s)
  local q = R.parse(s)
  if not q then return nil, "must be a number" .. slips.number(s, "without its unit: %s") end
  local x = R.todouble(q)
  if x == math.huge or x == -math.huge then return nil, "must be within the range of double" end
  return x
end

local kinds = {
  text = function(s)
    if s == "" then return nil, "must not be empty" end
    return s
  end,
  number = number,
  numbers = function(s)
    local list = {}
    for i, word in ipairs(split(s)) do
      local x, rule = number(word)
      if not x then return nil, (string.gsub(rule, "^must be a number", "must be numbers with commas between")) end
      list[i] = x
    end
    return list
  end,
  words = function(s) return split(s) end,
}

-- The text cut at commas outside of brackets, without blanks around the parts.
function options.entries(text)
  local list, depth, from = {}, 0, 1
  for i = 1, #text do
    local c = string.sub(text, i, i)
    if string.find(c, "[({]") then depth = depth + 1 elseif string.find(c, "[)}]") then depth = depth - 1 end
    if c == "," and depth <= 0 then
      list[#list + 1] = string.sub(text, from, i - 1)
      from = i + 1
    end
  end
  list[#list + 1] = string.sub(text, from)
  for i, s in ipairs(list) do list[i] = string.match(s, "^%s*(.-)%s*$") end
  return list
end

-- "a, b or c"
function options.either(list)
  if #list < 2 then return list[1] end
  return table.concat(list, ", ", 1, #list - 1) .. " or " .. list[#list]
end

-- What other programs call a value that some options have here by another name.
local elsewhere = { tex = "latex", md = "markdown", htm = "html", typ = "typst", txt = "text" }

-- "; did you mean b?" where the list has one word that begins with this one, or a word near to it; else nothing.
function options.meant(word, list)
  local begun = {}
  for _, entry in ipairs(list) do
    if entry == elsewhere[word] then return "; did you mean " .. entry .. "?" end
    if #word >= 2 and string.sub(entry, 1, #word) == word then begun[#begun + 1] = entry end
  end
  local best = #begun == 1 and begun[1] or nearest.one(word, list)
  return best and best ~= word and "; did you mean " .. best .. "?" or ""
end

-- What is wrong with a list of words, all of which must be of `known` and none twice, or nil.  alone: a word that may
-- stand there too, if it is the only one.
function options.unknown(name, list, known, alone)
  local seen, all = {}, { table.unpack(known) }
  all[#all + 1] = alone
  for _, word in ipairs(known) do seen[word] = 0 end
  for _, word in ipairs(list or {}) do
    if not seen[word] then
      return name .. " must be " .. (alone and alone .. " or " or "") .. "some of " .. table.concat(known, ", ") ..
        ", got " .. (word == "" and "nothing" or word) .. options.meant(word, all)
    end
    if seen[word] > 0 then return name .. ": " .. word .. " stands there twice" end
    seen[word] = 1
  end
  return nil
end

local function chosen(row, value)
  local list = row[2].several and (row[2].open and options.entries or split)(value) or { value }
  for _, word in ipairs(list) do
    local known = row[2].open and word ~= ""
    for _, w in ipairs(row[2]) do known = known or w == word end
    if not known and row[2].elsewhere and row[2].elsewhere[word] then
      return nil, row[1] .. " " .. word .. ": " .. row[2].elsewhere[word]
    end
    if not known then
      return nil, row[1] .. " must be " .. options.either(row[2]) .. ", got " .. word .. options.meant(word, row[2])
    end
    if list[word] then return nil, row[1] .. ": " .. word .. " stands there twice" end
    list[word] = true
  end
  return row[2].several and list or value
end

-- NAME and what stands behind its = in values of these kinds, or nil and the rule.
local named = {
  pair = function(value)
    local k, v = string.match(value, "^(%a[%w_]*)=(.+)$")
    if k and R.parse(v) then return k, v end
    return nil, "NAME=NUMBER" .. slips.number(v, "without its unit: " .. (k or "") .. "=%s")
  end,
  pairs = function(value)
    local k, v = string.match(value, "^(%a[%w_]*)=(.+)$")
    local list = k and split(v) or {}
    for _, x in ipairs(list) do list = R.parse(x) and list or {} end
    if #list == 1 or #list == 2 then return k, list end
    return nil, "NAME=NUMBER or NAME=NUMBER,NUMBER"
  end,
  ranges = function(value)
    local k, low, high = string.match(value, "^%s*(.-)%s*=%s*([^=:]+):([^=:]+)$")
    low, high = number(low or ""), number(high or "")
    if k ~= "" and low and high and low < high then return k, { low, high } end
    return nil, "NAME=LOW:HIGH, with LOW below HIGH"
  end,
}

-- One value of an option, put into out; a message if it is wrong.
local function take(row, key, value, out)
  local name, kind = row[1], row[2]
  if named[kind] then
    local k, v = named[kind](value)
    if not k then return name .. " must be " .. v .. ", got " .. value end
    out[key] = out[key] or {}
    if out[key][k] then return name .. " " .. k .. " is given twice" end
    out[key][k] = v
    return nil
  end
  if kind == "texts" then
    if value == "" then return name .. " must not be empty, got nothing" end
    out[key] = out[key] or {}
    table.insert(out[key], value)
    return nil
  end
  if out[key] ~= nil then return name .. " is given twice" end
  local v, why
  if type(kind) == "table" then
    v, why = chosen(row, value)
  else
    v, why = kinds[kind](value)
    why = why and name .. " " .. why .. ", got " .. (value == "" and "nothing" or value)
  end
  if v == nil then return why end
  out[key] = v
  return nil
end

-- What other programs call an option that some commands have here by another name.
local foreign = { ["--grid"] = "--over", ["--range"] = "--over", ["--output"] = "-o", ["--out"] = "-o",
  ["--jobs"] = "--threads", ["-j"] = "--threads", ["--solver"] = "--method", ["--integrator"] = "--method",
  ["--param"] = "--set", ["--parameter"] = "--set", ["--duration"] = "--until", ["--dt"] = "--step" }

-- The row of an option, or nil and a message.
local function find(rows, name)
  local names, known = {}, nil
  for i, row in ipairs(rows) do
    if row[1] == name then return row end
    names[i] = row[1]
    if row[1] == foreign[name] then known = row[1] end
  end
  if not known and (name == "-o" or foreign[name] == "-o") then
    return nil, "no option " .. name .. ": the result goes to standard output (add > FILE)"
  end
  return nil, "no option " .. name .. (known and "; did you mean " .. known .. "?" or options.meant(name, names))
end

-- What a command's declaration makes of the arguments: {options..., [1..n] = operands}, or nil and what is wrong.
function options.parse(command, args)
  local out, operands = {}, command.operands
  local i = 2
  while i <= #args do
    local a = args[i]
    if a == "" then
      return nil, operands[3] .. " must not be empty"
    elseif string.sub(a, 1, 1) ~= "-" or a == "-" then
      out[#out + 1] = a
    else
      local name, value = string.match(a, "^(%-%-[%w-]+)=(.*)$")
      name = name or a
      local row, why = find(command.options, name)
      if not row then return nil, why end
      local key = string.gsub(string.gsub(name, "^%-+", ""), "%-", "_")
      if row[2] == false then
        if value then return nil, name .. " takes no value" end
        out[key] = true
      else
        if not value then
          i = i + 1
          value = args[i]
          if not value then return nil, name .. " needs a value" end
        end
        why = take(row, key, value, out)
        if why then return nil, why end
      end
    end
    i = i + 1
  end
  if #out < operands[1] then return nil, operands[3] .. " is missing" end
  if #out > operands[2] then return nil, "too many operands: " .. out[operands[2] + 1] end
  return out
end

-- The row of an option of a command, whose rows other parts of the command use.
function options.row(command, name) return (find(command.options, name)) end

-- Prints one line about the command line, with where help is, and returns the exit status.
function options.wrong(host, command, why)
  host.err("polhode " .. command .. ": " .. why .. " (polhode help " .. command .. ")\n")
  return 2
end

-- Prints what went wrong outside of the command line and the scene, and returns the exit status, 2 unless another is
-- given.
function options.failed(host, command, why, status)
  host.err("polhode " .. command .. ": " .. string.gsub(why, "\n$", "") .. "\n")
  return status or 2
end

-- A result goes to the file of -o, or to standard output; returns the exit status.
function options.write(host, command, file, text)
  if not file or file == "-" then
    host.out(text)
    return 0
  end
  local ok, why, status = host.write_file(file, text)
  return ok and 0 or options.failed(host, command, why, status)
end

-- Prints what is wrong with a scene, or why it could not be read, and returns the exit status.
function options.refuse(host, d, why)
  if why then
    host.err("polhode: " .. why .. "\n")
    return 2
  end
  host.err(d:report())
  return 1
end

-- Warnings do not stop anything.
function options.warn(host, d)
  for _, w in ipairs(d.warnings) do host.err("warning: " .. w.text .. "\n") end
end

-- Rules that the emitted code does not ask about when a parameter changes; who: what is then done without asking.
function options.unasked(host, job, who)
  for _, c in ipairs(job.model.unasked) do
    host.err("warning: " .. job.model.file .. ":" .. c.line .. ": " .. c.what .. ": " .. c.rule .. ", which " .. who ..
      " when a parameter changes: there is no formula (polhode run and sweep ask)\n")
  end
end

return options
