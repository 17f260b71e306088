-- value.lua -- what a scene computes with: exact expressions that know their dimension.
--
-- A value is an opaque handle; its record {e = expression, dim = dimension or nil} is private, so a scene
-- cannot alter it.  A plain Lua number is exact (the decimal that was typed) and takes any dimension, and so does
-- what is computed from plain numbers only; beside a value with a dimension it counts as a pure number in a product.
-- Zero is of any dimension, whatever it was computed from.
-- `plain` marks what is computed from plain numbers and coordinates of a region only: a region takes it, as it takes
-- plain numbers, for any dimension; beside a value with a dimension it has that of its powers.  So is time,
-- the number of seconds; the states of a motion are, too, but "bare" until a plain number multiplies or divides them,
-- which may then be meant in any unit: 0.1*wx can be a torque, wx cannot, and wx + qx is wrong by itself.  A function
-- of a plain value is plain.
-- A wrong combination is reported on the user's line and goes on as a value without dimension, so that one slip gives
-- one message; what is computed from an unknown name (diag/broken.lua) is as broken as that.
-- `cycles` marks what is counted in Hz, and its multiples by numbers: as an angular rate it would be 2 pi too small.
-- `written` is {number or string, factor} where a value is a decimal that the scene writes, times what is exact: see
-- mass/digits.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local motion = require "generator.algebra.motion"
local text = require "generator.formula.text"
local digits = require "generator.mass.digits"
local units = require "generator.dsl.units"
local diag = require "generator.diag"
local broken = require "generator.diag.broken"

local value = {}

local record = setmetatable({}, { __mode = "k" })
local handle = { __name = "value" }

local function new(e, dim, plain)
  local v = setmetatable({}, handle)
  if e == expr.zero then dim = nil end -- 0 m is 0 kg
  record[v] = { e = e, dim = dim, plain = plain }
  return v
end
value.new = new
value.watched = "@@" -- before the names of what only events know (dsl/watched.lua)

-- The value is what the scene writes as the decimal `given`, times factor; a power of ten is a unit, not a measurement.
function value.write(v, given, factor)
  local d = digits.of(given)
  if d and d.count > 1 then record[v].written = { given, factor } end
  return v
end

-- The digits of what a scene gave for a number, with factor = |what it was multiplied by|; nil if it is exact.
function value.digits(x)
  local w = record[x] and record[x].written
  local d = digits.of(w and w[1] or not record[x] and x or nil)
  if d and w then
    local factor = value.number(w[2])
    if not factor then return nil end
    d.factor = R.abs(factor)
  end
  return d
end

-- Of a product: the digits of one factor, if the other is exact.
local function written(v, a, b, factor_a, factor_b)
  local x, y = record[a] and record[a].written, record[b] and record[b].written
  if record[a] and record[b] then
    local w, other = x or y, x and factor_b or factor_a
    if w and not (x and y) then record[v].written = { w[1], w[2] * other } end
    return v
  elseif x or y then
    return v -- 2*0.615: a number and a value with digits of its own
  end
  return value.write(v, record[a] and b or a, record[a] and factor_a or factor_b)
end

function value.is(v) return record[v] ~= nil end

-- The value, given in the unit: does it count cycles?
function value.counts(v, unit)
  if type(unit) == "string" and string.find(unit, "%f[%a]Hz%f[%A]") then record[v].cycles = true end
  return v
end

-- The scene that is being recorded: its diagnostics and the defaults of its parameters (symbol -> rational).
local current

function value.begin(d) current = { diag = d, defaults = {} } end
function value.defaults() return current.defaults end
function value.default(sym, number) current.defaults[sym.name] = number end

local function complain(what, rule, got) current.diag:error(current.diag:here(), what, rule, got) end

-- The record of x: of a handle, or of a plain number or "p/q" string; nil and a phrase if x is none of these.
function value.of(x)
  if record[x] then return record[x] end
  if type(x) ~= "number" and type(x) ~= "string" then return nil, "must be a number" end
  local q, why = R.lift(x)
  if not q then return nil, why end
  return { e = expr.lift(q), dim = nil }
end

-- Nodes of e as a tree, counted up to `most`.
local function size(e, most)
  local n = 1
  for _, c in ipairs(expr.children(e)) do
    if n > most then return n end
    n = n + size(c, most - n)
  end
  return n
end

local most_nodes, most_text = 40, 60 -- of an expression in a message

