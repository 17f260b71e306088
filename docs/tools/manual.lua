-- manual.lua -- the man pages: polhode(1), polhode-COMMAND(1), polhode-scene(5), polhode(3).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 docs/tools/manual.lua DIRECTORY VERSION DATE      in the project's root, after make: `make man`
--
-- polhode(1) and the commands' pages come from the tables that the command line is read with, polhode-scene(5) from the
-- catalogues of shapes, effects and units, polhode(3) from the headers of the library.  DATE is that of the version:
-- the same sources give the same bytes.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local help = require "generator.commands.help"
local headers = require "docs.tools.headers"
local roff = require "docs.tools.roff"
local scene_page = require "docs.tools.scene_page"

local manual = {}

local statuses = {
  { "0", "success" },
  { "1", "the scene is wrong; standard error names the line, the rule and the value" },
  { "2", "the command line is wrong, or a file is missing" },
  { "3", "a check of numbers failed, or a result is not finite" },
  { "70", "a bug of polhode; please report it" },
  { "74", "the output could not be written" },
}

local environment = {
  { "POLHODE_BODIES", "the folder of installed scenes, in place of the usual one" },
  { "POLHODE_PATIENCE", "how many times the usual limits of memory and steps a scene may use, for a large scene " ..
    "that you trust; default 1" },
  { "CC", "the C compiler for commands that compile what they generate; default cc" },
  { "NO_COLOR", "if it is set and not empty, messages have no colour; without it they have colour on a terminal" },
  { "TMPDIR", "where commands that compile make their folder; default /tmp" },
}

local scene_is = "SCENE is a file, - for standard input, or the name of an installed scene: a word without a slash " ..
  "and without .lua that is no file here. The installed scenes are looked up in the folder of POLHODE_BODIES, else " ..
  "in share/polhode/bodies beside the program's bin, else in the sources that it was built in, else in ./bodies."

local function sentence(text)
  return string.gsub(text, "^%l", string.upper) .. (string.find(text, "[%?%.]$") and "" or ".")
end

local function see_also(own)
  local list = {}
  for _, name in ipairs { "polhode", table.unpack(help.names) } do
    local page = name == "polhode" and name or "polhode-" .. name
    if page ~= own then list[#list + 1] = { page, 1 } end
  end
  list[#list + 1] = { "polhode", 3 }
  list[#list + 1] = { "polhode-scene", 5 }
  return list
end

local function synopsis(page, name, command)
  for _, form in ipairs(command.forms) do
    page:synopsis("polhode " .. name, form[1] .. (#command.options > 0 and " [OPTION...]" or ""))
  end
end

-- ---- polhode(1) ----

function manual.program(version, date)
  local page = roff.page("polhode", 1, version, date, "turn the description of a rigid body into C")
  page:section "SYNOPSIS"
  page:synopsis("polhode", "COMMAND OPERAND... [OPTION...]")
  page:synopsis("polhode", "--help | --version")
  page:section "DESCRIPTION"
  page:text("polhode reads a scene: the description of a rigid body and of what acts on it, in Lua. It derives the " ..
    "tensor of inertia and the equations of motion, and writes C99 for exactly this scene. If the motion has a " ..
    "closed form, the code contains that formula. polhode-scene(5) explains the language of scenes.")
  page:text(scene_is)
  page:section "COMMANDS"
  for _, name in ipairs(help.names) do
    local command = help.of(name)
    page:entry(name, nil, sentence(command.forms[1][2]) .. " See polhode-" .. name .. "(1).")
  end
  page:entry("help", "[COMMAND]", "Explain every option of a command, with examples.")
  page:section "EXIT STATUS"
  for _, s in ipairs(statuses) do page:entry(s[1], nil, sentence(s[2])) end
  page:section "ENVIRONMENT"
  for _, e in ipairs(environment) do page:entry(e[1], nil, sentence(e[2])) end
  page:section "EXAMPLES"
  for _, name in ipairs { "explain", "gen", "run", "plot" } do page:example(table.unpack(help.of(name).examples[1])) end
  page:see(see_also "polhode")
  return page:done()
end

-- ---- polhode-COMMAND(1) ----

function manual.command(name, version, date)
  local command = help.of(name)
  local page = roff.page("polhode-" .. name, 1, version, date, (string.gsub(command.forms[1][2], "%.$", "")))
  page:section "SYNOPSIS"
  synopsis(page, name, command)
  page:section "DESCRIPTION"
  for _, form in ipairs(command.forms) do
    page:text((#command.forms > 1 and form[1] .. ": " or "") .. sentence(form[2]) .. (form[3] and " " .. form[3] or ""))
  end
  if command.operands[3] == "SCENE" then page:text(scene_is) end
  if #command.options > 0 then
    page:section "OPTIONS"
    for _, row in ipairs(command.options) do
      local one_of = type(row[2]) == "table" and row.value and not row.each
      local choices = one_of and " One of " .. table.concat(row[2], ", ") .. "."
      page:entry(row[1], help.value(row), sentence(row[3]) .. (choices or
        "") .. (row.default and " Default: " .. row.default .. "." or ""))
      if row.each then
        page:inner(function()
          for _, choice in ipairs(row[2]) do page:entry(choice, nil, sentence(row.each[choice])) end
        end)
      end
    end
  end
  page:section "EXIT STATUS"
  page:text "0 on success. polhode(1) lists the others."
  page:section "EXAMPLES"
  for _, e in ipairs(command.examples) do page:example(table.unpack(e)) end
  page:see(see_also("polhode-" .. name))
  return page:done()
end

-- ---- polhode(3) ----

function manual.library(version, date, read)
  local page = roff.page("polhode", 3, version, date, "general library of rigid-body mechanics (libpolhode)")
  page:section "LIBRARY"
  page:text("libpolhode (-lpolhode -lgsl -lgslcblas -lm). pkg-config names the flags: " ..
    "pkg-config --cflags --libs polhode.")
  page:section "SYNOPSIS"
  local lines = {}
  for i, name in ipairs(headers.names) do lines[i] = "#include <" .. name .. ">" end
  page:literal(table.concat(lines, "\n"))
  for _, name in ipairs(headers.names) do
    local blocks = headers.blocks(read("src/runtime/" .. name))
    page:section(string.upper(name))
    for _, b in ipairs(blocks) do
      if b.head then page:subsection(b.head) end
      if b.text then page:text(b.text) end
      if b.code then page:literal(b.code) end
    end
  end
  page:see { { "polhode", 1 }, { "polhode-scene", 5 } }
  return page:done()
end

-- {name, text} of every page.
function manual.pages(version, date, read)
  local list = { { "polhode.1", manual.program(version, date) } }
  for _, name in ipairs(help.names) do
    list[#list + 1] = { "polhode-" .. name .. ".1", manual.command(name, version, date) }
  end
  list[#list + 1] = { "polhode-scene.5", scene_page(version, date) }
  list[#list + 1] = { "polhode.3", manual.library(version, date, read) }
  return list
end

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "a"
  file:close()
  return text
end

if arg and arg[0] and string.find(arg[0], "manual.lua", 1, true) then
  assert(arg[3], "usage: manual.lua DIRECTORY VERSION DATE")
  for _, p in ipairs(manual.pages(arg[2], arg[3], read)) do
    local file = assert(io.open(arg[1] .. "/" .. p[1], "wb"))
    assert(file:write(p[2]))
    assert(file:close())
  end
end

return manual
