-- lifted.lua -- what an effect returns, with no parameter left in it: all that the emitted code reads is a state, time,
-- an input, or a derived constant.
--
-- Effects keep derived constants of their own where these should have a name.  Whatever parameters remain in their
-- torques, forces and so on (a direction {sin(a), 0, -cos(a)}, an axis {p, 1, 0}) become constants here, in largest
-- parts, so that no effect can forget one.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"

local lifted = {}

local last = 2 -- the rank of parameters; derived constants and all others have higher ones

-- Does e depend on parameters and numbers only, and on one parameter at least?
local function pure(e)
  local symbols = expr.symbols(e)
  for _, s in ipairs(symbols) do
    if s.rank > last or s.name == "the mass" then return false end
  end
  return #symbols > 0
end

-- Lists and tables at any depth, keys in order, for new constants get their names in it.
local function all(x, keep, memo)
  if expr.is(x) then return motion.lift(x, keep, pure, memo) end
  if type(x) ~= "table" then return x end
  local keys, out = {}, {}
  for k in pairs(x) do keys[#keys + 1] = k end -- in hash order, so:
  table.sort(keys, function(a, b) return tostring(a) < tostring(b) end)
  for _, k in ipairs(keys) do out[k] = all(x[k], keep, memo) end
  return out
end

local of_motion = { "torque", "force", "derivative", "momentum", "momentum_rate", "kinetic", "varies", "turn",
  "products", "potential" }

-- The effect's specification, its functions of the motion so wrapped.
function lifted.spec(spec)
  for _, name in ipairs(of_motion) do
    local plain = spec[name]
    spec[name] = plain and function(a, c)
      local result = plain(a, c)
      if result == nil then return nil end
      local function keep(e)
        return c.constant(e.kind == "sym" and e.name or "par", e, "of " .. spec.name)
      end
      return all(result, keep, {})
    end
  end
  return spec
end

return lifted
