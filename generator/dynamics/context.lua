-- context.lua -- what an effect is given when it is asked for its torque, force and so on.
--
-- The fields are listed in effects/effects.lua.  A force and a potential are proportional to constants of the effect;
-- what counts in m r'' = F is each divided by the mass, so per_mass keeps that quotient as the constant and writes M,
-- a symbol that stands for the mass and cancels.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local state = require "generator.dynamics.state"

local context = {}

local M = expr.sym("the mass", 1)
context.M = M

-- The tensor's entries as derived constants, Ixx .. Iyz; zeros stay zero.
function context.inertia(m)
  return vec.map(m.inertia, function(e, n)
    local what = n > 3 and "tensor entry " or "moment of inertia "
    return m:constant("I" .. vec.entry[n], e, what .. vec.entry[n] .. ", kg m^2", m.parts ~= nil,
      m.parts and m.parts.entries[n])
  end)
end

-- The entries of I, a tensor of the model, as derived constants; about: what it is.
local function entries(m, I, about)
  if I == m.inertia then return context.inertia(m) end
  return vec.map(I, function(e, n)
    return m:constant("I" .. vec.entry[n], e, about .. ", " .. vec.entry[n] .. ", kg m^2")
  end)
end

-- The entries of the tensor that the rates carry: the body's, without the moments of wheels that turn in it.
function context.carried(m) return entries(m, m.carried, "tensor without the wheels' own moments") end

-- In what follows `constant` is what keeps the effects' derived constants: nil, the model; a function; false, nothing
-- does, and the body's own are not kept either.

-- What moving parts add to the tensor as a function of the state (m.record's effects), or nil.
function context.parts(m, constant)
  local sum
  for _, e in ipairs(m.record.effects) do
    local c = context.of(m, constant)
    local part = e.spec.varies and e.spec.varies(e.a, context.with(c, e))
    if part then sum = sum and vec.add(sum, part) or part end
  end
  return sum
end

-- The tensor that the rates carry, of the state; second result: with parts that move.
function context.now(m, constant)
  local parts, I = context.parts(m, constant), constant == false and (m.carried or m.inertia) or context.carried(m)
  if not parts then return I, false end
  return vec.add(I, parts), true
end

-- What effects hold beside I w.
function context.held(m, constant)
  local h, c = { expr.zero, expr.zero, expr.zero }, context.of(m, constant)
  for _, e in ipairs(m.record.effects) do
    if e.spec.momentum then h = vec.add(h, e.spec.momentum(e.a, context.with(c, e))) end
  end
  return h
end

-- I of docs/mechanics.md: the tensor of everything with the wheels held still and the moving parts as they are.
function context.locked(m, constant)
  local parts = context.parts(m, constant)
  local I = constant == false and (m.locked or m.inertia) or entries(m, m.locked, "tensor with all wheels held still")
  return parts and vec.add(I, parts) or I
end

-- L of docs/mechanics.md, of all that turns, in body axes.
function context.momentum(m, constant)
  return vec.add(vec.apply((context.now(m, constant)), state.w), context.held(m, constant))
end

-- Has I no products, whatever moves?
local function diagonal(m)
  for i = 4, 6 do
    if (m.locked or m.inertia)[i] ~= expr.zero then return false end
  end
  for _, e in ipairs(m.record.effects) do
    if e.spec.varies and #e.states > 0 then return false end
  end
  return true
end

local none = { expr.zero, expr.zero, expr.zero }

-- The fields are those of effects/effects.lua; the tensor and the momentum are made when an effect asks for them.
function context.of(m, constant)
  local keeps = constant
  if constant == false then
    constant = function(_, e) return e end
  elseif constant == nil then
    constant = function(name, e, about, positive)
      e = m:constant(name, e, about)
      if positive then m:positive(e) end
      return e
    end
  end
  return { mass = m.mass, com = m.com, origin = m.origin, inertia = m.locked or m.inertia, has = m.has, q = state.q,
    w = state.w, r = state.r, v = state.v, u = state.u, t = state.t, M = M, constant = constant, dw = none,
    lift = function(e, name, about) return motion.lift(e, function(x) return constant(name, x, about) end) end,
    diagonal = diagonal(m), tensor = function() return context.locked(m, keeps) end,
    momentum = function() return context.momentum(m, keeps) end,
    L = function() return vec.apply(context.locked(m, keeps), state.w) end, -- the equations give names to its entries
    per_mass = function(name, e, about) return constant(name, e / m.mass, about .. " per kg") * M end }
end

-- The context with the symbols of the effect's own states.
function context.with(c, e)
  c.own = e.own or {}
  return c
end

-- The formula of an effect as the scene has it.
function context.formula(e) return e.spec.said and e.spec.said(e.a) or e.spec.formula end

-- For looking only: constants are not kept.
function context.dry(m) return context.of(m, false) end

-- What the effects add to the energy, the mass as context.M.  part: "kinetic", of what turns in the body; "potential",
-- of what acts; "turning", the potential of fields that turn, which is none in inertial axes.
function context.energy(m, c, part)
  local sum = expr.zero
  for _, e in ipairs(m.record.effects) do
    local own = e.spec[part] and e.spec[part](e.a, context.with(c, e))
    if own then sum = sum + (part == "turning" and own.potential or own) end
  end
  return sum
end

-- The mass as a constant of the model.
function context.mass(m)
  return m:constant("mass", m.mass, "mass, kg", false, m.parts and m.parts.mass)
end

-- e/M of what is linear in M, a M + b: M cancels where e is proportional to it.
function context.divided(e)
  if expr.constant(e, { [M.name] = true }) then return e / M end
  return calculus.diff(e, M) + calculus.substitute(e, { [M] = expr.zero }) / M
end

-- e with the model's mass in place of M where it is left.
function context.massive(m, e)
  if expr.constant(e, { [M.name] = true }) then return e end
  return calculus.substitute(e, { [M] = context.mass(m) })
end

-- V of what acts, with the model's constants.
function context.potential(m) return context.massive(m, context.energy(m, context.of(m), "potential")) end

return context
