-- switched.lua -- the corners of the equations as C: what changes sign there, and steps that end there.
--
-- templates/steppers/switches.c stands once; switched.c once for each stepper with a tolerance, in its own text.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local switching = require "generator.dynamics.switching"
local floors = require "generator.emit.floors"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local SWITCHES, SWITCHED = template.group "steppers/switches.c", template.group "steppers/switched.c"

local LOOKS = 12 -- parts of a step; with the parabola through three, two or more for each turn that they resolve

local switched = {}

local function text(n) return string.format("%d", n) end

-- Binary digits of the type.
local function digits(ctx) return ctx.real == "float" and 24 or 53 end

-- The argument of the sides, or nil where there are only speeds.
local function sides(sw)
  if not sw or sw.count == 0 then return nil end
  local names = {}
  for i = 1, sw.count do names[i] = text(i - 1) end
  return { name = sw.name, count = sw.count, names = names }
end
switched.sides = sides

-- How many functions of sw's list a method looks at: a series shows by itself where a root vanishes.
local function looked_at(sw, method) return method == "taylor" and sw.hidden or #sw.list end

-- What all methods of a scene's steppers need: nil, or {switches, count = of the functions, has_rates = are there
-- steppers that need x' on the sides?}.
function switched.needed(steppers)
  local all
  for _, s in ipairs(steppers) do
    local sw, method = s.program and s.program.switches, s.method.name
    if sw then
      all = all or { switches = sw, count = 0, has_rates = false }
      all.count = math.max(all.count, looked_at(sw, method))
      all.has_rates = all.has_rates or method ~= "taylor" and sw.count > 0
    end
  end
  return all
end

-- What the templates of each method read of it; empty texts where there are no corners or no sides.
local READ = { adaptive = { "has_switches", "has_sides" },
  rosenbrock = { "has_switches", "has_sides", "sides", "sides_arg" },
  taylor = { "has_switches", "has_sides", "sides_arg", "series_sides", "most_parts" } }

-- What switched.c has from the method's own templates.
local OF_METHOD = { "count", "room", "states", "slides", "has_knots", "has_roots", "finest", "first" }

local function called(ctx, sw)
  local has = sides(sw) ~= nil
  local function given(words) return has and words or "" end
  return { has_switches = sw ~= nil, has_sides = has, most_parts = "1000",
    sides = given(", " .. (sw and sw.name or "")),
    series_sides = given(", o." .. (sw and sw.name or "")),
    sides_arg = given(", const " .. ctx.name .. "_real " .. (sw and sw.name or "") .. "[]") }
end

