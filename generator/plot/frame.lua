-- frame.lua -- panels with two axes: their ranges, names with units, curves with their names at the end.
--
-- A label is quantity over unit, "w / (rad/s)" (SI Brochure 5.4); very small or large values are divided by a power of
-- ten, which then is part of the unit.
-- SPDX-License-Identifier: GPL-3.0-or-later

local curve = require "generator.plot.curve"
local svg = require "generator.draw.svg"

local frame = {}

local right, bottom, left = 36, 38, 58 -- room for names of curves, ticks and labels
local least_room = svg.label_room({ 0, 1 }, false, 100) -- which `left` has
local advance = 7.2 -- of a letter, in pixels, about

-- Least and greatest of lists of numbers, a little wider; what is constant but for rounding gets a range around it.
function frame.range(lists, zero)
  local low, high = math.huge, -math.huge
  for _, list in ipairs(lists) do
    for _, x in ipairs(list) do low, high = math.min(low, x), math.max(high, x) end
  end
  if zero then low, high = math.min(low, 0.0), math.max(high, 0.0) end
  local size = math.max(math.abs(low), math.abs(high))
  if high - low <= 1e-7 * size or high == low then
    local around = size > 0 and 0.5 * size or 1.0
    return { low - around, high + around }
  end
  local more = 0.04 * (high - low)
  return { low - more, high + more }
end

-- The power of ten that a range is divided by, and the words of the unit with it.
function frame.power(range)
  local size = math.max(math.abs(range[1]), math.abs(range[2]))
  if size >= 1e-3 and size < 1e5 or size == 0 then return 1.0, "" end
  local k = math.floor(math.log(size, 10) + 1e-9)
  return 10.0 ^ k, "10^{" .. (string.gsub(string.format("%d", k), "^%-", "−")) .. "}"
end

