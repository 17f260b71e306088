-- whole.lua - runs a few lines of a test inside the program with the whole generator at hand.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local lua = require("tests.cli.whole")
--     local text = lua [[ local job = plan("top", { real = "float", methods = { "rk4" } }) say(...) ]]
--
-- program.run has the host alone.  Here generator and templates are those of the tree, and its main.lua is the test's.
-- Scenes are files NAME.lua in program.directory().

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local made

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
  if not made then
    made = program.shell("mkdir -p " .. dir .. "/tree/generator && cd " .. dir .. "/tree && " ..
      "ln -s $OLDPWD/templates . && ln -s $OLDPWD/generator/* generator && rm generator/main.lua && " ..
      "cp $OLDPWD/tests/cli/tree/generator/main.lua generator") == 0
  end
  program.write(dir .. "/text.lua", PRELUDE .. text)
  local binary = os.getenv("POLHODE") or "build/polhode"
  local code = program.shell(string.format("POLHODE_SOURCE=%s/tree timeout 120 %s %s/text.lua %s > %s/out 2> %s/err",
    dir, binary, dir, dir, dir, dir))
  if code ~= 0 then
    tap.diag(program.read(dir .. "/err"))
    return nil
  end
  return program.read(dir .. "/out")
end
