-- idle.lua -- why an effect that is in the scene does nothing, in words: for the warning on its line.
--
-- dynamics/states.lua finds that all it adds is zero, for every value of the parameters; here is what makes it so: a
-- strength that is zero, or else what the body or the origin is (`idle` of the effect).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"

local idle = {}

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
  local strengths, other = table.unpack(e.spec.idle or { {} })
  for _, name in ipairs(strengths) do
    if zero(e.a[strengths[name] or name]) then return "does nothing: " .. name .. " is 0" end
  end
  return "does nothing: " .. (other or "all that it adds is 0")
end

return idle
