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
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local breaks = require "generator.dynamics.breaks"
local distinct = require "generator.dynamics.distinct"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"
local switching = require "generator.dynamics.switching"
local series = require "generator.methods.series"
local stages = require "generator.methods.stages"

-- In float the seventh digit is the last one: an order above 10 costs more than its longer steps save, and coefficients
-- of seconds grow like w^n, in a type that ends at 3e38.
local taylor = { name = "taylor", adaptive = true, compensated = true, orders = { 4, 30 },
  own_order = { double = 20, float = 10 },
  about = "Taylor series of order 4 to 30 (--order; 20, in float 10), automatic recurrences, fixed or adaptive step" }

local rates = state.names.rates
local of_attitude = {}
for _, name in ipairs(state.names.attitude) do of_attitude[name] = true end

-- Where body and torque look alike from all sides of an axis k and the rate w3 about it is constant, the equations keep
-- their form in a frame that turns about k at any rate s relative to the body: only Omega = (I3 - I1)/I1 w3 becomes
-- Omega + s, and w3 in the attitude's equation w3 - s.  With s = (w3 - Omega)/2 the fastest oscillation, w3 of a
-- direction fixed in space, falls to (w3 + Omega)/2, and longer steps do.  Returns the groups in that frame, the number
-- of the axis, s; or the groups as they are.
local function despun(eq, zero)
  local m = eq.model
  local turns = m.has.rates and m.has.attitude
  local axis = turns and m.structure.kind == "symmetric" and equations.coordinate(m.structure.k)
  if not axis or not zero[rates[axis]] or eq.inputs then return eq.groups end
  local q, w = state.q, state.w
  local k = { expr.zero, expr.zero, expr.zero }
  k[axis] = expr.one
  local turning = vec.cross(k, w)
  local turned = vec.qmul(q, { expr.zero, -k[1] / 2, -k[2] / 2, -k[3] / 2 }) -- rate of change of q as the frame turns
  local slope = {} -- in the body, of the rates
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do slope[o.state] = equations.inline(eq.groups, o.expr) end
  end
  local rate = vec.map(rates, function(name) return slope[name] end)
  local along = vec.cross(k, rate)
  local function turned_with(e) -- how e changes as the frame turns
    local change = expr.zero
    for j = 1, 3 do change = change + calculus.diff(e, w[j]) * turning[j] end
    for j = 1, 4 do change = change + calculus.diff(e, q[j]) * turned[j] end
    return change
  end
  -- a rate r looks the same from all sides if its change, as the frame turns, is k x r
  for i = 1, 3 do
    if not ratio.iszero(turned_with(rate[i]) - along[i]) then return eq.groups end
  end
  for _, s in ipairs(m.states) do -- what moves or turns beside the body must not tell the frames apart
    if not string.find(s.name, "^[qw][wxyz]$") and not ratio.iszero(turned_with(slope[s.name])) then
      return eq.groups
    end
  end
  -- d(k x w)_i/dw_j is +-1 or 0, so this is the mean of the two entries of dw'/dw beside the diagonal, each with its
  -- sign
  local Omega = expr.zero
  for i = 1, 3 do
    for j = 1, 3 do -- w' = Omega k x w + ...: the part of the antisymmetric matrix about k
      if i ~= axis and j ~= axis and i ~= j then
        Omega = Omega + calculus.diff(turning[i], w[j]) * calculus.diff(rate[i], w[j]) / 2
      end
    end
  end
  for _, s in ipairs { w[axis % 3 + 1], w[(axis + 1) % 3 + 1] } do
    if calculus.diff(Omega, s) ~= expr.zero then return eq.groups end
  end
  local groups, s = {}, expr.sym("spin", 7)
  groups[1] = { defs = { { name = "spin", expr = (w[axis] - Omega) / 2 } }, outs = {} }
  for _, g in ipairs(eq.groups) do
    local copy = { defs = g.defs, outs = {} }
    for i, o in ipairs(g.outs) do
      local e = o.expr
      for n, name in ipairs(rates) do
        if o.state == name then e = e + s * turning[n] end
      end
      if string.find(o.state, "^q[wxyz]$") then e = calculus.substitute(e, { [w[axis]] = w[axis] - s }) end
      copy.outs[i] = { state = o.state, expr = e }
    end
    groups[#groups + 1] = copy
  end
  return groups, axis, groups[1].defs[1].expr, Omega
end

-- The heavy symmetric top, its axis k = z and the force along z in space: nothing but attitude and two rates moves, and
-- W' = i Omega W + K conj(a) b with W = wx + i wy, a = qw + i qz, b = qx + i qy.  Returns the constants of the text in
-- templates/steppers/taylor_top.c, or nil if the torque is another.
-- K is d^2 wx'/(d qw d qx), for Re(conj(a) b) = qw qx + qz qy; the imaginary part is qw qy - qz qx.
local function heavy(eq, Omega, moving)
  if #moving ~= 6 then return nil end
  local slope, q, w = {}, state.q, state.w
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do slope[o.state] = equations.inline(eq.groups, o.expr) end
  end
  local K = ratio.tidy(calculus.diff(calculus.diff(slope.wx, q[1]), q[2]))
  for _, s in ipairs(moving) do
    if not expr.constant(K, { [s.name] = true, t = true }) then return nil end
  end
  if K == expr.zero or not ratio.iszero(slope.wx + Omega * w[2] - K * (q[1] * q[2] + q[3] * q[4])) or
    not ratio.iszero(slope.wy - Omega * w[1] - K * (q[1] * q[3] - q[2] * q[4])) then
    return nil
  end
  local M = w[3] + Omega
  return { M, K, M / 4, Omega / 2 - M / 4 }
end

-- Free motion, a diagonal tensor: L is constant in space, so q' = q (0, w - lambda L)/2 for the attitude seen from a
-- frame that turns in space with lambda L, and lambda = 1/I2 leaves two components of the rate, 8 products of 12.
-- Returns the groups in that frame and d: lambda L = w - d w, component by component (d of the second axis is 0).
local function shifted(eq, groups)
  local m = eq.model
  if not (m.has.rates and m.has.attitude) or m.structure.kind ~= "diagonal" or eq.inputs then return groups end
  if m.frame or eq.turn then return groups end -- seen from axes that turn, L is not constant
  local I, w, rate, map = m.inertia, state.w, {}, {}
  for _, member in ipairs(m.members) do map[member.sym] = member.e end
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do rate[o.state] = equations.inline(eq.groups, o.expr) end
  end
  for _, s in ipairs(m.states) do -- a thrust that turns with the body must not be seen from another frame
    if s.kind ~= "attitude" and not expr.constant(rate[s.name], of_attitude) then return groups end
  end
  local torque = vec.cross(w, vec.apply(I, w)) -- I w' + w x L
  for i = 1, 3 do
    if not ratio.iszero(I[i] * calculus.substitute(rate[rates[i]], map) + torque[i]) then return groups end
  end
  local d = {}
  for _, i in ipairs { 1, 3 } do
    d[i] = m:constant("shift" .. i, expr.one - I[i] / I[2], "1 - I" .. i .. "/I2")
  end
  map = { [w[1]] = d[1] * w[1], [w[2]] = expr.zero, [w[3]] = d[3] * w[3] }
  local out = {}
  for n, g in ipairs(groups) do
    out[n] = { defs = g.defs, outs = {} }
    for i, o in ipairs(g.outs) do
      local e = o.expr
      if string.find(o.state, "^q[wxyz]$") then e = calculus.substitute(e, map) end
      out[n].outs[i] = { state = o.state, expr = e }
    end
  end
  return out, d
end

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
local function recurrences(list, groups, varying)
  local ok, made = pcall(series.new, list, groups, varying)
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

-- The recurrences of groups, laid out: moving: the states whose terms are wanted, {name, sym}; varying: their names.
-- Returns {order, states, roots = square roots of what may vanish, lanes, levels = {{first, last, variables}}, ...}, or
-- nil and why there is none.  Time is a state of its own, t' = 1.
local function laid_out(groups, moving, varying, order)
  local clock = expr.sym("t", 8)
  local list = { table.unpack(moving) }
  list[#list + 1] = { name = "t", sym = clock }
  local made, why = recurrences(list, groups, varying)
  if not made then return nil, why end
  made.slopes.t = { start = expr.one, term = expr.zero }
  local lanes, levels = by_level(made)
  numbered(made, lanes, levels)
  local roots = {}
  for _, v in ipairs(made.variables) do
    if v.root then roots[#roots + 1] = v end
  end
  return { order = order, term0 = series.FIRST, roots = roots, states = moving, variables = made.variables,
    lanes = lanes, levels = levels, slopes = made.slopes, constants = made.constants or {},
    read = readings(made, moving, lanes, clock) }
end

-- The same of the equations together with what neighbours along v depart by, the variational equations v' = f'(x) v:
-- state s has s_v beside it.  In `more`: those of states that keep their value and of inputs, which v holds beyond the
-- states.
local function tangent(eq, groups, moving, order)
  local m, known, states, varying, more = eq.model, {}, { table.unpack(moving) }, { t = true }, {}
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
  for _, s in ipairs(states) do varying[s.name] = true end
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
  local program, why = laid_out(out, states, varying, order)
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
  local zero, order = stages.conserved(eq), options.order or taylor.own_order[options.real or "double"]
  local varying, moving = { t = true }, {}
  for _, s in ipairs(eq.model.states) do
    if not zero[s.name] then
      varying[s.name] = true
      moving[#moving + 1] = s
    end
  end
  if #moving == 0 then return nil, stages.AT_REST end
  eq = separate(eq)
  local groups, axis, spin, Omega, shift, knots
  if switches then
    groups = eq.groups -- what has corners need not be the same from all sides
  else
    groups, axis, spin, Omega = despun(eq, zero)
    if not axis then groups, shift = shifted(eq, groups) end
  end
  groups, knots = straightened(eq, groups)
  local program, why = laid_out(groups, moving, varying, order)
  if not program then return nil, why end
  program.knots, program.axis, program.spin, program.shift = knots, axis, spin, shift
  program.switches = switches
  -- Lame's equation has the motion of unit quaternions; the derivatives by q are also those across |q| = 1
  program.top = axis == 3 and #knots == 0 and not options.jacobians and heavy(eq, Omega, moving) or nil
  if options.jacobians then
    program.transition, why = tangent(eq, straightened(eq, eq.groups), moving, order)
    if not program.transition then return nil, why end
    program.transition.knots = knots
  end
  return program
end

return taylor
