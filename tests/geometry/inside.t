#!/usr/bin/env lua5.4
-- inside.t - membership of points in every shape.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Three roads that share nothing with the predicates: the volume of a solid, from a handbook, against the share of
-- random points of a box that are inside; the area and length of thin things, by the volume of a layer around them; and
-- points of the surface (geometry/surface.lua), where the excess must vanish.  The random points are the same in every
-- run: a share differs from its expectation by 5 standard deviations once in 1.7 million.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local inside = require "generator.geometry.inside"
local surface = require "generator.geometry.surface"

local pi, sqrt = math.pi, math.sqrt
local N = 20000

local state = 1
local function uniform() -- Park and Miller
  state = state * 16807 % 2147483647
  return state / 2147483647
end

local function point(lo, hi)
  local p = {}
  for i = 1, 3 do p[i] = lo[i] + (hi[i] - lo[i]) * uniform() end
  return p
end

-- The volume of {p: test(p)} in the box, and its standard deviation for a volume of `want`.
local function measured(lo, hi, want, test)
  local box, n = (hi[1] - lo[1]) * (hi[2] - lo[2]) * (hi[3] - lo[3]), 0
  for _ = 1, N do
    if test(point(lo, hi)) then n = n + 1 end
  end
  local share = want / box
  return box * n / N, box * sqrt(share * (1 - share) / N)
end

local function name_of(s) return s.shape .. (s.faces and " " .. s.faces or "") end

-- ---- solids: volumes of Bronshtein, Handbook of Mathematics, 3.3, or one-line integrals ----

local L = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } } -- area 4
local ring = { { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 } } -- Pappus: 2 pi 1.5 1
local window = { { 0.25, 0.25 }, { 0.25, 0.75 }, { 0.75, 0.75 }, { 0.75, 0.25 } } -- area 1/4

local solids = {
  { { shape = "solid.box", x = 1, y = 2, z = 3 }, 6 },
  { { shape = "solid.sphere", r = 1.5 }, 4 / 3 * pi * 1.5 ^ 3 },
  { { shape = "solid.ellipsoid", a = 1, b = 2, c = 0.5 }, 4 / 3 * pi },
  { { shape = "solid.cylinder", r = 1, h = 3 }, 3 * pi },
  { { shape = "solid.elliptic_cylinder", a = 1, b = 2, h = 3 }, 6 * pi },
  { { shape = "solid.tube", r_in = 0.5, r_out = 1, h = 2 }, 2 * pi * 0.75 },
  { { shape = "solid.cone", r = 1, h = 2 }, 2 * pi / 3 },
  { { shape = "solid.elliptic_cone", a = 1, b = 2, h = 3 }, 2 * pi },
  { { shape = "solid.frustum", r_base = 2, r_top = 1, h = 3 }, pi * (4 + 2 + 1) },
  { { shape = "solid.capsule", r = 1, h = 2 }, 2 * pi + 4 / 3 * pi },
  { { shape = "solid.hemisphere", r = 2 }, 16 / 3 * pi },
  { { shape = "solid.cap", r = 2, h = 0.5 }, pi * 0.25 * (6 - 0.5) / 3 },
  { { shape = "solid.cap", r = 2, h = 3.5 }, pi * 12.25 * (6 - 3.5) / 3 },
  { { shape = "solid.zone", r = 2, z1 = -0.5, z2 = 1 }, pi * (4 * 1.5 - (1 + 0.125) / 3) },
  { { shape = "solid.sector", r = 2, h = 0.5 }, 2 / 3 * pi * 4 * 0.5 },
  { { shape = "solid.sector", r = 2, h = 3 }, 2 / 3 * pi * 4 * 3 },
  { { shape = "solid.half_cylinder", r = 1, h = 2 }, pi },
  { { shape = "solid.quarter_cylinder", r = 1, h = 2 }, pi / 2 },
  { { shape = "solid.hoof", r = 2, h = 3 }, 2 / 3 * 4 * 3 },
  { { shape = "solid.torus", R = 2, r = 0.5 }, 2 * pi * pi * 2 * 0.25 },
  { { shape = "solid.hollow_sphere", r_in = 1, r_out = 2 }, 4 / 3 * pi * 7 },
  { { shape = "solid.paraboloid", r = 2, h = 3 }, pi * 4 * 3 / 2 },
  { { shape = "solid.pyramid", x = 1, y = 2, h = 3 }, 2 },
  { { shape = "solid.prism", profile = L, h = 2 }, 8 },
  { { shape = "solid.wedge", x = 1, y = 2, z = 3 }, 3 },
  { { shape = "solid.tetrahedron", vertices = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 }, { 1, 1, 3 } } }, 1 },
  { { shape = "solid.parallelepiped", edges = { { 1, 0, 0 }, { 1, 2, 0 }, { -1, 1, 3 } } }, 6 },
  { { shape = "solid.parallelepiped", edges = { { 1, 2, 0 }, { 1, 0, 0 }, { -1, 1, 3 } } }, 6 },
  { { shape = "solid.regular", faces = 4, edge = 2 }, 8 * sqrt(2) / 12 },
  { { shape = "solid.regular", faces = 6, edge = 2 }, 8 },
  { { shape = "solid.regular", faces = 8, edge = 2 }, 8 * sqrt(2) / 3 },
  { { shape = "solid.regular", faces = 12, edge = 2 }, 8 * (15 + 7 * sqrt(5)) / 4 },
  { { shape = "solid.regular", faces = 20, edge = 2 }, 8 * 5 * (3 + sqrt(5)) / 12 },
  { { shape = "solid.bicylinder", r = 1.5 }, 16 / 3 * 1.5 ^ 3 },
  { { shape = "extrude", profile = L, h = 2, holes = { window } }, 7.5 },
  { { shape = "revolve", profile = ring }, 3 * pi },
  { { shape = "revolve", profile = ring, holes = { { { 1.25, 0.25 }, { 1.75, 0.25 }, { 1.75, 0.75 }, { 1.25,
    0.75 } } } },
    3 * pi * 0.75 },
  -- 0 <= y <= 2, 0 <= x <= y, 0 <= z <= 1 + x y: 2 + integral of y^3/2 = 2 + 2
  { { shape = "region", order = { 2, 1, 3 }, limits = { { {}, { { 2, 0, 0, 0 } } }, { {}, { { 1, 0, 1, 0 } } },
    { {}, { { 1, 0, 0, 0 }, { 1, 1, 1, 0 } } } } }, 4 },
}

