-- regions.lua -- where in the plane of two parameters a label is constant: bands with exact edges.
--
-- A problem is {atoms =, label = function(x, y), xlow =, xhigh =, ylow =, yhigh =}: an atom gives, for one x, the
-- places y where it changes sign; between them the label is constant, so a line x = constant is a list of intervals
-- with labels.  Neighbouring lines with the same list of labels are joined to bands, whose edges run through the exact
-- places; where the list changes, the x of the change is found by bisection, so no edge is made of steps.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local roots = require "generator.algebra.roots"
local section = require "generator.algebra.section"

local regions = {}

local scans = 256 -- values of y at which an atom that is no polynomial is looked at

-- An atom as {at = function(x) -> places in (lo, hi), sign = function(x, y)}; names: the two parameters.
function regions.atom(e, values, names, lo, hi)
  local terms = section.terms(e, values, names)
  if terms then
    return { e = e, at = function(x) return roots.between(section.coefficients(terms, x), lo, hi) end,
      value = function(x, y) return roots.value(section.coefficients(terms, x), y) end }
  end
  local fixed = section.fixed(e, values, names)
  local function value(x, y)
    return evaluate.double(fixed, { [names[1]] = x, [names[2]] = y })
  end
  if expr.constant(e, { [names[2]] = true }) then
    return { e = e, value = value, at = function() return {} end }
  end
  return { e = e, value = value, at = function(x)
    local list, before = {}, value(x, lo)
    for i = 1, scans do
      local a, b = lo + (hi - lo) * (i - 1) / scans, lo + (hi - lo) * i / scans
      local y = value(x, b)
      if y ~= 0 and before ~= 0 and (y > 0) ~= (before > 0) then
        list[#list + 1] = roots.bisect(function(t) return value(x, t) end, a, b)
      end
      before = y
    end
    return list
  end }
end

-- The line at x: {labels = {..}, edges = {{y, atom}, ...}}, one label more than edges; equal neighbours are joined.
local function line(p, x)
  local all = {}
  for n, a in ipairs(p.atoms) do
    for _, y in ipairs(a.at(x)) do all[#all + 1] = { y, n } end
  end
  table.sort(all, function(a, b) return a[1] < b[1] or a[1] == b[1] and a[2] < b[2] end)
  local labels, edges, low = {}, {}, p.ylow
  for i = 1, #all + 1 do
    local high = all[i] and all[i][1] or p.yhigh
    if high > low then
      local label = p.label(x, (low + high) / 2)
      if label ~= labels[#labels] then
        if #labels > 0 then edges[#edges + 1] = all[i - 1] end
        labels[#labels + 1] = label
      end
      low = high
    end
  end
  return { x = x, labels = labels, edges = edges, key = table.concat(labels, " ") }
end

-- The x between two lines of different kinds where the kind changes: the last line of the one, the first of the other.
local function change(p, a, b)
  for _ = 1, 60 do
    local x = a.x + (b.x - a.x) / 2
    if x <= a.x or x >= b.x then break end
    local m = line(p, x)
    if m.key == a.key then a = m else b = m end
  end
  return a, b
end

-- Runs of lines of one kind: a list of lists of lines, from xlow to xhigh.
function regions.runs(p, columns)
  local list, run = {}, nil
  local before
  for i = 0, columns do
    -- the ends of the range lie on borders (a = 0, say): a little inside them
    local t = i == 0 and 1e-7 or i == columns and columns - 1e-7 or i
    local l = line(p, p.xlow + (p.xhigh - p.xlow) * t / columns)
    while before and l.key ~= before.key do -- there may be several kinds between two lines
      local last, first = change(p, before, l)
      run[#run + 1] = last
      run = { first }
      list[#list + 1] = run
      before = first
    end
    if not run then
      run = {}
      list[1] = run
    end
    run[#run + 1] = l
    before = l
  end
  local wide = {} -- without the lines that lie on a border, where two moments are equal
  for _, r in ipairs(list) do
    if r[#r].x - r[1].x > 1e-9 * (p.xhigh - p.xlow) then wide[#wide + 1] = r end
  end
  return wide
end

-- The vertical borders between two runs that meet: a list of {x, y1, y2}, where the labels on the two sides differ.
function regions.steps(p, left, right)
  local a, b = left[#left], right[1]
  local list, low = {}, p.ylow
  local i, j = 1, 1
  while low < p.yhigh do
    local ya, yb = a.edges[i] and a.edges[i][1] or p.yhigh, b.edges[j] and b.edges[j][1] or p.yhigh
    local high = math.min(ya, yb)
    if a.labels[i] ~= b.labels[j] and high - low > 1e-4 * (p.yhigh - p.ylow) then
      local last = list[#list]
      if last and last[3] == low then last[3] = high else list[#list + 1] = { a.x, low, high } end
    end
    if ya <= high then i = i + 1 end
    if yb <= high then j = j + 1 end
    low = high
  end
  return list
end

return regions
