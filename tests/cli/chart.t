#!/usr/bin/env lua5.4
-- chart.t - polhode chart: borders where the conditions say, regions, errors; the same bytes twice.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Coordinates of the picture are read back through the frame, so a border is compared with its equation; a coordinate
-- is
-- written with two decimals and a border simplified to a hundredth of a pixel.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.output(string.format("timeout 120 %s %s", binary, arguments))
end

-- Frames of the panels, in order: {x, y, width, height}; the smaller rectangles are the legend's.
local function frames(svg)
  local list = {}
  for x, y, w, h in svg:gmatch '<rect class="frame" x="([%d.]+)" y="([%d.]+)" width="([%d.]+)" height="([%d.]+)"/>' do
    if tonumber(w) > 100 then list[#list + 1] = { tonumber(x), tonumber(y), tonumber(w), tonumber(h) } end
  end
  return list
end

local function points(data)
  local list = {}
  for x, y in data:gmatch "([%d.]+),([%d.]+)" do list[#list + 1] = { tonumber(x), tonumber(y) } end
  return list
end

-- Every border of the class as points in the parameters; range: {xlow, xhigh, ylow, yhigh}.
local function borders(svg, range)
  local list, all = {}, frames(svg)
  for data in svg:gmatch '<path class="curve" d="([^"]*)"' do
    local line = {}
    for i, p in ipairs(points(data)) do
      local f = all[1]
      for _, g in ipairs(all) do
        if p[1] >= g[1] - 1 and p[1] <= g[1] + g[3] + 1 then f = g end
      end
      line[i] = { range[1] + (p[1] - f[1]) / f[3] * (range[2] - range[1]),
        range[3] + (f[2] + f[4] - p[2]) / f[4] * (range[4] - range[3]), f = f }
    end
    list[#list + 1] = line
  end
  return list
end

-- The class of the area that holds the pixel (x, y): the last polygon around it.
local function area(svg, x, y)
  local found
  for class, data in svg:gmatch '<polygon class="(%l+)" points="([^"]*)"' do
    local list, inside = points(data), false
    local j = #list
    for i = 1, #list do
      local a, b = list[i], list[j]
      if (a[2] > y) ~= (b[2] > y) and x < (b[1] - a[1]) * (y - a[2]) / (b[2] - a[2]) + a[1] then inside = not inside end
      j = i
    end
    if inside then found = class end
  end
  return found
end

local PIXEL = 0.03 -- two decimals of the coordinate and the simplification

---- a cylinder -----------------------------------------------------------------------------------------

local command = "chart bodies/symmetric_top.lua --over r=0.01:0.1,h=0.01:0.15 --dissipation --axis z"
local status, svg = run(command)
tap.is(status, 0, "cylinder: drawn")
tap.ok(svg:find "^<svg " and svg:find "</svg>\n$" and svg:find("prefers-color-scheme:dark", 1, true),
  "cylinder: an SVG for light and dark")
do
  local list = borders(svg, { 0.01, 0.1, 0.01, 0.15 })
  tap.is(#list, 1, "cylinder: one border")
  local worst = 0.0
  for _, p in ipairs(list[1] or {}) do
    worst = math.max(worst, math.abs(p[2] - math.sqrt(3) * p[1]) / (0.14 / p.f[4]) )
  end
  -- two coordinates, a slope of 1.1 in pixels
  tap.ok(worst <= 2.2 * PIXEL, "cylinder: the border is h = sqrt(3) r", string.format("%.3f pixels", worst))
  local f = frames(svg)[1]
  local function at(r, h) return area(svg, f[1] + (r - 0.01) / 0.09 * f[3], f[2] + f[4] - (h - 0.01) / 0.14 * f[4]) end
  tap.is(at(0.03, 0.12), "unstable", "cylinder: long, its axis is unstable with dissipation")
  tap.is(at(0.08, 0.05), "stable", "cylinder: flat, it is stable")
  tap.is(at(0.05, 0.0855), "stable", "cylinder: just below sqrt(3) r")
  tap.is(at(0.05, 0.0877), "unstable", "cylinder: just above it")
  local x, y = svg:match '<circle class="here" cx="([%d.]+)" cy="([%d.]+)"'
  tap.ok(x and math.abs(x - (f[1] + 0.02 / 0.09 * f[3])) <= 0.01
    and math.abs(y - (f[2] + f[4] - 0.11 / 0.14 * f[4])) <= 0.01, "cylinder: the scene's own point")
  tap.ok(svg:find("h = √3 r", 1, true) and svg:find("stable iff h &lt; √3 r", 1, true),
    "cylinder: the border has its equation, the panel its condition")
  tap.ok(svg:find(">r, m<", 1, true) and svg:find(">h, m<", 1, true) and svg:find(">unstable<", 1, true),
    "cylinder: axes have their units, colours their legend")
end

local second = select(2, run(command))
tap.ok(second == svg, "the same bytes twice")
run(command .. " -o " .. dir .. "/chart.svg")
tap.ok(program.read(dir .. "/chart.svg") == svg, "-o writes the same bytes")

---- a brick: three axes ------------------------------------------------------------------------------------

status, svg = run "chart bodies/brick_centroid.lua --over a=0.01:0.3,b=0.01:0.3"
tap.is(status, 0, "brick: drawn")
do
  local fs = frames(svg)
  tap.is(#fs, 3, "brick: three panels")
  local wrong = {}
  local function middle(k, e) -- is edge k neither the longest nor the shortest?
    local less = 0
    for i = 1, 3 do less = less + (e[i] < e[k] and 1 or 0) end
    return less == 1
  end
  for i = 1, 12 do
    for j = 1, 12 do
      local a, b = 0.01 + 0.29 * (i - 0.4) / 12, 0.01 + 0.29 * (j - 0.6) / 12
      for k = 1, 3 do
        local f = fs[k]
        local got = area(svg, f[1] + (a - 0.01) / 0.29 * f[3], f[2] + f[4] - (b - 0.01) / 0.29 * f[4])
        if got ~= (middle(k, { a, b, 0.05 }) and "unstable" or "stable") then
          wrong[#wrong + 1] = string.format("panel %d at %g %g: %s", k, a, b, tostring(got))
        end
      end
    end
  end
  tap.is(#wrong, 0, "brick: unstable about the middle edge, everywhere", wrong[1])
  local off = {}
  for _, line in ipairs(borders(svg, { 0.01, 0.3, 0.01, 0.3 })) do
    for _, p in ipairs(line) do
      local least = math.min(math.abs(p[1] - p[2]), math.abs(p[1] - 0.05), math.abs(p[2] - 0.05)) / (0.29 / p.f[3])
      if least > 2 * PIXEL then off[#off + 1] = string.format("%g %g", p[1], p[2]) end
    end
  end
  tap.is(#off, 0, "brick: every border is a = b, a = c or b = c", off[1])
  tap.ok(svg:find("c = 0.05 m", 1, true) and not svg:find(">neutral<", 1, true),
    "brick: the other edge is named; borders have no area, so nothing is neutral")
end
svg = select(2, run "chart bodies/brick_centroid.lua --over a=0.01:0.04,b=0.01:0.3 --axis 2")
tap.ok(#frames(svg) == 1 and not svg:find 'class="here"', "one axis; a scene outside the ranges has no dot")

---- bodies that cannot be, and units --------------------------------------------------------------------------

program.write(dir .. "/tube.lua", [[
local a, b, h = param("r_in", 30, "mm"), param("r_out", 60, "mm"), param("h", 100, "mm")
return scene { name = "tube", body = solid.tube { r_in = a, r_out = b, h = h, mass = 1 } }
]])
status, svg = run("chart " .. dir .. "/tube.lua --over r_in=5:90,r_out=20:80 --dissipation --set h=80")
tap.is(status, 0, "tube: drawn")
do
  local f = frames(svg)[2]
  local function at(a, b) return area(svg, f[1] + (a - 5) / 85 * f[3], f[2] + f[4] - (b - 20) / 60 * f[4]) end
  tap.is(at(70, 60), "invalid", "tube: no body with r_in > r_out")
  tap.is(at(60, 70), "stable", "tube: a flat one is stable")
  tap.is(at(10, 30), "unstable", "tube: a long one is not: 80 > sqrt(3 (10² + 30²))")
  tap.is(at(10, 44.7), "unstable", "tube: below the border, 80 = sqrt(3 (10² + 45.09²))")
  tap.is(at(10, 45.5), "stable", "tube: above it")
  tap.ok(svg:find("no such body", 1, true) and svg:find("h = 80 mm", 1, true), "tube: legend, --set in the own unit")
end

---- errors ---------------------------------------------------------------------------------------------------

for _, case in ipairs {
  { "bodies/brick_centroid.lua", "--over must name two parameters" },
  { "bodies/brick_centroid.lua --over a=1:2", "--over must name two parameters" },
  { "bodies/brick_centroid.lua --over a=1:2,q=1:2", "--over q: the scene has no such parameter (it has a, b, c, M)" },
  { "bodies/brick_centroid.lua --over a=1:2,a=1:2", "two different parameters" },
  { "bodies/brick_centroid.lua --over a=2:1,b=1:2", "LOW must be less than HIGH, got a=2:1" },
  { "bodies/brick_centroid.lua --over a=1:1,b=1:2", "LOW must be less than HIGH" },
  { "bodies/brick_centroid.lua --over a=1:x,b=1:2", "--over must be NAME=LOW:HIGH" },
  { "bodies/brick_centroid.lua --over a=1:1e400,b=1:2", "the range must be within that of double, got a=1:1e400" },
  { "bodies/brick_centroid.lua --over a=1:2,b=1:2 --axis q", "--axis must be" },
  { "bodies/brick.lua --over a=1:2,b=1:2", "no simple closed form" },
  { "bodies/cube_corner.lua --over a=1:2,M=1:2 --axis x", "no principal axis" },
  { "bodies/brick_centroid.lua --over a=1:2,b=1:2 -o " .. dir .. "/tube.lua/x.svg", "tube.lua" },
} do
  local code, out, err = run("chart " .. case[1])
  tap.ok(code == 2 and out == "" and err:find(case[2], 1, true), "chart " .. case[1], err)
end

program.finish()
tap.done()
