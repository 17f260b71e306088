-- cuts.lua -- the members of a sweep that are no body by a rule that NAME_init cannot ask: they fail, as a scene would.
--
-- NAME_init asks whether a hole lies inside where there is a formula (mass/within.lua).  Else the question needs points
-- or polygons (dynamics/body_at.lua), which the program of the sweep has not.  So it is asked here, for all values of
-- the grid that the body depends on, and the program gets the answers as a table; or for one value that is drawn, along
-- its range, and the program gets the spans in which there is no body.
--     cuts.find(job, list) -> {texts, codes, axes} | {texts, spans, place} | nil; and a warning | nil
-- codes: 0, or the number of a text; axes {stride, count, step}: (grid point / stride) modulo count, times step; spans
-- {code, low | nil, high | nil} of the value at `place`, from 0.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local body_at = require "generator.dynamics.body_at"
local within = require "generator.mass.within"

local cuts = {}

local most = 4000 -- answers: some 10 ms each

-- Value i, from 0, of a grid, as a rational in SI units.
local function gridded(v, i)
  local a, factor = v.over, evaluate.precise(v.factor, {}, 240)
  local t = a.count > 1 and i / (a.count - 1) or 0.0
  local x = a.log and a.low * (a.high / a.low) ^ t or a.low + (a.high - a.low) * t
  if t == 1 then x = a.high end
  return R.decimal(x) * factor
end

-- The number of a text, new or known.
local function numbered(found, said)
  if not said then return 0 end
  if not found.number[said] then
    found.texts[#found.texts + 1] = said
    found.number[said] = #found.texts
  end
  return found.number[said]
end

-- ---- grids ----

-- The answers at all points of the grids; step: how far apart in the table two values of a grid are.
local function table_of(job, grids, size, found)
  local step = 1
  found.codes, found.axes = {}, grids
  for k = #grids, 1, -1 do
    grids[k].step = step
    step = step * grids[k].count
  end
  for n = 0, size - 1 do
    local values = {}
    for _, g in ipairs(grids) do values[g.value.name] = gridded(g.value, n // g.step % g.count) end
    found.codes[n + 1] = numbered(found, body_at(job, values))
  end
end

-- ---- one value that is drawn ----

-- Where values are drawn from: all of them, but for one in 1e18.
local function range(d)
  if d.kind == "normal" then return d.a - 9 * d.b, d.a + 9 * d.b end
  if d.kind == "uniform" or d.kind == "loguniform" then return d.a, d.b end
  return nil
end

-- The spans in which a hole sticks out, from answers at 64 steps; where the answer changes, it is halved down to the
-- last bits.  A span between two of the steps that is shorter than one of them is not found.
local function spans_of(job, v, low, high, found)
  local factor, steps = evaluate.precise(v.factor, {}, 240), 64
  local function code(x) return numbered(found, body_at(job, { [v.name] = R.fromdouble(x) * factor })) end
  local function border(a, b, of_a)
    for _ = 1, 40 do
      local x = a + (b - a) / 2
      if code(x) == of_a then a = x else b = x end
    end
    return b
  end
  found.spans = {}
  local last, from, before = code(low), nil, low
  for i = 1, steps do
    local x = low + (high - low) * i / steps
    local now = code(x)
    if now ~= last then
      local at = border(before, x, last)
      if last > 0 then table.insert(found.spans, { code = last, low = from, high = at }) end
      last, from = now, at
    end
    before = x
  end
  if last > 0 then table.insert(found.spans, { code = last, low = from }) end
end

-- ---- both ----

-- list: the study's values, grids in the order of the program's axes.
function cuts.find(job, list)
  if #job.model.unasked == 0 then return nil end
  local used, grids, drawn, stride, size, axes = within.parameters(job.model.record.body), {}, {}, 1, 1, 0
  for k = #list, 1, -1 do
    local v = list[k]
    local mine = v.kind == "param" and used[v.name]
    if v.over then axes = axes + 1 end
    if mine and v.over then
      table.insert(grids, 1, { value = v, stride = stride, count = v.over.count })
      size = size * v.over.count
    elseif mine then
      table.insert(drawn, 1, v)
    end
    stride = stride * (v.over and v.over.count or 1)
  end
  if #grids + #drawn == 0 then return nil end
  local found, low, high = { texts = {}, number = {} }, nil, nil
  if #drawn == 1 and #grids == 0 then low, high = range(drawn[1].draw) end
  if low then
    spans_of(job, drawn[1], low, high, found)
    found.place = axes
    for _, v in ipairs(list) do -- draws stand behind the axes
      if v == drawn[1] then break end
      if v.draw then found.place = found.place + 1 end
    end
  elseif #drawn > 0 or size > most then
    local rule = job.model:sentence(job.model.unasked[1])
    return nil, rule .. " depends on " .. (#drawn > 0 and drawn[1].name .. ", which is drawn" ..
      (#drawn + #grids > 1 and " with others" or "") or "more than " .. most .. " points") ..
      ": it is not asked of the members"
  else
    table_of(job, grids, size, found)
  end
  return #found.texts > 0 and found or nil
end

return cuts
