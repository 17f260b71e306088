-- rosenbrock.lua -- the linearly implicit method as C: rates, factors and their use printed;
-- templates/steppers/rosenbrock.c makes steps of them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local step_control = require "generator.emit.step_control"
local switched = require "generator.emit.switched"
local template = require "generator.emit.template"

local GROUP = template.group("steppers/rosenbrock.h", "steppers/rosenbrock.c")

local function text(n) return string.format("%d", n) end

local emit = {}

-- The places of an array as text.
local function placed(groups)
  local list = {}
  for i, g in ipairs(groups) do
    local outs = {}
    for k, o in ipairs(g.outs) do outs[k] = { array = o.array, index = text(o.index), expr = o.expr } end
    list[i] = { why = g.why, where = g.where, defs = g.defs, outs = outs }
  end
  return list
end

-- The rows of a tableau in C, with zeros up to `width`.
local function rows(list, width, real)
  local out = {}
  for i, row in ipairs(list) do
    local cells = {}
    for k = 1, width do cells[k] = number.text(row[k] or R.zero, real) end
    out[i] = { text = table.concat(cells, ", ") .. (i < #list and "}," or "}") }
  end
  return out
end

-- Header and source of the program of methods/rosenbrock.lua.  s, kit: see emit/steppers.lua.
function emit.render(s, kit)
  local program, ctx, T = s.program, kit.ctx, s.program.tableau
  local n, names = #program.states, {}
  for i, state in ipairs(program.states) do names[i] = state.name end
  local sides = program.switches and switched.sides(program.switches)
  local function made(name, groups, ...)
    local args = { ... }
    if sides and args[1] == "m" then table.insert(args, args[5] == "n" and 6 or 5, sides) end
    local f = source.make(ctx, { name = "rosenbrock_" .. name, groups = placed(groups), doc = {}, args = args })
    return { head = f.head, lines = f.lines }
  end
  local function array(name, count) return { name = name, count = text(count), out = true } end
  local function given(name, list) return { name = name, count = #list, names = list } end
  local attitude = program.states[1].name == "qw"
  local v = { count = text(n), cells = text(#program.factors), timed = program.timed, attitude = attitude, states = {},
    has_knots = s.has_knots, first = s.first, taken = s.taken,
    slips = {},
    many = text(#program.slips),
    slides = #program.slips > 0, rate = number.text(T.gamma ^ -1, ctx.real),
    a = rows(T.a, 7, ctx.real), C = rows(T.C, 7, ctx.real), c = rows({ T.c }, 8, ctx.real)[1].text,
    d = rows({ T.d }, 8, ctx.real)[1].text }
  v.c, v.d = string.sub(v.c, 1, -2), string.sub(v.d, 1, -2)
  for i, state in ipairs(program.states) do v.states[i] = { name = ctx.upper .. "_" .. string.upper(state.name) } end
  local held = {}
  for i, x in ipairs(program.slips) do held[i] = "x[" .. ctx.upper .. "_" .. string.upper(x.state.name) .. "]" end
  v.slip_states = table.concat(held, " and ") .. (#held == 1 and " is" or " are")
  for i, x in ipairs(program.slips) do v.slips[i] = { name = ctx.upper .. "_" .. string.upper(x.state.name),
    place = text(i - 1) } end
  v.rates = made("rates", program.rates, "m", "t", "x", "u", array("dz", n))
  v.matrix = made("matrix", program.matrix, "m", "t", "x", "u", "n", array("F", #program.factors),
    program.timed and array("dt", n) or nil)
  v.solve = made("solve", program.solve, given("F", program.factors), given("b", names), array("k", n))
  v.shift = #program.slips > 0 and made("slip", program.shifts, "m", "t", "x", "u", array("a", #program.slips)) or
    { head = "", lines = {} }
  switched.put(v, s, kit, "rosenbrock")
  step_control.put(v, s, kit, "rosenbrock")
  local render = GROUP(kit.templates, kit.base, v)
  return render "steppers/rosenbrock.h", { render "steppers/rosenbrock.c" }
end

return emit
