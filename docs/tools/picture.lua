-- picture.lua -- the picture of a body: its surface, the axes through the origin, the centroid, its dimensions.
--
--     picture.of(surface, { title =, about =, centroid = {x, y, z}, dims = {{"r", p, q, ...}, ...}, open =, view = })
--
-- dims: a label and two or more points in the body's frame, the lengths that the arguments name; out = true draws the
-- line beside the body instead of on it.  open: shells and plates, both sides are seen.
-- SPDX-License-Identifier: GPL-3.0-or-later

local svg = require "generator.draw.svg"
local view = require "docs.tools.view"
local shade = require "docs.tools.shade"

local picture = {}

local width, height, margin = 340, 280, 46

local styles = {
  { "skin", "stroke-width:.7;stroke-linejoin:round" },
  { "outline", "fill:none;stroke:#1d3247;stroke-width:1.5;stroke-linejoin:round;stroke-linecap:round",
    "stroke:#dce8f5" },
  { "edge", "fill:none;stroke:#33506e;stroke-width:.9;stroke-linejoin:round;stroke-linecap:round", "stroke:#b9cde2" },
  { "wire", "fill:none;stroke:#2f659c;stroke-width:3.2;stroke-linejoin:round;stroke-linecap:round", "stroke:#8fb8e6" },
  { "ball", "fill:#5f8fc2;stroke:#1d3247;stroke-width:1", "fill:#7da9d8;stroke:#dce8f5" },
  { "hid", "stroke:#555;stroke-width:.8;stroke-dasharray:2 3;fill:none", "stroke:#c8cdd6" },
  { "dim", "fill:none;stroke:#b3261e;stroke-width:1.1;stroke-linecap:round", "stroke:#ff9a8f" },
  { "ext", "fill:none;stroke:#b3261e;stroke-width:.5;stroke-dasharray:2 2", "stroke:#ff9a8f" },
  { "name", "font:italic 16px serif;fill:#9c1c15;stroke:#fff;stroke-width:3.5px;paint-order:stroke;"
    .. "stroke-linejoin:round", "fill:#ffb3aa;stroke:#15181d" },
  { "xyz", "font:italic 15px serif;fill:#444", "fill:#c3c8d0" },
  { "cm", "fill:none;stroke:#fff;stroke-width:3", "stroke:#15181d" },
  { "com", "fill:#fff;stroke:#000;stroke-width:1.2", "fill:#15181d;stroke:#fff" },
  { "com2", "fill:#000", "fill:#fff" },
}

-- Every point of s through f, shared points once.
local function mapped(s, f)
  local seen = {}
  local function at(p)
    seen[p] = seen[p] or f(p)
    return seen[p]
  end
  local out = { faces = {}, lines = {}, points = {}, creases = {} }
  for _, kind in ipairs { "faces", "lines", "creases" } do
    for i, item in ipairs(s[kind]) do
      local list = { cut = item.cut, flat = item.flat }
      for k, p in ipairs(item) do list[k] = at(p) end
      out[kind][i] = list
    end
  end
  for i, p in ipairs(s.points) do out.points[i] = at(p) end
  return out
end

local function extent(s, more)
  local lo, hi = { math.huge, math.huge }, { -math.huge, -math.huge }
  for _, list in ipairs { s.faces, s.lines, { s.points, more } } do
    for _, item in ipairs(list) do
      for _, p in ipairs(item) do
        for d = 1, 2 do lo[d], hi[d] = math.min(lo[d], p[d]), math.max(hi[d], p[d]) end
      end
    end
  end
  return lo, hi
end

local function length(s) -- the largest distance of a point from the origin along each axis
  local reach = { 0, 0, 0 }
  for _, list in ipairs { s.faces, s.lines, { s.points } } do
    for _, item in ipairs(list) do
      for _, p in ipairs(item) do
        for d = 1, 3 do reach[d] = math.max(reach[d], p[d]) end
      end
    end
  end
  return reach
end

-- ---- parts of the drawing ----

local function flip(p) return { p[1], height - p[2] } end -- SVG counts downwards

