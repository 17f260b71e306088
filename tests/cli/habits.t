#!/usr/bin/env lua5.4
-- habits.t: slips in one line, - for standard input and output, scenes by name, missing compilers, installation.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local quick = program.quick_compiler()

-- Runs the program in a folder of the test's own; before: of the environment; after: redirections.
local function run(arguments, before, after)
  local status = program.shell(string.format("cd %s && env %s timeout 120 %s %s >stdout 2>stderr %s", dir,
    before or quick, binary, arguments, after or "</dev/null"))
  return status, program.read(dir .. "/stdout"), program.read(dir .. "/stderr")
end

-- A stone in a turning frame, whose code compiles in no time and calls sine and cosine; a brick where it must turn.
local STONE = [[
local a = param("a", 0.2, "m/s^2")
return scene { name = "s", body = solid.sphere { r = 1, mass = 1 }, initial = { position = {0, 0, 1} },
  effects = { effect.translation { gravity = a }, effect.rotating_frame { rate = {0, 1, 1} } }, time = { horizon = 1 } }
]]
local BRICK = [[
return scene { name = "b", body = solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 1 }, initial = { omega = {1, 2, 3} } }
]]
program.write(dir .. "/s.lua", STONE)
program.write(dir .. "/b.lua", BRICK)

-- ---- slips ----

-- What the program says of its command line, or, where it is not that of a command, the whole line.
for _, case in ipairs {
  { "gne s.lua", 'polhode: no command "gne"; did you mean gen? (polhode help)' },
  { "help explian", 'polhode help: no command "explian"; did you mean explain? (polhode help)' },
  { "--version x", "polhode: too many operands: x (polhode help)" },
  { "gen gyroscop", "polhode: cannot read gyroscop: No such file or directory, and no installed scene has that " ..
    "name; did you mean gyroscope? (polhode list bodies)" },
  { "gen s.lua --set aa=1", "polhode: --set aa: the scene has no such parameter (it has a)" },
  { "gen s.lua --reel float", "no option --reel; did you mean --real?" },
  { "sweep s.lua --grid a=1:2:3", "no option --grid; did you mean --over?" },
  { "gen s.lua --output x", "no option --output; did you mean -o?" },
  { "check s.lua --grid a", "no option --grid" }, -- a word of other programs for what this command has not
  { "gen s.lua --real flaot", "--real must be double or float, got flaot; did you mean float?" },
  { "gen s.lua --method rk5", "--method must be some of exact, rk4, adaptive, taylor, rosenbrock, midpoint, semi, " ..
    "split2, " ..
    "split4, split6, linearised, got rk5; did you mean rk4?" },
  { "gen s.lua --method rk4,rk4", "--method: rk4 stands there twice" },
  { "gen s.lua --project sweep", "--project sweep: what is varied has to be said; `polhode sweep SCENE " ..
    "--over ... --emit DIR` writes that program" },
  { "gen s.lua --project zefyr", "--project must be make, cmake, arduino, platformio, zephyr, firmware, fmu or " ..
    "python, got zefyr; did you mean zephyr?" },
  { "gen s.lua --target cortex-m4", "--target must be all or some of cortex-m0, cortex-m3, cortex-m4f, cortex-m7, " ..
    "rv32imac, rv32imafc, avr, got cortex-m4; did you mean cortex-m4f?" },
  { "gen s.lua --with q31,prof", "--with must be analysis, orbit, attitude, batch, jacobians, compensated, proof, " ..
    "q31 or estimator, got prof; did you mean proof?" },
  { "gen s.lua --with q31,q31", "--with: q31 stands there twice" },
  { "gen s.lua --set a=1 --set a=2", "--set a is given twice" },
  { "gen s.lua --real float --real float", "--real is given twice" },
  { "gen s.lua -o ''", "-o must not be empty, got nothing" },
  { "gen s.lua -o -", "-o must be the name of a folder, as gen writes several files, got -" },
  { "gen s.lua --show order -o x", "-o: --show prints and writes no files" },
  { "run s.lua --method adaptiv", "--engine general has the methods adaptive, taylor, rk4, gsl-rk4, rkf45, rk8pd, " ..
    "implicit, exact, linearised, got adaptiv; did you mean adaptive?" },
  { "run s.lua --engine generated --method tailor", "--engine generated has the methods exact, rk4, adaptive, " ..
    "taylor, rosenbrock, midpoint, semi, split2, split4, split6, got tailor; did you mean taylor?" },
  { "run s.lua --step 0", "--step must be positive, got 0.0" },
  { "run s.lua --tolerance 1", "--tolerance must be from 1e-19 to 0.1, got 1.0" },
  { "run s.lua --method rk4 --tolerance 1e-3", "--tolerance: the method rk4 has a fixed step" },
  { "run s.lua --method exact --step 1e-3", "--step: the method exact has no steps" },
  { "run s.lua --engine generated --method exact --step 1e-3", "--step: the method exact has no steps" },
  { "run s.lua --step 1 --tolerance 1e-3", "--step and --tolerance exclude each other" },
  { "run s.lua --real float", "--real: it is the type of the emitted code (--engine generated), got --engine general" },
  { "run s.lua --until 1e400", "--until must be within the range of double, got 1e400" },
  { "run s.lua --at 1,1e400", "--at must be within the range of double, got 1,1e400" },
  { "run ''", "SCENE must not be empty" },
  { "check s.lua --states 0.5", "--states must be a whole number from 1 to 1000000, got 0.5" },
  { "explain --diff s.lua s.lua --real float", "--real: a difference is of expressions, before they have a type" },
  { "explain s.lua --real float --format sdf", "--real: --format sdf has no costs" },
  { "list efects", "must be shapes, effects, methods, bodies, constants or commands, got efects; did you mean " ..
    "effects?" },
  { "mesh -", "the format of a mesh is told by the end of its file's name, so it cannot come from standard input" },
} do
  local name, want = case[1]:match "^%S+", case[2]
  if not want:find "^polhode" then want = "polhode " .. name .. ": " .. want .. " (polhode help " .. name .. ")" end
  local status, out, err = run(case[1])
  tap.ok(status == 2 and out == "" and err == want .. "\n", "polhode " .. case[1] .. ": one line, status 2",
    status .. "\n" .. out .. err)
