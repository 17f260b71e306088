-- idle.lua -- why an effect that is in the scene does nothing, in words: for the warning on its line.
--
-- dynamics/states.lua finds that all it adds is zero, for every value of the parameters; here is what makes it so: a
-- strength that is zero, or else what the body or the origin is.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"

local idle = {}

local central = "the origin is the centre of mass, about which %s exerts no torque (origin = ... is the fixed point " ..
  "about which the body turns%s)"
local equal = "the three moments of inertia are equal"

-- Arguments by which an effect is multiplied (as the scene writes them, and as they are kept), and what else makes it
-- vanish.
local kinds = {
  gravity = { { "g" }, string.format(central, "the weight", "; effect.translation lets it fall") },
  pivot = { { "acceleration", "amplitude", "rate" }, string.format(central, "the support", "") },
  gravity_gradient = { { "mu" }, equal }, dissipation = { { "k" }, equal },
  damping = { { "c", "rate", c = "C" } }, drag = { { "c" } }, friction = { { "torque" } },
  torque = { { "body", "inertial" } }, spring = { { "stiffness", stiffness = "k" } },
  magnetic = { { "moment", "field", "rotating" } }, rotor = { { "momentum" } },
  solar_pressure = { { "flux" }, "no plate has an area" }, rotating_frame = { { "rate" } },
  inertia_rate = { {}, "no entry is given, or all are 0" },
}

-- Is x, an expression or a list of them at any depth, zero?
local function zero(x)
  if expr.is(x) then return x == expr.zero or ratio.iszero(x) end
  if type(x) ~= "table" then return false end
  for _, y in ipairs(x) do
    if not zero(y) then return false end
  end
  return #x > 0
end

-- e: the effect's record.
function idle.why(e)
  local strengths, other = table.unpack(kinds[string.gsub(e.kind, "^effect%.", "")] or { {} })
  for _, name in ipairs(strengths) do
    if zero(e.a[strengths[name] or name]) then return "does nothing: " .. name .. " is 0" end
  end
  return "does nothing: " .. (other or "all that it adds is 0")
end

return idle
