-- rosenbrock.lua -- Rodas5P: a linearly implicit method of order 5 with 8 stages, for stiff equations.
--
--     (1/(h g) 1 - J) k_i = f(t + c_i h, x + sum a_ij k_j) + sum (C_ij/h) k_j + h d_i df/dt
--     x(t + h) = x + sum a_8j k_j + k_8
-- with J = df/dx.  It is L-stable: what decays fast is damped at any step.  x + sum a_8j k_j has order 4, so k_8 is the
-- error.  Source: Steinebach 2023, BIT Numerical Mathematics 63, 27; the form without products by J is that of Hairer,
-- Wanner, Solving ODEs II (2nd ed.), IV.7.
--
-- A Rosenbrock method loses its order where the fast part of f vanishes on a curved set: friction on a plane decays to
-- slip = v + a(q, w) = 0, and a is not linear.  So the velocity's place is taken by the slip itself: in the states z =
-- (q, w, .., slip) the fast part is linear in z but for what changes slowly, and the order is kept at any friction.
-- The matrix is factored without pivots, L U by the structure of what is not zero (derived here, Markowitz 1957 by
-- diagonal entries).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local breaks = require "generator.dynamics.breaks"
local constancy = require "generator.dynamics.constancy"
local contact = require "generator.dynamics.contact"
local equations = require "generator.dynamics.equations"
local sensitivity = require "generator.dynamics.sensitivity"
local state = require "generator.dynamics.state"
local switching = require "generator.dynamics.switching"
local floors = require "generator.methods.floors"
local stages = require "generator.methods.stages"
local factored = require "generator.methods.factored"

local rosenbrock = { name = "rosenbrock", order = 5, adaptive = true, stiff = true,
  needs = { { path = "slip for velocity", needs = "a plane is touched; the velocity along it stands nowhere before " ..
    "the definition that adds a function of the other states to it" } },
  about = "linearly implicit Rodas5P, order 5, for stiff effects, step from a tolerance" }

local function rows(list)
  for i, row in ipairs(list) do
    for k, x in ipairs(row) do row[k] = R.lift(x) end
    list[i] = row
  end
  return list
end

rosenbrock.tableau = {
  gamma = R.lift "0.21193756319429014",
  a = rows { {}, { "3" }, { "2.849394379747939", "0.45842242204463923" },
    { "-6.954028509809101", "2.489845061869568", "-10.358996098473584" },
    { "2.8029986275628964", "0.5072464736228206", "-0.3988312541770524", "-0.04721187230404641" },
    { "-7.502846399306121", "2.561846144803919", "-11.627539656261098", "-0.18268767659942256",
      "0.030198172008377946" },
    { "-7.502846399306121", "2.561846144803919", "-11.627539656261098", "-0.18268767659942256",
      "0.030198172008377946", "1" },
    { "-7.502846399306121", "2.561846144803919", "-11.627539656261098", "-0.18268767659942256",
      "0.030198172008377946", "1", "1" } },
  C = rows { {}, { "-14.155112264123755" }, { "-17.97296035885952", "-2.859693295451294" },
    { "147.12150275711716", "-1.41221402718213", "71.68940251302358" },
    { "165.43517024871676", "-0.4592823456491126", "42.90938336958603", "-5.961986721573306" },
    { "24.854864614690072", "-3.0009227002832186", "47.4931110020768", "5.5814197821558125", "-0.6610691825249471" },
    { "30.91273214028599", "-3.1208243349937974", "77.79954646070892", "34.28646028294783", "-19.097331116725623",
      "-28.087943162872662" },
    { "37.80277123390563", "-3.2571969029072276", "112.26918849496327", "66.9347231244047", "-40.06618937091002",
      "-54.66780262877968", "-9.48861652309627" } },
  c = rows { { "0", "0.6358126895828704", "0.4095798393397535", "0.9769306725060716", "0.4288403609558664", "1", "1",
    "1" } }[1],
  d = rows { { "0.21193756319429014", "-0.42387512638858027", "-0.3384627126235924", "1.8046452872882734",
    "2.325825639765069", "0", "0", "0" } }[1],
}

