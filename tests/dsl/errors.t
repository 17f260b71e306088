#!/usr/bin/env lua5.4
-- errors.t: every message that a wrong scene can get, with its line, from the real program.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One row a message: {scene, line, message}.  The whole of standard error must be
--     s.lua:LINE: MESSAGE
--         the source line
-- with status 1, nothing on standard output and no file written.  Rows with a list of {line, message} are scenes with
-- several errors, all of which must come at once and in the order of the lines.
-- The quick tier takes every fifth row of a group.
-- The program runs `gen -o out s.lua` in a directory of its own; POLHODE names another binary.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local tables = { require "tests.dsl.messages_names", require "tests.dsl.messages_shapes",
  require "tests.dsl.messages_rows", require "tests.dsl.messages_plane", require "tests.dsl.messages_slips",
  (require "tests.dsl.messages_scenes") }

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local root = assert(io.popen("pwd")):read "l"

-- Status, standard output, standard error of `polhode ARGS` in the directory, with the scene in s.lua.
local function run(scene, args)
  program.write(dir .. "/s.lua", scene)
  local path = binary:sub(1, 1) == "/" and binary or root .. "/" .. binary
  local status = program.shell(string.format("cd %s && timeout 60 %s %s >stdout 2>stderr", dir, path, args))
  return status, program.read(dir .. "/stdout"), program.read(dir .. "/stderr")
end

local function exists(name) return program.shell("test -e " .. dir .. "/" .. name) == 0 end

