-- map.lua -- the map of the hard cases: a row a case, a column a way of computing it, a colour for its error.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local text = map.svg(files)      files: the catalogue's, cases with .result and .verdict (judge.lua)
--
-- Each cell has double on the left and float on the right.  The last column is the naive formula, in double.

local svg = require "generator.draw.svg"

local map = {}

local columns = { "model", "at", "at_tick", "rk4", "adaptive", "taylor", "split2", "split4", "split6", "midpoint",
  "semi", "library", "naive" }
local place = {}
for i, name in ipairs(columns) do place[name] = i end
map.columns = columns

-- Error over bound, up to which a colour goes; the last is for what is lost or no number.
local scale = { { 0.01, "s1", "below 0.01" }, { 0.1, "s2", "0.01 to 0.1" }, { 1, "s3", "0.1 to 1 (the bound)" },
  { 1e3, "s4", "to 1000 bounds" }, { 1e8, "s5", "to 10⁸" }, { math.huge, "s6", "more, or no number" } }
local palette = {
  { "s1", "fill:#bfe3c4", "fill:#20502c" }, { "s2", "fill:#8fcb98", "fill:#2f7340" },
  { "s3", "fill:#56a564", "fill:#48a05c" }, { "s4", "fill:#f6c768", "fill:#8c6a1c" },
  { "s5", "fill:#e98a43", "fill:#a8571d" }, { "s6", "fill:#c23b3b", "fill:#c24848" },
  { "name", "font:9px sans-serif;fill:#222", "fill:#dde1e7" },
  { "head", "font:bold 10px sans-serif;fill:#222", "fill:#e6e9ee" },
}

local ROW, CELL, LEFT, TOP = 11, 34, 262, 92

local function class(ratio)
  for _, s in ipairs(scale) do
    if ratio <= s[1] and ratio < math.huge or s[1] == math.huge then return s[2] end
  end
end

-- Where a row of somebody belongs, "rk4" or "rk4, energy": his own column, else the model's.
local function column(row)
  return row.real == "long double" and place.library or place[string.match(row.who, "^[%w_]+")] or place.model
end

-- {column -> {double = ratio, float = ratio, all = ratio}} of a case, the worst of each.
local function cells(case)
  local list = {}
  local function put(k, real, ratio)
    local c = list[k] or {}
    list[k] = c
    c[real] = math.max(c[real] or 0, ratio)
  end
  for _, row in ipairs(case.result.rows) do
    put(column(row), row.real == "long double" and "all" or row.real, row.ratio)
  end
  local unit = case.verdict.worst.double or case.verdict.worst.all
  if unit and case.result.naive then put(place.naive, "all", case.result.naive / unit.bound) end
  return list
end

function map.svg(files)
  local rows = 0
  for _, file in ipairs(files) do rows = rows + #file.cases + 1.6 end
  local width, height = LEFT + #columns * CELL + 20, TOP + rows * ROW + 20
  local d = svg.new(width, height, { title = "Hard cases: error over bound", palette = palette,
    about = "A row a case, a column a way of computing it; green: within the bound; amber to red: beyond it." })
  d:text(12, 20, "Hard cases: worst error in units of its bound", "title")
  local x = 12
  for _, s in ipairs(scale) do
    d:rect(x, 30, 14, 10, s[2])
    d:text(x + 18, 39, s[3], "small")
    x = x + 26 + 6.2 * utf8.len(s[3])
  end
  for i, name in ipairs(columns) do d:text(LEFT + (i - 0.35) * CELL, TOP - 6, name, "head", "start", -38) end
  local y = TOP
  for _, file in ipairs(files) do
    y = y + 1.6 * ROW
    d:text(12, y - 4, file.title, "head")
    for _, case in ipairs(file.cases) do
      d:text(LEFT - 6, y + 8, string.gsub(case.name, "_", " "), "name", "end")
      if case.result and case.verdict.worst.all then
        local list = cells(case)
        for i = 1, #columns do
          local c, left = list[i], LEFT + (i - 1) * CELL
          if c and c.all then d:rect(left + 1, y, CELL - 2, ROW - 1, class(c.all)) end
          if c and c.double then d:rect(left + 1, y, CELL / 2 - 1.5, ROW - 1, class(c.double)) end
          if c and c.float then d:rect(left + CELL / 2 + 0.5, y, CELL / 2 - 1.5, ROW - 1, class(c.float)) end
        end
      end
      y = y + ROW
    end
  end
  return svg.text(d)
end

return map
