-- workprecision.lua -- a work-precision diagram: error against time, both logarithmic, every curve with its name on it.
--
--     workprecision.text { title =, about =, note =, xlabel =, ylabel =,
--       curves = { { label =, kind = "own"|"group"|"peer"|"spot", points = { { time, error }, ... } }, ... },
--       floors = { { error, "what it is" }, ... } }
-- Curves differ by marker and dash as well as by colour, so that print in black and white tells them apart: kinds are
-- own (solid, filled markers), group (heavy, dashed, no colour of its own), peer (grey, hollow markers) and spot (a
-- single point, a star).  A label stands where it hides least: of some places along its curve the one with the smallest
-- sum of what it would cover.  Times and errors are positive; errors above `most` are left out.
-- SPDX-License-Identifier: GPL-3.0-or-later

local svg = require "generator.draw.svg"

local workprecision = {}

local width, height = 860, 600
local box = { 74, 66, 836, 546 } -- of the chart's frame
local most, least = 10.0, 1e-18 -- errors that are drawn
local letter, line_height = 6.3, 13 -- about the size of a label's letters

local halo = "paint-order:stroke;stroke-width:3.5px;stroke-linejoin:round;"
local styles = {
  { "name", "font:12px sans-serif;fill:#222;stroke:#fff;" .. halo, "fill:#e6e9ee;stroke:#15181d" },
  { "name-peer", "font:italic 12px sans-serif;fill:#555;stroke:#fff;" .. halo, "fill:#aab;stroke:#15181d" },
  { "wire", "fill:none;stroke-width:1.5;stroke-linejoin:round" },
  { "thick", "fill:none;stroke:#222;stroke-width:2.4;stroke-dasharray:9 4", "stroke:#e6e9ee" },
  { "thick2", "fill:none;stroke:#222;stroke-width:2.4;stroke-dasharray:2 3", "stroke:#e6e9ee" },
  { "dull", "stroke:#888", "stroke:#8a919c" },
  { "hollow", "fill:#fff;stroke:#777;stroke-width:1.1", "fill:#15181d;stroke:#9aa" },
  { "solid-e", "fill:#8a6d00", "fill:#d9bb4a" },
  { "floor", "stroke:#777;stroke-width:1;stroke-dasharray:1 4;stroke-linecap:round;fill:none", "stroke:#9aa" },
  { "lead", "stroke:#999;stroke-width:.7;fill:none", "stroke:#788" },
}

local colours = { "a", "b", "c", "d", "e" }
local dots = { "dot-a", "dot-b", "dot-c", "dot-d", "solid-e" }
local dashes = { false, "7 3", "2 2.5", "8 3 2 3", "12 3", "4 2 1 2 1 2", "5 5", "1 4" }

-- ---- markers ----

