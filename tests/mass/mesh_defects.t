#!/usr/bin/env lua5.4
-- mesh_defects.t - random meshes with a planted defect: each kind is named, the part with its place; without one,
-- nothing is.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- POLHODE_MESHES=500 tries so many (make check-all has 150, the quick tier 30); POLHODE_SEED another series.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local meshes = require "tests.mass.meshes"

local dir = program.directory()
local state = tonumber(os.getenv "POLHODE_SEED" or "1") * 7919 + 17
local most = tonumber(os.getenv "POLHODE_MESHES" or (tier.quick and "30" or "150"))

local function random()
  state = (state * 6364136223846793005 + 1442695040888963407) & 0x7fffffffffffffff
  return (state >> 20 & 0xffffffff) / 0x100000000
end
local function pick(n) return math.floor(random() * n) + 1 end
local function between(a, b) return a + (b - a) * random() end

-- A boulder of radius r (0.9 r to 1.1 r) at `at`, or a box within it.
local function lump(r, at)
  if random() < 0.7 then return meshes.boulder(pick(2) - 1 + (r > 0.5 and 1 or 0), r, at, random) end
  local lo, hi, h = {}, {}, math.floor(r * 2048) / 4096
  for i = 1, 3 do lo[i], hi[i] = math.floor(at[i] * 64) / 64 - h, math.floor(at[i] * 64) / 64 + h end
  return meshes.box(lo, hi)
end

local function place() return { between(-3, 3), between(-3, 3), between(-3, 3) } end
local function beside(at, d) return { at[1] + d, at[2], at[3] } end

-- Each makes a mesh; returns it, what must be said ("": nothing), and its volume where there is one.
local plant = {}

function plant.nothing()
  local m = lump(between(0.5, 2), place())
  return m, "", meshes.volume(m)
end

function plant.parts()
  local at = place()
  local a, b = lump(1, at), lump(1, beside(at, 2.5))
  return meshes.join(a, b), "", meshes.volume(a) + meshes.volume(b)
end

-- Box in box, whatever is drawn: a coarse boulder has dents.
local function nest(inside)
  local r, x = 1 + pick(4) / 4, pick(8) / 4
  local outer, inner = meshes.box({ x, 0, 0 }, { x + 4 * r, 4 * r, 4 * r }), lump(r / 4 + 0.25, { x + 2 * r, 2 * r,
    2 * r })
  return outer, inside and meshes.turned(inner) or inner
end

function plant.cavity()
  local a, b = nest(true)
  return meshes.join(a, b), "", meshes.volume(a) + meshes.volume(b)
end

function plant.outward()
  local a, b = nest(false)
  return meshes.join(a, b), "^part 2 %(" .. #b.f ..
    " triangles around %b()%) lies inside part 1 and looks outward as well",
    meshes.volume(a) - meshes.volume(b)
end

function plant.core()
  local a, b = nest(true)
  local core = meshes.box({ a.v[1][1] + 2 * (a.v[8][2] / 4) - 0.0625, a.v[8][2] / 2 - 0.0625, a.v[8][2] / 2 - 0.0625 },
    { a.v[1][1] + 2 * (a.v[8][2] / 4) + 0.0625, a.v[8][2] / 2 + 0.0625, a.v[8][2] / 2 + 0.0625 })
  return meshes.join(meshes.join(a, b), meshes.turned(core)),
    "^part 3 .* lies in a cavity of part 2 and looks inward as well",
    meshes.volume(a) + meshes.volume(b) + meshes.volume(core)
end

function plant.inward()
  local at = place()
  local a, b = lump(1, at), lump(0.7, beside(at, 2.5))
  local first = random() < 0.5
  return meshes.join(first and meshes.turned(a) or a, first and b or meshes.turned(b)),
    "^part " .. (first and 1 or 2) .. " %b() is inside out", meshes.volume(a) + meshes.volume(b)
end

function plant.inverted()
  local m = lump(between(0.5, 2), place())
  return meshes.turned(m), "^inside out: the faces look inward", meshes.volume(m)
end

function plant.overlap()
  local at = place()
  local a, b = lump(1, at), lump(1, beside(at, between(0.4, 0.9)))
  return meshes.join(a, b), "^parts 1 and 2 overlap at %b(): what both hold, a volume of some 0?[.%d]+, counts twice",
    meshes.volume(a) + meshes.volume(b)
end

-- Bars across each other, with no corner of one in the other.
function plant.across()
  local w, x = pick(8) / 16, pick(16) / 16
  local a, b = meshes.box({ -3, -w, -w }, { 3, w, w }), meshes.box({ x - w / 2, -3, -w / 2 }, { x + w / 2, 3, w / 2 })
  return meshes.join(a, b), "^parts 1 and 2 overlap at %b()", meshes.volume(a) + meshes.volume(b)
end

-- Boxes with faces in one plane.
function plant.flush()
  local x = pick(15) / 16
  local a, b = meshes.box({ 0, 0, 0 }, { 1, 1, 1 }), meshes.box({ x, 0, 0 }, { x + 1, 1, 1 })
  return meshes.join(a, b), "^parts 1 and 2 overlap at %b()", 2
