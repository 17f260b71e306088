#!/usr/bin/env lua5.4
-- links.t - polhode links judges every link of a file; one arm in three formats is one arm.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local run = require "tests.interchange.program"

local binary = program.quick()

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

run.finish()
tap.done()
