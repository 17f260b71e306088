-- semi.lua -- the semi-implicit step: one evaluation of the torque, rates first, then the attitude by the new rates.
--
--     w1 = w + h f(q, w, t),   q1 = q (1, h w1/2)/|q (1, h w1/2)|       (Cayley's map: |q| = 1 after every step)
-- In principal axes the products of Euler's equations take each new component as soon as it is there,
--     w1' = w1 + h (c1 w2 w3 + ..), w2' = w2 + h (c2 w3 w1' + ..), w3' = w3 + h (c3 w1' w2' + ..)
-- three shears that keep the volume in the space of rates; it costs nothing.  Position follows velocity in the same
-- way.  Order 1.  Source: Hairer, Lubich, Wanner, Geometric Numerical Integration (2nd ed.), I.1.2 (symplectic Euler)
-- and VI.3.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local moving = require "generator.dynamics.moving"
local state = require "generator.dynamics.state"
local attitude = require "generator.methods.attitude"
local stages = require "generator.methods.stages"

local semi = { name = "semi", order = 1, title = "semi-implicit Euler method, of order 1",
  about = "semi-implicit Euler, one evaluation a step, order 1, fixed step, the cheapest" }

local h, q, w = state.h, state.q, state.w
local in_turn = { wx = true, wy = true, wz = true, rx = true, ry = true, rz = true }

-- The step as equation groups with outs {state, expr}.
function semi.groups(eq)
  local m, zero = eq.model, stages.conserved(eq)
  local list, new, finals = {}, {}, {}
  local sequential = m.structure and m.structure.kind ~= "full"
  local waiting = {} -- position, which takes the new velocity
  local function step(g, o, why)
    if zero[o.state] or attitude.is[o.state] then return end
    local s = m.states.by_name[o.state]
    local e = calculus.substitute(o.expr, in_turn[o.state] and (sequential or string.find(o.state, "^r")) and new or {})
    local name = o.state .. "1"
    while m.by_name[name] do name = name .. "_" end
    local group = list[#list]
    if not group or group.source ~= g then
      group = { why = why, where = g.where, defs = {}, outs = {}, source = g }
      list[#list + 1] = group
      for _, d in ipairs(g.defs) do group.defs[#group.defs + 1] = d end
    end
    group.defs[#group.defs + 1] = { name = name, expr = s.sym + h * e }
    local sym = expr.sym(name, 8)
    if in_turn[o.state] or s.kind == "velocity" then new[s.sym] = sym end
    finals[#finals + 1] = { state = o.state, expr = sym }
  end
  for _, g in ipairs(eq.groups) do
    if #g.outs == 0 and #g.defs > 0 then list[#list + 1] = { why = g.why, where = g.where, defs = g.defs, outs = {} } end
    for _, o in ipairs(g.outs) do
      local s = m.states.by_name[o.state]
      if s.kind == "position" then
        waiting[#waiting + 1] = { g, o }
      else
        step(g, o, g.why .. "; x + h x'")
      end
    end
  end
  for _, p in ipairs(waiting) do step(p[1], p[2], p[1].why .. ", the new one") end
  local last = { why = "the new state", defs = {}, outs = finals }
  if m.has.attitude then
    local define = function(name, e)
      while m.by_name[name] do name = name .. "_" end
      last.defs[#last.defs + 1] = { name = name, expr = e }
      return expr.sym(name, 8)
    end
    last.why = "q1 = q (1, b)/|q (1, b)|, b = h w1/2"
    local hh = define("hh", h / 2)
    local b = vec.map(w, function(s, i) return define("b" .. attitude.comp[i], hh * (new[s] or s)) end)
    local p = vec.qmul(q, { expr.one, b[1], b[2], b[3] })
    if m.frame then
      local turn, defs = moving.rate(m)
      for _, d in ipairs(#list == 0 and defs or {}) do last.defs[#last.defs + 1] = d end
      local B = vec.scale(hh, turn)
      p = vec.qmul({ expr.one, -B[1], -B[2], -B[3] }, p)
    end
    for i, a in ipairs { "w", "x", "y", "z" } do p[i] = define("p" .. a, p[i]) end
    local n = define("n", expr.lift(1) / expr.sqrt(p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2 + p[4] ^ 2))
    for i, name in ipairs(state.names.attitude) do finals[#finals + 1] = { state = name, expr = n * p[i] } end
  end
  list[#list + 1] = last
  return list
end

return semi
