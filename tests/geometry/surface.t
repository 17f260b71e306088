#!/usr/bin/env lua5.4
-- surface.t - the surfaces of all shapes enclose what the handbooks say: a third road to the mass properties.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Measure, centroid and second moments of the polyhedron (divergence theorem; triangles and segments for shells and
-- wires) at three finenesses n, 2n, 4n.  The polyhedron's error is a series in even powers of 1/n, so two steps of
-- Richardson's extrapolation leave O(n^-6); their last change bounds what is left, and is itself required to be small.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local surface = require "generator.geometry.surface"
local polygon = require "generator.geometry.polygon"
local integrals = require "tests.geometry.integrals"
local rows = require "tests.geometry.handbook"

-- mean values {measure, x, y, z, xx, yy, zz, xy, xz, yz} of what the shape is made of
local function means(node, n)
  local s = surface.of(node, n)
  local kind = node.shape:match "^(%a+)"
  local sum
  if kind == "shell" or kind == "plate" then
    sum = integrals.area(s.faces)
  elseif kind == "rod" or kind == "wire" then
    sum = integrals.length(s.lines)
  else
    sum = integrals.volume(s.faces)
  end
  for i = 2, 10 do sum[i] = sum[i] / sum[1] end
  return sum, s
end

local names = { "measure", "x", "y", "z", "xx", "yy", "zz", "xy", "xz", "yz" }
local seen = {}

for _, row in ipairs(rows) do
  local node, c = row.node, row.com or { 0, 0, 0 }
  local what = node.shape .. (node.faces and " " .. node.faces or node.order and " " .. table.concat(node.order) or "")
  seen[node.shape] = true
  local want = { row.measure, c[1], c[2], c[3] }
  for k, ij in ipairs { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } do
    if row.S then
      want[4 + k] = row.S[k] or 0
    else -- sigma = tr(I)/2 1 - I, then to the origin
      local I = row.I
      local own = k <= 3 and (I[1] + I[2] + I[3]) / 2 - I[k] or -(I[k] or 0)
      want[4 + k] = own + c[ij[1]] * c[ij[2]]
    end
  end
  local A, s = means(node, 32)
  local B, C = means(node, 64), means(node, 128)
  local bad, curved = {}, false
  local size = math.sqrt(want[5] + want[6] + want[7]) -- a length of the shape
  for i = 1, 10 do
    local scale = i == 1 and row.measure or i <= 4 and size or size ^ 2
    local b, d = B[i] + (B[i] - A[i]) / 3, C[i] + (C[i] - B[i]) / 3
    local best = d + (d - b) / 15
    -- sums of up to 1e4 terms, each good to a few ulp: 1e-12 of the scale
    local left = math.abs(d - b) + 1e-12 * scale
    curved = curved or math.abs(C[i] - B[i]) > 1e-9 * scale
    local fine = math.abs(best - want[i]) <= left -- false for NaN
      if not fine or left > 1e-4 * scale then -- a bound that bounds
      bad[#bad + 1] = string.format("%s: %.15g, want %.15g, off %.2g, allowed %.2g", names[i], best, want[i],
        best - want[i], left)
    end
  end
  tap.ok(#bad == 0, what .. ": measure, centroid and second moments are the handbook's" ..
    (curved and " (extrapolated)" or " (exactly)"), table.concat(bad, "\n"))
  local kind = node.shape:match "^(%a+)"
  if kind ~= "shell" and kind ~= "plate" and kind ~= "rod" and kind ~= "wire" then
    tap.is(integrals.open_edges(s.faces), 0, what .. ": every edge has its partner")
    tap.ok(A[1] > 0, what .. ": faces look outwards")
    local moved = surface.tree({ op = "scaled", k = { -1, 1, 1 }, of = { op = "at", r = { 1, 2, 3 }, of = node } }, 32)
    tap.near(integrals.volume(moved.faces)[1], A[1], 1e-11, 0, what .. ": a mirror image keeps its volume",
      "sums of 1e3 terms about another point")
  end
end

-- ---- every shape has its row ----

