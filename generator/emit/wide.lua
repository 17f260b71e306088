-- wide.lua -- the Taylor series of several bodies at once: the text of one body's, on numbers that are vectors.
--
--     wide.render(s, kit, list) -> source, or nil       s: {program, step, advance}; kit: {templates, base, ctx}
--     list: of {way = "many" | "each", public = text of the first argument, tail}
-- nil where the series of one body stops at corners or leaves its recurrences, or calls functions of libm in them: then
-- bodies take their steps one by one.  Every operation is that of one body, so the bits are.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local recurrences = require "generator.emit.recurrences"
local source = require "generator.emit.source"
local taylor = require "generator.emit.taylor"
local template = require "generator.emit.template"

local GROUP = template.group("batch/wide.c", "batch/taylor_terms.c", "batch/taylor_back.c", "batch/taylor_move.c",
  "batch/taylor_advance.c", "batch/taylor_run.c")

local wide = {}

wide.needs = { { path = "taylor of several bodies at once", needs = "no frame about an axis, no heavy top, no " ..
  "root that may vanish, no corner, and no function of libm" } }

-- Bodies at once: a vector of 512 bits.
local WIDE = { double = "8", float = "16" }

-- Lines of one body's text for several: what comes from the model is the same for all or has a row of its own, and a
-- number becomes a vector by the difference from 0, which keeps its sign.
local function adapted(lines, rows)
  local out = {}
  for i, line in ipairs(lines) do
    line = string.gsub(line, "= m%->([%w_]+)([;,])", function(member, tail)
      return rows and "= own[" .. rows[member] .. "]" .. tail or "= m->" .. member .. " - none" .. tail
    end)
    line = string.gsub(line, "= ([%d%.eEFf%-%+/%(%)]+)([;,])", "= (%1) - none%2")
    out[i] = line
  end
  return out
end

-- Does a line call a function?
local function calls(lines)
  for _, line in ipairs(lines) do
    if string.find(line, "%f[%a_][%a_][%w_]*%(") then return true end
  end
  return false
end

-- The turning frame's lines; nil if there is none.
local function frame_of(ctx, program)
  if not program.shift then return nil end
  local g, w = { defs = {}, outs = {} }, {}
  for i, name in ipairs { "wx", "wy", "wz" } do
    w[i] = expr.sym(name, 5)
    g.outs[i] = { c = "const " .. ctx.kind .. " g" .. string.sub(name, 2),
      expr = w[i] - (program.shift[i] or expr.zero) * w[i] }
  end
  local c = source.statements(ctx, { name = "taylor_back", args = { "m", "x" }, groups = { g } })
  return { loads = c.loads, lines = c.groups[1].lines }
end

local function simple(program)
  return not program.top and not program.axis and #program.roots == 0 and #program.knots == 0 and
    not program.switches
end

-- The values of one way: all bodies of one model, or a model a body.
local function values_of(ctx, s, base, rows)
  local program = s.program
  local v = recurrences.of(ctx, program, false, base.zero)
  for _, name in ipairs { "outer", "start", "next", "loads", "after" } do v[name] = adapted(v[name], rows) end
  local all = { v.outer, v.start, v.next, v.loads, v.after }
  for _, level in ipairs(v.levels) do
    level.lines = adapted(level.lines, rows)
    all[#all + 1] = level.lines
    for _, lane in ipairs(level.lanes) do
      lane.weight = lane.weighted and "order*" or ""
      lane.head = lane.weighted and base.zero or "a[0][" .. lane.a .. "]"
    end
  end
  for _, lines in ipairs(all) do
    if calls(lines) then return nil end
  end
  v.history, v.states = {}, {}
  for i = 0, v.has_lanes and #program.read - 1 or -1 do v.history[i + 1] = string.format("%d", i) end
  for i, state in ipairs(program.states) do
    v.states[i] = { index = string.format("%d", i - 1), name = ctx.upper .. "_" .. string.upper(state.name) }
  end
  local frame = frame_of(ctx, program)
  v.shift, v.frame = frame ~= nil, frame and { loads = adapted(frame.loads, rows), lines = adapted(frame.lines, rows) }
  v.attitude, v.kinds = program.states[1].name == "qw", source.kinds(program.states)
  v.voids, v.side, v.count = {}, nil, nil -- the template's own
  return v
end

function wide.render(s, kit, list)
  if not simple(s.program) then return nil end
  local base, name = kit.base, kit.ctx.name
  local ctx = setmetatable({ kind = name .. "_wide", type = name .. "_wide" }, { __index = kit.ctx })
  local parts, ways, shared = {}, {}, nil
  for i, way in ipairs(list) do
    local rows = way.each and ctx.rows or nil
    local v = values_of(ctx, s, base, rows)
    if not v then return nil end
    v.way = way.each and "own_wide" or "wide"
    v.model = way.each and "own" or "m"
    v.owner = way.each and name .. "_wide own[]" or "const " .. name .. "_model *m"
    v.u = base.has_inputs and name .. "_wide u[], " or ""
    ways[i] = { way = way.way, tail = v.way, each = way.each, argument = way.each and "constants" or "m",
      public = way.each and "const " .. name .. "_real constants[]" or v.owner, call = way.each and "&own[0].v" or "m",
      u = base.has_inputs and "&v[0].v, " or "" }
    local text = table.concat(v.outer, "\n") .. table.concat(v.start, "\n") .. table.concat(v.next, "\n")
    for _, l in ipairs(v.levels) do text = text .. table.concat(l.lines, "\n") end
    text = text .. table.concat(v.loads, "\n") .. table.concat(v.after, "\n")
    for _, n in ipairs { v.model, "x" } do
      if not string.find(text, "%f[%w_]" .. n .. "%f[^%w_]") then v.voids[#v.voids + 1] = "(void)" .. n .. ";" end
    end
    if base.has_inputs and not string.find(text, "%f[%w_]u%f[^%w_]") then v.voids[#v.voids + 1] = "(void)u;" end
    v.wide, v.step, v.advance, v.ways = WIDE[ctx.real], s.step, s.advance, ways
    local literals = taylor.literals(ctx.real)
    v.finest, v.bias = literals.finest, literals.bias
    local render = GROUP(kit.templates, base, v)
    if i == 1 then parts[1] = render "batch/wide.c" end
    parts[#parts + 1] = render "batch/taylor_terms.c"
    if v.shift then parts[#parts + 1] = render "batch/taylor_back.c" end
    parts[#parts + 1] = render "batch/taylor_move.c"
    shared = render
  end
  parts[#parts + 1] = shared "batch/taylor_advance.c"
  parts[#parts + 1] = shared "batch/taylor_run.c"
  return table.concat(parts, "\n")
end

return wide
