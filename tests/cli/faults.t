#!/usr/bin/env lua5.4
-- faults.t - when the file system fails, or a signal comes: no file is half written, earlier ones are kept.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/cli/faults/shim.c lets the n-th call fail, or raises a signal before it; it works for root, too, whom a
-- read-only folder does not stop.  First a small set of files under every fault at every call; then the commands
-- that write.  The quick tier takes fewer calls.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local here = io.popen("pwd"):read("l")
if binary:sub(1, 1) ~= "/" then binary = here .. "/" .. binary end
local cc = os.getenv "CC" or "cc"
local LINUX = { ENOENT = 2, EINTR = 4, EIO = 5, EACCES = 13, ENOSPC = 28, EROFS = 30, EDQUOT = 122 }

if os.getenv "POLHODE_SANITIZED" then
  tap.skip("faults of the file system", "sanitizers want to be loaded first themselves")
  tap.done()
end
local shim = dir .. "/shim.so"
if program.shell(cc .. " -O1 -shared -fPIC -o " .. shim .. " tests/cli/faults/shim.c -ldl 2>/dev/null") ~= 0 then
  tap.skip("faults of the file system", "the shim does not compile here (packages gcc, libc6-dev)")
  tap.done()
end

local function sh(command) return program.shell("cd " .. dir .. " && { " .. command .. "; }") end
local function text_of(command)
  local pipe = io.popen("cd " .. dir .. " && { " .. command .. "; }")
  local text = pipe:read "a"
  pipe:close()
  return text
end

-- Names, modes, links and texts of all below a folder.
local function state(folder)
  return text_of("cd " .. folder .. " 2>/dev/null && find . -printf '%P %y %m %l\\n' | sort && find . -type f | " ..
    "sort | " ..
    "xargs -r md5sum")
end

-- ---- a set of three files over old ones, one whose folder is not there, and one that goes ----

