-- mutants.lua - plants defects one at a time and looks which tests see them: `make mutants`, docs/mutants.md.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/mutants/mutants.lua BUILD COUNT SEED PAGE [quick]
--
-- In a copy of the tree, BUILD/mutants/tree, a third of the defects each in generator/, templates/ and src/; the same
-- SEED plants the same ones in the same tree.  A defect with which the program cannot be built is none: another is
-- drawn.  Each is met by the quick tests that run its line (seen.lua), until one fails, and what they let pass by the
-- others of make check-all that run it (quick: not by these).  What was found is kept in BUILD/mutants/SEED.log: a run
-- that was stopped goes on there.

package.path = "./?.lua;" .. package.path

local sites = require "tests.mutants.sites"
local order = require "tests.mutants.order"
local seen = require "tests.mutants.seen"
local page = require "tests.mutants.page"

local build, count, seed, to, alone_quick = arg[1], tonumber(arg[2]), tonumber(arg[3]), arg[4], arg[5] == "quick"
io.stdout:setvbuf "line"

-- A whole number in [1, n] (Park and Miller's generator with 48271).
local state = 16807*seed % 2147483647
local function random(n)
  state = state*48271 % 2147483647
  return state*n // 2147483647 + 1
end

local here = io.popen("pwd"):read "l"
if build:sub(1, 1) ~= "/" then build = here .. "/" .. build end
local work = build .. "/mutants"
local tree, log = work .. "/tree", string.format("%s/%d.log", work, seed)

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

-- The line before and after, for the page.
local function change(text, s)
  local from = text:sub(1, s.from - 1):match ".*\n()" or 1
  local last = (text:find("\n", s.to, true) or #text + 1) - 1
  local tidy = function(line) return (line:gsub("%s+", " "):gsub("^ ", "")) end
  return tidy(text:sub(from, last)), tidy(text:sub(from, s.from - 1) .. s.new .. text:sub(s.to + 1, last))
end

---- the copy of the tree -------------------------------------------------------------------------------

local function make()
  return os.execute(string.format("make -s -C %s tests >%s/make.log 2>&1", tree, work))
end

-- With what is built already: the times of files are kept, so only what differs is built anew.
local function copy()
  assert(os.execute(string.format("rm -rf %s && mkdir -p %s/build %s/tmp && cp -a .ci .gitignore $(git ls-files | " ..
    "sed 's|/.*||' | grep -v '^[.]' | sort -u) %s && for d in obj lua tests oracle ready embedded.c; do " ..
    "[ ! -e %s/$d ] || cp -a %s/$d %s/build; done", tree, tree, work, tree, build, build, tree)))
  assert(make(), "the tree does not build; " .. work .. "/make.log says why")
end

-- Does the test fail?  It has time enough on a busy machine.
local function fails(test, tier)
  local limit = 60 + 10*test.seconds // 1
  local ended, why, code = os.execute(string.format("cd %s && TMPDIR=%s/tmp POLHODE_TIER=%s timeout -k 5 %d %s%s " ..
    ">%s/test.log 2>&1 </dev/null", tree, work, tier, limit, alone, test.command, work))
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

-- By number: { quick = test or "-", all = test or "-" }, from an earlier run.
local function read_log()
  local known = {}
  for verb, number, test in (slurp(log) or ""):gmatch "(%l+)\t(%d+)\t([^\t\n]*)" do
    number = tonumber(number)
    known[number] = known[number] or {}
    known[number][verb] = test
  end
  return known
end

local function plant(defect)
  local text = slurp(defect.file)
  local planted = sites.plant(text, defect)
  if defect.file:find "%.lua$" and not load(planted) then return false end
  write(tree .. "/" .. defect.file, planted)
  local built = make()
  if not built then write(tree .. "/" .. defect.file, text) end
  return built
end

-- Does it pass without a defect?  One that does not finds nothing, and is left out.
local sound = {}
local function is_sound(test, tier)
  local key = tier .. " " .. test.file
  if sound[key] == nil then
    assert(make())
    sound[key] = not fails(test, tier)
    if not sound[key] then print(test.file .. " fails without a defect: left out") end
  end
  return sound[key]
end

-- The first test of the list that fails with the defect, which is planted, or "-".  The tree is whole again after it,
-- but not yet built.
local function caught(defect, tests, tier)
  for _, test in ipairs(tests) do
    if sound[tier .. " " .. test.file] ~= false and fails(test, tier) then
      write(tree .. "/" .. defect.file, slurp(defect.file))
      if is_sound(test, tier) then
        order.killed(test, defect.file)
        return test.file
      end
      assert(plant(defect))
    end
  end
  write(tree .. "/" .. defect.file, slurp(defect.file))
  return "-"
end

os.execute("mkdir -p " .. work)
copy()
order.sees = {}
for _, tier in ipairs { "quick", not alone_quick and "all" or nil } do
  seen.record(work, tier, order.tests(tier))
  order.sees[tier] = seen.by(work, tier, order.tests(tier))
end
local known, defects = read_log(), {}
for number = 1, count do
  local area, before = AREAS[(number - 1) % #AREAS + 1], known[number] or {}
  local defect
  repeat
    defect = draw(area)
    local again = before.quick and before.site ~= defect.file .. ":" .. defect.from
    local good = not again and (before.quick or plant(defect))
  until good
  defects[number] = defect
  defect.was, defect.is = change(slurp(defect.file), defect)
  defect.quick = before.quick
  if defect.quick then
    order.killed({ file = defect.quick }, defect.file)
  else
    note("site", number, defect.file .. ":" .. defect.from)
    defect.quick = caught(defect, order.quick(defect), "quick")
    note("quick", number, defect.quick)
  end
  print(string.format("%d %s:%d %s\n  - %s\n  + %s\n  quick: %s", number, defect.file, defect.line, defect.kind,
    defect.was, defect.is, defect.quick))
end
for number, defect in ipairs(defects) do
  local before = known[number] or {}
  if defect.quick ~= "-" then
    defect.all = defect.quick
  elseif before.all then
    defect.all = before.all
  elseif not alone_quick then
    assert(plant(defect))
    defect.all = caught(defect, order.rest(defect), "all")
    note("all", number, defect.all)
  end
  if defect.quick == "-" then
    print(number, defect.file .. ":" .. defect.line, "all: " .. (defect.all or "not asked"))
  end
end
os.execute("rm -rf " .. tree)
page.write(to, seed, defects)
