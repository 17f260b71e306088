#!/usr/bin/env lua5.4
-- workprecision.t - the diagram: points where their logarithms are, markers and dashes that differ, names that do not
-- cover each other, light and dark.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local workprecision = require "generator.draw.workprecision"

local function curve(label, kind, first, order, count)
  local points = {}
  for i = 0, count - 1 do points[i + 1] = { first * 2 ^ i, 0.1 * 2 ^ (-order * i) } end
  return { label = label, kind = kind, points = points }
end

local curves = { curve("closed form", "spot", 1e-6, 0, 1), curve("rk4", "own", 1e-5, 4, 8),
  curve("taylor", "own", 2e-5, 12, 3), curve("split4", "own", 4e-5, 4, 8), curve("split6", "own", 8e-5, 6, 5),
  curve("midpoint", "own", 2e-5, 2, 6), curve("semi", "own", 1e-5, 1, 6), curve("best of them", "group", 1e-5, 11, 3),
  curve("GSL rk8pd", "peer", 3e-5, 8, 4), curve("GSL rkf45", "peer", 3e-5, 5, 6), curve("CVODE", "peer", 1e-3, 5, 6) }
local text = workprecision.text { title = "a < b", about = "it", xlabel = "t", ylabel = "e", curves = curves,
  floors = { { 1e-13, "one ulp" } } }

-- ---- where things are ----

local x0, y0, w, h = text:match '<rect class="frame" x="([%d.]+)" y="([%d.]+)" width="([%d.]+)" height="([%d.]+)"/>'
x0, y0, w, h = tonumber(x0), tonumber(y0), tonumber(w), tonumber(h)

do -- rk4: the path with as many points
  local path
  for data in text:gmatch '<path class="wire a"[^>]* d="M([^"]*)"' do path = path or data end
  local xs, ys = {}, {}
  for x, y in path:gmatch "([%d.]+),([%d.]+)" do xs[#xs + 1], ys[#ys + 1] = tonumber(x), tonumber(y) end
  tap.is(#xs, 8, "the first curve has its points")
  local even = true
  for i = 3, 8 do
    -- 0.02: coordinates have two decimals
    even = even and math.abs(xs[i] - 2 * xs[i - 1] + xs[i - 2]) <= 0.021
      and math.abs(ys[i] - 2 * ys[i - 1] + ys[i - 2]) <= 0.021
  end
  tap.ok(even, "equal factors are equal distances, along both axes")
  local ticks = {}
  for x, label in text:gmatch '<text class="tick" x="([%d.]+)" y="561" text%-anchor="middle">(.-)</text>' do
    ticks[#ticks + 1] = { tonumber(x), (label:gsub("<[^>]*>", "")) }
  end
  local at
  for _, t in ipairs(ticks) do at = t[2] == "10−5" and t[1] or at end
  tap.near(at or 0, xs[1], 0, 0.011, "the time 1e-5 stands above its tick (two decimals)",
      "two decimals of a pixel")
end

do
  local inside = true
  for x, y in text:gmatch '<circle class="[^"]*" cx="([%d.]+)" cy="([%d.]+)"' do
    x, y = tonumber(x), tonumber(y)
    inside = inside and x >= x0 and x <= x0 + w and y >= y0 and y <= y0 + h
  end
  tap.ok(inside, "markers are within the frame")
end

-- ---- names ----

do
  local boxes, found = {}, {}
  for class, x, y, name in text:gmatch '<text class="(name[%w-]*)" x="([%d.]+)" y="([%d.]+)">([^<]*)</text>' do
    x, y = tonumber(x), tonumber(y)
    boxes[#boxes + 1] = { x, y - 10, x + 5 * #name, y }
    found[name] = class
  end
  local all = #boxes == #curves
  for _, c in ipairs(curves) do
    all = all and found[c.label] == (c.kind == "peer" and "name-peer" or "name")
  end
  tap.ok(all, "every curve has its name, once; peers in another hand")
  local apart, within = true, true
  for i, a in ipairs(boxes) do
    within = within and a[1] >= x0 and a[3] <= x0 + w and a[2] >= y0 and a[4] <= y0 + h
    for j = 1, i - 1 do
      local b = boxes[j]
      apart = apart and not (a[1] < b[3] and b[1] < a[3] and a[2] < b[4] and b[2] < a[4])
    end
  end
  tap.ok(apart, "no name covers another")
  tap.ok(within, "all are within the frame")
end

-- ---- black and white, light and dark ----

do
  local looks, same = {}, false
  for class, style in text:gmatch '<path class="wire (%S+)"( ?s?t?y?l?e?=?"?[^"]*"?) d=' do
    same = same or looks[class .. style]
    looks[class .. style] = true
  end
  tap.ok(not same, "no two curves have the same colour and dash")
  local dashes, n = {}, 0
  for style in text:gmatch '<path class="wire %l"([^>]*) d=' do
    n = n + (dashes[style] and 0 or 1)
    dashes[style] = true
  end
  tap.is(n, 6, "without colour six of ours still differ by their dashes")
  local dark = text:match "@media screen and %(prefers%-color%-scheme:dark%){(.-)}</style>"
  for _, class in ipairs { "paper", "name", "name-peer", "hollow", "dull", "thick", "floor", "dot-a" } do
    tap.like(dark, "." .. class .. "{", class .. " is another on a dark screen")
  end
end

-- ---- what is left out ----

tap.is(workprecision.text { title = "", curves = {} }, nil, "nothing to draw")
tap.is(workprecision.text { title = "", curves = { { label = "a", kind = "own", points = { { 1e-6, 20.0 } } } } }, nil,
  "an error that is none is not drawn")
tap.like(workprecision.text { title = "a < b", curves = { { label = "x", kind = "own", points = { { 1e-6, 0.0 } } } } },
  "<title>a &lt; b</title>", "an error of zero is drawn at the bottom; titles are escaped")
tap.is(text, workprecision.text { title = "a < b", about = "it", xlabel = "t", ylabel = "e", curves = curves,
  floors = { { 1e-13, "one ulp" } } }, "the same calls give the same bytes")

tap.done()
