-- flight.lua -- a body that constant forces at its centre of mass carry along, and that turns as if it were free.
--
--     r = r0 + v0 t + g t^2/2,   g = gravity + force/m in inertial axes
-- Forces at the centre of mass have no torque about it, so that the turning is that of the same body without effects.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local free = require "generator.dynamics.closed.free"
local point = require "generator.dynamics.closed.point"

local flight = { name = "free top in flight, constant forces" }

function flight.detect(m)
  if not m.has.position then return nil, "nothing moves the centre of mass" end
  local form, acts = free.top(m)
  if not form then return nil, acts end
  local t = m.record.effects[1]
  if m.record.effects[2] or t.kind ~= "effect.translation" then
    local other = t.kind ~= "effect.translation" and t or m.record.effects[2]
    return nil, "beside constant forces, " .. string.gsub(other.kind, "effect%.", "") .. " acts on the body"
  end
  local varies = point.varies(t.a)
  if varies then return nil, varies, true end
  for i = 1, 3 do
    if not point.zero(t.a.stiffness[i]) then return nil, "a force on the centre of mass depends on its place", true end
  end
  local text = { "Constant forces at the centre of mass have no torque about it: r = r0 + v0 t + g t^2/2, g the",
    "acceleration by all of them, and about it the body turns as if nothing acted:", form.theorem .. "." }
  table.move(form.text, 1, #form.text, 4, text)
  local flags = { flies = true }
  for name, flag in pairs(form.flags) do flags[name] = flag end -- into a table: order is lost anyway
  return { kind = "flight of a " .. form.kind .. " top", theorem = "parabola of the centre of mass, and the " ..
      form.theorem, text = text, free = form, flags = flags, full = true, exact = form.exact,
    constants = function(model)
      local c = form.constants and form.constants(model) or {}
      for i, g in ipairs(point.steady(model, t)) do c["g" .. i] = g end
      return c
    end }
end

return flight
