-- series.lua -- the equations of motion as recurrences for the Taylor coefficients of the state.
--
-- Every quantity y(t) that varies is a sequence y[0], y[1], ... with y = sum y[n] s^n.  Sums are sums of sequences; a
-- product is Cauchy's, (u v)[n] = sum over j of u[j] v[n-j]; other functions follow from the differential equations
-- that they satisfy (Knuth, TAOCP 2, 4.7; Jorba, Zou 2005, Experimental Mathematics 14, 99):
--     q = u/v         q[n] = (u[n] - sum j<n q[j] v[n-j])/v[0]
--     y = u^a         y[n] = (a sum j u[j] y[n-j] - sum' j y[j] u[n-j])/(n u[0])
--     y = exp u       y[n] = (sum j u[j] y[n-j])/n
--     s, c = sin u, cos u     s[n] = (sum j u[j] c[n-j])/n,  c[n] = -(sum j u[j] s[n-j])/n
--     y = log u       y[n] = (u[n] - (sum j<n j y[j] u[n-j])/n)/u[0]
-- and y' = g(y) u' for tan, tanh, atan and the like.  So the whole work is bilinear: lanes, each the sum of products of
-- two sequences (or of j times one), in levels such that a level needs the lanes below it only; a sequence's own newest
-- term, not known yet, stands as zero in its lanes.
--
-- Each rule is the coefficient of s^(n-1) or s^n in an identity.  For y = u^a the identity is u y' = a u' y: n u[0]
-- y[n] stays on the left, and the other j y[j] u[n-j] go to the right, the second lane beside the j u[j] y[n-j].  For
-- y = log u it is u y' = u'; for y = exp u, y' = y u'; for a quotient q v = u.  Only u[0], v[0] are ever divided by,
-- numbers during a step (`first`), so a step costs one division for each.
--
-- A variable of level l is made of lanes of level l, and these of variables below l (and of terms of its own before the
-- newest): so terms n are computed level by level.  Lanes of one level do not need each other, which is what lets them
-- run side by side (taylor.lua).  For the terms up to N a lane has N(N+1)/2 products.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local linear = require "generator.methods.linear"

local series = {}
series.__index = series

local form, put, times, expression = linear.form, linear.put, linear.times, linear.expression

-- A variable: {name, sym, level, form (linear, over variables of this or lower levels) | start, term (see below)}.
-- start: the expression of term 0, in the terms 0 of others; term: that of term n > 0, in the lanes and terms n.

local function new_variable(self, name, level)
  local taken = self.taken
  local unique, n = name, 1
  while taken[unique] do
    n = n + 1
    unique = name .. "_" .. n
  end
  taken[unique], taken[unique .. "0"] = true, true -- its term 0 is called so
  local v = { name = unique, sym = expr.sym(unique, 8), level = level, weighted = false }
  self.variables[#self.variables + 1] = v
  self.by_sym[v.sym] = v
  return v
end

-- The lane sum over j of a[j] b[n-j]; weighted: of j a[j] b[n-j].  Returns its symbol, p0, p1 ...
local function lane(self, a, b, level, weighted)
  if not weighted and a.name > b.name then a, b = b, a end
  local key = a.name .. (weighted and "'*" or "*") .. b.name
  local known = self.lane_of[key]
  if not known then
    known = { a = a, b = b, weighted = weighted or false, level = level }
    known.sym = expr.sym("lane " .. key, 8)
    self.lane_of[key] = known
    self.lanes[#self.lanes + 1] = known
  end
  return known.sym
end

-- ---- linear forms as variables ---------------------------------------------------------------------------------

-- A form as one variable and a constant factor, which is 1 if `whole` is 1, a number's power if it is q > 1, and
-- anything if it is nil.  Forms that are equal are one variable.  A factor stays outside where it costs nothing: it
-- multiplies what is made of the variable, and not each of its terms.  So does the scale of a sum of long whole
-- numbers, which are what decimals become when algebra clears denominators: its powers would leave float.
local function single(self, f, name, whole)
  local factor = f.of[f.vars[1]]
  if #f.vars == 1 and f.constant == expr.zero and (factor == expr.one or not whole) then return f.vars[1], factor end
  local scale = whole == 1 and 0 or linear.long(f, whole or 1)
  if scale ~= 0 then
    factor = expr.num(R.new(10) ^ scale)
    return single(self, times(expr.one / factor, f), name, 1), factor
  end
  local key = expression(f, true)
  local v = self.linear[key]
  if not v then
    v = new_variable(self, name or "sum", linear.level(f))
    v.start, v.term = key, expression(f, false)
    self.linear[key] = v
  end
  return v, expr.one
end

-- ---- expressions ---------------------------------------------------------------------------------------------------

local of

local order = expr.sym("order", 8) -- n, as a number

-- a b: its lane needs both, so it is one level above them
local function multiplied(self, a, b)
  local v = new_variable(self, a.name .. "_" .. b.name, math.max(a.level, b.level) + 1)
  v.start = a.sym * b.sym
  v.term = lane(self, a, b, v.level)
  return v
end

-- A function of the variable u with the value `start` and term n > 0 from term(y, level).
local function defined(self, key, name, level, start, term)
  local y = self.functions[key]
  if not y then
    y = new_variable(self, name, level)
    self.functions[key] = y
    y.start = start
    y.term = term(y)
  end
  return y
end

-- u^a, by u y' = a u' y
local function power(self, u, a)
  local level = u.level + 1
  local root = R.sign(a) > 0 and not R.isint(a) and R.isint(a * R.new(2)) -- not negative, whatever u does
  return defined(self, "power " .. tostring(a) .. " " .. u.name, "power", level, u.sym ^ a, function(y)
    -- (taylor.lua lists such variables: a term n > 0 divides by u[0], which may be 0)
    y.root = root
    local up, down = lane(self, u, y, level, true), lane(self, y, u, level, true)
    return (a * up - down) / (order * self:first(u))
  end)
end

-- u/v, by y v = u: only v stands in a lane, u may be of the same level
local function quotient(self, u, v)
  local level = math.max(u.level, v.level + 1, 1)
  return defined(self, "quotient " .. u.name .. " " .. v.name, "quotient", level, u.sym / v.sym, function(y)
    return (u.sym - lane(self, y, v, level)) / self:first(v)
  end)
end

local functions = {}

function functions.exp(self, u)
  local level = u.level + 1
  return defined(self, "exp " .. u.name, "exponential", level, expr.call("exp", u.sym), function(y)
    return lane(self, u, y, level, true) / order
  end)
end

-- sin and cos, or sinh and cosh: sign of c' = sign s u'
local function pair(self, u, names, sign)
  local level = u.level + 1
  local key = names[1] .. " " .. u.name
  local s = self.functions[key]
  if not s then
    s = new_variable(self, names[3], level)
    local c = new_variable(self, names[4], level)
    s.start, c.start = expr.call(names[1], u.sym), expr.call(names[2], u.sym)
    s.term = lane(self, u, c, level, true) / order
    c.term = sign * lane(self, u, s, level, true) / order
    self.functions[key], self.functions[names[2] .. " " .. u.name] = s, c
  end
end

for _, row in ipairs { { "sin", "cos", "sine", "cosine", -1 }, { "sinh", "cosh", "sine_h", "cosine_h", 1 } } do
  for _, fn in ipairs { row[1], row[2] } do
    functions[fn] = function(self, u)
      pair(self, u, row, expr.lift(row[5]))
      return self.functions[fn .. " " .. u.name]
    end
  end
end

function functions.log(self, u)
  local level = u.level + 1
  return defined(self, "log " .. u.name, "logarithm", level, expr.call("log", u.sym), function(y)
    return (u.sym - lane(self, y, u, level, true) / order) / self:first(u)
  end)
end

-- y' = g u' with g a variable that is known to the terms below n when y[n] is: g[j], j < n, serves n y[n] =
-- sum (n - j) u[n-j] g[j].
local function integral(self, fn, name, u, derivative)
  local key = fn .. " " .. u.name
  local y = self.functions[key]
  if y then return y end
  local g = derivative()
  local level = math.max(u.level, g.level) + 1
  y = new_variable(self, name, level)
  self.functions[key] = y
  y.start, y.term = expr.call(fn, u.sym), lane(self, u, g, level, true) / order
  return y
end

-- constant + sign u^2, as a variable
local function square_plus(self, u, constant, sign)
  local v = new_variable(self, "square", u.level + 1)
  v.start, v.term = constant + sign * u.sym ^ 2, sign * lane(self, u, u, v.level)
  return v
end

function functions.atan(self, u)
  return integral(self, "atan", "arc", u, function()
    return power(self, square_plus(self, u, expr.one, expr.one), R.lift(-1))
  end)
end

local function arc(fn, sign)
  functions[fn] = function(self, u)
    return integral(self, fn, "arc", u, function()
      local root = power(self, square_plus(self, u, expr.one, expr.lift(-1)), R.new(-1, 2))
      if sign > 0 then return root end
      local v = new_variable(self, "slope", root.level)
      v.start, v.term = -root.sym, -root.sym
      return v
    end)
  end
end
arc("asin", 1)
arc("acos", -1)

-- y' = (1 + sign y^2) u': the square's own newest term is not needed, for u' has none of order 0.
local function self_square(fn, name, sign)
  functions[fn] = function(self, u)
    local level = u.level + 1
    return defined(self, fn .. " " .. u.name, name, level, expr.call(fn, u.sym), function(y)
      -- y[n] is not known yet and stands as 0 in the lane: 2 y[0] y[n] is what it lacks
      local g = new_variable(self, "slope", level)
      g.start, g.term = expr.one + sign * y.sym ^ 2, sign * (lane(self, y, y, level) + 2 * self:first(y) * y.sym)
      return lane(self, u, g, level, true) / order
    end)
  end
end
self_square("tan", "tangent", 1)
self_square("tanh", "tangent_h", -1)

-- Factors of a product or a power as {variable, exponent}; numbers and constants into the coefficient.
local function product(self, e)
  local coefficient, rest = expr.one, {}
  for _, f in ipairs(e.kind == "mul" and e or { e }) do
    if self:steady(f) then
      coefficient = coefficient * f
    else
      local base, exponent = f, R.one
      if f.kind == "pow" then base, exponent = f.base, f.exp end
      local v, c = single(self, of(self, base), nil, not R.isint(exponent) and R.toint(R.den(exponent)) or nil)
      coefficient = coefficient * c ^ exponent
      rest[#rest + 1] = { v, exponent }
    end
  end
  return coefficient, rest
end

-- c times the linear form of x: a factor that is steady during the step costs no lane.
local function scaled(self, c, x)
  return times(c, of(self, x))
end

-- The linear form of a product or a power.  Powers up to 4 are products, one lane each, which are right where the base
-- passes zero; others divide by it (power).  Denominators are multiplied with each other first: one quotient.
local function multiply_out(self, e)
  if e.kind == "mul" then
    local steady, moving = {}, {}
    for _, f in ipairs(e) do
      local list = self:steady(f) and steady or moving
      list[#list + 1] = f
    end
    if #moving == 1 and (moving[1].kind ~= "pow") then return scaled(self, expr.mul(steady), moving[1]) end
  end
  local coefficient, rest = product(self, e)
  local over, under = {}, {}
  for _, r in ipairs(rest) do
    local v, exponent = r[1], r[2]
    local n = R.isint(exponent) and R.toint(exponent) or nil
    if n and n > 0 and n <= 4 then
      for _ = 1, n do over[#over + 1] = v end
    elseif n == -1 and #rest > 1 then
      under[#under + 1] = v
    else
      over[#over + 1] = power(self, v, exponent)
    end
  end
  -- the product of a list of variables, two at a time
  local function chain(list)
    local v = list[1]
    for i = 2, #list do
      local key = v.name .. " times " .. list[i].name
      self.functions[key] = self.functions[key] or multiplied(self, v, list[i])
      v = self.functions[key]
    end
    return v
  end
  local v = chain(over)
  if #under > 0 then v = v and quotient(self, v, chain(under)) or power(self, chain(under), R.lift(-1)) end
  local f = form(expr.zero)
  put(f, v, coefficient)
  return f
end

-- The linear form of an expression.
function of(self, e)
  local known = self.memo[e]
  if known then return known end
  local f
  if self:steady(e) then
    f = form(e)
  elseif e.kind == "sym" then
    f = form(expr.zero)
    put(f, self.by_sym[e] or error("series: unknown symbol " .. e.name), expr.one)
  elseif e.kind == "add" then
    f = form(expr.zero)
    for i = 1, #e do
      local g = of(self, e[i])
      f.constant = f.constant + g.constant
      for _, v in ipairs(g.vars) do put(f, v, g.of[v]) end
    end
  elseif e.kind == "call" then
    local rule = functions[e.fn]
    if not rule then error(setmetatable({ fn = e.fn }, series.missing)) end
    local u = single(self, of(self, e[1]), "angle", 1)
    f = form(expr.zero)
    put(f, rule(self, u), expr.one)
  else
    f = multiply_out(self, e)
  end
  self.memo[e] = f
  return f
end

-- Raised for a function that has no recurrence here: {fn}.
series.missing = {}

-- Does e keep its value during a step?
function series:steady(e) return expr.constant(e, self.varying) end

-- Term 0 of a variable is called by this and the variable's name: no state or parameter of an effect has a digit.
series.FIRST = "n0_"

-- Term 0 of a variable, a number during the step.
function series.first(_, v)
  v.first = true
  return expr.sym(series.FIRST .. v.name, 8)
end

-- The recurrences of equations: states: {name, sym} in order, all of which change during a step; groups as in
-- dynamics/equations.lua.
-- Returns {variables, lanes, slopes = {state name -> {start, term}}, levels}.
function series.new(states, groups)
  local self = setmetatable({ variables = {}, lanes = {}, lane_of = {}, by_sym = {}, linear = {}, functions = {},
    memo = {}, taken = { order = true, n = true, j = true, r = true }, varying = {}, slopes = {} }, series)
  for _, s in ipairs(states) do
    local v = { name = s.name, sym = s.sym, level = 0, state = true }
    self.varying[s.name], self.taken[s.name], self.taken[s.name .. "0"] = true, true, true
    self.variables[#self.variables + 1], self.by_sym[s.sym] = v, v
  end
  for _, g in ipairs(groups) do
    for _, d in ipairs(g.defs) do
      local sym = expr.sym(d.name, 7)
      if self:steady(d.expr) then
        self.constants = self.constants or {}
        self.constants[#self.constants + 1] = d
      else
        self.varying[d.name] = true
        local v, c = single(self, of(self, d.expr), d.name)
        local g2 = form(expr.zero)
        put(g2, v, c)
        self.memo[sym] = g2
      end
    end
    for _, o in ipairs(g.outs) do
      local f = of(self, o.expr)
      self.slopes[o.state] = { start = expression(f, true), term = expression(f, false) }
    end
  end
  return self
end

return series