do
  local missing = {}
  for _, name in ipairs(surface.names()) do
    if not seen[name] and name ~= "points" and name ~= "tensor" and name ~= "mesh" then
      missing[#missing + 1] = name
    end
  end
  tap.is(table.concat(missing, " "), "", "every shape with a surface is tested")
end

-- ---- cut open: the rest of the solid is still closed, and three quarters of it ----

for _, node in ipairs { { shape = "solid.tube", r_in = 1, r_out = 2, h = 3 }, { shape = "solid.torus", R = 2, r = 1 },
  { shape = "solid.hollow_sphere", r_in = 1, r_out = 2 } } do
  local whole = integrals.volume(surface.of(node, 32).faces)[1]
  local rest = surface.of(node, 32, { turn = { 1 / 4, 3 / 4 } })
  tap.near(integrals.volume(rest.faces)[1], 3 / 4 * whole, 1e-12, 0, node.shape .. ": three quarters are left of it",
    "equal sectors; sums of 1e3 terms")
  tap.is(integrals.open_edges(rest.faces), 0, node.shape .. ": cut open, still closed")
end

-- ---- trees, boxes, samples ----

do
  local ball = { shape = "solid.sphere", r = 1 }
  local block = { shape = "solid.box", x = 4, y = 4, z = 4 }
  local half = math.sqrt(0.5)
  local tree = { op = "minus", block, { op = "at", r = { 0.5, 0, 0 }, of = { op = "turned", q = { half, half, 0, 0 },
    of = { op = "affine", A = { 1, 0.5, 0, 0, 1, 0, 0, 0, 1 }, of = ball } } } }
  local got = integrals.volume(surface.tree(tree, 32).faces)[1]
  local one = integrals.volume(surface.of(ball, 32).faces)[1]
  tap.near(got, 64 - one, 1e-12, 0, "minus: a sheared, turned and moved ball's volume is taken away (det 1)",
    "sums of 1e3 terms")
  local lo, hi = surface.box({ op = "at", r = { 1, 2, 3 }, of = { shape = "solid.capsule", r = 1, h = 2 } })
  tap.is(table.concat({ lo[1], lo[2], lo[3], hi[1], hi[2], hi[3] }, " "), "0.0 1.0 1.0 2.0 3.0 5.0",
    "box: a capsule's is exact")
  -- a turn by 90 degrees about x takes y to z
  lo, hi = surface.box({ op = "turned", q = { 1, 1, 0, 0 }, of = { shape = "rod.between", from = { 0, 1, 0 },
    to = { 0, 2, 0 } } })
  tap.ok(math.abs(lo[3] - 1) < 1e-15 and math.abs(hi[3] - 2) < 1e-15, "turned: v -> q v q*, y goes to z about x")
end

do
  local function largest(list, f)
    local worst = 0
    for _, p in ipairs(list) do worst = math.max(worst, math.abs(f(p))) end
    return worst
  end
  local function on(name, node, f)
    local list = surface.samples(node)
    tap.ok(#list > 200 and largest(list, f) < 1e-14, "samples of " .. name .. " lie on its surface",
      #list .. " points, off by " .. largest(list, f))
  end
  on("a ball", { shape = "solid.sphere", r = 1 }, function(p) return p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2 - 1 end)
  on("a box", { shape = "solid.box", x = 1, y = 1, z = 1 },
    function(p) return math.max(math.abs(p[1]), math.abs(p[2]), math.abs(p[3])) - 0.5 end)
  on("a tube", { shape = "solid.tube", r_in = 0.5, r_out = 1, h = 2 }, function(p)
    local rho = math.sqrt(p[1] ^ 2 + p[2] ^ 2)
    return math.min(math.abs(rho - 0.5), math.abs(rho - 1), math.abs(math.abs(p[3]) - 1))
  end)
  on("a bicylinder", { shape = "solid.bicylinder", r = 1 },
    function(p) return math.max(p[1] ^ 2, p[2] ^ 2) + p[3] ^ 2 - 1 end)
end

-- ---- triangles of polygons ----

do
  local function total(list)
    local s, least = 0, math.huge
    for _, t in ipairs(list) do
      s, least = s + polygon.area(t), math.min(least, polygon.area(t))
    end
    return s, least
  end
  local comb, n = {}, 7 -- teeth: as unlike a convex polygon as can be
  for i = 0, n - 1 do
    comb[#comb + 1] = { i, 0 }
    comb[#comb + 1] = { i + 0.5, 3 }
  end
  comb[#comb + 1], comb[#comb + 2] = { n, 0 }, { n / 2, -1 }
  local list = polygon.triangles(comb)
  local s, least = total(list)
  tap.is(#list, #comb - 2, "a comb has as many triangles as vertices less two")
  tap.near(s, math.abs(polygon.area(comb)), 1e-14, 0, "which cover it", "sums of 14 areas")
  tap.ok(least > 0, "and all turn left")
  local square = { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } }
  local holes, area = {}, 100
  for i = 0, 2 do
    for j = 0, 2 do
      holes[#holes + 1] = { { 1 + 3 * i, 1 + 3 * j }, { 3 + 3 * i, 1 + 3 * j }, { 2 + 3 * i, 3 + 3 * j } }
      area = area - 2
    end
  end
  list = polygon.triangles(square, holes)
  s, least = total(list)
  tap.near(s, area, 1e-14, 0, "a plate with nine holes in rows is covered but for them", "sums of 50 areas")
  tap.ok(least > 0, "by triangles that turn left")
  tap.is(#list, 4 + 27 + 2 * 9 - 2, "two triangles more for every hole's bridge")
end

tap.done()