program.write(dir .. "/set.lua", [[
local list = {}
for _, name in ipairs { "a.c", "b.c", "c.c", "deep/er/d.c" } do
  list[#list + 1] = { name = name, text = string.rep(name .. " new\n", 3000) }
end
list[#list + 1] = { name = "gone.c", text = false }
local ok, why = host.write_files("out", list)
if ok then return 0 end
host.err("polhode: " .. why .. "\n")
return 2
]])
program.write(dir .. "/one.lua", [[
local ok, why = host.write_file("out/a.c", string.rep("a.c new\n", 3000))
if ok then return 0 end
host.err("polhode: " .. why .. "\n")
return 2
]])
program.write(dir .. "/cache.lua", [[host.cache_write("0abc", string.rep("new\n", 3000)) return 0]])

local FRESH = "rm -rf out cache && mkdir -p out cache/polhode && for f in a.c b.c keep gone.c; do " ..
  "echo old $f > out/$f; " ..
  "done && " ..
  "chmod 640 out/b.c && echo old > cache/polhode/0abc"

-- Status and standard error of the little generator under a fault.
local function little(script, fault)
  sh(FRESH)
  local status = sh(string.format("XDG_CACHE_HOME=%s/cache FAULT=%q FAULT_COUNT=%s/count " ..
    "POLHODE_SOURCE=%s/tests/cli/tree " ..
    "timeout 20 env LD_PRELOAD=%s %s %s.lua >stdout 2>stderr", dir, fault, dir, here, shim, binary, script))
  return status, program.read(dir .. "/stderr")
end

sh(FRESH)
local old = state "out" .. state "cache"

-- Every file is whole, of the old text or the new; `stray`: temporaries that may be there.
local function whole(stray)
  local all = text_of("find out cache -type f")
  for path in all:gmatch "[^\n]+" do
    local text, name = program.read(dir .. "/" .. path), path:match "[^/]*$"
    local good = text == "old " .. name .. "\n" or text == ((path:match "^out/(deep.*)$" or name) ..
      " new\n"):rep(3000) or
      name == "0abc" and (text == "old\n" or text == ("new\n"):rep(3000))
    if not good and not (stray and name:find("^%.polhode%-")) then return false, path end
    if name:find("^%.polhode%-") and not stray then return false, path end
  end
  return true
end

for _, script in ipairs { "set", "one", "cache" } do
  little(script, "none 0 0")
  local new = state "out" .. state "cache"
  tap.ok(new ~= old and whole(), script .. ": without a fault the new files are there")
  local bad, runs, refused = {}, 0, 0
  for _, call in ipairs { "mkstemp", "write", "fchmod", "close", "mkdir", "rename", "link", "unlink" } do
    little(script, call .. " 9999 0")
    local n = tonumber(program.read(dir .. "/count"))
    for i = 1, math.min(n, 12), tier.quick and 5 or 1 do
      for _, name in ipairs { ({ "ENOSPC", "EIO", "EACCES" })[i % 3 + 1] } do
        local status, err = little(script, call .. " " .. i .. " " .. LINUX[name])
        local now = state "out" .. state "cache"
        runs = runs + 1
        if status ~= 0 then refused = refused + 1 end
        local fine = status == 0 and (now == new or script == "cache" and now == old) and err == "" or
          status == 2 and now == old and err:find("^polhode: cannot write [^\n]+: [^\n]+\n$") ~= nil
        -- what could not be unlinked is there: a second name of an old file, or a temporary of a failed set
        if call == "unlink" then fine = whole(true) end
        if not fine then bad[#bad + 1] = string.format("%s %d %s: status %s %s", call, i, name, status, err) end
      end
    end
  end
  tap.ok(#bad == 0 and (refused > 3 or tier.quick or script == "cache"), string.format("%s: %d faults (ENOSPC, EIO, " ..
    "EACCES by turns at each call), all new or all old with one message", script, runs), table.concat(bad, "\n"))
  bad = {}
  for _, fault in ipairs { "write 0 short", "write 1 " .. LINUX.EINTR, "write 2 " .. LINUX.EINTR } do
    local status, err = little(script, fault)
    if status ~= 0 or state "out" .. state "cache" ~= new then bad[#bad + 1] = fault .. ": " .. err end
  end
  tap.is(table.concat(bad, "\n"), "", script .. ": short and interrupted writes are gone on with")

  -- signals: what can be caught leaves all new or all old; SIGKILL leaves whole files, some of them perhaps new
  bad, runs = {}, 0
  little(script, "any 9999 0")
  local n = tonumber(program.read(dir .. "/count"))
  for i = 1, n, tier.quick and 7 or 1 do
    for _, signal in ipairs { i % 2 == 0 and 2 or 15, 9 } do
      local status = little(script, "any " .. i .. " signal " .. signal)
      local now = state "out" .. state "cache"
      runs = runs + 1
      local fine = signal == 9 and whole(true) or signal ~= 9 and (now == new or now == old) and status == 128 + signal
      if not fine then bad[#bad + 1] = string.format("signal %d at call %d: status %s", signal, i, status) end
    end
  end
  tap.ok(#bad == 0 and n > 4, string.format("%s: SIGKILL and, by turns, SIGINT or SIGTERM at each of %d calls: " ..
    "every file whole, nothing " ..
    "left behind but by SIGKILL", script, n), table.concat(bad, "\n"))
end

-- ---- what an output can be ----

local function run(command, before, fault)
  local status = sh((before or "") .. " timeout 60 " .. (fault and "env FAULT='" .. fault .. "' LD_PRELOAD=" ..
    shim .. " " or
    "") .. binary .. " " .. command .. " >stdout 2>stderr")
  return status, program.read(dir .. "/stderr")
end
program.write(dir .. "/s.lua", "return scene { name = 's', body = solid.sphere { r = 1, mass = 1 }, time = { " ..
  "horizon = 1 } }\n")
program.write(dir .. "/t.lua", "local a = param('a', 1, 'm') return scene { name = 's', body = solid.sphere { r " ..
  "= a, mass = 1 } }\n")

sh("mkdir -p ways && cd ways && mkdir dir && echo old > target && ln -s target link && ln -s nothing dangling && " ..
  "ln -s loop loop")
local CSV = "run s.lua --engine general --until 1 --every 0.5 -o "
local status, err = run(CSV .. "ways/dir")
tap.ok(status == 2 and err:find("it is a directory", 1, true), "an output that is a directory: status 2", err)
status, err = run(CSV .. "ways/dangling")
tap.ok(status == 2 and err:find("it is a link to nothing", 1, true) and sh "test ! -e ways/nothing" == 0,
  "a link to nothing: status 2, and nothing is made", err)
status, err = run(CSV .. "ways/loop")
tap.ok(status == 2 and err:find("cannot write ways/loop", 1, true), "a link to itself: status 2", err)
status = run(CSV .. "ways/link")
tap.ok(status == 0 and sh "test -h ways/link" == 0 and program.read(dir .. "/ways/target"):find("^t,qw"),
  "a link: its target is replaced, the link stays")
sh "echo old > ways/target"
status = run(CSV .. "ways/link", nil, "write 1 28")
tap.ok(status == 74 and program.read(dir .. "/ways/target") == "old\n",
  "a full disk behind a link: the target is as it was")
status, err = run(CSV .. "/dev/full")
tap.ok(status == 74 and err == "polhode run: cannot write /dev/full: No space left on device\n",
  "/dev/full: status 74", err)
status, err = run("gen s.lua -o /dev/null")
tap.ok(status == 2 and err:find("cannot write /dev/null", 1, true) and sh "test -c /dev/null" == 0,
  "gen into /dev/null: status 2", err)
status, err = run("gen s.lua -o big", "ulimit -f 1;")
tap.ok(status == 74 and err:find("File too large", 1, true) and sh "test ! -e big" == 0,
  "a file that may not be as large (ulimit -f): status 74 and no folder", err)
if sh "test -d /dev/shm && test -w /dev/shm && test $(stat -c %d /dev/shm) != $(stat -c %d .)" == 0 then
  local other = text_of("mktemp -d /dev/shm/polhode-XXXXXX"):gsub("\n", "")
  sh("echo old > " .. other .. "/t && ln -s " .. other .. "/t ways/far")
  status = run(CSV .. "ways/far")
  tap.ok(status == 0 and program.read(other .. "/t"):find("^t,qw") and sh "test -h ways/far" == 0,
    "a link to another file system: its target is replaced there")
  sh("rm -rf " .. other)
else
  tap.skip("a link to another file system", "there is no second one at /dev/shm")
end
-- A copy of the program, called from here: another user may not be able to reach the one in the project's folder.
local NOBODY = "setpriv --reuid=65534 --regid=65534 --clear-groups"
sh("chmod 755 . && cp " .. binary .. " other && chmod 755 other")
if sh(NOBODY .. " timeout 60 ./other --version >/dev/null 2>&1") == 0 then
  sh "mkdir -p ro/s && echo generated by polhode 0 > ro/s/s.c && chmod -R a+rX,a-w ro && chmod 644 s.lua"
  local before = state "ro"
  status = sh(NOBODY .. " timeout 60 ./other gen s.lua -o ro/s >stdout 2>stderr")
  err = program.read(dir .. "/stderr")
  tap.ok(status == 2 and err:find("Permission denied", 1, true) and state "ro" == before,
    "a read-only folder, for who is not root: status 2, all as before", err)
else
  tap.skip("a read-only folder, for who is not root", "setpriv (package util-linux) as root is needed")
end

-- ---- standard output ----

for _, command in ipairs { "explain s.lua", "list shapes", "run s.lua --engine general --until 1 --every 0.5",
  "--help" } do
  status = sh("timeout 60 " .. binary .. " " .. command .. " >/dev/full 2>stderr")
  tap.is(status .. " " .. program.read(dir .. "/stderr"), "74 polhode: cannot write standard output: No space " ..
    "left on device\n",
    command .. " to a full disk: status 74")
  status = sh("timeout 60 " .. binary .. " " .. command .. " >&- 2>stderr")
  tap.ok(status == 74 and program.read(dir .. "/stderr"):find("cannot write standard output", 1, true),
    command .. " with standard output closed: status 74", tostring(status))
end
sh("(" .. binary .. " run s.lua --engine general --until 1 --every 0.0001 2>stderr; echo $? >rc) | head -1 >/dev/null")
tap.is(program.read(dir .. "/rc") .. program.read(dir .. "/stderr"), "74\n",
  "a reader that goes away: status 74, no message")
sh("(" .. binary .. " gen s.lua -o closed <&- >&- 2>&-; echo $? >rc)")
tap.ok(program.read(dir .. "/rc") == "0\n" and sh("! grep -l 'polhode gen:' closed/*") == 0 and #state "closed" > 100,
  "gen with all three descriptors closed writes its files, and nothing else into them")

-- ---- the commands that write ----

-- The command first makes its files, then makes others over them while the disk is full, and while a rename fails; a
-- signal comes when the first file is there and the last is not.
local function command(name, first, second, folder, renames)
  sh("rm -rf " .. folder)
  status, err = run(first)
  local before, bad = state(folder), {}
  if status ~= 0 then bad[1] = "status " .. status .. ": " .. err end
  for _, fault in ipairs { "write 1 28", "rename " .. renames .. " 5", "rename " .. renames .. " signal 15" } do
    local again = run(second, nil, fault)
    local now = state(folder)
    if fault:find "signal" then
      run(second)
      local all_new = again == 143 and now == state(folder)
      if not all_new then bad[#bad + 1] = fault .. ": status " .. again end
    elseif again ~= 74 or now ~= before then
      bad[#bad + 1] = fault .. ": status " .. again
    end
  end
  tap.ok(#bad == 0 and before ~= "", name .. ": earlier files are kept on a full disk and when a rename fails; " ..
    "SIGTERM in " ..
    "between leaves all the new ones", table.concat(bad, "\n"))
end
for _, kind in ipairs(tier.every(6, { "make", "cmake", "arduino", "platformio", "zephyr", "firmware" })) do
  command("gen --project " .. kind, "gen s.lua -o g --project " .. kind, "gen t.lua -o g --project " .. kind, "g", 2)
end
command("run -o", CSV .. "o/x.csv", "run t.lua --engine general --until 1 --every 0.25 -o o/x.csv", "o", 1)
program.write(dir .. "/u.lua", "local a, b = param('a', 1, 'm'), param('b', 2, 'm') return scene { name = 'u', " ..
  "body = solid.box { x = a, y = b, z = 3, mass = 1 } }\n")
command("chart -o", "chart u.lua --over a=1:2,b=1:2 -o c/x.svg", "chart u.lua --over a=1:3,b=1:3 -o c/x.svg", "c", 1)

tap.done(program.finish())
