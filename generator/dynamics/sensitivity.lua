-- sensitivity.lua -- derivatives that are emitted on request (gen --with jacobians), as function descriptions.
--
--     jacobian_u          df/du of the equations of motion x' = f(t, x, u; p)
--     jacobian_p          df/dp: f depends on the parameters by way of the derived constants c(p) alone, so it is the
--                         sum of df/dc dc/dp; the dc/dp are derived constants themselves, computed by NAME_init
--     initial_p           dx(0)/dp, so that S' = (df/dx) S + df/dp can be integrated from the start
--     energy_gradient     and the like: derivatives of what is made of the state, for what is linearised as a whole
--     STEP_transition     the step and d x(t + h)/d x(t): every named quantity is followed by its derivatives
--                         (the tangent of the discrete map itself, exact for any h, not a solution of S' = J S)
--     STEP_transition_u   d x(t + h)/d u in the same way, the input held during the step
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local equations = require "generator.dynamics.equations"

local sensitivity = {}

-- rows and columns in the header's own names
local function array(name, count, rows, columns)
  return { name = name, count = count, out = true, size = { rows, columns } }
end

-- A matrix of rows by states; entry(e, k, state) is the derivative of that state's rate e.
local function of_rates(eq, name, columns, entry)
  local m, groups, row = eq.model, {}, {}
  for i, s in ipairs(m.states) do
    row[s.name] = i
    groups[i] = { why = "derivatives of d" .. s.name .. "/dt", defs = {}, outs = {} }
  end
  for _, eg in ipairs(eq.groups) do
    for _, o in ipairs(eg.outs) do
      local e, i = equations.inline(eq.groups, o.expr), row[o.state]
      for k = 1, columns do
        groups[i].outs[k] = { array = name, index = (i - 1) * columns + k - 1, expr = entry(e, k) }
      end
    end
  end
  return groups
end

-- inputs: the list of {name, sym} in the order of u.
function sensitivity.by_input(eq, inputs)
  if not eq.inputs then return nil end
  local n = #inputs
  return { name = "jacobian_u", args = { "m", "t", "x", "u", array("J", #eq.model.states * n, "NX", "NU") },
    doc = { "Derivative of the equations of motion by the input, row major, NX x NU:",
      "J[i*NU + k] = d(dx[i])/d(u[k])." },
    groups = of_rates(eq, "J", n, function(e, k) return calculus.diff(e, inputs[k].sym) end) }
end

local place = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } -- of the entries xx yy zz xy xz yz

-- The derivative by p of an entry of J = I^-1 in the entries themselves, dJ = -J dI J: one product of each, where the
-- quotient's own derivative has the determinant squared, which is I^6 and underflows for a body of some grams.
local function of_inverse(m, inverse, p)
  local function J(i, k)
    for n, at in ipairs(place) do
      if at[1] == math.min(i, k) and at[2] == math.max(i, k) then return inverse.J[n] end
    end
  end
  local at, sum = place[inverse.entry], expr.zero
  for n, e in ipairs(m.carried) do
    local d, i, k = calculus.diff(e, p.sym), place[n][1], place[n][2]
    if d ~= expr.zero then
      local term = J(at[1], i) * J(k, at[2])
      if i ~= k then term = term + J(at[1], k) * J(i, at[2]) end
      sum = sum - d * term
    end
  end
  return sum
end

-- The derivative of the derived constants by the parameter p: known[symbol] for calculus.diff, made when asked for.
function sensitivity.by_parameter(m, p)
  return setmetatable({}, { __index = function(known, sym)
    local member = m.by_name[sym.name]
    local d = expr.zero
    if member and member.sym == sym and member.e then
      d = m:constant("d" .. member.name .. "_d" .. p.name, calculus.diff(member.e, p.sym), "d " .. member.name ..
        "/d " .. p.name, m.parts ~= nil, member.inverse and not m.parts and of_inverse(m, member.inverse, p) or nil)
    end
    known[sym] = d
    return d
  end })
end

-- jacobian_p and initial_p; nil without parameters.
function sensitivity.by_parameters(eq)
  local m, known = eq.model, {}
  local n = #m.params
  if n == 0 then return nil end
  for k, p in ipairs(m.params) do known[k] = sensitivity.by_parameter(m, p) end
  local rates = of_rates(eq, "J", n, function(e, k) return calculus.diff(e, m.params[k].sym, known[k]) end)
  local start = {}
  for i, s in ipairs(m.states) do
    start[i] = { why = "derivatives of the initial " .. s.name, defs = {}, outs = {} }
    for k, p in ipairs(m.params) do
      local d = m:constant("d" .. s.name .. "0_d" .. p.name, calculus.diff(s.initial, p.sym), "d " .. s.name ..
        "(0)/d " .. p.name)
      start[i].outs[k] = { array = "S", index = (i - 1) * n + k - 1, expr = d }
    end
  end
  return { name = "jacobian_p", args = { "m", "t", "x", "u", array("J", #m.states * n, "NX", "NP") },
    doc = { "Derivative of the equations of motion by the parameters, row major, NX x NP:",
      "J[i*NP + k] = d(dx[i])/d(p[k])." }, groups = rates },
    { name = "initial_p", args = { "m", array("S", #m.states * n, "NX", "NP") },
      doc = { "Derivative of the initial state by the parameters, row major, NX x NP: where the sensitivities",
        "S' = (df/dx) S + df/dp start." }, groups = start }
end

-- The derivative by the states of a function that is made of them (a description with one result, or the array L of
-- three), as the function `name`.
function sensitivity.of_made(m, f, name, doc)
  local n, rows, groups = #m.states, {}, {}
  for _, g in ipairs(f.groups) do
    for _, o in ipairs(g.outs) do rows[(o.index or 0) + 1] = equations.inline(f.groups, o.expr) end
  end
  for i, e in ipairs(rows) do
    groups[i] = { why = #rows == 1 and "derivatives by the states" or "row " .. i, defs = {}, outs = {} }
    for k, s in ipairs(m.states) do
      groups[i].outs[k] = { array = "G", index = (i - 1) * n + k - 1, expr = calculus.diff(e, s.sym) }
    end
  end
  local args = {}
  for _, a in ipairs(f.args) do args[#args + 1] = type(a) == "string" and a or nil end
  args[#args + 1] = array("G", #rows * n, #rows > 1 and string.format("%d", #rows) or nil, "NX")
  return { name = name, args = args, doc = doc, groups = groups }
end

-- Symbols of a definition's name, whatever their rank.
-- Derivatives are looked up by symbol, and a definition may stand in expressions with any of these ranks.
local function symbols(name)
  local list = {}
  for rank = 6, 9 do list[#list + 1] = expr.sym(name, rank) end
  return list
end

-- Definitions followed by their derivatives by `columns` (a list of {name, sym}): known[k], which it fills, has the
-- derivative by column k of every symbol that is no column; taken: names that new ones must not have.
function sensitivity.follow(defs, columns, known, taken)
  local out = {}
  for _, d in ipairs(defs) do taken[d.name] = true end
  for _, d in ipairs(defs) do
    out[#out + 1] = d
    for k, s in ipairs(columns) do
      local e = calculus.diff(d.expr, s.sym, known[k])
      if e.kind ~= "num" and e.kind ~= "sym" then
        local own = d.name .. "_" .. s.name
        while taken[own] do own = own .. "_" end
        taken[own] = true
        out[#out + 1] = { name = own, expr = e }
        e = expr.sym(own, 9)
      end
      for _, sym in ipairs(symbols(d.name)) do known[k][sym] = e end
    end
  end
  return out
end

-- Groups {defs, outs = {state, expr}} of a map of the states, its definitions with their derivatives by the columns
-- (states or inputs), and last those of the outs into the array.  known, taken: as above.
function sensitivity.tangent(m, steps, known, taken, columns, name)
  local n, groups, final = #columns, {}, {}
  for _, member in ipairs(m.members) do taken[member.name] = true end
  for _, g in ipairs(steps) do
    for _, d in ipairs(g.defs) do taken[d.name] = true end
  end
  for i, g in ipairs(steps) do
    for _, o in ipairs(g.outs) do final[o.state] = o.expr end
    groups[i] = { why = g.why .. "; and its derivatives", where = g.where, outs = {},
      defs = sensitivity.follow(g.defs, columns, known, taken) }
  end
  for i, s in ipairs(m.states) do
    local g = { why = "derivatives of " .. s.name .. " at t + h", defs = {}, outs = {} }
    for k, by in ipairs(columns) do
      g.outs[k] = { array = name, index = (i - 1) * n + k - 1,
        expr = calculus.diff(final[s.name] or s.sym, by.sym, known[k]) }
    end
    groups[#groups + 1] = g
  end
  return groups, final
end

-- A table for each column: what sensitivity.tangent knows at first.
function sensitivity.nothing(columns)
  local known = {}
  for k in ipairs(columns) do known[k] = {} end
  return known
end

-- The contract of NAME_STEP_transition, for header and description.
function sensitivity.doc(scene, name)
  return {
    "The step of " .. scene .. "_" .. name .. ", x from t to t + h, and its transition matrix, row major, NX x NX:",
    "F[i*NX + k] = d x[i](t + h)/d x[k](t), exact for the step as it is computed (what keeps |q| = 1 included).",
  }
end

-- The transition matrix of a step that is written as groups {defs, outs}, as the function `name`.
function sensitivity.transition(eq, steps, name)
  local m = eq.model
  local groups, final = sensitivity.tangent(m, steps, sensitivity.nothing(m.states), {}, m.states, "F")
  local last = { why = "the new state", defs = {}, outs = {} }
  for _, s in ipairs(m.states) do
    if final[s.name] then last.outs[#last.outs + 1] = { array = "x", state = s.name, expr = final[s.name] } end
  end
  groups[#groups + 1] = last
  return { name = name .. "_transition", args = { "m", "t", "x!", "u", "h", array("F", #m.states * #m.states, "NX",
    "NX") },
    doc = sensitivity.doc(m.name, name), groups = groups }
end

-- The derivative by the input of the same step.
function sensitivity.transition_u(eq, steps, name)
  local m = eq.model
  local groups = sensitivity.tangent(m, steps, sensitivity.nothing(m.inputs), {}, m.inputs, "G")
  return { name = name .. "_transition_u", args = { "m", "t", "x", "u", "h", array("G", #m.states * #m.inputs, "NX",
    "NU") },
    doc = { "How " .. m.name .. "_" .. name .. " depends on its input, row major, NX x NU: G[i*NU + k] =",
      "d x[i](t + h)/d u[k], u held during the step; 0 where u[k] is beyond its limits.  x stays as it is." },
    groups = groups }
end

-- All of them for a job {equations, model, steppers, diag, record}; nil after an error: a derivative that
-- does not exist at the parameters' own values (|p| at p = 0) would be no constant.
-- which = "transition": the transition matrices alone.
function sensitivity.list(job, which)
  local eq, list = job.equations, {}
  if which ~= "transition" then
    list[1] = sensitivity.by_input(eq, job.model.inputs)
    for _, f in ipairs { sensitivity.by_parameters(eq) } do list[#list + 1] = f end
  end
  for i, s in ipairs(job.steppers) do
    local groups = s.method.plain or s.method.groups
    if groups then
      local steps = groups(eq, function(e, words) return eq.model:derived(e, words) end)
      local name = i == 1 and "step" or s.method.name .. "_step"
      list[#list + 1] = sensitivity.transition(eq, steps, name)
      if eq.inputs then list[#list + 1] = sensitivity.transition_u(eq, steps, name) end
    elseif not s.program.transition then
      job.diag:error(job.record.line, "method " .. s.method.name, "its step has no transition matrix here (--with " ..
        "jacobians): rk4, adaptive, taylor, midpoint and semi have one")
      return nil
    end
  end
  for _, member in ipairs(eq.model.members) do
    if not pcall(eq.model.number, eq.model, member.e) then
      job.diag:error(job.record.line, "jacobians", member.about .. " must exist at the parameters' own values")
      return nil
    end
  end
  return list
end

return sensitivity
