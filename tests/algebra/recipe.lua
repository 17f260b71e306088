-- recipe.lua: random expressions as plain trees, built into nodes in any order and valued without them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A recipe is {op, parts...}: "num" q, "sym" name, "sum", "product", "quotient", "power" with an integer, "root" with
-- an exponent, "call" with a name.  build() makes the node, with terms and factors shuffled and grouped at will: the
-- canonical form must not depend on that.  value() computes with rationals (and MPFR for roots and functions) straight
-- from the recipe and shares no code with the simplifier: it is the oracle.
-- Denominators are 1 + p^2 and roots are taken of those, so every value exists.

local R = require "polhode_rational"
local expr = require "generator.algebra.expr"
local random = require "tests.ir.random"

local recipe = {}

recipe.names = { "x", "y", "z", "u", "w" }
recipe.bits = 300 -- of values with roots and functions

local one = { "num", R.new(1) }

local function number() return { "num", R.new(random.int(25) - 13, random.int(7)) } end
local function positive(p) return { "sum", one, { "power", p, 2 } } end

-- About `size` operations; kinds.roots and kinds.calls allow more than rational functions; kinds.whole: no quotients.
function recipe.random(size, kinds)
  if size <= 0 then
    return random.int(4) == 1 and number() or { "sym", recipe.names[random.int(#recipe.names)] }
  end
  local function part() return recipe.random(size - 1 - random.int(2), kinds) end
  local pick = random.int(9 + (kinds.roots and 2 or 0) + (kinds.calls and 2 or 0))
  if pick <= 3 then return { "sum", part(), part(), random.int(2) == 1 and part() or nil } end
  if pick <= 6 then return { "product", part(), part(), random.int(2) == 1 and part() or nil } end
  if pick == 7 then return { "product", number(), part() } end
  if pick == 8 then return { "power", part(), random.int(4) } end
  if pick == 9 then return kinds.whole and part() or { "quotient", part(), positive(part()) } end
  if kinds.roots and pick <= 11 then
    local exponents = { "1/2", "-1/2", "3/2", "1/3", "-2/3" }
    return { "root", positive(part()), R.parse(exponents[random.int(#exponents)]) }
  end
  local functions = { "sin", "cos", "atan", "tanh", "abs" }
  return { "call", functions[random.int(#functions)], part() }
end

-- Products of sums in sums, each sign at random: where a minus goes into a sum, and from there into the sums of its
-- terms, no sign may be lost.
function recipe.signs(depth)
  local function name() return { "sym", recipe.names[random.int(#recipe.names)] } end
  local terms = { "sum" }
  for _ = 1, 1 + random.int(3) do
    local product = { "product", { "num", R.new(random.int(2) * 2 - 3, random.int(3)) }, name() }
    if depth > 0 and random.int(3) > 1 then product[#product + 1] = recipe.signs(depth - 1) end
    terms[#terms + 1] = product
  end
  return terms
end

local function shuffled(list)
  local out = {}
  for i, x in ipairs(list) do table.insert(out, random.int(i), x) end
  return out
end

-- Joins the list by op, grouped at random: ((a b) (c d)), (a (b c)) d, ...
local function joined(list, op)
  while #list > 1 do
    local i = random.int(#list - 1)
    local pair = op { list[i], list[i + 1] }
    table.remove(list, i + 1)
    list[i] = pair
  end
  return list[1]
end

function recipe.build(r)
  local op = r[1]
  if op == "num" then return expr.num(r[2]) end
  if op == "sym" then return expr.sym(r[2]) end
  if op == "power" or op == "root" then return expr.pow(recipe.build(r[2]), r[3]) end
  if op == "call" then return expr.call(r[2], recipe.build(r[3])) end
  if op == "quotient" then
    if random.int(2) == 1 then return recipe.build(r[2]) / recipe.build(r[3]) end
    local inverse = expr.pow(recipe.build(r[3]), -1)
    return inverse * recipe.build(r[2])
  end
  local parts = {}
  for i, k in ipairs(shuffled { table.unpack(r, 2) }) do parts[i] = recipe.build(k) end
  return joined(parts, op == "sum" and expr.add or expr.mul)
end

function recipe.value(r, env)
  local op = r[1]
  if op == "num" then return r[2] end
  if op == "sym" then return env[r[2]] end
  if op == "power" then return recipe.value(r[2], env) ^ r[3] end
  if op == "root" then return R.apply("pow", recipe.bits, recipe.value(r[2], env), r[3]) end
  if op == "call" then
    local x = recipe.value(r[3], env)
    return r[2] == "abs" and R.abs(x) or R.apply(r[2], recipe.bits, x)
  end
  local v = recipe.value(r[2], env)
  if op == "quotient" then return v / recipe.value(r[3], env) end
  for i = 3, #r do
    local k = recipe.value(r[i], env)
    v = op == "sum" and v + k or v * k
  end
  return v
end

-- A rational value for every name, of either sign.
function recipe.point()
  local env = {}
  for _, name in ipairs(recipe.names) do
    env[name] = R.new(random.int(81) - 41, random.int(9))
    if R.sign(env[name]) == 0 then env[name] = R.new(1, 3) end
  end
  return env
end

-- |a - b| <= 2^-bits max(1, |b|): the values that recipes give are moderate, so an absolute floor of 1 is fair.
function recipe.close(a, b, bits)
  local scale = R.abs(b) < 1 and R.new(1) or R.abs(b)
  return R.abs(a - b) <= scale * R.new(2) ^ -bits
end

recipe.seed = random.seed

return recipe
