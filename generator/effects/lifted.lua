-- lifted.lua -- what an effect returns, with no parameter left in it: all that the emitted code reads is a state, time,
-- an input, or a derived constant.
--
-- Effects keep derived constants of their own where these should have a name.  Whatever parameters remain in their
-- torques, forces and so on (a direction {sin(a), 0, -cos(a)}, an axis {p, 1, 0}) become constants here, in largest
-- parts, so that no effect can forget one.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

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

local function open(e)
  for _, s in ipairs(expr.symbols(e)) do
    if s.rank <= last and s.name ~= "the mass" then return true end
  end
  return false
end

-- e with keep(part) for every largest part of parameters: in a sum or product these together.
local function lift(e, keep, memo)
  if memo[e] then return memo[e] end
  local v = e
  if not open(e) then
    v = e
  elseif pure(e) then
    v = keep(e)
  elseif e.kind == "add" or e.kind == "mul" then
    local build, fixed, list = e.kind == "add" and expr.add or expr.mul, {}, {}
    for i = 1, #e do
      if pure(e[i]) then fixed[#fixed + 1] = e[i] else list[#list + 1] = lift(e[i], keep, memo) end
    end
    if #fixed > 0 then list[#list + 1] = keep(build(fixed)) end
    v = build(list)
  elseif e.kind == "pow" then
    v = expr.pow(lift(e.base, keep, memo), e.exp)
  elseif e.kind == "call" then
    local args = {}
    for i = #e, 1, -1 do
      local opposite = e.fn == "clamp" and i == 2 and e[2] == -e[3] -- one constant for both limits
      args[i] = opposite and -args[3] or lift(e[i], keep, memo)
    end
    v = expr.call(e.fn, table.unpack(args))
  end
  memo[e] = v
  return v
end

local function all(x, keep, memo)
  if expr.is(x) then return lift(x, keep, memo) end
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
