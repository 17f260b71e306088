-- motion.lua -- which expressions depend on the motion: on time, on states, on inputs.
--
-- A symbol's rank tells: parameters and derived constants have ranks up to 3 (dsl/env, dynamics/model), the step's
-- length, definitions, states, time and inputs 6 and more (dynamics/state).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

local motion = { rank = 8 } -- of states, time and inputs: after all constants in a product

-- The symbol of a state, of time ("t") or of an input.
function motion.sym(name) return expr.sym(name, motion.rank) end

-- Does the expression depend on parameters and constants only?
function motion.free(e)
  for _, s in ipairs(expr.symbols(e)) do
    if s.rank >= 6 then return false end
  end
  return true
end

-- Does one of the list depend on the motion?
function motion.any(list)
  for _, e in ipairs(list) do
    if not motion.free(e) then return true end
  end
  return false
end

-- e with every largest part that is_fixed(part) replaced by constant(part): in a sum or product its fixed members
-- together.  is_fixed: motion.free if nil; memo: shared by expressions that share parts.
function motion.lift(e, constant, is_fixed, memo)
  is_fixed, memo = is_fixed or motion.free, memo or {}
  local function lift(u)
    if memo[u] then return memo[u] end
    local v
    if is_fixed(u) then
      v = constant(u)
    elseif u.kind == "add" or u.kind == "mul" then
      local build = u.kind == "add" and expr.add or expr.mul
      local fixed, list = {}, {}
      for i = 1, #u do
        local to = is_fixed(u[i]) and fixed or list
        to[#to + 1] = u[i]
      end
      for i, x in ipairs(list) do list[i] = lift(x) end
      if #fixed > 0 then list[#list + 1] = constant(build(fixed)) end
      v = build(list)
    elseif u.kind == "pow" then
      v = expr.pow(lift(u.base), u.exp)
    elseif u.kind == "call" then
      local args = {}
      for i = #u, 1, -1 do
        local opposite = u.fn == "clamp" and i == 2 and u[2] == -u[3] -- one constant for both limits
        args[i] = opposite and -args[3] or lift(u[i])
      end
      v = expr.call(u.fn, table.unpack(args))
    else
      v = u
    end
    memo[u] = v
    return v
  end
  return lift(e)
end

return motion
