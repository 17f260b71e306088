#!/usr/bin/env lua5.4
-- messages.t - what is wrong with a robot file is said once, with file, line and element; nothing wrong is accepted.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local run = require "tests.interchange.program"

-- Standard error must be the lines `want` (a string, or a list), each "s.lua:1: inertial: ..." and the source below it.
local function refused(want, scene_argument)
  local scene = "return scene { name = \"b\", body = inertial { " .. scene_argument .. " } }"
  local status, out, err = run.explain(scene, "urdf")
  local lines = {}
  for i, w in ipairs(type(want) == "table" and want or { want }) do
    lines[i] = "s.lua:1: inertial: " .. w .. "\n    " .. scene .. "\n"
  end
  local name = type(want) == "table" and want[1] or want
  tap.ok(status == 1 and out == "" and err == table.concat(lines), name,
    "status " .. status .. "\n" .. out .. err .. table.concat(lines))
end

local function file(text, want, link)
  run.write("r.urdf", text)
  refused(want, 'file = "r.urdf"' .. (link and ', link = "' .. link .. '"' or ""))
end

-- ---- which files ----

refused('file must be relative to the scene\'s folder, got "/etc/passwd"', 'file = "/etc/passwd"')
refused('file must be in the scene\'s folder or below it, without .., got "../r.urdf"', 'file = "../r.urdf"')
refused('file must be in the scene\'s folder or below it, without .., got "a/../../r.urdf"', 'file = "a/../../r.urdf"')
refused('file must be in the scene\'s folder or below it, without .., got ".."', 'file = ".."')
refused("file must be the name of a file, got \"\"", 'file = ""')
refused("file must be the name of a file, got nothing", "")
refused("file must be the name of a file, got 3", "file = 3")
refused("file must not contain control characters, got \"a\\0b\"", 'file = "a\\0b"')
refused("link must be a name, got 3", 'file = "r.urdf", link = 3')
refused({ "unknown argument \"body\" (it has file, link)", "cannot read r.urdf: No such file or directory" },
  'file = "r.urdf", body = "x"')
run.shell("mkdir " .. run.dir .. "/sub")
refused("cannot read sub: it is a directory", 'file = "sub"')
run.write("sub/r.urdf", "<robot>")
refused("sub/r.urdf:1: no element found", 'file = "sub/r.urdf"')

-- A scene elsewhere: names are relative to it, not to where the program runs.
run.write("sub/s.lua", 'return scene { name = "b", body = inertial { file = "x.urdf" } }')
do
  local binary = os.getenv "POLHODE" or "build/polhode"
  run.write("sub/x.urdf", '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>' ..
    "</inertial>")
  tap.is(run.shell(binary .. " explain " .. run.dir .. "/sub/s.lua --format mjcf >" .. run.dir .. "/out"), 0,
    "names are relative to the scene")
end

-- ---- the text ----

file("", "r.urdf:1: no element found")
file("<robot>\n<link></robot>", "r.urdf:2: mismatched tag")
file("<!DOCTYPE r [<!ENTITY a 'b'>]>\n<robot/>", "r.urdf:1: a document type declaration is not allowed")
file("<html/>", "r.urdf:1: the root must be <robot> (URDF), <mujoco> (MJCF), <sdf> (SDF) or an <inertial> of one of " ..
  "them, got <html>: it is a web page: fetch the file itself")
file("<inertial/>", "r.urdf:1: the root must be <robot> (URDF), <mujoco> (MJCF), <sdf> (SDF) or an <inertial> of " ..
  "one of them, got <inertial>")

-- ---- which link ----

local I = ' ixy="0" ixz="0" iyy="1" iyz="0" izz="1"'
local good = '<inertial><mass value="1"/><inertia ixx="1"' .. I .. "/></inertial>"
local two = '<robot>\n<link name="a">' .. good .. '</link>\n<link name="b">' .. good ..
  '</link>\n<link name="c"/></robot>'
file("<robot/>", "r.urdf:1: link must name a <link> with <inertial> (there are none)")
file(two, 'r.urdf:1: link must name a <link> with <inertial> (there are "a", "b")')
file(two, 'r.urdf:1: no <link> with <inertial> has this name (there are "a", "b"), got "d"', "d")
file(two, 'r.urdf:4: <link> "c" has no <inertial>', "c")
file(good, 'r.urdf:1: the file is one <inertial>, which has no name, got "a"', "a")
file('<robot>\n<link name="a">' .. good .. '</link>\n<link name="a">' .. good .. "</link></robot>",
  'r.urdf:1: more than one <link> has this name ("a" in line 2, "a" in line 3), got "a"', "a")
file('<mujoco><include file="more.xml"/></mujoco>', 'r.urdf:1: no <body> with <inertial> has this name (there are ' ..
  'none; files that it includes are not read), got "a"', "a")

-- ---- URDF ----

