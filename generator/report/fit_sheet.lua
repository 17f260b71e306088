-- fit_sheet.lua -- a sheet of a fit as SVG: data and model, residuals, confidence ellipses.
--
--     sheet.text(told) -> SVG; told: from report/fit.lua
-- Each residual has two panels: what was measured (dots) with the model (line), and below z = (measured - model)/sigma
-- with a band of 2 sigma.  An attitude has only the second, as it is a turn.  Of a long log every k-th row is drawn.
-- An ellipse has the true pair inside with a probability of 95 %, d' C^-1 d = 5.991; both axes are in standard errors.
-- SPDX-License-Identifier: GPL-3.0-or-later

local svg = require "generator.draw.svg"

local sheet = {}

local WIDE, LEFT, RIGHT, DATA, RESIDUAL, GAP = 760, 70, 20, 130, 70, 62
local MOST_PANELS, MOST_NAMES, CELL = 12, 6, 104
local ROOT = math.sqrt(5.991464547107979) -- the 95 % point of chi-square with two degrees of freedom, -2 log 0.05

local function range_of(lists)
  local low, high = math.huge, -math.huge
  for _, list in ipairs(lists) do
    for _, x in ipairs(list) do low, high = math.min(low, x), math.max(high, x) end
  end
  local edge = high > low and 0.06 * (high - low) or math.max(math.abs(high), 1) * 0.06
  return { low - edge, high + edge }
end

-- The residuals with a trace, in their order: {log, name, trace}.
local function panels_of(told)
  local list, left = {}, 0
  for n, log in ipairs(told.logs) do
    for k, name in ipairs(told.names) do
      local trace = told.result.traces[n][k]
      if #trace.t > 1 then
        if #list < MOST_PANELS then
          list[#list + 1] = { log = log.path, name = name, trace = trace }
        else
          left = left + 1
        end
      end
    end
  end
  return list, left
end

-- The estimates that have a standard error, at most MOST_NAMES: {place, estimate}.
local function named(told)
  local list = {}
  for i, e in ipairs(told.estimates) do
    if e.sigma and #list < MOST_NAMES then list[#list + 1] = { i, e } end
  end
  return list
end

local function measured(d, p, top)
  local t = p.trace
  local f = svg.frame(d, { x0 = LEFT, x1 = WIDE - RIGHT, y0 = top, y1 = top + DATA, xrange = range_of { t.t },
    yrange = range_of { t.y, t.model }, ylabel = p.name })
  local line = {}
  for i, x in ipairs(t.t) do
    d:circle(f.x(x), f.y(t.y[i]), 1.3, "dot-a")
    line[i] = { f.at(x, t.model[i]) }
  end
  d:path(line, "curve b")
end

local function residual(d, p, top)
  local t = p.trace
  local r = range_of { t.z, { -2.5, 2.5 } }
  local f = svg.frame(d, { x0 = LEFT, x1 = WIDE - RIGHT, y0 = top, y1 = top + RESIDUAL, xrange = range_of { t.t },
    yrange = r, ylabel = "z", xlabel = "t in s", grid = false })
  d:rect(LEFT, f.y(2), WIDE - RIGHT - LEFT, f.y(-2) - f.y(2), "area-n")
  d:line(LEFT, f.y(0), WIDE - RIGHT, f.y(0), "axis")
  for i, x in ipairs(t.t) do d:circle(f.x(x), f.y(t.z[i]), 1.1, "dot") end
end

-- u = cos s, v = rho cos s + sqrt(1 - rho^2) sin s is the ellipse of correlation rho.
local function ellipse(rho)
  local points, root = {}, math.sqrt(math.max(0, 1 - rho * rho))
  for i = 0, 72 do
    local s = 2 * math.pi * i / 72
    points[i + 1] = { ROOT * math.cos(s), ROOT * (rho * math.cos(s) + root * math.sin(s)) }
  end
  return points
end

local function ellipses(d, told, list, top)
  for row = 2, #list do
    for column = 1, row - 1 do
      local x0, y0 = LEFT + (column - 1) * CELL, top + (row - 2) * CELL
      local size = CELL - 8
      local points = ellipse(told.correlation[list[row][1]][list[column][1]])
      for i, p in ipairs(points) do points[i] = { x0 + (p[1] + 3) / 6 * size, y0 + (3 - p[2]) / 6 * size } end
      d:rect(x0, y0, size, size, "frame")
      d:polygon(points, "area-a")
      for _, tick in ipairs { { "−2", 1 }, { "0", 3 }, { "2", 5 } } do -- at the sheet's edges alone
        local along = tick[2] / 6 * size
        if column == 1 then d:text(x0 - 6, y0 + size - along + 4, tick[1], "tick", "end") end
        if row == #list then d:text(x0 + along, y0 + size + 14, tick[1], "tick", "middle") end
      end
      d:path(svg.through(points, true), "curve a")
      if column == 1 then d:text(x0 - 34, y0 + CELL / 2, list[row][2].name, "small", "middle", -90) end
      if row == #list then d:text(x0 + CELL / 2, y0 + CELL + 22, list[column][2].name, "small", "middle") end
    end
  end
end

local function text_of(...) return string.format(...) end

local function rough(x) return text_of("%.3g", x) end

-- Chi-square, or what stands for it where no sigma is known.
local function verdict(told)
  if not told.known then return "residuals: standard deviation " .. rough(math.sqrt(told.reduced)) end
  return "chi-square " .. rough(told.reduced) .. " times its expectation, " .. told.dof ..
    " degrees of freedom, more has a probability of " .. rough(told.tail) ..
    (told.status == 0 and "" or "; the fit failed")
end

-- Of a panel's residuals the root mean square and how probable it is that they are white.
local function quality(told, p)
  for _, c in ipairs(told.residuals) do
    if c.log == p.log and c.name == p.name then
      return ", root mean square " .. rough(c.rms) .. (c.white and
        ", white with probability " .. rough(c.white.tail) or "")
    end
  end
  return ""
end

function sheet.text(told)
  local panels, left = panels_of(told)
  local list, height = named(told), 76
  for _, p in ipairs(panels) do height = height + (p.trace.y[1] and DATA + 22 or 0) + RESIDUAL + GAP end
  local square = #list > 1 and (#list - 1) * CELL + 80 or 0
  local d = svg.new(WIDE, height + square, { title = "Fit of " .. told.scene,
    about = "data and model over time, residuals in sigma, and confidence ellipses of the estimates" })
  d:text(LEFT, 24, "Fit of " .. told.scene .. ": dots measured, line model, SI units; z in sigma, band 2 sigma" ..
    (left > 0 and "; " .. left .. " more are not drawn" or ""), "title")
  d:text(LEFT, 40, verdict(told), "small")
  local top = 72
  for _, p in ipairs(panels) do
    d:text(LEFT, top - 8, p.log .. ": " .. p.name .. quality(told, p), "small")
    if p.trace.y[1] then
      measured(d, p, top)
      top = top + DATA + 22
    end
    residual(d, p, top)
    top = top + RESIDUAL + GAP
  end
  if square > 0 then
    d:text(LEFT, top, "95 % regions of pairs, axes in standard errors from the estimate", "label")
    ellipses(d, told, list, top + 14)
  end
  return svg.text(d)
end

return sheet
