-- rotating_frame.lua -- the base frame turns: position, velocity and attitude are relative to it.
--
-- Omega(t) = rate + rate_dot t, in the axes of the frame, is its rate relative to an inertial frame.  The centre of
-- mass has the Coriolis, centrifugal and Euler terms (dynamics/moving.lua), the attitude q from body to frame axes
--     q' = (q (0, w) - (0, Omega) q)/2,
-- while w stays the inertial rate in body axes, so that torques enter as always.  What other effects call inertial
-- axes are then those of the frame.  Landau, Lifshitz, Mechanics, section 39.
-- centrifugal = false leaves Omega x (Omega x r) out: the usual linearised pendulum of Foucault, where the local
-- gravity already contains it.
-- With a constant rate Jacobi's integral is conserved (Landau, Lifshitz, 39.11): with v and w relative to the frame
--     T + V - m (Omega x r)^2/2     and for the turning    T - Omega.L + V,    L of all that turns, rotors and wheels.
-- Alone, it moves a body whose initial position or velocity is given.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local frame = {
  name = "effect.rotating_frame",
  about = "the base frame turns at rate + rate_dot t (its own axes): Coriolis, centrifugal and Euler terms",
  args = { { name = "rate", dim = "rate", size = 3 },
    { name = "rate_dot", dim = "rate_dot", size = 3, default = { 0, 0, 0 } },
    { name = "centrifugal", flag = true, default = true } },
  idle = { { "rate" } },
  formula = "m v' = F - 2 m Omega x v - m Omega x (Omega x r) - m Omega' x r; q' = (q (0, w) - (0, Omega) q)/2",
  signs = "Omega = rate + rate_dot t is the frame's rate in its own axes; r, v, q are relative to it, w is inertial",
  source = "Landau, Lifshitz, Mechanics, 3rd ed., section 39",
  example = "foucault",
  single = true, keeps = "T+V if rate is constant or the body only turns, |L|, w3, L_z if rate is along z",
}

local comp = { "x", "y", "z" }

function frame.moves(given) return given.position ~= nil or given.velocity ~= nil end

-- The base frame's motion: rate and rate_dot (their constants), and whether the centrifugal term counts.
function frame.frame(a, c)
  local function constants(name, v, about)
    return vec.map(v, function(x, i) return c.constant(name .. comp[i], x, about) end)
  end
  return { rate = constants("O", a.rate, "rate of the base frame, rad/s"),
    rate_dot = constants("A", a.rate_dot, "its rate of change, rad/s^2"), centrifugal = a.centrifugal }
end

local function steady(a)
  return a.rate_dot[1] == expr.zero and a.rate_dot[2] == expr.zero and a.rate_dot[3] == expr.zero
end

-- With a changing rate there is no potential: energy is then kinetic relative to the frame (of the turning: inertial)
-- plus the potential of the other effects.
function frame.potential(a, c)
  if not steady(a) then return expr.zero end
  local f, V = frame.frame(a, c), expr.zero
  if c.has.position and a.centrifugal then
    local u = vec.cross(f.rate, c.r)
    V = -c.M * vec.dot(u, u) / 2
  end
  if c.has.attitude then
    V = V - vec.dot(f.rate, vec.matvec(vec.rotation(c.q), c.momentum()))
  end
  return V
end

function frame.conserves(a, c)
  local list = { "|L|", "w3" }
  if steady(a) or not c.has.position then list[#list + 1] = "T+V" end -- a rate that changes has no potential, nor work
  local upright = true
  for i = 1, 2 do upright = upright and a.rate[i] == expr.zero and a.rate_dot[i] == expr.zero end
  if upright then list[#list + 1] = "L_z" end
  return list
end

function frame.numeric(a, num, given)
  return { kind = "rotating_frame", rate = vec.map(a.rate, num), rate_dot = vec.map(a.rate_dot, num),
    centrifugal = a.centrifugal, moves = given.position ~= nil or given.velocity ~= nil }
end

return frame
