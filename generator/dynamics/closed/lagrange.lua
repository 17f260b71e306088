-- lagrange.lua -- the heavy symmetric top (Lagrange): gravity alone on a symmetric body held at a point of its axis.
--
-- The axis of a sphere about the origin of rotation is the line to its centre of mass.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local equations = require "generator.dynamics.equations"

local lagrange = { name = "heavy symmetric top (Lagrange)" }

local function parallel(a, b)
  for _, e in ipairs(vec.cross(a, b)) do
    if not ratio.iszero(e) then return false end
  end
  return true
end

local function zero(v)
  for _, e in ipairs(v) do
    if not ratio.iszero(e) then return false end
  end
  return true
end

-- The axis: of symmetry; of a sphere to the centre of mass, or z.
local function axis(m)
  if m.structure.kind == "symmetric" then return m.structure.k end
  if not zero(m.com) then return m.com end
  return { expr.zero, expr.zero, expr.one }
end

local axes = { "x", "y", "z" }

-- The direction of k need not be a unit vector; Mgk has its length in it.
local function constants(m)
  local s, k, g = m.structure, axis(m), m.record.effects[1].a
  local out = {}
  for i, x in ipairs(axes) do
    out["k" .. x] = equations.coordinate(k) and k[i] or m:constant("k" .. x, k[i], "direction of the symmetry axis")
    out["d" .. x] = m:constant("d" .. x, g.direction[i], "direction of gravity")
  end
  out.Mgk = m:constant("Mgk", m.mass * g.g * vec.dot(m.com, k), "M g r.k, k the direction of the symmetry axis, N m")
  out.I1 = m:constant("I1", s.alpha, "moment of inertia across the symmetry axis, kg m^2")
  out.I3 = s.kind == "sphere" and out.I1 or s.rod and expr.zero or
    m:constant("I3", s.axial, "moment of inertia about the symmetry axis, kg m^2")
  return out
end

function lagrange.detect(m)
  local list, s = m.record.effects, m.structure
  local weights, other = 0, nil
  for _, e in ipairs(list) do
    if e.kind == "effect.gravity" then
      weights = weights + 1
    else
      other = other or string.gsub(e.kind, "effect%.", "")
    end
  end
  if weights == 0 then return nil, other == "plane" and "no point of the body is held" or "no gravity acts" end
  if other then return nil, "not gravity alone acts on the body, but " .. other .. " too", true end
  if weights > 1 then return nil, "gravity acts " .. weights .. " times: write it as one", true end
  if s.kind ~= "sphere" and s.kind ~= "symmetric" then
    return nil, "gravity acts, but no two moments about the origin of rotation are equal for every value of the " ..
      "parameters", true
  end
  if not parallel(axis(m), m.com) then
    return nil, "gravity acts on a symmetric body, but its centre of mass is not on the symmetry axis for every " ..
      "value of the parameters", true
  end
  return { kind = "lagrange", theorem = "heavy symmetric top (Lagrange), theta functions",
    text = { "The cosine u of the tilt swings between two roots of a cubic, u = u1 + (u2 - u1) sn^2; the attitude",
      "is a pair a, b with |a|^2 = (1 + u)/2, |b|^2 = (1 - u)/2, each exp(i mu t) times a quotient of theta functions",
      "with mu and eta of its own, as are the rates across the axis (Jacobi; Whittaker, Analytical Dynamics, sections",
      "71-73; Klein and Sommerfeld, Theorie des Kreisels, part 2).  Set up in twice the working precision; any state:",
      "cusps, loops, steady precession, sleeping tops, pendulums, passages through the vertical are limits." },
    flags = { lagrange = true }, constants = constants, full = true, ticks = true }
end

return lagrange
