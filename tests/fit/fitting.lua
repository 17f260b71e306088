-- fitting.lua - runs `polhode fit` from a test.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local code, got, err = fitting.run(binary, scene_text, "--data log.csv --free I2")
--
-- got: what it printed as JSON, or nil.

local json = require "tests.json"
local program = require "tests.cli.program"

local fitting = {}

function fitting.run(binary, scene, options)
  local path = program.directory() .. "/scene.lua"
  program.write(path, scene)
  local code, out, err = program.output(binary .. " fit " .. path .. " --format json " .. options)
  return code, out ~= "" and json.read(out) or nil, err
end

return fitting
