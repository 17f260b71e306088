-- control.lua -- the input u: three torque components in body axes, optionally limited.
--
-- With `max` each component is clamped to [-max, max] by comparing: exact, however large u is, which the well-known
-- (|u + max| - |u - max|)/2 is not: of u = 1e17 max nothing is left there.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local control = {
  name = "effect.control",
  about = "input u: torque in body axes, max (optional) limits each component",
  formula = "N = u, or with max each component between -max and max",
  signs = "u acts on the body, body axes; it is held during a step",
  source = "the definition",
  example = "gyroscope",
  args = { { name = "max", dim = "torque", sign = "positive", optional = true } },
  input = true,
}

function control.torque(a, c)
  if not a.max then return c.u end
  local limit = c.constant("umax", a.max, "limit of each input, N m")
  return vec.map(c.u, function(u)
    return expr.call("clamp", u, -limit, limit)
  end)
end

-- Where nothing else than u acts the library takes it as it is; with a limit, or along lines over time, as expressions.
function control.numeric(a, _, _, code, c)
  if not a.max and not c.lines then return { kind = "control" } end
  return { kind = "torque", varying = vec.map(control.torque(a, c), function(e)
    return { code = code(e) }
  end) }
end

return control
