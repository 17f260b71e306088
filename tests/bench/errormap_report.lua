-- errormap_report.lua -- the error map as a page and a picture.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/bench/errormap_report.lua DIRECTORY PAGE.md PICTURE.svg
--
-- DIRECTORY/double and DIRECTORY/float hold `places`, `lines` and `errors`, line by line of one sweep
-- (tests/bench/errormap.c, tests/oracle/free_top.c).  Errors are counted in units u of the type's rounding, 2^-53 and
-- 2^-24: of the rates relative to the largest rate, of the attitude the angle 2 |q - q'|.  Beyond 0.1 it is "lost".

package.path = "./?.lua;" .. package.path

local svg = require "generator.draw.svg"

local from, page, picture = arg[1], arg[2], arg[3]
local depths = { "1", "0.9", "0.5", "0.1", "1e-3", "1e-6", "1e-10", "1e-14" }
local times = { "1", "100", "10⁴", "10⁶" }
local unit = { double = 2 ^ -53, float = 2 ^ -24 }
local reals, ways = { "double", "float" }, { "NAME_at", "NAME_at_tick" }
local GRID, LOST = 9, 0.1

-- The larger error; what is no number has been read as infinite.
local function worse(map, key, e)
  if not (map[key] and map[key] >= e) then map[key] = e end
end

local function number(word) return tonumber(word) or math.huge end

