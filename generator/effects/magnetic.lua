-- magnetic.lua -- a magnetic dipole of the body in a uniform field.
--
--     N = m x R(q)^T B,   V = -m . R(q)^T B       m fixed in the body, B fixed in inertial axes, or turning about z:
--     B(t) = Rz(rate t) B(0)
-- A turning field does work: NAME_energy has no potential of it, NAME_jacobi_integral is T - m.B(t) - rate L_z.  A
-- moment that varies (of magnetorquers: inputs) has no potential, either.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local custom = require "generator.effects.custom"

local magnetic = {
  name = "effect.magnetic",
  about = "magnetic dipole moment (body; it may vary) in a fixed field, or in one rotating about inertial z at a rate",
  args = { { name = "moment", dim = "magnetic_moment", size = 3, motion = true },
    { name = "field", dim = "field", size = 3, optional = true },
    { name = "rotating", dim = "field", size = 3, optional = true },
    { name = "rate", dim = "rate", optional = true } },
  keeps = "T+V (fixed field), T+V-n.L (rotating field), L_z (field along z), w3 (moment along z)",
  idle = { { "moment", "field", "rotating" } },
  formula = "N = m x R(q)^T B, V = -m.R(q)^T B; rotating: B = (Bx cos a - By sin a, Bx sin a + By cos a, Bz), " ..
    "a = rate t",
  signs = "the moment turns towards the field; rate > 0 turns the field from x to y; NAME_energy has no V of a " ..
    "moment that varies or of a field that turns",
  source = "Jackson, Classical Electrodynamics, 3rd ed., 5.71 and 5.72",
  example = "compass",
}

local comp = { "x", "y", "z" }

function magnetic.refuse(_, given)
  if (given.field == nil) == (given.rotating == nil) then return "give field or rotating, one of them" end
  if (given.rotating == nil) ~= (given.rate == nil) then return "rotating needs rate, and rate needs rotating" end
  return nil
end

-- Moment and field in body axes; nothing where either is zero.
local function vectors(a, c)
  local m = vec.map(a.moment, function(x, i) return c.lift(x, "m" .. comp[i], "magnetic moment, A m^2") end)
  local B = vec.map(a.field or a.rotating, function(x, i) return c.constant("B" .. comp[i], x, "field, T") end)
  if a.rotating then
    local angle = c.constant("turning", a.rate, "rate of the field, rad/s") * c.t
    local cos, sin = expr.call("cos", angle), expr.call("sin", angle)
    B = { B[1] * cos - B[2] * sin, B[1] * sin + B[2] * cos, B[3] }
  end
  return m, vec.matvec(vec.transpose(vec.rotation(c.q)), B)
end

function magnetic.torque(a, c) return vec.cross(vectors(a, c)) end

function magnetic.potential(a, c)
  if a.rotating or motion.any(a.moment) then return expr.zero end
  return -vec.dot(vectors(a, c))
end

function magnetic.turning(a, c)
  if not a.rotating or motion.any(a.moment) then return nil end
  return { rate = a.rate, potential = -vec.dot(vectors(a, c)) }
end

local function along_z(v) return v[1] == expr.zero and v[2] == expr.zero end

-- A fixed field and a constant moment have a potential; for B along inertial z the torque is across it, and
-- (m x B)_z = 0 for m along body z.
function magnetic.conserves(a)
  local list = { a.field and not motion.any(a.moment) and "T+V" or nil }
  if along_z(a.field or a.rotating) then list[#list + 1] = "L_z" end
  if along_z(a.moment) then list[#list + 1] = "w3" end
  return list
end

function magnetic.numeric(a, num, _, code, c)
  if motion.any(a.moment) then return custom.told(magnetic.torque(a, c), nil, code) end
  return { kind = "magnetic", moment = vec.map(a.moment, num), field = vec.map(a.field or a.rotating, num),
    rate = a.rotating and num(a.rate) or 0.0, rotating = a.rotating ~= nil }
end

return magnetic
