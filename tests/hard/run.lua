-- run.lua -- runs the hard cases, prints their table, draws their map.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/hard/run.lua PROGRAM DIRECTORY [PATTERN] [PAGE.md MAP.svg]
--     POLHODE_HARD=FILE lua5.4 ...      only that file of cases
--
-- The cases run inside the program, two files at a time, each file in a process of its own; the bounds on a scene's
-- time (docs/sandbox.md) are not what is tested here.  Exit status 1 when a bound is exceeded.  Needs build/oracle/*
-- (make tests).

package.path = "./?.lua;" .. package.path

local catalogue = require "tests.hard.catalogue"
local judge = require "tests.hard.judge"

local run = {}

local function quote(s) return "'" .. string.gsub(s, "'", "'\\''") .. "'" end

-- A tree whose generator is ours, whose main.lua is the host test's, and which has tests/hard as generator.hard.
local function tree(directory)
  assert(os.execute(string.format("d=%s; rm -rf $d; mkdir -p $d/generator && ln -s $PWD/templates $d/templates && " ..
    "ln -s $PWD/generator/* $d/generator && rm $d/generator/main.lua && ln -s $PWD/tests/hard $d/generator/hard && " ..
    "cp tests/cli/tree/generator/main.lua $d/generator", quote(directory .. "/tree"))))
end

-- speed: "fast" or "all"; pattern of names; list of files.  Results by name, as judge.read has them.
function run.cases(program, directory, speed, pattern, files)
  tree(directory)
  local jobs = {}
  for _, name in ipairs(files) do
    jobs[#jobs + 1] = string.format("POLHODE_PATIENCE=10 POLHODE_SOURCE=%s timeout -k 5 1800 %s " ..
      "tests/hard/worker.lua %s %s %s >%s 2>%s",
      quote(directory .. "/tree"), quote(program), speed, quote(pattern), name,
      quote(directory .. "/" .. name .. ".rows"), quote(directory .. "/" .. name .. ".err"))
  end
  local list = assert(io.open(directory .. "/jobs", "w"))
  list:write(table.concat(jobs, "\n"), "\n")
  list:close()
  os.execute(string.format("xargs -P 2 -d '\\n' -I {} sh -c '{ {}; } || true' <%s", quote(directory .. "/jobs")))
  local results = {}
  for _, name in ipairs(files) do
    for line in io.lines(directory .. "/" .. name .. ".rows") do judge.read(results, line) end
    for line in io.lines(directory .. "/" .. name .. ".err") do io.stderr:write(name, ": ", line, "\n") end
  end
  return results
end

local function main(program, directory, pattern, page, map)
  local only = os.getenv "POLHODE_HARD"
  local files = only and { only } or catalogue.files
  local hard = catalogue.load(files)
  local results = run.cases(program, directory, "all", pattern, files)
  local faults, count, worst = {}, 0, { ratio = 0 }
  print(string.format("%-44s %8s %8s %9s  %s", "case, errors over their bounds", "double", "float", "naive", "worst"))
  for _, file in ipairs(hard) do
    for _, case in ipairs(file.cases) do
      if string.find(case.name, pattern) then
        local v = judge.case(case, results[case.name])
        local w = v.worst.all or { who = "nobody", real = "", ratio = math.huge, bound = 1 }
        local function ratio(real) return v.worst[real] and string.format("%.2g", v.worst[real].ratio) or "-" end
        count = count + 1
        if w.ratio >= worst.ratio then worst = { ratio = w.ratio, name = case.name } end
        for _, f in ipairs(v.faults) do faults[#faults + 1] = f end
        print(string.format("%-44s %8s %8s %9s  %s", case.name, ratio "double", ratio "float",
          string.format("%.2g", ((results[case.name] or {}).naive or 0) / (v.worst.double or w).bound),
          w.who .. " " .. w.real))
        case.verdict, case.result = v, results[case.name]
      end
    end
  end
  print(string.format("%d cases; the worst error is %.2g of its bound: %s", count, worst.ratio, tostring(worst.name)))
  if page then
    require("tests.hard.page")(hard, page, map)
  end
  for _, f in ipairs(faults) do print("FAULT " .. f) end
  os.exit(#faults == 0 and 0 or 1)
end

if arg and string.find(arg[0], "run.lua", 1, true) then main(arg[1], arg[2], arg[3] or "", arg[4], arg[5]) end

return run
