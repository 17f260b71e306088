-- point.lua -- a point under constant and linear forces, in axes at rest or turning steadily (templates/orbit/point.c).
--
-- At rest each coordinate is r'' = g - kappa r.  In a frame that turns at Omega n, across n and as complex numbers
-- (i: the quarter turn about n),
--     z'' + 2 i Omega z' - delta z = gamma,   delta = Omega^2 - kappa, without the centrifugal term -kappa,
-- whose rates are Omega +- sigma, sigma^2 = Omega^2 - delta:
--     z = e^(-i Omega t) (z0 cos sigma t + (z0' + i Omega z0) sin(sigma t)/sigma) + gamma P(t),
--     P = integral over s from 0 to t of e^(-i Omega s) sin(sigma s)/sigma.
-- sigma = 0: straight lines seen from the frame; kappa > 0, no centrifugal term: Foucault's pendulum.
-- Landau, Lifshitz, Mechanics, section 39; Synge, Griffith, Principles of Mechanics, section 13.5.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local context = require "generator.dynamics.context"
local moving = require "generator.dynamics.moving"

local point = { name = "point under constant and linear forces" }

local function zero(e) return e == expr.zero or ratio.iszero(e) end
point.zero = zero

-- Why the force of effect.translation is not made of constant and linear ones; a: its arguments.
function point.varies(a)
  if not (zero(a.drag) and zero(a.linear)) then return "drag slows the centre of mass" end
  for i = 1, 3 do
    if not zero(a.thrust[i]) then return "the thrust turns with the body" end
  end
  return motion.any(a.force) and "the force varies with the motion" or nil
end

-- The acceleration by gravity and the constant force of effect.translation (t), as constants of the model.
function point.steady(model, t)
  local g = t.spec.strengths(t.a, context.with(context.of(model), t))
  return vec.map(t.a.force, function(force, i)
    if zero(force) then return g[i] end
    local axis = string.sub("xyz", i, i)
    return model:constant("pull" .. axis, t.a.gravity[i] + force / model.mass, "acceleration by all constant forces " ..
      axis .. ", m/s^2")
  end)
end

-- The axis along which the frame turns for every value of the parameters; nil: oblique.
local function axis_of(rate)
  local found
  for i = 1, 3 do
    if not zero(rate[i]) then
      if found then return nil end
      found = i
    end
  end
  return found
end

-- Across an oblique or given axis the stiffness must be one.
local function isotropic(k, axis)
  local function same(i, j) return zero(k[i] - k[j]) end
  if not axis then return same(1, 2) and same(2, 3) end
  return same(axis % 3 + 1, (axis + 1) % 3 + 1)
end

local plain = { "Constant and linear forces: each coordinate is a parabola, an oscillation or an exponential." }
local framed_text = {
  "Across the axis n of the frame, Omega n its rate, i the quarter turn about n, g the constant force",
  "z = exp(-i Omega t) (z0 cos(sigma t) + (v0 + i Omega z0) sin(sigma t)/sigma) + g P(t),",
  "sigma^2 = k/m, without the centrifugal term Omega^2 + k/m; P is the integral of the second solution.  Along n it",
  "is a parabola, an oscillation or an exponential.  Landau, Lifshitz, Mechanics, section 39." }

-- Only effect.translation of constant and linear forces, and a frame that turns steadily.
function point.detect(m)
  if not m.has.position then
    return nil, contact.of(m) and "the body touches a plane" or "nothing moves the centre of mass"
  end
  if m.has.rates then return nil, "the body also turns" end
  local t
  for _, e in ipairs(m.record.effects) do
    if e.kind == "effect.translation" then
      t = e
    elseif e ~= m.frame then
      return nil, string.gsub(e.kind, "effect%.", "") .. " acts on the point", true
    end
  end
  local varies = t and point.varies(t.a)
  if varies then return nil, varies, true end
  local k = t and t.a.stiffness or { expr.zero, expr.zero, expr.zero }
  local frame = m.frame and m.frame.spec.frame(m.frame.a, context.dry(m))
  local axis = frame and axis_of(frame.rate)
  if frame then
    for i = 1, 3 do
      if not zero(frame.rate_dot[i]) then return nil, "the rate of the frame changes", true end
    end
    if not isotropic(k, axis) then return nil, "the stiffness is not one across the axis of the frame", true end
  end
  -- along: the stiffness along the frame's axis, across: that of both directions across it; z if there is none
  local function constants(model)
    local c, list = context.with(context.of(model), t or {}), {}
    local turn = frame and moving.frame(model)
    local g, stiff = t and point.steady(model, t), t and select(2, t.spec.strengths(t.a, c))
    for i = 1, 3 do
      list["g" .. i] = t and g[i] or expr.zero
      list["k" .. i] = t and context.massive(model, context.divided(stiff[i])) or expr.zero
      list["O" .. i] = frame and turn.rate[i] or expr.zero
    end
    local across = (axis or 3) % 3 + 1
    list.across, list.along = list["k" .. across], list["k" .. (axis or 3)]
    return list
  end
  return { kind = "point", theorem = frame and "point in a steadily turning frame, linear forces" or
    "point under constant and linear forces", text = frame and framed_text or plain, full = true,
    pairs = frame and "sums" or "few", constants = constants,
    flags = { framed = frame ~= nil, centrifugal = frame and frame.centrifugal or false,
      axis_x = axis == 1, axis_y = axis == 2 } }
end

return point
