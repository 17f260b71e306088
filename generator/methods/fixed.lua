-- fixed.lua -- programs of whole numbers: every node with its binary point, its bound and its error.
--
-- A node stands for the real number n 2^-e, n a whole number of 32 bits, e its exponent.  It knows `hi`, the largest
-- |n| that can be (so that no overflow is a matter of proof, not of trust), and `err`, how far n 2^-e is at most from
-- what exact arithmetic would make of the exact inputs: rounding and the rounding of constants, in real units.  The
-- error is a sum of positive doubles, enlarged at each node by more than their rounding.
--
--     mul      the product of two words without its last n bits, n at least 30, rounded once: exponent ea + eb - n
--     down     the same, rounded down, which is cheaper: half a unit too low on average; only for sums, which make up
--              for two of them by one unit, so that nothing is lost
--     product  of two numbers of 16 bits, exact: exponent ea + eb
--     sum      small multiples of nodes of one exponent
--     right    rounded to nearest, by so many bits: exponent e - n;     left   exact: e + n
--     clip     to -hi .. hi
-- A node that does not fit raises {blame = name of the exponent that must be smaller}; methods/q31.lua searches.
-- The same list of nodes is printed as C (emit/q31.lua) and run here with Lua's integers of 64 bits.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local fixed = {}
fixed.__index = fixed

local TOP = (1 << 31) - 1
local SLACK = 1 + 2.0 ^ -40

function fixed.new() return setmetatable({ ops = {}, inputs = {} }, fixed) end

function fixed.unfit(blame) error(setmetatable({ blame = blame }, fixed.misfit), 0) end

fixed.misfit = { __tostring = function(x) return "does not fit: " .. x.blame end }

local function check(hi, blame)
  if hi > TOP then fixed.unfit(blame) end
  return hi
end

-- The largest real value of a node.
function fixed.most(a) return a.hi * 2.0 ^ -a.e end

