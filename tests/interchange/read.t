#!/usr/bin/env lua5.4
-- read.t - what an <inertial> of each format means: numbers, frames, units of angles, defaults, names.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Turned tensors are compared with R I R^T taken in 60 decimal digits (mpmath 1.3) from the textbook matrices: Rx, Ry,
-- Rz, Rodrigues' formula, the matrix of a quaternion, Gram and Schmidt; then rounded to double.  The program's way is
-- another (exact expressions through half angles or Rodrigues, evaluated to 240 bits), and both round once: equal
-- doubles.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local run = require "tests.interchange.program"

-- mass, com and tensor {xx, yy, zz, xy, xz, yz} as the program read them: the doubles of what it writes.
local function numbers(file, link)
  local status, out, err = run.inertial(file, "urdf", link)
  if status ~= 0 then return nil, err end
  local list = {}
  local function put(pattern)
    for word in out:match(pattern):gmatch "%S+" do list[#list + 1] = tonumber(word) end
  end
  put 'mass value="([^"]*)"'
  put 'xyz="([^"]*)"'
  for _, k in ipairs { "ixx", "iyy", "izz", "ixy", "ixz", "iyz" } do put(k .. '="([^"]*)"') end
  return list, err
end

local function reads(name, text, want, link)
  run.write("robot.xml", text)
  local got, err = numbers("robot.xml", link)
  local same = got ~= nil
  for i = 1, 10 do same = same and got[i] == want[i] end
  tap.ok(same, name, (got and table.concat(got, ", ") or "") .. "\n" .. table.concat(want, ", ") .. "\n" .. err)
  return err
end

local function silent(name, ...) tap.is(reads(name, ...), "", name .. ": without a warning") end

local function tensor(I) return { 1.5, 0.25, -0.5, 3, table.unpack(I) } end

-- ---- plain ----

local plain = { 1.5, 0.25, -0.5, 3, 0.01, 0.02, 0.015, 0.001, -2e-4, 0.0003 }
local urdf_inertia = '<inertia ixx="0.01" ixy="0.001" ixz="-2e-4" iyy="0.02" iyz="0.0003" izz="0.015"/>'

local function urdf(origin, inertia)
  return '<?xml version="1.0"?>\n<robot name="r"><link name="base"><inertial><origin ' .. origin ..
    '/><mass value="1.5"/>' .. (inertia or urdf_inertia) .. "</inertial></link></robot>"
end
local function sdf(attributes, pose, more)
  return '<sdf version="1.11"><model name="m"><link name="base"><inertial><mass>1.5</mass><pose' .. attributes .. ">" ..
    pose .. "</pose>" .. (more or "<inertia><ixx>1</ixx><ixy>0</ixy><ixz>0</ixz><iyy>2</iyy><iyz>0</iyz>" ..
    "<izz>2.5</izz></inertia>") .. "</inertial></link></model></sdf>"
end
local function mjcf(compiler, orientation, inertia)
  return '<mujoco><compiler ' .. compiler .. '/><worldbody><body name="base"><inertial pos="0.25 -0.5 3" mass="1.5" ' ..
    (inertia or 'diaginertia="1 2 2.5" ') .. orientation .. "/></body></worldbody></mujoco>"
end

silent("URDF", urdf 'xyz="0.25 -0.5 3"', plain)
silent("URDF, spelled otherwise", urdf('rpy="0 0. -0e5" xyz=" +.25\n-5E-1\t3. "', '<inertia ixx="1e-2" ' ..
  'ixy="+1.0e-3" ixz="-.2e-3" iyy="2E-2" iyz="0.00030" izz="15.e-3"/>'), plain)
silent("URDF without origin", "<robot><link name='base'><inertial><mass value='2'/><inertia ixx='1' ixy='0' ixz='0' " ..
  "iyy='1' iyz='0' izz='1'/></inertial></link></robot>", { 2, 0, 0, 0, 1, 1, 1, 0, 0, 0 })
silent("SDF", sdf("", " 0.25 -0.5 3 0 0 0 ", "<inertia><ixx>0.01</ixx><iyy> 0.02 </iyy><izz>0.015</izz>" ..
  "<ixy>0.001</ixy><ixz>-2e-4</ixz><iyz>0.0003</iyz></inertia>"), plain)
silent("MJCF", mjcf("", "", 'fullinertia="0.01 0.02 0.015 0.001 -2e-4 0.0003"'), plain)
silent("MJCF, diagonal", mjcf("", ""), tensor { 1, 2, 2.5, 0, 0, 0 })
silent("an <inertial> of URDF alone", urdf('xyz="0.25 -0.5 3"'):match "<inertial>.*</inertial>", plain)
silent("an <inertial> of SDF alone", sdf("", "0.25 -0.5 3 0 0 0"):match "<inertial>.*</inertial>",
  tensor { 1, 2, 2.5, 0, 0, 0 })
silent("an <inertial> of MJCF alone", mjcf("", ""):match "<inertial .-/>", tensor { 1, 2, 2.5, 0, 0, 0 })
silent("a <link> of URDF alone", urdf('xyz="0.25 -0.5 3"'):match "<link.*</link>", plain)
silent("a <link> of SDF alone", sdf("", "0.25 -0.5 3 0 0 0"):match "<link.*</link>", tensor { 1, 2, 2.5, 0, 0, 0 })

-- The sign of a product: masses at (1, 1, 0) and (-1, -1, 0) have -integral of x y dm = -2, in all three formats.
for _, format in ipairs { "urdf", "mjcf", "sdf" } do
  local _, out = run.explain('return scene { name = "b", body = points { {1, 1, 1, 0}, {1, -1, -1, 0}, ' ..
    '{1, 0, 0, 1}, {1, 0, 0, -1} } }', format)
  local want = { urdf = 'ixy="-2.0"', mjcf = 'fullinertia="4.0 4.0 4.0 -2.0 0.0 0.0"', sdf = "<ixy>-2.0</ixy>" }
  tap.like(out, want[format], format .. ": mass along x = y has a negative ixy")
end

-- ---- turned frames ----

local rpy = { 0.016960988670773156, 0.012613549899383694, 0.015425461429843152, -0.00411559124737777,
  -0.00208031774914867, -5.803195780163973e-05 }
local swap = { 1, 2.5, 2, 0, 0, 0 } -- a quarter turn about x

silent("URDF: rpy about fixed axes, x first", urdf 'xyz="0.25 -0.5 3" rpy="0.3 -0.2 1.1"', tensor(rpy))
silent("URDF: pi/2 in digits is what the digits say", urdf('xyz="0.25 -0.5 3" rpy="1.5707963267948966 0 0"',
  '<inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/>'), tensor { 1, 2.5, 2, 0, 0, -9.615660845819876e-18 })
silent("URDF: quat_xyzw", urdf('xyz="0.25 -0.5 3" quat_xyzw="-1 0 0 1"',
  '<inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/>'), tensor(swap))
silent("SDF: degrees are exact", sdf(' degrees="true"', "0.25 -0.5 3 90 0 -180"), tensor(swap))
silent("SDF: radians as in URDF", sdf("", "0.25 -0.5 3 0.3 -0.2 1.1", "<inertia><ixx>0.01</ixx><iyy>0.02</iyy>" ..
  "<izz>0.015</izz><ixy>0.001</ixy><ixz>-2e-4</ixz><iyz>0.0003</iyz></inertia>"), tensor(rpy))
silent("SDF: quaternion, scalar last", sdf(' rotation_format="quat_xyzw"', "0.25 -0.5 3 -0.1 0.7 0.3 0.5"),
  tensor { 2.145124716553288, 2.1553287981859413, 1.199546485260771, 0.30839002267573695, -0.41723356009070295,
    0.11337868480725624 })

local quat = tensor { 2.145124716553288, 2.1553287981859413, 1.199546485260771, 0.30839002267573695,
  -0.41723356009070295, 0.11337868480725624 }
silent("MJCF: quat, scalar first, of any length", mjcf("", 'quat="0.5 -0.1 0.7 0.3"'), quat)
silent("MJCF: quat of the frame itself", mjcf("", 'quat="-3 0 0 0"'), tensor { 1, 2, 2.5, 0, 0, 0 })
silent("MJCF: axisangle in radians", mjcf('angle="radian"', 'axisangle="1 2 -3 0.7"'),
  tensor { 1.4322458189619993, 1.8040318879180048, 2.263722293119996, 0.33735761362572214, 0.4431790125927798,
    -0.315647467694984 })
silent("MJCF: axisangle in degrees, the default", mjcf("", 'axisangle="1 2 -3 40"'),
  tensor { 1.4303505150702165, 1.8047279526398643, 2.2649215322899194, 0.3373345122882795, 0.4426505793659092,
    -0.31441744256694915 })
silent("MJCF: euler xyz about turning axes, the default", mjcf("", 'euler="20 -50 110"'),
  tensor { 2.2450796442233374, 1.0781524170914139, 2.1767679386852485, 0.2980356664317037, -0.21482349015816224,
    -0.13953013464424133 })
silent("MJCF: eulerseq XYZ about fixed axes", mjcf('eulerseq="XYZ"', 'euler="20 -50 110"'),
  tensor { 2.1127500635971375, 1.7916522697497577, 1.5955976666531047, -0.025980382227047433, 0.33983242191827356,
    -0.6316705188415058 })
silent("MJCF: eulerseq XYZ is URDF's rpy", '<mujoco><compiler angle="radian" eulerseq="XYZ"/><worldbody><body>' ..
  '<inertial mass="1.5" pos="0.25 -0.5 3" euler="1.5707963267948966 0 0" diaginertia="1 2 2.5"/></body>' ..
  "</worldbody></mujoco>",
  tensor { 1, 2.5, 2, 0, 0, -9.615660845819876e-18 })
silent("MJCF: eulerseq zXz, mixed", mjcf('eulerseq="zXz"', 'euler="20 -50 110"'),
  tensor { 1.5868240888334653, 2.050950466818494, 1.8622254443480408, 0.31651111077974453, -0.3772032533677445,
    0.5351563944218126 })
for i, c in ipairs {
  { "1 2 3 -1 1 0.5", { 2.0077793493635077, 1.9568599717114568, 1.5353606789250354, -0.004243281471004243,
    -0.3330975954738331, -0.6364922206506365 } },
  { "-1 0.1 0.2 0.1 -1 0.3", { 1.0709148024191182, 2.0355704303916387, 2.393514767189243, 0.1276495801773237,
    0.29074922200692854, 0.12046268569079913 } },
  { "-1 0.1 0.2 0.1 1 0.3", { 1.0601689868234945, 2.034943795131393, 2.4048872180451126, 0.07161468026501898,
    0.2650375939849624, -0.1593984962406015 } },
  { "0.1 -0.2 1 0.3 -1 0.1", { 2.449514523331558, 2.002101683805154, 1.0483837928632882, 0.15488549305584007,
    -0.11397435372198779, 0.18493178745544675 } } } do
  silent("MJCF: xyaxes, " .. i, mjcf("", 'xyaxes="' .. c[1] .. '"'), tensor(c[2]))
end
-- half turns, whose quaternion has no scalar part: about y, and about (1, 2, 2) with R = 2 n nT - 1 by hand
silent("MJCF: xyaxes, half a turn about y", mjcf("", 'xyaxes="-1 0 0 0 1 0"'), tensor { 1, 2, 2.5, 0, 0, 0 })
silent("MJCF: xyaxes, half a turn about (1, 2, 2)", mjcf("", 'xyaxes="-7 4 4 4 -1 8"'),
  tensor { 121 / 81, 178 / 81, 293 / 162, 44 / 81, 26 / 81, -20 / 81 })
silent("MJCF: zaxis", mjcf("", 'zaxis="0.3 -0.4 -1.2"'), tensor { 1.9319526627218935, 1.1952662721893492,
  2.3727810650887573, -0.31952662721893493, -0.03550295857988166, 0.35502958579881655 })
silent("MJCF: zaxis upside down", mjcf("", 'zaxis="0 0 -2"', 'diaginertia="1 2 2.5" '), tensor { 1, 2, 2.5, 0, 0, 0 })

-- ---- which link ----

local two = [[<robot name="r">
  <link name="world"/>
  <link name="a"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="b"><inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>]]
silent("a link by its name", two, { 2, 0, 0, 0, 1, 1, 1, 0, 0, 0 }, "b")
silent("a body inside bodies", '<mujoco><worldbody><body name="a"><body name="b"><frame><body name="c"><inertial ' ..
  'pos="0 0 0" mass="3" diaginertia="1 1 1"/></body></frame></body></body></worldbody></mujoco>',
  { 3, 0, 0, 0, 1, 1, 1, 0, 0, 0 }, "c")
local nested = '<sdf version="1.9"><world name="w"><model name="arm"><link name="base"><inertial><mass>4</mass>' ..
  '<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>' ..
  "</model>" ..
  '<model name="leg"><link name="base"><inertial><mass>5</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz>' ..
  "<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link></model></world></sdf>"
silent("a link of one of two models", nested, { 5, 0, 0, 0, 1, 1, 1, 0, 0, 0 }, "leg::base")

-- ---- what is assumed, is said ----

tap.like(reads("SDF without mass: 1 kg", sdf("", "0.25 -0.5 3 0 0 0"):gsub("<mass>.-</mass>", ""),
  { 1, 0.25, -0.5, 3, 1, 2, 2.5, 0, 0, 0 }), 'robot.xml:1: link "m::base": <inertial> has no <mass>: ' ..
  "the format's default is 1 kg", "and says so")
tap.like(reads("SDF without inertia: 1 kg m^2", sdf("", "0.25 -0.5 3 0 0 0", ""), tensor { 1, 1, 1, 0, 0, 0 }),
  "<inertial> has no <inertia>: the format's default is ixx = iyy = izz = 1 kg m^2", "and says so")
tap.like(reads("SDF without products", sdf("", "0.25 -0.5 3 0 0 0", "<inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz>" ..
  "</inertia>"), tensor { 1, 2, 2.5, 0, 0, 0 }), "<inertia> has no ixy, ixz, iyz: the format's default is " ..
  "1 for moments, 0 for products", "and says which")
tap.like(reads("SDF: relative_to", sdf(' relative_to="other"', "0.25 -0.5 3 0 0 0"), tensor { 1, 2, 2.5, 0, 0, 0 }),
  "<pose> relative_to is ignored", "is said to be ignored")
tap.like(reads("URDF: nine entries", urdf('xyz="0.25 -0.5 3"', urdf_inertia:gsub("/>", ' iyx="5"/>')), plain),
  "<inertia> iyx is not read", "the entries that nobody reads are named")
tap.like(reads("MJCF: inertiafromgeom", mjcf('inertiafromgeom="true"', ""), tensor { 1, 2, 2.5, 0, 0, 0 }),
  "makes MuJoCo use the geoms; read is what <inertial> says", "warns")
tap.like(reads("MJCF: balanceinertia", mjcf('balanceinertia="true"', ""), tensor { 1, 2, 2.5, 0, 0, 0 }),
  "balanceinertia lets MuJoCo change moments that break the triangle inequality", "warns")

run.finish()
tap.done()
