-- value.lua -- what a scene computes with: exact expressions that know their dimension.
--
-- A value is an opaque handle; its record {e = expression, dim = dimension or nil} is private, so a scene
-- cannot alter it.  A plain Lua number is exact (the decimal that was typed) and takes any dimension; in a
-- product it counts as a pure number.  A wrong combination is reported on the user's line and goes on as a
-- value without dimension, so that one slip gives one message.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local text = require "generator.algebra.text"
local units = require "generator.dsl.units"
local diag = require "generator.diag"

local value = {}

local record = setmetatable({}, { __mode = "k" })
local handle = { __name = "value" }

local function new(e, dim)
  local v = setmetatable({}, handle)
  record[v] = { e = e, dim = dim }
  return v
end
value.new = new

function value.is(v) return record[v] ~= nil end

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

-- How x should be quoted in a message: what was typed, or the expression with its value.
function value.show(x)
  local r = record[x]
  if not r then return diag.show(x) end
  local n = value.number(r.e)
  local number = n and diag.show(R.todouble(n)) or "no number"
  local s = text.of(r.e)
  return s == number and s or s .. " = " .. number
end

-- The number that e has for the parameters' defaults, as a rational within 2^-200 of it (exact where e is a
-- rational function); nil if e has no value there.
function value.number(e)
  local ok, q = pcall(evaluate.precise, e, current.defaults, 200)
  return ok and q or nil
end

local function operand(x, what)
  local r, why = value.of(x)
  if not r then
    complain(what, "an operand " .. why, diag.show(x))
    return { e = expr.one, dim = nil }
  end
  return r
end

local function guarded(what, f, ...)
  local ok, e = pcall(f, ...)
  if ok then return e end
  complain(what, string.gsub(tostring(e), "^.-:%d+: ", ""), nil)
  return expr.one
end

local function sum(what, f)
  return function(a, b)
    local x, y = operand(a, what), operand(b, what)
    local dim = x.dim or y.dim
    if x.dim and y.dim and not units.equal(x.dim, y.dim) then
      complain(what, "both sides must have one dimension",
        units.name(x.dim) .. " and " .. units.name(y.dim))
      dim = nil
    end
    return new(guarded(what, f, x.e, y.e), dim)
  end
end

handle.__add = sum("sum", function(a, b) return a + b end)
handle.__sub = sum("difference", function(a, b) return a - b end)
function handle.__unm(a) return new(-record[a].e, record[a].dim) end

function handle.__mul(a, b)
  local x, y = operand(a, "product"), operand(b, "product")
  return new(guarded("product", function() return x.e * y.e end),
    units.times(x.dim or units.none, y.dim or units.none))
end

function handle.__div(a, b)
  local x, y = operand(a, "quotient"), operand(b, "quotient")
  return new(guarded("quotient", function() return x.e / y.e end),
    units.times(x.dim or units.none, units.power(y.dim or units.none, R.new(-1))))
end

function handle.__pow(a, n)
  local x, y = operand(a, "power"), operand(n, "power")
  if y.e.kind ~= "num" or R.abs(y.e.value) > R.new(64) then
    complain("power", "the exponent must be a plain number between -64 and 64", value.show(n))
    return new(x.e, x.dim)
  end
  return new(guarded("power", function() return x.e ^ y.e end), x.dim and units.power(x.dim, y.e.value))
end

function handle.__tostring(v) return value.show(v) end
function handle.__newindex() complain("value", "a value cannot be changed") end

-- A function of a pure number for scenes: sin(x), with x checked for dimension.
function value.func(fn)
  return function(...)
    local args = { ... }
    for i = 1, math.max(1, #args) do
      local r = operand(args[i], fn)
      if r.dim and not units.equal(r.dim, units.none) then
        complain(fn, "the argument must be a pure number or an angle", units.name(r.dim))
      end
      args[i] = r.e
    end
    return new(guarded(fn, expr.call, fn, table.unpack(args)), units.none)
  end
end

function value.sqrt(x)
  local r = operand(x, "sqrt")
  return new(guarded("sqrt", expr.sqrt, r.e), r.dim and units.power(r.dim, R.half))
end

return value
