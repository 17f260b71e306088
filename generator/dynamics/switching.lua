-- switching.lua -- what changes sign where the equations of motion are not smooth, and the equations between.
--
-- |e|, sign(e), min, max, limits and the lit side of a plate each have a function g of the state and the time whose
-- sign says which of two smooth forms holds.  Between the zeros of all g the equations with these signs as numbers
-- (`branch`) are smooth, and a step of any method that ends at a zero keeps its order: the steppers with a tolerance
-- look for the zeros (templates/steppers/switched.c).  Source: Hairer, Norsett, Wanner I, section II.6.
-- A speed |s| = sqrt(s.s), with a least square beside it or not, has no two forms: it turns sharply where it is least
-- and small ("bend").  Its g is s.s + h d(s.s)/dt, h the step: below 0 where the speed falls so fast that nothing would
-- be left within the step, and back above 0 close to where it is least.  A speed that keeps its size has no bend, and
-- the roundings of its rate are none.
-- The corners of tables over time are at known times: knots of breaks.lua, and not here.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local expression = require "generator.formula.expression"
local words = require "generator.formula.text"
local breaks = require "generator.dynamics.breaks"
local constancy = require "generator.dynamics.constancy"
local equations = require "generator.dynamics.equations"

local switching = {}

local RANK = 8
local smallest = R.new(2) ^ -126 -- what |e| = sqrt(e^2 + smallest) has beside e^2: effects/solar_pressure.lua

