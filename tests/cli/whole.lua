-- whole.lua - runs a few lines of a test inside the program with the whole generator at hand.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local lua = require("tests.cli.whole")
--     local text = lua [[ local job = plan("top", { real = "float", methods = { "rk4" } }) say(...) ]]
--
-- program.run has the host alone.  Here generator and templates are those of the tree, and its main.lua is the test's.
-- Scenes are files NAME.lua in program.directory().

local program = require "tests.cli.program"
local worker = require "tests.cli.worker"

local dir = program.directory()

local PRELUDE = [[
local driver = require "generator.driver"
local build = require "generator.commands.build"
local numeric = require "generator.dynamics.numeric"
local function read(name) return assert(driver.read(host, args[1] .. "/" .. name .. ".lua", {})) end
local function plan(name, options) options.command = "" return (assert(driver.plan(read(name), options))) end
local function same(a, b) for i = 1, #a do if a[i] ~= b[i] then return false end end return #a == #b end
]]

-- What the text says, or nil and its message as a diagnostic.
return function(text)
  program.write(dir .. "/text.lua", PRELUDE .. text)
  return worker(dir .. "/text.lua", { dir })
end
