#!/usr/bin/env lua5.4
-- mesh.t: polhode mesh: reports, units, messages, exit statuses; host.mesh's table.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What is integrated and counted is tests/runtime/mesh.c's, what is malformed tests/runtime/mesh_read.c's.  The bodies
-- here are a brick of 10 x 20 x 30 file units and the corner tetrahedron.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  local files = ">" .. dir .. "/stdout 2>" .. dir .. "/stderr"
  local status = program.shell("timeout 60 " .. binary .. " mesh " .. arguments .. " " .. files)
  return status, program.read(dir .. "/stdout"), program.read(dir .. "/stderr")
end

local OPEN = [[
v 0 0 0
v 10 0 0
v 10 20 0
v 0 20 0
v 0 0 30
v 10 0 30
v 10 20 30
v 0 20 30
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
]]
local brick, open, flipped, inverted = dir .. "/brick.obj", dir .. "/open.obj", dir .. "/flipped.obj", dir .. "/in.obj"
program.write(brick, OPEN .. "f 4 3 2 1\n")
program.write(open, OPEN)
program.write(flipped, OPEN .. "f 1 2 3 4\n")
program.write(inverted, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\nf 1 1 2\n")

-- The numbers of the line whose label begins so.
local function numbers(text, label)
  local line = ("\n" .. text):match("\n" .. label .. "([^\n]*)")
  local list = {}
  for n in (line or ""):gmatch "%-?%d[%d.e+-]*" do list[#list + 1] = tonumber(n) end
  return list
end

-- 12 digits are printed: half a unit of the last one.
local function close(got, want, what)
  local good = #got >= #want
  for i, x in ipairs(want) do good = good and math.abs(got[i] - x) <= 5e-12 * math.abs(x) end
  tap.ok(good, what, table.concat(got, " ") .. " for " .. table.concat(want, " "))
end

do -- a brick of 1 x 2 x 3 cm, 2.7 g/cm^3: 16.2 g, moments m (b^2 + c^2)/12
  local status, out, err = run(brick .. " --units mm --density '2.7 g/cm^3'")
  tap.ok(status == 0 and err == "", "a closed mesh: status 0, nothing on standard error", err)
  tap.ok(out:find("verdict             closed, no defects\n", 1, true) and
    out:find("6 faces, 12 triangles, 8 vertices, 12 edges\n", 1, true), "counts and verdict", out)
  close(numbers(out, "box"), { 0, 0, 0, 10, 20, 30 }, "box in the file's unit")
  close(numbers(out, "volume"), { 6000 }, "volume in the file's unit")
  close(numbers(out, "mass"), { 0.0162 }, "mass in kg")
  close(numbers(out, "centre of mass"), { 0.005, 0.01, 0.015 }, "centre in m")
  close(numbers(out, "tensor about it"), { 1.755e-6, 1.35e-6, 6.75e-7 }, "tensor")
  close(numbers(out, "principal moments"), { 6.75e-7 }, "the smallest moment first")
  tap.ok(not out:find("-0 ", 1, true), "no minus zero")
end
do
  local _, out = run(brick .. " --mass '2 lb' --units in")
  close(numbers(out, "mass"), { 2 * 0.45359237 }, "a mass with its unit")
  close(numbers(out, "centre of mass"), { 0.127, 0.254, 0.381 }, "inches")
  local _, kg = run(brick .. " --mass 12")
  close(numbers(kg, "tensor about it"), { 1300, 1000, 500 }, "a mass in kg, a file in metres")
  local _, shell = run(brick .. " --kind surface --density '1 kg/m^2'")
  close(numbers(shell, "area"), { 2200 }, "area")
  local _, wires = run(brick .. " --kind=wires --density '3 g/m'")
  close(numbers(wires, "length"), { 240 }, "length: the edges, no diagonals")
  close(numbers(wires, "mass"), { 0.72 }, "density by length")
end
do
  local status, out = run(brick .. " --format json --density 1000")
  tap.ok(status == 0 and out:find('"mass": 6000000.0,', 1, true)
    and out:find('"verdict": "closed, no defects"', 1, true)
    and out:find('"open": 0,', 1, true) and out:find('"inverted": false', 1, true)
    and out:find('"com": [5.0, 10.0, 15.0]', 1, true), "json", out)
end

do -- defects
  local status, out, err, _ = run(open)
  tap.is(status, 1, "the volume of an open mesh: status 1")
  tap.is(out, "", "and nothing on standard output")
  tap.is(err, open .. ": a volume needs closed faces that look outward, got edges with one face only: 4\n" ..
    "    4 edges with one face only\n    --kind surface takes the faces as a shell\n", "its message has the counts")
  status, out = run(open .. " --kind surface")
  tap.ok(status == 0 and out:find("open: the faces do not enclose a volume", 1, true)
    and out:find("4 edges with one face only", 1, true), "an open surface is reported as open", out)
  status, _, err = run(flipped)
  tap.ok(status == 1 and err:find("faces that look to opposite sides: 4\n", 1, true), "a flipped face", err)
  status, out = run(inverted)
  tap.ok(status == 0 and out:find("verdict             closed, but inside out\n", 1, true)
    and out:find("the volume was taken positive", 1, true) and out:find("1 face without area", 1, true),
    "inside out, with a face of no area", out)
  close(numbers(out, "volume"), { 1 / 6 }, "its volume is positive")
  program.write(dir .. "/flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n")
  status, _, err = run(dir .. "/flat.obj")
  tap.ok(status == 1 and err:find("the mesh has no volume, area or length", 1, true), "no volume", err)
  program.write(dir .. "/nan.obj", OPEN .. "f 4 3 2 1\nv nan 0 0\nf 1 2 9\n")
  status, _, err = run(dir .. "/nan.obj")
  tap.ok(status == 1 and err:find("coordinates must be finite, faces with others: 1\n", 1, true), "not finite", err)
  program.write(dir .. "/cut.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 9000000000\n" ..
    "property float x\nproperty float y\nproperty float z\nend_header\n")
  status, _, err = run(dir .. "/cut.ply")
  tap.is(err, dir .. "/cut.ply: byte 124: the file ends within an element\n", "a file cut off: the byte")
  tap.is(status, 1, "malformed: status 1")
end

do -- the command line
  for _, case in ipairs {
    { "", "polhode mesh: FILE is missing" },
    { "nothere.stl", "polhode: cannot read nothere.stl: No such file or directory" },
    { dir, "polhode: cannot read " .. dir .. ": it is not a regular file" },
    { "/dev/zero", "polhode: cannot read /dev/zero: it is not a regular file" },
    { brick .. " --kind solid", "polhode mesh: --kind must be volume, surface or wires, got solid" },
    { brick .. " --units kg", 'polhode mesh: --units: must be in m or a unit of its kind, got "kg"' },
    { brick .. " --units ell", 'polhode mesh: --units: unknown unit "ell"' },
    { brick .. " --mass 1 --density 1", "polhode mesh: --mass and --density exclude each other" },
    { brick .. " --mass 0", "polhode mesh: --mass must be positive, got 0" },
    { brick .. " --mass -1", "polhode mesh: --mass must be positive, got -1" },
    { brick .. " --mass heavy", 'polhode mesh: --mass must be a number, with or without a unit, got "heavy"' },
    { brick .. " --density '1 kg'", 'polhode mesh: --density must be in kg/m^3 or a unit of its kind, got "kg"' },
    { brick .. " --kind wires --density '1 kg/m^2'",
      'polhode mesh: --density must be in kg/m or a unit of its kind, got "kg/m^2"' },
  } do
    local status, out, err = run(case[1])
    local hint = case[2]:find "^polhode mesh" and " (polhode help mesh)\n" or "\n"
    tap.ok(status == 2 and out == "" and err == case[2] .. hint,
      "status 2: " .. case[2]:gsub(dir, "DIR"), err)
  end
end

do -- what the generator is given
  local code, out = program.run([[
local m, none = host.mesh(args[1], "volume")
host.out(string.format("%g %g %g %g %d %d %s %s\n", m.measure, m.com[3], m.sigma[3], m.box.hi[2], m.triangles,
  m.defects.open, m.body, none))
local nothing, message, why = host.mesh(args[2], "volume")
host.out(string.format("%s %s %d %d %g\n", nothing, why.reason, why.defects.open, why.faces, why.measure))
host.out(string.match(message, "[^/]*$") .. "\n")
local b = host.mesh(args[1], "volume", { unit = 1, mass = 12 }).body
host.out(string.format("%g %g %g %g %d\n", b.mass, b.tensor[1], b.moments[1], b.second[1], #b.axes))
host.out(tostring(pcall(host.mesh, args[1], "solid")) .. "\n")
host.out(select(3, host.mesh("/", "volume")).reason .. "\n")
]], brick, open)
  tap.is(code, 0, "host.mesh in a generator of the test's own")
  tap.is(out, "6000 15 75 20 12 0 nil nil\nnil mesh 4 5 0\n" ..
    "open.obj: a volume needs closed faces that look outward, got edges with one face only: 4\n" ..
    "12 1300 500 100 3\nfalse\nfile\n", "its table, its failures")
end

program.finish()
tap.done()
