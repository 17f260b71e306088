-- exact.lua -- exact values and symmetries of the elementary functions.
--
-- Used by expr.call before a call node is made: sin and cos at multiples of pi/12, odd and even symmetry,
-- and inverse pairs.  A law stands beside each rule.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local radical = require "generator.algebra.radical"

local odd = { sin = true, tan = true, asin = true, atan = true, sinh = true, tanh = true }
local even = { cos = true, cosh = true, abs = true }
local at_zero = { sin = 0, tan = 0, asin = 0, atan = 0, sinh = 0, tanh = 0, cos = 1, cosh = 1, exp = 1, abs = 0 }

return function(expr)
  -- a = r*pi with r rational?  returns r
  local function turns(a)
    if expr.iszero(a) then return R.zero end
    if a == expr.pi then return R.one end
    local c, rest = expr.split(a)
    if rest == expr.pi then return c end
  end

  -- sin(k*pi/12) for k = 0 .. 6 (15, 45 and 75 degrees by the half-angle formulas)
  local function sine(k)
    local two, three, six = expr.sqrt(2), expr.sqrt(3), expr.sqrt(6)
    local table_ = { [0] = expr.zero, (six - two) / 4, expr.lift(R.half), two / 2, three / 2, (six + two) / 4,
      expr.one }
    return table_[k]
  end

  local function sin_pi(r)
    local k = (r - R.new(2) * radical.floor(r / R.new(2))) * R.new(12) -- reduced to [0, 24)
    if not R.isint(k) then return nil end
    local n = R.toint(k)
    if n >= 12 then return -sine(n - 12 <= 6 and n - 12 or 24 - n) end
    return sine(n <= 6 and n or 12 - n)
  end

  return function(fn, args)
    if fn == "pi" then return expr.pi end
    local a = args[1]
    if fn == "abs" then
      if a.kind == "num" then return expr.lift(R.abs(a.value)) end
      if expr.nonnegative(a) then return a end
      local c, rest = expr.split(a) -- |c x y| ==> |c| y |x| for y >= 0
      local out, inside = { expr.lift(R.abs(c)) }, {}
      for _, f in ipairs(rest.kind == "mul" and rest or { rest }) do
        local list = expr.nonnegative(f) and out or inside
        list[#list + 1] = f
      end
      if #out > 1 or out[1] ~= expr.one then
        out[#out + 1] = expr.call("abs", expr.mul(inside))
        return expr.mul(out)
      end
    end
    if expr.iszero(a) and at_zero[fn] then return expr.lift(at_zero[fn]) end
    if fn == "log" and a == expr.one then return expr.zero end
    if (odd[fn] or even[fn]) and #args == 1 then -- f(-x) ==> -f(x), or f(x)
      local c, rest = expr.split(a)
      if R.sign(c) < 0 then
        local v = expr.call(fn, expr.mul { -c, rest })
        return odd[fn] and -v or v
      end
    end
    local r = turns(a)
    if r and fn == "sin" then return sin_pi(r) end
    if r and fn == "cos" then return sin_pi(r + R.half) end
    if r and fn == "tan" then
      local s, c = sin_pi(r), sin_pi(r + R.half)
      if s and c and not expr.iszero(c) then return s / c end
    end
    if fn == "exp" and a.kind == "call" and a.fn == "log" then return a[1] end -- exp(log x) ==> x
    return nil
  end
end
