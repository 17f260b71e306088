#!/usr/bin/env lua5.4
-- slips.t - what people write on a command line by habit, and the message that they get for it.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = io.popen("pwd"):read "l" .. "/" .. binary end

local function run(arguments)
  return program.output(string.format("cd %s && timeout 60 %s %s", dir, binary, arguments))
end

program.write(dir .. "/brick.lua", [[
return scene { name = "own", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 2 }, initial = { omega = {1, 2, 3} } }
]])
program.shell(string.format("cp %s/brick.lua %s/mine.lua && mkdir %s/yours && cp %s/brick.lua %s/yours.lua", dir, dir,
  dir, dir, dir))

-- The whole message, behind `polhode` or `polhode COMMAND`, and the status 2.
for _, row in ipairs {
  { "explain mine", ": cannot read mine: No such file or directory; there is mine.lua" },
  { "explain yours", ": cannot read yours: it is a directory; there is yours.lua" },
  { "explain mine.lua --format tex", " explain: --format must be text, markdown, latex, html, typst, json, urdf, " ..
    "mjcf or sdf, got tex; did you mean latex? (polhode help explain)" },
  { "explain mine.lua -o FILE", " explain: no option -o: the result goes to standard output (add > FILE) " ..
    "(polhode help explain)" },
  { "run mine.lua --columns omega", " run: --columns: the scene has no omega; the angular velocity is w in body " ..
    "axes and omega_inertial in inertial axes (polhode help run)" },
  { "run mine.lua --columns omega_z", " run: --columns: the scene has no omega_z; the angular velocity is wz in " ..
    "body axes and omega_inertial_z in inertial axes (polhode help run)" },
  { "run mine.lua --columns ω", " run: --columns ω: Lua has no ω (U+03C9): names are of the letters a to z, digits " ..
    "and _: write omega (polhode help run)" },
  { "run mine.lua --until 1,5", " run: --until must be a number (decimals have a point: 1.5), got 1,5 " ..
    "(polhode help run)" },
  { "run mine.lua --until 5s", " run: --until must be a number (without its unit: 5), got 5s (polhode help run)" },
  { "run mine.lua --set a=0,5", " run: --set must be NAME=NUMBER (decimals have a point: 0.5), got a=0,5 " ..
    "(polhode help run)" },
  { "run mine.lua -o x.xlsx", " run: -o x.xlsx: run writes CSV or JSON, not xlsx; name it .csv, which " ..
    "spreadsheets open (polhode help run)" },
  { "run mine.lua -o x.json", " run: -o x.json: its name says JSON, and it would have CSV (--format json) " ..
    "(polhode help run)" },
  { "help cylinder", " help: no command \"cylinder\"; there is solid.cylinder, shell.cylinder (polhode help)" },
} do
  local status, out, err = run(row[1])
  tap.ok(status == 2 and out == "" and err == "polhode" .. row[2] .. "\n", row[1], err)
end
tap.ok(program.shell("test -e " .. dir .. "/x.xlsx") ~= 0, "no file of a wrong kind is written")

do
  local status, out, err = run "explain brick"
  tap.ok(status == 0 and out:find("^brick %(") and err:find("note: brick is the installed scene; that of this " ..
    "folder is brick.lua\n", 1, true), "an installed scene beside a file of that name: which one it is", err)
  local _, whole = run "help effect.gravity"
  status, out, err = run "help gravity"
  tap.ok(status == 0 and err == "" and out == whole and #out > 100, "help gravity is that of effect.gravity", err)
  status, out, err = run "run mine.lua --until 1 --every 1 --format json -o x.json"
  tap.ok(status == 0 and out == "" and err == "" and program.read(dir .. "/x.json"):find "^{",
    "JSON in a file that says so", err)
end

program.finish()
tap.done()