local RANK = 8

-- Of a state that a definition adds a function of the other states to, and that nothing before it mentions: the number
-- of that definition's group, the definition's place in it, and the function.
local function slip(eq, s)
  for i, g in ipairs(eq.groups) do
    for k, d in ipairs(g.defs) do
      if calculus.diff(d.expr, s.sym) == expr.one then return { group = i, place = k, rest = d.expr - s.sym } end
      if not expr.constant(d.expr, { [s.name] = true }) then return nil end
    end
  end
end

-- The velocities along a plane that slips: a list of {state, name of the velocity, group, place (of the definition of
-- the slip), rest (slip = velocity + rest)}.
local function slips(eq)
  local list = {}
  if not (contact.of(eq.model) and eq.touch) then return list end
  for _, s in ipairs(eq.model.states) do
    local found = string.match(s.name, "^v[12]$") and slip(eq, s)
    if found then
      found.state, found.name = s, "go_" .. s.name
      list[#list + 1] = found
    end
  end
  return list
end
rosenbrock.slips = slips

-- The equations with the slip for the velocity: groups of definitions, and the rates by state name.
local function in_slips(eq, list)
  local map, groups, rates = {}, {}, {}
  local at = {}
  for _, x in ipairs(list) do at[x.group .. " " .. x.place] = x end
  for i, g in ipairs(eq.groups) do
    local own = { why = g.why, where = g.where, defs = {}, outs = {} }
    for k, d in ipairs(g.defs) do
      local x = at[i .. " " .. k]
      if x then
        own.defs[#own.defs + 1] = { name = d.name, expr = x.state.sym }
        own.defs[#own.defs + 1] = { name = x.name, expr = x.state.sym - calculus.substitute(x.rest, map) }
        map[x.state.sym] = expr.sym(x.name, RANK)
      else
        own.defs[#own.defs + 1] = { name = d.name, expr = calculus.substitute(d.expr, map) }
      end
    end
    for _, o in ipairs(g.outs) do rates[o.state] = { group = own, expr = calculus.substitute(o.expr, map) } end
    groups[i] = own
  end
  return groups, rates
end

-- To the groups: how fast what is added to each velocity changes along the motion.
local function changing(eq, list, groups, rates, taken)
  local known = { [state.t] = expr.one }
  for _, s in ipairs(eq.model.states) do
    local rate = rates[s.name]
    if rate then
      local name = "rate_" .. s.name
      rate.group.defs[#rate.group.defs + 1] = { name = name, expr = rate.expr }
      rate.expr = expr.sym(name, RANK)
      known[s.sym] = rate.expr
    end
  end
  local time = { { name = "dt", sym = expr.sym("dt", RANK) } }
  local g = { why = "how fast the slip changes: v' and what the turning of the contact point changes by", defs = {},
    outs = {} }
  local sofar = {}
  for _, group in ipairs(eq.groups) do
    for _, d in ipairs(group.defs) do sofar[#sofar + 1] = d end
  end
  local made = sensitivity.follow(sofar, time, { known }, taken)
  local old = {}
  for _, d in ipairs(sofar) do old[d] = true end
  for _, d in ipairs(made) do
    if not old[d] then g.defs[#g.defs + 1] = d end
  end
  for _, x in ipairs(list) do
    rates[x.state.name] = { group = g, expr = rates[x.state.name].expr + calculus.diff(x.rest, time[1].sym, known) }
  end
  groups[#groups + 1] = g
end

-- Only the definitions that the results mention, directly or by others.
local function needed(groups, results)
  local by, keep = {}, {}
  for _, g in ipairs(groups) do
    for _, d in ipairs(g.defs) do by[d.name] = d end
  end
  local function mark(e)
    for _, s in ipairs(expr.symbols(e)) do
      local d = by[s.name]
      if d and not keep[d] then
        keep[d] = true
        mark(d.expr)
      end
    end
  end
  for _, e in ipairs(results) do mark(e) end
  local list = {}
  for i, g in ipairs(groups) do
    local own = { why = g.why, where = g.where, defs = {}, outs = g.outs or {} }
    for _, d in ipairs(g.defs) do own.defs[#own.defs + 1] = keep[d] and d or nil end
    list[i] = own
  end
  return list
end

-- The derivatives of the rates by the states and by the time: groups, J[i][k], and df/dt by i.
local function derivatives(groups, rates, moving, taken)
  local columns = {}
  for i, s in ipairs(moving) do columns[i] = s end
  columns[#columns + 1] = { name = "t", sym = state.t }
  local known, out = sensitivity.nothing(columns), {}
  for i, g in ipairs(groups) do
    out[i] = { why = g.why .. "; and its derivatives", where = g.where, outs = {},
      defs = sensitivity.follow(g.defs, columns, known, taken) }
  end
  local J, by_time = {}, {}
  local slope, time = {}, calculus.by(state.t, known[#columns])
  for k = 1, #moving do slope[k] = calculus.by(columns[k].sym, known[k]) end
  for i, s in ipairs(moving) do
    J[i] = {}
    for k = 1, #moving do J[i][k] = slope[k](rates[s.name].expr) end
    by_time[i] = time(rates[s.name].expr)
  end
  return out, J, by_time
end

-- What is added to each velocity, a[i].
local function shifts(eq, list)
  local a = { why = "slip = v + what the body's turning adds at the contact point", defs = {}, outs = {} }
  for i, x in ipairs(list) do
    a.outs[i] = { array = "a", index = i - 1, expr = equations.inline(eq.groups, x.rest) }
  end
  return { a }
end

-- {tableau, states = that move, slips, shifts = groups of what the slip adds to the velocity, rates = groups of f,
-- matrix = groups of the factors and df/dt, factors = their entries, solve = groups, timed = does f depend on t?,
-- knots, switches (dynamics/switching.lua) or nil}, or nil and why there is none.
function rosenbrock.program(eq)
  local switches, whole = switching.of(eq), eq
  if switches then eq = switches.equations end
  local moving, taken = constancy.moving(eq), {}
  for _, member in ipairs(eq.model.members) do taken[member.name] = true end
  for _, s in ipairs(eq.model.states) do taken[s.name] = true end
  if #moving == 0 then return nil, stages.AT_REST end
  local list = slips(eq)
  local groups, rates = in_slips(eq, list)
  if #list > 0 then changing(eq, list, groups, rates, taken) end
  local results = {}
  for i, s in ipairs(moving) do results[i] = rates[s.name].expr end
  groups = needed(groups, results)
  local last = { why = "the rates", defs = {}, outs = {} }
  for i, s in ipairs(moving) do last.outs[i] = { array = "dz", index = i - 1, expr = rates[s.name].expr } end
  local f = { table.unpack(groups) }
  f[#f + 1] = last
  local matrix, J, by_time = derivatives(groups, rates, moving, taken)
  local lu = factored.of(moving, J, expr.sym("n", 6))
  local entries = {}
  for _, e in ipairs(lu.entries) do entries[#entries + 1] = e end
  local timed = false
  for _, e in ipairs(by_time) do
    timed = timed or e ~= expr.zero
    entries[#entries + 1] = e
  end
  matrix = needed(matrix, entries)
  for _, g in ipairs(lu.groups) do matrix[#matrix + 1] = g end
  if timed then
    local g = { why = "the derivative by the time", defs = {}, outs = {} }
    for i, e in ipairs(by_time) do g.outs[i] = { array = "dt", index = i - 1, expr = e } end
    matrix[#matrix + 1] = g
  end
  return { tableau = rosenbrock.tableau, states = moving, slips = list, rates = f, matrix = matrix,
    factors = lu.names, solve = lu.solve, timed = timed, shifts = shifts(eq, list), knots = breaks.knots(eq),
    switches = switches, floors = floors.of(whole) }
end

return rosenbrock
