-- attitude.lua -- the attitude's part of the classical Runge-Kutta step, q' = q (0, w)/2.
--
-- The equation is linear in q, so the four increments are q multiplied from the right: with v_s = w_s h/4 (the
-- angles, h/2 for the whole step of stage 4's input) they are q e_s,
--     e1 = v1,  e2 = (1 + e1) v2,  e3 = (1 + e2) 2 v3,  e4 = (1 + e3) v4,  q += q (e1 + 2 e2 + e3 + e4)/3
-- and if no rate depends on q, q itself enters one product at the end ("apart").  Else the increments d_s = q e_s are
-- formed at each stage ("coupled").  In a frame that turns at Omega they are d_s = q v_s - V_s q, V_s = Omega h/4.
-- The factor n = 3/2 - |q|^2/2 is one Newton step for 1/|q|, taken from the q that comes in: by linearity that is
-- normalising before the step.  It costs no latency, and |q| cannot drift: what a step leaves, the next one removes.
-- Source: Kutta 1901; Hairer, Norsett, Wanner, Solving ODEs I (2nd ed.), table II.1.2.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local state = require "generator.dynamics.state"

local attitude = {}

local q = state.q
local axes = { "w", "x", "y", "z" }
local comp = { "x", "y", "z" }
attitude.comp = comp
attitude.is = { qw = true, qx = true, qy = true, qz = true } -- names of its states

-- Adds definitions prefix..letter..suffix for the entries of v; returns their symbols (a number or a symbol stays).
local function named(group, prefix, suffix, v, letters)
  return vec.map(v, function(e, i)
    if e.kind == "num" or e.kind == "sym" then return e end
    local name = prefix .. letters[i] .. suffix
    local known = false
    for _, d in ipairs(group.defs) do known = known or d.name == name end
    if not known then group.defs[#group.defs + 1] = { name = name, expr = e } end
    return expr.sym(name, group.rank or 9)
  end)
end
attitude.named = named

-- The quaternion (0, v).
local function pure(v) return { expr.zero, v[1], v[2], v[3] } end

-- Apart: the doubled quaternion 2 (1 + e2) serves stage 3, and 2 e2 the final sum.
-- Gets what it returned for the stage before, {sum = what the stage adds to e1 + 2 e2 + e3 + e4, next = the factor of
-- the next stage's v}.
local function apart(g, s, v, e)
  if s == 1 then return { sum = pure(v), next = { expr.one, v[1], v[2], v[3] } } end
  local product = vec.qmul(e.next, pure(v))
  local ew = named(g, "ew", tostring(s), { s == 2 and 2 * product[1] or product[1] }, { "" })[1]
  local ev = named(g, "e", tostring(s), { product[2], product[3], product[4] }, comp)
  if s == 2 then
    ev = named(g, "f", tostring(s), vec.scale(expr.lift(2), ev), comp)
    local ow = named(g, "o", tostring(s), { 2 + ew }, { "" })[1]
    return { sum = { ew, ev[1], ev[2], ev[3] }, next = { ow, ev[1], ev[2], ev[3] } }
  end
  if s == 4 then return { sum = { ew, ev[1], ev[2], ev[3] } } end
  local ow = named(g, "o", tostring(s), { 1 + ew }, { "" })[1]
  return { sum = { ew, ev[1], ev[2], ev[3] }, next = { ow, ev[1], ev[2], ev[3] } }
end

-- The attitude at stage s (coupled only; else q).
function attitude.at(g, s, previous, coupled)
  if not coupled or s == 1 then return q end
  return named(g, "q", tostring(s), vec.add(q, previous.d), axes)
end

-- The increment of stage s from the angles v (and V of the frame) and the attitude `at` of the stage.
-- Returns {sum, next} (apart) or {sum, d} (coupled). d is the change of q over h/2, v being w h/4; over h in stage 3,
-- whose d leads to the end of the step.
function attitude.increment(g, s, v, at, previous, coupled, V)
  if not coupled then return apart(g, s, v, previous) end
  local d = vec.qmul(at, pure(v))
  if V then d = vec.sub(d, vec.qmul(pure(V), at)) end
  if s == 3 then d = vec.scale(expr.lift(2), d) end
  d = named(g, "d", tostring(s), d, axes)
  return { d = d, sum = s == 2 and vec.scale(expr.lift(2), d) or d }
end

-- The last group: what is added to the attitude.  n - 1 is small and a factor of q: its rounding moves |q| alone.  A
-- third is not exact, so it multiplies what the increments differ by: see rk4.lua.
local function added(list, coupled)
  local m, third = expr.sym("m1", 9), expr.lift "1/3"
  local g = { why = "n - 1, n = 1/|q| by one Newton step from 1, so |q| cannot drift", outs = {},
    defs = { { name = "m1", expr = (1 - (q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2)) / 2 } } }
  local mean = vec.map(list[1].sum, function(x, i)
    if x == expr.zero then return third * (list[4].sum[i] + list[3].sum[i] + list[2].sum[i]) end
    local rest = list[4].sum[i] + list[3].sum[i] + list[2].sum[i] - 5 * x
    return 2 * x + third * named(g, "e", "5", { rest }, { axes[i] })[1]
  end)
  mean = named(g, "s", "", mean, axes)
  local turn = vec.map(mean, function(x) return x + m * x end)
  local new
  if coupled then
    g.why = g.why .. "; q += (n - 1) q + n (d1 + 2 d2 + d3 + d4)/3"
    new = vec.map(q, function(x, i) return m * x + turn[i] end)
  else
    g.why = g.why .. "; q += q (n - 1 + n (e1 + 2 e2 + e3 + e4)/3)"
    turn[1] = m + turn[1]
    new = vec.qmul(q, named(g, "p", "", turn, axes))
  end
  for i, name in ipairs { "qw", "qx", "qy", "qz" } do g.outs[i] = { state = name, expr = new[i] } end
  return g
end

-- The last group, coupled.  n is 1 but for a unit or two of the last place, and n q would be q but for as many:
-- rounded, a step of the last place is more of a small mantissa than of a large one, which turns q, always the same
-- way.  So the difference (n - 1) q is added to the increment, which has digits to spare, and rounded with it.
local function joined(list)
  local g = { why = "n - 1, n = 1/|q| by one Newton step from 1, so |q| cannot drift; q += (n - 1) q + n (d1 + " ..
    "2 d2 + d3 + d4)/3", outs = {},
    defs = { { name = "m1", expr = (1 - (q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2)) / 2 } } }
  local m = expr.sym("m1", 9)
  g.defs[2] = { name = "n3", expr = (1 + m) / 3 }
  local new = vec.map(q, function(x, i)
    local sum = list[1].sum[i] + list[4].sum[i] + list[3].sum[i] + list[2].sum[i]
    return m * x + expr.sym("n3", 9) * sum
  end)
  new = named(g, "p", "", new, axes)
  for i, name in ipairs { "qw", "qx", "qy", "qz" } do g.outs[i] = { state = name, expr = q[i] + new[i] } end
  return g
end

-- The last group: the new attitude from the four increments; increments: what is added to the old one.
function attitude.finish(list, coupled, increments)
  if increments then return added(list, coupled) end
  local half = expr.lift "1/2"
  if coupled then return joined(list) end
  local g = { why = "n = 1/|q| by one Newton step from 1, so |q| cannot drift", outs = {},
    defs = { { name = "n", expr = half * 3 - half * (q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2) } } }
  local n = expr.sym("n", 9)
  g.defs[2] = { name = "n3", expr = n / 3 }
  local weighted = vec.map(list[1].sum, function(x, i)
    return expr.sym("n3", 9) * (x + list[4].sum[i] + list[3].sum[i] + list[2].sum[i])
  end)
  g.why = g.why .. "; q = n q (1 + (e1 + 2 e2 + e3 + e4)/3)"
  weighted[1] = n + weighted[1]
  local new = vec.qmul(q, named(g, "p", "", weighted, axes))
  for i, name in ipairs { "qw", "qx", "qy", "qz" } do g.outs[i] = { state = name, expr = new[i] } end
  return g
end

return attitude
