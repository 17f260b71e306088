-- rotor.lua -- the free symmetric top (or sphere) with rotors along its axis: regular precession, L with their part.
--
--     I1 w' = (I w + h) x w,  I w + h = I1 (w + s k),  s = (I3/I1 - 1) (k.w)/k^2 + (h.k)/(I1 k^2):  w' = s k x w
-- so that R(t) = exp([L]x t/I1) R(0) exp(-[k]x s t) as without rotors (Volterra 1899, Acta Math. 22, 201).  ABOVE the
-- line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local loads = require "generator.dynamics.closed.loads"
local symmetric = require "generator.dynamics.closed.symmetric"

local rotor = { name = "axial gyrostat" }

function rotor.detect(m)
  local l, other = loads.of(m, true)
  if not l then return nil, other end
  if not l.rotor then return nil, "there is no rotor" end
  if l.damping or l.torque then return nil, "damping or a torque changes the angular momentum", true end
  local s = symmetric.about(m, l.axis)
  if not s then return nil, "no two moments are equal for every value of the parameters", true end
  if not loads.along(l.rotor, s.k) then return nil, "the rotor is not along the symmetry axis", true end
  return { kind = "gyrostat", theorem = "symmetric gyrostat, regular precession",
    text = { "Two moments are equal (I1), the third is I3 about the axis k, along which the rotors hold h.  Seen from",
      "the inertial frame the axis goes round L = I w + h at |L|/I1; in the body w goes round k at",
      "Omega = ((I3 - I1) k.w + h)/I1, |k| = 1; hence",
      "q(t) = (cos, L/|L| sin)(|L|t/2 I1) q(0) (cos, -k sin)(Omega t/2).",
      "Volterra 1899, Acta Math. 22, 201; Landau, Lifshitz, Mechanics, section 33, for h = 0." },
    flags = { symmetric = true, rotor = true }, full = true, ticks = true,
    constants = function(model)
      local c = symmetric.constants(model, s)
      c.hk = model:constant("hk", loads.component(l.rotor, s.k), "momentum of the rotors along the axis, over |k|")
      return c
    end }
end

return rotor
