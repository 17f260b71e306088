-- mutants.lua - plants defects one at a time and looks which tests see them: `make mutants`, docs/mutants.md.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/mutants/mutants.lua BUILD COUNT SEED PAGE SPEND [quick]
--
-- In a copy of the tree, BUILD/mutants/SEED/tree, a third of the defects each in generator/, templates/ and src/; the
-- same SEED plants the same ones in the same tree, and several may run at once.  What cannot be built, or of which the
-- compiler makes the same, is no defect: another is drawn.  Each is met by the quick tests that run its line
-- (seen.lua), until one fails or SPEND seconds of them have passed; a test that takes more than a third of that is not
-- asked.  What they let pass meets the others of make check-all that run it (quick: those that are near its file by
-- name, and those of make check-target).  What each test did is kept in the file BUILD/mutants/SEED.log: a run that was
-- stopped goes on there, one with more to SPEND asks more tests.

package.path = "./?.lua;" .. package.path

local sites = require "tests.mutants.sites"
local order = require "tests.mutants.order"
local seen = require "tests.mutants.seen"
local page = require "tests.mutants.page"

local build, count, seed, to, spend = arg[1], tonumber(arg[2]), tonumber(arg[3]), arg[4], tonumber(arg[5])
local alone_quick = arg[6] == "quick"
io.stdout:setvbuf "line"

