-- chart.lua -- the stability chart: in the plane of two parameters, where a spin is stable, neutral or unstable.
--
-- Regions and borders are exact (report/regions.lua): they come from the atoms of mass/stability, and what NAME_init
-- would refuse is hatched.  A border carries its equation.  Other parameters keep their defaults.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local critical = require "generator.mass.critical"
local lawful = require "generator.mass.validity"
local stability = require "generator.mass.spin_stability"
local regions = require "generator.report.regions"
local svg = require "generator.draw.svg"

local chart = {}

local columns = 192

local palette = {
  -- the stroke closes the seams between bands
  { "stable", "fill:#cfe6cf;stroke:#cfe6cf;stroke-width:.7", "fill:#1f4428;stroke:#1f4428" },
  { "unstable", "fill:#f7d9c9;stroke:#f7d9c9;stroke-width:.7", "fill:#582f1c;stroke:#582f1c" },
  { "neutral", "fill:#d6e2f2;stroke:#d6e2f2;stroke-width:.7", "fill:#22384f;stroke:#22384f" },
  { "invalid", "fill:url(#hatch)" },
  { "hatch", "stroke:#999;stroke-width:1", "stroke:#666d78" }, { "hatched", "fill:#eee", "fill:#22262c" },
  { "halo", "paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round", "stroke:#15181d" },
  { "note", "font:12px sans-serif;fill:#444", "fill:#c3c8d0" },
  { "here", "fill:#222;stroke:#fff;stroke-width:1.5", "fill:#fff;stroke:#15181d" },
}

local words = { [1] = "stable", [0] = "neutral", [-1] = "unstable" }

local function sign(x) return x > 0 and 1 or x < 0 and -1 or 0 end