-- Letters that stand alone are quantities: italic for doc:math.  Words, indices and the Delta of a change stay upright.
local function italic(name)
  return (string.gsub(name, "([_^]?)([%a\xCE\xCF][%a\x80-\xBF]*)", function(mark, word)
    local letter = string.gsub(word, "^Δ", "")
    local before = string.sub(word, 1, #word - #letter)
    if mark ~= "" or utf8.len(letter) ~= 1 then return nil end
    return before .. "⟨" .. letter .. "⟩"
  end))
end

-- "t / s" as text of doc:math; units of several parts stand in brackets.
function frame.label(name, unit, power)
  name = italic(name)
  local parts = {}
  if power and power ~= "" then parts[1] = power end
  if unit and unit ~= "1" then parts[#parts + 1] = unit end
  if #parts == 0 then return name end
  local whole = table.concat(parts, " ")
  if #parts > 1 or string.find(whole, "[/ ]") then whole = "(" .. whole .. ")" end
  return name .. " / " .. whole
end

-- Heights for names at the right of the frame, near to where the curves end and 14 pixels apart.
local function spread(list, low, high)
  table.sort(list, function(a, b)
    if a.y ~= b.y then return a.y < b.y end
    return a.place < b.place
  end)
  for i, l in ipairs(list) do l.at = math.max(l.y, low, i > 1 and list[i - 1].at + 14 or low) end
  local most = high
  for i = #list, 1, -1 do
    list[i].at = math.min(list[i].at, most)
    most = list[i].at - 14
  end
end

local row, item, longest = 16, 34, 8 -- pixels of the legend; letters of a name that stands at a curve's end

-- Draws rows of short lines with what they mean, {class, text}, from (x, y) on to x1; returns their height.
local function legend(d, list, x, y, x1)
  local at, height = x, 0
  for _, l in ipairs(list) do
    local wide = item + advance * utf8.len(l[2])
    if at > x and at + wide > x1 then at, height = x, height + row end
    d:line(at, y + height + 5, at + 20, y + height + 5, "line " .. l[1])
    d:math(at + 25, y + height + 9, l[2], "small")
    at = at + wide
  end
  return #list > 0 and height + row + 2 or 0
end

-- Path data of a curve, and its last point.  With ranges what leaves the frame is cut off; a logarithmic axis has no 0.
local function path_of(c, p, f, point)
  local data, points, last = {}, {}, nil
  local function lift()
    local cut = p.xrange or p.yrange
    for _, piece in ipairs(cut and curve.clipped(points, f.x0, f.y0, f.x1, f.y1) or { points }) do
      if #piece > 0 then data[#data + 1], last = curve.path(piece), piece[#piece] end
    end
    points = {}
  end
  for i, v in ipairs(c.values) do
    if c.breaks and c.breaks[i] then lift() end
    if p.log and v <= 0 then lift() else points[#points + 1] = point(c.xs[i], v) end
  end
  lift()
  return table.concat(data), last
end

-- p: {box =, x = {name, unit}, y = {name, unit}, curves = {{name =, class =, xs =, values =, breaks = set of indices
-- where the pen is lifted}, ...}, log = a logarithmic y axis, xrange =, yrange =, mark = {x, words} of an upright line,
-- the words at its left, legend = {{class, text}, ...}}.  Names are at the ends of curves; long ones in the legend.
function frame.over(d, p)
  local box, lists, times, named, keys, long = p.box, {}, {}, {}, {}, 0
  for i, c in ipairs(p.curves) do
    lists[i], times[i] = c.values, { c.xs[1], c.xs[#c.xs] }
    long = math.max(long, utf8.len(c.name))
    if c.name ~= "" then named[#named + 1] = { c.class, c.name } end
  end
  local at_ends = #named > 1 and long <= longest
  for _, l in ipairs(#named > 1 and not at_ends and named or {}) do keys[#keys + 1] = l end
  for _, l in ipairs(p.legend or {}) do keys[#keys + 1] = l end
  local x0, x1 = box.x0 + left, box.x1 - (at_ends and math.max(right, 14 + advance * long) or right)
  local above = legend(d, keys, x0, box.y0, x1)
  local low, high = math.huge, -math.huge
  for _, ends in ipairs(times) do low, high = math.min(low, ends[1]), math.max(high, ends[2]) end
  local xr, yr = p.xrange or { low, high }, p.yrange or frame.range(lists, p.zero)
  local xs, xp = frame.power(xr)
  local ys, yp = 1.0, ""
  if not p.log then ys, yp = frame.power(yr) end
  local top, ends = box.y0 + above, box.y1 - bottom
  x0 = x0 + svg.label_room({ yr[1] / ys, yr[2] / ys }, p.log, ends - top) - least_room
  local f = { x0 = x0, y0 = top, x1 = x1, y1 = ends,
    xrange = { xr[1] / xs, xr[2] / xs }, yrange = { yr[1] / ys, yr[2] / ys }, ylog = p.log,
    xlabel = frame.label(p.x[1], p.x[2], xp), ylabel = frame.label(p.y[1], p.y[2], yp) }
  local scale = svg.frame(d, f)
  if p.mark and p.mark[1] >= xr[1] and p.mark[1] <= xr[2] then
    local x = scale.x(p.mark[1] / xs)
    d:line(x, f.y0, x, f.y1, "ring")
    d:text(x - 5, f.y0 + 14, p.mark[2], "small", "end")
  end
  local names = {}
  for place, c in ipairs(p.curves) do
    local data, last = path_of(c, p, f, function(x, y) return { scale.x(x / xs), scale.y(y / ys) } end)
    if last then
      d:path(data, "line " .. c.class)
      if c.name ~= "" then names[#names + 1] = { x = last[1], y = last[2], c = c, place = place } end
    end
  end
  if not at_ends then return scale end
  spread(names, f.y0 + 4, f.y1 - 2)
  for _, n in ipairs(names) do
    d:line(f.x1 + 1, n.y, f.x1 + 9, n.at, "line " .. n.c.class)
    d:math(f.x1 + 12, n.at + 4, n.c.name, "end")
  end
  return scale
end

-- A panel with one scale for x and y, which holds [-reach, reach] or the ranges: returns the scale and the power.
-- p: {box =, x =, y = {name, unit}, xrange =, yrange =}
function frame.plane(d, p)
  local box = p.box
  local x0, x1, y0, y1 = box.x0 + left, box.x1 - 12, box.y0, box.y1 - bottom
  local wide, high = p.xrange[2] - p.xrange[1], p.yrange[2] - p.yrange[1]
  local unit = math.min((x1 - x0) / wide, (y1 - y0) / high) -- pixels
  local mx, my = (p.xrange[1] + p.xrange[2]) / 2, (p.yrange[1] + p.yrange[2]) / 2
  local w, h = math.min(x1 - x0, math.max(wide * unit, 0.8 * (y1 - y0))), y1 - y0
  local cx = (x0 + x1) / 2
  local s, text = frame.power { math.max(math.abs(p.xrange[1]), math.abs(p.xrange[2])),
    math.max(math.abs(p.yrange[1]), math.abs(p.yrange[2])) }
  local f = { x0 = cx - w / 2, x1 = cx + w / 2, y0 = y0, y1 = y1, grid = false,
    xrange = { (mx - w / 2 / unit) / s, (mx + w / 2 / unit) / s },
    yrange = { (my - h / 2 / unit) / s, (my + h / 2 / unit) / s },
    xlabel = frame.label(p.x[1], p.x[2], text), ylabel = frame.label(p.y[1], p.y[2], text) }
  local scale = svg.frame(d, f)
  return scale, s, unit * s
end

return frame