local seen = {}
for _, case in ipairs(solids) do
  local s, want = case[1], case[2]
  seen[s.shape] = true
  local lo, hi = surface.box(s, 96)
  for i = 1, 3 do lo[i], hi[i] = lo[i] - 0.1, hi[i] + 0.1 end
  local got, sigma = measured(lo, hi, want, function(p) return inside.contains(s, p) end)
  tap.near(got, want, 0, 5 * sigma, name_of(s) .. ": as many points inside as its volume says", "5 standard deviations")
end

-- ---- thin things: a layer of half thickness d has the volume 2 d area, or pi d^2 length ----

local d = 0.05
local triangle = { { 0, 0, 0 }, { 2, 0, 1 }, { 0, 3, 1 } } -- edges 2,0,1 and 0,3,1: normal (-3, -2, 6), area 3.5
local thin = { -- shape, area or length; rim: length of the border, or number of ends and corners
  { { shape = "shell.sphere", r = 1 }, area = 4 * pi, rim = 0 },
  { { shape = "shell.hemisphere", r = 1 }, area = 2 * pi, rim = 2 * pi },
  { { shape = "shell.zone", r = 1, z1 = -0.5, z2 = 0.25 }, area = 2 * pi * 0.75, rim = 4 * pi },
  -- spheroid a = b = 1, c = 2: 2 pi (1 + 2/e asin e), e = sqrt(3)/2
  { { shape = "shell.ellipsoid", a = 1, b = 1, c = 2 }, area = 2 * pi * (1 + 4 / sqrt(3) * pi / 3), rim = 1 },
  { { shape = "shell.cylinder", r = 1, h = 2, ends = false }, area = 4 * pi, rim = 4 * pi },
  { { shape = "shell.cylinder", r = 1, h = 2, ends = true }, area = 6 * pi, rim = 4 * pi },
  { { shape = "shell.cone", r = 3, h = 4 }, area = 15 * pi, rim = 6 * pi },
  { { shape = "shell.torus", R = 2, r = 0.5 }, area = 4 * pi * pi, rim = 0 },
  { { shape = "shell.box", x = 1, y = 2, z = 3 }, area = 22, rim = 0 },
  { { shape = "plate.disc", r = 1 }, area = pi, rim = 2 * pi },
  { { shape = "plate.annulus", r_in = 0.5, r_out = 1 }, area = 0.75 * pi, rim = 3 * pi },
  { { shape = "plate.ellipse", a = 1, b = 2 }, area = 2 * pi, rim = 10 },
  { { shape = "plate.rectangle", x = 1, y = 2 }, area = 2, rim = 6 },
  { { shape = "plate.sector", r = 2, angle = 1 }, area = 2, rim = 6 },
  { { shape = "plate.sector", r = 2, angle = 5 }, area = 10, rim = 14 },
  { { shape = "plate.triangle", vertices = triangle }, area = 3.5, rim = 10 },
  { { shape = "plate.polygon", profile = L, holes = { window } }, area = 3.75, rim = 12 },
  { { shape = "rod.straight", length = 2 }, length = 2, rim = 2 },
  { { shape = "rod.between", from = { 1, 0, 0 }, to = { 2, 2, 2 } }, length = 3, rim = 2 },
  { { shape = "wire.hoop", r = 1 }, length = 2 * pi, rim = 0 },
  { { shape = "wire.arc", r = 1, angle = 4 }, length = 4, rim = 2 },
  { { shape = "wire.polyline", points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 } }, closed = false }, length = 3,
    rim = 4 },
  { { shape = "wire.polyline", points = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 4, 0 } }, closed = true }, length = 12,
    rim = 6 },
  { { shape = "wire.helix", r = 1, pitch = 1, turns = 1.5 }, length = 1.5 * sqrt(4 * pi * pi + 1), rim = 4 },
  { { shape = "wire.helix", r = 1, pitch = -0.5, turns = 1 }, length = sqrt(4 * pi * pi + 0.25), rim = 4 },
  { { shape = "wire.catenary", a = 1, span = 2 }, length = 2 * (math.exp(1) - math.exp(-1)) / 2, rim = 4 },
}
for _, case in ipairs(thin) do
  local s = case[1]
  seen[s.shape] = true
  local lo, hi = surface.box(s, 96)
  for i = 1, 3 do lo[i], hi[i] = lo[i] - 0.2, hi[i] + 0.2 end
  local h = case.length and 3 * d or d
  local want = case.area and 2 * h * case.area or pi * h * h * case.length
  -- at a rim, an end or a corner the layer is wider or narrower by its own thickness; where the excess is of first
  -- order only (a slanted helix: its distance at one height, too large by 1 + (pitch/2 pi r)^2) the layer is thinner
  local edge = case.area and 4 * h * h * case.rim or pi * h * h * h * case.rim
  local slack = (s.shape == "wire.helix" or s.shape == "wire.catenary") and 0.1 * want or 0
  local got, sigma = measured(lo, hi, want, function(p) return inside.contains(s, p, h) end)
  tap.near(got, want, 0, 5 * sigma + edge + slack, s.shape .. ": the layer around it has the volume of its measure",
    "5 standard deviations, and what rims and ends add")
