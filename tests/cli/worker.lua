-- worker.lua - runs a Lua file of a test inside the program, with the whole generator at hand.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local text = require("tests.cli.worker")("tests/x/worker.lua", { "argument", ... })
--
-- The file is the body of a function (host, args) as in tests/cli/tree.  Returns what it says, or nil and its message
-- as a diagnostic.

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local made

return function(file, arguments)
  if not made then
    made = program.shell("mkdir -p " .. dir .. "/tree/generator && cd " .. dir .. "/tree && " ..
      "ln -s $OLDPWD/templates . && ln -s $OLDPWD/generator/* generator && rm generator/main.lua && " ..
      "cp $OLDPWD/tests/cli/tree/generator/main.lua generator") == 0
  end
  local words = {}
  for i, a in ipairs(arguments) do words[i] = "'" .. a .. "'" end
  local binary = os.getenv("POLHODE") or "build/polhode"
  local code = program.shell(string.format("POLHODE_SOURCE=%s/tree timeout 120 %s %s %s > %s/out 2> %s/err", dir,
    binary, file, table.concat(words, " "), dir, dir))
  if code ~= 0 then
    tap.diag(program.read(dir .. "/err"))
    return nil
  end
  return program.read(dir .. "/out")
end
