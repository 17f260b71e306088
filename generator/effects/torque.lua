-- torque.lua -- a constant torque, given in body axes or in inertial axes.
--
-- N_body = N, or N_body = R(q)^T N.  The torque equation in the body frame, dL/dt|body + w x L = N, is where it
-- enters (Goldstein 5.39).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local torque = {
  name = "effect.torque",
  about = "constant torque, body = {x, y, z} or inertial = {x, y, z}",
  keeps = "w3 (body torque across z) or L_z (inertial torque across z)",
}

function torque.read(ctx, line, what, given, args)
  args.unknown(ctx, line, what, { { name = "body" }, { name = "inertial" } }, given)
  if (given.body == nil) == (given.inertial == nil) then
    ctx.diag:error(line, what, "give body or inertial, one of them")
    return nil
  end
  local key = given.body ~= nil and "body" or "inertial"
  local v = args.vector(ctx, ctx.diag:locate(line, key), what, key, { dim = "torque", size = 3 }, given[key])
  return v and { [key] = v }
end

function torque.torque(a, c)
  local N = vec.map(a.body or a.inertial, function(x, i)
    return c.constant("N" .. string.sub("xyz", i, i), x, "torque, N m")
  end)
  if a.body then return N end
  return vec.matvec(vec.transpose(vec.rotation(c.q)), N)
end

-- A torque across the axis of symmetry leaves the spin alone, one across z in inertial axes L_z.
function torque.conserves(a)
  if a.body then return a.body[3] == expr.zero and { "w3" } or {} end
  return a.inertial[3] == expr.zero and { "L_z" } or {}
end

function torque.numeric(a, num)
  local key = a.body and "body" or "inertial"
  return { kind = "torque", [key] = vec.map(a[key], num) }
end

return torque
