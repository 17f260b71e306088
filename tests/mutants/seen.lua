-- seen.lua - which lines each test runs, so that a planted defect meets only tests that can see it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/mutants/seen.lua WORK TIER FILE COMMAND     records one test in WORK/seen
--
--     seen.record(work, tier, tests)    all that are not recorded yet, short ones first, as many at once as there are
--                                       processors; a tree that differs from the recorded one is recorded anew
--     local sees = seen.by(work, tier, tests) -- sees(test, path, line): can the test tell a defect there?  And which
--                                                share of the lines that it runs are of this file
--
-- The tree is copied and built as for `make coverage`: hook.c sees lines of scripts and templates, gcov those of C.
-- A test that fails in this slow build is taken to see everything.  A line on which nothing can stop, such as the
-- middle of a table of C, counts as seen by each test that runs any line of its file.

package.path = "./?.lua;" .. package.path

local lines = require "tests.coverage.lines"

local seen = {}

local function run(...)
  local command = string.format(...)
  return os.execute(command), command
end

local function output(...)
  local pipe = assert(io.popen(string.format(...)))
  local text = pipe:read "a"
  pipe:close()
  return text
end

local function place(work, tier, file) return work .. "/seen/" .. tier .. "__" .. file:gsub("/", "__") end

---- one test -------------------------------------------------------------------------------------------

local MAX_LINES = 4096 -- hook.c's

-- The lines of the scripts and templates that the hook has marked.
local function scripts(folder)
  local of = {}
  for name in output("ls %s", folder):gmatch "[^\n]+" do
    local file = assert(io.open(folder .. "/" .. name, "rb"))
    local bytes, ran = file:read(MAX_LINES) or "", {}
    file:close()
    for line in bytes:gmatch "()\1" do ran[#ran + 1] = line - 1 end
    of[name:gsub("%%", "/")] = ran
  end
  return of
end

local function sources(folder)
  local notes, of = {}, {}
  for counts in output("find %s -name '*.gcda'", folder):gmatch "[^\n]+" do
    local note = counts:gsub("gcda$", "gcno")
    run("ln -sf %s %s", note:sub(#folder + 1), note)
    notes[#notes + 1] = note
  end
  if #notes == 0 then return of end
  for path, its in pairs(lines.c(notes)) do -- any order
    of[path] = {}
    for line, ran in pairs(its) do -- any order
      if ran then table.insert(of[path], line) end
    end
  end
  return of
end

local function record(work, tier, file, command)
  local tree, at = work .. "/seen/tree", place(work, tier, file)
  run("rm -rf %s.d; mkdir -p %s.d/lines %s.d/c", at, at, at)
  local hook = "package.loadlib('" .. tree .. "/build/lua/polhode_coverage.so', 'luaopen_polhode_coverage')()"
  local passed = run('cd %s && LUA_INIT="%s" POLHODE_COVERAGE=%s.d/lines POLHODE_COVERED=%s GCOV_PREFIX=%s.d/c ' ..
    'TMPDIR=%s.d POLHODE_TIER=%s timeout 900 %s >%s.log 2>&1 </dev/null',
    tree, hook, at, tree, at, at, tier, command, at)
  local out = { passed and "passed" or "failed" }
  if passed then
    for _, of in ipairs { scripts(at .. ".d/lines"), sources(at .. ".d/c") } do
      for path, ran in pairs(of) do -- any order: it is read into a table
        out[#out + 1] = path .. " " .. table.concat(ran, " ")
      end
    end
  end
  run("chmod -R u+w %s.d; rm -rf %s.d", at, at)
  local to = assert(io.open(at, "w"))
  to:write(table.concat(out, "\n"), "\n")
  to:close()
end

---- all of them ----------------------------------------------------------------------------------------

function seen.record(work, tier, tests)
  local stamp = output("git ls-files -c generator templates src tests bodies | grep -v '^tests/mutants/' | " ..
    "xargs cat | sha256sum")
  local file = io.open(work .. "/seen/stamp")
  local before = file and file:read "a"
  if file then file:close() end
  if before ~= stamp then
    assert(run("rm -rf %s/seen && mkdir -p %s/seen/tree && cp -a .ci $(git ls-files | sed 's|/.*||' | " ..
      "grep -v '^[.]' | sort -u) %s/seen/tree", work, work, work))
    assert(run("make -s -j$(nproc) -C %s/seen/tree COVERED=tests/coverage/hook.h CFLAGS='-O0 -g --coverage' " ..
      "all tests build/lua/polhode_coverage.so >%s/seen/make.log 2>&1", work, work), "see make.log in the folder seen")
    file = assert(io.open(work .. "/seen/stamp", "w"))
    file:write(stamp)
    file:close()
  end
  local pipe = assert(io.popen("xargs -r -P $(nproc) -d '\\n' -n 4 lua5.4 tests/mutants/seen.lua", "w"))
  table.sort(tests, function(a, b) return a.seconds < b.seconds or a.seconds == b.seconds and a.file < b.file end)
  for _, t in ipairs(tests) do
    local known = io.open(place(work, tier, t.file))
    if known then
      known:close()
    else
      pipe:write(work, "\n", tier, "\n", t.file, "\n", t.command, "\n")
    end
  end
  pipe:close()
end

function seen.by(work, tier, tests)
  local of, any, total = {}, {}, {}
  for _, t in ipairs(tests) do
    local file = io.open(place(work, tier, t.file))
    local passed = file and file:read "l" == "passed"
    if passed then
      of[t.file], total[t.file] = {}, 0
      for text in file:lines() do
        local path, ran = text:match "^(%S+)(.*)$"
        local its = {}
        any[path] = any[path] or {}
        for line in ran:gmatch "%d+" do
          line = tonumber(line)
          its[line], any[path][line] = true, true
        end
        of[t.file][path] = its
        its[0] = select(2, ran:gsub("%d+", ""))
        total[t.file] = total[t.file] + its[0]
      end
    end
    if file then file:close() end
  end
  return function(test, path, line)
    local its = of[test.file]
    if its == nil then return true, 0 end
    its = its[path]
    if its == nil then return false end
    return not (any[path] and any[path][line]) or its[line] == true, its[0]/total[test.file]
  end
end

if arg and arg[0] and arg[0]:find "mutants/seen%.lua$" then record(table.unpack(arg)) end

return seen
