#!/usr/bin/env lua5.4
-- chart.t - polhode chart --from: what is drawn of a sweep's rows, and what is refused.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The tables are written here, so that it is known how many cells of which colour there must be.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function chart(options)
  return program.output(string.format("POLHODE_SOURCE=. %s chart %s", binary, options))
end

-- 4 x 3 members: z = 0 in the left half, 1 in the right, none in one corner; b in equal ratios.
local lines = { "member,a,b,z,status" }
for i = 0, 3 do
  for j = 0, 2 do
    local z = i < 2 and "0" or "1"
    if i == 3 and j == 2 then z = "nan" end
    lines[#lines + 1] = string.format("%d,%d,%g,%s,\"no body: a, b\"", #lines - 1, i, 10.0 ^ j, z)
  end
end
program.write(dir .. "/rows.csv", table.concat(lines, "\n") .. "\n")
local file = "--from " .. dir .. "/rows.csv "

-- The area of all subpaths of one class.
local function area(svg, class)
  local sum = 0
  for d in svg:gmatch('<path class="' .. class .. '" d="([^"]*)"') do
    for part in d:gmatch "M([^Z]*)Z" do
      local x0, y0, _, _, x1, y1 = part:match "([%d.]+),([%d.]+) ([%d.]+),([%d.]+) ([%d.]+),([%d.]+)"
      sum = sum + math.abs((tonumber(x1) - tonumber(x0)) * (tonumber(y1) - tonumber(y0)))
    end
  end
  return sum
end

local code, svg, err = chart(file .. "--x a --y b --z z")
if not tap.is(code, 0, "a map of three columns") then tap.diag(err) end
do
  local cell = 450 * 400 / 12 -- the frame's pixels; the axis b is logarithmic, so that all cells are alike
  local function cells(class) return math.floor(area(svg, class) / cell * 100 + 0.5) / 100 end
  tap.ok(cells "s0" == 6 and cells "s63" == 5 and cells "none" == 1, "each value has its colour on as many cells")
  tap.ok(svg:find(">a<", 1, true) and svg:find(">b<", 1, true) and svg:find(">z<", 1, true), "with the columns' names")
end
code, svg = chart(file .. "--x z")
tap.ok(code == 0 and svg:find("11 members, 1 without a number", 1, true) ~= nil, "a histogram of one counts members")
code, svg = chart(file .. "--x a --y z")
tap.is(code == 0 and select(2, svg:gsub("<circle", "")), 11, "a point for each member with numbers, of two")

for _, case in ipairs { { "--x q", "has no column q" }, { "", "--x is missing" }, { "--x a --z z", "--y is missing" },
  { "--x a --over a=1:2,b=1:2", "--over: it belongs to a scene" }, { "brick --x a", "too many operands" } } do
  code, svg, err = chart(file .. case[1])
  tap.ok(code == 2 and svg == "" and err:find(case[2], 1, true) ~= nil, "said: " .. case[2])
end
for _, case in ipairs { { "--from x.h5 --x a", "must be a CSV file" }, { "--from none.csv --x a", "none.csv" },
  { "brick --x a", "--x: it names a column" }, { "", "SCENE is missing" } } do
  code, svg, err = chart(case[1])
  tap.ok(code == 2 and svg == "" and err:find(case[2], 1, true) ~= nil, "said: " .. case[2])
end
if program.shell "command -v rsvg-convert > /dev/null 2>&1" == 0 then
  code = chart(file .. "--x a --y b --z z -o " .. dir .. "/map.png")
  tap.ok(code == 0 and (program.read(dir .. "/map.png") or ""):sub(2, 4) == "PNG", "-o FILE.png is a picture")
else
  tap.skip("-o FILE.png is a picture", "there is no rsvg-convert (Debian package librsvg2-bin)")
end

program.finish()
tap.done()
