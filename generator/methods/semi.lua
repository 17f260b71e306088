-- semi.lua -- the semi-implicit step: one evaluation of the torque, rates first, then the attitude by a rotation.
--
--     L' = L + h N(q, w, t),  w' = I^-1 L'                      the torque, at the start of the step
--     w* = w' + (1 - (h/2) f'(w'))^-1 (h/2) f(w')               the rate at the middle, f = I^-1 (I w x w): no torque
--     q1 = q E,  L1 = E^T L'      E the rotation of the unit quaternion along (1, h w*/2): Cayley's map of h w*
-- so torque-free motion keeps q L, whatever w* is, and the rates stay bounded: |L1| = |L'|.  w* is one Newton iteration
-- of the midpoint rule (methods/midpoint.lua), which is Kahan's method for the quadratic f; for a symmetric body it is
-- the rule's solution.  Order 1 with torques (symplectic Euler), 2 without.  Position follows velocity in the same way;
-- states of effects' own take one step of Euler's method.
-- Where inner dissipation turns the axes at W beside w, the rotation is that of W, so that q L stays then, too.  With
-- moving parts I is the tensor at the start until L1 is known, and w1 = (I + D1)^-1 L1 with the tensor at the end.
-- Source: Hairer, Lubich, Wanner, Geometric Numerical Integration (2nd ed.), I.1.2 (symplectic Euler), VII.5; Hirota,
-- Kimura 2000, J. Phys. Soc. Japan 69, 627 (Kahan's method for Euler's top).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local constancy = require "generator.dynamics.constancy"
local context = require "generator.dynamics.context"
local equations = require "generator.dynamics.equations"
local moving = require "generator.dynamics.moving"
local state = require "generator.dynamics.state"
local cayley = require "generator.methods.cayley"

local semi = { name = "semi", order = 1, title = "semi-implicit method of order 1",
  needs = { { path = "the step", needs = "of attitude and rates q' = (q (0, W) - (0, Omega) q)/2, (I + D) w' = (L + " ..
    "k) x W + N - D' w with W = w + the slip of inner dissipation; other states: any equations" } },
  about = "semi-implicit, one torque evaluation a step, order 1 (2 without torque), fixed step, for firmware" }

local h, q, w = state.h, state.q, state.w

