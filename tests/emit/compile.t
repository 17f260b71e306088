#!/usr/bin/env lua5.4
-- compile.t - the emitted code of every body, and of scenes that are hard, keeps its promises to compiler and linker.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- In double and float, with parameters and with --bake (bodies by turns): C99 by gcc or clang, g++ as
-- C++11, all warnings errors; the self-test passes; text and objects are as tests/promises/judge.lua wants them: no
-- data that may change, no foreign function, float is float; and under address and undefined-behaviour sanitizers, with
-- division of floats by zero, the self-test and a walk along the edges of the valid (exercise.lua) find nothing.
-- The quick tier takes three scenes; of the bodies that have no kind of their own every second pair is tried, and
-- POLHODE_COMPILE=all tries each (tests/promises/projects.t compiles every body).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local exercise = require "tests.emit.exercise"
local judge = require "tests.promises.judge"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

-- The scenes beside bodies/: one hard thing each.
local hard = {
  ball = 'body = solid.sphere { r = param("r", 2, "m"), density = 3 }, initial = { omega = {1, 2, 3} }',
  still = 'body = solid.box { x = 1, y = 2, z = 3, mass = param("M", 1, "kg") }',
  pendulum = [[body = rod.between { from = {0, 0, 0}, to = {1, 2, 3}, mass = param("M", 2, "kg") },
    origin = {0, 0, 0}, effects = { effect.gravity{} }, initial = { omega = {2, -1, 0} }]],
  spinning_cone = [[body = solid.cone { r = param("r", 0.05, "m"), h = 0.1, mass = 1 }:turned{axis = "x", angle = pi},
    origin = "apex", effects = { effect.gravity{}, effect.damping{ c = param("c", 1e-5, "N m s") } },
    initial = { omega = {0, 0.3, 40}, attitude = { axis = "y", angle = 0.3 } }]],
  driven = [[body = solid.box { x = param("a", 1, "m"), y = 2, z = 3, mass = 4 }, origin = "corner",
    effects = { effect.control{ max = param("limit", 2, "N m") }, effect.damping{ rate = 0.1 },
      effect.torque{ inertial = { param("n", 1, "N m"), 0, 2 } },
      effect.damping{ c = {{1, 2, 3}, {0, 1, 2}, {0, 0, 1}} } },
    initial = { omega = {1, 2, 3} }]],
  pushed = [[body = solid.box { x = 1, y = 2, z = 3, mass = 4 },
    effects = { effect.torque{ inertial = { param("n", 2, "N m"), 1, 3 } } }, initial = { omega = {1, 2, 3} }]],
  huge = [[body = tensor { mass = 1, xx = 1e30, yy = 2e30, zz = 2.5e30, xy = 1e29 },
    initial = { omega = {1e-20, 2e-20, 0} }, time = { horizon = 1e21, step = 1e18 }]],
  tiny = [[body = tensor { mass = 1, xx = 1e-30, yy = 2e-30, zz = 2.5e-30, yz = 1e-31 },
    initial = { omega = {1e10, 2e10, 1} }, time = { horizon = 1e-9, step = 1e-12 }]],
  far = [[body = solid.box { x = param("a", 1, "m"), y = 1, z = 1, mass = 1 }, origin = {2^30, 0, 0},
    initial = { omega = {1, 2, 3} }]],
  near_symmetric = [[body = tensor { mass = 1, xx = 1, yy = exact("1.00000000000000000001"), zz = 1.5 },
    initial = { omega = {1, 2, 3} }]],
  lamina = [[body = plate.rectangle { x = param("a", 1, "m"), y = 2, mass = 1 }:turned{axis = {1, 2, 3}, angle = 1},
    initial = { omega = {1, 2, 3} }]],
  -- plane, and no entry of its tensor is a rational: what cancels in the Jacobian must not leave 1e-72
  crescent = "body = wire.arc { r = 2, angle = 2, mass = 1 }, initial = { omega = {1, 2, 3} }",
  -- names that the emitted functions use themselves
  words = [[body = solid.box { x = param("x", 1, "m"), y = param("h", 2, "m"), z = param("t", 3, "m"),
      mass = param("m", 4, "kg") }, origin = "corner",
    effects = { effect.damping{ c = param("u", 1e-3, "N m s") }, effect.gravity{ g = param("k", 9.8, "m/s^2") } },
    initial = { omega = { param("p", 1, "rad/s"), param("n", 2, "rad/s"), param("result", 3, "rad/s") } }]],
  -- a composite body whose parameters are called like what NAME_init and NAME_sort_moments call something
  taken = [[body = solid.box { x = param("s1", 0.3, "m"), y = param("value_D", 0.2, "m"), z = param("gap", 0.05, "m"),
      density = 3000 } - solid.cylinder { r = param("S", 0.01, "m"), h = param("m1", 0.02, "m"),
      mass = param("mass", 1e-3, "kg") }:at{param("check1", 0.02, "m"), 0, 0} +
      solid.sphere { r = param("r1", 0.02, "m"), mass = param("D", 1, "kg") }:at{0, param("order", 0.1, "m"), 0},
    initial = { omega = {1, 2, 3} }]],
}