local function words(line)
  local list = {}
  for word in string.gmatch(line, "%S+") do list[#list + 1] = word end
  return list
end

-- All samples of a type, in their order: body (column, row), motion (side, depth), time k, way, the four errors in
-- units, and turns about L, estimated by the largest rate.
local function read(real)
  local list, u = {}, unit[real]
  local places, states = io.lines(from .. "/" .. real .. "/places"), io.lines(from .. "/" .. real .. "/lines")
  for line in io.lines(from .. "/" .. real .. "/errors") do
    local p, e, s = words(places()), words(line), words(states())
    local w = 0
    for i = 7, 9 do w = math.max(w, math.abs(tonumber(s[i]))) end
    list[#list + 1] = { column = tonumber(p[1]), row = tonumber(p[2]), side = tonumber(p[3]), depth = tonumber(p[4]),
      time = tonumber(p[5]), way = tonumber(p[6]) + 1, rates = number(e[1]) / u, attitude = 2 * number(e[2]) / u,
      each_rate = number(e[3]) / u, each_q = number(e[4]) / u, turns = w * tonumber(s[14]) / (2 * math.pi),
      moments = { tonumber(s[1]), tonumber(s[2]) } }
  end
  return list
end

local samples = {}
for _, real in ipairs(reals) do samples[real] = read(real) end

local function lost(e, real) return e * unit[real] > LOST end

-- Two digits, or a power of ten; "lost".
local function label(e, real)
  if not e then return "" end
  if lost(e, real) then return "lost" end
  if e < 99.5 then return string.format(e < 9.95 and "%.1f" or "%.0f", e) end
  return (string.gsub(string.format("%.0e", e), "e%+0*", "e"))
end

-- ---- the page ----

local out = {}
local function put(format, ...) out[#out + 1] = select("#", ...) > 0 and string.format(format, ...) or format end

-- Median, the largest of 99 of 100, largest: of one error of the samples that `take` takes, and their number.
local function spread(real, what, take)
  local list = {}
  for _, s in ipairs(samples[real]) do
    if take(s) then list[#list + 1] = s[what] end
  end
  table.sort(list)
  local n = #list
  return list[(n + 1) // 2], list[math.ceil(0.99 * n)], list[n], n
end

local function summary()
  put "| type | by | samples | rates | attitude | each rate | each of q |"
  put "|---|---|---|---|---|---|---|"
  for _, real in ipairs(reals) do
    for way, name in ipairs(ways) do
      local cells, n = {}, 0
      for i, what in ipairs { "rates", "attitude", "each_rate", "each_q" } do
        local middle, most, all, count = spread(real, what, function(s) return s.way == way end)
        cells[i], n = label(middle, real) .. ", " .. label(most, real) .. ", " .. label(all, real), count
      end
      put("| %s | `%s` | %d | %s |", real, name, n, table.concat(cells, " | "))
    end
  end
end

local function by_time()
  put("| type | by | error of | %s periods |", table.concat(times, " | "))
  put("|---|---|---|%s", string.rep("---|", #times))
  for _, real in ipairs(reals) do
    for way, name in ipairs(ways) do
      for _, what in ipairs { "rates", "attitude" } do
        local cells = {}
        for k = 1, #times do
          local _, _, all = spread(real, what, function(s) return s.way == way and s.time == k - 1 end)
          cells[k] = label(all, real)
        end
        put("| %s | `%s` | %s | %s |", real, name, what, table.concat(cells, " | "))
      end
    end
  end
end

-- By how many turns about L a sample has made: decades of 10^2.
local function by_turns()
  local steps = { 1e2, 1e4, 1e6, 1e8, 1e10, math.huge }
  put "| type | by | error of | below 10² turns | 10⁴ | 10⁶ | 10⁸ | 10¹⁰ | more |"
  put "|---|---|---|---|---|---|---|---|---|"
  for _, real in ipairs(reals) do
    for way, name in ipairs(ways) do
      for _, what in ipairs { "rates", "attitude" } do
        local cells, low = {}, 0
        for i, high in ipairs(steps) do
          local from_here = low
          local _, _, all = spread(real, what, function(s)
            return s.way == way and s.turns >= from_here and s.turns < high
          end)
          cells[i], low = label(all, real), high
        end
        put("| %s | `%s` | %s | %s |", real, name, what, table.concat(cells, " | "))
      end
    end
  end
end

-- The first samples in an order, with where they are.
local function places(real, count, take, before)
  local list = {}
  for i, s in ipairs(samples[real]) do
    local e = math.max(s.rates, s.attitude)
    if take(e) then list[#list + 1] = { s = s, e = e, i = i } end
  end
  table.sort(list, function(a, b)
    if before(a) ~= before(b) then return before(a) < before(b) end
    return a.i < b.i
  end)
  put "| error | by | A, B (C = 1) | L about the axis of | distance from the separatrix | periods | turns |"
  put "|---|---|---|---|---|---|---|"
  for i = 1, math.min(count, #list) do
    local s = list[i].s
    put("| %s u | `%s` | %.7g, %.7g | %s moment | %s | %s | %.1g |", label(list[i].e, real), ways[s.way], s.moments[1],
      s.moments[2], s.side == 0 and "the smallest" or "the largest", depths[s.depth + 1], times[s.time + 1], s.turns)
  end
  return #list
end

local function prose(text)
  for line in string.gmatch(text, "([^\n]*)\n") do put("%s", line) end
end

prose [[
# How exact the closed form of the free top is

`make errormap` writes this page in some minutes, with the same bytes each time. It compiles the generated code in
double and in float, and runs it for many bodies, motions and times. It compares every state with the textbook's
formulas in 512 bits of MPFR (`tests/oracle/free_top.c`). These reproduce the 32 digits of the reference set.

- **Bodies** have the moments A ≤ B ≤ C = 1. B goes from 1/2 to 1 in nine steps, and A from C − B (a lamina) to B (two
  equal moments) in nine. The ends are approached to 10⁻⁶, so the corners are nearly a rod, a sphere and a disc.
- **Motions** have G² between 2T A and 2T C. L circulates about the axis of the smallest or of the largest moment, at
  0.999999, 0.9, ... 10⁻¹⁴ of the way from the separatrix to that axis. In float, rounding limits the last of these.
  Phases are multiples of the golden angle.
- **Times**: 1, 100, 10⁴, 10⁶ periods of the rates, by `NAME_at` and by `NAME_at_tick`. Near a symmetric body or the
  axis a period of the rates may be 10⁶ turns of the body, so 10⁶ periods are up to 10¹² turns about L.
- **Inputs are exact**: moments, state and time are numbers of the type, and the oracle gets the same numbers.

Errors are in units **u** of the type's rounding: 2⁻⁵³ = 1.1e-16 in double, 2⁻²⁴ = 6.0e-8 in float. *Rates* is the
largest error of a rate relative to the largest rate. *Attitude* is the angle between the two attitudes in rad. *Each
rate* and *each of q* are relative to the component itself, however small it is. "lost" means an error above 0.1.

![largest errors over bodies, motions and times](errormap.svg)

## Over everything

Each cell has three numbers. Half of the samples have a smaller error than the first, 99 of 100 than the second. The
third is the largest error.

]]
summary()
prose [[

The requirement is 4e-15 in double, 36 u, and 4e-6 in float, 67 u. Errors relative to a component have no bound,
because a component that passes through 0 has an error as large as the others have.

## With time

]]
by_time()
prose [[

The same errors by the number of turns about L:

]]
by_turns()
prose [[

## Where the largest errors sit

In double the largest errors have no special place. They are the roundings of some dozens of operations, and neither
body, motion nor time changes their number. These are the five largest:

]]
places("double", 5, function() return true end, function(a) return -a.e end)
prose [[

In float the phases are pairs of 48 bits, so their error reaches a unit of the last place after some 2²⁰ turns. These
are the samples beyond 67 u with the fewest turns:

]]
local over = places("float", 5, function(e) return e > 4e-6 / unit.float end, function(a) return a.s.turns end)
put("")
put("(%d of %d are beyond.)", over, #samples.float)
prose [[

- The **rates** need only the phase of the polhode. In 10⁶ periods it makes 2·10⁶ half-turns, which a pair can hold.
- The **attitude** needs the turns about L. A period of the rates may be 10⁴ turns and more (A = B, B = C to 10⁻⁶, a
  spin near an axis). Then 10⁶ periods are 10¹⁰ turns. The set-up rounds a rate at 2⁻⁴⁸, and this error grows to 10⁻⁴
  of a turn.
- **Ticks** are integers. They add no error, and reach times that a float cannot hold. A float t has 24 bits, so after
  10⁷ steps it is wrong by half a step. This map leaves that error out, because the oracle gets the same float. Ticks
  do not make the rates of the set-up more accurate, which are pairs of floats. For 10⁸ turns and more in float, do
  the set-up in double.
]]

local file = assert(io.open(page, "w"))
file:write(table.concat(out, "\n"), "\n")
file:close()

-- ---- the picture ----

-- Fill and text of a cell by its error: up to 8, 16, 32, 128, 10^4, more, lost.
local levels = { { 8, "#edf4fb", "#222" }, { 16, "#d3e4f3", "#222" }, { 32, "#a6c9e6", "#222" },
  { 128, "#6fa8d6", "#111" }, { 1e4, "#3a7ebd", "#fff" }, { math.huge, "#1c4f8c", "#fff" } }
local palette = { { "gone", "fill:#7a2a16;stroke:#fff;stroke-width:1", "stroke:#15181d" }, { "on-gone", "fill:#fff" },
  { "none", "fill:none;stroke:#bbb;stroke-width:1" }, { "cell", "font:10px sans-serif" } }
for i, l in ipairs(levels) do
  palette[#palette + 1] = { "e" .. i, "fill:" .. l[2] .. ";stroke:#fff;stroke-width:1", "stroke:#15181d" }
  palette[#palette + 1] = { "on-e" .. i, "fill:" .. l[3] }
end

local CELL_W, CELL_H, LEFT, WIDE = 34, 20, 64, 9 * 34
local width = 2 * (LEFT + WIDE) + 24
local doc = svg.new(width, 930, { title = "Errors of the emitted free top", palette = palette,
  about = "Largest error of attitude and rates by body and by motion and time, double and float, in roundings." })

local function cell(x, y, e, real)
  local class = "none"
  if e and lost(e, real) then class = "gone" end
  for i = #levels, 1, -1 do
    if e and class ~= "gone" and e <= levels[i][1] then class = "e" .. i end
  end
  -- the smallest level that holds e: the loop runs downwards and overwrites
  doc:rect(x, y, CELL_W, CELL_H, class)
  if e then doc:text(x + CELL_W / 2, y + 14, label(e, real), "cell on-" .. class, "middle") end
end

-- The largest of both errors of the samples, by key(s).
local function map(real, key)
  local m = {}
  for _, s in ipairs(samples[real]) do worse(m, key(s), math.max(s.rates, s.attitude)) end
  return m
end

for r, real in ipairs(reals) do
  local x0, y0 = (r - 1) * (LEFT + WIDE + 12) + LEFT, 60
  doc:text(x0, 24, real .. (r == 1 and ", u = 2⁻⁵³" or ", u = 2⁻²⁴"), "title")
  for way, name in ipairs(ways) do
    local m = map(real, function(s) return s.way .. "," .. s.column .. "," .. s.row end)
    doc:text(x0, y0 - 12, "by " .. name .. ": bodies, worst of motions and times", "small")
    for row = 0, GRID - 1 do
      for column = 0, GRID - 1 do
        cell(x0 + column * CELL_W, y0 + (GRID - 1 - row) * CELL_H, m[way .. "," .. column .. "," .. row], real)
      end
    end
    local bottom = y0 + GRID * CELL_H
    doc:text(x0 - 6, bottom - 6, "B = C/2", "tick", "end")
    doc:text(x0 - 6, y0 + 14, "B = C", "tick", "end")
    doc:text(x0, bottom + 14, "A = C − B, lamina", "tick")
    doc:text(x0 + WIDE, bottom + 14, "A = B", "tick", "end")
    y0 = bottom + 58
  end
  y0 = y0 + 14
  local m = map(real, function(s) return s.way .. "," .. s.side .. "," .. s.depth .. "," .. s.time end)
  doc:text(x0, y0 - 24, "motions, worst of bodies: distance from the separatrix", "small")
  for way, name in ipairs(ways) do
    local left = x0 + (way - 1) * (4 * CELL_W + CELL_W / 2)
    doc:text(left, y0 - 6, name .. ", periods:", "tick")
    for k = 0, 3 do doc:text(left + (k + 0.5) * CELL_W, y0 + 10, times[k + 1], "tick", "middle") end
    local y = y0 + 16
    for line = 0, 15 do
      local side, depth = line // 8, line < 8 and line or 15 - line
      cell(left, y, m[way .. "," .. side .. "," .. depth .. ",0"], real)
      for k = 1, 3 do
        cell(left + k * CELL_W, y, m[way .. "," .. side .. "," .. depth .. "," .. k], real)
      end
      if way == 1 then doc:text(x0 - 6, y + 14, depths[depth + 1], "tick", "end") end
      y = y + CELL_H
    end
  end
  doc:text(x0, y0 + 16 * CELL_H + 34, "upper half: L about the axis of the smallest moment", "tick")
end

file = assert(io.open(picture, "w"))
file:write(svg.text(doc))
file:close()
