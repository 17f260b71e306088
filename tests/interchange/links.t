#!/usr/bin/env lua5.4
-- links.t - polhode links judges every link of a file; one arm in three formats is one arm.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local run = require "tests.interchange.program"

local binary = program.quick()
local absolute = os.getenv "POLHODE" or "build/polhode"
if absolute:sub(1, 1) ~= "/" then absolute = assert(io.popen "pwd"):read "l" .. "/" .. absolute end

local function polhode(words)
  local status = program.shell(string.format("timeout 60 %s %s >%s/out 2>%s/err", binary, words, run.dir, run.dir))
  return status, program.read(run.dir .. "/out"), program.read(run.dir .. "/err")
end

local function prints(words, status, out, err)
  local s, o, e = polhode(words)
  tap.ok(s == status and o == out and e == err, "polhode " .. words, "status " .. s .. "\n" .. o .. e .. out .. err)
end

prints("links tests/interchange/arm.urdf", 1, [[
ok     "upper": mass 1.2, com 0.1 0 0.02, xx yy zz xy xz yz 0.002 0.005 0.006 -0.0003 0 0
no     "lower"
      tests/interchange/arm.urdf:16: link "lower": <inertia> triangle inequality about the centre of mass: ]] .. [[
zz <= xx + yy must hold, got 1.676359 > 0.0026619 + 0.0023025; most likely: zz has a slipped decimal point or ]] .. [[
is off by a unit's 1e3 (0.001676359 would satisfy it)
URDF: 3 links, 2 with <inertial>: 1 wrong, 0 with a warning; 1 static
]], "")
prints("links tests/interchange/arm.xml", 0, [[
ok     "upper": mass 1.2, com 0.1 0 0.02, xx yy zz xy xz yz 0.002 0.005 0.006 -0.0003 0 0
ok     "lower": mass 1.559, com 0.05 0 0, xx yy zz xy xz yz 0.0026 0.0023 0.0017 0 0 0 in a turned frame
MJCF: 2 links, 2 with <inertial>: 0 wrong, 0 with a warning; 0 static
]], "")
prints("links tests/interchange/arm.sdf", 0, [[
ok     "arm::upper": mass 1.2, com 0.1 0 0.02, xx yy zz xy xz yz 0.002 0.005 0.006 -0.0003 0 0
warn   "arm::lower": mass 1, com 0.05 0 0, xx yy zz xy xz yz 0.0026 0.0023 0.0017 0 0 0 in a turned frame
      tests/interchange/arm.sdf:12: link "arm::lower": <inertial> has no <mass>: the format's default is 1 kg
SDF: 2 links, 2 with <inertial>: 0 wrong, 1 with a warning; 0 static
]], "")
prints("links no/such/file", 2, "", "polhode: cannot read no/such/file: No such file or directory\n")
prints("links README.md", 2, "", "polhode: README.md:1: this is no XML; read are URDF, MJCF and SDF\n")
run.write("x.xml", "<a/>")
prints("links " .. run.dir .. "/x.xml", 2, "",
  "polhode: " .. run.dir .. "/x.xml:1: the root must be <robot> (URDF), <mujoco> (MJCF), <sdf> (SDF) or an " ..
  "<inertial> of one of them, got <a>\n")

do
  local first
  for _, name in ipairs { "arm.urdf", "arm.xml", "arm.sdf" } do
    run.write(name, program.read("tests/interchange/" .. name))
    local _, out, err = run.inertial(name, "urdf", "upper")
    first = first or out
    tap.ok(out == first and out:find 'ixy="%-0.0003"', name .. ": the same upper arm", out .. err)
  end
end

-- The library, which gets the shape and its rotation, and the emitted code agree on a turned inertial.
run.write("lower.lua", 'return scene { name = "lower", body = inertial { file = "arm.xml", link = "lower" } }')
do
  local status, out, err = polhode("check --states 100 " .. run.dir .. "/lower.lua")
  tap.ok(status == 0 and not out:find "not ok", "polhode check agrees on a turned inertial", out .. err)
end

-- ---- what nobody reads, what never moves, what is probably in another unit ----