-- Too far out for float: products of a tensor of 1e30 with rates of 1e-20 leave its range.
local double_only = { huge = true, tiny = true }

-- The bodies for the sanitizers: one of each closed form and of each kind of state.
local one_of_a_kind = { brick = true, symmetric_top = true, bracket = true, gyroscope = true, heavy_top = true,
  foucault = true, thrown_book = true, damped_brick = true, gyrostat = true }

local ALL = os.getenv "POLHODE_COMPILE" == "all"
local QUICK = { brick = true, driven = true, words = true }

local scenes = {}
do
  local pipe = assert(io.popen "ls bodies/*.lua")
  for path in pipe:lines() do scenes[#scenes + 1] = { name = path:match "([%w_]+)%.lua$", path = path, body = true } end
  pipe:close()
  local names = {}
  for name in pairs(hard) do names[#names + 1] = name end
  table.sort(names)
  for _, name in ipairs(names) do
    local path = string.format("%s/%s.lua", dir, name)
    program.write(path, "-- " .. name .. "\nreturn scene { name = \"" .. name .. "\",\n  " .. hard[name] .. " }\n")
    scenes[#scenes + 1] = { name = name, path = path }
  end
  local kept = {}
  for _, s in ipairs(scenes) do
    if not tier.quick or QUICK[s.name] then kept[#kept + 1] = s end
  end
  scenes = kept
end

-- ---- the work on one directory, as a shell script: each line of its output is a check that failed ----

program.write(dir .. "/one.sh", [[
#!/bin/sh
# one.sh DIRECTORY NAME LEVEL SANITIZE C++ COMPILER...   LEVEL: gcc's; clang's warnings do not depend on it, what it
# makes of loops is seen where it is alone
cd "$1" || exit 1
name=$2 gcc=$3 sanitize=$4 plus=$5
shift 5
warn="-pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off"
failed() { echo "$1" >>failed; [ -f log ] && head -n 12 log >>failed; }
for cc in "$@"; do
  level=$gcc
  [ $cc = clang ] && level=-O1 && [ $# = 2 ] && level=-O0
  $cc -std=c99 $level $warn -c $name.c -o $name-$cc.o 2>log || failed "$cc compiles the code"
  $cc -std=c99 -O0 $warn -c ${name}_test.c -o test-$cc.o 2>log || failed "$cc compiles the self-test"
  $cc test-$cc.o $name-$cc.o -lm -o test-$cc 2>log || failed "$cc links"
  ./test-$cc >log 2>&1 || { grep -B3 '^not ok' log >log2; mv log2 log; failed "$cc: the self-test passes"; }
  tail -n 1 log | grep -q '^1\.\.[1-9]' || failed "$cc: the self-test has a plan"
  nm $name-$cc.o >$name-$cc.nm
done
[ $plus = yes ] && for f in $name.c ${name}_test.c; do
  g++ -std=c++11 -x c++ $warn -fsyntax-only $f 2>log || failed "g++ takes $f as C++11"
done
if [ $sanitize = yes ]; then
  san="-fsanitize=address,undefined,float-divide-by-zero -fno-sanitize-recover=all"
  gcc -std=c99 -O0 $san -c $name.c -o san.o 2>log || failed "builds with sanitizers"
  gcc -std=c99 -O0 $san san.o ${name}_test.c -lm -o test-san 2>log || failed "the self-test builds with sanitizers"
  ./test-san >log 2>&1 || {
    grep -E -A4 '^not ok|runtime error|ERROR' log >log2
    mv log2 log
    failed "sanitizers: the self-test"
  }
  gcc -std=c99 -O0 $san san.o exercise.c -lm -o exercise 2>log || failed "the exercise builds"
  ./exercise >log 2>&1 || failed "sanitizers: the edges of the valid"
fi
: >>done
exit 0
]])

local jobs, list = {}, {}
for i, s in ipairs(scenes) do
  for _, real in ipairs { "double", "float" } do
    for _, bake in ipairs { false, true } do
      -- both compilers and C++ on every body, with more warnings, but no level: tests/promises/projects.t
      local wide = not s.body or one_of_a_kind[s.name]
      -- hard scenes without --bake; of the other bodies one variant is enough: double, or float and baked, by turns
      local wanted
      if not s.body then
        wanted = not bake and not (real == "float" and double_only[s.name])
      elseif wide then
        wanted = bake == (real == "float")
      else
        wanted = bake == (real == "float") and bake == (i % 2 == 0) and (ALL or i % 4 < 2)
      end
      if not wanted then goto continue end
      local where = string.format("%s/%s-%s%s", dir, s.name, real, bake and "-bake" or "")
      local code = program.shell(string.format("%s gen %s --layout single --with analysis,orbit --real %s %s -o %s " ..
        "2>%s.err", binary, s.path, real,
        bake and "--bake" or "", where, where))
      local name = s.name .. ", " .. real .. (bake and ", baked" or "")
      if code == 0 then
        -- sanitizers in double, of bodies those of one kind each
        local sanitize = wide and real == "double" and not bake
        local compilers = bake and "clang" or (real == "float" or not wide) and "gcc" or "gcc clang"
        -- some of gcc's warnings come with its analysis of -O2, for which one of each kind is enough
        local level = s.body and sanitize and "-O2" or "-O1"
        local header = program.read(where .. "/" .. s.name .. ".h")
        program.write(where .. "/exercise.c", exercise.text(s.name, header))
        jobs[#jobs + 1] = { where = where, name = name, scene = s, real = real, bake = bake, sanitize = sanitize,
          compilers = compilers }
        list[#list + 1] = string.format("%s %s %s %s %s %s", where, s.name, level, sanitize and "yes" or "no",
          wide and "yes" or "no", compilers)
      else
        local why = program.read(where .. ".err") or ""
        tap.ok(code == 1 and real == "float" and why:find("constant", 1, true),
          name .. ": refused, because float cannot hold its constants", "status " .. code .. "\n" .. why)
      end
      ::continue::
    end
  end
end

program.write(dir .. "/list", table.concat(list, "\n") .. "\n")
program.shell("xargs -L 1 -P 2 sh " .. dir .. "/one.sh <" .. dir .. "/list")

local CHECKS = "compiles as C99 and C++11, self-test passes, no data, no foreign symbol"
for _, job in ipairs(jobs) do
  local failed = program.read(job.where .. "/failed")
  local base = job.where .. "/" .. job.scene.name
  local p = { name = job.scene.name, real = job.real, own = job.real == "float", header = program.read(base .. ".h"),
    source = program.read(base .. ".c") }
  local faults = judge.text(p)
  for cc in string.gmatch(job.compilers, "%S+") do
    -- as without optimisation: math.h's errno leaves a call of the root
    table.move(judge.symbols(program.read(base .. "-" .. cc .. ".nm") or "", p, "-O0"), 1, 99, #faults + 1, faults)
  end
  if #faults > 0 then failed = (failed or "") .. table.concat(faults, "\n") end
  tap.ok(not failed and program.read(job.where .. "/done"), job.name .. ": " .. CHECKS ..
    (job.sanitize and ", clean under sanitizers" or ""), failed or "the script did not end")
end

-- ---- the emitted Makefile ----

do
  local where = dir .. "/brick-double"
  local code = program.shell("cd " .. where .. " && make check CC=gcc >log 2>&1 && grep -q '^ok 1' log && " ..
    "make clean >>log 2>&1 && test ! -e brick_test -a ! -e brick.o")
  tap.is(code, 0, "the emitted Makefile builds, checks and cleans")
  code = program.shell("cd " .. where .. " && make promises CC=gcc >log 2>&1 && test ! -e promises.o")
  tap.is(code, 0, "and shows what the object needs and keeps")
  program.write(where .. "/brick.c", program.read(where .. "/brick.c") .. "int brick_mode = 3;\n")
  tap.ok(program.shell("cd " .. where .. " && make promises CC=gcc >log 2>&1") ~= 0,
    "which fails with data that changes")
end

program.finish()
tap.done()