local function urdf(inertial, want)
  file('<robot>\n<link name="a">\n<inertial>' .. inertial .. "</inertial></link></robot>", want)
end
local at, mass = 'r.urdf:3: link "a": ', '<mass value="1"/>'
local function inertia(xx, rest) return mass .. '<inertia ixx="' .. xx .. '"' .. (rest or I) .. "/>" end

urdf('<inertia ixx="1"' .. I .. "/>", at .. "<inertial> has no <mass>")
urdf(mass, at .. "<inertial> has no <inertia>")
urdf("", { at .. "<inertial> has no <mass>", at .. "<inertial> has no <inertia>" })
urdf('<mass/><inertia ixx="1"' .. I .. "/>", at .. "<mass> value is missing")
urdf('<mass value="-1"/><inertia ixx="1"' .. I .. "/>", at .. "mass must be positive, got -1")
urdf('<mass value="0"/><inertia ixx="1"' .. I .. "/>", at .. "mass must be positive, got 0")
for _, word in ipairs { "one", "1/3", "0x1p3", "nan", "inf", "1e", "1e5.0", "--1", "1,5", ".", "+" } do
  urdf(inertia(word), at .. '<inertia> ixx must be a number, got "' .. word .. '"')
end
urdf(inertia("${i}"), at .. '<inertia> ixx must be a number (expand xacro files first), got "${i}"')
urdf(inertia("1e400"), at .. '<inertia> ixx must be within the range of double, got "1e400"')
urdf(inertia("1e-400"), at .. '<inertia> ixx must be within the range of double, got "1e-400"')
urdf(inertia("1e-299999"), at .. '<inertia> ixx must be within the range of double, got "1e-299999"')
urdf(inertia("1e999999999"), at .. '<inertia> ixx must be within the range of double, got "1e999999999"')
urdf(inertia("0." .. ("3"):rep(399)), at .. "<inertia> ixx must have at most 400 characters, got \"0." ..
  ("3"):rep(35) .. "...\"")
urdf(inertia("1 2"), at .. '<inertia> ixx must be one number, got "1 2"')
urdf(inertia(""), at .. "<inertia> ixx must be one number, got none")
urdf(mass .. '<inertia ixx="1" ixy="0" ixz="0" iyy="1" izz="1"/>', at .. "<inertia> iyz is missing")
urdf(inertia(1) .. '<origin xyz="1 2"/>', at .. '<origin> xyz must be 3 numbers, got "1 2"')
urdf(inertia(1) .. '<origin rpy="1 2 3 4"/>', at .. '<origin> rpy must be 3 numbers, got "1 2 3 4"')
urdf(inertia(1) .. '<origin rpy="0 0 0" quat_xyzw="0 0 0 1"/>', at .. "<origin> must have rpy or quat_xyzw, not both")
urdf(inertia(1) .. '<origin quat_xyzw="0 0 0 0"/>', at .. "<origin> quat_xyzw must not be zero")
urdf(inertia(1) .. mass, at .. "<inertial> must have one <mass>, got 2")
urdf(inertia(1) .. "</inertial><inertial>", at .. "<link> must have one <inertial>, got 2")

-- tensors that no body has
urdf(inertia(-1), at .. "<inertia> xx must not be negative, got -1")
urdf(inertia(5), at .. "<inertia> triangle inequality about the centre of mass: xx <= yy + zz must hold, " ..
  "got 5 > 1 + 1; most likely: xx has a slipped decimal point (0.5 would satisfy it)")
urdf(inertia(1, ' ixy="2" ixz="0" iyy="1" iyz="0" izz="1"'), at .. "<inertia> |xy| <= " ..
  "sqrt((yy + zz - xx)(zz + xx - yy))/2 must hold about the centre of mass, got 2 > 0.5; most likely: xy has a " ..
  "slipped decimal point (0.2 would satisfy it)")
urdf(inertia(2, ' ixy="0.6" ixz="0.6" iyy="2" iyz="0.6" izz="2"'), at .. "<inertia> triangle inequality of " ..
  "the principal moments about the centre of mass must hold, got 3.2 > 1.4 + 1.4 from xx 2, yy 2, zz 2, xy 0.6, " ..
  "xz 0.6, yz 0.6; most likely: xy, xz, yz are products of inertia and want the other sign")
-- a lost decimal point in izz, as reported of a robot's file; and a plate's zz too large by 1e-14, some 45 units
urdf(mass .. '<inertia ixx="2661.9E-6" ixy="-31.029E-6" ixz="9.34E-6" iyy="2302.5E-6" iyz="151.466E-6" ' ..
  'izz="1676359E-6"/>',
  at .. "<inertia> triangle inequality about the centre of mass: zz <= xx + yy must hold, got 1.676359 > 0.0026619 " ..
  "+ 0.0023025; most likely: zz has a slipped decimal point or is off by a unit's 1e3 (0.001676359 would satisfy it)")
