-- members_chart.lua -- members of a sweep as a picture: a histogram of one column, points of two, a map of three.
--
--     members.text(names, columns) -> the SVG, or nil and what is wrong
-- A map has a cell for each point of a grid; borders are halfway to the neighbours, on a logarithmic axis where the
-- grid is one.  Colours go from dark to light with the value; members without a number are hatched.
-- SPDX-License-Identifier: GPL-3.0-or-later

local svg = require "generator.draw.svg"

local members = {}

local SHADES, MOST_POINTS, BINS = 64, 50000, 60
local WIDTH, HEIGHT = 640, 480
local BOX = { x0 = 70, y0 = 30, x1 = 520, y1 = 430 }
-- Of ascending lightness, so that they read in grey, too.
local ANCHORS = { { 38, 22, 84 }, { 39, 80, 140 }, { 31, 138, 138 }, { 104, 190, 98 }, { 243, 226, 90 } }

local function colour(s)
  local at = s * (#ANCHORS - 1)
  local i = math.min(#ANCHORS - 1, math.floor(at) + 1)
  local c = {}
  for k = 1, 3 do
    c[k] = math.floor(ANCHORS[i][k] + (ANCHORS[i + 1][k] - ANCHORS[i][k]) * (at - i + 1) + 0.5)
  end
  return string.format("#%02x%02x%02x", c[1], c[2], c[3])
end

local palette = { { "none", "fill:url(#hatch)" }, { "hatch", "stroke:#999;stroke-width:1", "stroke:#666d78" },
  { "hatched", "fill:#eee", "fill:#22262c" }, { "bar", "fill:#1f6fb2", "fill:#6db3f2" } }
for i = 0, SHADES - 1 do
  palette[#palette + 1] = { "s" .. string.format("%d", i), "shape-rendering:crispEdges;fill:" ..
    colour(i / (SHADES - 1)) }
end

local function hatch(d)
  d:put('<defs><pattern id="hatch" width="6" height="6" patternUnits="userSpaceOnUse"><rect' ..
    d:attributes("hatched") .. ' width="6" height="6"/><path' .. d:attributes("hatch") ..
    ' d="M0 6L6 0"/></pattern></defs>')
end

local function finite(x) return x - x == 0 end

-- Least and greatest of a column; nil where there is none.
local function range(list)
  local low, high = math.huge, -math.huge
  for _, x in ipairs(list) do
    if finite(x) then low, high = math.min(low, x), math.max(high, x) end
  end
  if low > high then return nil end
  local around = low == high and math.max(1e-9, math.abs(low) / 10) or 0
  return { low - around, high + around }
end

-- The different values of a column in their order, and place[value]; nil if there are more than a grid would have.
local function steps(list)
  local seen, out, place = {}, {}, {}
  for _, x in ipairs(list) do
    if finite(x) and not seen[x] then
      seen[x] = true
      out[#out + 1] = x
    end
    if #out > 2000 then return nil end
  end
  table.sort(out)
  for i, x in ipairs(out) do place[x] = i end
  return out, place
end

-- Are the values in equal ratios, over more than a factor of 20?
local function logarithmic(values)
  local n = #values
  if n < 3 or values[1] <= 0 or values[n] / values[1] < 20 then return false end
  local ratio = math.log(values[n] / values[1]) / (n - 1)
  for i = 2, n do
    if math.abs(math.log(values[i] / values[i - 1]) / ratio - 1) > 1e-6 then return false end
  end
  return true
end

-- The borders of the cells.
local function borders(values, log)
  local function into(x) return log and math.log(x) or x end
  local function back(x) return log and math.exp(x) or x end
  local out, n = {}, #values
  for i = 2, n do out[i] = back((into(values[i - 1]) + into(values[i])) / 2) end
  out[1] = back(2 * into(values[1]) - into(out[2]))
  out[n + 1] = back(2 * into(values[n]) - into(out[n]))
  return out
end

local function shade(z, within)
  if not finite(z) then return "none" end
  local s = math.floor((z - within[1]) / (within[2] - within[1]) * SHADES)
  return "s" .. string.format("%d", math.max(0, math.min(SHADES - 1, s)))
end

-- The scale of colours at the right.
local function legend(d, name, within, hatched)
  local x, height = BOX.x1 + 24, BOX.y1 - BOX.y0
  for i = 0, SHADES - 1 do
    d:rect(x, BOX.y1 - (i + 1) * height / SHADES, 16, height / SHADES + 0.5, "s" .. string.format("%d", i))
  end
  d:rect(x, BOX.y0, 16, height, "frame")
  for _, t in ipairs(svg.ticks(within[1], within[2], 6)) do
    d:math(x + 21, BOX.y1 - (t[1] - within[1]) / (within[2] - within[1]) * height + 4, t[2], "tick")
  end
  d:text(x + 8, BOX.y0 - 10, name, "label", "middle")
  if hatched then
    d:rect(x, BOX.y1 + 12, 16, 12, "none")
    d:text(x + 21, BOX.y1 + 22, "none", "tick")
  end
end

local function map(names, columns, xs, xplace, ys, yplace)
  local within = range(columns[3])
  if not within then return nil, "the column " .. names[3] .. " has no number" end
  local xlog, ylog = logarithmic(xs), logarithmic(ys)
  local xb, yb = borders(xs, xlog), borders(ys, ylog)
  local title = names[3] .. " over " .. names[1] .. " and " .. names[2]
  local d = svg.new(WIDTH, HEIGHT, { title = title, palette = palette })
  local hatched, cells = false, {}
  for k, z in ipairs(columns[3]) do
    local i, j = xplace[columns[1][k]], yplace[columns[2][k]]
    if i and j then
      cells[j] = cells[j] or {}
      cells[j][i] = shade(z, within)
      hatched = hatched or not finite(z)
    end
  end
  if hatched then hatch(d) end
  local frame = { x0 = BOX.x0, y0 = BOX.y0, x1 = BOX.x1, y1 = BOX.y1, xrange = { xb[1], xb[#xb] },
    yrange = { yb[1], yb[#yb] }, xlabel = names[1], ylabel = names[2], xlog = xlog, ylog = ylog, grid = false }
  local scale = svg.frame(svg.new(1, 1, {}), frame) -- for its scales; it is drawn over the cells
  local list, paths = {}, {}
  local function put(class, i, last, j)
    local x0, x1, y0, y1 = scale.x(xb[i]), scale.x(xb[last + 1]), scale.y(yb[j]), scale.y(yb[j + 1])
    if not paths[class] then
      list[#list + 1] = class
      paths[class] = {}
    end
    table.insert(paths[class], svg.through({ { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } }, true))
  end
  for j = 1, #ys do
    local i = 1
    while i <= #xs do
      local class, last = cells[j] and cells[j][i], i
      while class and last < #xs and cells[j][last + 1] == class do last = last + 1 end
      if class then put(class, i, last, j) end
      i = last + 1
    end
  end
  d:group(nil, function()
    for _, class in ipairs(list) do d:path(table.concat(paths[class]), class) end
  end)
  svg.frame(d, frame)
  legend(d, names[3], within, hatched)
  return svg.text(d)
end

local function widened(within, share)
  local more = (within[2] - within[1]) * share
  return { within[1] - more, within[2] + more }
end

local function points(names, columns)
  local xr, yr, zr = range(columns[1]), range(columns[2]), columns[3] and range(columns[3])
  if not (xr and yr) then return nil, "the columns have no numbers" end
  local d = svg.new(WIDTH, HEIGHT, { title = names[2] .. " over " .. names[1], palette = palette })
  local scale = svg.frame(d, { x0 = BOX.x0, y0 = BOX.y0, x1 = BOX.x1, y1 = BOX.y1, xrange = widened(xr, 0.03),
    yrange = widened(yr, 0.03), xlabel = names[1], ylabel = names[2] })
  local every = math.max(1, math.ceil(#columns[1] / MOST_POINTS))
  for k = 1, #columns[1], every do
    local x, y = columns[1][k], columns[2][k]
    if finite(x) and finite(y) then
      d:circle(scale.x(x), scale.y(y), 1.2, zr and shade(columns[3][k], zr) or "bar")
    end
  end
  if zr then legend(d, names[3], zr, false) end
  return svg.text(d)
end

local function histogram(name, list)
  local within, counts, most, n = range(list), {}, 0, 0
  if not within then return nil, "the column " .. name .. " has no number" end
  for _, x in ipairs(list) do
    if finite(x) then
      local b = math.min(BINS, math.floor((x - within[1]) / (within[2] - within[1]) * BINS) + 1)
      counts[b] = (counts[b] or 0) + 1
      most, n = math.max(most, counts[b]), n + 1
    end
  end
  local d = svg.new(WIDTH, HEIGHT, { title = "histogram of " .. name, palette = palette })
  local scale = svg.frame(d, { x0 = BOX.x0, y0 = BOX.y0, x1 = BOX.x1, y1 = BOX.y1, xrange = within,
    yrange = { 0, most * 1.05 }, xlabel = name, ylabel = "members" })
  for b = 1, BINS do
    local x0 = scale.x(within[1] + (b - 1) / BINS * (within[2] - within[1]))
    local x1, y = scale.x(within[1] + b / BINS * (within[2] - within[1])), scale.y(counts[b] or 0)
    if counts[b] then d:rect(x0, y, x1 - x0, BOX.y1 - y, "bar") end
  end
  d:text(BOX.x0, BOX.y0 - 10, string.format("%d members", n) .. (n < #list and
    string.format(", %d without a number", #list - n) or ""), "small")
  return svg.text(d)
end

function members.text(columns_named, columns)
  local names = {}
  for i, name in ipairs(columns_named) do names[i] = string.gsub(name, "_", " ") end -- which would lower what follows
  if #columns == 1 then return histogram(names[1], columns[1]) end
  local xs, xplace = steps(columns[1])
  local ys, yplace = steps(columns[2])
  if #columns == 3 and xs and ys and #xs > 1 and #ys > 1 and #xs * #ys <= 2 * #columns[1] then
    return map(names, columns, xs, xplace, ys, yplace)
  end
  return points(names, columns)
end

return members
