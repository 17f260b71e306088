-- completed.lua -- what a shell can complete: commands, their operands and options, and the values of each option.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- All of it comes from the tables that the program reads its command line with (generator/commands/options.lua), and is
-- written for three shells by docs/tools/completions.lua.

local help = require "generator.commands.help"
local measure = require "generator.commands.measure"
local methods = require "generator.methods.methods"

local completed = {}

local function methods_of(command)
  local names = { command ~= "view" and "exact" or nil }
  for _, m in ipairs(methods) do names[#names + 1] = m.name end
  if command == "gen" or command == "run" then names[#names + 1] = "linearised" end
  return names
end

-- The value of an option: {words = list, several = commas between?}, {files = extension or true}, {folders = true}, or
-- {} where there is nothing to offer; nil for a flag.
local function value(command, row)
  local kind, called = row[2], row.value or ""
  if kind == false then return nil end
  if type(kind) == "table" then return { words = { table.unpack(kind) }, several = kind.several } end
  if row[1] == "--method" then return { words = methods_of(command), several = kind == "words" } end
  if row[1] == "--target" then return { words = { "all", table.unpack(measure.names) }, several = true } end
  if string.find(called, "^DIR") then return { folders = true } end
  if string.find(called, "^FILE") then return { files = string.match(called, "^FILE%.(%w+)$") or true } end
  return {}
end

-- What an operand can be: "scene", "mesh" (any file) or a list of words.
local function operand(name, command)
  if name == "help" then return { table.unpack(help.names) } end
  local kind = command.operands[3]
  if kind == "WHAT" then return { table.unpack(command.subjects) } end
  return kind == "SCENE" and "scene" or kind == "FILE" and "file" or nil
end

local function first_sentence(text)
  return (string.gsub(string.gsub(string.gsub(text, "%s+", " "), "[;:] .*$", ""), "^(.-) %(.*$", "%1"))
end

-- A list of {name =, about =, operand =, options = {{name =, about =, value =}, ...}}, in the order of the help.
function completed.commands()
  local list = {}
  for i, name in ipairs(help.names) do
    local command, options = help.of(name), {}
    for k, row in ipairs(command.options) do
      options[k] = { name = row[1], about = first_sentence(row[3]), value = value(name, row) }
    end
    options[#options + 1] = { name = "--help", about = "explain every option of the command" }
    list[i] = { name = name, about = command.forms[1][2], operand = operand(name, command), options = options }
  end
  list[#list + 1] = { name = "help", about = "every option of a command, and examples", operand = operand "help",
    options = {} }
  return list
end

return completed
