-- linearised_chart.lua -- the error of the linearised top against the amplitude: the derived law as lines, the exact
-- solution as points.
--
-- Left, where the spin is stable: the largest error in 1 and in 100 periods; right, where it is not: the time until the
-- error is a tenth of the spin.  The law is mass/linearised's; the points come from a function of the caller, in body
-- axes (the general library's exact solver, which shares no formula with the law).
-- SPDX-License-Identifier: GPL-3.0-or-later

local svg = require "generator.draw.svg"
local law = require "generator.mass.linearised"
local facts = require "generator.report.facts"

local chart = {}

local least, most = 1e-4, 1.0 -- amplitudes
local wrong = 0.1
local samples = 48 -- of the exact motion in a period: the largest error is missed by at most (pi/48)^2/2 of itself
local top, side, bottom = 84, 340, 96
local left, gap, right = 72, 92, 24

local names = { "axis 1 (least moment)", "axis 2 (middle moment)", "axis 3 (greatest moment)" }

local styles = {
  { "note", "font:12px sans-serif;fill:#444", "fill:#c3c8d0" },
  { "ring-a", "fill:none;stroke:#1f6fb2;stroke-width:1.4", "stroke:#6db3f2" },
  { "ring-b", "fill:none;stroke:#c2571a;stroke-width:1.4", "stroke:#f0975a" },
  { "edge", "stroke-dasharray:1 3;stroke-width:1;stroke:#777;fill:none", "stroke:#9aa" },
}

-- The rates of the exact motion along the principal axes at the times (in 1/w, the spin is 1 rad/s): rows {x, y, z}.
local function exact(f, A, x, y, times, measure)
  local a, w = f.axes, {}
  for n = 1, 3 do w[n] = a[A.k][n] + x * a[A.i][n] + y * a[A.j][n] end
  local rows, why = measure(w, times)
  if not rows then return nil, why end
  local function along(v, row) return v[1] * row[1] + v[2] * row[2] + v[3] * row[3] end
  for n, row in ipairs(rows) do rows[n] = { along(a[A.i], row), along(a[A.j], row), along(a[A.k], row) } end
  return rows
end

local function difference(A, x, y, t, row)
  local lx, ly = law.rates(A, x, y, t)
  return math.max(math.abs(row[1] - lx), math.abs(row[2] - ly), math.abs(row[3] - 1))
end

-- The largest error of n periods with the transverse rate e, or nil and why.
function chart.error(f, A, e, n, measure)
  local x, y = law.direction(A)
  local times, period = {}, 2 * math.pi / A.frequency
  for i = 1, n * samples do times[i] = i * period / samples end
  local rows, why = exact(f, A, e * x, e * y, times, measure)
  if not rows then return nil, why end
  local worst = 0.0
  for i, row in ipairs(rows) do worst = math.max(worst, difference(A, e * x, e * y, times[i], row)) end
  return worst
end

-- The first time with an error of a tenth, in 1/w; infinite if not within 1.5 times what the law says.
function chart.failure(f, A, e, measure)
  local x, y = law.direction(A)
  local times, count = {}, 1000
  local finish = 1.5 * law.failure(A, e * x, e * y, wrong)
  for i = 1, count do times[i] = finish * i / count end
  local rows, why = exact(f, A, e * x, e * y, times, measure)
  if not rows then return nil, why end
  local before = 0.0
  for i, row in ipairs(rows) do
    local now = difference(A, e * x, e * y, times[i], row)
    if now >= wrong then return finish * (i - (now - wrong) / (now - before)) / count end
    before = now
  end
  return math.huge
end

local function decade(x, up) return 10.0 ^ (up and math.ceil or math.floor)(math.log(x, 10)) end

-- Amplitudes from least to most, below the limit: `each` a decade.
local function amplitudes(limit, each)
  local list = {}
  for n = 0, 4 * each do
    local e = least * 10.0 ^ (n / each)
    if e < limit then list[#list + 1] = e end
  end
  return list
end

local function stable_panel(d, f, list, box, measure)
  local low = least
  for _, A in ipairs(list) do low = math.min(low, law.error(law.worst(A, math.min(least, A.limit / 2)), 1)) end
  local s = svg.frame(d, { x0 = box[1], y0 = box[2], x1 = box[3], y1 = box[4], xlog = true, ylog = true,
    xrange = { least, most }, yrange = { decade(low), 10.0 }, xlabel = "e: transverse rate / w",
    ylabel = "largest error of a rate / w" })
  for n, A in ipairs(list) do
    local color = n == 1 and "a" or "b"
    for _, periods in ipairs { 1, 100 } do
      local points = {}
      for _, e in ipairs(amplitudes(A.limit, 60)) do
        points[#points + 1] = { s.at(e, law.error(law.worst(A, e), periods)) }
      end
      if #points > 1 then d:path(points, "curve " .. color .. (periods == 1 and "" or " dashed")) end
      for _, e in ipairs(amplitudes(A.limit, 3)) do
        local error, why = chart.error(f, A, e, periods, measure)
        if not error then return nil, why end
        local x, y = s.at(e, math.max(error, decade(low)))
        d:circle(x, y, 3.2, (periods == 1 and "dot-" or "ring-") .. color)
      end
    end
    if A.limit > least and A.limit < most then d:line(s.x(A.limit), box[2], s.x(A.limit), box[4], "edge") end
  end
  local x, y = box[1], box[4] + 54
  for n, A in ipairs(list) do
    local color = n == 1 and "a" or "b"
    for i, periods in ipairs { 1, 100 } do
      local at = x + (i - 1) * 260
      d:line(at, y - 4, at + 26, y - 4, "curve " .. color .. (periods == 1 and "" or " dashed"))
      d:circle(at + 13, y - 4, 3.2, (periods == 1 and "dot-" or "ring-") .. color)
      d:text(at + 33, y, periods == 1 and names[A.k] .. ": 1 period" or "100 periods", "note")
    end
    y = y + 18
  end
  return true
end

local function unstable_panel(d, f, A, box, measure)
  local x, y = law.direction(A)
  local function turns(e) return law.failure(A, e * x, e * y, wrong) / (2 * math.pi) end
  local log = A.kind == "neutral"
  local range = log and { decade(turns(most)), decade(turns(least), true) } or { 0.0, 1.08 * turns(least) }
  local s = svg.frame(d, { x0 = box[1], y0 = box[2], x1 = box[3], y1 = box[4], xlog = true, ylog = log,
    xrange = { least, most }, yrange = range, xlabel = "e: transverse rate / w",
    ylabel = "revolutions until wrong by 0.1 w" })
  local points = {}
  for _, e in ipairs(amplitudes(math.huge, 60)) do points[#points + 1] = { s.at(e, turns(e)) } end
  d:path(points, "curve c")
  for _, e in ipairs(amplitudes(math.huge, 3)) do
    local time, why = chart.failure(f, A, e, measure)
    if not time then return nil, why end
    if time < math.huge then
      local px, py = s.at(e, time / (2 * math.pi))
      d:circle(px, py, 3.2, "dot-c")
    end
  end
  local px, py = box[1], box[4] + 54
  d:line(px, py - 4, px + 26, py - 4, "curve c")
  d:circle(px + 13, py - 4, 3.2, "dot-c")
  d:text(px + 33, py, log and "across the axis of symmetry, neutral" or names[A.k] .. ", unstable", "note")
  return true
end

-- The chart as SVG text, or nil and why.  measure(w, times) -> {{wx, wy, wz}, ...}: the exact motion of the job's body
-- without its effects, from the rates w at t = 0, in body axes.
function chart.text(job, measure)
  local f = facts.of(job)
  local stable, other = {}, nil
  for k = 1, 3 do
    local A = law.axis(f.moments, k)
    if A.kind == "stable" then
      stable[#stable + 1] = A
    elseif A.kind ~= "exact" then
      other = other or A
    end
  end
  local panels = (#stable > 0 and 1 or 0) + (other and 1 or 0)
  if panels == 0 then return nil, "all moments of this body are equal: the linearised top is exact" end
  local title = f.name .. ": the linearised top against the exact one"
  local width = math.max(left + panels * side + (panels - 1) * gap + right, 560) -- the title's
  local d = svg.new(width, top + side + bottom, { title = title, palette = styles, about = "The error of the " ..
    "linearised free top as a function of the transverse rate at t = 0: lines are the derived law, points the exact " ..
    "solution." })
  d:text(left, 26, title, "title")
  d:text(left, 44, "lines: derived law; points: exact motion, from the worst direction; dotted: separatrix", "note")
  local x = left
  local function box() return { x, top, x + side, top + side } end
  if #stable > 0 then
    d:text(x + side / 2, top - 12, "where the spin is stable", "label", "middle")
    local ok, why = stable_panel(d, f, stable, box(), measure)
    if not ok then return nil, why end
    x = x + side + gap
  end
  if other then
    d:text(x + side / 2, top - 12, "where it is " .. other.kind, "label", "middle")
    local ok, why = unstable_panel(d, f, other, box(), measure)
    if not ok then return nil, why end
  end
  return svg.text(d)
end

return chart
