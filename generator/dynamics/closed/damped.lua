-- damped.lua -- a torque -rate L: the free motion, whatever the body, in a time that runs slower and slower.
--
-- With L' + w x L = -rate L the direction of L in space stays and L = exp(-rate t) M, w = exp(-rate t) v, where M and v
-- move as those of the free body in the time tau = (1 - exp(-rate t))/rate, dtau = exp(-rate t) dt: both sides of
-- M' + v x M = 0 and of q' = q (0, v)/2 carry the same factor.  What of the damping gives such a torque: `rate`, any
-- matrix C = rate I, and a number c for a sphere.  A rod's rate along its line carries no L and is kept.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local free = require "generator.dynamics.closed.free"
local loads = require "generator.dynamics.closed.loads"

local damped = { name = "damping proportional to L" }

function damped.detect(m)
  local l, other = loads.of(m, true)
  if not l then return nil, other end
  if not l.damping then return nil, "there is no damping" end
  if l.torque or l.rotor then return nil, "beside the damping a torque or a rotor acts" end
  local rate = loads.proportional(m, l.damping)
  if not rate then
    return nil, "the damping is not proportional to the tensor, so not to L, for every value of the parameters", true
  end
  local form = free.top(m)
  local text = { "The torque -rate L leaves the direction of L alone: L = exp(-rate t) L_free, w = exp(-rate t) w_free",
    "and q = q_free at the time (1 - exp(-rate t))/rate of the free motion (negative rates: growth), which is the" }
  text[3] = form.theorem .. ":"
  for _, line in ipairs(form.text) do text[#text + 1] = line end
  local flags = { damped = true, rod = m.structure.rod or false }
  for name, flag in pairs(form.flags) do flags[name] = flag end -- into a table: order is lost anyway
  return { kind = "damped " .. form.kind, theorem = "damping proportional to L, a change of time in the " ..
      form.theorem, text = text, free = form,
    flags = flags, full = true, decay = rate, exact = form.exact, constants = function(model)
      local c = form.constants and form.constants(model) or {}
      c.decay = model:constant("decay", rate, "rate of decay of L, 1/s")
      return c
    end }
end

return damped