-- Euler's step of what is not turning: new velocities and own states first, then positions by the new velocities.
-- increments, here and below: what is added to the state stands in the place of the new state, and what the state has
-- lost comes by increments(name).  Returns the new states: moving parts that are asked where they were and where they
-- are must be asked at the same times as in the next step, or what they did between is lost.
local function carried(m, groups, zero, list, finals, increments)
  local new = {}
  for _, last in ipairs { false, true } do
    for _, g in ipairs(groups) do
      local group = { why = g.why, where = g.where, defs = {}, outs = {} }
      local define = cayley.definer(m, group)
      for _, o in ipairs(g.outs) do
        local s = m.states.by_name[o.state]
        if (s.kind == "position") == last and s.kind ~= "attitude" and s.kind ~= "rates" and not zero[o.state] then
          local e = equations.inline(groups, o.expr)
          if last then e = calculus.substitute(e, new) end
          local added = increments and define("d" .. o.state, h * e) or h * e
          new[s.sym] = define(o.state .. "1", s.sym + (increments and increments(o.state) + added or added))
          finals[#finals + 1] = { state = o.state, expr = increments and added or new[s.sym] }
        end
      end
      if #group.defs > 0 then list[#list + 1] = group end
    end
  end
  return new
end

-- The rates after the torque, w' (definitions of their own where there is a torque), and w' - w.
local function kicked(m, N, list, increments)
  if cayley.none(N) then return w, { expr.zero, expr.zero, expr.zero } end
  local g = { why = "w' = w + h I^-1 N", defs = {}, outs = {} }
  list[#list + 1] = g
  local define = cayley.definer(m, g)
  local added = vec.scale(h, cayley.solved(m, N))
  if increments then added = cayley.each(define, "dw", added) end
  return cayley.each(define, "wk", vec.add(w, added)), added
end

-- w1 - w' = S1^-1 ((L1 - L') - (S1 - S) w'), S1 the tensor with the moving parts as they are at the end.
local function moved(m, change, at, new, list)
  local g = { why = "w1 = w' + (I + D1)^-1 (L1 - L' - (D1 - D) w'), D1 that of the moving parts at the end", defs = {},
    outs = {} }
  list[#list + 1] = g
  local define = cayley.definer(m, g)
  local S, D = cayley.inertia(m), context.parts(m)
  local later = vec.map(D, function(e) return calculus.substitute(e, new) end)
  local S1 = vec.map(S, function(e, n) return define("S" .. vec.entry[n], calculus.substitute(e, new)) end)
  local rest = cayley.each(define, "n", vec.sub(change, vec.apply(vec.sub(later, D), at)))
  return vec.solve(S1, rest, function(name, e) return define(name .. "1", e) end)
end

-- What is added to q to make q1 = n q (1, b): n - 1 without cancellation, r - 1 = -b^2 r^2/(1 + r) of r = 1/|(1, b)|;
-- of p that is formed otherwise n - 1 = (1 - |p|^2) n^2/(1 + n).  What rounding does to n moves |q| alone.
local function added_turn(define, p, b, short)
  local n1, n
  if short then
    local length = q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2
    local r1 = define("r1", -vec.dot(b, b) * short * short / (1 + short))
    n1 = define("n1", r1 + short * (1 - length) / 2)
    n = define("n", 1 + n1)
  else
    local length = define("pp", p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2 + p[4] ^ 2)
    n = define("n", expr.lift(1) / expr.sqrt(length))
    n1 = define("n1", (1 - length) * n * n / (1 + n))
  end
  return n, n1
end

-- A group {why, defs, outs} and what defines names in it.
local function group_of(m, why)
  local g = { why = why, defs = {}, outs = {} }
  return g, cayley.definer(m, g)
end

local function replaced(v, map) return vec.map(v, function(e) return calculus.substitute(e, map) end) end

-- The rate that turns the body, at the middle of the step: one Newton iteration from the rate w' behind the kick, for
-- the midpoint rule of the motion that is left, w* = w' + (h/2) f(w*); `turns` is false where that is w' itself.  Then
-- the rate at which the axes turn, where that is another one.  Returns the rate and h/2.
local function middle_rate(m, S)
  local g, define = group_of(m, S.turns and "the rate at the middle: w* = w' + (1 - (h/2) f')^-1 (h/2) f" or
    "half of the step")
  S.list[#S.list + 1] = g
  local hh, middle = define("hh", h / 2), S.at
  if S.turns then
    local F = cayley.each(define, "F", vec.map(S.f, function(e) return -hh * e end))
    local change = cayley.newton(define, F, function(i, j) return hh * calculus.diff(S.f[i], S.at[j]) end)
    middle = cayley.each(define, "wm", vec.sub(S.at, change))
  end
  if S.slip then
    local there = {}
    for i = 1, 3 do there[w[i]] = middle[i] end
    g.why = g.why .. "; the axes turn at W"
    middle = cayley.each(define, "W", vec.add(middle, replaced(S.slip, there)))
  end
  return middle, hh
end

-- Half of the rotation, b of (1, b), and the rates at the end: L' = I w' + k turned back by it is L1, and
-- w1 = w' + I^-1 (L1 - L').  Returns b, w1 and 1/|(1, b)| where the attitude can use it.
local function rotation(m, S, middle, hh)
  local g, define = group_of(m, "half of the rotation, (1, b)")
  if m.has.attitude or S.turns then S.list[#S.list + 1] = g end
  local half = cayley.each(define, "b", vec.scale(hh, middle))
  local w1 = S.base
  local s, short = 2 / (1 + vec.dot(half, half)), nil
  if m.has.attitude and not m.frame then -- one root for both: n = 1/|(1, b)| and s = 2 n^2
    short = define("r", expr.lift(1) / expr.sqrt(1 + vec.dot(half, half)))
    s = 2 * short * short
  end
  if S.turns then
    g.why = "half of the rotation, (1, b); L turned back by it, w1 = w' + I^-1 (L1 - L')"
    local L = vec.add(replaced(vec.apply(cayley.inertia(m), w), S.map), S.k)
    local change = cayley.turned(define, half, s, cayley.each(define, "L", L), "L")
    change = cayley.each(define, "dL", change)
    w1 = vec.add(w1, S.varies and moved(m, change, S.at, S.new, S.list) or cayley.solved(m, change))
  end
  return half, w1, short
end

-- The new attitude, or what is added to the old one, in the last group: q1 = n q (1, b), where the base frame turns
-- q1 = (1, -B) q (1, b)/|..|.
local function new_attitude(m, last, S, half, hh, short)
  last.why = "q1 = n q (1, b), n = 1/|q (1, b)| with one Newton step for 1/|q|, so |q| cannot drift"
  local define = cayley.definer(m, last)
  local p = vec.qmul(q, { expr.one, half[1], half[2], half[3] })
  if m.frame then
    local turn, defs = moving.rate(m)
    turn = vec.map(turn, function(e) return equations.inline({ { defs = defs } }, e) end)
    local B = cayley.each(define, "B", vec.scale(hh, turn))
    p = vec.qmul({ expr.one, -B[1], -B[2], -B[3] }, p)
    last.why = "q1 = (1, -B) q (1, b)/|..|, B = (h/2) Omega"
  end
  if S.increments then
    local n, n1 = added_turn(define, p, half, short)
    last.why = last.why .. "; q1 - q = (n - 1) q + n (p - q)"
    return vec.add(vec.scale(n1, q), vec.scale(n, vec.sub(p, q)))
  elseif m.frame then
    return cayley.unit(define, p)
  end
  local length = q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2
  return vec.scale(define("n", short * (expr.lift "3/2" - length / 2)), p)
end

-- The step as equation groups with outs {state, expr}.  S is what its parts share: list of groups, new (states that
-- were carried over), at and map (the rates w' behind the kick), base (those, or what the kick adds), k and slip of the
-- acting effects, f (Euler's rates without torque), increments.
-- The order is that of the scheme: what does not turn, the kick, the rate at the middle, the rotation, the new state.
local function step(eq, increments)
  local m, zero = eq.model, constancy.conserved(eq)
  local list, finals = {}, {}
  local S = { list = list, increments = increments, map = {} }
  S.new = carried(m, eq.groups, zero, list, finals, increments)
  local last = { why = "the new state", defs = {}, outs = finals }
  if not m.has.rates then
    list[#list + 1] = last
    return list
  end

  local acts = cayley.acting(m)
  S.k, S.slip, S.varies = acts.k, acts.slip, context.parts(m) ~= nil
  local at, added = kicked(m, acts.N, list, increments)
  for i = 1, 3 do S.map[w[i]] = at[i] end
  S.at, S.base = at, increments and added or at
  S.f = replaced(cayley.rates(m, vec.cross(S.k, w)), S.map)
  S.turns = S.slip or S.varies or not cayley.none(S.f)
  local middle, hh = middle_rate(m, S)
  local half, w1, short = rotation(m, S, middle, hh)
  for i, name in ipairs(state.names.rates) do
    -- what is along an axis of symmetry turns with it
    local e = S.f[i] == expr.zero and not S.slip and not S.varies and S.base[i] or w1[i]
    if not zero[name] then finals[#finals + 1] = { state = name, expr = e } end
  end
  if m.has.attitude then
    for i, e in ipairs(new_attitude(m, last, S, half, hh, short)) do
      finals[#finals + 1] = { state = state.names.attitude[i], expr = e }
    end
  end
  list[#list + 1] = last
  return list
end

function semi.refused(eq)
  return eq.model.has.rates and cayley.missed(eq) or nil
end

function semi.groups(eq) return step(eq, nil) end

-- What the step adds to the states, in the place of the new states: methods/compensated.lua.
function semi.increments(eq, _, lost) return step(eq, lost) end

return semi
