-- errormap_report.lua -- the error map as a table and a picture.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/bench/errormap_report.lua DIRECTORY PICTURE.svg
--
-- DIRECTORY/double and DIRECTORY/float hold `places` and `errors`, line by line of one sweep (tests/bench/errormap.c,
-- tests/oracle/free_top.c). An error is the larger of that of the rates, relative to the largest rate, and the angle
-- between the attitudes, 2 |q - q'|. The table has its largest value over all bodies, in units of the last place of the
-- type (2^-53, 2^-24); the picture its largest value over all motions and times.

local from, picture = arg[1], arg[2]
local depth = { "1", "0.9", "0.5", "0.1", "1e-3", "1e-6", "1e-10", "1e-14" }
local times = { "1", "1e2", "1e4", "1e6" }
local unit = { double = 2 ^ -53, float = 2 ^ -24 }
local GRID, CELL = 7, 34

local function worse(map, key, e)
  if not (map[key] and map[key] >= e) then map[key] = e end
end

local function read(real)
  local by_motion, by_body, count = {}, {}, 0
  local places = io.lines(from .. "/" .. real .. "/places")
  local worst = { rates = 0, attitude = 0 }
  for line in io.lines(from .. "/" .. real .. "/errors") do
    local column, row, side, d, k = string.match(places(), "(%d+) (%d+) (%d+) (%d+) (%d+)")
    local rates, attitude = string.match(line, "(%S+) (%S+)")
    rates, attitude = tonumber(rates) or math.huge, 2 * (tonumber(attitude) or math.huge) -- "nan" is no number
    local e = math.max(rates, attitude) / unit[real]
    worse(worst, "rates", rates)
    worse(worst, "attitude", attitude)
    worse(by_motion, side .. d .. k, e)
    worse(by_body, column .. "," .. row, e)
    count = count + 1
  end
  return { motion = by_motion, body = by_body, count = count, worst = worst }
end

local maps = { double = read "double", float = read "float" }
for _, real in ipairs { "double", "float" } do
  local map = maps[real]
  print(string.format("\n%s: %d states; largest error of the rates %.2g, of the attitude %.2g rad\n", real, map.count,
    map.worst.rates, map.worst.attitude))
  print("| circulation about | distance from the separatrix | " .. table.concat(times, " | ") .. " periods |")
  print("|---|---|" .. string.rep("---|", #times))
  for side, axis in ipairs { "the smallest moment", "the largest" } do
    for d, name in ipairs(depth) do
      local cells = {}
      for k = 1, #times do
        local e = map.motion[(side - 1) .. (d - 1) .. (k - 1)]
        cells[k] = e and string.format("%.1f", e) or "-"
      end
      print("| " .. axis .. " | " .. name .. " | " .. table.concat(cells, " | ") .. " |")
    end
  end
end

-- White at 0, dark at 16 units of the last place.
local function shade(e)
  local v = 255 - math.floor(200 * math.min(1, e / 16) + 0.5)
  return string.format("#%02x%02xff", v, v)
end

local function label(e)
  return e and (e < 100 and string.format("%.1f", e) or (string.gsub(string.format("%.0e", e), "e%+0*", "e"))) or ""
end

local out = { string.format('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" ' ..
  'font-family="sans-serif" font-size="11">', 2 * (GRID * CELL + 60), GRID * CELL + 70) }
for i, real in ipairs { "double", "float" } do
  local x0, y0 = (i - 1) * (GRID * CELL + 60) + 40, 24
  out[#out + 1] = string.format('<text x="%d" y="16">%s: largest error, units of the last place</text>', x0, real)
  for row = 0, GRID - 1 do
    for column = 0, GRID - 1 do
      local e = maps[real].body[column .. "," .. row]
      local x, y = x0 + column * CELL, y0 + (GRID - 1 - row) * CELL
      out[#out + 1] = string.format('<rect x="%d" y="%d" width="%d" height="%d" fill="%s" stroke="#888"/>', x, y,
        CELL, CELL, e and shade(e) or "#ddd")
      out[#out + 1] = string.format('<text x="%d" y="%d" text-anchor="middle">%s</text>', x + CELL // 2,
        y + CELL // 2 + 4, label(e))
    end
  end
  out[#out + 1] = string.format('<text x="%d" y="%d">A from C - B (lamina) to B (symmetric)</text>', x0,
    y0 + GRID * CELL + 16)
  out[#out + 1] = string.format('<text x="%d" y="%d" transform="rotate(-90 %d %d)">B/C from 1/2 to 1</text>', x0 - 8,
    y0 + GRID * CELL, x0 - 8, y0 + GRID * CELL)
end
out[#out + 1] = "</svg>"
local file = assert(io.open(picture, "w"))
file:write(table.concat(out, "\n"), "\n")
file:close()