-- A whole number in [1, n] (Park and Miller's generator with 48271).
local state = 16807*seed % 2147483647
local function random(n)
  state = state*48271 % 2147483647
  return state*n // 2147483647 + 1
end

local here = io.popen("pwd"):read "l"
if build:sub(1, 1) ~= "/" then build = here .. "/" .. build end
local shared = build .. "/mutants"
local work, log = string.format("%s/%d", shared, seed), string.format("%s/%d.log", shared, seed)
local tree = work .. "/tree"

local function slurp(path)
  local file = io.open(path, "rb")
  local text = file and file:read "a"
  if file then file:close() end
  return text
end

local function write(path, text)
  local file = assert(io.open(path, "wb"))
  assert(file:write(text))
  assert(file:close())
end

-- Where there are name spaces for processes a defect can signal none but those of its own test.
local ALONE = "unshare --pid --fork --mount-proc --kill-child "
local alone = os.execute(ALONE .. "true 2>/dev/null") and ALONE or ""

---- what can be planted --------------------------------------------------------------------------------

-- Tables of measured numbers are no code.
local AREAS = {
  { name = "generator", files = "generator -name '*.lua' ! -path generator/cost/measured.lua", language = "lua" },
  { name = "templates", files = "templates -name '*.[ch]'", language = "template" },
  { name = "src", files = "src -name '*.c'", language = "c" },
}

-- By kind: all sites of an area, in the order of files and lines.
local function collect(area)
  area.sites = {}
  for _, kind in ipairs(sites.kinds) do area.sites[kind] = {} end
  for path in io.popen("find " .. area.files .. " | LC_ALL=C sort"):lines() do
    for _, s in ipairs(sites.find(slurp(path), area.language)) do
      s.file = path
      table.insert(area.sites[s.kind], s)
    end
  end
end

local function draw(area)
  if not area.sites then collect(area) end
  local list = area.sites[sites.kinds[random(#sites.kinds)]]
  return list[random(#list)]
end

-- The line before and after, for the page: of a long one what is near the defect.
local WIDTH = 90
local function change(text, s)
  local from = text:sub(1, s.from - 1):match ".*\n()" or 1
  local last = (text:find("\n", s.to, true) or #text + 1) - 1
  local before = text:sub(from, s.from - 1):gsub("^%s+", "")
  local behind = text:sub(s.to + 1, last):gsub("%s+$", "")
  local longer = math.max(s.to - s.from + 1, #s.new)
  if #before + longer + #behind > WIDTH then
    local room = math.max(10, (WIDTH - longer)//2)
    local left, right = math.max(room, WIDTH - longer - #behind), math.max(room, WIDTH - longer - #before)
    if #before > left then before = "..." .. before:sub(3 - left) end
    if #behind > right then behind = behind:sub(1, right - 3) .. "..." end
  end
  return before .. text:sub(s.from, s.to) .. behind, before .. s.new .. behind
end

---- the copy of the tree -------------------------------------------------------------------------------

-- Targets of the tree's Makefile that are built from it as it stands.
local built = {}

local function make(target)
  built[target] = built[target] or os.execute(string.format("make -s -C %s %s >%s/make.log 2>&1", tree, target, work))
  return built[target]
end

-- With what is built already: the times of files are kept, so only what differs is built anew.
local function copy()
  assert(os.execute(string.format("rm -rf %s && mkdir -p %s/build %s/tmp && cp -a .ci .gitignore $(git ls-files | " ..
    "sed 's|/.*||' | grep -v '^[.]' | sort -u) %s && for d in obj lua tests oracle ready embedded.c; do " ..
    "[ ! -e %s/$d ] || cp -a %s/$d %s/build; done", tree, tree, work, tree, build, build, tree)))
  assert(make "tests", "the tree does not build; " .. work .. "/make.log says why")
end

local function put(path, text)
  write(tree .. "/" .. path, text)
  built = {}
end

-- What a test needs built: itself, the program if the file or a module of tests/ that it loads names it, or nothing but
-- what reckons for scripts.
local programs = {}
local function runs_program(path)
  if programs[path] == nil then
    programs[path] = false
    local text = slurp(path) or ""
    local found = text:find "polhode[\"' ]" ~= nil
    for module in text:gmatch 'require%s*%(?%s*"(tests[%w_.]*)"' do
      found = runs_program(module:gsub("[.]", "/") .. ".lua") or found
    end
    programs[path] = found
  end
  return programs[path]
end

local function needs(test)
  if test.file:find "%.c$" then return test.command end
  return runs_program(test.file) and "all" or "build/lua/polhode_rational.so"
end

-- Does the test fail?  Its time is counted in processor seconds of one process, so a busy machine finds nothing; a
-- process that waits for ever is found by the clock.
local function fails(test, tier)
  assert(make(needs(test)), "its object was built, the program is not")
  local limit = 60 + 10*test.seconds // 1
  local ended, why, code = os.execute(string.format("cd %s && ulimit -t %d && TMPDIR=%s/tmp " ..
    "XDG_CACHE_HOME=%s/tmp POLHODE_TIER=%s timeout -k 5 %d %s%s >%s/test.log 2>&1 </dev/null", tree, limit, work, work,
    tier, 20*limit, alone, test.command, work))
  os.execute(string.format("chmod -R u+w %s/tmp; rm -rf %s/tmp; mkdir %s/tmp", work, work, work))
  if why == "signal" and code == 2 or code == 130 then os.exit(130) end
  return not ended
end

---- the run --------------------------------------------------------------------------------------------

local function note(...)
  local file = assert(io.open(log, "a"))
  file:write(table.concat({ ... }, "\t"), "\n")
  file:close()
end

-- By number: { site =, quick = test or "-", all = test or "-", passed = { test = true } }, from an earlier run.
local function read_log()
  local known = {}
  for verb, number, what in (slurp(log) or ""):gmatch "(%l+)\t(%d+)\t([^\t\n]*)" do
    number = tonumber(number)
    known[number] = known[number] or { passed = {} }
    if verb == "passed" then
      known[number].passed[what] = true
    else
      known[number][verb] = what
    end
  end
  return known
end

-- Has the compiler made the same of it?  Then nothing has changed.
local function same_code(text, planted) return string.dump(load(text), true) == string.dump(load(planted), true) end
local function object_of(file) return (file:gsub("^src", "obj"):gsub("c$", "o")) end
local function same_object(file)
  local object = object_of(file)
  return os.execute(string.format("strip -g -o %s/a.o %s/build/%s && strip -g -o %s/b.o %s/%s && " ..
    "cmp -s %s/a.o %s/b.o", work, tree, object, work, build, object, work, work)) == true
end

-- Its object is built at once, the rest when a test needs it.
local function plant(defect)
  local text = slurp(defect.file)
  local planted = sites.plant(text, defect)
  local script, c = defect.file:find "%.lua$", defect.file:find "^src/"
  if script and (not load(planted) or same_code(text, planted)) then return false end
  put(defect.file, planted)
  local good = not c or make("build/" .. object_of(defect.file)) and not same_object(defect.file)
  if not good then put(defect.file, text) end
  return good
end

-- Does it pass without a defect?  One that does not finds nothing, and is left out.
local sound = {}
local function is_sound(test, tier)
  local key = tier .. " " .. test.file
  if sound[key] == nil then
    sound[key] = not fails(test, tier)
    if not sound[key] then print(test.file .. " fails without a defect: left out") end
  end
  return sound[key]
end

-- The first test of the list that fails with the defect, which is planted, or "-"; at most `most` seconds of those that
-- have not passed before.  The tree is whole again after it, but not yet built.
local function caught(number, defect, tests, tier, passed, most)
  local spent = 0
  for _, test in ipairs(tests) do
    local key = tier .. " " .. test.file
    if sound[key] ~= false and not passed[key] and spent + test.seconds <= most then
      spent = spent + test.seconds
      local failed = fails(test, tier)
      if failed then
        put(defect.file, slurp(defect.file))
        if is_sound(test, tier) then
          order.met(test, defect.file, true)
          return test.file
        end
        assert(plant(defect))
      else
        order.met(test, defect.file, false)
        note("passed", number, key)
      end
    end
  end
  put(defect.file, slurp(defect.file))
  return "-"
end

-- What earlier runs of any seed have learned.
local function learn()
  for path in io.popen(string.format("ls %s/*.log 2>/dev/null", shared)):lines() do
    local file = {}
    for verb, number, what in slurp(path):gmatch "(%l+)\t(%d+)\t([^\t\n]*)" do
      if verb == "site" then
        file[number] = what:match "^[^:]+"
      elseif what ~= "-" then
        order.met({ file = what:match "%S+$" }, file[number], verb ~= "passed")
      end
    end
  end
end

os.execute("mkdir -p " .. work)
copy()
order.sees = {}
for _, tier in ipairs { "quick", not alone_quick and "all" or nil } do
  local tests = order.tests(tier, tier == "quick" and spend/3 or math.huge)
  seen.record(shared, tier, tests)
  order.sees[tier] = seen.by(shared, tier, tests)
end
local known, defects = read_log(), {}
learn()
for number = 1, count do
  local area, before = AREAS[(number - 1) % #AREAS + 1], known[number] or { passed = {} }
  local defect
  repeat
    defect = draw(area)
    local again = before.site and before.site ~= defect.file .. ":" .. defect.from
    local good = not again and (before.quick and before.quick ~= "-" or plant(defect))
  until good
  defects[number] = defect
  defect.was, defect.is = change(slurp(defect.file), defect)
  defect.quick = before.quick
  if not defect.quick or defect.quick == "-" then
    if not before.site then note("site", number, defect.file .. ":" .. defect.from) end
    defect.quick = caught(number, defect, order.quick(defect, spend/3), "quick", before.passed, spend)
    note("quick", number, defect.quick)
  end
  print(string.format("%d %s:%d %s\n  - %s\n  + %s\n  quick: %s", number, defect.file, defect.line, defect.kind,
    defect.was, defect.is, defect.quick))
end
for number, defect in ipairs(defects) do
  local before = known[number] or { passed = {} }
  if defect.quick ~= "-" then
    defect.all = defect.quick
  elseif before.all and before.all ~= "-" then
    defect.all = before.all
  else
    assert(plant(defect))
    defect.all = caught(number, defect, alone_quick and order.longer(defect) or order.rest(defect), "all",
      before.passed, alone_quick and 10*spend or math.huge)
    note("all", number, defect.all)
  end
  if defect.quick == "-" then
    print(number, defect.file .. ":" .. defect.line, "all: " .. (defect.all or "not asked"))
  end
end
os.execute("rm -rf " .. work)
page.write(to, seed, defects, alone_quick and "no test near it" or "no test")
