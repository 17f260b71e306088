-- switched.lua -- the corners of the equations as C: what changes sign there, and steps that end there.
--
-- templates/steppers/switches.c stands once; switched.c once for each stepper with a tolerance, in its own text.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local switching = require "generator.dynamics.switching"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local SWITCHES, SWITCHED = template.group "steppers/switches.c", template.group "steppers/switched.c"

local LOOKS = 12 -- parts of a step; with the parabola through three, two or more for each turn that they resolve

local switched = {}

local function text(n) return string.format("%d", n) end

-- Of a number.
local function digits(ctx) return ctx.real == "float" and 24 or 53 end

-- The argument of the sides.
local function sides(sw)
  local names = {}
  for i = 1, #sw.list do names[i] = text(i - 1) end
  return { name = sw.name, count = #sw.list, names = names }
end
switched.sides = sides

-- What templates and functions call with it: empty texts where there are no corners.
local function called(ctx, sw)
  if not sw then return { has_switches = false, sides = "", sides_arg = "", switched = "" } end
  return { has_switches = true, most_parts = "1000", sides = ", " .. sw.name, array = sw.name, many = text(#sw.list),
    smooth = text(sw.count), bends = #sw.list > sw.count,
    sides_arg = ", const " .. ctx.name .. "_real " .. sw.name .. "[]" }
end

-- What the templates of each method read of that.
local READ = { adaptive = { "has_switches", "switched" },
  rosenbrock = { "has_switches", "switched", "sides", "sides_arg" },
  taylor = { "has_switches", "switched", "sides", "sides_arg", "array", "many", "most_parts" } }

-- What switched.c has from the method's own templates.
local OF_METHOD = { "count", "room", "states", "kinds", "slides", "has_floors", "floors_pass",
  "floors_count", "given", "given_args", "norm_pass", "has_knots",
  "has_roots", "finest", "first" }

-- switches.c; has_rates: are there steppers that need x' on the sides?
function switched.shared(kit, sw, has_rates)
  local ctx, words_of = kit.ctx, called(kit.ctx, sw)
  local v = { array = sw.name, many = words_of.many, smooth = words_of.smooth, bends = words_of.bends, list = {},
    looks = text(LOOKS), has_rates = has_rates, places = {}, rates = { head = "", lines = {} } }
  v.looks_real = number.text(R.new(LOOKS), ctx.real)
  v.rounding = number.text(R.new(2) ^ (3 - digits(ctx)), ctx.real)
  v.thousandth = number.text(R.new(2) ^ -10, ctx.real)
  v.most_halved, v.most_crowded = "30", text(40 + 2 * #sw.list)
  v.no_rates, v.has_sides = v.bends and ", x" or "", sw.count > 0
  for i, s in ipairs(sw.list) do v.list[i] = { number = text(i - 1), about = switching.about(s) } end
  for k = 0, LOOKS do -- (1 - cos(k pi/n))/2
    local e = expr.call("sin", expr.pi * expr.lift(R.new(k, 2 * LOOKS))) ^ 2
    v.places[k + 1] = number.text(evaluate.precise(e, {}, 200), ctx.real) .. (k < LOOKS and "," or "")
  end
  local names = {}
  for i, s in ipairs(ctx.states) do names[i] = s.name end
  local outs = {}
  for i, s in ipairs(sw.list) do outs[i] = { array = "g", index = text(i - 1), expr = s.g } end
  local args = { "m", "t", "x" }
  if v.bends then args[#args + 1] = { name = "v", count = #names, names = names } end
  args[#args + 1], args[#args + 2], args[#args + 3] = "u", sides(sw), { name = "g", count = v.many, out = true }
  local groups = {}
  for i, g in ipairs(sw.equations.groups) do groups[i] = { defs = g.defs, outs = {} } end
  groups[#groups + 1] = { defs = {}, outs = outs }
  v.g = source.make(ctx, { name = "switches", groups = groups, doc = {}, args = args })
  if has_rates then
    local rates = {}
    for i, g in ipairs(sw.equations.groups) do
      rates[i] = { why = g.why, where = g.where, defs = g.defs, outs = {} }
      for k, o in ipairs(g.outs) do rates[i].outs[k] = { array = "dx", state = o.state, expr = o.expr } end
    end
    v.rates = source.make(ctx, { name = "side_rates", groups = rates, doc = {}, args = { "m", "t", "x", "u", sides(sw),
      "dx" } })
  end
  return SWITCHES(kit.templates, kit.base, v) "steppers/switches.c"
end

-- The values of a stepper's templates with those of switched.c, which becomes one of them.
function switched.put(v, s, kit, method)
  local sw = s.program.switches
  local all = called(kit.ctx, sw)
  for _, k in ipairs(READ[method]) do v[k] = all[k] end
  if not sw then return v end
  local taylor, turn = method == "taylor", v.turn and v.turn ~= ""
  local count = taylor and sw.hidden or #sw.list
  local bends = count > sw.count
  local own = { method = method, taylor = taylor, adaptive = method == "adaptive", slides = false, has_roots = false,
    has_floors = false, floors_pass = "", floors_count = "", given = "", given_args = "", norm_pass = "",
    taken = s.taken, way_turn = turn and ", w->turn" or "", looks = text(LOOKS), own = text(count), bends = bends,
    keeps = bends and not taylor and sw.count == 0,
    most_halvings = text(4 * digits(kit.ctx)), end_rates = not all.bends and "" or bends and ", v" or ", w->y",
    look_rates = not all.bends and "" or bends and ", v" or ", y",
    by_cubic = taylor and "" or ", by the cubic with the states and rates at its ends",
    top_arg = taylor and ", int top" or "", top_pass = taylor and ", top" or "",
    top_full = taylor and ", " .. kit.ctx.upper .. "_ORDER" or "",
    top_own = taylor and ", " .. kit.ctx.name .. "_taylor_top(tolerance)" or "" }
  for _, k in ipairs { "array", "many", "most_parts" } do own[k] = all[k] end
  for _, k in ipairs(OF_METHOD) do
    if v[k] ~= nil then own[k] = v[k] end
  end
  v.switched = SWITCHED(kit.templates, kit.base, own) "steppers/switched.c"
  return v
end

return switched
