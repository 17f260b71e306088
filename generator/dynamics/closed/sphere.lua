-- sphere.lua -- the free spherical top: uniform rotation (Landau, Lifshitz, Mechanics, section 33).
-- SPDX-License-Identifier: GPL-3.0-or-later

local free = require "generator.dynamics.closed.free"

local sphere = { name = "free spherical top" }

function sphere.detect(m, eq)
  local acts = free.acts(m, eq)
  if acts then return nil, acts end
  if m.structure.kind ~= "sphere" then return nil, "the moments are not all equal for every value of the parameters" end
  return { kind = "sphere", theorem = "free spherical top, uniform rotation",
    text = { "All moments are equal, so L = I1 w and w are constant in both frames:",
      "q(t) = q(0) (cos |w|t/2, w/|w| sin |w|t/2).  Landau, Lifshitz, Mechanics, section 33." },
    flags = {}, full = true, ticks = true }
end

return sphere
