-- scenes.lua -- which scene a word of the command line means: a file, standard input, or an installed scene.
--
-- A word that is a file, or that has a slash or ends in .lua, is the name of a file; - is standard input; any other is
-- looked up in the folder of installed scenes, which host.bodies finds (src/cli/host/file_read.c).
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"

local scenes = {}

-- The names of the installed scenes and their folder, or nil and why there are none.
function scenes.names(host)
  local folder = host.bodies()
  if not folder then
    return nil, "no scenes are installed beside this program (POLHODE_BODIES may name a folder of them)"
  end
  local names, why = host.list_dir(folder, ".lua")
  if not names then return nil, why end
  for i, n in ipairs(names) do names[i] = string.gsub(n, "%.lua$", "") end
  return names, folder
end

-- What driver.read is to be given for the word, or nil and a message.
function scenes.find(host, word)
  if word == "-" or string.find(word, "/", 1, true) or string.find(word, "%.lua$") then return word end
  local text, why = host.read(word)
  if text then return word end
  local names, folder = scenes.names(host)
  for _, name in ipairs(names or {}) do
    if name == word then
      local own = host.read(word .. ".lua")
      if own and own ~= host.read(folder .. "/" .. word .. ".lua") then
        host.err("note: " .. word .. " is the installed scene; that of this folder is " .. word .. ".lua\n")
      end
      return folder .. "/" .. name .. ".lua"
    end
  end
  if host.read(word .. ".lua") then return nil, why .. "; there is " .. word .. ".lua" end
  return nil, why .. ", and " .. (names and "no installed scene has that name" ..
    options.meant(word, names) .. " (polhode list bodies)" or folder)
end

return scenes