function fixed:add(op)
  op.err = op.err * SLACK
  self.ops[#self.ops + 1] = op
  return op
end

-- Blocks of the printed program: what follows is said to compute this.
function fixed:block(...) self.ops[#self.ops + 1] = { kind = "block", text = { ... } } end

-- A word of the state or of the input: name as it stands in C.
function fixed:input(name, e, hi, err)
  local op = { kind = "input", name = name, e = e, hi = hi, err = err }
  self.inputs[#self.inputs + 1] = op
  return op
end

-- The whole number nearest to q 2^e, nil if it has more than 64 bits, and the error that it has, in real units.
function fixed.nearest(q, e)
  local scaled = q * R.new(2) ^ e
  local n = R.floor(scaled + R.half)
  return R.toint(n), math.abs(R.todouble((n - scaled) / R.new(2) ^ e)) * SLACK
end

-- The constant q with exponent e.
function fixed.constant(q, e, about, blame)
  local n, err = fixed.nearest(q, e)
  if not n then fixed.unfit(blame) end
  check(math.abs(n), blame)
  return { kind = "constant", value = n, q = q, e = e, hi = math.abs(n), err = err, about = about }
end

-- The largest exponent with which q is a word.
function fixed.finest(q)
  local e = 31 - R.log2(q)
  while math.abs((fixed.nearest(q, e))) > TOP do e = e - 1 end
  while math.abs((fixed.nearest(q, e + 1))) <= TOP do e = e + 1 end
  return e
end

-- err: |a b - a' b'| is at most |a| db + |b| da + da db, and half a unit from rounding; rounded down, the other half is
-- what `sum` gives back.
function fixed:mul(name, a, b, n, blame, down)
  local ma, mb = fixed.most(a), fixed.most(b)
  n = n or 32
  local e = a.e + b.e - n
  if n < 32 then check(((a.hi * b.hi + (1 << n - 1)) >> n) + (1 << 18), blame) end -- emitted in halves: 2^18 is theirs
  return self:add { kind = "mul", name = name, a = a, b = b, n = n, e = e,
    down = down or nil, hi = (a.hi * b.hi + (1 << n) - 1) >> n,
    err = ma * b.err + mb * a.err + a.err * b.err + 2.0 ^ (-e - 1) }
end

-- The node times q with exponent e: the constant has all its bits.
-- 30 to 62 bits of the product are dropped (see mul above).
function fixed:scale(name, a, q, e, about, blame, down)
  local full = fixed.finest(q)
  local n = a.e + full - e
  if n < 30 or n > 62 then fixed.unfit(blame) end
  return self:mul(name, a, fixed.constant(q, full, about, blame), n, blame, down)
end

-- whole - q a, rounded down, all of the exponent of the constant `whole`; where q a is less than a unit it is left out,
-- and counted as an error.
function fixed:less(name, whole, a, q, about, blame)
  local c = fixed.constant(q, whole.e + 32 - a.e, about, blame)
  if a.hi * c.hi < 1 << 32 then
    whole.err = whole.err + fixed.most(a) * R.todouble(q) * SLACK
    return whole
  end
  return self:sum(name, { { 1, whole }, { -1, self:mul(name .. "1", a, c, 32, blame, true) } }, blame)
end

-- Both of 16 bits: the product is exact, and a word.
function fixed:product(name, a, b, blame)
  return self:add { kind = "product", name = name, a = a, b = b, e = a.e + b.e, hi = check(a.hi * b.hi, blame),
    err = fixed.most(a) * b.err + fixed.most(b) * a.err + a.err * b.err }
end

-- terms: a list of {multiple, node}, all of one exponent
-- Two terms that were rounded down are one unit too low on average: `more` adds it, and what stays of an odd number of
-- them counts as an error.
function fixed:sum(name, terms, blame)
  local hi, err, halves, e = 0, 0.0, 0, terms[1][2].e
  for _, t in ipairs(terms) do
    assert(t[2].e == e, name)
    hi, err = hi + math.abs(t[1]) * t[2].hi, err + math.abs(t[1]) * t[2].err
    if t[2].down then halves = halves + t[1] end
  end
  if #terms == 1 and terms[1][1] == 1 and halves == 0 then return terms[1][2] end
  local more = halves < 0 and -(-halves // 2) or halves // 2
  if halves % 2 == 1 then err = err + 2.0 ^ (-e - 1) end
  return self:add { kind = "sum", name = name, terms = terms, more = more, e = e, err = err,
    hi = check(hi + math.abs(more), blame) }
end

-- To the nearest, by adding half a unit of what is dropped; the sum must be a word, too.
function fixed:right(name, a, n)
  if n == 0 then return a end
  if n > 30 then fixed.unfit "f" end
  local e = a.e - n
  check(a.hi + (1 << n - 1), "f")
  return self:add { kind = "right", name = name, a = a, n = n, e = e, hi = (a.hi + (1 << n - 1)) >> n,
    err = a.err + 2.0 ^ (-e - 1) }
end

-- Exact.
function fixed:left(name, a, n, blame)
  if n == 0 then return a end
  if n > 30 then fixed.unfit(blame) end
  return self:add { kind = "left", name = name, a = a, n = n, e = a.e + n, hi = check(a.hi << n, blame), err = a.err }
end

-- With its exponent changed to e.
function fixed:to(name, a, e, blame)
  if e > a.e then return self:left(name, a, e - a.e, blame) end
  return self:right(name, a, a.e - e)
end

-- flag: the bit that tells of it.  The error is that of a: what is clipped is reported, not bounded.
function fixed:clip(name, a, hi, flag)
  return self:add { kind = "clip", name = name, a = a, limit = hi, flag = flag, e = a.e, hi = math.min(hi, a.hi),
    err = a.err }
end

-- x/2^n rounded down; Lua's >> brings in zeros from above.
local function floor_shift(x, n) return (x >> n) | (x < 0 and ~(-1 >> n) or 0) end
fixed.floor_shift = floor_shift

-- What C does, in integers of 64 bits: no product or sum of words leaves them.
local run = {
  mul = function(o, v) return floor_shift(v(o.a) * v(o.b) + (o.down and 0 or 1 << o.n - 1), o.n) end,
  product = function(o, v) return v(o.a) * v(o.b) end,
  sum = function(o, v)
    local s = o.more
    for _, t in ipairs(o.terms) do s = s + t[1] * v(t[2]) end
    return s
  end,
  right = function(o, v) return floor_shift(v(o.a) + (1 << o.n - 1), o.n) end,
  left = function(o, v) return v(o.a) << o.n end,
}

-- Runs the program.  given: values of the inputs by their names.  Returns a function from a node to its value, and the
-- flags of what was clipped.  A value beyond its bound is a bug of this file, and an error.
function fixed:run(given)
  local values, flags = {}, 0
  local function value(node)
    if node.kind == "constant" then return node.value end
    if node.kind == "input" then return given[node.name] end
    return values[node]
  end
  for _, op in ipairs(self.ops) do
    if op.kind == "clip" then
      local x = value(op.a)
      values[op] = math.max(-op.limit, math.min(op.limit, x))
      if values[op] ~= x then flags = flags | op.flag end
    elseif run[op.kind] then
      values[op] = run[op.kind](op, value)
    end
    if values[op] and math.abs(values[op]) > op.hi then error("fixed: " .. op.name .. " is beyond its bound") end
  end
  return value, flags
end

return fixed