urdf(inertia(1, ' ixy="0" ixz="0" iyy="1" iyz="0" izz="2.00000000000001"'), at .. "<inertia> triangle inequality " ..
  "about the centre of mass: zz <= xx + yy must hold, got 2.00000000000001 > 1 + 1; most likely: the entries of a " ..
  "flat or thin body were rounded (more digits, or the sum itself, would satisfy it)")

-- An impossible part is found also where the whole looks possible.
run.write("r.urdf", "<inertial>" .. inertia(5) .. "</inertial>")
do
  local status, _, err = run.explain('return scene { name = "b", body = inertial { file = "r.urdf" } + ' ..
    "solid.box { x = 9, y = 9, z = 9, mass = 9 } }", "urdf")
  tap.ok(status == 1 and err:find("triangle inequality about the centre of mass: xx <= yy + zz", 1, true),
    "an impossible part of a sum is refused", err)
end

-- ---- SDF ----

local function sdf(inertial, want)
  file('<sdf version="1.9"><model name="m"><link name="a">\n' .. inertial .. "</link></model></sdf>", want)
end
local entries = "<ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz>"
local here = 'r.urdf:2: link "m::a": '
local function inertial(more)
  return "<inertial><mass>1</mass><inertia>" .. entries .. "</inertia>" .. more .. "</inertial>"
end
sdf('<inertial auto="true"/>', here .. "<inertial auto=\"true\"> leaves the numbers to the simulator; write them out")
sdf(inertial "<pose>1 2 3</pose>", here .. '<pose> must be 6 numbers, got "1 2 3"')
sdf(inertial '<pose rotation_format="quat_xyzw">1 2 3 0 0 0</pose>',
  here .. '<pose> must be 7 numbers, got "1 2 3 0 0 0"')
sdf(inertial '<pose rotation_format="quat_xyzw">1 2 3 0 0 0 0</pose>', here .. "<pose> quaternion must not be zero")
sdf(inertial '<pose rotation_format="x">1 2 3 0 0 0 0</pose>', here .. "<pose> rotation_format must be euler_rpy or " ..
  'quat_xyzw, got "x"')
sdf("<inertial><mass>x</mass><inertia>" .. entries .. "</inertia></inertial>",
  here .. '<mass> must be a number, got "x"')
sdf("<inertial><mass>1</mass><inertia>" .. entries:gsub("<ixx>1", "<ixx>") .. "</inertia></inertial>",
  here .. "<ixx> must be one number, got none")

-- ---- MJCF ----

local function mjcf(attributes, want, compiler)
  file("<mujoco>\n<compiler " .. (compiler or "") .. '/>\n<worldbody>\n<body name="a"><inertial ' .. attributes ..
    "/></body></worldbody></mujoco>", want)
end
local there, on = 'r.urdf:4: body "a": <inertial> ', 'r.urdf:2: body "a": <compiler> '
local full = 'pos="0 0 0" mass="1" diaginertia="1 1 1" '
mjcf('pos="0 0 0" diaginertia="1 1 1"', there .. "mass is missing")
mjcf('mass="1" diaginertia="1 1 1"', there .. "pos is missing")
mjcf('pos="0 0 0" mass="1"', there .. "diaginertia or fullinertia is missing")
mjcf(full .. 'fullinertia="1 1 1 0 0 0"', there .. "fullinertia and diaginertia exclude each other")
mjcf('pos="0 0 0" mass="1" fullinertia="1 1 1 0 0 0" quat="1 0 0 0"',
  there .. "fullinertia and quat exclude each other")
mjcf('pos="0 0 0" mass="1" fullinertia="1 1 1 0 0"', there .. 'fullinertia must be 6 numbers, got "1 1 1 0 0"')
mjcf(full .. 'quat="1 0 0 0" euler="0 0 0"', there .. "quat and euler exclude each other")
mjcf(full .. 'quat="0 0 0 0"', there .. "quat must not be zero")
mjcf(full .. 'zaxis="0 0 0"', there .. "zaxis must not be zero")
mjcf(full .. 'axisangle="0 0 0 1"', there .. "axisangle must have an axis that is not zero")
mjcf(full .. 'xyaxes="1 0 0 0 0 0"', there .. "xyaxes must have axes that are not zero")
mjcf(full .. 'xyaxes="1 2 3 -2 -4 -6"', there .. "xyaxes must have axes that are not parallel")
mjcf(full, on .. 'angle must be degree or radian, got "grad"', 'angle="grad"')
mjcf(full, on .. 'eulerseq must be three of x, y, z, X, Y, Z, got "xyw"', 'eulerseq="xyw"')
mjcf(full, on .. 'coordinate="global" is not supported any more', 'coordinate="global"')
mjcf('pos="0 0 0" mass="1" diaginertia="1 1 3"',
  there .. "triangle inequality about the centre of mass: zz <= xx + yy must hold, got 3 > 1 + 1; most likely: zz " ..
  "has a slipped decimal point (0.3 would satisfy it)")

run.finish()
tap.done()
