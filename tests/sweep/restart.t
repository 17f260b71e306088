#!/usr/bin/env lua5.4
-- restart.t - the program of a sweep: the same bytes for any threads, blocks, ranks, kills; and what stops it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One run with one thread and blocks of another size is the oracle of all others, which are compared as bytes; sweep.t
-- says that its numbers are right.  Processes are killed with SIGKILL after random times, by their own number.  Parts
-- that need MPI or HDF5 are skipped without them.  POLHODE_KILLS=50: so many kills of each kind.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = program.quick()
local KILLS = tonumber(os.getenv "POLHODE_KILLS") -- nil: what the tier has time for

local function output(format, ...)
  local pipe = assert(io.popen("{ " .. string.format(format, ...) .. "; } 2>&1"))
  local text = pipe:read "a"
  local _, why, code = pipe:close()
  return why == "signal" and 128 + code or code, text
end

local function there(command) return program.shell("command -v " .. command .. " >/dev/null 2>&1") == 0 end

local function emit(name, options)
  local code, text = output("POLHODE_SOURCE=. %s sweep tumbling_box %s --emit %s/%s", binary, options, dir, name)
  if code ~= 0 then tap.diag(text) end
  return code == 0
end

-- Compiles it with what `make` of its own Makefile takes; the program's path.
local function build(name, with)
  local code, text = output("make -s -C %s/%s TUNE= %s && mv %s/%s/tumbling_box_sweep %s/%s.run", dir, name, with, dir,
    name, dir, name)
  if code ~= 0 then tap.diag(text) end
  return code == 0 and dir .. "/" .. name .. ".run"
end

local VARIED = "--sample 20000 --vary 'wx=normal(1,0.1),a=uniform(0.15,0.25)' --until 2 --keep final " ..
  "--keep 'first: flip = wy'"
tap.ok(emit("rows", VARIED) and emit("stats", VARIED .. " --stats"), "programs are emitted")
local hdf5 = program.shell "pkg-config --exists hdf5-serial 2>/dev/null" == 0
local rows, stats = build("rows", hdf5 and "" or "HDF5=0"), build("stats", hdf5 and "" or "HDF5=0")
if not tap.ok(rows and stats, "and made by their Makefiles") then
  program.finish()
  tap.done()
end

local function run(path, options) return output("cd %s && timeout 300 %s %s", dir, path, options) end
local function same(a, b) return program.shell(string.format("cmp -s %s/%s %s/%s", dir, a, dir, b)) == 0 end

-- ---- workers ----

tap.is(run(rows, "-o one.csv --threads 1 --block 777"), 0, "one thread computes the oracle")
local text = program.read(dir .. "/one.csv") or ""
tap.is(select(2, text:gsub("\n", "")), 20001, "with a row for each member")
for _, options in ipairs { "--threads 2", "--threads 3 --block 1", "--threads 4 --block 100000" } do
  run(rows, "-o other.csv " .. options)
  tap.ok(same("one.csv", "other.csv"), options .. ": the same bytes")
end
local code = output("cd %s && %s -o - --threads 2 > out.csv", dir, rows)
tap.ok(code == 0 and same("one.csv", "out.csv"), "on standard output, too")
tap.is(output("ls -d %s/*.blocks %s/*.new 2>/dev/null | wc -l", dir, dir), 0, "nothing is left beside the files")
run(stats, "-o one_s.csv --threads 1 --block 777")
for _, options in ipairs { "--threads 2", "--threads 3 --block 10" } do
  run(stats, "-o other_s.csv " .. options)
  tap.ok(same("one_s.csv", "other_s.csv"), "statistics, " .. options .. ": the same bytes")
end

-- ---- statistics of the rows ----

