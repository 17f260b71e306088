-- init.lua -- what NAME_init does: tests the parameters, then computes the derived constants.
--
-- A composite body's constants are computed in its named parts (mass/parts.lua); a constant that a later one uses is a
-- local of its own name.  BELOW the line where it makes C.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local cost = require "generator.algebra.cost"
local cosine = require "generator.algebra.cosine"
local nest = require "generator.algebra.nest"
local number = require "generator.emit.number"
local source = require "generator.emit.source"

local init = {}

local words = { m = true, p = true, k = true, own = true, roundoff = true } -- what NAME_init itself calls something

-- The parameters as inputs, and the names that must change for it: node -> symbol.
local function inputs(ctx, m)
  local list, map = {}, {}
  for _, p in ipairs(m.params) do
    local name = p.name
    if words[name] then
      name = name .. "_"
      map[p.sym] = expr.sym(name, 2)
    end
    list[#list + 1] = { sym = name, c = "p[" .. ctx.upper .. "_" .. string.upper(p.name) .. "]" }
  end
  return list, map
end

-- The members' forms, nested if that is cheaper: all or none, as sums that they share must stay shared.
local function nested(members)
  local best = {}
  for i, member in ipairs(members) do best[i] = cosine(member.form) end
  local least = cost(best)
  for _, last in ipairs { false, true } do
    local forms = {}
    for i, member in ipairs(members) do forms[i] = nest(cosine(member.form), last) end
    local now = cost(forms)
    if now < least then best, least = forms, now end
  end
  return best
end

-- The steps of the body's parts that the forms need and that are not in `placed` yet, as definitions.
local function steps(m, forms, map, placed)
  local list = {}
  for _, step in ipairs(m.parts and m.parts:needed(forms) or {}) do
    if not placed[step] then
      placed[step] = true
      list[#list + 1] = { name = step.name, expr = calculus.substitute(step.e, map), about = step.about }
    end
  end
  return list
end

-- The groups of parts and constants; members: which constants; placed: steps that are there already.
local function constants(m, members, map, groups, placed)
  local forms, used = nested(members), {}
  local own = { table.unpack(forms) }
  for _, step in ipairs(steps(m, forms, map, placed)) do
    groups[#groups + 1] = { why = step.about, defs = { step }, outs = {} }
  end
  for _, e in ipairs(forms) do
    for _, s in ipairs(expr.symbols(e)) do used[s] = true end
  end
  for i, member in ipairs(members) do
    local e = calculus.substitute(own[i], map)
    local named = used[member.sym] and own[i] ~= member.sym
    groups[#groups + 1] = { why = member.about, defs = named and { { name = member.name, expr = e } } or {},
      outs = { { c = "k." .. member.name, expr = named and member.sym or e } } }
  end
  return groups
end

-- Operations that computing the constants `members` from the parameters takes.
function init.cost(ctx, m, members)
  local list, map = inputs(ctx, m)
  return source.count { name = "init", inputs = list, groups = constants(m, members, map, {}, {}) }
end

-- Fills the template's values: init_loads, init_checks, init_groups, finite_lines, checks.
function init.fill(ctx, m, values)
  local list, map = inputs(ctx, m)
  local groups, checks, placed = {}, {}, {}
  -- a condition may ask for the rounding of the real type, half a unit in the last place of 1: it keeps a name, for
  -- multiplied into the other numbers of a sum it would spoil their form
  map[expr.sym("unit roundoff", 1, true)] = expr.sym("roundoff", 1, true)
  list[#list + 1] = { sym = "roundoff", c = number.text(R.new(2) ^ (ctx.real == "float" and -24 or -53), ctx.real) }
  for i, c in ipairs(m.conditions) do
    groups[i] = { defs = steps(m, { c.form }, map, placed), outs = { { c = "const " .. ctx.name .. "_real check" .. i,
      expr = calculus.substitute(c.form, map) } } }
    local relation = c.allow_zero and " >= " or " > "
    checks[i] = { number = string.format("%d", i), text = c.text, lines = {},
      condition = "check" .. i .. relation .. number.text(R.zero, ctx.real) }
  end
  constants(m, m.members, map, groups, placed)
  values.init_loads, values.init_checks, values.init_groups = {}, checks, {}
  local c = source.statements(ctx, { name = "init", args = {}, inputs = list, groups = groups })
  values.init_loads = c.loads
  for i, g in ipairs(c.groups) do
    local lines = {}
    if g.why then lines = source.comment(g.why) end
    for _, l in ipairs(g.lines) do lines[#lines + 1] = l end
    if checks[i] then checks[i].lines = lines else values.init_groups[#values.init_groups + 1] = { lines = lines } end
  end
  values.finite_lines = {}
  local code = #checks + 1
  for _, member in ipairs(m.members) do
    values.finite_lines[#values.finite_lines + 1] = string.format("if (!(k.%s - k.%s == %s)) return %d;", member.name,
      member.name, number.text(R.zero, ctx.real), code)
  end
  values.has_finite = #m.members > 0
  local listed = {}
  for i, check in ipairs(checks) do listed[i] = { number = check.number, text = check.text } end
  if #m.members > 0 then
    listed[#listed + 1] = { number = string.format("%d", code), text = "every derived constant must be finite" }
  end
  if #listed == 0 then listed[1] = { number = "-", text = "there is nothing to check" } end
  values.checks = listed
end

return init
