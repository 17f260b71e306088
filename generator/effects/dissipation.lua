-- dissipation.lua -- an energy sink inside the body: the rates lose energy and L in inertial axes stays as it is.
--
-- Double bracket dissipation: with L = I w (and what rotors and wheels hold) in body axes
--     L' = L x w + k L x (L x w) = L x W,      W = w + k L x w,     q' = q (0, W)/2
-- The first equation is Bloch's, Krishnaprasad's, Marsden's and Ratiu's: L is always normal to L', so |L| stays, and
--     T' = w.L' = -k |L x w|^2,
-- so that T falls until w is along L; only the turn about the axis of the largest moment is then stable.
-- The second equation is what makes L stay in inertial axes too: (R L)' = R (L' + W x L) = 0 wants the body axes to
-- turn at any rate W with L' = L x W, and W = w + k L x w is that one whose inner motion vanishes with L x w.
-- Read as physics: L = I W + h, and h = I (w - W) = -k I (L x w) is the angular momentum of small inner parts that run
-- behind, without inertia of their own; w = I^-1 L is the mean rate of the whole.  A plain torque k L x (L x w) with
-- q' = q (0, w)/2 would keep |L| too, but turn L in space.
-- SPDX-License-Identifier: GPL-3.0-or-later

local vec = require "generator.algebra.vec"

local dissipation = {
  name = "effect.dissipation",
  about = "inner energy sink k (double bracket): T falls, L in inertial axes stays",
  args = { { name = "k", dim = "sink", sign = "nonnegative", about = "strength: T' = -k |L x w|^2" } },
  single = true, conserves = { "L" },
  idle = { { "k" }, "the three moments of inertia are equal" },
  formula = "I w' = L x w + k L x (L x w) + N, q' = q (0, w + k L x w)/2, L = I w + h",
  signs = "k > 0 takes energy, T' = -k |L x w|^2; w = I^-1 L is the mean rate, the body axes turn at w + k L x w",
  source = "Bloch, Krishnaprasad, Marsden, Ratiu, Commun. Math. Phys. 175 (1996) 1; the attitude: derived here",
  example = "energy_sink",
}

local function parts(a, c)
  local L = c.momentum()
  return L, vec.scale(c.constant("sink", a.k, "strength of the energy sink, 1/(N m s)"), vec.cross(L, c.w))
end

function dissipation.torque(a, c) return vec.cross(parts(a, c)) end

function dissipation.turn(a, c)
  local _, slip = parts(a, c)
  return slip
end

function dissipation.numeric(a, num) return { kind = "dissipation", k = num(a.k) } end

return dissipation
