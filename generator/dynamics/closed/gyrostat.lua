-- gyrostat.lua -- the free gyrostat of any moments, its rotors along one of the axes x, y, z, which are principal.
--
--     I w' = (I w + h) x w:  u = M3/|M|, M = I w + h, has u'^2 = a quartic in u      (templates/orbit/gyrostat.c)
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local ratio = require "generator.algebra.ratio"
local loads = require "generator.dynamics.closed.loads"

local gyrostat = { name = "asymmetric gyrostat" }

local index = { "0", "1", "2" }

-- The axis along which the rotors hold h, or nil.
local function axis_of(h)
  local axis, others = nil, 0
  for i = 1, 3 do
    if not ratio.iszero(h[i]) then axis, others = i, others + 1 end
  end
  return others <= 1 and (axis or 3) or nil
end

local function diagonal(m)
  for i = 4, 6 do
    if not ratio.iszero(m.inertia[i]) then return false end
  end
  return true
end

-- first, second, third: the axes so renamed that the rotors are along the third.
function gyrostat.detect(m)
  local l, other = loads.of(m, true)
  if not l then return nil, other end
  if not l.rotor then return nil, "there is no rotor" end
  if l.damping or l.torque then return nil, "damping or a torque changes the angular momentum", true end
  if not diagonal(m) then
    return nil, "the axes x, y, z are not principal for every value of the parameters: turn the body", true
  end
  local third = axis_of(l.rotor)
  if not third then
    return nil, "the rotors are along no principal axis: of no component u of the momentum is u'^2 a polynomial in u",
      true
  end
  local first, second = third % 3 + 1, (third + 1) % 3 + 1
  return { kind = "asymmetric gyrostat", theorem = "asymmetric gyrostat, theta functions",
    text = { "The rotors hold h along the principal axis 3.  M = I w + h e3 (inertial axes) and w.I w are constant;",
      "u = M3/|M| has u'^2 = a quartic in u (Volterra 1899, Acta Math. 22, 201; Wittenburg, Dynamics of Multibody",
      "Systems).  The attitude is a pair a, b with |a|^2 = (1 + u)/2, |b|^2 = (1 - u)/2, each exp(i mu t) theta1 or",
      "theta2 of z - i eta, with mu and eta of its own; the rates are products of two of these.  Set up in twice the",
      "working precision; four real roots or two, permanent rotations, separatrices and h = 0 are limits." },
    full = true, ticks = true,
    flags = { lagrange = true, first = index[first], second = index[second], third = index[third] },
    constants = function(model)
      local function moment(name, i)
        local about = "moment of inertia about " .. string.sub("xyz", i, i) .. ", kg m^2"
        return model:constant(name, model.inertia[i], about)
      end
      return { I1 = moment("I1", first), I2 = moment("I2", second), I3 = moment("I3", third),
        hr = model:constant("hr", l.rotor[third], "momentum of the rotors, N m s") }
    end }
end

return gyrostat
