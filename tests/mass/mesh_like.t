#!/usr/bin/env lua5.4
-- mesh_like.t - a mesh is a shape like any other: moved, scaled, cut, joined, welded, in another unit or another
-- format it is the same body, or the complaint is the same.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- All scenes are read in one run of the program, which alone can read meshes.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local meshes = require "tests.mass.meshes"

local dir = program.directory()
local state = 20260

local function random()
  state = (state * 6364136223846793005 + 1442695040888963407) & 0x7fffffffffffffff
  return (state >> 20 & 0xffffffff) / 0x100000000
end

local function write(name, m, format)
  program.write(dir .. "/" .. name .. "." .. (format or "obj"), meshes.text(m, format or "obj"))
end

local list, number = {}, {} -- scenes: bodies

-- The number of the scene with this body.
local function scene(body)
  if not number[body] then
    list[#list + 1] = body
    number[body] = #list
    program.write(dir .. "/s" .. #list .. ".lua", "return scene { name = \"s\", body = " .. body .. " }\n")
  end
  return number[body]
end

local pairs_of = {} -- {kind, a, b, name}

local function same(a, b, name, how) pairs_of[#pairs_of + 1] = { "same", scene(a), scene(b), name, how } end
local function alike(a, b, part, name) pairs_of[#pairs_of + 1] = { "alike", scene(a), scene(b), name, part } end
local function says(a, part, name) pairs_of[#pairs_of + 1] = { "says", scene(a), part, name } end
local function holds(a, mass, part, name) pairs_of[#pairs_of + 1] = { "holds", scene(a), mass, name, part } end

local function mesh(name, more) return "mesh { file = \"" .. name .. "\"" .. (more or ", density = 1000") .. " }" end

-- ---- a boulder, again and again ----

local boulder = meshes.boulder(1, 0.7, { 0.25, -0.5, 0.125 }, random)
local function moved(f, flip) return meshes.map(boulder, f, flip) end
for _, format in ipairs(meshes.formats) do
  write("a", boulder, format)
  same(mesh "a.obj", mesh("a." .. format), "as " .. format)
end
write("bom", boulder)
program.write(dir .. "/bom.obj", "\xef\xbb\xbf" .. meshes.text(boulder, "obj"))
program.write(dir .. "/bom.stl", "\xef\xbb\xbf" .. meshes.text(boulder, "stl"))
program.write(dir .. "/bom.ply", "\xef\xbb\xbf" .. meshes.text(boulder, "ply"))
for _, format in ipairs { "obj", "stl", "ply" } do same(mesh "a.obj", mesh("bom." .. format),
  "a byte-order mark in " .. format) end

write("mm", moved(function(p) return { 1000 * p[1], 1000 * p[2], 1000 * p[3] } end))
write("double", moved(function(p) return { 2 * p[1], 2 * p[2], 2 * p[3] } end))
write("long", moved(function(p) return { p[1], 2 * p[2], p[3] } end))
write("mirror", moved(function(p) return { -p[1], p[2], p[3] } end, true))
write("shift", moved(function(p) return { p[1] + 1, p[2] - 2, p[3] + 0.5 } end))
write("quarter", moved(function(p) return { -p[2], p[1], p[3] } end))
write("shear", moved(function(p) return { p[1] + p[2] / 2, p[2], p[3] } end))
for _, how in ipairs { ", density = 1000", ", mass = 3" } do
  local function of(name) return mesh(name .. ".obj", how) end
  same(of "mm":gsub(" }$", ", units = \"mm\" }"), of "a", "in mm" .. how)
  same(of "double", of "a" .. ":scaled { 2 }", "twice as large" .. how)
  same(of "a", of "double" .. ":scaled { 0.5 }", "half as large" .. how)
  same(of "long", of "a" .. ":scaled { 1, 2, 1 }", "stretched along y" .. how)
  same(of "mirror", of "a" .. ":mirrored \"x\"", "mirrored" .. how)
  same(of "shift", of "a" .. ":at { 1, -2, 0.5 }", "moved" .. how)
  same(of "quarter", of "a" .. ":turned { axis = \"z\", angle = pi/2 }", "turned" .. how)
  same(of "shear", of "a" .. ":sheared { xy = 0.5 }", "sheared" .. how)
  for _, kind in ipairs { "surface", "wires" } do
    local more = ", kind = \"" .. kind .. "\"" .. how
    same(mesh("double.obj", more), mesh("a.obj", more) .. ":scaled { 2 }", kind .. " twice as large" .. how)
    same(mesh("shift.obj", more), mesh("a.obj", more) .. ":at { 1, -2, 0.5 }", kind .. " moved" .. how)
    says(mesh("a.obj", more) .. ":scaled { 1, 2, 1 }", "can only be scaled by one factor", kind .. " stretched" .. how)
  end
end

-- ---- a box, as a mesh and as a solid ----

local cube = meshes.box({ -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 })
local BOX = "solid.box { x = 1, y = 1, z = 1, density = 1000 }"
write("cube", cube, "stl")
write("cube", cube, "binary.stl")
local CUBE = mesh "cube.stl"
same(CUBE, BOX, "a cube")
same(CUBE .. ":scaled { 0.5 }", BOX .. ":scaled { 0.5 }", "a cube half as large")
holds(CUBE .. ":scaled { 0.5 }", 125, "Ixx 5.20833333333333", "which has 125 kg")
holds(CUBE .. ":scaled { 1, 2, 1 }", 2000, nil, "and twice as long 2000 kg")
local function ball(r, at, density)
  return "solid.sphere { r = " .. r .. ", density = " .. density .. " }:at { " .. at .. ", 0, 0 }"
end
local DRILL = "solid.cylinder { r = 0.125, h = 1, density = 1000 }"
for _, file in ipairs { "cube.stl", "cube.binary.stl" } do
  local it = mesh(file)
  same(it .. " - " .. DRILL, BOX .. " - " .. DRILL, "a hole right through " .. file)
  same(it .. " + " .. BOX .. ":at { 1, 0, 0 }", BOX .. " + " .. BOX .. ":at { 1, 0, 0 }", "side by side, " .. file)
end
same(BOX .. ":scaled { 2 } - " .. CUBE, BOX .. ":scaled { 2 } - " .. BOX, "a mesh as the hole")
same("(" .. CUBE .. " - " .. DRILL .. ") + " .. DRILL, "(" .. BOX .. " - " .. DRILL .. ") + " .. DRILL,
  "a hole that is filled")
for _, turn in ipairs { "", ":turned { axis = { 1, 2, 3 }, angle = 1 }" } do
  alike("(" .. CUBE .. " - " .. ball(0.3, 0.3, 1000) .. ")" .. turn, "(" .. BOX .. " - " .. ball(0.3, 0.3, 1000) ..
    ")" .. turn,
    "hole: must lie inside the body it is cut from", "a hole that sticks out" .. turn)
  alike(CUBE .. turn .. " + " .. BOX .. ":at { 0.5, 0.25, 0 }", BOX .. turn .. " + " .. BOX .. ":at { 0.5, 0.25, 0 }",
    "overlap: what both hold, some 0.", "bodies that overlap" .. turn)
end
alike(CUBE .. " - " .. ball(0.25, 0, 2000), BOX .. " - " .. ball(0.25, 0, 2000), "must not be denser",
  "a hole that is denser")
alike(CUBE .. " - " .. ball(0.25, 0, 500), BOX .. " - " .. ball(0.25, 0, 500), "is less dense",
  "a hole that is lighter")
local PLATE = "plate.disc { r = 0.25, density = 1 }"
alike(CUBE .. " - " .. PLATE, BOX .. " - " .. PLATE, "of the same kind", "a plate as a hole")
alike(BOX .. ":scaled { 2 } - " .. mesh("cube.stl", ", kind = \"surface\", density = 1"),
  BOX .. ":scaled { 2 } - shell.box { x = 1, y = 1, z = 1, density = 1 }", "of the same kind", "a shell as a hole")
alike(mesh "cube.stl" .. " + " .. mesh "cube.stl", BOX .. " + " .. BOX, "overlap", "the same twice")
says(BOX .. " + " .. BOX .. ":at { 0.5, 0, 0 }", "overlap: what both hold, some 0.5 m^3, counts twice", "half of each")
says(CUBE .. " + solid.box { x = 3, y = 0.5, z = 0.5, density = 1 }", "overlap", "a bar through a mesh")
says("plate.rectangle { x = 2, y = 1, density = 1 } + plate.rectangle { x = 1, y = 2, density = 1 }", "overlap",
  "plates across")
holds("plate.rectangle { x = 1, y = 1, density = 1 } + plate.rectangle { x = 1, y = 1, density = 1 }:at { 1, 0, 0 }",
  2, "",
  "plates side by side")

-- ---- near vertices ----

local function joined(x) return x .. ", weld = 1e-6" end
write("loose", meshes.loose(boulder, 1e-8, random), "ply")
says(mesh "loose.ply", "mesh { ..., weld = 1e-7 } joins them and closes it", "vertices 1e-8 apart: a weld is offered")
says(mesh("loose.ply", joined ", density = 1000"), "welded as asked", "and said when it is used")
same(mesh("loose.ply", joined ", density = 1000"), mesh "a.obj", "and is the body then", "near")
same(mesh("a.obj", joined ", density = 1000"), mesh "a.obj", "a weld that nothing needs")
same(mesh("loose.ply", joined ", units = \"mm\", density = 1e12"), mesh "a.obj" ..
  ":scaled { 0.001, 0.001, 0.001 }:scaled { 1 }",
  "in parts of its size in every unit", "moments")
says(mesh("a.obj", ", weld = 1, density = 1"), "weld must be a number from 0 to 0.01", "a weld of all")

-- ---- parts, as one file and as shapes ----

local function brick(x0, y0, z0, x1, y1, z1) return meshes.box({ x0, y0, z0 }, { x1, y1, z1 }) end
local outer, inner = brick(0, 0, 0, 4, 4, 1), brick(1, 1, 0.25, 3, 3, 0.75)
write("cavity", meshes.join(outer, meshes.turned(inner)))
write("outward", meshes.join(outer, inner))
holds(mesh("cavity.obj", ", density = 1"), 14, "", "a cavity that looks inward")
holds(mesh("outward.obj", ", density = 1"), 14, "part 2 (12 triangles around (2, 2, 0.5)) lies inside part 1",
  "and outward")
write("part", meshes.join(brick(0, 0, 0, 2, 2, 2), meshes.turned(brick(2.25, 0, 0, 2.75, 0.5, 0.5))))
holds(mesh("part.obj", ", density = 1"), 8.125, "part 2 (12 triangles around (2.5, 0.25, 0.25)) is inside out",
  "a part inside out")
write("cross", meshes.join(brick(0, 0, 0, 2, 2, 2), brick(1, 1, 1, 3, 3, 3)))
holds(mesh("cross.obj", ", density = 1"), 16,
  "parts 1 and 2 overlap at (2, 2, 2): what both hold, a volume of some 1", "an overlap")
write("beside", meshes.join(brick(0, 0, 0, 1, 1, 1), brick(1, 0.25, 0, 2, 1.25, 1)))
holds(mesh("beside.obj", ", density = 1"), 2, "", "parts that touch")
local bent = meshes.box({ 0, 0, 0 }, { 2, 1, 3 }, true)
bent.v[8] = { 2, 1, 4 }
write("bent", bent)
says(mesh "bent.obj", "1 face that is not flat: other diagonals would change the whole by up to 5",
  "a bent quadrilateral")

-- ---- units ----

write("part_mm", brick(0, 0, 0, 100, 50, 20))
says(mesh("part_mm.obj", ", density = 2700"),
  "it is 100 m long and has 2.7e+08 kg; in mm it would be 0.1 m and 0.27 kg", "mm")
says(mesh("part_mm.obj", ", mass = 0.27"), "(write units = \"mm\")", "mm, by the mass")
holds(mesh("part_mm.obj", ", units = \"mm\", density = 2700"), 0.27, "", "with the unit nothing is said")
holds(mesh("part_mm.obj", ", units = \"m\", density = 2700"), 2.7e8, "", "nor where metres are meant")
holds(mesh("part_mm.obj", ", density = 2700") .. ":scaled { 0.001 }", 0.27, "", "nor where it is scaled")

-- ---- files that are no mesh ----

program.write(dir .. "/lfs.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:" .. string.rep("0", 64) ..
  "\nsize 12345\n")
says(mesh "lfs.stl", "is a pointer of Git LFS", "a pointer to a file elsewhere")
for _, x in ipairs { { "dae", "Collada" }, { "step", "STEP" }, { "3mf", "3MF" }, { "off", "OFF" }, { "glb",
  "glTF" } } do
  program.write(dir .. "/part." .. x[1], "something\n")
  says(mesh("part." .. x[1]), x[2] .. " is not read; export the part as STL, OBJ or PLY", x[1])
end
says("shell.frustum { r = 1, h = 1, mass = 1 }", "it is shell.cone{r = R, h = H} - shell.cone{r = r", "shell.frustum")
says("plate.sphere { r = 1, mass = 1 }", "(there is contact.sphere, shell.sphere, solid.sphere)",
  "a shape of another family")

-- ---- what came of it ----

local status, out, err = program.run_generator([[
local driver = require "generator.driver"
for i = 1, tonumber(args[2]) do
  local job, d = driver.read(host, args[1] .. "/s" .. i .. ".lua", {})
  local m = job and job.model
  local numbers, said = {}, {}
  if m then
    for _, e in ipairs { m.mass, m.body.com[1], m.body.com[2], m.body.com[3], table.unpack(m.centroidal) } do
      numbers[#numbers + 1] = string.format("%.17g", m:double(e))
    end
  end
  for _, w in ipairs(job and job.diag.warnings or d.errors) do
    said[#said + 1] = string.gsub(w.message, "\n", " ")
  end
  host.out(table.concat(numbers, " ") .. "|" .. table.concat(said, " ; ") .. "\n")
end
]], dir, tostring(#list))
tap.ok(status == 0, "all scenes are read", err)

local results = {}
for line in out:gmatch "[^\n]*" do
  local numbers, said = line:match "^(.-)|(.*)$"
  if numbers then
    local r = { said = said }
    for n in numbers:gmatch "%S+" do r[#r + 1] = tonumber(n) end
    results[#results + 1] = r
  end
end

-- How far two bodies are apart, in parts of mass, size and moment.
local function apart(a, b, first)
  if #a == 0 or #a ~= #b then return 1 / 0 end
  local moment, worst = 0, 0
  for i = 5, 7 do moment = math.max(moment, math.abs(a[i]), math.abs(b[i])) end
  local size = math.sqrt(moment / a[1])
  for i = first or 1, #a do
    local unit = i == 1 and a[1] or i <= 4 and size + math.abs(a[i]) or moment
    worst = math.max(worst, math.abs(a[i] - b[i]) / unit)
  end
  return worst
end

local function show(r) return table.concat(r, " ") .. " | " .. r.said end

-- A message without the names and places in it that differ between a mesh and a solid.
local function bare(text)
  return (text:gsub("the %a+ of line 1", "the shape"):gsub("%b()", ""):gsub(", got the point .-, ", ", got a point, "))
end

for _, c in ipairs(pairs_of) do
  local a = results[c[2]] or { said = "nothing" }
  if c[1] == "says" then
    tap.ok(a.said:find(c[3], 1, true), c[4], show(a))
  elseif c[1] == "holds" then
    local fine = a[1] and math.abs(a[1] / c[3] - 1) < 1e-12
    local said = not c[5] or (c[5] == "" and a.said == "") or (c[5] ~= "" and a.said:find(c[5], 1, true))
    local moment = c[5] and c[5]:match "^Ixx (.*)"
    if moment then said = math.abs(a[5] - tonumber(moment)) < 1e-12 end
    tap.ok(fine and said, c[4], show(a))
  else
    local other = results[c[3]] or { said = "nothing" }
    if c[1] == "alike" then
      tap.ok(a.said:find(c[5], 1, true) and bare(a.said) == bare(other.said), c[4], a.said .. "\n" .. other.said)
    else
      -- doubles that were rounded once, and sums of a few hundred terms
      local worst = c[5] == "near" and 1e-6 or c[5] == "moments" and 2 or 4e-14
      tap.ok(apart(a, other) <= worst and (c[5] or bare(a.said) == bare(other.said)), c[4], show(a) .. "\n" ..
        show(other))
    end
  end
end

program.finish()
tap.done()
