-- axial.lua -- a symmetric top (or sphere) with damping, constant torque and rotors along its axis: the rates.
--
-- Torque n k - C w - w x h, C = c1 across and c3 along k, h = b k; s = (k.w)/k^2:
--     I3 s' = n - c3 s               s = s0 exp(-c3 t/I3) + n/I3 t f1,   f1 = (exp(y) - 1)/y at y = -c3 t/I3
--     I1 a' = ((I3 - I1) s + b) k x a - c1 a,   a = w - s k: it turns about k by the angle
--     |k| ((I3/I1 - 1) (s0 t f1 + n/I3 t^2 f2) + b t/I1),   f2 = (exp(y) - 1 - y)/y^2,  and fades with exp(-c1 t/I1)
-- Without damping the angle is quadratic in time.  The attitude q' = q (0, w)/2 then is Landau and Zener's equation
-- (parabolic cylinder functions: Zener 1932, Proc. R. Soc. A 137, 696), damped the confluent hypergeometric one; it
-- closes by elementary functions where a = 0 (spin about the axis) and for damping proportional to L (damped.lua).
-- Euler's equations: Goldstein 5.39.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local principal = require "generator.mass.principal"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local loads = require "generator.dynamics.closed.loads"
local symmetric = require "generator.dynamics.closed.symmetric"

local axial = { name = "symmetric top with axial torque or damping, rates" }

-- A direction for a sphere: that of the rotor, of the torque, or of the damping's own axis.
-- Any axis is one of symmetry of a sphere; the one that what acts has, if it has one.
local function direction(l)
  if l.axis then return l.axis end
  if l.torque and not ratio.iszero(vec.dot(l.torque, l.torque)) then return l.torque end
  local C = l.damping
  local s = C and principal.classify { C[1][1], C[2][2], C[3][3], C[1][2], C[1][3], C[2][3] }
  return s and s.k or { expr.zero, expr.zero, expr.one }
end

-- Damping must be symmetric about the axis, torque and rotor along it: then k.w has an equation of its own.
function axial.detect(m)
  local l, other = loads.of(m)
  if not l then return nil, other end
  if not l.damping and not l.torque then return nil, "there is neither damping nor a torque in body axes" end
  local s = symmetric.about(m, m.structure.kind == "sphere" and direction(l))
  if not s then return nil, "no two moments are equal for every value of the parameters" end
  if l.torque and not loads.along(l.torque, s.k) then return nil, "the torque is not along the symmetry axis", true end
  if l.rotor and not loads.along(l.rotor, s.k) then return nil, "the rotor is not along the symmetry axis", true end
  local c1, c3 = expr.zero, expr.zero
  if l.damping then c1, c3 = loads.coaxial(l.damping, s.k) end
  if not c1 then return nil, "the damping is not symmetric about the symmetry axis", true end
  return { kind = "axial", theorem = "symmetric top with " .. (l.torque and "constant axial torque" or "") ..
      (l.torque and l.damping and " and " or "") .. (l.damping and "axial damping" or "") .. ": the rates",
    text = { "s = k.w along the axis k (|k| = 1) obeys I3 s' = N - c3 s; the rates across it turn about k at",
      "((I3 - I1) s + h)/I1" .. (l.damping and " and fade with exp(-c1 t/I1)" or "") .. ": " .. (l.damping and
      "an angle of linear and exponential terms." or "an angle quadratic in time."),
      "Of the attitude there is no elementary form: q' = q (0, w)/2 is " .. (l.damping and
      "a confluent hypergeometric equation," or "Landau and Zener's equation (parabolic cylinder functions),"),
      "but for spin about the axis alone" .. (l.damping and " and damping proportional to L" or "") ..
      ".  Goldstein 5.39; Zener 1932, Proc. R. Soc. A 137, 696." },
    flags = { symmetric = true, axial = true, rod = s.rod or false }, full = false,
    constants = function(model)
      local c = symmetric.constants(model, s)
      c.torque = model:constant("Nk", loads.component(l.torque or { expr.zero, expr.zero, expr.zero }, s.k),
        "torque along the axis, over |k|")
      c.hk = model:constant("hk", loads.component(l.rotor or { expr.zero, expr.zero, expr.zero }, s.k),
        "angular momentum of the rotors along the axis, over |k|")
      c.c1 = model:constant("c1", ratio.tidy(c1), "damping across the axis, N m s")
      c.c3 = model:constant("c3", ratio.tidy(c3), "damping along the axis, N m s")
      return c
    end }
end

return axial
