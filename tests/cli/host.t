#!/usr/bin/env lua5.4
-- host.t - what the program does outside Lua: files all or none, output checked, compilers, plugins, signals.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each check runs the program with a few lines of generator of its own (tests/cli/tree).

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local here = io.popen("pwd"):read("l")

-- The generator `text` prints `want` and ends in `status` (0).
local function prints(name, text, want, status)
  local code, out, err = program.run(text, dir)
  return tap.ok(code == (status or 0) and out == want, name,
    string.format("status %s\ngot  %s\nwant %s\n%s", code, out, want, err))
end

local function shell(command)
  return program.shell("cd " .. dir .. " && " .. command) == 0
end

-- ---- the state ----

prints("the generator has no io, os, dofile, loadfile, print",
  "say(io, os, dofile, loadfile, print, package.loadlib, package.path)", "nil nil nil nil nil nil nil\n")
prints("require finds nothing outside generator", [[
  local ok, why = pcall(require, "socket")
  say(ok, string.find(why, "no module outside 'generator.'", 1, true) ~= nil)]], "false true\n")
prints("exact numbers are preloaded", [[say(require "polhode_rational".parse "0.1")]], "1/10\n")
prints("chance is the same in every run", "say(math.random(1000000)) say(math.random(1000000))",
  (select(2, program.run("say(math.random(1000000)) say(math.random(1000000))"))))
prints("the exit status is the generator's", "return 3", "", 3)

do
  local code, out, err = program.run("\nlocal t = nil\nhost.out('x')\nt.x = 1")
  tap.is(code, 70, "an error that nobody caught ends in status 70")
  tap.is(out, "x", "what was written before stays written")
  tap.like(err, "main.lua:4: attempt to index a nil value (local 't')", "the message has file and line")
  tap.like(err, "generator/main.lua:", "the traceback names the generator's own files")
  code, out, err = program.run("error({})")
  tap.ok(code == 70 and out == "" and err:find("error object is a table value", 1, true),
    "an error object is no crash", err)
  code, out, err = program.run("local t = {} for i = 1, 1e9 do t[i] = string.rep('x', 20000000) .. i end")
  tap.ok(code == 70 and out .. err == "polhode: internal error: not enough memory\n",
    "a generator that eats memory ends", code .. err)
end

-- ---- reading ----

program.write(dir .. "/a.txt", "one\0two\r\n")
prints("read gives every byte", "local t = host.read(args[1] .. '/a.txt') say(#t, string.byte(t, 4))", "9 0\n")
prints("read of nothing says so", "say(select(2, host.read('no/such/file')))",
  "cannot read no/such/file: No such file or directory\n")
prints("read of a directory says so", "say(select(2, host.read('/tmp')))", "cannot read /tmp: it is a directory\n")
prints("read of a device says so", "say(select(2, host.read('/dev/zero')))",
  "cannot read /dev/zero: it is not a regular file\n")
shell("mkfifo fifo")
prints("read of a fifo does not hang", "local t, why = host.read(args[1] .. '/fifo') say(t, #why > 0)", "nil true\n")
shell("truncate -s 80M big")
prints("read of a huge file is refused", "say(host.read(args[1] .. '/big'))",
  "nil cannot read " .. dir .. "/big: it is larger than 4 MiB\n")
shell("mkdir list && touch list/b.lua list/a.lua list/B.lua list/.c.lua list/c.txt")
prints("list_dir sorts by byte, keeps the suffix, hides dots",
  "say(table.concat(host.list_dir(args[1] .. '/list', '.lua'), ' '))", "B.lua a.lua b.lua\n")
prints("list_dir of nothing says so", "say(host.list_dir('no/such'))",
  "nil cannot read no/such: No such file or directory\n")
prints("templates are there by name and in order", [[
  local sorted = true
  for i, name in ipairs(host.templates) do
    sorted = sorted and type(host.templates[name]) == "string" and (i == 1 or host.templates[i - 1] < name)
  end
  say(sorted)]], "true\n")

-- ---- writing ----

prints("write_files makes the directory and says what it wrote", [[
  local ok, names = host.write_files(args[1] .. "/made/deep", { { name = "b.c", text = "b" },
    { name = "sub/a.c", text = "" } })
  say(ok, table.concat(names, " "))]], "true b.c sub/a.c\n")
