-- stages.lua -- instances of the equations at the stages of a one-step method.
--
-- A stepper is unrolled by instantiating the equation groups once a stage, with the state's symbols replaced by
-- that stage's values and the definitions renamed.  What does not change from stage to stage (a component of w
-- that is conserved, and whatever depends on it alone) keeps its one name, so it is computed once.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local constancy = require "generator.dynamics.constancy"

local stages = {}

-- States whose rate may have a constant factor, and those that a method steps by itself (attitude.lua).
local quotient = { wx = true, wy = true, wz = true }
local attitude = { qw = true, qx = true, qy = true, qz = true }

-- Why a method that looks for a length of its steps has nothing to look at.
stages.AT_REST = "no state of the scene changes"

-- c and rest of a product; where rest is a sum of long whole numbers (algebra/rational.lua) the number of c goes with
-- it, for it is the scale of their decimals: 1e-12 (7e12 x + 3e11 y) is 7 x + 0.3 y.
local function natural(c, rest)
  local most = R.zero
  for i = 1, rest.kind == "add" and #rest or 0 do
    local n = R.abs((expr.split(rest[i])))
    if n > most then most = n end
  end
  local number, others = expr.split(c)
  if math.abs(R.decade(most)) < R.LONG then return c, rest end
  return others, expr.num(number) * rest
end

-- e = constant * rest, the constant free of the names in `set`.
local function split(e, set)
  local factors = e.kind == "mul" and e or { e }
  local c, rest = {}, {}
  for i = 1, #factors do
    local list = expr.constant(factors[i], set) and c or rest
    list[#list + 1] = factors[i]
  end
  return natural(expr.mul(c), expr.mul(rest))
end

-- All equations but the attitude's prepared for a method: {groups, factor = {by state}, zero = {by state}}.  Each rate
-- is factor * what the groups give; the factor does not change during a step.  Only rates of turning have one, a
-- quotient of moments: in other sums what is common is a coincidence of their numbers.  whole: take no factor out.
function stages.prepare(eq, whole)
  local set, out = constancy.varying(eq), { groups = {}, factor = {}, zero = constancy.conserved(eq) }
  for _, g in ipairs(eq.free and {} or eq.groups) do -- where something acts the factor stands before all definitions
    for _, d in ipairs(g.defs) do set[d.name] = true end
  end
  for _, g in ipairs(eq.groups) do
    local copy = { defs = g.defs, outs = {} }
    for _, o in ipairs(g.outs) do
      if not attitude[o.state] then
        local c, rest = expr.one, o.expr
        if quotient[o.state] and not whole then c, rest = split(o.expr, set) end
        out.factor[o.state] = c
        copy.outs[#copy.outs + 1] = { state = o.state, expr = rest }
      end
    end
    out.groups[#out.groups + 1] = copy
  end
  return out
end

-- The name of what is called `base` at stage n, "" for the first.  A component has the number behind it: vx2.  Between
-- another name and the number stands an S, as its own number may end it: the second wheel at stage 3 is wheel_2S3.
-- A capital stands before _ and small letters in the order of names, as digits do, so sums keep their order.
function stages.name(base, n)
  local component = #base < 3 and not string.find(base, "%d$") or #base == 3 and string.find(base, "^%a+[wxyz]$")
  return base .. ((component or n == "") and "" or "S") .. n
end

-- One instance with the symbols in `map` (node -> node) replaced: the definitions, named with `suffix` where they
-- changed, the factor-free rates and the factors by state name, and what was replaced by what.  The first stage (suffix
-- "" or "1") also defines what never changes.
function stages.instance(prepared, map, suffix)
  local defs, out, factor, renamed = {}, {}, {}, {}
  for k, v in pairs(map) do renamed[k] = v end -- into a table: order is lost anyway
  for _, g in ipairs(prepared.groups) do
    for _, d in ipairs(g.defs) do
      local e = calculus.substitute(d.expr, renamed)
      if e ~= d.expr then
        local name = stages.name(d.name, suffix)
        renamed[expr.sym(d.name, 7)] = expr.sym(name, 7)
        defs[#defs + 1] = { name = name, expr = e }
      elseif suffix == "" or suffix == "1" then
        defs[#defs + 1] = d
      end
    end
    for _, o in ipairs(g.outs) do
      out[o.state] = calculus.substitute(o.expr, renamed)
      factor[o.state] = calculus.substitute(prepared.factor[o.state], renamed)
    end
  end
  return defs, out, factor, renamed
end

return stages
