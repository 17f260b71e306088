#!/usr/bin/env lua5.4
-- valgrind.t - no command of the program, and no emitted code, reads what was never written, or beyond its memory.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Memcheck sees what the sanitizers of `make sanitize` do not: values that were never set, down to the single bit,
-- also inside Lua, MPFR and expat.  The scenes are small: everything takes fifty times as long.  Valgrind has long
-- doubles of 64 bits, so numbers of the general library are off here, and a status 1 of `check` says nothing; errors
-- of memory end with 99.  Nothing is suppressed.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"

if program.shell "command -v valgrind >/dev/null 2>&1" ~= 0 then
  tap.skip("memcheck of the program and of emitted code", "needs valgrind (Debian package valgrind)")
  tap.done()
end

local dir = program.directory()
-- without the pool of small blocks; the bounds on a scene's time are for programs that run at full speed
local MEMCHECK = "POLHODE_MALLOC=1 POLHODE_PATIENCE=100 timeout 500 valgrind -q --error-exitcode=99 " ..
  "--leak-check=full --errors-for-leak-kinds=definite "

local function write(name, text)
  program.write(dir .. "/" .. name, text)
end

write("rod.lua", [[return scene { name = "rod", body = solid.cylinder { r = param("r", 1, "m"), h = 3, mass = 2 },
  effects = { effect.damping { rate = 0.1 } }, initial = { omega = {1, 0.5, 3} } }]])
write("box.lua", [[return scene { name = "box",
  body = solid.box { x = param("a", 1, "m"), y = param("b", 2, "m"), z = 3, mass = 2 },
  initial = { omega = {1, 2, 3} } }]])
write("faces.lua", [[return scene { name = "faces", body = mesh { file = "corner.stl", density = 2 },
  initial = { omega = {1, 2, 3} } }]])
write("wrong.lua", "return scene { name = \"wrong\",\n  body = solid.box { x = -1, y = 2, z = 3, mass = 2 } }")
write("broken.lua", "return scene { name = ")
write("link.urdf", [[<robot name="r"><link name="l"><inertial><mass value="2"/>
  <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>]])

-- A tetrahedron; each face seen from outside.
local out = { "solid corner" }
for face in string.gmatch("000 010 100;000 100 001;000 001 010;100 010 001", "[^;]+") do
  out[#out + 1] = "facet normal 0 0 0\nouter loop"
  for x, y, z in face:gmatch "(%d)(%d)(%d)" do out[#out + 1] = string.format("vertex %s %s %s", x, y, z) end
  out[#out + 1] = "endloop\nendfacet"
end
out[#out + 1] = "endsolid corner\n"
write("corner.stl", table.concat(out, "\n"))

-- Status, what was printed, and what memcheck and the program said.
local function memcheck(command)
  local code = program.shell(string.format("p=$PWD/%s; cd %s && CC=%s/cc-O0 %s %s >out 2>err", binary, dir, dir,
    MEMCHECK, (command:gsub("^polhode", "\"$p\""))))
  return code, program.read(dir .. "/out"), program.read(dir .. "/err")
end
program.compiler "-O0" -- writes cc-O0

-- command, status, what its output or message contains
local commands = {
  { "polhode list shapes", 0, "solid.box" },
  { "polhode explain rod.lua", 0, "damping" },
  { "polhode gen rod.lua --method rk4 -o rod", 0, "" },
  { "polhode gen box.lua --real float -o box", 0, "" },
  { "polhode run rod.lua --at 0.5", 0, "wx" },
  { "polhode run rod.lua --engine general --at 0.5", 0, "wx" },
  { "polhode check rod.lua --states 3 --real double", nil, "1.." },
  { "polhode chart box.lua --over a=1:2,b=1:2 -o box.svg", 0, "" },
  { "polhode mesh corner.stl", 0, "volume" },
  { "polhode explain wrong.lua", 1, "wrong.lua:2" },
  { "polhode explain broken.lua", 1, "broken.lua:1" },
  { "polhode explain absent.lua", nil, "absent.lua" },
  { "polhode links link.urdf", 0, "" },
  { "polhode chart rod.lua", nil, "--over" },
}

for _, c in ipairs(commands) do
  local command, status, part = table.unpack(c, 1, 3)
  local code, text, said = memcheck(command)
  local as_wanted = status == nil and code ~= 99 and code < 70 or code == status
  local shown = (text .. said):find(part, 1, true)
  tap.ok(as_wanted and shown and not said:find("==%d+== "), command .. ": memcheck finds nothing",
    "status " .. code .. "\n" .. said:sub(1, 3000))
end

-- What would be found: a sum of a value that was never set decides.
write("unset.c", "int main(int n, char **v) {\n  double x[2];\n  (void)v, x[n > 0] = 1;\n" ..
  "  return x[0] > 0 ? 2 : 0;\n}\n")
tap.is(program.shell(string.format("cd %s && cc -O0 -g -w unset.c -o unset && %s ./unset >out 2>err", dir,
  MEMCHECK)), 99, "memcheck ends with 99 where a value was never set")

-- The emitted code, with its own self-test as a user builds it for a debugger.
for _, name in ipairs { "rod", "box" } do
  local code = program.shell(string.format("cd %s/%s && cc -std=c99 -O1 -g -ffp-contract=off %s*.c " ..
    "-lm -o test >log 2>&1", dir, name, name))
  tap.is(code, 0, name .. ": the emitted code builds")
  local text, said
  code, text, said = memcheck("./" .. name .. "/test")
  tap.ok(code == 0 and text:find "\n1%.%.%d+" and not said:find "==%d+== ",
    name .. ": the self-test passes, memcheck finds nothing",
    "status " .. code .. "\n" .. said:sub(1, 3000))
end

program.finish()
tap.done()
