-- frame.lua -- panels with two axes: their ranges, names with units, curves with their names at the end.
--
-- A label is quantity over unit, "w / (rad/s)" (SI Brochure 5.4); very small or large values are divided by a power of
-- ten, which then is part of the unit.
-- SPDX-License-Identifier: GPL-3.0-or-later

local curve = require "generator.plot.curve"
local svg = require "generator.draw.svg"

local frame = {}

local right, bottom, left = 36, 38, 58 -- room for names of curves, ticks and labels
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

-- p: {box =, x = {name, unit}, y = {name, unit}, xs = numbers, curves = {{name =, class =, values =, breaks = set of
-- indices where the pen is lifted}, ...}, log = a logarithmic y axis, yrange =, mark = {x, words} of an upright line,
-- the words at its left}
function frame.over(d, p)
  local box, lists, room = p.box, {}, right
  for i, c in ipairs(p.curves) do
    lists[i] = c.values
    room = math.max(room, 14 + advance * utf8.len(c.name))
  end
  local xr = { p.xs[1], p.xs[#p.xs] }
  local yr = p.yrange or frame.range(lists, p.zero)
  local xs, xp = frame.power(xr)
  local ys, yp = 1.0, ""
  if not p.log then ys, yp = frame.power(yr) end
  local f = { x0 = box.x0 + left, y0 = box.y0, x1 = box.x1 - room, y1 = box.y1 - bottom,
    xrange = { xr[1] / xs, xr[2] / xs }, yrange = { yr[1] / ys, yr[2] / ys }, ylog = p.log,
    xlabel = frame.label(p.x[1], p.x[2], xp), ylabel = frame.label(p.y[1], p.y[2], yp) }
  local scale = svg.frame(d, f)
  if p.mark then
    local x = scale.x(p.mark[1] / xs)
    d:line(x, f.y0, x, f.y1, "ring")
    d:text(x - 5, f.y0 + 14, p.mark[2], "small", "end")
  end
  local names = {}
  for place, c in ipairs(p.curves) do
    local data, points = {}, {}
    local function lift()
      if #points > 0 then data[#data + 1] = curve.path(points) end
      points = {}
    end
    for i, v in ipairs(c.values) do
      if c.breaks and c.breaks[i] then lift() end
      points[#points + 1] = { scale.x(p.xs[i] / xs), scale.y(v / ys) }
    end
    lift()
    if #data > 0 then d:path(table.concat(data), "line " .. c.class) end
    names[place] = { y = scale.y(c.values[#c.values] / ys), c = c, place = place }
  end
  spread(names, f.y0 + 4, f.y1 - 2)
  for _, n in ipairs(#p.curves > 1 and names or {}) do
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
