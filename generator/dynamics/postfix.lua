-- postfix.lua -- expressions of the motion as a list that the host's evaluator runs (src/cli/engine/program.c).
--
-- Operands come before what joins them: "n", high, low pushes a number (a pair of doubles), "v", i the i-th of
-- t, x[0], x[1] ..; "u", i the input number i from 0; "+", n and "*", n join n values; "^", p, q raises to p/q;
-- else the name of a function of one to three arguments.  Parts without symbols of the motion are evaluated
-- here, exactly.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local motion = require "generator.algebra.motion"

local postfix = {}

-- exact: expression of parameters -> rational; place: name of a state -> its index in x from 0; of an input -> minus
-- its number from 1.
function postfix.of(e, exact, place)
  local out = {}
  local function put(...)
    for _, x in ipairs { ... } do out[#out + 1] = x end
  end
  -- a part that is free of the motion is one number
  local function walk(u)
    if motion.free(u) then
      local q = exact(u)
      local high = R.todouble(q)
      put("n", high, R.todouble(q - R.fromdouble(high)))
    elseif u.kind == "sym" then
      local i = u.name ~= "t" and assert(place[u.name], u.name)
      if i and i < 0 then put("u", -i - 1) else put("v", i and i + 1 or 0) end
    elseif u.kind == "pow" then
      walk(u.base)
      put("^", R.todouble(R.num(u.exp)), R.todouble(R.den(u.exp)))
    else
      for i = 1, #u do walk(u[i]) end
      if u.kind == "call" then
        put(u.fn)
      else
        put(u.kind == "add" and "+" or "*", #u)
      end
    end
  end
  walk(e)
  return out
end

return postfix
