-- wheel.lua -- a driven reaction wheel: a balanced rotor on an axis of the body, its relative speed W a state.
--
-- With the unit axis a, the wheel's moment J about it and the motor's torque u on the wheel,
--     J (a.w + W)' = u,      (I - J a a^T) w' = ((I - J a a^T) w + J (a.w + W) a) x w - u a + N
-- where I has the wheel in it as if it were locked.  included = true says that the body's tensor is that I; included =
-- false, that the body's tensor has the wheel's mass and its moments across the axis, but not J, and is itself
-- I - J a a^T.  T of the wheel is J (a.w + W)^2/2, and the total L is conserved by the motor: it is an inner torque.
-- With u = 0 a.w + W is constant and so is the energy.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local torque = require "generator.effects.torque"

local wheel = {
  name = "effect.wheel",
  about = "a driven wheel on an axis of the body: its speed relative to the body is a state, a motor turns it",
  reader = "wheel",
  takes = { { "axis", "1", nil, "body axes, of any length" },
    { "inertia", "kg m^2", nil, "J about the axis, positive" },
    { "speed", "rad/s", "0", "W at t = 0, relative to the body" },
    { "torque", "kg m^2/s^2", "0", "of the motor on the wheel: a number, an expression, a table over time" },
    { "included", "true or false", nil, "is J in the body's tensor?" } },
  keeps = "L and |L| with the wheel's part; T+V without torque; w3 if free and along z",
  formula = "J (a.w + W)' = u; (I - J a a^T) w' = ((I - J a a^T) w + J (a.w + W) a) x w - u a",
  term = "N = J (a.w + W) a x w - u a, of the wheel on the body", -- what stands in the equations of the body
  holds = "J (a.w + W) a of each wheel", has = "J (a.w + W)^2/2 of each wheel", -- of L and of T
  signs = "u > 0 speeds the wheel up along its axis and pushes the body the other way; W is relative to the body",
  source = "Hughes, Spacecraft Attitude Dynamics, section 3.5; Schaub, Junkins, Analytical Mechanics " ..
    "of Space Systems, section 4.5",
  example = "wheels",
}

local comp = { "x", "y", "z" }

function wheel.check(a) return { { vec.dot(a.axis, a.axis), "axis must not be zero" } } end

local function length(a) return expr.sqrt(vec.dot(a.axis, a.axis)) end

-- The axis b as it was given, n = |b|, J/n^2, u and n W + b.w.  Of these only n can be irrational, so that the squares
-- of a rounded unit vector never meet exact ones.
local function parts(a, c)
  local b = vec.map(a.axis, function(x, i) return c.constant("a" .. comp[i], x, "axis of the wheel") end)
  local n = c.constant("an", length(a), "length of the wheel's axis vector")
  local J = c.constant("Jw", a.inertia / vec.dot(a.axis, a.axis), "moment of the wheel over the axis squared, kg m^2")
  return b, n, J, c.lift(a.torque, "uw", "torque of the wheel's motor, N m"), n * c.own.wheel + vec.dot(b, c.w)
end

function wheel.states(a)
  return { { name = "wheel", initial = a.speed, unit = "rad/s", about = "speed of the wheel relative to the body" } }
end

function wheel.torque(a, c)
  local b, n, _, u = parts(a, c)
  return vec.scale(-u / n, b)
end

function wheel.momentum(a, c)
  local b, _, J, _, speed = parts(a, c)
  return vec.scale(J * speed, b)
end

-- J (a.w + W)' a is u a, which wheel.torque has already.
function wheel.momentum_rate() return { expr.zero, expr.zero, expr.zero } end

function wheel.derivative(a, c)
  local b, n, _, u = parts(a, c)
  return { wheel = u / c.constant("Jaxis", a.inertia, "moment of the wheel, kg m^2") - vec.dot(b, c.dw) / n }
end

function wheel.kinetic(a, c)
  local _, _, J, _, speed = parts(a, c)
  return J * speed ^ 2 / 2
end

local function own_tensor(a) return vec.scale(a.inertia / vec.dot(a.axis, a.axis), vec.outer(a.axis)) end

-- What it takes from the tensor that the rates carry.
function wheel.carries(a) return a.included and vec.scale(expr.lift(-1), own_tensor(a)) or nil end

-- What it adds to the body's tensor when it is held still.
function wheel.locks(a) return not a.included and own_tensor(a) or nil end

-- Without a motor a.w + W is constant, so the wheel does no work, and along z it does not slow w3 down.
function wheel.conserves(a)
  local list, free = { "L" }, a.torque == expr.zero
  if free then list[2] = "T+V" end
  if free and a.axis[1] == expr.zero and a.axis[2] == expr.zero then list[3] = "w3" end
  return list
end

function wheel.numeric(a, num, _, code)
  local free = not a.rows and #expr.symbols(a.torque) == 0
  return { kind = "wheel", axis = vec.map(a.axis, num), inertia = num(a.inertia),
    included = a.included, torque = free and num(a.torque) or torque.varying(a.torque, a.rows, num, code) }
end

return wheel