local function lines_of(text)
  local list = {}
  text = text:gsub("\r\n", "\n"):gsub("\r", "\n")
  for line in (text .. "\n"):gmatch "([^\n]*)\n" do list[#list + 1] = line end
  return list
end

-- What standard error must be.
local function expected(scene, faults)
  local source, out = lines_of(scene), {}
  for i, fault in ipairs(faults) do
    local line, message = fault[1], fault[2]
    out[i] = "s.lua" .. (line and ":" .. line or "") .. ": " .. message .. "\n"
    if line and source[line]:find "%S" then
      out[i] = out[i] .. "    " .. source[line]:gsub("^%s+", ""):gsub("%c", " ") .. "\n"
    end
  end
  return table.concat(out)
end

local function check(group)
  for _, row in ipairs(tier.every(5, group)) do
    local scene, faults = row[1], type(row[2]) == "table" and { table.unpack(row, 2) } or { { row[2], row[3] } }
    local status, out, err = run(scene, "gen -o out s.lua " .. (row.args or ""))
    local want = expected(scene, faults)
    tap.ok(status == 1 and out == "" and err == want and not exists "out",
      group.about .. ": " .. (row.name or faults[1][2]),
      string.format("status %s\n%s%s\ngot\n%swant\n%s", status, out == "" and "" or "stdout not empty\n",
        exists "out" and "files were written" or "", err, want))
    if exists "out" then program.shell("rm -rf " .. dir .. "/out") end
  end
end
for _, groups in ipairs(tables) do
  for _, group in ipairs(groups) do check(group) end
end

-- ---- how messages are given ----

do
  local many = {}
  for i = 1, 30 do many[i] = "local b" .. i .. " = solid.sphere { r = -" .. i .. ", mass = 1 }" end
  local scene = table.concat(many, "\n") .. "\n" .. 'return scene { name = "s", body = b1 }\n'
  local status, out, err = run(scene, "gen -o out s.lua")
  local faults = {}
  for i = 1, 20 do faults[i] = { i, "sphere: r must be positive, got -" .. i } end
  tap.ok(status == 1 and out == "" and err == expected(scene, faults) .. "s.lua: and 10 more errors\n",
    "of 30 errors the first 20 are shown and the rest is counted", err)
  local one_more = many[1]
  for i = 2, 21 do one_more = one_more .. "\n" .. many[i] end
  err = select(3, run(one_more .. '\nreturn scene { name = "s", body = b1 }\n', "gen -o out s.lua"))
  tap.like(err, "\ns.lua: and 1 more error\n", "of 21 errors one is left to count")
end

do
  local scene = 'for i = 1, 5 do\n  local b = solid.sphere { r = -1, mass = 1 }\nend\n' ..
    'return scene { name = "s", body = solid.sphere { r = 1, mass = 1 } }\n'
  local _, _, err = run(scene, "gen -o out s.lua")
  tap.is(err, expected(scene, { { 2, "sphere: r must be positive, got -1" } }), "the same error in a loop is said once")
end

do
  local scene = 'return scene { name = "s", body = solid.sphere { r = -1, mass = 1 } }'
  for _, command in ipairs { "explain s.lua", "explain --format json s.lua", "run s.lua", "gen s.lua",
    "check s.lua" } do
    local status, _, err = run(scene, command)
    tap.ok(status == 1 and err:find("s.lua:1: sphere: r must be positive, got -1", 1, true) == 1,
      "polhode " .. command .. " says the same and ends with 1", status .. "\n" .. err)
  end
  tap.ok(not exists "s", "gen without -o wrote nothing either")
end

do -- a line that could steer a terminal, and one that never ends
  local _, _, err = run('local s = "\27[31m' .. ("x"):rep(500) .. '" solid.box()\n', "gen -o out s.lua")
  tap.ok(not err:find "\27" and #err < 400, "a quoted line has no control characters and is cut", err)
end

-- ---- the command line ----

for _, case in ipairs {
  { "explain nothing.lua", 2, "polhode: cannot read nothing.lua: No such file or directory\n" },
  { "explain .", 2, "polhode: cannot read .: it is a directory, and no installed scene has that name (polhode list " ..
    "bodies)\n" },
  { "gen", 2, "polhode gen: SCENE is missing (polhode help gen)\n" },
  { "explain s.lua t.lua", 2, "polhode explain: too many operands: t.lua (polhode help explain)\n" },
  { "explain --formt json s.lua", 2,
    "polhode explain: no option --formt; did you mean --format? (polhode help explain)\n" },
  { "explain --format", 2, "polhode explain: --format needs a value (polhode help explain)\n" },
  { "explain --format pdf s.lua", 2,
    "polhode explain: --format must be text, markdown, latex, html, typst, json, urdf, mjcf or sdf, got pdf; " ..
      "did you mean sdf? (polhode help explain)\n" },
  { "gen --bake=yes s.lua", 2, "polhode gen: --bake takes no value (polhode help gen)\n" },
  { "gen --method euler s.lua", 2,
    "polhode gen: --method must be some of exact, rk4, adaptive, taylor, rosenbrock, midpoint, semi, split2, " ..
      "split4, split6, " ..
      "linearised, got euler (polhode help gen)\n" },
  { "gen --set x s.lua", 2, "polhode gen: --set must be NAME=NUMBER, got x (polhode help gen)\n" },
  { "gen --set r=abc s.lua", 2, "polhode gen: --set must be NAME=NUMBER, got r=abc (polhode help gen)\n" },
  { "gen --set r=nan s.lua", 2, "polhode gen: --set must be NAME=NUMBER, got r=nan (polhode help gen)\n" },
  { "gen --set r=1/0 s.lua", 2, "polhode gen: --set must be NAME=NUMBER, got r=1/0 (polhode help gen)\n" },
  { "gen --set 1=1 s.lua", 2, "polhode gen: --set must be NAME=NUMBER, got 1=1 (polhode help gen)\n" },
  { "gen --set q=1 s.lua", 2, "polhode: --set q: the scene has no such parameter (it has r)\n" },
  { "fly s.lua", 2, "polhode: no command \"fly\" (polhode help)\n" },
  { "", 2, "usage: polhode COMMAND" },
  { "list planets", 2, "polhode list: must be shapes, effects, methods, bodies, constants or commands, got planets " ..
    "(polhode help list)\n" },
} do
  local status, out, err = run('local r = param("r", 1, "m")\n' ..
    'return scene { name = "s", body = solid.sphere { r = r, mass = 1 } }', case[1])
  tap.ok(status == case[2] and out == "" and err:find(case[3], 1, true) == 1,
    "polhode " .. case[1] .. ": status 2 and " .. case[3]:gsub("\n", ""), status .. "\n" .. err)
end
tap.ok(not exists "s", "none of these wrote files")

tap.done(program.finish())
