-- evaluate.lua -- the value of an expression: exact, in doubles, or to any number of bits.
--
-- ABOVE the line: the node is evaluated as it stands, sums in its own order.  exact() takes rational
-- functions only and is exact; precise() rounds every operation to `bits` bits (MPFR for functions), so its
-- error is a few units of the last bit times the condition of the expression: ask for bits in plenty
-- and it is the oracle for everything printed in double.  double() is quick and promises nothing.
-- Symbols take their values from env by name.  A value that is no real number (1/0, log -1) is an error
-- in exact() and precise().
-- Not here: evaluation of what lower made of an expression (tests/ir/eval.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local choice = require "generator.algebra.choice"

local evaluate = {}

local function lookup(env, name)
  local x = env[name]
  if x == nil then error("evaluate: no value for symbol '" .. name .. "'", 0) end
  return x
end

-- The function e -> value by the arithmetic A: number, symbol, sum and product of two, power, call.
-- A = {number(q), symbol(name), add(x, y), mul(x, y), pow(x, n), call(fn, args)}: n is a rational, the others values of
-- A's kind.  Each node once, in whatever expressions, so the cost is the number of distinct subexpressions.
local function walker(A)
  local memo = {}
  local value

  local rules = {
    num = function(n) return A.number(n.value) end,
    sym = function(n) return A.symbol(n.name) end,
    add = function(n)
      local sum = value(n[1])
      for k = 2, #n do sum = A.add(sum, value(n[k])) end
      return sum
    end,
    mul = function(n)
      local product = value(n[1])
      for k = 2, #n do product = A.mul(product, value(n[k])) end
      return product
    end,
    pow = function(n) return A.pow(value(n.base), n.exp) end,
    call = function(n)
      if n.fn == "opaque" then return value(n[1]) end
      local args = {}
      for k = 1, #n do args[k] = value(n[k]) end
      return A.call(n.fn, args)
    end,
  }

  function value(n)
    local known = memo[n]
    if known == nil then
      local rule = rules[n.kind] or error("evaluate: unknown node kind '" .. tostring(n.kind) .. "'")
      known = rule(n)
      memo[n] = known
    end
    return known
  end

  return value
end

-- ---- exact ------------------------------------------------------------------------------------------------

-- The rational value of a rational function (roots and |x| that come out rational included).
function evaluate.exact(e, env)
  return walker {
    number = function(q) return q end,
    symbol = function(name)
      local x = lookup(env, name)
      return R.is(x) and x or R.lift(x)
    end,
    add = function(x, y) return x + y end,
    mul = function(x, y) return x * y end,
    pow = function(x, n)
      if R.isint(n) then return x ^ R.toint(n) end
      local root = R.root(x, R.toint(R.den(n)))
      if not root then error("evaluate: " .. tostring(x) .. "^(" .. tostring(n) .. ") is not rational", 0) end
      return root ^ R.toint(R.num(n))
    end,
    call = function(fn, args)
      return choice.of(fn, R.one, table.unpack(args)) or error("evaluate: " .. fn .. " has no exact value", 0)
    end,
  }(e)
end

-- ---- to `bits` bits -----------------------------------------------------------------------------------------

-- The function e -> value as a rational with `bits` significant bits, for many expressions in one environment: what
-- they share is evaluated once.  Names may be added to env as they become known; none may change its value.
function evaluate.within(env, bits)
  local function rounded(q) return R.round(q, bits) end
  local function apply(fn, ...)
    local x = R.apply(fn, bits, ...)
    if x then return x end
    local args = {}
    for k, q in ipairs { ... } do args[k] = string.format("%.17g", R.todouble(q)) end
    error("evaluate: " .. fn .. "(" .. table.concat(args, ", ") .. ") is not a real number", 0)
  end
  return walker {
    number = function(q) return q end, -- exact: rounding it would be an error of the argument of sin
    symbol = function(name)
      local x = lookup(env, name)
      return R.is(x) and x or R.lift(x)
    end,
    add = function(x, y) return rounded(x + y) end,
    mul = function(x, y) return rounded(x * y) end,
    pow = function(x, n)
      if R.isint(n) then
        if R.sign(x) == 0 and R.sign(n) < 0 then error("evaluate: division by zero", 0) end
        return rounded(x ^ R.toint(n))
      end
      if n == R.half then return apply("sqrt", x) end
      return apply("pow", x, n)
    end,
    call = function(fn, args)
      return choice.of(fn, R.one, table.unpack(args)) or apply(fn, table.unpack(args))
    end,
  }
end

-- The value as a rational with `bits` significant bits.
function evaluate.precise(e, env, bits) return evaluate.within(env, bits)(e) end

-- ---- double -------------------------------------------------------------------------------------------------

-- Functions that Lua's library lacks, by MPFR, correctly rounded; out of range is NaN.
local function by_mpfr(fn)
  return function(...)
    local args = { ... }
    for k, x in ipairs(args) do
      if x - x ~= 0 then return 0.0 / 0.0 end
      args[k] = R.fromdouble(x)
    end
    local y = R.apply(fn, 53, table.unpack(args))
    return y and R.todouble(y) or 0.0 / 0.0
  end
end

local functions = {
  sin = math.sin, cos = math.cos, tan = math.tan, asin = math.asin, acos = math.acos,
  atan = function(x) return math.atan(x) end,
  atan2 = function(y, x) return math.atan(y, x) end,
  exp = math.exp, log = function(x) return math.log(x) end,
  sinh = by_mpfr "sinh", cosh = by_mpfr "cosh", tanh = by_mpfr "tanh",
  pi = function() return math.pi end,
}
for _, fn in ipairs { "ellipsoid_area", "ellipsoid_normal", "arc_across", "arc_along", "arc_lever", "catenary_rise",
  "catenary_width", "catenary_height" } do
  functions[fn] = by_mpfr(fn)
end

-- The value in doubles; env holds Lua numbers or rationals.
function evaluate.double(e, env)
  return walker {
    number = R.todouble,
    symbol = function(name)
      local x = lookup(env, name)
      return R.is(x) and R.todouble(x) or x * 1.0
    end,
    add = function(x, y) return x + y end,
    mul = function(x, y) return x * y end,
    pow = function(x, n)
      if n == R.half then return math.sqrt(x) end
      return x ^ R.todouble(n)
    end,
    call = function(fn, args)
      local value = choice.of(fn, 1.0, table.unpack(args))
      if value then return value end
      local f = functions[fn] or error("evaluate: unknown function '" .. fn .. "'")
      return f(table.unpack(args))
    end,
  }(e)
end

return evaluate