local function paint(doc, seen)
  for layer = 1, seen.layers do
    local faces, outline, edge = {}, {}, {}
    for _, f in ipairs(seen.faces) do if f.layer == layer then faces[#faces + 1] = f end end
    for _, e in ipairs(seen.edges) do
      if e.layer == layer then table.insert(e.outline and outline or edge, e) end
    end
    for _, area in ipairs(shade.areas(faces)) do
      local d = {}
      for i, loop in ipairs(area.loops) do
        for k, p in ipairs(loop) do loop[k] = flip(p) end
        d[i] = svg.through(loop, true)
      end
      if #d > 0 then doc:path(table.concat(d), area.class) end
    end
    for _, kind in ipairs { { edge, "edge" }, { outline, "outline" } } do
      local d = {}
      for i, line in ipairs(shade.lines(kind[1])) do
        for k, p in ipairs(line) do line[k] = flip(p) end
        d[i] = svg.through(line)
      end
      if #d > 0 then doc:path(table.concat(d), kind[2]) end
    end
  end
end

-- A line in space, solid where it is seen, dotted where something is before it.
local function line_in_space(doc, seen, p, q, class)
  local n, from, state = 60, p, nil
  local function at(i)
    local t = i / n
    return { p[1] + (q[1] - p[1]) * t, p[2] + (q[2] - p[2]) * t, p[3] + (q[3] - p[3]) * t }
  end
  for i = 0, n do
    local hidden = i < n and view.hidden(seen, at(i + 0.5))
    if i == n or state ~= nil and hidden ~= state then
      local to = at(i)
      doc:line(from[1], height - from[2], to[1], height - to[2], state and "hid" or class)
      from = to
    end
    state = hidden
  end
end

local function axes(doc, seen, map, reach, size)
  for d, name in ipairs { "x", "y", "z" } do
    local e = { 0, 0, 0 }
    e[d] = reach[d] + 0.24 * size
    local o, tip = map { 0, 0, 0 }, map(e)
    local l = math.sqrt((tip[1] - o[1]) ^ 2 + (tip[2] - o[2]) ^ 2)
    line_in_space(doc, seen, o, tip, "axis")
    if l > 8 then
      local ux, uy = (tip[1] - o[1]) / l, (tip[2] - o[2]) / l
      doc:arrow(tip[1] - ux, height - tip[2] + uy, tip[1], height - tip[2], "axis")
      doc:text(tip[1] + 9 * ux, height - tip[2] - 9 * uy + 5, name, "xyz", "middle")
    end
  end
end

local function dimension(doc, dim, map, centre)
  local p = {}
  for i = 2, #dim do p[i - 1] = map(dim[i]) end
  local a, b = p[1], p[#p]
  local l = math.sqrt((b[1] - a[1]) ^ 2 + (b[2] - a[2]) ^ 2)
  local nx, ny = 0, 1
  if l > 1e-6 then nx, ny = -(b[2] - a[2]) / l, (b[1] - a[1]) / l end
  local m = p[(#p + 1) // 2]
  if #p % 2 == 0 then
    local n = p[#p // 2 + 1]
    m = { (m[1] + n[1]) / 2, (m[2] + n[2]) / 2 }
  end
  local side = (m[1] - centre[1]) * nx + (m[2] - centre[2]) * ny
  if math.abs(side) < 1 then side = ny >= 0 and 1 or -1 end -- no outer side: above
  if side < 0 ~= (dim.other or false) then nx, ny = -nx, -ny end
  local off = dim.out and (type(dim.out) == "number" and dim.out or 13) or 0
  local function moved(v) return flip { v[1] + off * nx, v[2] + off * ny } end
  if off > 0 then
    for _, v in ipairs { a, b } do
      local from, to = flip { v[1] + 2 * nx, v[2] + 2 * ny }, moved(v)
      doc:line(from[1], from[2], to[1], to[2], "ext")
    end
  end
  local list = {}
  for i, v in ipairs(p) do list[i] = moved(v) end
  doc:path(list, "dim")
  if #p == 2 then
    for _, v in ipairs(list) do
      doc:line(v[1] - 3.5 * nx, v[2] + 3.5 * ny, v[1] + 3.5 * nx, v[2] - 3.5 * ny, "dim")
    end
  end
  local t = flip { m[1] + (off + 11) * nx, m[2] + (off + 11) * ny }
  doc:math(t[1], t[2] + 5, dim[1], "name", nx > 0.5 and "start" or nx < -0.5 and "end" or "middle")
end

-- ---- the picture ----

function picture.of(s, o)
  local camera = view.camera(o.view and o.view[1] or 32, o.view and o.view[2] or 24)
  local ends = {}
  local reach = length(s)
  local raw = mapped(s, camera)
  local lo, hi = extent(raw)
  local size = math.max(hi[1] - lo[1], hi[2] - lo[2])
  for d = 1, 3 do
    local e = { 0, 0, 0 }
    e[d] = reach[d] + 0.2 * size
    ends[d] = camera(e)
  end
  ends[4] = camera { 0, 0, 0 }
  for _, dim in ipairs(o.dims or {}) do
    for i = 2, #dim do ends[#ends + 1] = camera(dim[i]) end
  end
  lo, hi = extent(raw, ends)
  local scale = math.min((width - 2 * margin) / (hi[1] - lo[1]), (height - 2 * margin) / (hi[2] - lo[2]))
  local mx, my = (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2
  local function map(p)
    local v = camera(p)
    return { width / 2 + scale * (v[1] - mx), height / 2 + scale * (v[2] - my), scale * v[3] }
  end
  local screen = mapped(s, map)
  local palette = shade.palette()
  for _, p in ipairs(styles) do palette[#palette + 1] = p end
  local doc = svg.new(width, height, { title = o.title, about = o.about, palette = palette })
  local seen = view.of(screen, o.open)
  doc:group("skin", function() paint(doc, seen) end)
  axes(doc, seen, map, reach, size)
  for _, l in ipairs(screen.lines) do
    local list = {}
    for i, p in ipairs(l) do list[i] = flip { math.floor(p[1] * 10 + 0.5) / 10, math.floor(p[2] * 10 + 0.5) / 10 } end
    doc:path(list, "wire")
  end
  table.sort(screen.points, function(a, b) return a[3] < b[3] end)
  for _, p in ipairs(screen.points) do doc:circle(p[1], height - p[2], 7, "ball") end
  lo, hi = extent(screen)
  local centre = { (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2 }
  for _, dim in ipairs(o.dims or {}) do dimension(doc, dim, map, centre) end
  if o.centroid then
    local c = flip(map(o.centroid))
    doc:circle(c[1], c[2], 4.5, "com")
    local x, y = svg.number(c[1]), svg.number(c[2])
    doc:path("M" .. x .. "," .. y .. "h4.5a4.5,4.5 0 0,0 -4.5,-4.5zh-4.5a4.5,4.5 0 0,0 4.5,4.5z", "com2")
  end
  return svg.text(doc)
end

return picture
