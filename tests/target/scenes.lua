-- scenes.lua -- make rules from a scene to programs on the machines of machines.lua; flags of all of them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     scenes.source(scene, real, methods)            the emitted NAME.c; beside it NAME.h and NAME_test.c
--     scenes.object(m, compiler, level, source, flags, needs)
--     scenes.program(m, elf, objects)                links
--     scenes.output(m, elf, run)                     runs; the file holds what was printed and `status N`; run: by
--                                                    something else than m.run
--
-- Each returns the file's path and leaves a rule in jobs.lua.

local jobs = require "tests.target.jobs"

local scenes = { dir = "build/target", program_path = os.getenv "POLHODE" or "build/polhode" }

scenes.flags = "-std=c99 -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections"
-- every object waits for these: a change of flags makes all anew
scenes.recipe = { "tests/target/scenes.lua", "tests/target/machines.lua", "generator/cost/cores.lua" }

local function with(list, more)
  local all = table.move(list, 1, #list, 1, {})
  return table.move(more, 1, #more, #all + 1, all)
end

function scenes.source(scene, real, methods, more)
  local name = string.match(scene, "[^/]*$")
  local options = string.gsub((methods and "," .. methods or "") .. (more or ""), "[ ,]+%-*", ".")
  local own = scenes.dir .. "/" .. name .. "." .. real .. options
  local what = "--with analysis" .. ((not methods or string.find(methods, "exact", 1, true)) and ",orbit" or "")
  local all = string.gsub(more or "", "%-%-with ", what .. ",")
  if not string.find(all, "--with", 1, true) then all = all .. " " .. what end
  -- what comes out as it was before keeps its time, and what was built from it stays
  local stamp = jobs.rule(own .. "/stamp", { scenes.program_path, "bodies/" .. scene .. ".lua" },
    string.format("%s gen bodies/%s.lua --layout single --real %s%s%s -o %s/new && for f in " ..
      "%s/new/*; do cmp -s $f %s/${f##*/} || " ..
      "cp $f %s; done && touch %s/stamp", scenes.program_path, scene, real, methods and " --method " .. methods or "",
      all, own, own, own, own, own))
  for _, file in ipairs { ".h", "_test.c" } do jobs.rule(own .. "/" .. name .. file, { stamp }) end
  return jobs.rule(own .. "/" .. name .. ".c", { stamp })
end

local function folder(path) return string.match(path, "^(.*)/") end
local function base(path) return (string.gsub(string.match(path, "[^/]*$"), "%.[^.]*$", "")) end

-- flags: after the common ones; tag: tells objects of one source with other flags apart
function scenes.object(m, compiler, level, source, flags, needs, tag)
  local own = string.match(source, "^" .. scenes.dir) and folder(source) or scenes.dir .. "/" .. base(source)
  local file = string.format("%s/%s.%s%s/%s%s.o", own, m.name, compiler, level, base(source), tag or "")
  return jobs.rule(file, with(with({ source }, scenes.recipe), needs or {}),
    string.format("%s %s %s %s -c -o %s %s", m.compile[compiler], scenes.flags, level, flags or "", file, source))
end

function scenes.program(m, elf, objects, options)
  local all = table.move(objects, 1, #objects, 1, {})
  for _, file in ipairs(m.start) do
    -- loops that clear and copy stay loops: no memset, no memcpy of the C library in firmware
    all[#all + 1] = scenes.object(m, "gcc", "-Os", file, "-std=gnu11 -fno-tree-loop-distribute-patterns")
  end
  return jobs.rule(elf, all, string.format("%s %s %s -lm -o %s", m.link, options or "", table.concat(all, " "), elf))
end

function scenes.output(m, elf, runner)
  local needs, run = { elf }, (runner or m.run) .. " "
  if m.runner then
    local program = scenes.dir .. "/" .. base(m.runner)
    needs[2] = jobs.rule(program, { "tests/target/" .. m.runner },
      string.format("cc -std=gnu11 -O2 -o %s tests/target/%s -lsimavr -l:libelf.so.1", program, m.runner))
    run = run .. program .. " "
  end
  local out = elf .. ".out"
  return jobs.rule(out, needs, string.format("%s%s < /dev/null > %s 2>&1; echo status $? >> %s", run, elf, out, out))
end

return scenes