-- How x should be quoted in a message: what was typed, or the expression with its value; with_unit: and its SI unit.
function value.show(x, with_unit)
  local r = record[x]
  if not r then return diag.show(x) end
  local n = value.number(r.e)
  local number = n and diag.show(R.todouble(n)) or "no number"
  if n and (number == "inf" or number == "-inf" or number == "0.0" and R.sign(n) ~= 0) then
    number = R.magnitude(n)
  end
  local s, coordinates = nil, 0 -- @x: a coordinate, which has no number
  if size(r.e, most_nodes) <= most_nodes then s, coordinates = string.gsub(text.of(r.e), "@", "") end
  if s and not motion.free(r.e) then -- time, states and inputs have no number either
    s, coordinates = string.gsub(s, "%f[%w_]u_(%a)", "%1"), 1 -- an input by its own name
  end
  if s and s ~= number and #s <= most_text then number = coordinates > 0 and s or s .. " = " .. number end
  if not with_unit then return number end
  local pure = not r.dim or units.equal(r.dim, units.none)
  return number .. (pure and " (a pure number)" or " " .. units.name(r.dim))
end

-- The number that e has for the parameters' defaults, as a rational within 2^-200 of it (exact where e is a
-- rational function); nil if e has no value there.
function value.number(e)
  local ok, q = pcall(evaluate.exact, e, current.defaults)
  if not ok then ok, q = pcall(evaluate.precise, e, current.defaults, 200) end
  return ok and q or nil
end

-- The record of an operand; after an error that of 1.
local function operand(x, what)
  local r, why = value.of(x)
  if not r then
    complain(what, "an operand " .. why, diag.show(x))
    return { e = expr.one, dim = nil }
  end
  return r
end

-- f(...), or what it complains of (a division by zero) on the user's line, and 1.
local function guarded(what, f, ...)
  local ok, e = pcall(f, ...)
  if ok then return e end
  complain(what, string.gsub(tostring(e), "^.-:%d+: ", ""), nil)
  return expr.one
end

-- Has neither operand a dimension but for that of coordinates?
local function both_plain(x, y) return (x.plain or not x.dim) and (y.plain or not y.dim) and (x.plain or y.plain) end

local function bare(x) return x.plain == "bare" end

-- The record, but that of 0 without a unit if it is one: 0, and what 0 times a state leaves, belongs to every unit.
local function neutral(x) return x.e == expr.zero and x.plain and { e = x.e } or x end

-- Both must have one dimension; one that is plain takes the other's.
local function sum(what, f)
  return function(a, b)
    local x, y = neutral(operand(a, what)), neutral(operand(b, what))
    local dim, plain = x.dim or y.dim, both_plain(x, y)
    if x.dim and y.dim and not units.equal(x.dim, y.dim) then
      dim = nil
      if not plain or bare(x) and bare(y) then
        complain(what, "both sides must have one dimension",
          units.name(x.dim) .. " and " .. units.name(y.dim))
      elseif bare(x) or bare(y) then
        dim = bare(x) and x.dim or y.dim -- the other one's number is meant so
      end
    end
    local e = guarded(what, f, x.e, y.e)
    local fixed = dim and e ~= expr.zero and (bare(x) or bare(y)) -- zero is of any unit
    return new(e, dim, plain and (fixed and "bare" or true))
  end
end

-- The operation f, unless an operand is what an unknown name stands for.
local function sound(f)
  return function(a, b)
    if broken.is(a) or broken.is(b) then return broken.object end
    return f(a, b)
  end
end

handle.__add = sound(sum("sum", function(a, b) return a + b end))
handle.__sub = sound(sum("difference", function(a, b) return a - b end))
function handle.__unm(a) return new(-record[a].e, record[a].dim, record[a].plain) end

-- Dimension of x * y^n; nil if neither has one.
local function combined(x, y, n)
  if not x.dim and not y.dim then return nil end
  return units.times(x.dim or units.none, units.power(y.dim or units.none, R.new(n)))
end

-- `plain` of a product: bare only if both are; false where one has a dimension that it means.
local function product_plain(x, y)
  if bare(x) and bare(y) then return "bare" end
  return both_plain(x, y) and true
end

handle.__mul = sound(function(a, b)
  local x, y = operand(a, "product"), operand(b, "product")
  local v = new(guarded("product", function() return x.e * y.e end), combined(x, y, 1), product_plain(x, y))
  record[v].cycles = x.cycles and y.e.kind == "num" or y.cycles and x.e.kind == "num" or nil
  return written(v, a, b, x.e, y.e)
end)

