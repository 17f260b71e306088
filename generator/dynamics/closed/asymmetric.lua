-- asymmetric.lua -- the free top of any moments: Jacobi's solution in theta functions (templates/orbit/top.c).
-- SPDX-License-Identifier: GPL-3.0-or-later

local free = require "generator.dynamics.closed.free"
local critical = require "generator.mass.critical"

local asymmetric = { name = "free asymmetric top" }

-- Is every diagonal moment positive whatever parameters NAME_init accepts?  They may still underflow.
function asymmetric.positive(m)
  local known = critical.of(m.conditions)
  for i = 1, 3 do
    if not known:positive(m.inertia[i]) then return false end
  end
  return true
end

function asymmetric.detect(m, eq)
  local acts = free.acts(m, eq)
  if acts then return nil, acts end
  return { kind = "asymmetric", theorem = "free asymmetric top, theta functions",
    text = { "With u linear in time L = (B1 cn u, B2 sn u, B3 dn u) along the principal axes, Jacobi's functions; the",
      "attitude is exp(i mu t) times theta4 and theta1 of pi u/(2 K) - i eta, a complex pair (Jacobi 1849; Whittaker,",
      "Analytical Dynamics, section 69).  Set up in twice the working precision; any moments and any state: symmetric,",
      "spherical, a rod, spin about an axis and the separatrix are limits that the same formulas pass through." },
    flags = {}, full = true, ticks = true, exact = true }
end

return asymmetric
