-- program.lua - runs polhode on scenes and robot files in a directory of the test's own.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local run = require "tests.interchange.program"
--     run.write("b.urdf", text)
--     local status, out, err = run.explain('return scene { ... }', "urdf")     -- the scene is s.lua
--     run.inertial("b.urdf", "mjcf")      -- a scene that is nothing but this file
--     run.finish()
-- POLHODE names another binary.

local program = require "tests.cli.program"
local json = require "tests.json"

local run = {}

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = assert(io.popen "pwd"):read "l" .. "/" .. binary end

run.dir, run.shell, run.finish = dir, program.shell, program.finish

function run.write(name, text) program.write(dir .. "/" .. name, text) end

function run.explain(scene, format, more)
  run.write("s.lua", scene)
  local status = program.shell(string.format("cd %s && timeout 60 %s explain s.lua --format %s %s >out 2>err", dir,
    binary, format, more or ""))
  return status, program.read(dir .. "/out"), program.read(dir .. "/err")
end

function run.inertial(file, format, link)
  return run.explain(string.format("return scene { name = \"b\", body = inertial { file = %q%s } }", file,
    link and string.format(", link = %q", link) or ""), format)
end

-- Mass, centre and the six entries about it as doubles, in one list; nil and standard error.
function run.numbers(text, err)
  local ok, t = pcall(json.read, text)
  if not ok or not t then return nil, err end
  local list = { t.mass }
  for i = 1, 3 do list[#list + 1] = t.com[i] end
  for i = 1, 6 do list[#list + 1] = t.centroidal.numeric[i] end
  return list
end

return run