local function regular(n, r, turn, inner)
  return function(d, x, y, class)
    local points = {}
    for i = 0, n - 1 do
      local angle, s = 2 * math.pi * i / n + turn, (inner and i % 2 == 1) and inner or r
      points[#points + 1] = { x + s * math.sin(angle), y - s * math.cos(angle) }
    end
    d:polygon(points, class)
  end
end

local markers = {
  function(d, x, y, class) d:circle(x, y, 3.4, class) end,
  regular(4, 4.4, math.pi / 4), -- square
  regular(3, 4.7, 0), -- triangle
  regular(4, 4.7, 0), -- diamond
  regular(3, 4.7, math.pi), -- triangle, downwards
  regular(10, 5.4, 0, 2.2), -- star of five points
  regular(8, 5.2, 0, 1.9), -- star of four
  regular(6, 4.3, 0), -- hexagon
}
local star = regular(10, 8, 0, 3.4)

-- ---- labels ----

local function overlap(a, b)
  local x, y = math.min(a[3], b[3]) - math.max(a[1], b[1]), math.min(a[4], b[4]) - math.max(a[2], b[2])
  return x > 0 and y > 0 and x * y or 0
end

-- The length of the segment p q inside the box (Liang and Barsky).
local function inside(b, p, q)
  local from, to, dx, dy = 0.0, 1.0, q[1] - p[1], q[2] - p[2]
  for _, e in ipairs { { -dx, p[1] - b[1] }, { dx, b[3] - p[1] }, { -dy, p[2] - b[2] }, { dy, b[4] - p[2] } } do
    if e[1] == 0 then
      if e[2] < 0 then return 0 end
    elseif e[1] < 0 then
      from = math.max(from, e[2] / e[1])
    else
      to = math.min(to, e[2] / e[1])
    end
  end
  return math.max(to - from, 0) * math.sqrt(dx * dx + dy * dy)
end

-- The box of a label of that many letters at the point: {x1, y1, x2, y2}, and where a line to it would end.
local places = {}
for _, far in ipairs { 7, 18, 32 } do
  for _, side in ipairs { { 1, 0 }, { -1, 0 }, { 1, 1 }, { -1, 1 }, { 1, -1 }, { -1, -1 }, { 0, 1 }, { 0, -1 } } do
    places[#places + 1] = { side[1], side[2], far }
  end
end

local function placed(p, place, letters)
  local w = letters * letter
  local x = p[1] + place[1] * place[3] - (1 - place[1]) / 2 * w
  local y = p[2] + place[2] * place[3] - line_height / 2
  return { x, y, x + w, y + line_height }
end

-- Chooses places for the labels of all curves, the shortest curves first: those have the least choice.
local function label(d, curves, taken)
  local order = {}
  for i in ipairs(curves) do order[i] = i end
  table.sort(order, function(a, b)
    if #curves[a].pixels ~= #curves[b].pixels then return #curves[a].pixels < #curves[b].pixels end
    return a < b
  end)
  for _, i in ipairs(order) do
    local c, best, least_cost = curves[i], nil, math.huge
    local n = utf8.len(c.label)
    for at, p in ipairs(c.pixels) do
      for rank, place in ipairs(places) do
        local b = placed(p, place, n)
        local cost = 0.4 * rank + 0.8 * (#c.pixels - at) -- near, and at the accurate end
        if b[1] < box[1] + 2 or b[3] > box[3] - 2 or b[2] < box[2] + 2 or b[4] > box[4] - 2 then cost = cost + 1e6 end
        for _, t in ipairs(taken) do cost = cost + overlap(b, t) * 2 end
        for _, other in ipairs(curves) do
          for k, q in ipairs(other.pixels) do
            cost = cost + overlap(b, { q[1] - 4, q[2] - 4, q[1] + 4, q[2] + 4 }) * 0.5
            if k > 1 then cost = cost + inside(b, other.pixels[k - 1], q) * (other == c and 0.3 or 0.6) end
          end
          if cost >= least_cost then break end
        end
        if cost < least_cost then best, least_cost = { b, p, place[3] }, cost end
      end
    end
    local b, p = best[1], best[2]
    taken[#taken + 1] = b
    if best[3] > 10 then -- a thin line back to the curve
      local x, y = math.max(b[1], math.min(p[1], b[3])), math.max(b[2], math.min(p[2], b[4]))
      d:line(p[1], p[2], x, y, "lead")
    end
    c.at = { b[1], b[4] - 3 }
  end
  for _, c in ipairs(curves) do d:text(c.at[1], c.at[2], c.label, c.kind == "peer" and "name-peer" or "name") end
end

-- ---- the diagram ----

local function decades(lo, hi)
  local a, b = math.floor(math.log(lo, 10) + 1e-9), math.ceil(math.log(hi, 10) - 1e-9)
  return { 10.0 ^ a, 10.0 ^ math.max(b, a + 1) }
end

-- Around [lo, hi], at least two decades.
local function around(lo, hi)
  local middle, half = math.sqrt(lo * hi), math.max(math.sqrt(hi / lo) * 1.5, 10.0)
  return { middle / half, middle * half }
end

-- The ranges of times and errors, over what is drawn.
local function ranges(curves, floors)
  local t0, t1, e0, e1 = math.huge, 0, math.huge, 0
  for _, c in ipairs(curves) do
    for _, p in ipairs(c.points) do
      t0, t1, e0, e1 = math.min(t0, p[1]), math.max(t1, p[1]), math.min(e0, p[2]), math.max(e1, p[2])
    end
  end
  for _, f in ipairs(floors) do e0, e1 = math.min(e0, f[1]), math.max(e1, f[1]) end
  if t1 == 0 then return nil end
  return around(t0, t1), decades(e0 * 0.5, e1)
end

local function draw(d, curves)
  local own, peers, groups = 0, 0, 0
  for _, c in ipairs(curves) do
    if c.kind == "own" then
      own = own + 1
      local k, style = (own - 1) % #colours + 1, dashes[(own - 1) % #dashes + 1]
      c.dot, c.marker = dots[k], markers[(own - 1) % #markers + 1]
      c.class, c.style = "wire " .. colours[k], style and "stroke-dasharray:" .. style or nil
    elseif c.kind == "peer" then
      peers = peers + 1
      local style = dashes[(peers - 1) % #dashes + 1]
      c.dot, c.marker = "hollow", markers[(peers - 1) % #markers + 1]
      c.class, c.style = "wire dull", style and "stroke-dasharray:" .. style or nil
    elseif c.kind == "group" then
      groups = groups + 1
      c.class = groups % 2 == 1 and "thick" or "thick2"
    else
      c.dot, c.marker = "dot", star
    end
  end
  for _, kind in ipairs { "peer", "group", "own", "spot" } do -- ours on top
    for _, c in ipairs(curves) do
      if c.kind == kind and #c.pixels > 1 then d:path(c.pixels, c.class, c.style) end
    end
    for _, c in ipairs(curves) do
      for _, p in ipairs(c.kind == kind and c.marker and c.pixels or {}) do c.marker(d, p[1], p[2], c.dot) end
    end
  end
end

-- The diagram as SVG text; nil when there is nothing to draw.
function workprecision.text(chart)
  local curves, floors = {}, {}
  for _, c in ipairs(chart.curves) do
    local points = {}
    for _, p in ipairs(c.points) do
      if p[2] <= most and p[1] > 0 then points[#points + 1] = { p[1], math.max(p[2], least) } end
    end
    if #points > 0 then curves[#curves + 1] = { label = c.label, kind = c.kind, points = points } end
  end
  for _, f in ipairs(chart.floors or {}) do
    if f[1] > 0 and f[1] < most then floors[#floors + 1] = f end
  end
  local xrange, yrange = ranges(curves, floors)
  if not xrange then return nil end
  local d = svg.new(width, height, { title = chart.title, about = chart.about, palette = styles })
  d:text(box[1], 28, chart.title, "title")
  if chart.note then d:text(box[1], 48, chart.note, "small") end
  local s = svg.frame(d, { x0 = box[1], y0 = box[2], x1 = box[3], y1 = box[4], xlog = true, ylog = true,
    xrange = xrange, yrange = yrange, xlabel = chart.xlabel, ylabel = chart.ylabel })
  local taken = {}
  for _, f in ipairs(floors) do
    local y = s.y(f[1])
    d:line(box[1], y, box[3], y, "floor")
    d:text(box[1] + 8, y - 4, f[2], "small")
    taken[#taken + 1] = { box[1], y - 14, box[1] + 8 + utf8.len(f[2]) * 5.6, y + 1 }
  end
  for _, c in ipairs(curves) do
    c.pixels = {}
    for i, p in ipairs(c.points) do c.pixels[i] = { s.at(p[1], p[2]) } end
  end
  draw(d, curves)
  label(d, curves, taken)
  return svg.text(d)
end

return workprecision