-- What the conditions of NAME_init say of the point, in exact numbers: atoms, and a function(x, y) -> valid.
local function validity(m, make)
  local knows_nothing, atoms, tests = critical.of {}, {}, {}
  for _, c in ipairs(m.conditions) do
    local s, list = 1, { c.e } -- a mass by itself is a symbol that passes for positive
    if c.e.kind ~= "sym" then s, list = knows_nothing:signs(calculus.substitute(c.e, lawful.exactly)) end
    local own = {}
    for i, e in ipairs(list) do
      own[i] = make(e)
      atoms[#atoms + 1] = own[i]
    end
    tests[#tests + 1] = function(x, y)
      local v = s
      for _, a in ipairs(own) do v = v * sign(a.value(x, y)) end
      return v > 0 or v == 0 and c.allow_zero
    end
  end
  return atoms, function(x, y)
    for _, t in ipairs(tests) do
      if not t(x, y) then return false end
    end
    return true
  end
end

-- The problem of one axis for report/regions, in the parameters' SI units.
local function problem(job, s, over, k, dissipation)
  local m, names = job.model, { over[1].name, over[2].name }
  local ylow, yhigh = over[2].low, over[2].high
  local function make(e) return regions.atom(e, m.defaults, names, ylow, yhigh) end
  local own, by_expr = {}, {}
  for i, e in ipairs(s:atoms()) do
    own[i] = make(e)
    by_expr[e] = own[i]
  end
  local others, valid = validity(m, make)
  local atoms = { table.unpack(own) }
  for _, a in ipairs(others) do atoms[#atoms + 1] = a end
  return { atoms = atoms, xlow = over[1].low, xhigh = over[1].high, ylow = ylow, yhigh = yhigh, own = #own,
    label = function(x, y)
      if not valid(x, y) then return "invalid" end
      return words[s.verdict(s:signs(function(e) return sign(by_expr[e].value(x, y)) end), k, dissipation)]
    end }
end

---- drawing -------------------------------------------------------------------------------------------

-- The points without those that lie on the line through their neighbours, to a hundredth of a pixel.
local function simplified(points)
  local out, from = { points[1] }, 1
  for i = 2, #points - 1 do
    local a, b = points[from], points[i + 1]
    local dx, dy = b[1] - a[1], b[2] - a[2]
    local length = math.sqrt(dx * dx + dy * dy)
    local straight = length > 0
    for k = from + 1, i do
      local x, y = points[k][1] - a[1], points[k][2] - a[2]
      straight = straight and math.abs(x * dy - y * dx) <= 0.01 * length
    end
    if not straight then
      out[#out + 1] = points[i]
      from = i
    end
  end
  out[#out + 1] = points[#points]
  return out
end

-- Bands of a run: polygons, from the lines' edges.
local function bands(d, p, runs, at)
  for r, run in ipairs(runs) do
    local function edge(l, n)
      local x = l == runs[1][1] and p.xlow or l == runs[#runs][#runs[#runs]] and p.xhigh or l.x
      local y = n == 0 and p.ylow or n == #l.labels and p.yhigh or l.edges[n][1]
      return { at(x, y) }
    end
    for n, label in ipairs(run[1].labels) do
      local above, points = {}, {}
      for i, l in ipairs(run) do above[i], points[#run + 1 - i] = edge(l, n), edge(l, n - 1) end
      if runs[r + 1] then -- neighbours share the border
        local x = at(runs[r + 1][1].x, p.ylow)
        above[#run][1], points[1][1] = x, x
      end
      above, points = simplified(above), simplified(points)
      points = table.move(points, 1, #points, #above + 1, above)
      if label == "invalid" then d:polygon(points, "hatched") end
      d:polygon(points, label)
    end
  end
end

-- Borders as polylines {points, atom}; joined from run to run where they go on.
local function borders(p, runs, at)
  local list = {}
  for r, run in ipairs(runs) do
    for n in ipairs(run[1].edges) do
      local current
      for _, l in ipairs(run) do
        local atom = l.edges[n][2]
        if not current or current.atom ~= atom then
          current = { atom = atom, points = {} }
          list[#list + 1] = current
        end
        current.points[#current.points + 1] = { at(l.x, l.edges[n][1]) }
      end
    end
    for _, step in ipairs(runs[r + 1] and regions.steps(p, run, runs[r + 1]) or {}) do
      local atom -- the first that changes sign here
      local y, width = (step[2] + step[3]) / 2, 1e-8 * (p.xhigh - p.xlow)
      for i, a in ipairs(p.atoms) do
        if not atom and sign(a.value(step[1] - width, y)) ~= sign(a.value(step[1] + width, y)) then atom = i end
      end
      list[#list + 1] = { atom = atom, points = { { at(step[1], step[2]) }, { at(step[1], step[3]) } } }
    end
  end
  return list
end

local function length(points)
  local s = 0.0
  for i = 2, #points do
    local a, b = points[i - 1], points[i]
    s = s + math.sqrt((b[1] - a[1]) ^ 2 + (b[2] - a[2]) ^ 2)
  end
  return s
end

-- The equation on the border, along it, at its middle: on the longest border of each atom.
local function label(d, s, p, list, box)
  local longest = {}
  for _, b in ipairs(list) do
    local l = longest[b.atom]
    if b.atom and b.atom <= p.own and (not l or length(b.points) > length(l.points)) then longest[b.atom] = b end
  end
  for n = 1, p.own do
    local b = longest[n]
    if b and length(b.points) > 60 then
      local words_of = s.critical:condition(p.atoms[n].e, "=", "unicode")
      if utf8.len(words_of) * 8 > math.min(length(b.points), 240) then words_of = s:equality(p.atoms[n].e) or "" end
      local half, i = length(b.points) * (n % 3 * 0.2 + 0.35), 2
      while i < #b.points do
        local part = length { b.points[i - 1], b.points[i] }
        if half < part then break end
        half, i = half - part, i + 1
      end
      i = math.min(i, #b.points)
      local a, c = b.points[math.max(1, i - 4)], b.points[math.min(#b.points, i + 3)]
      local turn = math.deg(math.atan(c[2] - a[2], c[1] - a[1]))
      if turn > 90 then turn = turn - 180 elseif turn < -90 then turn = turn + 180 end
      if math.abs(turn + 90) < 1e-9 or math.abs(turn - 90) < 1e-9 then turn = -90 end
      local x, y, up = b.points[i][1], b.points[i][2], math.rad(turn)
      if words_of ~= "" then
        local wide = utf8.len(words_of) * 3.4 -- half the text, about
        local reach, rise = wide * math.cos(up), wide * math.abs(math.sin(up))
        x = math.min(math.max(x, box.x0 + reach + 6), box.x1 - reach - 6)
        y = math.min(math.max(y, box.y0 + rise + 18), box.y1 - rise - 6)
        d:math(x + 8 * math.sin(up), y - 8 * math.cos(up), words_of, "math halo", "middle", turn)
      end
    end
  end
end

local function axis_label(o) return o.name .. (o.unit and ", " .. o.unit or "") end

local function panel(d, job, s, over, k, dissipation, box)
  local p = problem(job, s, over, k, dissipation)
  local function at(x, y)
    return box.x0 + (x - p.xlow) / (p.xhigh - p.xlow) * (box.x1 - box.x0),
      box.y1 - (y - p.ylow) / (p.yhigh - p.ylow) * (box.y1 - box.y0)
  end
  local runs = regions.runs(p, columns)
  bands(d, p, runs, at)
  svg.frame(d, { x0 = box.x0, y0 = box.y0, x1 = box.x1, y1 = box.y1, grid = false,
    xrange = { over[1].given_low, over[1].given_high }, yrange = { over[2].given_low, over[2].given_high },
    xlabel = axis_label(over[1]), ylabel = axis_label(over[2]) })
  local list = borders(p, runs, at)
  for _, b in ipairs(list) do d:path(simplified(b.points), "curve") end
  label(d, s, p, list, box)
  local condition = s:condition(k, dissipation, "unicode")
  if utf8.len(condition) > (box.x1 - box.x0) / 6 then condition = nil end
  d:text((box.x0 + box.x1) / 2, box.y0 - (condition and 26 or 10), box.title, "label", "middle")
  if condition then
    local settled = string.find(condition, "^never") or string.find(condition, "^always")
    d:math((box.x0 + box.x1) / 2, box.y0 - 9, "stable " .. (settled and "" or "iff ") .. condition, "note", "middle")
  end
  if over.inside then
    local x, y = at(over[1].here, over[2].here)
    d:circle(x, y, 4.5, "here")
  end
  local seen = {}
  for _, run in ipairs(runs) do
    for _, l in ipairs(run[1].labels) do seen[l] = true end
  end
  return seen
end

local function legend(d, seen, inside, x, y)
  local names = { stable = "stable", neutral = "neutral", unstable = "unstable", invalid = "no such body" }
  for _, name in ipairs { "stable", "neutral", "unstable", "invalid" } do
    if seen[name] then
      if name == "invalid" then d:rect(x, y - 11, 16, 12, "hatched") end
      d:rect(x, y - 11, 16, 12, name)
      d:rect(x, y - 11, 16, 12, "frame")
      d:text(x + 22, y, names[name], "note")
      x = x + 40 + 7 * #names[name]
    end
  end
  if inside then
    d:circle(x + 8, y - 5, 4.5, "here")
    d:text(x + 20, y, "the scene", "note")
  end
end

-- The chart as SVG text.  over: two of {name, unit, low, high, here (SI), given_low, given_high (own unit)};
-- axes: which of the axes of s, of mass/stability unless it is given (report/upright_chart.lua).  nil and why if the
-- body has no axes in closed form.
function chart.text(job, over, axes, dissipation, s, about)
  local m = job.model
  s = s or stability.of(m)
  if not s.axes then return nil, "the principal axes have no simple closed form, so no condition can be drawn" end
  over.inside = true
  for _, o in ipairs(over) do over.inside = over.inside and o.here >= o.low and o.here <= o.high end
  local size = #axes == 1 and 420 or 270
  local gap = 84
  local width = 72 + #axes * size + (#axes - 1) * gap + 28
  local height = 100 + size + 84
  local title = m.name .. ": stability of a spin" .. (dissipation and " with dissipation" or about or "")
  local spin = about and "spin" .. about or "free spin about a principal axis"
  local d = svg.new(width, height, { title = title, palette = palette, about = "Regions of the parameters " ..
    over[1].name .. " and " .. over[2].name .. " where a " .. spin .. " persists." })
  d:put('<defs><pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">')
  d:line(0, 0, 0, 7, "hatch")
  d:put("</pattern></defs>")
  d:text(72, 26, title, "title")
  local others = {}
  for _, p in ipairs(m.params) do
    local used = p.name == over[1].name or p.name == over[2].name
    for _, e in ipairs(s:atoms()) do
      if not used and not expr.constant(e, { [p.name] = true }) then
        others[#others + 1] = p.name .. " = " .. p.given
        used = true
      end
    end
  end
  if #others > 0 then d:text(72, 44, table.concat(others, ", "), "note") end
  local seen = {}
  for i, k in ipairs(axes) do
    local x0 = 72 + (i - 1) * (size + gap)
    local box = { x0 = x0, y0 = 100, x1 = x0 + size, y1 = 100 + size, title = "about " .. s.axes[k] }
    local labels = panel(d, job, s, over, k, dissipation, box)
    for _, name in ipairs { "stable", "neutral", "unstable", "invalid" } do seen[name] = seen[name] or labels[name] end
  end
  legend(d, seen, over.inside, 72, height - 16)
  return svg.text(d)
end

return chart
