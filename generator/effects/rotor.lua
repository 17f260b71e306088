-- rotor.lua -- a rotor that spins inside the body with constant relative angular momentum: the gyrostat.
--
-- h = momentum axis/|axis| in body axes is what the rotor has beyond turning along with the body; its mass and its
-- moments belong to the body's (the rotor is symmetric about its axis, so these do not change).
--     I w' = (I w + h) x w + N
-- A motor keeps h, so it does work: what is constant without other torques is w.I w/2 and I w + h in inertial axes.
-- Volterra 1899, Acta Math. 22, 201; Hughes, Spacecraft Attitude Dynamics (1986), on gyrostats.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local rotor = {
  name = "effect.rotor",
  about = "a rotor in the body: constant angular momentum relative to it, momentum along axis (body)",
  idle = { { "momentum" } },
  formula = "I w' = (I w + h) x w + N, h = momentum axis/|axis|",
  term = "N = h x w, h = momentum axis/|axis|",
  holds = "h of the rotor",
  signs = "h is what the rotor has beyond turning with the body; its mass and moments are in the body's",
  source = "Volterra, Acta Math. 22 (1899) 201; Hughes, Spacecraft Attitude Dynamics, on gyrostats",
  example = "gyrostat",
  args = { { name = "axis", size = 3 }, { name = "momentum", dim = "angular_momentum" } },
  keeps = "T+V (T of the body), L and |L| with the rotor's part, w3 if axis is the symmetry axis",
}

function rotor.check(a) return { { vec.dot(a.axis, a.axis), "axis must not be zero" } } end

local function held(a)
  local length = expr.sqrt(vec.dot(a.axis, a.axis))
  return vec.map(a.axis, function(x) return ratio.tidy(a.momentum * x / length) end)
end
rotor.held = held -- the closed forms ask for it, too

function rotor.momentum(a, c)
  return vec.map(held(a), function(x, i)
    local name = string.sub("xyz", i, i)
    return c.constant("H" .. name, x, "angular momentum of the rotor along " .. name .. ", N m s")
  end)
end

-- w3 where h is along z: then (h x w)_z = 0.
function rotor.conserves(a)
  local along = a.axis[1] == expr.zero and a.axis[2] == expr.zero
  return along and { "T+V", "L", "w3" } or { "T+V", "L" }
end

function rotor.numeric(a, num) return { kind = "rotor", momentum = vec.map(held(a), num) } end

return rotor
