-- tree.lua - runs Lua text inside the program, with the whole generator at hand and the host's table.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local lua = require "tests.plan.tree"
--     local out, err, status = lua([[ say(host.version) ]], before, argument, ...)    -- say(...) prints a line
-- before: environment variables for the shell, or nil.

local program = require "tests.cli.program"

local binary = os.getenv("POLHODE") or "build/polhode"
local LIMIT = tonumber(os.getenv "POLHODE_TEST_LIMIT" or 120) -- s; far above what any test may take

local base

-- The generator beside us with tests/cli/tree's main.lua in place of its own.
local function source()
  if not base then
    base = program.directory() .. "/source"
    program.shell("mkdir -p " .. base .. " && cp -r generator templates " .. base ..
      " && cp tests/cli/tree/generator/main.lua " .. base .. "/generator/")
  end
  return base
end

return function(text, before, ...)
  local dir = program.directory()
  program.write(dir .. "/main.lua", text)
  local words = { before or "", "POLHODE_SOURCE=" .. source(), "timeout", tostring(LIMIT), binary, dir .. "/main.lua" }
  for _, a in ipairs { ... } do words[#words + 1] = "'" .. a:gsub("'", "'\\''") .. "'" end
  words[#words + 1] = ">" .. dir .. "/out 2>" .. dir .. "/err"
  local status = program.shell(table.concat(words, " "))
  return program.read(dir .. "/out"), program.read(dir .. "/err"), status
end
