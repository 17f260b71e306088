-- help.lua -- polhode help: all commands on one screen, or one of them with every option explained.
--
-- What is said stands beside the command, in its file: command.forms = {{operands, what it does, page = is it on the
-- command's own page alone?}, ...},
-- command.options and command.operands (commands/options.lua), command.examples = {{command line, what it shows}, ...}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local help = { names = { "init", "gen", "run", "sweep", "fit", "design", "explain", "check", "bench", "plot",
  "view", "chart", "mesh", "links", "list" } }

local width, column = 80, 26 -- of a line; where explanations begin

-- The words of text in lines of at most `wide` letters.
local function wrapped(text, wide)
  local lines, line = {}, nil
  for word in string.gmatch(text, "%S+") do
    if line and #line + 1 + #word <= wide then
      line = line .. " " .. word
    else
      lines[#lines + 1] = line
      line = word
    end
  end
  lines[#lines + 1] = line
  return lines
end

-- What is explained, at an indent, and its explanation from a column on: beside it, or below it if it is too long.
local function beside(out, left, right, indent, at)
  local lines = wrapped(right, width - at)
  left = string.rep(" ", indent) .. left
  if #left + 2 > at then
    out[#out + 1] = left
  else
    lines[1] = left .. string.rep(" ", at - #left) .. lines[1]
  end
  for i, line in ipairs(lines) do
    out[#out + 1] = (i > 1 or #left + 2 > at) and string.rep(" ", at) .. line or line
  end
end

local named = { pair = "NAME=NUMBER", pairs = "NAME=X[,Y]", ranges = "NAME=LOW:HIGH" }

-- What is written for an option's value, nil for a flag.
function help.value(row)
  return row[2] and (named[row[2]] or row.value or table.concat(row[2], "|")) or nil
end

local function option(out, row)
  local about = row[3] .. (row.default and " (default: " .. row.default .. ")" or "")
  local value = help.value(row)
  beside(out, row[1] .. (value and " " .. value or ""), about, 2, column)
  if not row.each then return end
  for _, choice in ipairs(row[2]) do beside(out, choice, row.each[choice], column, column + 13) end
end

local about_scenes = "SCENE is a file, - for standard input, or the name of an installed scene (polhode list bodies)."

function help.of(name) return require("generator.commands." .. name) end

function help.overview()
  local out = { "usage: polhode COMMAND OPERANDS [OPTIONS]", "" }
  for _, name in ipairs(help.names) do
    for _, form in ipairs(help.of(name).forms) do
      if not form.page then beside(out, name .. string.rep(" ", 8 - #name) .. form[1], form[2], 2, 34) end
    end
  end
  beside(out, "help    [COMMAND]", "its options; or a word of scenes: scene.time", 2, 34)
  out[#out + 1] = ""
  local status = " Exit status: 0; 1 wrong scene; 2 wrong command line or missing file; 3 a check of numbers " ..
    "failed; 70 a bug; 74 output failed."
  for _, line in ipairs(wrapped(about_scenes .. status, width)) do out[#out + 1] = line end
  return table.concat(out, "\n") .. "\n"
end

function help.page(name)
  local command, out = help.of(name), {}
  for i, form in ipairs(command.forms) do
    out[#out + 1] = (i == 1 and "usage: " or "       ") .. "polhode " .. name .. " " .. form[1] ..
      (#command.options > 0 and " [options]" or "")
  end
  for _, form in ipairs(command.forms) do
    out[#out + 1] = ""
    local about = string.gsub(form[2], "^%l", string.upper) .. (string.find(form[2], "%?$") and "" or ".")
    local text = (#command.forms > 1 and form[1] .. ": " or "") .. about .. (form[3] and " " .. form[3] or "")
    for _, line in ipairs(wrapped(text, width)) do out[#out + 1] = line end
  end
  if command.operands[3] == "SCENE" then
    out[#out + 1] = ""
    for _, line in ipairs(wrapped(about_scenes, width)) do out[#out + 1] = line end
  end
  if #command.options > 0 then out[#out + 1] = "\nOptions" end
  for _, row in ipairs(command.options) do option(out, row) end
  out[#out + 1] = "\nExamples"
  for _, e in ipairs(command.examples) do
    out[#out + 1] = "  " .. e[1]
    for _, line in ipairs(wrapped(e[2], width - 6)) do out[#out + 1] = "      " .. line end
  end
  return table.concat(out, "\n") .. "\n"
end

return help
