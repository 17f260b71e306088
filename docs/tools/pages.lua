-- pages.lua -- writes the pages that are made from the generator's own tables: shapes, effects, commands.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 docs/tools/pages.lua DIRECTORY          in the project's root, after make: `make docs`
--
-- Writes DIRECTORY/shapes.md with DIRECTORY/shapes/NAME.svg, effects.md, reference.md, commands.md,
-- and methods.md with its table of special paths.  These tools read
-- the generator's modules, and no module of the generator knows them: the program has what a user calls and nothing
-- else.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local catalogue = require "generator.mass.catalogue"
local modules = require "generator.effects.effects"
local reference = require "generator.commands.reference"
local language = require "generator.language.reference"
local commands = require "docs.tools.commands"
local effects = require "docs.tools.effects"
local shapes = require "docs.tools.shapes"
local special = require "docs.tools.special"

local folder = assert(arg[1], "usage: pages.lua DIRECTORY")

-- One reader in the project's root: nil where there is no such file.
local function read(path)
  local file = io.open(path, "rb")
  local text = file and file:read "a"
  if file then file:close() end
  return text
end

local function write(path, text)
  local file = assert(io.open(path, "wb"))
  assert(file:write(text))
  assert(file:close())
end

local files = shapes.files(catalogue.list)
files[#files + 1] = { name = "effects.md", text = effects.page(modules, read) }
files[#files + 1] = { name = "reference.md", text = language.page(reference.entries()) }
files[#files + 1] = { name = "commands.md", text = commands.page() }
files[#files + 1] = { name = "methods.md", text = special.page(read "docs/methods.md") }

assert(os.execute("mkdir -p '" .. folder .. "/shapes'"))
for _, f in ipairs(files) do write(folder .. "/" .. f.name, f.text) end
