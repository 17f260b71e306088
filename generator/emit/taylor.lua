-- taylor.lua -- the Taylor stepper as C: which of templates/steppers/taylor_*.c say it, and their values.
--
-- The recurrences are those of the levels (taylor_terms.c), beside them rows of vectors where one level is all
-- (taylor_rows.c), or those of a heavy symmetric top (taylor_top.c); a series in a turning frame comes back by
-- taylor_axis.c or taylor_shift.c; where a square root may vanish, taylor_roots.c and taylor_corners.c step aside.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local number = require "generator.emit.number"
local packed = require "generator.emit.packed"
local recurrences = later "generator.emit.recurrences"
local source = require "generator.emit.source"
local switched = require "generator.emit.switched"
local template = require "generator.emit.template"

local function files(...)
  local list = { ... }
  for i, name in ipairs(list) do list[i] = "steppers/taylor" .. name end
  return table.unpack(list)
end

local GROUP = template.group(files(".h", "_title.c", "_vectors.c", "_rows.c", "_terms.c", "_top.c", "_series.c",
  "_axis.c", "_shift.c", "_move.c", "_roots.c", "_step.c", "_orders.c", "_size.c", "_corners.c", "_run.c", "_knots.c",
  "_compensated.c"))
local TRANSITION = template.group(files "_transition.c")

local taylor = {}

local function text(n) return string.format("%d", n) end