end

-- ---- the excess vanishes on the surface, and only there ----

local all = {}
for _, list in ipairs { solids, thin } do
  for _, case in ipairs(list) do all[#all + 1] = case[1] end
end
all[#all + 1] = { shape = "points", list = { { 1, 0, 0, 0 }, { 2, 1, 2, 3 } } }
seen.points = true
for _, s in ipairs(all) do
  local worst, drawn = 0, surface.of(s, 16)
  for _, list in ipairs { drawn.faces, drawn.lines, { drawn.points } } do
    for _, polygon in ipairs(list) do
      for _, p in ipairs(polygon) do worst = math.max(worst, math.abs(inside.excess(s, p))) end
    end
  end
  tap.near(worst, 0, 0, 1e-14 * 16, name_of(s) .. ": no excess at the points of its surface",
    "some ten roundings of coordinates up to 4")
end
for _, name in ipairs(surface.names()) do
  if inside.kind { shape = name } and not seen[name] then tap.ok(false, name .. " is tested here") end
end

-- ---- extremes ----

do
  local needle = { shape = "solid.ellipsoid", a = 1e8, b = 1e-8, c = 1 }
  tap.ok(inside.contains(needle, { 0.999e8, 0, 0 }) and not inside.contains(needle, { 1.001e8, 0, 0 }) and
    inside.contains(needle, { 0, 0.999e-8, 0 }) and not inside.contains(needle, { 0, 1.001e-8, 0 }),
    "an ellipsoid of 1e8, 1, 1e-8 has its ends where they are")
  tap.near(inside.excess(needle, { 0, 1.001e-8, 0 }), 1e-11, 1e-9, 0, "and the distance is that of its thin side",
    "1.001e-8 - 1e-8 keeps 13 digits of 1e-11")
  for _, scale in ipairs { 1e-150, 1e150 } do
    local e = inside.excess({ shape = "solid.ellipsoid", a = scale, b = 2 * scale, c = scale }, { 0, 3 * scale, 0 })
    tap.near(e / scale, 1, 1e-12, 0, "sizes of " .. string.format("%g", scale) .. " neither overflow nor vanish",
      "a few roundings")
  end
  for _, s in ipairs(all) do -- at the centre, on the axes: no 0/0
    for _, p in ipairs { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, 1, 0 } } do
      local e = inside.excess(s, p)
      if e ~= e then tap.ok(false, name_of(s) .. " at a point of its axes: no number") end
    end
  end
  local whole = { shape = "solid.sector", r = 1, h = 2 }
  tap.ok(inside.contains(whole, { 0, 0, -0.5 }) and inside.contains(whole, { 0.1, 0, -0.5 }) and
    not inside.contains({ shape = "solid.sector", r = 1, h = 1.9 }, { 0, 0, -0.5 }),
    "a sector of the height 2 r is the ball, with its lower axis; a lower one lacks it")
end

-- ---- trees ----

local box, ball = { shape = "solid.box", x = 1, y = 2, z = 3 }, { shape = "solid.sphere", r = 1 }
local function tree_volume(tree, lo, hi, want, name)
  local got, sigma = measured(lo, hi, want, function(p) return inside.contains(tree, p) end)
  tap.near(got, want, 0, 5 * sigma, name, "5 standard deviations")
end
tree_volume({ op = "scaled", of = ball, k = { 1, -2, 0.5 } }, { -2, -2.5, -1 }, { 2, 2.5, 1 }, 4 / 3 * pi,
  "a ball scaled by 1, -2, 1/2")
tree_volume({ op = "affine", of = box, A = { 1, 0.5, 0, 0, 1, 0.25, 0, 0, 1 } }, { -2, -2, -2 }, { 2, 2, 2 }, 6,
  "a sheared box keeps its volume")
tree_volume({ op = "sum", ball, { op = "at", of = ball, r = { 1, 0, 0 } } }, { -2, -2, -2 }, { 3, 2, 2 },
  8 / 3 * pi - 5 / 12 * pi, "two balls at the distance r: twice 4/3 pi less the lens 5/12 pi")
tree_volume({ op = "minus", { op = "at", of = box, r = { 1, 1, 1 } }, { op = "at", of = { shape = "solid.cylinder",
  r = 0.5, h = 3 }, r = { 1, 1, 1 } } }, { 0, -1, -1 }, { 2, 3, 3 }, 6 - 0.75 * pi, "a box with a hole through it")
do
  -- a quarter turn about z takes x to y
  local rod = { op = "turned", of = { shape = "solid.box", x = 4, y = 1, z = 1 }, q = { sqrt(0.5), 0, 0, sqrt(0.5) } }
  tap.ok(inside.contains(rod, { 0, 1.9, 0 }) and not inside.contains(rod, { 1.9, 0, 0 }), "a quarter turn")
  local a = { op = "turned", of = { op = "at", of = ball, r = { 5, 0, 0 } }, q = { 2, 0, 0, 2 } }
  tap.near(inside.excess(a, { 0, 7, 0 }), 1, 1e-14, 0, "turned after it was moved, by a quaternion of any length",
    "a few roundings")
  local sheared = { op = "affine", of = box, A = { 1, 2, 0, 0, 1, 0, 0, 0, 1 } }
  tap.near(inside.excess(sheared, { 0.5 + 2 * 0.5, 0.5, 0 }), 0, 0, 1e-14, "a shear is undone", "a few roundings")
  local stretched = { op = "scaled", of = ball, k = { 1, 1, 100 } }
  tap.near(inside.distance(stretched, { 1.01, 0, 0 }, 1e-6), 0.01, 1e-6, 0,
    "the distance from a stretched ball is not stretched", "differences of width 1e-6 at a radius of 1")
  tap.ok(inside.excess(stretched, { 1.01, 0, 0 }) >= 0.01, "while its excess is at least the distance")
end

-- ---- what is not known ----

do
  local mesh = { shape = "mesh" }
  tap.is(inside.contains(mesh, { 0, 0, 0 }), nil, "of a mesh nothing is known")
  tap.is(inside.contains({ op = "sum", mesh, ball }, { 0, 0, 0 }), true, "a sum with a ball holds what the ball holds")
  tap.is(inside.contains({ op = "sum", mesh, ball }, { 2, 0, 0 }), nil, "and what else, nobody knows")
  tap.is(inside.contains({ op = "minus", ball, mesh }, { 2, 0, 0 }), false, "a ball less a mesh ends with the ball")
  tap.is(inside.contains({ op = "minus", ball, mesh }, { 0, 0, 0 }), nil, "and what is left of it, nobody knows")
  tap.is(inside.contains({ op = "minus", mesh, ball }, { 0, 0, 0 }), false, "a mesh less a ball lacks the ball")
  tap.is(inside.excess({ op = "minus", mesh, ball }, { 1.5, 0, 0 }), nil, "how far it is beside the ball, nobody knows")
  tap.is(inside.contains({ op = "minus", ball, ball }, { 1, 0, 0 }), true, "the border of a hole is not cut out")
end

tap.done()
