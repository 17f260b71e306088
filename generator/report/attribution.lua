-- attribution.lua -- what each effect costs: the operations of a right-hand side, effect by effect.
--
-- An effect's operations are the difference that leaving it out makes, the states being the scene's.  What no effect
-- asks for is counted by equation.  Sums that two effects share, or that only the two together need, belong to neither:
-- the row "shared" is what is missing in the total (negative where each alone would save it).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local equations = require "generator.dynamics.equations"
local quantities = require "generator.dynamics.quantities"
local source = require "generator.emit.source"

local attribution = {}

local classes = { "add", "mul", "div", "sqrt", "call" }
attribution.classes = classes

local function context(job, m)
  return { name = m.name, upper = string.upper(m.name), real = job.real, members = m.members, states = m.states,
    inputs = job.model.inputs }
end

-- Operations of a function of the job.
function attribution.cost(job, f) return source.cost(context(job, job.model), f) end

local function combined(a, b, sign)
  local out = {}
  for _, c in ipairs(classes) do out[c] = (a[c] or 0) + sign * (b[c] or 0) end
  return out
end

-- The derived constants that the rates of the equations use, in the model's order.
local function constants(m, eq)
  local used, list = {}, {}
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do
      for _, s in ipairs(expr.symbols(equations.inline(eq.groups, o.expr))) do used[s] = true end
    end
  end
  for _, member in ipairs(m.members) do
    if used[member.sym] then list[#list + 1] = member end
  end
  return list
end

-- The right-hand side with these effects alone: its model, equations and operations.
local function with(job, effects)
  local m = job.model:variant(effects)
  local nobody = { error = function() end } -- a part of what was accepted is accepted
  local eq = equations.of(nobody, m)
  return { model = m, equations = eq, cost = source.cost(context(job, m), quantities.rhs(eq)) }
end

local of = { qw = "attitude", wx = "Euler's equations", vx = "centre of mass" } -- by the first state of a group

-- {total = counts, rows = {{name, line, cost, constants = {names}}}, shared = counts or nil}
function attribution.of(job)
  local effects, rows = job.model.record.effects, {}
  local whole, none = with(job, effects), with(job, {})
  for _, g in ipairs(none.equations.groups) do
    local name = g.outs[1] and of[g.outs[1].state]
    if name then
      local alone = { groups = { g }, model = none.model, inputs = none.equations.inputs }
      local names = {}
      for i, member in ipairs(constants(none.model, { groups = { g } })) do names[i] = member.name end
      rows[#rows + 1] = { name = name, constants = names,
        cost = source.cost(context(job, none.model), quantities.rhs(alone)) }
    end
  end
  for i, e in ipairs(effects) do
    local others = {}
    for k, other in ipairs(effects) do
      if k ~= i then others[#others + 1] = other end
    end
    local left, known, names = with(job, others), {}, {}
    for _, member in ipairs(constants(left.model, left.equations)) do known[member.e] = true end
    for _, member in ipairs(constants(whole.model, whole.equations)) do
      if not known[member.e] then names[#names + 1] = member.name end
    end
    rows[#rows + 1] = { name = string.gsub(e.kind, "^effect%.", ""), line = e.line, constants = names,
      cost = combined(whole.cost, left.cost, -1) }
  end
  local rest, any = whole.cost, false
  for _, r in ipairs(rows) do rest = combined(rest, r.cost, -1) end
  for _, c in ipairs(classes) do any = any or rest[c] ~= 0 end
  return { total = combined(whole.cost, {}, 1), rows = rows, shared = any and rest or nil }
end

-- "3 + -, 6 *": counts in words, the zeros left out.
function attribution.words(cost)
  local parts = {}
  for i, c in ipairs(classes) do
    local n = cost[c] or 0
    if n ~= 0 then
      parts[#parts + 1] = string.format("%d %s", n, ({ "+ -", "*", "/", "sqrt", n == 1 and "call" or "calls" })[i])
    end
  end
  return #parts > 0 and table.concat(parts, ", ") or "nothing"
end

-- The table as lines of text.
function attribution.lines(a)
  local lines = { "rhs: " .. attribution.words(a.total) .. "; of these" }
  for _, r in ipairs(a.rows) do
    lines[#lines + 1] = "  " .. r.name .. (r.line and " (line " .. r.line .. ")" or "") .. ": " ..
      attribution.words(r.cost) .. (#r.constants > 0 and (r.line and "; constants that only it needs: "
      or "; constants: ") .. table.concat(r.constants, ", ") or "")
  end
  if a.shared then lines[#lines + 1] = "  shared between effects: " .. attribution.words(a.shared) end
  lines[#lines + 1] = "(an effect's operations: the difference that leaving it out makes)"
  return lines
end

-- The same for report/json.lua.
function attribution.json(a, object)
  local function counts(cost, ...)
    local list = { ... }
    for _, c in ipairs(classes) do list[#list + 1] = { c, cost[c] or 0 } end
    return list
  end
  local rows = {}
  for i, r in ipairs(a.rows) do
    local fields = counts(r.cost, { "what", r.name })
    if r.line then fields[#fields + 1] = { "line", r.line } end
    fields[#fields + 1] = { "constants", r.constants }
    rows[i] = object(fields)
  end
  local fields = { { "total", object(counts(a.total)) }, { "rows", rows } }
  if a.shared then fields[3] = { "shared", object(counts(a.shared)) } end
  return object(fields)
end

return attribution