tap.is(program.read(dir .. "/made/deep/b.c"), "b", "the text is on disk")
tap.is(program.read(dir .. "/made/deep/sub/a.c"), "", "an empty text makes an empty file")
shell("touch -d 2001-01-01 made/deep/b.c")
prints("what did not change is not touched", [[
  local ok, names = host.write_files(args[1] .. "/made/deep", { { name = "b.c", text = "b" },
    { name = "sub/a.c", text = "new" } })
  say(ok, table.concat(names, " "))]], "true sub/a.c\n")
tap.ok(shell("test made/deep/b.c -ot a.txt"), "its time stays")
shell("umask 077; chmod 755 made/deep/b.c")
prints("a file that is replaced keeps its mode",
  "say((host.write_files(args[1] .. '/made/deep', { { name = 'b.c', text = 'bb' } })))", "true\n")
tap.ok(shell("test -x made/deep/b.c"), "an executable stays one")
tap.ok(shell("test -z \"$(find . -name '.polhode*')\""), "no temporary is left")

shell("mkdir -p go/ne/far go/on && touch go/a.c go/b.c go/ne/far/c.c go/on/d.c go/on/e.c")
prints("text = false removes a file, and the folders that it leaves empty", [[
  local ok, names = host.write_files(args[1] .. "/go", { { name = "a.c", text = false },
    { name = "no/such.c", text = false }, { name = "ne/far/c.c", text = false }, { name = "on/d.c", text = false } })
  say(ok, table.concat(names, " "))]], "true a.c ne/far/c.c on/d.c\n")
tap.ok(shell("test \"$(cd go && find . | LC_ALL=C sort | tr '\\n' ' ')\" = '. ./b.c ./on ./on/e.c '"),
  "what was not named stays, and its folder; none is made for a file that is not there")
