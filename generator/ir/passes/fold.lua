-- fold.lua: pass of local rewrites, each with the IEEE law that makes it legal.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line: a rule may be here only if both sides are equal for every double and every float,
-- zeros with their sign, subnormals and infinities included (NaN stays NaN; its sign and payload
-- are nobody's business).  Every rule removes an operation or replaces one by a cheaper one, so the
-- pass ends: one sweep, operands first.
--
-- Constants fold only if the operands are representable in float, hence in double too: then the
-- program would round the exact result once, and so does the folded constant when it is printed.
-- Products and quotients that are zero or leave the normal range of float are left alone.
--
-- Refused, with the counter-example:
--     x + 0       ==> x           x = -0: the sum is +0
--     0 - x       ==> -x          x = 0: the difference is +0
--     x * 0       ==> 0           x = inf, NaN: NaN;  x = -1: -0
--     x - x       ==> 0           x = inf, NaN: NaN
--     x / x       ==> 1           x = 0, inf, NaN: NaN
--     -(a - b)    ==> b - a       a = b: -0 against +0
--     (a + b) - b ==> a           a = 1, b = 1e30: 0            (any reassociation)
--     (a * b) * c ==> a * (b * c) a = b = 1e200, c = 1e-200: inf against 1e200
--     a*b + a*c   ==> a*(b + c)   a = 3, b = 0.1, c = 0.3: 1.2 against 1.2000000000000002
--     x / c       ==> x * (1/c)   x = 5, c = 3: 1.6666666666666667 against 1.6666666666666665
--     x / 2^k     ==> x * 2^-k    when 2^-k is subnormal or zero: the constant itself is inexact
-- (x - 0 ==> x holds, but lower makes no such thing.)

local R = require "polhode_rational"
local instr = require "generator.ir.core.instr"

local fold = {}

local ONE = R.new(1)
local MINUS = -ONE
local FLOAT_MIN_EXP, FLOAT_MAX_EXP = -126, 127 -- of normal binary32 numbers 1.m * 2^e

-- Is q a normal number of float (or zero)?  Then it is one of double.
local function representable(q)
  if R.sign(q) == 0 then return true end
  local e = R.log2(q)
  return e >= FLOAT_MIN_EXP and e <= FLOAT_MAX_EXP and R.round(q, 24) == q
end

-- Does the exact result q round to a normal float?  (A little less is asked for: |q| < 2^127.)
local function in_range(q)
  if R.sign(q) == 0 then return false end
  local e = R.log2(q)
  return e >= FLOAT_MIN_EXP and e < FLOAT_MAX_EXP
end

local function power_of_two(q)
  return R.sign(q) ~= 0 and R.round(q, 1) == q
end

-- The rules by opcode.  x, y are the defining instructions of the operands; `to` offers
--     to.value(v)          the result is value v           to.const(q)   ... the constant q
--     to.op(name, v1, v2)  ... this operation instead
-- A rule returns true if it applied.
local function is(i, q) return i.op == "const" and i.value == q end

local function both(x, y)
  return x.op == "const" and y.op == "const" and representable(x.value) and representable(y.value)
end

local rules = {
  neg = {
    -- -(-x) ==> x: two flips of the sign bit
    function(to, x) return x.op == "neg" and to.value(x.src1) end,
    -- -(c) ==> the constant: rounding is symmetric; zero has no sign as a constant
    function(to, x) return x.op == "const" and R.sign(x.value) ~= 0 and to.const(-x.value) end,
  },
  add = {
    -- x + (-y) ==> x - y, (-x) + y ==> y - x: IEEE defines x - y as x + (-y), and + commutes
    function(to, x, y) return y.op == "neg" and to.op("sub", x.dst, y.src1) end,
    function(to, x, y) return x.op == "neg" and to.op("sub", y.dst, x.src1) end,
    -- x + (-c) ==> x - c, the same law
    function(to, x, y)
      return y.op == "const" and R.sign(y.value) < 0 and to.op("sub", x.dst, to.constant(-y.value))
    end,
    -- a + b ==> its exact sum rounded once; a zero sum of constants is +0, and so is 0 as a constant
    function(to, x, y)
      local q = both(x, y) and x.value + y.value
      return q and (R.sign(q) == 0 or in_range(q)) and to.const(q)
    end,
  },
  sub = {
    -- x - (-y) ==> x + y
    function(to, x, y) return y.op == "neg" and to.op("add", x.dst, y.src1) end,
    function(to, x, y)
      return y.op == "const" and R.sign(y.value) < 0 and to.op("add", x.dst, to.constant(-y.value))
    end,
    function(to, x, y)
      local q = both(x, y) and x.value - y.value
      return q and (R.sign(q) == 0 or in_range(q)) and to.const(q)
    end,
  },
  mul = {
    -- x * 1 ==> x, x * -1 ==> -x: exact
    function(to, x, y) return is(y, ONE) and to.value(x.dst) end,
    function(to, x, y) return is(x, ONE) and to.value(y.dst) end,
    function(to, x, y) return is(y, MINUS) and to.op("neg", x.dst) end,
    function(to, x, y) return is(x, MINUS) and to.op("neg", y.dst) end,
    -- a * b ==> its exact product rounded once
    function(to, x, y)
      local q = both(x, y) and x.value * y.value
      return q and in_range(q) and to.const(q)
    end,
    -- (-x) * (-y) ==> x * y, (-x) * c ==> x * (-c): the sign of a product is the product of the signs
    function(to, x, y) return x.op == "neg" and y.op == "neg" and to.op("mul", x.src1, y.src1) end,
    function(to, x, y)
      return x.op == "neg" and y.op == "const" and R.sign(y.value) ~= 0
        and to.op("mul", to.constant(-y.value), x.src1)
    end,
    function(to, x, y)
      return y.op == "neg" and x.op == "const" and R.sign(x.value) ~= 0
        and to.op("mul", to.constant(-x.value), y.src1)
    end,
  },
  div = {
    -- x / 1 ==> x, x / -1 ==> -x: exact
    function(to, _, y, i) return is(y, ONE) and to.value(i.src1) end,
    function(to, _, y, i) return is(y, MINUS) and to.op("neg", i.src1) end,
    function(to, x, y)
      local q = both(x, y) and R.sign(y.value) ~= 0 and x.value / y.value
      return q and in_range(q) and to.const(q)
    end,
    -- x / 2^k ==> x * 2^-k: both round the same real number, 2^-k being exact
    function(to, x, y)
      return y.op == "const" and power_of_two(y.value) and representable(y.value)
        and representable(1 / y.value) and to.op("mul", to.constant(1 / y.value), x.dst)
    end,
    -- (-x) / (-y) ==> x / y, c / (-y) ==> (-c) / y, (-x) / c ==> x / (-c)
    function(to, x, y) return x.op == "neg" and y.op == "neg" and to.op("div", x.src1, y.src1) end,
    function(to, x, y)
      return y.op == "neg" and x.op == "const" and R.sign(x.value) ~= 0
        and to.op("div", to.constant(-x.value), y.src1)
    end,
    function(to, x, y)
      return x.op == "neg" and y.op == "const" and R.sign(y.value) ~= 0
        and to.op("div", x.src1, to.constant(-y.value))
    end,
  },
  fabs = {
    -- |-x| ==> |x|, ||x|| ==> |x|: the sign bit is cleared anyway
    function(to, x) return x.op == "neg" and to.op("fabs", x.src1) end,
    function(to, x) return x.op == "fabs" and to.value(x.dst) end,
  },
  sqrt = {
    -- sqrt of a representable square is exact
    function(to, x)
      local q = x.op == "const" and representable(x.value) and R.sign(x.value) > 0 and R.root(x.value, 2)
      return q and representable(q) and to.const(q)
    end,
  },
}

-- One application of a rule to i, whose operands are defined by x and y; nil if none applies.
local function step(i, x, y, to)
  for _, rule in ipairs(rules[i.op] or {}) do
    if rule(to, x, y, i) then return to.result end
  end
end

-- Rules are tried on an instruction until none applies; its operands are in their final form by then.
function fold.run(ir)
  local define = instr.definitions(ir)
  local same = {} -- value number -> the value number it was found to equal
  local constants = {}
  for _, i in ipairs(ir.consts) do constants[tostring(i.value)] = i.dst end

  return instr.rebuilt(ir, function(old, emit, new)
    local to = {}
    function to.constant(q)
      local key = tostring(q)
      if not constants[key] then
        local i = { op = "const", dst = instr.fresh(new), value = q }
        constants[key] = i.dst
        define[i.dst] = i
        table.insert(new.consts, i)
      end
      return constants[key]
    end
    function to.value(v) to.result = { value = v } return true end
    function to.const(q) return to.value(to.constant(q)) end
    function to.op(op, src1, src2)
      to.result = { op = op, src1 = src1, src2 = src2, dst = old.dst, name = old.name }
      return true
    end

    local i = instr.renamed(old, same)
    while true do
      local result = step(i, define[i.src1], define[i.src2], to)
      if not result then break end
      if result.value then
        same[old.dst] = result.value
        return
      end
      i = result
    end
    if i.dst then define[i.dst] = i end
    emit(i)
  end)
end

return fold
