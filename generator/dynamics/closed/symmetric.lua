-- symmetric.lua -- the free symmetric top: Poinsot's regular precession,
--     R(t) = exp([L]x t/I1) R(0) exp([k]x (1 - I3/I1) (k.w) t),   w(t) = w turned about k by -(1 - I3/I1)(k.w) t
-- (Landau, Lifshitz, Mechanics, sections 33 and 36: precession |L|/I1 about L, and the rest about the axis).
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local equations = require "generator.dynamics.equations"
local free = require "generator.dynamics.closed.free"

local symmetric = { name = "free symmetric top" }

-- The body as symmetric about k: its own structure, or of a sphere one about the given axis; nil for other bodies.
function symmetric.about(m, axis)
  local s = m.structure
  if s.kind == "symmetric" then return s end
  if s.kind ~= "sphere" then return nil end
  return { k = axis, k2 = ratio.tidy(vec.dot(axis, axis)), alpha = s.alpha, axial = s.alpha }
end

-- Axis and moments of a symmetric top as derived constants: kx, ky, kz, k2 = k^2, I1 across and I3 about the axis.
function symmetric.constants(m, about)
  local s = about or m.structure
  local k = s.k
  if not equations.coordinate(k) then
    k = {}
    for i, n in ipairs { "kx", "ky", "kz" } do k[i] = m:constant(n, s.k[i], "direction of the symmetry axis") end
  end
  return { kx = k[1], ky = k[2], kz = k[3],
    k2 = m:constant("k2", s.k2, "square of the direction of the symmetry axis"),
    I1 = m:constant("I1", s.alpha, "moment of inertia across the symmetry axis, kg m^2"),
    I3 = s.rod and expr.zero or m:constant("I3", s.axial, "moment of inertia about the symmetry axis, kg m^2") }
end

function symmetric.detect(m, eq)
  local acts = free.acts(m, eq)
  if acts then return nil, acts end
  local s = m.structure
  if s.kind ~= "symmetric" then return nil, "no two moments are equal for every value of the parameters" end
  return { kind = "symmetric", theorem = s.rod and "free rod, rotation in a plane" or
      "free symmetric top, regular precession",
    text = { "Two moments are equal (I1), the third is I3 about the axis k.  Seen from the inertial frame the axis",
      "goes round L at |L|/I1; in the body w goes round k at Omega = (I3 - I1)/I1 k.w; hence",
      "q(t) = (cos, L/|L| sin)(|L|t/2 I1) q(0) (cos, k/|k| sin)((1 - I3/I1) k.w t/2).",
      "Landau, Lifshitz, Mechanics, sections 33 and 36." },
    flags = { symmetric = true },
    constants = function(model) return symmetric.constants(model) end, full = true, ticks = true }
end

return symmetric