-- sqrt(e^2 + smallest) is |e|: returns e, or nil.
local function smoothed(u)
  if u.kind ~= "pow" or u.exp ~= R.half or u.base.kind ~= "add" then return nil end
  local square = u.base - expr.num(smallest)
  local c, bar = expr.split(#u.base == 2 and square ~= expr.zero and expr.sqrt(square) or expr.zero)
  return bar.kind == "call" and bar.fn == "abs" and c * bar[1] or nil
end

-- The square of a speed under a root: of rates, nothing else beside them that changes.  Second result: is the root's
-- series that of a length, which shows where it vanishes (templates/steppers/taylor_corners.c)?
local function speed(u, moves)
  if u.kind ~= "pow" or R.den(u.exp) ~= R.new(2) or u.base.kind ~= "add" then return nil end
  local least, beside
  for _, term in ipairs(u.base) do
    local c, square = expr.split(term)
    if square.kind == "pow" and square.exp == R.new(2) and moves.states[square.base] and R.sign(c) > 0 then
      least = (not least or c < least) and c or least
    elseif expr.constant(term, moves.names) then
      beside = term
    else
      return nil
    end
  end
  local bare = not beside or least and beside.kind == "num" and R.abs(beside.value) <= least * smallest
  return least and u.base or nil, R.sign(u.exp) > 0 and bare
end

-- What is gathered: list = {g, about, branch = its symbol, or bend = true}, by what it is.
local function gathering(eq)
  local name = "branch"
  local taken = eq.model.by_name or {}
  while taken[name] or taken[name .. "0"] do name = name .. "_" end
  return { name = name, list = {}, bends = {}, bare = {}, by = {} }
end

-- The sign of e as an expression of the numbers of branches.
local function sign_of(self, e, about)
  local c, rest = expr.split(e)
  local known = self.by[rest]
  if not known then
    known = { g = rest, about = about, branch = expr.sym(self.name .. #self.list, RANK) }
    self.by[rest] = known
    self.list[#self.list + 1] = known
  end
  return R.sign(c) < 0 and -known.branch or known.branch
end

-- f(arguments) between the corners: {fn -> form}
local forms = {
  abs = function(sign, e) return sign(e) * e end,
  sign = function(sign, e) return sign(e) end,
  side = function(sign, e) return sign(e) end,
  min = function(sign, a, b)
    local s = sign(a - b)
    return (1 - s) / 2 * a + (1 + s) / 2 * b
  end,
  max = function(sign, a, b)
    local s = sign(a - b)
    return (1 + s) / 2 * a + (1 - s) / 2 * b
  end,
  clamp = function(sign, x, low, high)
    local above, below = sign(x - low), sign(high - x)
    return (1 + above) / 2 * ((1 + below) / 2) * x + (1 - above) / 2 * low + (1 - below) / 2 * high
  end,
}

-- The function e -> e between the corners.
local function opened(self, eq)
  local names, states, memo, knots = constancy.varying(eq), {}, {}, {}
  for _, s in ipairs(eq.model.states) do
    states[s.sym] = names[s.name] and s.kind and s.kind ~= "attitude" and s.kind ~= "position"
  end
  for _, k in ipairs(breaks.knots(eq)) do
    for _, set in ipairs { k.bars, k.signs } do
      for e in pairs(set) do knots[e] = true end -- a set: order is lost
    end
  end
  local function open(u)
    if memo[u] then return memo[u] end
    local v
    if knots[u] or expr.constant(u, names) then
      v = u
    elseif u.kind == "call" and forms[u.fn] then
      local args = {}
      for i = 1, #u do args[i] = open(u[i]) end
      v = forms[u.fn](function(e) return sign_of(self, e, u) end, table.unpack(args))
    elseif smoothed(u) then
      local e = open(smoothed(u))
      v = sign_of(self, e, expr.call("abs", smoothed(u))) * e
    else
      local square, bare = speed(u, { names = names, states = states })
      if square and not self.by[square] then
        self.by[square] = { about = u, square = square, bend = true, bare = bare }
        local list = bare and self.bare or self.bends
        list[#list + 1] = self.by[square]
      end
      v = expr.map(u, open)
    end
    memo[u] = v
    return v
  end
  return open
end

-- square + h d square/dt: the states' rates times the step h are numbers of an array `v`.
local function falling(eq, square)
  local sum = square
  for _, s in ipairs(eq.model.states) do
    sum = sum + calculus.diff(square, s.sym) * expr.sym("v" .. s.name, RANK)
  end
  return sum
end

-- Is every g with a side affine in the states and time, for all values of the branches?
local function affine(self, groups, states)
  local names, symbols, inlined = { t = true }, { expr.sym("t", 8) }, equations.inlined(groups)
  for i, s in ipairs(states) do names[s.name], symbols[i + 1] = true, s.sym end
  for i = 1, self.count do
    local g = inlined(self.list[i].g)
    for _, s in ipairs(symbols) do
      if not expr.constant(calculus.diff(g, s), names) then return false end
    end
  end
  return true
end

-- Nil where the equations are smooth but for knots.  Else {name = of the array of branches, list = {g, about, branch or
-- bend}, bends after all that have branches and of them last those that a series shows, count = of branches, hidden =
-- without these last ones, affine = are the g with branches, equations = the equations between the corners}.
function switching.of(eq)
  local self, groups = gathering(eq), {}
  local open = opened(self, eq)
  for i, g in ipairs(eq.groups) do
    local own = { why = g.why, where = g.where, defs = {}, outs = {} }
    for k, d in ipairs(g.defs) do own.defs[k] = { name = d.name, expr = open(d.expr) } end
    for k, o in ipairs(g.outs) do own.outs[k] = { state = o.state, expr = open(o.expr) } end
    groups[i] = own
  end
  self.count = #self.list
  self.hidden = self.count + #self.bends
  for _, list in ipairs { self.bends, self.bare } do
    for _, b in ipairs(list) do
      b.g = falling(eq, b.square)
      self.list[#self.list + 1] = b
    end
  end
  if #self.list == 0 then return nil end
  self.affine = affine(self, groups, eq.model.states)
  self.equations = setmetatable({ groups = groups }, { __index = eq })
  return self
end

-- The speed of a square, by its components.
local function speed_in_words(square)
  local list = {}
  for _, term in ipairs(square) do
    local _, part = expr.split(term)
    if part.kind == "pow" then list[#list + 1] = words.of(part.base) end
  end
  return "the speed of " .. table.concat(list, ", ")
end

-- What has the corner, in words.
function switching.about(s)
  local what = s.bend and speed_in_words(s.square) or words.of(s.about)
  if #what > 60 then what = s.bend and "a speed" or expression.called(s.about.fn) .. "(...)" end
  return s.bend and what .. ", where it is least" or what
end

-- What passes 0 where the equations have corners, of parameters, states and time: a list.  Where a speed is least they
-- are smooth, unless it vanishes: bends are not here.
function switching.corners(eq)
  local own = equations.fork(eq)
  local self, list, sides = switching.of(own), {}, {}
  if not self then return list end
  local inlined, numbers = equations.inlined(self.equations.groups), calculus.substitution(breaks.constants(own.model))
  for i = 1, self.count do
    local s = self.list[i] -- what stands in others comes before them
    list[i] = numbers(calculus.substitute(inlined(s.g), sides))
    sides[s.branch] = expr.call("side", list[i])
  end
  return list
end

-- How many corners there are, and their values in doubles: values(time, x) at a state as the scene lists it, for the
-- parameters' defaults and inputs that are 0.
function switching.values(eq)
  local corners, env = switching.corners(eq), {}
  for _, p in ipairs(eq.model.params) do env[p.name] = R.todouble(p.default) end
  for _, u in ipairs(eq.model.inputs) do env[u.name] = 0.0 end
  return #corners, function(time, x)
    env.t = time
    for i, s in ipairs(eq.model.states) do env[s.name] = x[i] end
    local list = {}
    for k, e in ipairs(corners) do list[k] = evaluate.double(e, env) end
    return list
  end
end

return switching