shell("mkdir -p go/c.c && ln -s b.c go/l.c")
prints("neither a folder nor a link is removed", [[
  local ok, names = host.write_files(args[1] .. "/go", { { name = "c.c", text = false }, { name = "l.c",
    text = false } })
  say(ok, #names)]], "true 0\n")
tap.ok(shell("test -d go/c.c && test -h go/l.c && test -f go/b.c"), "they are there")
prints("when another file cannot be written, none is removed", [[
  say(host.write_files(args[1] .. "/go", { { name = "b.c", text = false }, { name = "c.c", text = "x" } }))]],
  "nil cannot write " .. dir .. "/go/c.c: it is a directory 2\n")
tap.ok(shell("test -f go/b.c"), "it is there")

shell("mkdir -p bad/c.c && printf old > bad/a.c")
prints("one target that cannot be written fails the whole set", [[
  say(host.write_files(args[1] .. "/bad", { { name = "a.c", text = "new" }, { name = "b.c", text = "b" },
    { name = "c.c", text = "c" } }))]], "nil cannot write " .. dir .. "/bad/c.c: it is a directory 2\n")
tap.is(program.read(dir .. "/bad/a.c"), "old", "what was there is as it was")
tap.ok(shell("test ! -e bad/b.c && test -z \"$(find . -name '.polhode*')\""), "nothing new is there")
prints("directories that were made for nothing go again", [[
  say(host.write_files(args[1] .. "/new/er", { { name = "a.c", text = "a" }, { name = "a.c/b", text = "b" } }))]],
  "nil cannot write " .. dir .. "/new/er/a.c: Is a directory 2\n")
tap.ok(shell("test ! -e new"), "none is left")
prints("a file in the way of a directory is named", [[
  say(host.write_files(args[1] .. "/a.txt/x", { { name = "a.c", text = "a" } }))]],
  "nil cannot write " .. dir .. "/a.txt/x: Not a directory 2\n")
for _, name in ipairs { "../x", "/x", ".", "..", "..x", ".polhode", "", "a/../x", "a//c", "a/", "a/./x", "a/b/../c",
  "a/.polhode-1/c" } do
  prints("the name '" .. name .. "' is refused", string.format([[
    say(pcall(host.write_files, args[1] .. "/names", { { name = %q, text = "" } }))]], name),
    "false write_files: entry 1 is no {name=, text=} with a plain relative name\n")
end
tap.ok(shell("test ! -e names"), "and nothing was made for them")

prints("write_file replaces one file", "say(host.write_file(args[1] .. '/one.csv', 'text'))", "true\n")
tap.is(program.read(dir .. "/one.csv"), "text", "its text is on disk")
prints("write_file into nothing says so", "say(host.write_file('', 'x'))",
  "nil cannot write : No such file or directory 2\n")
prints("write_file to a directory says so", "say(host.write_file(args[1], 'x'))",
  "nil cannot write " .. dir .. ": it is a directory 2\n")
prints("write_file writes through a device", "say(host.write_file('/dev/null', 'x'))", "true\n")
tap.ok(shell("test -c /dev/null"), "/dev/null is still a device")
prints("write_file to /dev/full says so", "say(host.write_file('/dev/full', 'x'))",
  "nil cannot write /dev/full: No space left on device 74\n")
shell("printf x > target && ln -s target link")
prints("write_file writes through a link", "say(host.write_file(args[1] .. '/link', 'y'))", "true\n")
tap.ok(program.read(dir .. "/target") == "y" and shell("test -h link"), "the link stays and its target changed")

-- ---- output ----

do
  local code, _, err = program.run_with("", ">/dev/full", "say('x')")
  tap.is(code, 74, "a full disk is a failure of its own")
  tap.is(err, "polhode: cannot write standard output: No space left on device\n", "with a message")
  code = program.run_with("", ">/dev/full", "say('x') return 3")
  tap.is(code, 3, "the generator's own failure comes first")
  code, _, err = program.run_with("", ">&-", "say('x')")
  tap.ok(code == 74 and err:find("cannot write standard output", 1, true), "so is a closed output", code .. err)
  program.write(dir .. "/long.lua", "for i = 1, 100000 do say('a line of output') end")
  program.shell("cd " .. here .. "; (POLHODE_SOURCE=tests/cli/tree " .. (os.getenv("POLHODE") or "build/polhode") .. " "
    .. dir .. "/long.lua 2>" .. dir .. "/pipe.err; echo $? >" .. dir .. "/pipe.rc) | head -1 >/dev/null")
  tap.is(program.read(dir .. "/pipe.rc"), "74\n", "a reader that goes away is a failure")
  tap.is(program.read(dir .. "/pipe.err"), "", "without a message: it has seen enough")
end
prints("a file is no terminal", "say(host.isatty('out'), host.isatty('err'))", "false false\n")

-- ---- processes ----

prints("execute gives status and output, both streams in order", [[
  say(host.execute { "sh", "-c", "echo out; echo err >&2; exit 7" })]], "7 out\nerr\n\n")
prints("execute passes arguments as they are", [[
  say(host.execute { "printf", "%s|", "a b", "$HOME", "'", "*" })]], "0 a b|$HOME|'|*|\n")
prints("execute of nothing says so", [[say(host.execute { "no-such-program" })]],
  "nil cannot run no-such-program: No such file or directory\n")
prints("execute can be bounded in time", [[
  local t = host.clock()
  local status = host.execute({ "sleep", "20" }, { seconds = 0.3 })
  say(status, host.clock() - t < 5)]], "137 true\n")
prints("execute runs in a directory", [[
  local _, out = host.execute({ "pwd" }, { dir = args[1] })
  say(out == args[1] .. "\n")]], "true\n")
prints("a child that writes a lot does not block", [[
  local status, out = host.execute { "sh", "-c", "head -c 3000000 /dev/zero; exit 4" }
  say(status, #out)]], "4 1048576\n")

program.write(dir .. "/good file.c", "int main(void) { return 5; }\n")
program.write(dir .. "/wrong.c", "int main(void) { return nothing; }\n")
prints("compile makes a program, whatever its name holds", [[
  say((host.compile(args[1], { "good file.c" }, "good $x")))
  say(host.execute { args[1] .. "/good $x" })]], "true\n5 \n")
prints("what the compiler says comes back", [[
  local ok, text = host.compile(args[1], { "wrong.c" }, "wrong")
  say(ok, string.find(text, "wrong.c", 1, true) ~= nil and string.find(text, "nothing", 1, true) ~= nil)]],
  "nil true\n")
prints("what a child writes beside its work, as compilers do, is in a folder that goes with the program", [[
  local own, ask = host.tempdir(), { "sh", "-c", "echo $TMPDIR" }
  local _, mine = host.execute(ask, { dir = own })
  local _, other = host.execute(ask, { dir = args[1] })
  say(mine == own .. "\n", other == own .. "\n")]], "true false\n")
prints("a compiler that is not there is named, with the way out", [[
  say(host.compile(args[1], { "wrong.c" }, "wrong", { cc = "no-such-cc -x" }))]],
  "nil cannot run the C compiler no-such-cc: No such file or directory (set CC, or install the packages gcc and " ..
    "libc6-dev)\n")
do
  local _, out = program.run_with("CC='gcc -DX=1'", "", "say(host.compile(args[1], { 'good file.c' }, 'good'))", dir)
  tap.like(out, "true gcc -DX=1 -o good good file.c", "CC may hold flags, and the command line comes back")
end

-- ---- temporary directories ----

do
  local _, out = program.run([[
    local d = host.tempdir()
    host.write_files(d .. "/a", { { name = "b/c", text = "x" } })
    say(d)]])
  tap.ok(out:find("/polhode%-%w+\n$") and not io.open(out:sub(1, -2)), "a temporary directory goes with the program",
    out)
  _, out = program.run("host.out(host.tempdir() .. '\\n') error('x')")
  tap.ok(not io.open(out:sub(1, -2)), "also when the generator fails", out)
  _, out = program.run_with("TMPDIR=" .. dir, "", "say(host.tempdir())")
  tap.like(out, dir .. "/polhode-", "it is made in TMPDIR")
  _, out = program.run_with("TMPDIR=/no/such", "", "say(host.tempdir())")
  tap.is(out, "nil cannot make a temporary directory in /no/such: No such file or directory\n",
    "without a place for it there is a message")
end

-- ---- scenes by name ----

-- A copy of the program that stands alone has no folder of scenes beside it: that of the working folder counts.
shell("cp " .. here .. "/build/polhode lone")
tap.ok(not shell("./lone run own_scene --at 0 >lone.out 2>&1") and not program.read(dir .. "/lone.out"):find("internal",
  1, true), "without a folder of scenes a name is no scene's, and said to be none", program.read(dir .. "/lone.out"))
shell("mkdir bodies && echo 'return scene { name = \"own_scene\", body = solid.sphere { r = 1, mass = 1 } }' " ..
  ">bodies/own_scene.lua")
tap.ok(shell("env -u POLHODE_BODIES ./lone run own_scene --at 0 >lone.out 2>&1"), "./bodies is looked through",
  program.read(dir .. "/lone.out"))

-- ---- signals ----

-- The program is stopped once it says it is ready; its temporary directory must go, and it must die of the signal.
local function stopped(name, signal, number, text)
  program.write(dir .. "/stop.lua", "local d = host.tempdir() host.write_file(args[1], d) " .. text)
  shell("rm -f ready")
  program.shell(string.format([[
    exec 2>/dev/null
    POLHODE_SOURCE=tests/cli/tree %s %s/stop.lua %s/ready 2>%s/stop.err & pid=$!
    (sleep 20; kill -KILL $pid) >/dev/null & guard=$!
    while ! test -s %s/ready; do sleep 0.05; done
    sleep 0.1; kill -%s $pid; wait $pid; echo $? >%s/stop.rc; kill $guard]], os.getenv("POLHODE") or "build/polhode",
    dir, dir, dir, dir, signal, dir))
  local made = program.read(dir .. "/ready")
  tap.is(program.read(dir .. "/stop.rc"), 128 + number .. "\n", name .. ": it dies of " .. signal)
  tap.ok(made and not io.open(made), name .. ": its temporary directory is gone", made)
  tap.is(program.read(dir .. "/stop.err"), "", name .. ": without a message")
end
stopped("a busy loop", "TERM", 15, "while true do end")
stopped("a loop that catches errors", "TERM", 15, "while true do pcall(function() while true do end end) end")
stopped("a scene", "TERM", 15, "while true do host.sandbox('while true do end', '@x', {}) end")
stopped("a child process", "TERM", 15, "host.execute { 'sleep', '25' }")

tap.done(program.finish())