local function table_of(csv) -- numbers by row and column
  local list = {}
  for line in csv:gmatch "[^\n]+" do
    local cells = {}
    for cell in (line .. ","):gmatch "([^,]*)," do cells[#cells + 1] = tonumber(cell) or cell end
    list[#list + 1] = cells
  end
  return list
end

do
  local given, tables = table_of(text), table_of(program.read(dir .. "/one_s.csv") or "")
  local column, sum, square, sorted, n = 3, 0.0, 0.0, {}, #given - 1 -- a
  for i = 2, #given do sum = sum + given[i][column] end
  local mean = sum / n
  for i = 2, #given do
    square = square + (given[i][column] - mean) ^ 2
    sorted[i - 1] = given[i][column]
  end
  table.sort(sorted)
  local row = tables[3]
  tap.is(row[1], "a", "a row for each quantity")
  tap.is(row[2], n, "which counts the members")
  -- this sum in order rounds 20000 times, at most 2^-53 of its size each
  tap.ok(math.abs(row[4] / mean - 1) < 20000 * 2.0 ^ -53, "the mean is that of the rows")
  tap.ok(math.abs(row[5] ^ 2 / (square / (n - 1)) - 1) < 20000 * 2.0 ^ -52, "so is the deviation")
  tap.ok(row[6] == sorted[1] and row[7] == sorted[n], "least and greatest value are there to the bit")
  local median = sorted[n // 2 + 1] -- by its bucket: 2^-8 of the distance from member 0
  tap.ok(math.abs(row[12] - median) <= 2.0 ^ -8 * math.abs(median - given[2][column]) * 1.01,
    "the median is within its bucket of 2^-8")
  local bins, at = 0, nil
  for i, r in ipairs(tables) do at = r[1] == "histogram" and i or at end
  for i = 4, #tables[at + 2] do bins = bins + tables[at + 2][i] end
  tap.is(bins, n, "a histogram has all members")
end

-- ---- kills ----

math.randomseed(20261123) -- the times of the kills are the machine's all the same
-- Runs `start` (a shell's job that is killed by `kill`) until it was killed so often.  One that finishes before its
-- kill is compared, and the next begins anew.  Were all that finished the same, how many were killed.
local function killed(file, oracle, kills, start, kill, longest)
  local good, some = true, 0
  for _ = 1, 10 * kills do
    local status, said = output("cd %s && { %s -o %s --resume & p=$!; sleep %.3f; %s; wait $p; }", dir, start, file,
      longest * (0.1 + 0.9 * math.random()), kill())
    if status == 0 then
      good = good and same(oracle, file)
      os.remove(dir .. "/" .. file)
    elseif status >= 124 then -- 124: timeout's own TERM
      some = some + 1
    elseif said:find "another process works in" then -- ranks whose mpirun was killed end a little later
      program.shell "sleep 0.2"
    else
      good = false
      tap.diag(said)
    end
    if some == kills then break end
    if math.random() < 0.2 then -- as a machine that stopped: the log's end is torn, or has something else
      output("cd %s/%s.blocks && for f in rank-*.log; do head -c 77 /dev/urandom >> $f; done", dir, file)
    end
  end
  return good, some
end
local function itself() return "kill -9 $p 2>/dev/null" end
for _, case in ipairs { { rows, "killed.csv", "one.csv", KILLS or tier.quick and 3 or 8 },
  { stats, "killed_s.csv", "one_s.csv", KILLS and KILLS // 5 or tier.quick and 2 or 4 } } do
  local path, file, oracle, kills = table.unpack(case)
  local good, some = killed(file, oracle, kills, path .. " --threads 1", itself, 0.3)
  local status, said = run(path, "-o " .. file .. " --threads 2 --resume")
  tap.is(some, kills, file .. " was killed so often, at random moments")
  if not tap.ok(good and status == 0 and same(oracle, file), "--resume gives the same bytes") then tap.diag(said) end
end

-- ---- the parent is killed ----

-- polhode itself is killed, which cannot tell its child: the child must end on its own and leave what --resume takes.
local here = os.getenv "PWD"
if program.shell "test -d /proc/self" == 0 then
  local sweep = string.format("POLHODE_SOURCE=%s %s/build/polhode sweep tumbling_box %s --threads 1 -o orphan.csv",
    here, here, (VARIED:gsub("20000", "400000")))
  local _, told = output("cd %s && { exec 3>&1; %s & p=$!; i=0; c=; while [ -z \"$c\" -o ! -s " ..
    "orphan.csv.blocks/rank-00000.log ] && [ $i -lt 600 ]; do sleep 0.1; c=$(pgrep -P $p -f orphan.csv); " ..
    "i=$((i + 1)); done; kill -9 $p; wait $p 2>/dev/null; i=0; while kill -0 $c 2>/dev/null && [ $i -lt 50 ]; do " ..
    "sleep 0.1; i=$((i + 1)); done; kill -0 $c 2>/dev/null && { echo it lives; kill -9 $c; } || echo it ended; }",
    dir, sweep)
  tap.ok(told:find "it ended" and told:find "stopped by signal 15", "kill -9 of polhode ends the program that it runs")
  if not told:find "it ended" then tap.diag(told) end
  tap.ok(program.shell("test -s " .. dir .. "/orphan.csv.blocks/rank-00000.log") == 0,
    "and what it computed is there for --resume")
  output("rm -rf %s/orphan.csv.blocks", dir)
end

-- ---- what stands in the way ----

local status, said
output("cd %s && { %s -o half.csv --threads 1 & p=$!; sleep 0.15; kill -9 $p; wait $p; }", dir, rows)
status, said = run(rows, "-o half.csv")
tap.ok(status == 2 and said:find "%-%-resume goes on", "without --resume what is there is neither used nor lost")
status, said = run(stats, "-o half.csv --resume")
tap.ok(status == 2 and said:find "half.csv.blocks is of another study", "blocks of another sweep are refused")
status, said = run(rows, "-o half.csv --resume --block 3")
tap.ok(status == 2 and said:find "%-%-block", "and blocks of another size")
output("cd %s && { %s -o term.csv --threads 1 & p=$!; sleep 0.15; kill -TERM $p; wait $p; }", dir, rows)
status = run(rows, "-o term.csv --resume")
tap.ok(status == 0 and same("one.csv", "term.csv"), "after SIGTERM it goes on")
output("cd %s && rm -rf lost.csv.blocks; { %s -o lost.csv --threads 1 & p=$!; sleep 0.15; kill -9 $p; wait $p; }; " ..
  "rm lost.csv.blocks/rank-00000.log", dir, rows)
status = run(rows, "-o lost.csv --resume")
tap.ok(status == 0 and same("one.csv", "lost.csv"), "a log that was lost is computed again")
status, said = run(rows, "-o one.csv --resume")
tap.ok(status == 0 and said:find "nothing is left to resume", "a sweep that is complete says so")
status, said = run(stats, "-o one.csv --resume")
tap.ok(status == 2 and said:find "of another study" and said:find("there  polhode sweep tumbling_box", 1, true) and
  said:find("now    polhode sweep tumbling_box", 1, true) and said:find "%-%-stats", "a file of another study " ..
  "is an error that names both", said)
local whole = program.read(dir .. "/one.csv")
for what, changed in pairs { -- each by itself: order is lost anyway
  ["is cut"] = whole:sub(1, #whole // 2), ["has another digit"] = whole:gsub(",1", ",2", 1),
  ["is something else"] = "x\n" } do
  program.write(dir .. "/one.csv", changed)
  status, said = run(rows, "-o one.csv --resume")
  tap.ok(status == 2 and said:find "not what the sweep wrote", "a file that " .. what .. " is not resumed", said)
end
program.write(dir .. "/one.csv", whole)
program.write(dir .. "/any.csv", "t,x\n")
status, said = run(rows, "-o any.csv --resume")
tap.ok(status == 2 and said:find "nothing can be resumed" and program.read(dir .. "/any.csv") == "t,x\n",
  "nor one of which nobody says whose it is", said)
status, said = run(rows, "-o nowhere/x.csv")
tap.ok(status == 2 and said:find "nowhere", "a folder that is missing is named")
status, said = output("cd %s && ulimit -f 200 && trap '' XFSZ && %s -o full.csv --threads 1", dir, rows)
tap.ok(status == 2 and said:find "full.csv.blocks" and said:find "with room %-%-resume goes on",
  "a disk without room ends it with a message")
if status ~= 2 then tap.diag(said) end
status = run(rows, "-o full.csv --resume")
tap.ok(status == 0 and same("one.csv", "full.csv"), "and with room it finishes")
status, said = output("%s -o - --threads 2 > /dev/full", rows)
tap.ok(status == 2 and said:find "standard output", "standard output that is full is no success")
for _, case in ipairs { { "--threads 0", "--threads must be" }, { "-o x.txt", "must end in .csv or .h5" },
  { "--nothing", "no option --nothing" }, { "--resume", "--resume: it needs" } } do
  status, said = run(rows, case[1])
  tap.ok(status == 2 and said:find(case[2], 1, true) ~= nil, "said: " .. case[2])
end
status, said = run(rows, "--about")
tap.ok(status == 0 and said:find "fingerprint  %x+" and said:find "members      20000", "--about tells what it is")

-- ---- HDF5 ----

local CHECK = [==[
import sys, h5py, csv
f = h5py.File(sys.argv[1], "r")
rows = list(csv.reader(open(sys.argv[2])))
bad = 0
for k, name in enumerate(rows[0]):
    column = f[name]
    assert name == "member" or column.dims[0][0].name == "/member"
    for i in (0, 1, 777, 1024, 19999):
        if name != "status":
            want, got = float(rows[i + 1][k]), float(column[i])
            bad += not (want == got or want != want and got != got)
        else:
            bad += column.attrs["flag_meanings"].split()[column[i]] != rows[i + 1][k]
assert f["wx"].attrs["units"] == "rad/s" and f.attrs["seed"] == 1 and "tumbling_box" in f.attrs["scene"]
print("differences", bad)
]==]
local XARRAY = [==[
import sys, h5py, xarray
d = xarray.open_dataset(sys.argv[1], engine="h5netcdf")
f = h5py.File(sys.argv[1], "r")
assert dict(d.sizes) == {"member": 20000}, d.sizes
assert "member" in d.coords and int(d.member[777]) == 777
for name in f:
    if name == "status":
        assert d[name].attrs["flag_meanings"]
    elif name != "member":
        assert d[name].dims == ("member",) and d[name].attrs["units"] == f[name].attrs["units"]
        assert d[name].values.tobytes() == f[name][:].tobytes(), name
assert abs(float(d.sel(member=slice(10, 12)).a.mean()) - f["a"][10:13].mean()) < 1e-12
print("it is read")
]==]
local STATS = [==[
import sys, numpy, xarray
d = xarray.open_dataset(sys.argv[1])
assert d.covariance.dims == ("quantity", "other") and d.histogram.dims == ("quantity", "bin"), d
names = [x.decode() if isinstance(x, bytes) else x for x in d.quantity.values]
a = names.index("a")
r = xarray.open_dataset(sys.argv[2], engine="h5netcdf")
r = r.isel(member=numpy.flatnonzero(~numpy.isnan(r.flip)))
assert abs(float(d.covariance[a, names.index("wx")]) - numpy.cov(r.a, r.wx)[0, 1]) < 1e-12
assert int(d.histogram[a].sum()) == int(d["count"][a]) == 20000
assert int(d.status[0]) == 20000 and d.quantiles.dims == ("quantity", "probability")
print("they are read")
]==]

if hdf5 then
  run(rows, "-o one.h5 --threads 1 --block 777")
  run(rows, "-o other.h5 --threads 3")
  tap.ok(same("one.h5", "other.h5"), "HDF5: the same bytes for other threads and blocks")
  run(stats, "-o one_s.h5 --threads 2")
  tap.ok(program.shell("h5dump -d /covariance " .. dir .. "/one_s.h5 > /dev/null 2>&1") == 0 or not there "h5dump",
    "statistics as HDF5")
  program.write(dir .. "/check.py", CHECK)
  if program.shell "/usr/bin/python3 -c 'import h5py' 2>/dev/null" == 0 then
    status, said = output("/usr/bin/python3 %s/check.py %s/one.h5 %s/one.csv", dir, dir, dir)
    if not tap.ok(status == 0 and said:find "differences 0", "h5py reads the numbers of the CSV") then
      tap.diag(said)
    end
  else
    tap.skip("h5py reads the numbers of the CSV", "there is no h5py (Debian package python3-h5py)")
  end
  if program.shell "/usr/bin/python3 -c 'import xarray, h5netcdf' 2>/dev/null" == 0 then
    program.write(dir .. "/xarray.check", XARRAY)
    status, said = output("/usr/bin/python3 - %s/one.h5 < %s/xarray.check", dir, dir)
    tap.ok(status == 0 and said:find "it is read", "xarray opens it as a table over the dimension member")
    if status ~= 0 then tap.diag(said) end
    program.write(dir .. "/stats.check", STATS)
    status, said = output("/usr/bin/python3 - %s/one_s.h5 %s/one.h5 < %s/stats.check", dir, dir, dir)
    tap.ok(status == 0 and said:find "they are read", "and statistics over quantities", said)
  else
    tap.skip("xarray opens it", "there is no xarray (Debian packages python3-xarray, python3-h5netcdf)")
  end
else
  tap.skip("HDF5", "there is no HDF5 (Debian package libhdf5-dev)")
end
if hdf5 then
  -- the logs fit, the file does not: it has the members' numbers besides
  local size = #program.read(dir .. "/one.h5")
  status, said = output("cd %s && ulimit -f %d && trap '' XFSZ && %s -o tight.h5 --threads 1", dir,
    size // 512 - 20, rows)
  tap.ok(status == 2 and said:find "tight.h5: cannot be written" and not said:find "[Ss]egmentation",
    "a disk that fills while the file is written", status .. " " .. said)
end
local plain = build("rows", "HDF5=0")
status, said = run(plain, "-o x.h5")
tap.ok(status == 2 and said:find "built without HDF5", "without HDF5 it says what is missing")

-- ---- ranks ----

local MPIRUN = "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 " ..
  "OMPI_MCA_btl_vader_single_copy_mechanism=none timeout 300 mpirun"

local function ranks_agree(library, path, launcher)
  for _, n in ipairs { 1, 2, 4 } do
    local file = string.format("%s%d.csv", library, n)
    status, said = output("cd %s && %s -n %d %s -o %s", dir, launcher, n, path, file)
    tap.ok(status == 0 and said == "" and same("one.csv", file), library .. ", " .. n .. " ranks: the same bytes")
    if status ~= 0 or said ~= "" then tap.diag(said) end
  end
end

if there "mpicc.openmpi" and there "mpirun.openmpi" then
  local ranks = build("rows", "MPI=1 CC=mpicc.openmpi HDF5=0")
  local mpirun = MPIRUN .. ".openmpi"
  ranks_agree("openmpi", ranks, mpirun)
  -- any of the three ranks is killed, or mpirun with all of them
  local function one_of_them()
    local which = math.random(4)
    if which == 4 then return "kill -9 $(pgrep -P $p) 2>/dev/null" end
    return string.format("m=$(pgrep -P $p); kill -9 $(pgrep -P $m | sed -n %dp) 2>/dev/null", which)
  end
  -- Open MPI 4.1's mpirun may wait for ever if a rank is killed while it starts: its ranks are gone, and so must it be
  local hasty = mpirun:gsub("timeout 300", "timeout -k 1 20")
  local kills = KILLS or tier.quick and 2 or 4
  local good, some = killed("rk.csv", "one.csv", kills, hasty .. " -n 3 " .. ranks, one_of_them, 1.0)
  tap.is(some, kills, "ranks were killed so often, at random moments")
  for _ = 1, 20 do -- ranks of a launcher that was killed live on for a moment, and hold their file
    status, said = output("cd %s && %s -n 2 %s -o rk.csv --resume", dir, mpirun, ranks)
    if not said:find("another process works in", 1, true) then break end
    os.execute "sleep 1"
  end
  tap.ok(good and status == 0 and same("one.csv", "rk.csv"), "other ranks finish, with the same bytes")
  if status ~= 0 then tap.diag(said) end
else
  tap.skip("2 and 4 ranks", "there is no Open MPI (Debian packages libopenmpi-dev, openmpi-bin)")
end
if there "mpicc.mpich" and there "mpirun.mpich" then
  ranks_agree("mpich", build("rows", "MPI=1 CC=mpicc.mpich HDF5=0"), "timeout 300 mpirun.mpich")
else
  tap.skip("ranks of MPICH", "there is no MPICH (Debian packages mpich, libmpich-dev)")
end

program.finish()
tap.done()
