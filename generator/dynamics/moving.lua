-- moving.lua -- the motion of the centre of mass, and the base frame that it is seen from.
--
--     r' = v,   m v' = F - 2 m Omega x v - m Omega x (Omega x r) - m Omega' x r
-- F the sum of the effects' forces; Omega(t) the rate of the base frame in its own axes, zero without
-- effects/rotating_frame.lua (Goldstein, Poole, Safko, 3rd ed., 4.91; Landau, Lifshitz, Mechanics, 39.7).  Written as
--     - Omega x (2 v + Omega x r) - Omega' x r
-- which takes 12 products.  Without the centrifugal term (`centrifugal = false`) it is - 2 Omega x v - Omega' x r.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local state = require "generator.dynamics.state"

local moving = {}

local axis_name = { "x", "y", "z" }

local function frame(m) return m.frame and m.frame.spec.frame(m.frame.a, context.with(context.of(m), m.frame)) end
moving.frame = frame

-- A product with a sum in it is one, too: it is worth a name.
local function is_sum(e)
  if e.kind ~= "mul" then return e.kind == "add" end
  for i = 1, #e do
    if e[i].kind == "add" then return true end
  end
  return false
end

-- Sums become definitions prefix..x of the group.
local function named(m, defs, prefix, v)
  return vec.map(v, function(e, i)
    if not is_sum(e) then return e end
    local name = prefix .. axis_name[i]
    while m.by_name[name] do name = name .. "_" end
    defs[#defs + 1] = { name = name, expr = e }
    return expr.sym(name, 7)
  end)
end

-- Omega(t) and the definitions it needs.
function moving.rate(m)
  local f, defs = frame(m), {}
  return named(m, defs, "Omega_", vec.add(f.rate, vec.scale(state.t, f.rate_dot))), defs
end

-- The groups of r and v.  first: a group that has already defined Omega (the attitude's), or nil.
function moving.groups(m, first)
  local list = { { why = "velocity: r' = v", defs = {}, outs = {}, line = m.moving.line } }
  local g = { why = "centre of mass: m v' = F", defs = {}, outs = {}, line = m.moving.line }
  local c, a = context.of(m), { expr.zero, expr.zero, expr.zero }
  for _, e in ipairs(m.record.effects) do
    if e.spec.force then a = vec.add(a, e.spec.force(e.a, context.with(c, e))) end
  end
  a = vec.map(a, function(x) return context.massive(m, context.divided(x)) end)
  local f = frame(m)
  if f then
    local turn, defs = moving.rate(m)
    if not (first and m.has.attitude) then g.defs = defs end
    local s = vec.scale(expr.lift(2), state.v)
    g.why = g.why .. " - 2 m Omega x v"
    if f.centrifugal then
      s, g.why = vec.add(s, vec.cross(turn, state.r)), g.why .. " - m Omega x (Omega x r)"
      s = named(m, g.defs, "V", s)
    end
    a = vec.sub(a, vec.cross(turn, s))
    local euler = vec.cross(f.rate_dot, state.r)
    if euler[1] ~= expr.zero or euler[2] ~= expr.zero or euler[3] ~= expr.zero then
      a, g.why = vec.sub(a, euler), g.why .. " - m Omega' x r"
    end
  end
  for i = 1, 3 do
    list[1].outs[i] = { state = state.names.position[i], expr = state.v[i] }
    g.outs[i] = { state = state.names.velocity[i], expr = a[i] }
  end
  list[2] = g
  return list
end

return moving