end

function plant.touching()
  local y = pick(7) / 8
  return meshes.join(meshes.box({ 0, 0, 0 }, { 1, 1, 1 }), meshes.box({ 1, y, 0 }, { 2, y + 1, 1 })), "", 2
end

function plant.open()
  local m = lump(1, place())
  table.remove(m.f, pick(#m.f))
  return m, "^3 edges with one face only"
end

function plant.flipped()
  local m = lump(1, place())
  local f = m.f[pick(#m.f)]
  f[1], f[2] = f[2], f[1]
  return m, "^3 edges between faces that look to opposite sides"
end

-- A wall of its own inside: its edges have three faces.
function plant.wall()
  local m = lump(1, place())
  local f, g = m.f[1], m.f[#m.f]
  m.f[#m.f + 1] = { f[1], f[2], g[1] == f[1] and g[2] or g[1] }
  return m, "edges? with one face only"
end

function plant.repeated()
  local m = lump(1, place())
  local f = m.f[pick(#m.f)]
  m.f[#m.f + 1], m.f[#m.f + 2] = { f[1], f[2], f[3] }, { f[1], f[3], f[2] }
  return m, "2 triangles that repeat others", meshes.volume(m)
end

function plant.line()
  local m = lump(1, place())
  local f = m.f[pick(#m.f)]
  m.f[#m.f + 1] = { f[1], f[2], f[1] }
  return m, "1 face without area", meshes.volume(m)
end

function plant.infinite()
  local m = lump(1, place())
  m.v[#m.v + 1] = { 1 / 0, 0, 0 }
  m.f[#m.f + 1] = { 1, 2, #m.v }
  return m, "1 face with a coordinate that is not finite"
end

function plant.loose()
  local m = lump(1, place())
  return meshes.loose(m, 10 ^ between(-8, -6), random), "^%d+ edges with one face only.*; weld "
end

function plant.bent()
  local s = { pick(8) / 4, pick(8) / 4, pick(8) / 4 }
  local m, d = meshes.box({ 0, 0, 0 }, s, true), pick(8) / 32
  m.v[8] = { s[1], s[2], s[3] + d }
  return m, "^1 face that is not flat: other diagonals would change the whole by up to [%d.]+ %%$", meshes.volume(m)
end

local kinds = {}
for k in pairs(plant) do kinds[#kinds + 1] = k end
table.sort(kinds)

local cases = {}
for n = 1, most do
  local kind = kinds[(n - 1) % #kinds + 1]
  local m, said, volume = plant[kind]()
  local format = kind == "infinite" and "obj" or
    (kind == "bent" or kind == "loose") and ({ "obj", "ply" })[pick(2)] or meshes.formats[pick(#meshes.formats)]
  local name = dir .. "/" .. n .. "." .. format
  program.write(name, (meshes.text(m, format):gsub("inf", "1e999")))
  cases[n] = { kind = kind, name = name, said = said, volume = volume, format = format }
end

local names = {}
for i, c in ipairs(cases) do names[i] = c.name end
program.write(dir .. "/names", table.concat(names, "\n") .. "\n")

local status, out, err = program.run_generator([[
local defects = require "generator.dsl.defects"
for name in string.gmatch(host.read(args[1]), "[^\n]+") do
  local m, why, failed = host.mesh(name, "volume")
  local list = {}
  if m or failed.reason == "mesh" then list = defects.phrases(m or failed) end
  if failed and failed.reason == "mesh" then list[#list + 1] = defects.offer(failed, function(w) return "weld " ..
    w end) end
  host.out(string.format("%.17g %s\n", m and m.measure or 0, failed and failed.reason == "format" and why or
    table.concat(list, "; ")))
end
]], dir .. "/names")
tap.ok(status == 0, "all meshes are read", err)

local n, right = 0, {}
for line in out:gmatch "[^\n]+" do
  n = n + 1
  local c, volume, said = cases[n], line:match "^(%S+) ?(.*)$"
  local named = c.said == "" and said == "" or c.said ~= "" and said:find(c.said)
  local size = tonumber(volume)
  -- the sum here is in doubles: some 1e-13 of the size
  local fine = not c.volume and size == 0 or c.volume and math.abs(size / c.volume - 1) < 1e-11
  right[c.kind] = right[c.kind] or { 0, 0 }
  right[c.kind][1] = right[c.kind][1] + 1
  if named and fine then
    right[c.kind][2] = right[c.kind][2] + 1
  else
    tap.diag(c.kind .. " " .. c.name:gsub(dir, "") .. ": " .. line .. " for " .. c.said .. ", " .. tostring(c.volume))
  end
end
tap.is(n, most, "each has a line")
for _, kind in ipairs(kinds) do
  local r = right[kind] or { 0, 0 }
  tap.is(r[2], r[1], kind .. ": " .. r[1] .. " of " .. r[1] .. " are named, with the right volume")
end

program.finish()
tap.done()