-- How to come back from the turning frame: pairs of states that the angle mixes, see templates/steppers/taylor_axis.c.
local function turns_of(ctx, program)
  local v = { axis = program.axis ~= nil and not program.top, shift = program.shift ~= nil, top = program.top ~= nil }
  if program.top then
    local g = { defs = {}, outs = {} }
    for i, e in ipairs(program.top) do g.outs[i] = { c = "o[" .. text(i - 1) .. "]", expr = e } end
    local f = source.statements(ctx, { name = "taylor_constants", args = { "m", "x" }, groups = { g } })
    v.lame = { loads = f.loads, lines = f.groups[1].lines }
    return v
  end
  if program.shift then
    local g, w = { defs = {}, outs = {} }, {}
    for i, name in ipairs { "wx", "wy", "wz" } do
      w[i] = expr.sym(name, 5)
      g.outs[i] = { c = "const " .. ctx.name .. "_real g" .. string.sub(name, 2),
        expr = w[i] - (program.shift[i] or expr.zero) * w[i] }
    end
    local f = { name = "taylor_back", args = { "m", "x" }, groups = { g } }
    local c = source.statements(ctx, f)
    v.frame = { loads = c.loads, lines = c.groups[1].lines }
  end
  if not program.axis then return v end
  local f = { name = "taylor_spin", args = { "m", "x" }, result = true, doc = {},
    groups = { { defs = {}, outs = { { result = true, expr = program.spin } } } } }
  v.spin, v.turns = {}, {}
  for _, line in ipairs(source.make(ctx, f).lines) do
    if line ~= "" then v.spin[#v.spin + 1] = line end
  end
  local at, comp = {}, { "x", "y", "z" }
  for i, s in ipairs(program.states) do at[s.name] = text(i - 1) end
  local a, b, c = comp[program.axis], comp[program.axis % 3 + 1], comp[(program.axis + 1) % 3 + 1]
  -- q (cos, k sin) of half the angle; the rates turned by minus the angle
  v.turns[1] = { a = at["q" .. a], b = at.qw, one = "D", sine = "S" }
  v.turns[2] = { a = at["q" .. b], b = at["q" .. c], one = "D", sine = "S" }
  v.turns[3] = { a = at["w" .. b], b = at["w" .. c], one = "W", sine = "V" }
  return v
end

-- Numbers of the type that the control of step and order wants.
function taylor.literals(real)
  local function literal(q) return number.text(R.lift(q), real) end
  local double = real ~= "float"
  local fraction, bias = double and 52 or 23, double and 1023 or 127
  return { float = double and "0" or "1", int = double and "int64_t" or "int32_t",
    bit = literal(R.new(2) ^ -fraction), scale = literal(R.new(2) ^ fraction), bias = literal(bias),
    corner_part = literal(R.new(2) ^ -(fraction // 2)), corner_halvings = text(fraction + 8),
    finest = literal(R.new(2) ^ (-fraction - 2)), leaving = literal(R.new(2) ^ (2 - fraction)),
    six = literal(R.new(6)), parts = "1000",
    least_packed = literal(R.new(13)), -- where a product costs less beside the rest of a step
    least = literal(R.new(19, 2)), slope = literal(R.new(3, 8)) }
end

local function merge(v, more)
  for k, x in pairs(more or {}) do v[k] = x end -- into a table: order is lost anyway
  return v
end

-- The values of all templates but that of the transition matrix; which texts: {packed, top}.
local function values_of(s, kit)
  local program, ctx, base = s.program, kit.ctx, kit.base
  local v, within, apart = recurrences.of(ctx, program, s.has_knots, base.zero)
  local rows = packed.of(ctx, program, base.zero, within)
  if rows then v.start_packed = apart end
  local function knots(words) return s.has_knots and words or "" end
  v.after_t, v.before_end = knots ", t", knots(", t + " .. base.half .. "*left")
  v.side_about = knots "; side: a time next to t on the side that they are for"
  v.order, v.states = text(program.order), {}
  for i, state in ipairs(program.states) do
    v.states[i] = { index = text(i - 1), name = ctx.upper .. "_" .. string.upper(state.name) }
  end
  merge(merge(merge(v, rows), turns_of(ctx, program)), taylor.literals(ctx.real))
  v.packed, v.row, v.columns = rows ~= nil, rows and packed.width or v.count, v.states
  v.attitude, v.kinds = program.states[1].name == "qw", source.kinds(program.states)
  v.transition, v.has_roots, v.roots = program.transition ~= nil, #program.roots > 0, {}
  v.first, v.has_knots, v.knots_count, v.has_compensated = s.first, s.has_knots, kit.knots_count, kit.compensated
  if program.top then -- rows of the attitude and its rates
    v.packed, v.row, v.lanes, v.columns = true, "8", "5", {}
    for i = 1, 8 do v.columns[i] = { index = text(i - 1) } end
    v.kinds[2].last = "8"
  end
  for i, x in ipairs(program.roots) do -- their terms stand beyond the states
    v.roots[i] = { index = text(#program.states + i - 1), place = text(x.place) }
  end
  if v.has_roots then v.row = text(#program.states + #program.roots) end
  switched.put(v, s, kit, "taylor")
  return v, rows
end

-- The values of taylor_transition.c: the recurrences of the variational equations, and what the step has.
local function transition(s, kit, whole)
  local program, ctx = s.program, kit.ctx
  local v = recurrences.of(ctx, program.transition, s.has_knots, kit.base.zero)
  for i, l in ipairs(program.transition.levels) do
    v.levels[i].first, v.levels[i].last = text(l.first - 1), text(l.last)
  end
  v.tangents = {}
  for i, state in ipairs(program.states) do
    v.tangents[i] = { name = ctx.upper .. "_" .. string.upper(state.name), along = text(#program.states + i - 1) }
  end
  for _, name in ipairs { "attitude", "frame", "shift", "first", "has_knots", "knots_count" } do
    v[name] = whole[name]
  end
  return v
end

-- Header and sources of the program of methods/taylor.lua.  s, kit: see emit/steppers.lua.
function taylor.render(s, kit)
  local v, rows = values_of(s, kit)
  local render, sources = GROUP(kit.templates, kit.base, v), {}
  local function file(name) return render((files(name))) end
  local function put(name, asked)
    if asked ~= false then sources[#sources + 1] = file(name) end
  end
  put "_title.c"
  v.terms = {}
  if v.top then
    put "_vectors.c"
    put "_top.c"
  elseif rows then -- in one #if
    v.terms[1] = file "_rows.c" .. "#else\n" .. file "_terms.c"
    put "_vectors.c"
  else
    put "_terms.c"
  end
  put "_series.c"
  put("_axis.c", v.axis)
  put("_shift.c", v.shift)
  put "_move.c"
  put("_roots.c", v.has_roots)
  local alone = not s.program.switches -- the step is that of switched.c
  put("_step.c", alone and not s.has_knots)
  put("_orders.c", alone and kit.planning)
  put "_size.c"
  put("_corners.c", v.has_roots)
  put "_run.c"
  put("_orders.c", not alone and kit.planning)
  if s.program.transition then
    local name = files "_transition.c"
    sources[#sources + 1] = TRANSITION(kit.templates, kit.base, transition(s, kit, v))(name)
  end
  put("_knots.c", alone and s.has_knots)
  put("_compensated.c", kit.compensated)
  return file ".h", sources
end

return taylor
