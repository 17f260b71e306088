-- torque.lua -- a torque given in body axes or in inertial axes, constant or varying.
--
-- N_body = N, or N_body = R(q)^T N.  The torque equation in the body frame, dL/dt|body + w x L = N, is where it
-- enters (Goldstein 5.39).  A component is a number, an expression of time and states, or a table over time
-- (dsl/moving.lua), linear between its rows and constant beyond them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"

local torque = {
  name = "effect.torque",
  about = "torque, body or inertial = {x, y, z}: numbers, expressions of t and states, tables {{t, v}, ...}",
  reader = "torque",
  takes = { { "body", "kg m^2/s^2", nil, "three components: numbers, expressions of t and states, tables" },
    { "inertial", "kg m^2/s^2", nil, "or: the same in inertial axes" } },
  keeps = "w3 (body torque across z) or L_z (inertial torque across z)",
  idle = { { "body", "inertial" } },
  formula = "N = body, or N = R(q)^T inertial",
  signs = "N is what acts on the body; body axes turn with it, inertial axes stand still (or are those of a frame)",
  source = "Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., 5.39",
  example = "thruster",
}

-- R(q)^T takes inertial components to the body's.
function torque.torque(a, c)
  local N = vec.map(a.body or a.inertial, function(x, i)
    return c.lift(x, "N" .. string.sub("xyz", i, i), "torque, N m")
  end)
  if a.body then return N end
  return vec.matvec(vec.transpose(vec.rotation(c.q)), N)
end

-- A torque across the axis of symmetry leaves the spin alone, one across z in inertial axes L_z.
function torque.conserves(a)
  if a.body then return a.body[3] == expr.zero and { "w3" } or {} end
  return a.inertial[3] == expr.zero and { "L_z" } or {}
end

-- What is constant as numbers, what varies as a table or as code.
function torque.numeric(a, num, _, code)
  local key = a.body and "body" or "inertial"
  if not motion.any(a[key]) then return { kind = "torque", [key] = vec.map(a[key], num) } end
  local parts = vec.map(a[key], function(e, i)
    if motion.free(e) then return num(e) end
    return torque.varying(e, a.rows[i], num, code)
  end)
  return { kind = "torque", varying = parts, turned = key == "inertial" }
end

-- A component for the library: {rows = {t1, v1, t2, ...}} or {code = ...}.
function torque.varying(e, rows, num, code)
  if not rows then return { code = code(e) } end
  local list = {}
  for _, row in ipairs(rows) do list[#list + 1], list[#list + 2] = num(row[1]), num(row[2]) end
  return { rows = list }
end

return torque
