-- taylor_special.lua -- the frames in which Taylor series take longer steps, and the heavy top's own recurrences.
--
-- Each holds for the equations that it claims and for no others (claim.lua).
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"
local claim = require "generator.methods.claim"

local special = {}

special.needs = {
  { path = "frame about an axis", needs = "attitude and rates; symmetric about x, y or z, the rate about it " ..
    "constant; all equations look alike from all sides of the axis and turn the rates across it at a constant rate; " ..
    "no inputs" },
  { path = "frame of L", needs = "attitude and rates; no products of inertia; q' = q (0, w)/2, and the rates have " ..
    "Euler's equations without torque; no other state depends on the attitude; no inputs" },
  { path = "heavy top", needs = "the frame about z; nothing moves but the attitude, q' = q (0, w)/2, and two rates, " ..
    "W' = i Omega W + K conj(a) b with Omega and K constant; no corners, no transition matrix" },
}

local q, w, rates = state.q, state.w, state.names.rates
local of_attitude, place = {}, {}
for i, name in ipairs(state.names.attitude) do of_attitude[name], place[name] = true, i end
for i, name in ipairs(rates) do place[name] = i end

-- The groups with the rate put(state, expr) of each state in the place of expr.
local function changed(groups, put)
  return vec.map(groups, function(g)
    return { defs = g.defs, outs = vec.map(g.outs, function(o)
      return { state = o.state, expr = put(o.state, o.expr) }
    end) }
  end)
end

-- Does e keep its value while these states move?
local function steady(e, moving)
  local varying = { t = true }
  for _, s in ipairs(moving) do varying[s.name] = true end
  return expr.constant(e, varying)
end

