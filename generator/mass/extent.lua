-- extent.lua -- how far one parameter may go while there is a body, the others at their defaults.
--
--     extent.of(m, name, low, high) -> low, high
-- m: a model (dynamics/model.lua); doubles around the parameter's default.  The result is the largest interval around
-- it, within the one that is asked for, in which every condition of the model holds.  A condition that is a polynomial
-- in the parameter ends it at its nearest root; another one, with a sine or a root in it, is looked at in `scans`
-- places to each side, and its end is found by bisection.
-- At an end of its own the body has ceased: a condition is 0 there.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local poly = require "generator.algebra.poly"
local roots = require "generator.algebra.roots"
local section = require "generator.algebra.section"
local validity = require "generator.mass.validity"

local extent = {}

local scans = 64
local bits = 128

-- e as a polynomial in one parameter, the others at their defaults: coefficients in doubles, or nil.
function extent.polynomial(m, e, name)
  if not poly.modest(e) then return nil end
  local terms = section.terms(e, m.defaults, { name })
  return terms and section.coefficients(terms)
end

-- From `here` towards `limit`: where e is first not positive, or the limit.
local function walked(positive, here, limit)
  local before = here
  for i = 1, scans do
    local x = here + (limit - here) * i / scans
    if not positive(x) then
      return roots.bisect(function(y) return positive(y) and 1 or -1 end, before, x)
    end
    before = x
  end
  return limit
end

function extent.of(m, name, low, high)
  local here, env = R.todouble(m.defaults[name]), {}
  for k, v in pairs(m.defaults) do env[k] = v end -- into a table: order is lost anyway
  local function number(e, x)
    env[name] = R.fromdouble(x)
    local fine, value = pcall(evaluate.precise, e, env, bits)
    return fine and R.sign(value) or -1 -- what has no value is none: a quotient by zero, a root of a negative number
  end
  for _, c in ipairs(m.conditions) do
    if not expr.constant(c.e, { [name] = true }) then
      local e = calculus.substitute(c.e, validity.exactly)
      local polynomial = extent.polynomial(m, e, name)
      if polynomial then
        for _, x in ipairs(roots.between(polynomial, low, high)) do
          if x < here then low = math.max(low, x) elseif x > here then high = math.min(high, x) end
        end
      elseif number(e, here) >= 0 then
        local function positive(x) return number(e, x) > 0 end
        if low < here then low = walked(positive, here, low) end
        if high > here then high = walked(positive, here, high) end
      end
    end
  end
  return low, high
end

return extent
