-- linear.lua -- sums of a constant and of variables of series.lua with constant coefficients.
--
-- ABOVE the line.  A form is {constant = expr, vars = {variables in their order}, of = {[variable] = coefficient}}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local linear = {}

function linear.form(constant) return { constant = constant, vars = {}, of = {} } end

-- f + c v, in place
function linear.put(f, v, c)
  if not f.of[v] then
    f.vars[#f.vars + 1] = v
    f.of[v] = expr.zero
  end
  f.of[v] = f.of[v] + c
end

-- c f
function linear.times(c, f)
  local g = linear.form(c * f.constant)
  for _, v in ipairs(f.vars) do linear.put(g, v, c * f.of[v]) end
  return g
end

-- The form as an expression, with its constant or without.
function linear.expression(f, constant)
  local terms = { constant and f.constant or expr.zero }
  for _, v in ipairs(f.vars) do terms[#terms + 1] = f.of[v] * v.sym end
  return expr.add(terms)
end

function linear.level(f)
  local level = 0
  for _, v in ipairs(f.vars) do level = math.max(level, v.level) end
  return level
end

-- The exponent of ten of the largest number in the form where it is long (algebra/rational.lua), a multiple of q; or 0.
function linear.long(f, q)
  local most = R.abs((expr.split(f.constant)))
  for _, v in ipairs(f.vars) do
    local c = R.abs((expr.split(f.of[v])))
    if c > most then most = c end
  end
  local e = R.decade(most)
  return math.abs(e) >= R.LONG and e - e % q or 0
end

return linear