-- The lines that `polhode links` prints of a text, without those of good links; status and standard error.
local function said(text, name)
  run.write(name, text)
  local status = program.shell(string.format("cd %s && timeout 60 %s links %s >out 2>err", run.dir, absolute, name))
  local lines = {}
  for line in program.read(run.dir .. "/out"):gmatch "[^\n]+" do
    if not line:find "^ok" then lines[#lines + 1] = (line:gsub("^(%l+ +\"[%w:]+\": mass).*", "%1")) end
  end
  return status, table.concat(lines, "\n"), program.read(run.dir .. "/err")
end

local function judged(what, text, name, status, out, err)
  local s, o, e = said(text, name)
  tap.ok(s == status and o == out and e == (err or ""), what, "status " .. s .. "\n" .. o .. "\n" .. e .. out)
end

local entries = 'ixx="0.1" ixy="0" ixz="0" iyy="0.15" iyz="0" izz="0.2"'
local none = 'ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"'
local function link(name, inertial) return '<link name="' .. name .. '">' .. inertial .. "</link>\n" end
local function inertial(mass, I, more)
  return '<inertial><mass value="' .. mass .. '"/><inertia ' .. I .. "/>" .. (more or "") .. "</inertial>"
end

judged("URDF: elements and attributes that nobody reads", "<robot>\n" ..
  link("a", inertial(1, entries, "\n<pose>1 0 0 0 0 0</pose>\n<Origin xyz='1 0 0'/>")) ..
  link("b", inertial(1, entries .. ' iyx="0"', "text<origin xyz='0 0 0' rpy='0 0 90'/>")) ..
  link("c", "<Inertial/><mass value='1'/>") .. "<Link/></robot>", "r.urdf", 0, [[
warn   "a": mass
      r.urdf:3: link "a": <pose> in <inertial> is not read: URDF has <origin xyz= rpy=>
      r.urdf:4: link "a": <Origin> in <inertial> is not read: did you mean <origin>?
warn   "b": mass
      r.urdf:5: link "b": <inertial> "text" is not read: its numbers are in elements
      r.urdf:5: link "b": <inertia> iyx is not read
      r.urdf:5: link "b": <origin> rpy is in radians and 90 looks like degrees
warning: r.urdf:7: <Link> in <robot> is not read: did you mean <link>?
warning: r.urdf:6: link "c": <Inertial> in <link> is not read: did you mean <inertial>?
warning: r.urdf:6: link "c": <mass> in <link> is not read: it belongs into <inertial>
URDF: 3 links, 2 with <inertial>: 0 wrong, 2 with a warning; 1 static]])

judged("URDF: static links, and a body without moments", "<robot>" .. link("world", "") ..
  link("base", inertial(1, 'ixx="5" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"')) .. link("zero", inertial(0, none)) ..
  link("point", inertial(0.754, none)) .. link("free", inertial(1, entries)) ..
  '<joint name="j" type="fixed"><parent link="world"/><child link="base"/></joint>' ..
  '<joint name="k" type="fixed"><parent link="free"/><child link="point"/></joint></robot>', "r.urdf", 1, [[
static "base": fixed to "world"
      r.urdf:2: link "base": <inertia> triangle inequality about the centre of mass: xx <= yy + zz must hold, ]] .. [[
got 5 > 1 + 3
static "zero": no mass and no moments
no     "point"
      r.urdf:4: link "point": <inertia> has no moment of inertia about the centre of mass, so its rotation ]] .. [[
is undetermined
URDF: 5 links, 4 with <inertial>: 1 wrong, 0 with a warning; 3 static]])

judged("URDF: a ring of fixed joints ends", "<robot>" .. link("a", inertial(1, entries)) ..
  '<joint type="fixed"><parent link="a"/><child link="a"/></joint></robot>', "r.urdf", 0,
  "URDF: 1 link, 1 with <inertial>: 0 wrong, 0 with a warning; 0 static")

local I = "<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia>"
judged("SDF 1.2, static models, what nobody reads", '<gazebo version="1.2"><world name="w">\n' ..
  '<model name="m"><static>true</static>' .. link("a", "<inertial><mass>1</mass>" .. I .. "</inertial>") ..
  "</model>" ..
  '<model name="n">' .. link("b", '<inertial><origin xyz="1 0 0"/><mass value="2">1</mass>' .. I ..
  '<pose degrees="true">0 0 0 1.5708 0 0</pose><density>3</density></inertial>') .. link("c", "") ..
  link("d", "<inertial><mass>1</mass>" .. I .. "</inertial>") ..
  '<joint type="fixed"><parent>world</parent><child>d</child></joint></model></world></gazebo>', "r.sdf", 0, [[
static "m::a": its model is static
warn   "n::b": mass
      r.sdf:3: link "n::b": <origin> in <inertial> is not read: SDF has <pose>
      r.sdf:3: link "n::b": <mass> value is not read: SDF has the number between the tags
      r.sdf:3: link "n::b": <density> in <inertial> is not read
      r.sdf:3: link "n::b": <pose> is in degrees and 1.5708 looks like radians
static "n::d": fixed to the world
SDF: 4 links, 3 with <inertial>: 0 wrong, 1 with a warning; 2 static; 1 without <inertial>: ]] ..
  "the format's default is 1 kg and unit moments")

judged("MJCF: what nobody reads, bodies without <inertial>", '<mujoco><worldbody><body name="a">' ..
  '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1" rpy="0 0 1" eulr="0 0 1"><mass/></inertial>\n' ..
  '<body name="b"><geom size="1"/></body></body>' ..
  '<body name="c"><inertial pos="0 0 0" mass="1" diaginertia="1 1 1" euler="0 1.57 0"/></body>' ..
  '</worldbody><compiler eulrseq="XYZ" autolimits="true"/></mujoco>', "r.xml", 0, [[
warn   "a": mass
      r.xml:1: body "a": <inertial> rpy is not read: MJCF has euler=
      r.xml:1: body "a": <inertial> eulr is not read: did you mean euler?
      r.xml:1: body "a": <mass> in <inertial> is not read: MJCF has the attribute mass=
      r.xml:2: body "a": <compiler> eulrseq is not read: did you mean eulerseq?
warn   "c": mass
      r.xml:2: body "c": <compiler> eulrseq is not read: did you mean eulerseq?
      r.xml:2: body "c": <inertial> euler is in degrees and 1.57 looks like radians
MJCF: 3 links, 2 with <inertial>: 0 wrong, 2 with a warning; 0 static; 1 without <inertial>: MuJoCo takes their geoms]])

-- ---- nothing was checked ----

judged("a robot without links", "<robot/>", "r.urdf", 2, "",
  "polhode: r.urdf: nothing was checked: URDF without a <link>\n")
judged("links in a macro", '<robot xmlns:xacro="x">\n<xacro:macro name="m"><link name="a"/></xacro:macro></robot>',
  "r.urdf", 2, "warning: r.urdf:2: <xacro:macro> is not expanded (run xacro first); links that it makes are not read",
  "polhode: r.urdf: nothing was checked: URDF without a <link>\n")
judged("bodies of geoms", '<mujoco><worldbody><body name="a"/></worldbody><include file="x"/></mujoco>', "r.xml", 2, "",
  "polhode: r.xml: nothing was checked: MJCF without a <body> that has <inertial>: MuJoCo takes their geoms; " ..
  "included files are not read\n")

-- ---- marks of editors, and other formats ----

local robot = "<robot>" .. link("a", inertial(1, 'ixx="5" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"')) .. "</robot>"
for what, text in pairs {
  ["a byte order mark"] = "\xef\xbb\xbf<?xml version='1.0'?>\n\n\n" .. robot,
  ["blank lines before the declaration"] = "\n \n<?xml version='1.0'?>\n" .. robot,
  ["a mark and blank lines"] = "\xef\xbb\xbf\r\n\r\n<?xml version='1.0'?>\r\n" .. robot,
  ["zero bytes at the end"] = "\n\n\n" .. robot .. "\n\0\0\0\26\0" } do
  local status, out = said(text, "r.urdf")
  tap.ok(status == 1 and out:find('r.urdf:4: link "a": <inertia> triangle', 1, true), what .. ": read, lines kept", out)
end
for text, want in pairs {
  ["version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 12345\n"] = ": is a pointer of Git's large-file " ..
    "storage, not the file (git lfs pull fetches it)",
  ["\n#usda 1.0\n"] = ": is a USD scene, which is not read; read are URDF, MJCF and SDF",
  ["PK\3\4xx"] = ": is a ZIP archive (also USDZ, 3MF, FMU); unpack it first",
  ["solid x\n"] = ": is a mesh (STL): polhode mesh reads it",
  ["<COLLADA/>"] = ":1: the root must be <robot> (URDF), <mujoco> (MJCF), <sdf> (SDF) or an <inertial> of one of " ..
    "them, got <COLLADA>: it is COLLADA, which is not read",
  ["robot a"] = ":1: this is no XML; read are URDF, MJCF and SDF",
  ["<robot/>\n<robot/>"] = ":2: text after the end of the root element",
  ["<robot>"] = ":1: no element found", [""] = ":1: no element found" } do
  judged("no robot file: " .. text:sub(1, 12), text, "r.urdf", 2, "", "polhode: r.urdf" .. want .. "\n")
end
run.write("r.urdf", "version https://git-lfs.github.com/spec/v1\n")
do
  local _, _, err = run.inertial("r.urdf", "urdf")
  tap.like(err, "s.lua:1: inertial: r.urdf: is a pointer of Git's large-file storage", "inertial{} says the same")
end

run.finish()
tap.done()
