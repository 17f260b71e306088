-- main.lua -- the command line: help, options, which scenes are meant, the command, the exit status.
--
-- Exit status: 0; 1 the scene is wrong; 2 the command line is wrong; 3 the numbers failed a check; 70 a bug (an error
-- that reaches the host).  Results go to standard output, everything else to standard error.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local colours = require "generator.commands.colours"
local help = require "generator.commands.help"
local options = require "generator.commands.options"
local reference = later "generator.commands.reference"
local scenes = require "generator.commands.scenes"

local known = {}
for _, name in ipairs(help.names) do known[name] = true end

-- The text of `polhode help [COMMAND or NAME of the scene language]`, or nil and what is wrong.
local function explained(word, more)
  if more then return nil, "too many operands: " .. more end
  if not word or word == "help" then return help.overview() end
  if known[word] then return help.page(word) end
  local text, names = reference.help(word)
  if text then return text end
  local members = {} -- gravity: effect.gravity
  for _, name in ipairs(names) do
    if string.match(name, "^%w+%.(.*)$") == word then members[#members + 1] = name end
  end
  if #members == 1 then return (reference.help(members[1])) end
  if #members > 1 then
    return nil, "no command " .. string.format("%q", word) .. "; there is " .. table.concat(members, ", ")
  end
  local dotted = string.find(word, "[.:]") ~= nil
  return nil, (dotted and "no entry " or "no command ") .. string.format("%q", word) ..
    options.meant(word, dotted and names or help.names)
end

local function print_help(host, word, more)
  local text, why = explained(word, more)
  if not text then
    host.err("polhode help: " .. why .. " (polhode help)\n")
    return 2
  end
  host.out(text)
  return 0
end

-- The scenes that are meant by the operands, in their place; false after a message.
local function found(host, given)
  local all = true
  for i, word in ipairs(given) do
    local file, why = scenes.find(host, word)
    if not file then host.err("polhode: " .. why .. "\n") end
    all, given[i] = all and file ~= nil, file or word
  end
  return all
end

return function(host, args)
  host = colours.host(host)
  local name = args[1]
  if name == "help" then return print_help(host, args[2], args[3]) end
  if name == "--help" or name == "-h" then return print_help(host, args[2], args[3]) end
  if name == "--version" then
    if args[2] then
      host.err("polhode: too many operands: " .. args[2] .. " (polhode help)\n")
      return 2
    end
    host.out("polhode " .. host.build .. "\n")
    return 0
  end
  if not name then
    host.err(help.overview())
    return 2
  end
  if not known[name] then
    local all = { table.unpack(help.names) }
    all[#all + 1] = "help"
    host.err("polhode: no command " .. string.format("%q", name) .. options.meant(name, all) .. " (polhode help)\n")
    return 2
  end
  for i = 2, #args do
    if args[i] == "--help" or args[i] == "-h" then return print_help(host, name) end
  end
  local command = help.of(name)
  local given, why = options.parse(command, args)
  if not given then return options.wrong(host, name, why) end
  if command.operands[3] == "SCENE" and not found(host, given) then return 2 end
  return command.run(host, given)
end
