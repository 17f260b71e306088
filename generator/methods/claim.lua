-- claim.lua -- what a special path of a method needs of a scene, and the proof that the scene has no more.
--
-- A special path is code for one motion: it is right where every equation that it stands for is the one that it was
-- made from, and wrong by anything more.  So a path claims the rates of all states that move, and claim.miss proves
-- each of them equal to the scene's by algebra.  A state without a claim, a term that an effect or the base frame adds,
-- rule the path out by themselves: no path lists what it cannot take.  What each needs, in words, is in the `needs` of
-- its module.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"

local claim = {}

-- The rates of the scene by state, without names of definitions.
function claim.rates(groups)
  local put, rates = equations.inlined(groups), {}
  for _, g in ipairs(groups) do
    for _, o in ipairs(g.outs) do rates[o.state] = put(o.expr) end
  end
  return rates
end

-- q' = (q (0, W) - (0, Omega) q)/2 by state: a body that turns at W (nil: w) seen from a base frame that turns at Omega
-- (nil: at rest).
function claim.turning(W, Omega)
  W = W or state.w
  local rate, out = vec.qmul(state.q, { expr.zero, W[1], W[2], W[3] }), {}
  if Omega then rate = vec.sub(rate, vec.qmul({ expr.zero, Omega[1], Omega[2], Omega[3] }, state.q)) end
  for i, name in ipairs(state.names.attitude) do out[name] = rate[i] / 2 end
  return out
end

-- The first of the states whose rate is not the claimed one, or nil: all are.  list: states, {name}; rates, claimed: by
-- name; m: by its derived constants, if they must be known.
function claim.miss(list, rates, claimed, m)
  local map = {}
  for _, member in ipairs(m and m.members or {}) do map[member.sym] = member.e end
  local put = calculus.substitution(map)
  for _, s in ipairs(list) do
    local c = claimed[s.name]
    local rest = c and rates[s.name] - c
    if not c or not (ratio.iszero(rest) or m and ratio.iszero(put(rest))) then return s.name end
  end
  return nil
end

return claim
