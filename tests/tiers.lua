-- tiers.lua - which tests are run together, from the list tests/tiers.txt; what is running and how long is left.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/tiers.lua files TIER BUILD JOBS     the files of a tier, longest first; starts the log
--     lua5.4 tests/tiers.lua one BUILD FILE            runs one of them: `prove -e` calls this
--     lua5.4 tests/tiers.lua take BUILD                writes the seconds that the last run measured into the list
--
-- TIER: quick (make check), all (make check-all), target (make check-target).  `files` fails if a test is not in the
-- list, a file of the list is not there, or the quick tier has grown beyond its limit.
-- `one` says what starts, how long is left, and of a test that fails the lines that say why: on descriptor 3 if it is
-- open, for prove holds back standard error until there is standard output.  Tests see their tier in POLHODE_TIER;
-- some run a part of themselves if it is quick.

local LIST = "tests/tiers.txt"
local LIMIT = 540 -- s of processor time: 5 minutes on 2 cores, less a tenth

local function fail(...)
  io.stderr:write("tests/tiers.lua: ", string.format(...), "\n")
  os.exit(1)
end

local function lines_of(path)
  local file, list = io.open(path), {}
  if file then
    for line in file:lines() do list[#list + 1] = line end
    file:close()
  end
  return list
end

local function output(command)
  local pipe, list = assert(io.popen(command)), {}
  for line in pipe:lines() do list[#list + 1] = line end
  pipe:close()
  return list
end

---- the list ------------------------------------------------------------------------------------------

-- A line is: seconds in the quick tier, seconds of the whole file, the file; a comment after #.  Instead of the first
-- number: "-" if make check-all alone runs it, "target" if make check-target does.
local function read_list()
  local entries, by_file = {}, {}
  for number, line in ipairs(lines_of(LIST)) do
    local text = line:gsub("#.*", "")
    if text:find "%S" then
      local quick, all, file = text:match "^%s*(%S+)%s+(%S+)%s+(%S+)%s*$"
      local known = quick == "-" or quick == "target" or tonumber(quick)
      if not file or not known or not tonumber(all) then
        fail("%s:%d: SECONDS SECONDS FILE is wanted (- or target for the first), got %q", LIST, number, line)
      end
      if by_file[file] then fail("%s:%d: %s is there twice", LIST, number, file) end
      local e = { file = file, quick = tonumber(quick), all = tonumber(all), target = quick == "target" }
      entries[#entries + 1], by_file[file] = e, e
    end
  end
  return entries, by_file
end

-- The seconds of an entry in a tier, or nil if it is not in it.
local function seconds(e, tier)
  if tier == "target" then return e.target and e.all or nil end
  if e.target then return nil end
  if tier == "quick" then return e.quick end
  return e.all
end

-- tests/runtime/x.c is built and then run as BUILD/tests/runtime/x.t.
local function runnable(file, build) return (file:gsub("^(tests/runtime/.*)%.c$", build .. "/%1.t")) end

local function check_list(entries, by_file)
  local there = {}
  for _, file in ipairs(output "find tests -name '*.t' | LC_ALL=C sort; ls tests/runtime/*.c") do
    there[file] = true
    if not by_file[file] then
      fail("%s is not in %s: add a line, SECONDS SECONDS %s (- for the first: not a quick test)", file, LIST, file)
    end
  end
  local sum = 0
  for _, e in ipairs(entries) do
    if not there[e.file] then fail("%s names %s, which is not there", LIST, e.file) end
    sum = sum + (e.quick or 0)
  end
  if sum > LIMIT then fail("the quick tier is %.0f s of processor time, at most %d are allowed", sum, LIMIT) end
end

---- the log of a run: what started and ended, in BUILD/tests/tier.log -----------------------------------

local function append(build, ...)
  local file = assert(io.open(build .. "/tests/tier.log", "a"))
  file:write(table.concat({ ... }, " ") .. "\n")
  file:close()
end

local function read_log(build)
  local log = { wanted = {}, list = {}, running = {}, ended = {} }
  for _, line in ipairs(lines_of(build .. "/tests/tier.log")) do
    local verb, a, b, c = line:match "^(%S+) (%S+) ?(%S*) ?(%S*)$"
    if verb == "tier" then
      log.tier, log.jobs = a, tonumber(b)
    elseif verb == "want" then
      log.wanted[a], log.list[#log.list + 1] = tonumber(b), a
    elseif verb == "start" then
      log.running[a] = tonumber(b)
    elseif verb == "end" then
      log.running[a], log.ended[a] = nil, { wall = tonumber(b), cpu = tonumber(c) }
    end
  end
  return log
end

local function files(tier, build, jobs)
  local entries, by_file = read_list()
  check_list(entries, by_file)
  local chosen, sum = {}, 0
  for _, e in ipairs(entries) do
    if seconds(e, tier) then
      chosen[#chosen + 1] = e
      sum = sum + seconds(e, tier)
    end
  end
  table.sort(chosen, function(a, b)
    local x, y = seconds(a, tier), seconds(b, tier)
    return x > y or x == y and a.file < b.file
  end)
  os.execute("mkdir -p " .. build .. "/tests && : >" .. build .. "/tests/tier.log")
  append(build, "tier", tier, jobs)
  for _, e in ipairs(chosen) do
    append(build, "want", e.file, seconds(e, tier))
    print(runnable(e.file, build))
  end
  io.stderr:write(string.format("%d files of tests, %.0f s of processor time when %s was measured, %s at a time\n",
    #chosen, sum, LIST, jobs))
end

---- one test --------------------------------------------------------------------------------------------

-- What is left, in seconds on the clock: what the list says, corrected by how long the ended files took.  Thirty
-- seconds as listed are added to both, so that the first small files do not decide.
local function left(log)
  local rest, took, listed, ended = 0, 30, 30, 0
  for file, cost in pairs(log.wanted) do
    local e, since = log.ended[file], log.running[file]
    if e then
      took, listed, ended = took + e.wall, listed + cost, ended + 1
    else
      rest = rest + math.max(0, cost - (since and os.time() - since or 0))
    end
  end
  return rest*took/listed/log.jobs, ended
end

local function tell(...)
  local text = table.concat({ ... }):gsub("'", "'\\''")
  os.execute("{ printf '%s\n' '" .. text .. "' >&3; } 2>/dev/null || printf '%s\n' '" .. text .. "' >&2")
end

local function said(log, what, ...)
  local s, ended = left(log)
  tell(string.format("[%d of %d, %d:%02d left] %s", ended, #log.list, s // 60, s % 60 // 1, what), ...)
end

-- User and system seconds from the shell's `times`, whose second line is for children: "0m1.20s 0m0.03s".
local function processor(path)
  local sum = 0
  for m, s in (lines_of(path)[2] or ""):gmatch "(%d+)m([%d.]+)s" do sum = sum + 60*m + s end
  return sum
end

local function one(build, path)
  local file = path
  if path:sub(1, #build) == build then file = path:sub(#build + 2):gsub("%.t$", ".c") end
  append(build, "start", file, os.time())
  local log = read_log(build)
  said(log, file)
  local out = build .. "/tests/" .. file:gsub("/", "_")
  local began = os.time()
  local command = path == file and "lua5.4 " .. path or path
  -- a make that a test runs is none of ours
  local _, why, code = os.execute(string.format("unset MAKEFLAGS MFLAGS MAKELEVEL; POLHODE_TIER=%s; " ..
    "export POLHODE_TIER; %s >%s.out 3>&-; s=$?; times >%s.times; exit $s", log.tier, command, out, out))
  local text, failed, explains = lines_of(out .. ".out"), {}, false
  for _, line in ipairs(text) do
    print(line)
    explains = line:find "^not ok" ~= nil or explains and line:find "^#" ~= nil
    if explains and #failed < 100 then failed[#failed + 1] = "\n  " .. line end
  end
  local cpu = processor(out .. ".times")
  os.remove(out .. ".times")
  append(build, "end", file, os.time() - began, string.format("%.2f", cpu))
  if code ~= 0 then
    log = read_log(build)
    said(log, string.format("%s fails (%s %d)", file, why, code), table.unpack(failed))
  else
    os.remove(out .. ".out")
  end
  log = read_log(build)
  local sum, ended = 0, 0
  for _, e in pairs(log.ended) do sum, ended = sum + e.cpu, ended + 1 end
  if ended == #log.list then
    tell(string.format("all %d files have run: %.0f s of processor time", ended, sum))
  end
  os.exit(why == "signal" and 128 + code or code)
end

-- Numbers into their columns; what was not run, comments and order stay.
local function take(build)
  local log = read_log(build)
  local text = {}
  for i, line in ipairs(lines_of(LIST)) do
    local quick, all, file, rest = line:match "^%s*(%S+)%s+([%d.]+)%s+(%S+)(.*)$"
    local e = file and log.ended[file]
    if e then
      local whole = tonumber(quick) == tonumber(all)
      local new = string.format("%.2f", e.cpu)
      if log.tier ~= "quick" or whole then all = new end
      if tonumber(quick) and (log.tier == "quick" or whole) then quick = new end
    end
    text[i] = file and quick ~= "#" and string.format("%6s %7s %s%s", quick, all, file, rest) or line
  end
  local out = assert(io.open(LIST, "w"))
  out:write(table.concat(text, "\n"), "\n")
  out:close()
end

local commands = { files = files, one = one, take = take }
if not commands[arg[1]] then fail("files, one or take is wanted") end
commands[arg[1]](table.unpack(arg, 2))
