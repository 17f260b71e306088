-- taylor.lua -- the Taylor series method: the recurrences of series.lua laid out as loops over lanes.
--
-- All products of one level are summed in one loop, lane beside lane, so that compilers put them into vector registers;
-- what is linear is straight code around it.  y holds the newest term of every sequence that a lane reads, the states'
-- first; a[n][lane] and b[n][lane] are gathered from it.  Source of the method: Jorba, Zou 2005, Experimental
-- Mathematics 14, 99.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local breaks = require "generator.dynamics.breaks"
local constancy = require "generator.dynamics.constancy"
local distinct = require "generator.dynamics.distinct"
local state = require "generator.dynamics.state"
local switching = require "generator.dynamics.switching"
local series = require "generator.methods.series"
local stages = require "generator.methods.stages"
local special = require "generator.methods.taylor_special"

-- In float the seventh digit is the last one: an order above 10 costs more than its longer steps save, and coefficients
-- of seconds grow like w^n, in a type that ends at 3e38.
local taylor = { name = "taylor", adaptive = true, compensated = true, orders = { 4, 30 },
  own_order = { double = 20, float = 10 },
  needs = special.needs,
  about = "Taylor series of order 4 to 30 (--order; 20, in float 10), automatic recurrences, fixed or adaptive step" }

-- Does any form of the series contain the symbol?
-- (time as a state that nothing reads needs no place)
local function uses(made, sym)
  local set = { [sym.name] = true }
  local function has(e) return e and not expr.constant(e, set) end
  for _, v in ipairs(made.variables) do
    local s = v.state and v.name ~= sym.name and made.slopes[v.name] or {}
    if has(v.start) or has(v.term) or has(s.start) or has(s.term) then return true end
  end
  return false
end

-- Between two corners |t - T| is +-(t - T), sign(t - T) is +-1: the groups with a symbol of that sign for each corner,
-- and the corners, {time, sign}.
-- k.sign stands for +1 or -1 on the side of the corner that the step is on (breaks.lua).
local function straightened(eq, groups)
  local knots, map = breaks.knots(eq), {}
  for i, k in ipairs(knots) do
    local name = "side" .. i
    while eq.model.by_name[name] do name = name .. "_" end
    k.sign = expr.sym(name, 6)
    for bar, slope in pairs(k.bars) do -- into a table: order is lost anyway
      map[bar] = slope * k.sign * (state.t - k.time)
    end
    for sign, after in pairs(k.signs) do map[sign] = after * k.sign end -- into a table: order is lost anyway
  end
  if #knots == 0 then return groups, knots end
  local function put(list)
    return vec.map(list, function(d)
      return { name = d.name, state = d.state, expr = calculus.substitute(d.expr, map) }
    end)
  end
  return vec.map(groups, function(g) return { defs = put(g.defs), outs = put(g.outs) } end), knots
end

-- The recurrences of the groups for the states `list`; or nil and why there are none.
local function recurrences(list, groups)
  local ok, made = pcall(series.new, list, groups)
  if ok then return made end
  if getmetatable(made) ~= series.missing then error(made, 0) end
  return nil, "no recurrence is known for the function " .. made.fn
end