end
tap.is(program.shell("ls " .. dir .. "/s " .. dir .. "/x >/dev/null 2>&1"), 2, "none of them wrote files")

-- ---- standard input and output ----

do
  local _, want = run "explain s.lua"
  local status, out, err = run("explain -", nil, "<s.lua")
  tap.ok(status == 0 and err == "" and out == want:gsub("s%.lua", "stdin"), "explain - reads standard input", err)
  _, want = run "run s.lua --at 1"
  status, out = run("run - --at 1 -o -", nil, "<s.lua")
  tap.ok(status == 0 and out == want, "run - -o - is a filter")
  _, want = run "chart b.lua --linearised"
  status, out = run("chart - --linearised -o -", nil, "<b.lua")
  tap.ok(status == 0 and out == want and out:find("<svg", 1, true) == 1, "chart - -o - is one")
  status, out, err = run("check - --states 1", nil, "<s.lua")
  tap.ok(status == 0 and out:find("s, double", 1, true) and out:find("s, float", 1, true),
    "check - reads it once, for double and float", out .. err)
  tap.ok(out:find("over 1 states and 1 sets", 1, true), "--states 1 compares one state", out)
  status, out, err = run("explain -", nil, "<<'END'\nreturn scene { name = 's', body = solid.box { x = -1 } }\nEND")
  tap.ok(status == 1 and out == "" and err:find("stdin:1: box: x must be positive, got -1", 1, true) == 1,
    "messages call it stdin", err)
  status, _, err = run("explain -", nil, "</")
  tap.ok(status == 2 and err == "polhode: cannot read standard input: Is a directory\n", "what cannot be read is said",
    err)
  program.write(dir .. "/r.urdf", '<robot name="r"><link name="a"/></robot>')
  status, out = run("links -", nil, "<r.urdf")
  tap.ok(status == 0 and out == "URDF: 1 link, 0 with <inertial>: 0 wrong, 0 with a warning; 1 static\n",
    "links - reads it too", out)
  program.write(dir .. "/f.lua", 'return scene { name = "f", body = inertial { file = "-" } }')
  status, out, err = run("explain f.lua", nil, "<r.urdf")
  tap.ok(status == 1 and out == "" and err:find("f.lua:1: inertial: cannot read ./-: No such file", 1, true) == 1,
    "a scene that names the file - does not get it", err)
