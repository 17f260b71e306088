-- attitude.lua -- the rate of the attitude: q' = q (0, w)/2.
--
-- With what is added in a base frame that turns, and where effects let the body's axes turn beside w.  ABOVE the
-- line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local moving = require "generator.dynamics.moving"
local state = require "generator.dynamics.state"

local attitude = {}

-- The rate W at which the body's axes turn, where effects say that it is not w, named in the group; else nil.
local function axes_turn(m, g)
  local W, c = nil, context.of(m)
  for _, e in ipairs(m.record.effects) do
    if e.spec.turn then W = vec.add(W or state.w, e.spec.turn(e.a, context.with(c, e))) end
  end
  if not W then return nil end
  g.why, g.turn = "attitude: q' = q (0, W)/2, W the rate at which the axes turn", {}
  for i = 1, 3 do
    g.defs[i] = { name = "W" .. string.sub("xyz", i, i), expr = W[i] }
    g.turn[i] = expr.sym("W" .. string.sub("xyz", i, i), 7)
  end
  return g.turn
end

-- q' = (q (0, w) - (0, Omega) q)/2, Omega the rate of the base frame.
-- place(m, line): where it stands in the scene.
function attitude.group(m, place)
  local w, q = state.w, state.q
  local g = { why = "attitude: q' = q (0, w)/2", defs = {}, outs = {} }
  w = axes_turn(m, g) or w
  local rate = vec.qmul(q, { expr.zero, w[1], w[2], w[3] })
  if m.frame then
    local turn, defs = moving.rate(m)
    rate = vec.sub(rate, vec.qmul({ expr.zero, turn[1], turn[2], turn[3] }, q))
    for _, def in ipairs(defs) do g.defs[#g.defs + 1] = def end
    g.why = "attitude in the turning frame: q' = (q (0, w) - (0, Omega) q)/2"
    g.where = place(m, m.frame.line)
  end
  for i, n in ipairs(state.names.attitude) do g.outs[i] = { state = n, expr = rate[i] / 2 } end
  return g
end

return attitude