handle.__div = sound(function(a, b)
  local x, y = operand(a, "quotient"), operand(b, "quotient")
  return new(guarded("quotient", function() return x.e / y.e end), combined(x, y, -1), product_plain(x, y))
end)

handle.__pow = sound(function(a, n)
  local x, y = operand(a, "power"), operand(n, "power")
  if y.e.kind ~= "num" or R.abs(y.e.value) > R.new(64) then
    complain("power", "the exponent must be a plain number between -64 and 64", value.show(n))
    return new(x.e, x.dim)
  end
  return new(guarded("power", function() return x.e ^ y.e end), x.dim and units.power(x.dim, y.e.value),
    x.plain)
end)

-- (if param > 1 then ... would decide by the default alone)
local function unordered(a, b)
  if broken.is(a) or broken.is(b) then return false end
  complain("comparison", "values have no order: a parameter is a symbol, its default only one of its values")
  return false
end
handle.__lt, handle.__le = unordered, unordered

function handle.__tostring(v) return value.show(v) end
function handle.__newindex() complain("value", "a value cannot be changed") end

-- The functions of scenes: how many arguments (false: two or more); what the dimensions must be: "pure" numbers (an
-- angle is one), the "same" for all (the result is a pure number), "any", the same for all (the result has it), or
-- "root", any (the result has its root); and what it is.
value.functions = {
  { "sqrt", 1, "root", "the square root; of m^2 it is in m" },
  { "abs", 1, "any", "x without its sign, in the unit of x" },
  { "sign", 1, "same", "1, 0 or -1: the sign of x, 0 at 0" },
  { "min", false, "any", "the least of two or more of one unit" },
  { "max", false, "any", "the greatest of two or more of one unit" },
  { "sin", 1, "pure", "the sine of an angle in rad" }, { "cos", 1, "pure", "the cosine of an angle in rad" },
  { "tan", 1, "pure", "the tangent of an angle in rad" },
  { "asin", 1, "pure", "the angle from -pi/2 to pi/2 of a sine" },
  { "acos", 1, "pure", "the angle from 0 to pi of a cosine" },
  { "atan", 1, "pure", "the angle between -pi/2 and pi/2 of a tangent" },
  { "atan2", 2, "same", "the angle from -pi to pi of the point with the ordinate x and the abscissa y, both of one " ..
    "unit: atan2(s, c) with s = k*sin(a), c = k*cos(a) is a" },
  { "exp", 1, "pure", "e to the power x" }, { "log", 1, "pure", "the natural logarithm" },
  { "sinh", 1, "pure", "the hyperbolic sine" }, { "cosh", 1, "pure", "the hyperbolic cosine" },
  { "tanh", 1, "pure", "the hyperbolic tangent" },
}

local function counted(fn, n, ...)
  if select("#", ...) <= n then return end
  complain(fn, "takes " .. (n == 1 and "one argument" or n .. " arguments"), tostring(select("#", ...)))
end

-- fn of two, and so of more.
local function folded(fn)
  local two = sum(fn, function(a, b) return expr.call(fn, a, b) end)
  return function(...)
    local given = { ... }
    if #given < 2 then complain(fn, "takes two or more arguments", tostring(#given)) end
    local v = given[1]
    for i = 2, #given do v = sound(two)(v, given[i]) end
    return v or broken.object
  end
end

-- What a scene calls as fn; n, kind: as above.
function value.func(fn, n, kind)
  if not n then return folded(fn) end
  if kind == "root" then return value.sqrt end
  return function(...)
    counted(fn, n, ...)
    local given, es, dim, plain = { ... }, {}, nil, nil
    for i = 1, n do
      if broken.is(given[i]) then return broken.object end
      local r = operand(given[i], fn)
      es[i] = r.e
      if r.dim and kind == "pure" and not r.plain and not units.equal(r.dim, units.none) then
        complain(fn, "the argument must be a pure number or an angle", value.show(given[i], true))
      elseif r.dim and dim and not units.equal(r.dim, dim) then
        complain(fn, "both arguments must have one dimension", units.name(dim) .. " and " .. units.name(r.dim))
      end
      dim, plain = dim or r.dim, plain or r.plain and true
    end
    return new(guarded(fn, expr.call, fn, table.unpack(es)), dim and (kind == "any" and dim or units.none), plain)
  end
end

function value.sqrt(...)
  counted("sqrt", 1, ...)
  if broken.is((...)) then return broken.object end
  local r = operand((...), "sqrt")
  return new(guarded("sqrt", expr.sqrt, r.e), r.dim and units.power(r.dim, R.half), r.plain)
end

return value