end

-- ---- programs that are not there ----

local NOSUCH = "cannot run the C compiler nosuch: No such file or directory (set CC, or install the packages gcc " ..
  "and libc6-dev)\n"
for _, case in ipairs { { "run s.lua --engine generated --at 1", "run: " }, { "check s.lua", "check: " },
  { "bench s.lua --method rk4 --no-peers", "bench: " }, { "gen s.lua --accuracy 1e-3", "gen: " },
  { "gen s.lua --project fmu", "gen: " }, { "gen s.lua --real float --target cortex-m4f", "gen: --target: " },
  { "explain s.lua --real float --target cortex-m0", "explain: --target: " } } do
  local crossed = program.shell "command -v arm-none-eabi-gcc qemu-system-arm >/dev/null 2>&1" == 0
  if case[1]:find "target" and not crossed then -- then these are missed, too
    tap.skip("polhode " .. case[1] .. " without a compiler", "no cross compiler here (.ci/setup target)")
    goto continue
  end
  local status, out, err = run(case[1], "CC=nosuch XDG_CACHE_HOME=" .. dir)
  tap.ok(status == 2 and err == "polhode " .. case[2] .. NOSUCH and not out:find("not ok", 1, true),
    "polhode " .. case[1] .. " without a compiler: status 2 and the packages", status .. "\n" .. out .. err)
  ::continue::
end
do
  local status, out, err = run("check s.lua", "CC=false")
  tap.ok(status == 2 and out == "TAP version 13\nBail out! No C compiler.\n" and
    err == "polhode check: the C compiler cannot compile a function that includes <math.h> (set CC, or install the " ..
      "packages gcc and libc6-dev)\n", "a compiler that compiles nothing is none", status .. out .. err)
  -- a folder with a C compiler and what it calls, and nothing else
  program.shell("cd " .. dir .. " && mkdir bin && for p in timeout cc as ld; do ln -s $(command -v $p) bin/; done")
  status, out, err = run("gen s.lua --real float --target cortex-m4f", "PATH=" .. dir .. "/bin CC=cc")
  tap.ok(status == 2 and out == "" and err == "polhode gen: --target needs arm-none-eabi-gcc, qemu-system-arm, " ..
    "<math.h> of arm-none-eabi-gcc, not found here; on Debian: apt-get install --no-install-recommends " ..
    "gcc-arm-none-eabi qemu-system-arm libnewlib-arm-none-eabi\n",
    "without a cross compiler: status 2 and the packages", status .. out .. err)
end

-- ---- the installed program ----

