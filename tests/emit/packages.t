#!/usr/bin/env lua5.4
-- packages.t - gen --project make, cmake, arduino, platformio, zephyr: are they what those ecosystems expect?
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- make and cmake are built, tested, installed and used from another project.  The Arduino library runs in
-- tests/target/arduino.t.  Of PlatformIO and Zephyr only the form of the files is checked and the examples are compiled
-- for this machine; Zephyr's kernel is a stand-in of this test.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local json = require "tests.json"
local firmware = require "tests.emit.firmware"

local dir = program.directory()
local run, read = firmware.run, program.read
local WARN = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local function list(folder)
  local names = {}
  for name in run(folder, "find . -type f | LC_ALL=C sort"):gmatch "%./([^\n]+)" do names[#names + 1] = name end
  return table.concat(names, " ")
end

local layout = {
  make = "LICENSE Makefile README.md polhode.manifest probe.c probe.h probe_orbit.c probe_orbit.h " ..
    "probe_private.h probe_test.c qemu.c qemu.ld",
  cmake = "CMakeLists.txt LICENSE README.md include/probe.h include/probe_orbit.h polhode.manifest src/probe.c " ..
    "src/probe_orbit.c src/probe_private.h tests/probe_test.c",
  arduino = "LICENSE README.md examples/probe_motion/probe_motion.ino extras/probe_test.c keywords.txt "
    .. "library.properties polhode.manifest src/probe.c src/probe.h src/probe_orbit.c "
    .. "src/probe_orbit.h src/probe_private.h",
  platformio = "LICENSE README.md examples/motion/platformio.ini examples/motion/src/main.c extras/probe_test.c "
    .. "include/probe.h include/probe_orbit.h library.json polhode.manifest src/probe.c src/probe_orbit.c "
    .. "src/probe_private.h",
  zephyr = "LICENSE README.md extras/probe_test.c include/probe.h include/probe_orbit.h polhode.manifest " ..
    "samples/motion/CMakeLists.txt "
    .. "samples/motion/prj.conf samples/motion/sample.yaml samples/motion/src/main.c src/probe.c src/probe_orbit.c "
    .. "src/probe_private.h zephyr/CMakeLists.txt zephyr/Kconfig zephyr/module.yml",
}
local scene = (firmware.probe:gsub("horizon = 32", "horizon = exact(\"200/4096\")"))
local at = {}
for _, kind in ipairs { "make", "cmake", "arduino", "platformio", "zephyr" } do
  local folder, why = firmware.make(dir, scene, "--project " .. kind)
  if not tap.ok(folder, "gen --project " .. kind, why) then os.exit(1) end
  at[kind] = folder
  tap.is(list(folder), layout[kind], kind .. ": the files are where they belong")
  local again = folder .. "again"
  os.rename(folder, again)
  firmware.make(dir, scene, "--project " .. kind)
  local text, ok = run(dir, "diff -r " .. folder .. " " .. again)
  tap.ok(ok, kind .. ": the same bytes once more", text)
  text = run(folder, "cat " .. layout[kind])
  local bad = text:find(dir, 1, true)
  for name in text:gmatch "%${([^}]*)}" do -- CMake's own are in capitals, and pkg-config's are not used
    if not name:find "^[%u_]+$" then bad = name end
  end
  tap.ok(not bad, kind .. ": no path of this machine, nothing left of the templates", bad)
  for line in read(folder .. "/README.md"):gmatch "[^\n]+" do
    local name = line:match "^| ([%w_/.]+) |"
    if name and name:find "[./]" and not io.open(folder .. "/" .. name) then
      local found = run(folder, "find . -name '" .. name .. "'")
      if found == "" then tap.ok(false, kind .. ": README.md names a file that is there", name) end
    end
  end
end

-- ---- make ----

local consumer = dir .. "/consumer"
run(".", "mkdir -p " .. consumer)
program.write(consumer .. "/main.c", [[
#include <probe.h>
#include <stdio.h>

int main(void)
{
  probe_model m;
  double x[PROBE_NX];

  if (probe_init(&m, 0) != 0) return 1;
  probe_initial(&m, x);
  probe_step(&m, 0, x, 0, 1.0/4096);
  printf("%.6f\n", x[PROBE_WZ]);
  return 0;
}
]])
local want = string.format("%.6f\n", firmware.truth(dir .. "/probe.lua", { 1 / 4096 })[1][7])
local text, ok = run(at.make, "make -s lib install DESTDIR=" .. dir .. "/stage PREFIX=/usr")
tap.ok(ok, "make: lib and install", text)
tap.is(list(dir .. "/stage"), "usr/include/probe.h usr/include/probe_orbit.h usr/lib/libprobe.a " ..
  "usr/lib/pkgconfig/probe.pc",
  "make: header, library and pkg-config file under DESTDIR PREFIX")
text = run(consumer, string.format("PKG_CONFIG_SYSROOT_DIR=%s/stage PKG_CONFIG_PATH=%s/stage/usr/lib/pkgconfig "
  .. "PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1 PKG_CONFIG_ALLOW_SYSTEM_LIBS=1 sh -c "
  .. "\"cc main.c -o made \\$(pkg-config --cflags --libs probe)\" && ./made", dir, dir))
tap.is(text, want, "make: a program finds it by pkg-config and runs")

-- ---- cmake ----

local _, cmake = run(".", "command -v cmake")
if cmake then
  text, ok = run(at.cmake, "cmake -B build -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS='-Wall -Wextra -Werror' && "
    .. "cmake --build build && cd build && ctest")
  tap.ok(ok and text:find "100%% tests passed, 0 tests failed out of 1", "cmake: configured, built, tested by ctest",
    text)
  text, ok = run(at.cmake, "cmake --install build --prefix " .. dir .. "/prefix")
  tap.ok(ok, "cmake: installed", text)
  tap.like(list(dir .. "/prefix"), "include/probe.h", "cmake: the header")
  program.write(consumer .. "/CMakeLists.txt", [[
cmake_minimum_required(VERSION 3.13)
project(consumer LANGUAGES C)
find_package(probe 0.1.0 REQUIRED)
add_executable(found main.c)
target_link_libraries(found PRIVATE probe::probe)
]])
  text, ok = run(consumer, "cmake -B build -DCMAKE_PREFIX_PATH=" .. dir .. "/prefix && cmake --build build")
  tap.ok(ok, "cmake: find_package(probe) in another project", text)
  tap.is(run(consumer, "./build/found"), want, "cmake: which links probe::probe and runs")
  program.write(consumer .. "/CMakeLists.txt", string.format([[
cmake_minimum_required(VERSION 3.13)
project(consumer LANGUAGES C)
add_subdirectory(%s probe)
add_executable(inside main.c)
target_link_libraries(inside PRIVATE probe::probe)
]], at.cmake))
  text, ok = run(consumer, "rm -rf build && cmake -B build && cmake --build build --target inside && ls build/probe")
  tap.ok(ok and not text:find "probe_test", "cmake: add_subdirectory, without its tests", text)
  tap.is(run(consumer, "./build/inside"), want, "cmake: and that runs")
else
  tap.skip("cmake: built, tested, installed, found", "install cmake")
end

-- ---- arduino: library.properties by the specification of the IDE (1.5) ----

local properties = {}
for key, value in read(at.arduino .. "/library.properties"):gmatch "([%w_]+)=([^\n]*)\n" do properties[key] = value end
for _, key in ipairs { "name", "version", "author", "maintainer", "sentence", "paragraph", "category",
  "architectures" } do
  tap.ok((properties[key] or "") ~= "", "arduino: library.properties has " .. key)
end
tap.ok(properties.name:find "^%w[%w_. -]*$" and #properties.name <= 63, "arduino: the name is one that the IDE takes")
tap.ok(properties.version:find "^%d+%.%d+%.%d+$", "arduino: the version has three numbers")
tap.is(properties.includes, "probe.h", "arduino: and the header that the IDE includes")
local kinds = {}
for line in read(at.arduino .. "/keywords.txt"):gmatch "[^\n]+" do
  if line:sub(1, 1) ~= "#" then kinds[line:match "^[%w_]+\t(%u+%d)$" or line] = true end
end
local count = 0
for _ in pairs(kinds) do count = count + 1 end
tap.ok(count == 3 and kinds.KEYWORD1 and kinds.KEYWORD2 and kinds.LITERAL1,
  "arduino: keywords.txt has a word, a tab and its kind, no more")
local none, why = firmware.make(dir, "bodies/brick.lua", "--project arduino --real double")
tap.like(not none and why, "project arduino: must be in float", "arduino: double is refused")

-- ---- names that a kind of project has taken ----

for _, case in ipairs {
  { "cmake", "test", "a target of CMake's own" }, { "cmake", "install", "a target of CMake's own" },
  { "make", "Makefile", "a file of the project" }, { "make", "qemu", "a file of the project" },
} do
  local kind, name, what = table.unpack(case)
  local path = dir .. "/" .. name .. ".lua"
  local f = assert(io.open(path, "w"))
  f:write(string.format("return scene { name = %q, body = solid.sphere { r = 1, mass = 1 }, effects = {},\n", name),
    "  initial = { omega = { 0, 0, 1 } } }\n")
  f:close()
  local made, refusal = firmware.make(dir, path, "--project " .. kind)
  tap.like(not made and refusal, "project " .. kind .. ": the scene must not be named like " .. what,
    kind .. ": a scene is not named " .. name)
end

-- ---- platformio: library.json by its schema ----

local manifest = json.read(read(at.platformio .. "/library.json"))
tap.ok(manifest.name:find "^[%w_ .-]+$" and #manifest.name <= 100, "platformio: no character of the name is reserved")
tap.ok(manifest.version:find "^%d+%.%d+%.%d+$" and manifest.description ~= "", "platformio: version and description")
tap.ok(manifest.frameworks == "*" and manifest.platforms == "*", "platformio: for all frameworks and platforms")
tap.ok(manifest.headers == "probe.h" and manifest.license == "MIT-0", "platformio: header and licence")
for _, name in ipairs(manifest.examples[1].files) do
  tap.ok(read(at.platformio .. "/" .. manifest.examples[1].base .. "/" .. name),
    "platformio: the example has its " .. name)
end
text, ok = run(at.platformio, string.format("cc %s -O2 -ffp-contract=off -I%s -o motion examples/motion/src/main.c "
  .. "%s/probe.c -lm && ./motion", WARN, manifest.build.includeDir, manifest.build.srcDir))
tap.ok(ok, "platformio: library and example compile for this machine without a warning", text)
local rows, times = {}, {}
for line in text:gmatch "[^\n]+" do
  local row = {}
  for word in line:gmatch "[^,]+" do row[#row + 1] = tonumber(word) end
  if row[1] then rows[#rows + 1], times[#times + 1] = row, row[1] end
end
tap.is(#rows, 21, "platformio: 21 rows of the motion")
local truth, worst = firmware.truth(dir .. "/probe.lua", times), 0
for i, row in ipairs(rows) do
  for k = 1, 7 do worst = math.max(worst, math.abs(row[k + 1] - truth[i][k])) end
end
-- in float, as the cores of its boards: time and states of some 20 units of 2^-24 (the states are at most 2 here)
tap.ok(worst <= 20 * 2.0 ^ -23, "platformio: which are the library's", worst)
tap.like(read(at.platformio .. "/include/probe.h"), "typedef float probe_real;", "platformio: in float unless asked")
tap.like(read(at.zephyr .. "/include/probe.h"), "typedef float probe_real;", "zephyr: too")

-- ---- zephyr ----

-- The subset of YAML that is used: keys in blocks, lists of words.
local function yaml(source)
  local root = {}
  local stack = { { indent = -1, node = root } }
  for line in source:gmatch "[^\n]+" do
    local indent, rest = line:match "^( *)(.*)$"
    if rest ~= "" and rest:sub(1, 1) ~= "#" then
      while stack[#stack].indent >= #indent do table.remove(stack) end
      local node = stack[#stack].node
      local key, value = rest:match "^([%w_.]+):%s*(.*)$"
      local item = rest:match "^%- (.+)$"
      if item then
        node[#node + 1] = item
      elseif not key then
        error("yaml: " .. line)
      elseif value == "" then
        node[key] = {}
        stack[#stack + 1] = { indent = #indent, node = node[key] }
      else
        node[key] = value
      end
    end
  end
  return root
end

local module = yaml(read(at.zephyr .. "/zephyr/module.yml"))
tap.is(module.name, "probe", "zephyr: module.yml names the module")
tap.ok(module.build.cmake == "zephyr" and read(at.zephyr .. "/zephyr/CMakeLists.txt"),
  "zephyr: and where its CMakeLists.txt is")
tap.ok(read(at.zephyr .. "/" .. module.build.kconfig), "zephyr: and its Kconfig")
local kconfig = read(at.zephyr .. "/zephyr/Kconfig")
local symbol = kconfig:match "\nconfig ([%u%d_]+)\n\tbool \""
tap.is(symbol, "POLHODE_PROBE", "zephyr: Kconfig defines a symbol of its own")
tap.like(read(at.zephyr .. "/zephyr/CMakeLists.txt"), "if(CONFIG_" .. symbol .. ")",
  "zephyr: on which the module depends")
tap.like(read(at.zephyr .. "/samples/motion/prj.conf"), "\nCONFIG_" .. symbol .. "=y\n",
  "zephyr: and which the sample sets")
local sample = yaml(read(at.zephyr .. "/samples/motion/sample.yaml"))
tap.is(sample.tests["sample.polhode.probe.motion"].harness_config.regex[1], '"t,qw,qx,qy,qz,wx,wy,wz"',
  "zephyr: sample.yaml says what the sample prints")
if cmake then
  program.write(dir .. "/zephyr.cmake", string.format([[
foreach(name zephyr_library_named zephyr_library_sources zephyr_library_compile_options zephyr_include_directories)
  function(${name})
    message(STATUS "${name} ${ARGV}")
  endfunction()
endforeach()
set(CONFIG_%s y)
include(%s/zephyr/CMakeLists.txt)
]], symbol, at.zephyr))
  text, ok = run(dir, "cmake -P zephyr.cmake")
  tap.ok(ok, "zephyr: CMakeLists.txt calls what Zephyr has", text)
else
  tap.skip("zephyr: CMakeLists.txt is read", "install cmake")
end
run(".", "mkdir -p " .. dir .. "/kernel/zephyr/sys")
program.write(dir .. "/kernel/zephyr/kernel.h", "#define k_msleep(ms) ((void)(ms))\n")
program.write(dir .. "/kernel/zephyr/sys/printk.h", "#include <stdio.h>\n#define printk printf\n")
text, ok = run(at.zephyr, string.format("cc %s -O2 -ffp-contract=off -Iinclude -I%s/kernel -o motion "
  .. "samples/motion/src/main.c src/probe.c -lm && ./motion", WARN, dir))
tap.ok(ok, "zephyr: module and sample compile for this machine without a warning", text)
worst, count = 0, 0
for line in text:gmatch "[^\n]+" do
  local k = 0
  count = count + (line:find "^%-?%d" and 1 or 0)
  for word in line:gmatch "%-?%d+" do
    k = k + 1
    if rows[count] then worst = math.max(worst, math.abs(tonumber(word) / 1e6 - rows[count][k])) end
  end
end
tap.ok(count == 21 and worst <= 1.01e-6, "zephyr: the sample prints the motion, cut to millionths", worst)

program.finish()
tap.done()
