-- custom.lua -- an effect that the scene writes itself, with the rights of those here.
--
--     effect.custom { params = {..}, torque = function(s) return {..} end, force = .., potential = .., states = {..} }
-- Each function receives s: lists s.w, s.q, s.r, s.v, s.L (I w, body axes), the time s.t, and the effect's own
-- parameters and states by name; torque is in body axes, force (on the centre of mass) in inertial ones.  With a
-- potential and no torque, N_i = -dV along a turn about body axis i, by q' = q (0, w)/2; with a potential and no force,
-- F = -dV/dr.  A torque or force that is given is all of it.  states = {name = {initial =, unit =, rate = function}}.
-- Which laws it keeps is decided from its expressions (dynamics/laws.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"

local custom = {
  name = "effect.custom",
  about = "the scene's own: torque, force, potential, states as functions of the motion",
  takes = { { "params", "any", "{}", "values by name, of three or more small letters; a function reads the value of " ..
    "gain as s.gain" },
    { "torque", "kg m^2/s^2", nil, "function(s) that returns three components, body axes; s has the lists s.w, s.q, " ..
      "s.r, s.v and s.L (I w), the time s.t, and params and states by name" },
    { "force", "kg m/s^2", nil, "function(s) that returns three components, inertial axes" },
    { "potential", "kg m^2/s^2", nil, "function(s) that returns one value" },
    { "states", "any", "{}", "{name = {initial =, unit =, rate = function(s)}}; a function reads the " ..
      "state heat as s.heat" } },
  reader = "custom", decided = true, keeps = "what its expressions show",
  formula = "as the scene writes it; from a potential N_i = -dV along a turn about body axis i, F = -dV/dr",
  signs = "torque in body axes, force on the centre of mass in inertial axes, potential in J",
  source = "the scene",
  example = "magnet_pendulum",
}

-- What of the formula these functions have.
function custom.said(a)
  local from = {}
  if a.potential and not a.torque then from[1] = "N_i = -dV along a turn about body axis i" end
  if a.potential and not a.force then from[#from + 1] = "F = -dV/dr" end
  return "as the scene writes it" .. (#from > 0 and "; from a potential " .. table.concat(from, ", ") or "")
end

-- e with what is constant lifted out, and then the effect's own names and L filled in.
local function filled(a, c, e, name)
  local map, L = {}, nil
  e = c.lift(e, name, "constant of effect.custom")
  for _, p in ipairs(a.params) do
    map[expr.sym("@" .. p.name, 6)] = c.constant(p.name, p.e, p.name .. ", parameter of effect.custom, " .. p.unit)
  end
  for _, s in ipairs(a.states) do map[motion.sym("@" .. s.name)] = c.own[s.name] end
  for i, n in ipairs { "@Lx", "@Ly", "@Lz" } do
    if not expr.constant(e, { [n] = true }) then
      L = L or c.L()
      map[motion.sym(n)] = L[i]
    end
  end
  return calculus.substitute(e, map)
end

local function all(a, c, v, name) return vec.map(v, function(e) return filled(a, c, e, name) end) end

function custom.states(a)
  return vec.map(a.states, function(s)
    return { name = s.name, initial = s.initial, unit = s.unit, about = "state of effect.custom" }
  end)
end

function custom.derivative(a, c)
  local rates = {}
  for _, s in ipairs(a.states) do rates[s.name] = filled(a, c, s.rate, "rate") end
  return rates
end

function custom.potential(a, c) return a.potential and filled(a, c, a.potential, "V") or expr.zero end

-- From a potential: minus its slope along q' = q (0, e_i)/2.
function custom.torque(a, c)
  if a.torque then return all(a, c, a.torque, "custom") end
  local V, zero = custom.potential(a, c), expr.zero
  local slope = vec.map(c.q, function(x) return calculus.diff(V, x) end)
  local N = {}
  for i = 1, 3 do
    local turn = vec.qmul(c.q, { zero, i == 1 and expr.one or zero, i == 2 and expr.one or zero,
      i == 3 and expr.one or zero })
    N[i] = zero
    for k = 1, 4 do N[i] = N[i] - slope[k] * turn[k] / 2 end
  end
  return N
end

-- Does it push the centre of mass?
function custom.pushes(a)
  if a.force then return true end
  local place = { rx = true, ry = true, rz = true }
  return a.potential ~= nil and not expr.constant(a.potential, place)
end

function custom.force(a, c)
  if a.force then return all(a, c, a.force, "custom") end
  local V = custom.potential(a, c)
  return vec.map(c.r, function(x) return -calculus.diff(V, x) end)
end

-- For the library: a torque (body axes) and a force of expressions, as an act of its own.
function custom.told(torque, force, code)
  local nothing = { expr.zero, expr.zero, expr.zero }
  return { kind = "custom", torque = vec.map(torque or nothing, code), force = vec.map(force or nothing, code),
    potential = code(expr.zero), states = {} }
end

-- Everything as code: the library is told what the scene says, and nothing of what follows from it here but the
-- gradient of a potential.
function custom.numeric(a, _, _, code, c)
  return { kind = "custom", torque = vec.map(custom.torque(a, c), code), force = vec.map(custom.force(a, c), code),
    potential = code(custom.potential(a, c)),
    states = vec.map(a.states, function(s) return code(filled(a, c, s.rate, "rate")) end) }
end

return custom
