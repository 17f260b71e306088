-- frames.lua -- vectors seen from a turning frame: rates of change and the four terms of an acceleration.
--
-- For a vector A given in body axes, with dA/dt the rate that an observer on the body sees:
--     dA/dt (inertial) = dA/dt (body) + w x A                                            (Goldstein 4.82)
-- Applied twice to a position r with body velocity v and body acceleration a:
--     a_inertial = a + 2 w x v + w' x r + w x (w x r)          relative, Coriolis, Euler, centripetal   (4.91)
-- All components stay in body axes.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local frames = {}

-- The inertial rate of change, in body axes, from the body rate dA.
function frames.rate(w, A, dA) return vec.add(dA, vec.cross(w, A)) end

-- The rate in the body frame from the inertial one: the same read backwards.
function frames.body_rate(w, A, inertial) return vec.sub(inertial, vec.cross(w, A)) end

-- {relative, coriolis, euler, centripetal}: the second derivative term by term.
function frames.acceleration(w, dw, r, v, a)
  return { relative = a, coriolis = vec.map(vec.cross(w, v), function(x) return 2 * x end), euler = vec.cross(dw, r),
    centripetal = vec.cross(w, vec.cross(w, r)) }
end

-- Kinetic energy of particles that turn with w about the origin, by the definition: sum m (w x r)^2/2.
-- rows: {{m, x, y, z}, ...}, expressions.
function frames.particle_energy(rows, w)
  local T = {}
  for i, p in ipairs(rows) do
    local v = vec.cross(w, { p[2], p[3], p[4] })
    T[i] = p[1] * vec.dot(v, v) / 2
  end
  return expr.add(T)
end

return frames
