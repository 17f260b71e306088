-- eddy_current.lua -- the body is a conductor that turns in a uniform field: eddy currents brake it.
--
-- Seen from the body the field changes at B' = -w x B.  Where the body turns slowly, so that the currents' own field is
-- small beside B, the currents are proportional to that and make the magnetic moment m = k w x B, on which the field
-- exerts
--     N = m x B = -k B x (w x B) = -k (B^2 w - (B.w) B),     N.w = -k |w x B|^2 <= 0,     N.B = 0
-- The turn about the field stays.  Of a thin spherical shell (radius R, thickness d, conductivity s): E = -B' x r/2 is
-- along the surface and drives the sheet current s d E, so m = integral of r x s d E/2 = -(2 pi/3) s d R^4 B', that is
-- k = 2 pi s d R^4/3; of a full sphere, by shells, k = 2 pi s R^5/15.  Other bodies have a tensor in the place of k.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local eddy_current = {
  name = "effect.eddy_current",
  about = "eddy currents in a conductor that turns in a field (inertial): torque -k B x (w x B)",
  args = { { name = "k", dim = "N m s/T^2", sign = "nonnegative", about = "of a thin spherical shell 2 pi s d R^4/3" },
    { name = "field", dim = "field", size = 3 } },
  keeps = "L_z (field along z)",
  idle = { { "k", "field" } },
  formula = "N = -k B x (w x B), B = R(q)^T field",
  signs = "k >= 0 takes energy out: N.w = -k |w x B|^2; the turn about the field stays",
  source = "Youngquist, Nurge, Starr, Leve, Peck, Am. J. Phys. 84 (2016) 181: a hollow sphere; derived here",
  example = "eddy_damper",
}

local comp = { "x", "y", "z" }

function eddy_current.torque(a, c)
  local k = c.constant("eddy", a.k, "eddy currents, N m s/T^2")
  local B = vec.map(a.field, function(x, i) return c.constant("B" .. comp[i], x, "field, T") end)
  B = vec.matvec(vec.transpose(vec.rotation(c.q)), B)
  return vec.scale(k, vec.cross(vec.cross(c.w, B), B))
end

function eddy_current.conserves(a)
  return { a.field[1] == expr.zero and a.field[2] == expr.zero and "L_z" or nil }
end

function eddy_current.numeric(a, num) return { kind = "eddy_current", k = num(a.k), field = vec.map(a.field, num) } end

return eddy_current