-- Where body and torque look alike from all sides of an axis k and the rate w3 about it is constant, the equations keep
-- their form in a frame that turns about k at any rate s relative to the body: only Omega = (I3 - I1)/I1 w3 becomes
-- Omega + s, and w3 in the attitude's equation w3 - s.  With s = (w3 - Omega)/2 the fastest oscillation, w3 of a
-- direction fixed in space, falls to (w3 + Omega)/2, and longer steps do.  The base frame may turn: it stands on the
-- other side of q.  Returns {groups in that frame, axis = its number, spin = s, Omega}, or nil.
local function about_axis(eq, zero, rate, moving)
  local m = eq.model
  local axis = m.structure.kind == "symmetric" and equations.coordinate(m.structure.k)
  if not axis or not zero[rates[axis]] then return nil end
  local k = { expr.zero, expr.zero, expr.zero }
  k[axis] = expr.one
  local function turned(p) return vec.qmul(p, { expr.zero, -k[1] / 2, -k[2] / 2, -k[3] / 2 }) end
  local turning, turned_q = vec.cross(k, w), turned(q) -- rates of change of w and q as the frame turns
  local function turned_with(e) -- how e changes as the frame turns
    local change = expr.zero
    for j = 1, 3 do change = change + calculus.diff(e, w[j]) * turning[j] end
    for j = 1, 4 do change = change + calculus.diff(e, q[j]) * turned_q[j] end
    return change
  end
  local function of(names) return vec.map(names, function(name) return rate[name] end) end
  -- a rate looks alike from all sides if it changes with the frame as its state does; what moves beside the body must
  -- not tell the frames apart
  local change, claimed = {}, {}
  for _, s in ipairs(m.states) do change[s.name], claimed[s.name] = turned_with(rate[s.name]), expr.zero end
  for i, e in ipairs(vec.cross(k, of(rates))) do claimed[rates[i]] = e end
  for i, e in ipairs(turned(of(state.names.attitude))) do claimed[state.names.attitude[i]] = e end
  if claim.miss(m.states, change, claimed) then return nil end
  -- d(k x w)_i/dw_j is +-1 or 0, so this is the mean of the two entries of dw'/dw beside the diagonal, each with its
  -- sign: the part of the antisymmetric matrix about k
  local Omega, s = expr.zero, expr.sym("spin", 7)
  for i = 1, 3 do
    for j = 1, 3 do
      if i ~= axis and j ~= axis and i ~= j then
        Omega = Omega + calculus.diff(turning[i], w[j]) * calculus.diff(rate[rates[i]], w[j]) / 2
      end
    end
  end
  if not steady(Omega, moving) then return nil end
  local spin = (w[axis] - Omega) / 2
  local function put(name, e)
    if of_attitude[name] then return calculus.substitute(e, { [w[axis]] = w[axis] - s }) end
    return place[name] and e + s * turning[place[name]] or e
  end
  for i, name in ipairs(state.names.attitude) do -- the rate w3 turns the attitude as the frame does, or it is no w3
    if not ratio.iszero(put(name, rate[name]) - rate[name] - s * turned_q[i]) then return nil end
  end
  local groups = { { defs = { { name = "spin", expr = spin } }, outs = {} } }
  for _, g in ipairs(changed(eq.groups, put)) do groups[#groups + 1] = g end
  return { groups = groups, axis = axis, spin = spin, Omega = Omega }
end

-- Free motion, a diagonal tensor: L is constant in space, so q' = q (0, w - lambda L)/2 for the attitude seen from a
-- frame that turns in space with lambda L, and lambda = 1/I2 leaves two components of the rate, 8 products of 12.
-- Returns {groups in that frame, shift = d}, lambda L = w - d w component by component (d of the second axis is 0), or
-- nil.
local function about_momentum(eq, rate)
  local m = eq.model
  if m.structure.kind ~= "diagonal" then return nil end
  local I, claimed = m.inertia, claim.turning()
  for i, e in ipairs(vec.cross(w, vec.apply(I, w))) do claimed[rates[i]] = -e / I[i] end -- I w' + w x L = 0
  for _, s in ipairs(m.states) do -- a thrust that turns with the body must not be seen from another frame
    if not place[s.name] then
      if not expr.constant(rate[s.name], of_attitude) then return nil end
      claimed[s.name] = rate[s.name]
    end
  end
  if claim.miss(m.states, rate, claimed, m) then return nil end
  local d = {}
  for _, i in ipairs { 1, 3 } do
    d[i] = m:constant("shift" .. i, expr.one - I[i] / I[2], "1 - I" .. i .. "/I2")
  end
  local map = { [w[1]] = d[1] * w[1], [w[2]] = expr.zero, [w[3]] = d[3] * w[3] }
  return { shift = d, groups = changed(eq.groups, function(name, e)
    return of_attitude[name] and calculus.substitute(e, map) or e
  end) }
end

-- The frame of the series: {groups, rate = the rates by state, and what about_axis or about_momentum give}.  zero: the
-- states that keep their value, by name; moving: the others.
function special.frame(eq, zero, moving)
  local m, rate = eq.model, claim.rates(eq.groups)
  local turns = m.has.rates and m.has.attitude and not eq.inputs
  local seen = turns and (about_axis(eq, zero, rate, moving) or about_momentum(eq, rate)) or { groups = eq.groups }
  seen.rate = rate
  return seen
end

-- The heavy symmetric top, its axis k = z and the force along z in space: nothing but attitude and two rates moves, and
-- W' = i Omega W + K conj(a) b with W = wx + i wy, a = qw + i qz, b = qx + i qy.  Returns the constants of the text in
-- templates/steppers/taylor_top.c, or nil if the motion is another.
-- K is d^2 wx'/(d qw d qx), for Re(conj(a) b) = qw qx + qz qy; the imaginary part is qw qy - qz qx.
function special.top(seen, moving)
  if seen.axis ~= 3 or #moving ~= 6 then return nil end
  local Omega, rate = seen.Omega, seen.rate
  local K = ratio.tidy(calculus.diff(calculus.diff(rate.wx, q[1]), q[2]))
  if K == expr.zero or not steady(K, moving) then return nil end
  local claimed = claim.turning()
  claimed.wx = -Omega * w[2] + K * (q[1] * q[2] + q[3] * q[4])
  claimed.wy = Omega * w[1] + K * (q[1] * q[3] - q[2] * q[4])
  if claim.miss(moving, rate, claimed) then return nil end
  local M = w[3] + Omega
  return { M, K, M / 4, Omega / 2 - M / 4 }
end

return special