-- Lanes in the order of their levels, each level a range {first, last, variables = those made of its lanes}; within a
-- level lanes stand in the order in which they came up.  Level 0: what no lane is needed for.
local function by_level(made)
  local depth = 0
  for _, l in ipairs(made.lanes) do depth = math.max(depth, l.level) end
  for _, v in ipairs(made.variables) do depth = math.max(depth, v.level) end
  local lanes, levels = {}, {}
  for level = 1, depth do
    levels[level] = { first = #lanes + 1, variables = {} }
    for _, l in ipairs(made.lanes) do
      if l.level == level then lanes[#lanes + 1] = l end
    end
    levels[level].last = #lanes
  end
  levels[0] = { variables = {} }
  return lanes, levels
end

-- Gives each lane its index in the array p of C and puts p[index] for its symbol into all terms, and
-- fills the variables of the levels.
local function numbered(made, lanes, levels)
  local rename = {}
  for i, l in ipairs(lanes) do
    l.index = i - 1
    rename[l.sym] = expr.sym("p[" .. l.index .. "]", 8)
  end
  for _, v in ipairs(made.variables) do
    if v.term then
      v.term = calculus.substitute(v.term, rename)
      local row = levels[v.level].variables
      row[#row + 1] = v
    end
  end
  for name, s in pairs(made.slopes) do -- a map of its own: order is lost
    made.slopes[name] = { start = s.start, term = calculus.substitute(s.term, rename) }
  end
end

-- What lanes read, each variable with its place in the array y of C: the moving states first, time only if it is used.
local function readings(made, moving, lanes, clock)
  local read, places = {}, 0
  local function place(v)
    if not v.place then
      v.place = places
      places = places + 1
      read[#read + 1] = v
    end
  end
  for _, s in ipairs(moving) do place(made.by_sym[s.sym]) end
  for _, l in ipairs(lanes) do
    place(l.a)
    place(l.b)
  end
  if uses(made, clock) then place(made.by_sym[clock]) end
  return read
end

-- A sum of states that lanes read has its next term before the terms of a level are made (emit/recurrences.lua,
-- advance), so it is said in states and sums that are read: those that no lane reads are put in.
local function expanded(made)
  local inside = {}
  for _, v in ipairs(made.variables) do
    if v.level == 0 and v.term then
      local whole = calculus.substitute(v.term, inside)
      if v.place then v.term = whole else inside[v.sym] = whole end
    end
  end
end

-- The recurrences of groups, laid out: moving: the states whose terms are wanted, {name, sym}.
-- Returns {order, states, roots = square roots of what may vanish, lanes, levels = {{first, last, variables}}, ...}, or
-- nil and why there is none.  Time is a state of its own, t' = 1.
local function laid_out(groups, moving, order)
  local clock = expr.sym("t", 8)
  local list = { table.unpack(moving) }
  list[#list + 1] = { name = "t", sym = clock }
  local made, why = recurrences(list, groups)
  if not made then return nil, why end
  made.slopes.t = { start = expr.one, term = expr.zero }
  local lanes, levels = by_level(made)
  numbered(made, lanes, levels)
  local read, roots = readings(made, moving, lanes, clock), {}
  expanded(made)
  for _, v in ipairs(made.variables) do
    if v.root then roots[#roots + 1] = v end
  end
  return { order = order, term0 = series.FIRST, roots = roots, states = moving, variables = made.variables,
    lanes = lanes, levels = levels, slopes = made.slopes, constants = made.constants or {},
    read = read }
end

-- The same of the equations together with what neighbours along v depart by, the variational equations v' = f'(x) v:
-- state s has s_v beside it.  In `more`: those of states that keep their value and of inputs, which v holds beyond the
-- states.
local function tangent(eq, groups, moving, order)
  local m, known, states, more = eq.model, {}, { table.unpack(moving) }, {}
  local none = expr.sym("nothing", 8) -- no symbol of the equations: all derivatives are those that are known
  local moves = {}
  for _, s in ipairs(moving) do moves[s.name] = true end
  for _, s in ipairs(m.states) do
    local name = s.name .. "_v"
    while m.by_name[name] do name = name .. "_" end
    local v = { name = name, sym = expr.sym(name, 8), along = s.name }
    known[s.sym] = v.sym
    local list = moves[s.name] and states or more
    list[#list + 1] = v
  end
  for i, s in ipairs(m.inputs) do
    local v = { name = s.name .. "_v", sym = expr.sym(s.name .. "_v", 8), input = i }
    known[s.sym] = v.sym
    more[#more + 1] = v
  end
  local out = {}
  for i, g in ipairs(groups) do
    local copy = { defs = {}, outs = {} }
    for _, d in ipairs(g.defs) do
      copy.defs[#copy.defs + 1] = d
      local e = calculus.diff(d.expr, none, known)
      if e.kind ~= "num" and e.kind ~= "sym" then
        copy.defs[#copy.defs + 1] = { name = d.name .. "_v", expr = e }
        e = expr.sym(d.name .. "_v", 7)
      end
      known[expr.sym(d.name, 7)] = e
    end
    for _, o in ipairs(g.outs) do
      copy.outs[#copy.outs + 1] = o
      local v = moves[o.state] and known[m.states.by_name[o.state].sym]
      if v then copy.outs[#copy.outs + 1] = { state = v.name, expr = calculus.diff(o.expr, none, known) } end
    end
    out[i] = copy
  end
  local program, why = laid_out(out, states, order)
  if program then program.more = more end
  return program, why
end

-- The equations with no definition called like a derived constant: the series are told apart by names.
-- A definition that has such a name gets another one.
local function separate(eq)
  local ranks = {}
  for _, member in ipairs(eq.model.members or {}) do ranks[member.name] = 3 end
  return setmetatable({ groups = distinct.run(eq.groups, ranks) }, { __index = eq })
end

-- The series of the equations, or nil and why there is none.  options: {order =, jacobians =}.  As laid_out, with knots
-- = {{time, sign}}, axis, spin, shift of the frame, transition = the program of the variational equations.
function taylor.program(eq, options)
  local switches = switching.of(eq)
  if switches and switches.hidden == 0 then switches = nil end -- the series shows the corners
  if switches and switches.count > 0 and options.jacobians then
    return nil, "the equations have corners at times that are not known before, beyond which a transition matrix is " ..
      "not one series': use rk4, or leave jacobians out"
  end
  if switches then eq = switches.equations end
  local order, moving, zero = options.order or taylor.own_order[options.real or "double"], constancy.moving(eq)
  if #moving == 0 then return nil, stages.AT_REST end
  eq = separate(eq)
  -- what has corners need not be the same from all sides
  local seen = switches and { groups = eq.groups } or special.frame(eq, zero, moving)
  local groups, knots = straightened(eq, seen.groups)
  local program, why = laid_out(groups, moving, order)
  if not program then return nil, why end
  program.knots, program.axis, program.spin, program.shift = knots, seen.axis, seen.spin, seen.shift
  program.switches = switches
  -- Lame's equation has the motion of unit quaternions; the derivatives by q are also those across |q| = 1
  program.top = #knots == 0 and not options.jacobians and special.top(seen, moving) or nil
  if options.jacobians then
    program.transition, why = tangent(eq, straightened(eq, eq.groups), moving, order)
    if not program.transition then return nil, why end
    program.transition.knots = knots
  end
  return program
end

return taylor
