-- laws.lua -- the laws by which errors grow with the number of steps: measured, fitted, and put beside what theory
-- says.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/bench/laws.lua PROGRAM LIBRARY DIRECTORY [PAGE.md PICTURE.svg]
--
-- laws_runs.lua lists the runs, laws.c measures them (two at a time), laws_fit.lua fits exponents and their standard
-- errors, laws_page.lua writes the page between its marks and the picture.

package.path = "./?.lua;" .. package.path

local build = require "tests.bench.laws_build"
local fit = require "tests.bench.laws_fit"
local runs = require "tests.bench.laws_runs"
local page = require "tests.bench.laws_page"

local program, library, dir = arg[1], arg[2], arg[3]

assert(os.execute("mkdir -p " .. dir))
local list, gains = runs.list(), runs.pairs()
local count = #list
table.move(gains, 1, #gains, count + 1, list)
build.all(program, library, dir, list)

-- Each run's output in a file of its own; those that are there are kept, so that an interrupted measurement goes on.
local jobs = assert(io.open(dir .. "/jobs", "w"))
for i, r in ipairs(list) do
  r.out = string.format("%s/%s_%d_%.6g_%d", r.folder, "out", r.row, r.h, r.steps)
  jobs:write(string.format("test -s %s || { %s/laws %d %.17g %d %d > %s.part && mv %s.part %s; } # %d\n", r.out,
    r.folder,
    r.row, r.h, r.steps, r.members, r.out, r.out, r.out, i))
end
jobs:close()
assert(os.execute(string.format("xargs -P 2 -d '\\n' -n 1 sh -c < %s/jobs", dir)))

for i, r in ipairs(list) do
  r.points = build.read(r.out)
  fit.run(r, r.points)
  if i > count then r.operations, list[i] = build.operations(program, r), nil end
end
page.write(list, gains, arg[4], arg[5])