do
  local build = binary:match "^(.*)/[^/]*$"
  local status = program.shell(string.format("make -s -o all install BUILD=%s DESTDIR=%s/made PREFIX=/opt/p >%s/log " ..
    "2>&1", build, dir, dir))
  tap.ok(status == 0, "make install", program.read(dir .. "/log"))
  program.shell(string.format("mv %s/made/opt/p %s/moved && mkdir %s/elsewhere", dir, dir, dir))
  for _, name in ipairs { "bin/polhode", "lib/libpolhode.a", "include/polhode.h", "share/polhode/bodies/wheels.lua",
    "share/doc/polhode/README.md", "share/doc/polhode/docs/shapes.md", "share/doc/polhode/docs/shapes/solid.box.svg",
    "share/doc/polhode/LICENSE" } do
    tap.ok(program.read(dir .. "/moved/" .. name), "it brings " .. name)
  end
  local function installed(arguments, before)
    local code = program.shell(string.format("cd %s/elsewhere && env -u POLHODE_BODIES %s ../moved/bin/polhode %s " ..
      ">../stdout 2>../stderr", dir, before or "", arguments))
    return code, program.read(dir .. "/stdout"), program.read(dir .. "/stderr")
  end
  local _, here, out, err
  status, out, err = installed "list bodies"
  _, here = run("list bodies", "POLHODE_BODIES=" .. root .. "/bodies")
  tap.ok(status == 0 and err == "" and out == here and out:find "\nwheels ", "list bodies, after a move", err)
  status, out, err = installed "gen dropped_stone"
  tap.ok(status == 0 and out .. err == "" and program.read(dir .. "/elsewhere/dropped_stone/dropped_stone.h"),
    "gen dropped_stone", err)
  status = installed "explain dropped_stone"
  tap.is(status, 0, "the folder dropped_stone that this made is not taken for the scene")
  program.write(dir .. "/elsewhere/brick", STONE)
  _, out = installed "explain brick"
  tap.ok(out:find("s (brick)", 1, true) == 1, "a file goes before an installed scene of its name", out:sub(1, 40))
  program.shell(string.format("mkdir %s/own && cp %s/s.lua %s/own/mine.lua", dir, dir, dir))
  _, out = installed("list bodies", "POLHODE_BODIES=../own")
  tap.like(out, "^mine +[^\n]*\n$", "POLHODE_BODIES names another folder", true)
  -- a scene that names a file beside it
  program.write(dir .. "/moved/share/polhode/bodies/arm.lua",
    'return scene { name = "arm", body = inertial { file = "arm.urdf" } }')
  program.write(dir .. "/moved/share/polhode/bodies/arm.urdf", '<robot name="r"><link name="a"><inertial>' ..
    '<mass value="2"/><inertia ixx="1" iyy="2" izz="2" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>')
  status, out, err = installed "explain arm"
  tap.ok(status == 0 and out:find("arm.lua", 1, true), "a scene by name finds the files that it names", err)
end

-- ---- how the emitted README says the code is linked ----

program.write(dir .. "/main.c", '#include "s.h"\nint main(void) { s_model m; s_real x[S_NX]; ' ..
  "if (s_init(&m, 0) != 0) return 1; s_initial(&m, x); s_step(&m, 0, x, 0, (s_real)0.001); return !(x[2] > 0); }\n")
for _, case in ipairs { { "double", true }, { "float", false }, { "double --libm own", false },
  { "float --libm system", true } } do
  local name = (case[1]:gsub("%W+", "_"))
  run("gen s.lua --real " .. case[1] .. " -o " .. name)
  local readme = program.read(dir .. "/" .. name .. "/README.md") or ""
  local line = readme:match "\n    (cc [^\n]*main%.c[^\n]*)\n" or "false"
  local function linked(command)
    local where = "cd " .. dir .. "/" .. name
    return program.shell(where .. " && cp ../main.c . && " .. command .. " -o main >log 2>&1 && ./main")
  end
  tap.is(linked(line), 0, "README.md of --real " .. case[1] .. " has a line that compiles and links")
  tap.is(line:find " %-lm$" ~= nil, case[2], "with -lm: " .. tostring(case[2]))
  tap.is(linked((line:gsub(" %-lm$", ""))) ~= 0, case[2], "which is needed there: " .. tostring(case[2]))
end

tap.done(program.finish())
