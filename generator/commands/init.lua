-- init.lua -- polhode init: a new project: a commented scene, a program, a Makefile, and what an editor needs.
--
-- The user's files are written once; definitions and snippets are written anew, so that `polhode init NAME` after an
-- update of the program brings them up to date (commands/outputs.lua keeps book).
-- SPDX-License-Identifier: GPL-3.0-or-later

local catalogue = require "generator.mass.catalogue"
local definitions = require "generator.language.definitions"
local effects = require "generator.effects.effects"
local identifiers = require "generator.dsl.names"
local options = require "generator.commands.options"
local reference = require "generator.commands.reference"
local outputs = require "generator.commands.outputs"
local snippets = require "generator.language.snippets"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"

local init = {}

init.forms = { { "NAME", "a new project: scene, Makefile, editor",
  "It has a commented scene, a program that runs its code, a Makefile, an example for continuous integration, and " ..
  "for editors with the Lua language server completion, hover and snippets. Once more in the same folder it brings " ..
  "the editor's files up to date and keeps yours." } }
init.operands = { 1, 1, "NAME" }
init.options = {
  { "-o", "text", "the folder that is written; it is made if it is not there", value = "DIR", default = "NAME" },
}
init.examples = { { "polhode init spinner", "the folder spinner; make -C spinner check generates, compiles, tests" } }

-- The user's files: template, name in the project.
local templates = { { "scene.txt", "@NAME@.lua" }, { "main.txt", "main.c" }, { "make.txt", "Makefile" },
  { "readme.txt", "README.md" }, { "luarc.txt", ".luarc.json" }, { "workflow.txt", ".github/workflows/check.yml" } }

-- What the editor's files are made from: {shapes =, effects =, units =, functions =, watched =}.
function init.tables()
  return { shapes = catalogue.list, effects = effects, units = units, functions = value.functions,
    watched = reference.watched() }
end

-- The files of the project, for outputs.write.
function init.files(name, texts)
  local function filled(text)
    return (string.gsub(text, "@(%u+)@", { NAME = name, UPPER = string.upper(name) }))
  end
  local files = {}
  for i, t in ipairs(templates) do
    files[i] = { name = filled(t[2]), text = filled(texts["templates/start/" .. t[1]]), once = true }
  end
  files[#files + 1] = { name = ".gitignore", text = "/gen/\n/" .. name .. "\n", once = true }
  files[#files + 1] = { name = ".lua/polhode.d.lua", text = definitions.text(init.tables()) }
  files[#files + 1] = { name = ".vscode/polhode.code-snippets", text = snippets.text(init.tables()) }
  return files
end

function init.run(host, given)
  local name = given[1]
  local rule = identifiers.scene(name)
  if name == "gen" or name == "Makefile" then rule = "must not be that of a file of the project" end
  if rule then return options.wrong(host, "init", "NAME " .. rule .. ", got " .. name) end
  local files = init.files(name, host.templates)
  local ok, why, status = outputs.write(host, given.o or name, "init " .. name, files)
  if not ok then return options.failed(host, "init", why, status) end
  host.out(string.format("%s: %s.lua, main.c, Makefile and the editor's files\nnext: cd %s && make && ./%s\n",
    given.o or name, name, given.o or name, name))
  return 0
end

return init
