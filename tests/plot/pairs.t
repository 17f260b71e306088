#!/usr/bin/env lua5.4
-- pairs.t - polhode plot of two runs, of columns and expressions, with ranges: curves read back against run.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.output(string.format("timeout 120 %s %s", binary, arguments))
end

local paper = "tenths of a pixel in both coordinates, 0.12 of the curve, 0.05 of a tick's place"

local function number(text)
  local power = text:match '^10<tspan[^>]*>(.-)</tspan>$'
  local plain = (power or text):gsub("−", "-")
  return power and 10.0 ^ tonumber(plain) or tonumber(plain)
end

-- The first frame of a picture: x0, y0, x1, y1, and functions from pixels to its units, with how much a pixel is.
local function frame_of(text, log)
  local x0, y0, w, h = text:match '<rect class="frame" x="([%d.]+)" y="([%d.]+)" width="([%d.]+)" height="([%d.]+)"'
  local f = { x0 = tonumber(x0), y0 = tonumber(y0) }
  f.x1, f.y1 = f.x0 + tonumber(w), f.y0 + tonumber(h)
  local function scale(pattern, shift, of)
    local ticks = {}
    for x, y, value in text:gmatch('<text class="tick" x="([%d.]+)" y="([%d.]+)" text%-anchor="' .. pattern ..
      '">(.-)</text>') do
      local inside = tonumber(y) < f.y1 + 20 and tonumber(x) < f.x1 + 20
      if inside then ticks[#ticks + 1] = { tonumber(pattern == "end" and y or x) - shift, of(number(value)) } end
    end
    local a, b = ticks[1], ticks[#ticks]
    local size = (b[2] - a[2]) / (b[1] - a[1])
    return function(pixel) return a[2] + (pixel - a[1]) * size end, math.abs(size)
  end
  local function same(x) return x end
  f.x, f.dx = scale("middle", 0, same)
  f.y, f.dy = scale("end", 4, log and function(v) return math.log(v, 10) end or same)
  return f
end

-- The curves of a class in the picture's first frame: their points in its units.
local function curve(text, class, log)
  local f, list = frame_of(text, log), {}
  local data = text:match('<path class="line ' .. class .. '" d="([^"]*)"')
  for piece in (data or ""):gmatch "M[^M]*" do
    local px, py, n = 0, 0, {}
    for digits in piece:gmatch "%-?%d*%.?%d+" do n[#n + 1] = tonumber(digits) end
    for i = 1, #n, 2 do
      px, py = px + n[i], py + n[i + 1]
      list[#list + 1] = { f.x(px), f.y(py), px, py }
    end
  end
  return list, f
end

-- The last row of run's table.
local function last_row(arguments)
  local _, out = run("run " .. arguments)
  local cells = {}
  for cell in out:match "([^\n]*)\n$":gmatch "[^,]+" do cells[#cells + 1] = tonumber(cell) end
  return cells
end

-- ---- the error of a method against the exact motion ----

do
  local ends = {}
  for i, step in ipairs { 0.01, 0.005 } do
    local status, text, err = run("plot bodies/brick.lua --what error --method rk4,exact --step " .. step)
    tap.ok(status == 0 and err == "", "rk4 with h = " .. step .. " against the exact motion", err)
    tap.ok(text:find("Difference of rk4 (h = " .. step .. " s) and exact", 1, true), "h is in the picture")
    local points, f = curve(text, "cx", true)
    local low, high, early = -math.huge, math.huge, 0
    for _, p in ipairs(points) do
      low, high = math.max(low, p[4]), math.min(high, p[4])
      if p[1] > 1 then early = math.max(early, p[4]) end -- of 10 s
    end
    local middle = (f.y0 + f.y1) / 2
    tap.ok(#points > 50 and high < middle and early > middle, "what it is after a tenth of the time takes the height")
    ends[i] = points[#points][2]
  end
  tap.near(ends[1] - ends[2], 4 * math.log(2, 10), 0.03, 0.03, "half the step: a sixteenth of the error, read off",
    "the order of rk4 is 4; the error has terms of h^5, and a pixel is a hundredth of a decade")
end

-- ---- columns, groups and expressions ----

do
  local status, text, err = run "plot bodies/brick.lua --what 'rim = a*wx' --until 1.5"
  local points, f = curve(text, "cx")
  tap.ok(status == 0 and err == "" and text:find(">rim</tspan>", 1, true) == nil and text:find("rim = a*wx", 1, true),
    "an expression has a panel", err)
  tap.ok(text:find(">rim / (m/s)<", 1, true), "with its name and unit at the axis")
  tap.near(points[#points][2], last_row("bodies/brick.lua --at 1.5 --columns 'rim = a*wx'")[1], 0, 0.4 * f.dy,
    "its values are those of run", paper)
  status, text, err = run "plot bodies/brick.lua --what '{wx, tilt},L_body' --until 1.5"
  tap.ok(status == 0 and err == "" and select(2, text:gsub('class="frame"', "")) == 2, "{A, B} is one panel", err)
  points, f = curve(text, "cy")
  tap.near(points[#points][2], last_row("bodies/brick.lua --at 1.5 --columns tilt")[1], 0, 0.4 * f.dy,
    "with the second curve in it", paper)
  tap.ok(text:find("Angular momentum, body axes", 1, true), "L along the body's axes has a picture of its own")
  text = select(2, run "plot bodies/brick.lua --what L_body --until 1.5")
  local want = last_row "bodies/brick.lua --at 1.5 --columns L_body"
  for i, class in ipairs { "cx", "cy", "cz" } do
    points, f = curve(text, class)
    tap.near(points[#points][2], want[i], 0, 0.4 * f.dy, "component " .. i .. " is L_body of run", paper)
  end
  status, text, err = run "plot bodies/brick.lua --what matrix --until 1.5"
  tap.ok(status == 0 and select(2, text:gsub('class="frame"', "")) == 3, "nine columns are three panels", err)
end

-- ---- two runs ----

do
  local status, text, err = run "plot bodies/brick.lua --what wx --method rk4 --step 0.2,0.1 --until 4"
  tap.ok(status == 0 and err == "", "h and h/2", err)
  tap.ok(text:find(">h = 0.2 s<", 1, true) and text:find(">h = 0.1 s<", 1, true), "a legend tells which is which")
  for class, step in pairs { cx = 0.2, ["cx dashed"] = 0.1 } do
    local points, f = curve(text, class)
    tap.near(points[#points][2], last_row("bodies/brick.lua --method rk4 --step " .. step .. " --at 4 --columns wx")[1],
      0, 0.4 * f.dy, "the curve of h = " .. step .. " ends where run does", paper)
  end
  status, text, err = run "plot bodies/book.lua --set thickness=25,60 --what polhode,{wx} --until 2"
  tap.ok(status == 0 and err == "" and select(2, text:gsub("Polhode on the ellipsoid", "")) == 2,
    "two values of a parameter: a figure for each", err)
  tap.ok(text:find(">thickness = 25 mm; moments", 1, true) and text:find(">thickness = 60 mm; moments", 1, true) and
    not text:find("mm, thickness", 1, true), "each says its value, and the sheet none of them")
  local points, f = curve(text, "cx dashed")
  tap.near(points[#points][2], last_row("bodies/book.lua --set thickness=60 --at 2 --columns wx")[1], 0, 0.4 * f.dy,
    "and in one frame the curve of the other", paper)
  status, text, err = run "plot bodies/brick.lua --what rates --method exact,linearised --until 0.5"
  tap.ok(status == 0 and err == "" and text:find(">exact<", 1, true) and text:find(">linearised<", 1, true) and
    select(2, text:gsub("dashed", "")) >= 6, "linearised against exact", err)
end

-- ---- ranges ----

do
  local status, text, err = run "plot bodies/brick.lua --what wx --range t=1:2 --range wx=0:2"
  local points, f = curve(text, "cx")
  local out = 0
  for _, p in ipairs(points) do
    local beyond = p[3] < f.x0 - 0.1 or p[3] > f.x1 + 0.1 or p[4] < f.y0 - 0.1 or p[4] > f.y1 + 0.1
    out = out + (beyond and 1 or 0)
  end
  tap.ok(status == 0 and err == "" and #points > 10 and out == 0, "what leaves the ranges is cut off", err)
  tap.near(f.x(f.x0), 1, 0, f.dx, "the time begins where it was asked to", paper)
  tap.near(f.x(f.x1), 2, 0, f.dx, "and ends there", paper)
  tap.near(f.y(f.y1), 0, 0, f.dy, "the values begin where they were asked to", paper)
  tap.near(f.y(f.y0), 2, 0, f.dy, "and end there", paper)
end

-- ---- a table ----

do
  local csv = program.directory() .. "/brick.csv"
  run("run bodies/brick.lua --until 2 --columns 't,rim = a*wx' -o " .. csv)
  local status, text, err = run("plot --from " .. csv .. " --what rim")
  local points, f = curve(text, "cx")
  tap.ok(status == 0 and err == "", "a column of a table", err)
  tap.near(points[#points][2], last_row("bodies/brick.lua --at 2 --columns 'rim = a*wx'")[1], 0, 0.4 * f.dy,
    "has its numbers", paper)
  status, text, err = run("plot --from " .. csv .. " --what rum")
  tap.ok(status == 2 and text == "" and err:find("the file has no column rum; did you mean rim?", 1, true),
    "one that is not there is told", err)
end

program.finish()
tap.done()