-- Rows of four numbers.
local function rows_of(list)
  local rows = {}
  for i = 1, #list, 4 do
    local last = math.min(i + 3, #list)
    rows[#rows + 1] = table.concat(list, ", ", i, last) .. (last < #list and "," or "")
  end
  return rows
end

-- The functions g as C, and x' on the sides.
local function functions_of(ctx, sw, count, has_rates)
  local names, groups, outs, args = {}, {}, {}, { "m", "t", "x" }
  for i, s in ipairs(ctx.states) do names[i] = s.name end
  for i = 1, count do outs[i] = { array = "g", index = text(i - 1), expr = sw.list[i].g } end
  if count > sw.count then args[#args + 1] = { name = "v", count = #names, names = names } end
  args[#args + 1] = "u"
  args[#args + 1] = sides(sw)
  args[#args + 1] = { name = "g", count = text(count), out = true }
  for i, g in ipairs(sw.equations.groups) do groups[i] = { defs = g.defs, outs = {} } end
  groups[#groups + 1] = { defs = {}, outs = outs }
  local g = source.make(ctx, { name = "switches", groups = groups, doc = {}, args = args })
  if not has_rates then return g, { head = "", lines = {} } end
  local rates = {}
  for i, e in ipairs(sw.equations.groups) do
    rates[i] = { why = e.why, where = e.where, defs = e.defs, outs = {} }
    for k, o in ipairs(e.outs) do rates[i].outs[k] = { array = "dx", state = o.state, expr = o.expr } end
  end
  return g, source.make(ctx, { name = "side_rates", groups = rates, doc = {}, args = { "m", "t", "x", "u", sides(sw),
    "dx" } })
end

-- switches.c, for what switched.needed gives.
function switched.shared(kit, needed)
  local ctx, sw, count = kit.ctx, needed.switches, needed.count
  local v = { array = sw.name, many = text(count), smooth = text(sw.count), bends = count > sw.count, list = {},
    has_sides = sw.count > 0, has_rates = needed.has_rates, looks = text(LOOKS), nodes = text(LOOKS + 1) }
  v.looks_real = number.text(R.new(LOOKS), ctx.real)
  v.rounding = number.text(R.new(2) ^ (3 - digits(ctx)), ctx.real)
  v.thousandth = number.text(R.new(2) ^ -10, ctx.real)
  v.most_halved, v.most_crowded = "30", text(40 + 2 * #sw.list)
  v.o_branch = sw.count > 0 and ", o->" .. sw.name or ""
  for i = 1, count do v.list[i] = { number = text(i - 1), about = switching.about(sw.list[i]) } end
  local places = {}
  for k = 0, LOOKS do -- (1 - cos(k pi/n))/2
    local e = expr.call("sin", expr.pi * expr.lift(R.new(k, 2 * LOOKS))) ^ 2
    places[k + 1] = number.text(evaluate.precise(e, {}, 200), ctx.real)
  end
  v.places = rows_of(places)
  v.g, v.rates = functions_of(ctx, sw, count, needed.has_rates)
  return SWITCHES(kit.templates, kit.base, v) "steppers/switches.c"
end

-- The values of a stepper's templates with those of switched.c, which becomes one of them.
function switched.put(v, s, kit, method)
  local sw, ctx = s.program.switches, kit.ctx
  local all = called(ctx, sw)
  for _, k in ipairs(READ[method]) do v[k] = all[k] end
  v.switched = ""
  if not sw then return end
  local has, taylor, adaptive = sw.count > 0, method == "taylor", method == "adaptive"
  local turn, count, many = adaptive and v.attitude, looked_at(sw, method), kit.corners.count
  local bends = count > sw.count
  local function given(asked, words) return asked and words or "" end
  -- the rates that g's of speeds have, if the function takes any; no matter which where those g are not looked at
  local function rates(own) return given(many > sw.count, bends and ", v" or own) end
  local own = { method = method, taylor = taylor, adaptive = adaptive, rosenbrock = method == "rosenbrock",
    slides = false, has_roots = false, has_sides = has, bends = bends, keeps = not taylor and sw.affine,
    array = sw.name, smooth = text(sw.count), own = text(count), many = text(many), most_parts = all.most_parts,
    looks = text(LOOKS), looks_less = text(LOOKS - 1), nodes = text(LOOKS + 1), most_tries = text(LOOKS * count),
    most_halvings = text(4 * digits(ctx)), rates = has and "side_rates" or "rhs",
    end_rates = rates ", w->y", look_rates = rates ", y", none_rates = given(many > sw.count, ", none"),
    w_sides = given(has, ", w->o." .. sw.name), own_sides = given(has, ", w.o." .. sw.name),
    terms_sides = given(has, ", w.o." .. sw.name), knot_side = given(s.has_knots, ", t + " .. kit.base.half .. "*left"),
    way_turn = given(turn, ", w->turn"), room_d = given(taylor, ", d[" .. ctx.upper .. "_ROW]"),
    way_norm = floors.passed(s.program, "w->m", "w->u", "*h") ..
      "x, w->" .. (adaptive and "out" or "y") .. ", w->error",
    by_cubic = given(not taylor, ", by the cubic with the states and rates at its ends"), at = given(not taylor, "t, "),
    at_arg = given(not taylor, ctx.name .. "_real t, "),
    taken = s.taken, rests = #s.program.states < #ctx.states,
    top_arg = given(taylor, ", int top"), top_pass = given(taylor, ", top"),
    top_full = given(taylor, ", " .. ctx.upper .. "_ORDER"),
    top_own = given(taylor, ", " .. ctx.name .. "_taylor_top(tolerance)") }
  for _, k in ipairs(OF_METHOD) do
    if v[k] ~= nil then own[k] = v[k] end
  end
  v.switched = SWITCHED(kit.templates, kit.base, own) "steppers/switched.c"
end

return switched
