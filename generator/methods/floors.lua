-- floors.lua -- by what, at least, the error of a step is measured where a body may come to rest.
--
-- A size that is rounding can be followed by no step: what is left of the slip, say, where v and w x r cancel, or of
-- the velocity of a weight on a spring.  So a size is never less than what the terms of its rate, each on its own, make
-- of it within the step h.  On a plane:
--     v:  |g| h, and |r| |w|, the other part of the slip       w:  m |g| |r|/I h, and |v|/|r|       place:  |r|
-- |r|: a bound of the way from the centre of mass to the contact point; I: half the trace, the largest moment or up to
-- half more.  In space, v' = a1 + a2 + .. and r' = v:
--     v:  F = h (|a1| + |a2| + ..)                             r:  F h, what that makes of it
-- the terms of all three components together, as they are at the start of the step, sums in products and functions
-- opened (`size`).  Where at most one term of each component is left at v = 0, no forces balance at rest, and there is
-- no floor.
-- Terms that vanish with the state leave none either: a motion that grows out of nearly nothing is followed.
-- Nothing here remembers the run.  What plays the same part in the general library is scale.c.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local context = require "generator.dynamics.context"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"

local floors = {}

local function length(v) return expr.call("sqrt", vec.dot(v, v)) end

-- The place of a state in what NAME_floors gives; nil: it has no floor.
local function place(s)
  if s.kind == "rates" then return 0 end
  return string.match(s.name, "^v[12]$") and 1 or string.match(s.name, "^p[12]$") and 2 or nil
end

local of_place, of_time = {}, { t = true }
for _, name in ipairs(state.names.position) do of_place[name] = true end

-- df/du of f(.., u, ..), the argument number k; nil: no rule.
local function slope(f, k)
  local u, arguments = expr.sym("@u", 8), table.move(f, 1, #f, 1, {})
  arguments[k] = u
  local ok, d = pcall(calculus.diff, expr.call(f.fn, table.unpack(arguments)), u)
  return ok and calculus.substitute(d, { [u] = f[k] }) or nil
end

-- Is argument k of the function e one whose terms count?  A place that is a sum, as in sin(x - x0); not where the time
-- is one of them, whose size grows for ever while nothing rests there.
local opened
local function opened_argument(e, k)
  return opened(e[k]) and expr.constant(e[k], of_time) and not expr.constant(e[k], of_place)
end

-- Is e more than one term?  Nodes never change (algebra/expr.lua), so the answer is kept for each.
local answer = setmetatable({}, { __mode = "k" })
function opened(e)
  if answer[e] == nil then
    local found = e.kind == "add"
    for k = 1, (e.kind == "mul" or e.kind == "call") and #e or 0 do
      found = found or e.kind == "mul" and opened(e[k]) or e.kind == "call" and opened_argument(e, k)
    end
    answer[e] = found
  end
  return answer[e]
end

local function abs(e) return expr.call("abs", e) end

-- The sum of the absolute terms of e.  Of a product with sums each in turn is replaced by its terms while the others
-- stay, and a function is known to f(u) and to f'(u) times the terms of u, for so roundings add up: d(a b) = da b + a
-- db.  memo: what is known, for parts that are shared; the result is as large as e, not as what e multiplied out is.
local function size(e, memo)
  if memo[e] then return memo[e] end
  local list = {}
  if e.kind == "add" then
    for k = 1, #e do list[k] = size(e[k], memo) end
  elseif e.kind == "mul" then
    for k = 1, #e do
      local others = table.move(e, 1, #e, 1, {})
      table.remove(others, k)
      list[#list + 1] = opened(e[k]) and abs(expr.mul(others)) * size(e[k], memo) or nil
    end
  elseif e.kind == "call" then
    for k = 1, #e do
      local d = opened_argument(e, k) and slope(e, k)
      list[#list + 1] = d and abs(d) * size(e[k], memo) or nil
    end
    if #list > 0 then list[#list + 1] = abs(e) end
  end
  memo[e] = #list > 0 and expr.add(list) or abs(e)
  return memo[e]
end

local still = {} -- v = 0
for i = 1, 3 do still[state.v[i]] = expr.zero end

-- Is v' = e more than one term at rest?  Where it has no value there, as 1/v, it counts as such.
local function balances(e)
  local ok, rest = pcall(calculus.substitute, e, still)
  return not ok or opened(rest)
end

-- The sum of the absolute terms of v', or nil where no forces balance at rest.
local function pulls(eq)
  local inlined, rates = equations.inlined(eq.groups), {}
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do rates[o.state] = o.expr end
  end
  local sum, memo, balance = {}, {}, false
  for i, name in ipairs(state.names.velocity) do
    local rate = inlined(rates[name])
    balance = balance or balances(rate)
    sum[i] = rate
  end
  if not balance then return nil end
  for i, rate in ipairs(sum) do sum[i] = size(rate, memo) end
  return expr.add(sum)
end

-- Of translation: {groups = {F, F h} of a function, places}, or nil.
local function in_space(eq)
  local sum, places = pulls(eq), {}
  if not sum then return nil end
  for i = 1, 3 do places[state.names.velocity[i]], places[state.names.position[i]] = 0, 1 end
  local span = abs(state.h)
  return { places = places, groups = { { why = "v: |h| times the terms of v' = F/m, each on its own; r: what that " ..
    "makes of it", defs = {}, outs = { { array = "least", index = 0, expr = span * sum },
    { array = "least", index = 1, expr = span * span * sum } } } } }
end

-- On a plane {pull = |g|, reach = |r|, turn = 2 m |g| |r|/trace I, derived constants; places = by the states' names},
-- else as in_space has it; nil: no floors.
function floors.of(eq)
  local m = eq.model
  if m.has.position then return in_space(eq) end
  local plane = contact.of(m)
  if not (plane and eq.touch) then return nil end
  local a, s = plane.a, plane.a.surface
  local mass, trace = m.mass, m.inertia[1] + m.inertia[2] + m.inertia[3]
  local reach = s.rim + length(s.half) + length(vec.sub(s.at, context.of(m).origin))
  if s.support then reach = reach + expr.call("sqrt", trace / (2 * mass)) end -- its size is a function; the body's own
  local pull, places = length(a.gravity), {}
  for _, x in ipairs(m.states) do places[x.name] = place(x) end
  return { places = places,
    pull = m:constant("floor_pull", pull, "|g| of the plane, m/s^2"),
    reach = m:constant("floor_reach", reach, "bound of the way to the contact point, m"),
    turn = m:constant("floor_turn", 2 * mass * pull * reach / trace, "m |g| |r|/I, 1/s^2") }
end

return floors
